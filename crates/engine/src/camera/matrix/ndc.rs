//! Conventions of normalised device coordinates: where graphics libraries want z_n, and which way y_n points.

/// The range of depths and the direction of y of a graphics library, and its treatment of depth.
///
/// Whatever the convention, view space is right-handed and the camera looks along −**n**, as in `[0]`.
///
/// | | z_n at F | z_n at B | y_n |
/// | --- | --- | --- | --- |
/// | `opengl`, `[0]` | −1 | 1 | up |
/// | `direct3d`, `metal`, `webgpu` | 0 | 1 | up |
/// | `vulkan` | 0 | 1 | down |
/// | all of them `reversed` | 1 | 0 | as it is |
///
/// OpenGL reversed has 0 … 1 as well, which is `glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)`: in −1 … 1 the digits
/// that reversing is to win are lost around 0 again. `infinite` lets B → ∞, where z_n has the limit that B had: nothing
/// is too far away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Ndc {
    /// Whose.
    pub api: Api,
    /// z_n is 1 at F and 0 at B.
    pub reversed: bool,
    /// No back plane (in perspective; see [`InfiniteParallel`]).
    pub infinite: bool,
}

/// A graphics library.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Api {
    /// OpenGL, WebGL, and `[0]`.
    #[default]
    OpenGl,
    /// Direct3D.
    Direct3d,
    /// Vulkan.
    Vulkan,
    /// Metal.
    Metal,
    /// WebGPU.
    WebGpu,
}

impl Api {
    /// All, in the order in which they are listed.
    pub const ALL: [Self; 5] = [Self::OpenGl, Self::Direct3d, Self::Vulkan, Self::Metal, Self::WebGpu];

    /// The name as its makers write it.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::OpenGl => "OpenGL",
            Self::Direct3d => "Direct3D",
            Self::Vulkan => "Vulkan",
            Self::Metal => "Metal",
            Self::WebGpu => "WebGPU",
        }
    }
}

impl Ndc {
    /// All, each library as it is, reversed, infinite, and both.
    pub const ALL: [Self; 20] = {
        let mut all = [Self { api: Api::OpenGl, reversed: false, infinite: false }; 20];
        let mut i = 0;
        while i < all.len() {
            all[i] = Self { api: Api::ALL[i / 4], reversed: i % 2 == 1, infinite: i % 4 >= 2 };
            i += 1;
        }
        all
    };

    /// The name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match (self.api, self.reversed, self.infinite) {
            (Api::OpenGl, false, false) => "opengl",
            (Api::OpenGl, true, false) => "opengl-reversed",
            (Api::OpenGl, false, true) => "opengl-infinite",
            (Api::OpenGl, true, true) => "opengl-reversed-infinite",
            (Api::Direct3d, false, false) => "direct3d",
            (Api::Direct3d, true, false) => "direct3d-reversed",
            (Api::Direct3d, false, true) => "direct3d-infinite",
            (Api::Direct3d, true, true) => "direct3d-reversed-infinite",
            (Api::Vulkan, false, false) => "vulkan",
            (Api::Vulkan, true, false) => "vulkan-reversed",
            (Api::Vulkan, false, true) => "vulkan-infinite",
            (Api::Vulkan, true, true) => "vulkan-reversed-infinite",
            (Api::Metal, false, false) => "metal",
            (Api::Metal, true, false) => "metal-reversed",
            (Api::Metal, false, true) => "metal-infinite",
            (Api::Metal, true, true) => "metal-reversed-infinite",
            (Api::WebGpu, false, false) => "webgpu",
            (Api::WebGpu, true, false) => "webgpu-reversed",
            (Api::WebGpu, false, true) => "webgpu-infinite",
            (Api::WebGpu, true, true) => "webgpu-reversed-infinite",
        }
    }

    /// z_n at F and at B (at infinity, where there is no far plane).
    #[must_use]
    pub const fn depths(self) -> [f64; 2] {
        match (self.api, self.reversed) {
            (_, true) => [1.0, 0.0],
            (Api::OpenGl, false) => [-1.0, 1.0],
            (Api::Direct3d | Api::Vulkan | Api::Metal | Api::WebGpu, false) => [0.0, 1.0],
        }
    }

    /// Are the axes x_n, y_n, z_n, as they lie before the eye, right-handed? Those of `[0]` are not; turning y or z
    /// round changes it.
    #[must_use]
    pub const fn is_right_handed(self) -> bool {
        self.y_points_down() != self.reversed
    }

    /// Does y_n grow downwards?
    #[must_use]
    pub const fn y_points_down(self) -> bool {
        matches!(self.api, Api::Vulkan)
    }
}

/// A parallel projection has no matrices without a far plane: all depths would have the same z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} moves the back plane to infinity, which in parallel projection gives all depths the same z; allowed: projection = \"perspective\", \
     or a convention without -infinite",
    .0.name()
)]
pub struct InfiniteParallel(pub Ndc);
