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
/// that reversing is to win are lost around 0 again. `infinite` lets B → ∞, and z_n there has the limit that B had.
/// Nothing is too far away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Ndc {
    /// The library with this convention.
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
    pub const fn title(self) -> &'static str {
        self.row().0
    }

    /// The title, the names (as it is, reversed, infinite, both), z_n at F, and true if y_n points down.
    const fn row(self) -> (&'static str, [&'static str; 4], f64, bool) {
        macro_rules! row {
            ($title:literal, $name:literal, $near:literal, $down:literal) => {{
                let infinite = [concat!($name, "-infinite"), concat!($name, "-reversed-infinite")];
                ($title, [$name, concat!($name, "-reversed"), infinite[0], infinite[1]], $near, $down)
            }};
        }
        match self {
            Self::OpenGl => row!("OpenGL", "opengl", -1.0, false),
            Self::Direct3d => row!("Direct3D", "direct3d", 0.0, false),
            Self::Vulkan => row!("Vulkan", "vulkan", 0.0, true),
            Self::Metal => row!("Metal", "metal", 0.0, false),
            Self::WebGpu => row!("WebGPU", "webgpu", 0.0, false),
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
    pub const fn name(self) -> &'static str {
        self.api.row().1[self.reversed as usize + 2 * self.infinite as usize]
    }

    /// z_n at F and at B (at infinity, if there is no far plane).
    pub const fn depths(self) -> [f64; 2] {
        if self.reversed { [1.0, 0.0] } else { [self.api.row().2, 1.0] }
    }

    /// True if the axes x_n, y_n, z_n, as they lie before the eye, are right-handed. Those of `[0]` aren't. Turning y
    /// or z round changes it.
    pub const fn is_right_handed(self) -> bool {
        self.y_points_down() != self.reversed
    }

    /// True if y_n grows downwards.
    pub const fn y_points_down(self) -> bool {
        self.api.row().3
    }
}

/// A parallel projection has no matrices without a far plane. All depths would have the same z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} moves the back plane to infinity, which in parallel projection gives all depths the same z; allowed: projection = \"perspective\", \
     or a convention without -infinite",
    .0.name()
)]
pub struct InfiniteParallel(pub Ndc);
