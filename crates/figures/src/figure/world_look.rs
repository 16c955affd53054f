//! The content of the world picture besides scene and camera: the `[world]` section of a figure.

/// The `[world]` section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorldLook {
    /// True if the picture is the section through C along **u**, as in the side figures of `[0]`, instead of the space.
    pub section: bool,
    /// F, B, D, W, H and θ/2 as dimension lines.
    pub dimensions: bool,
    /// Opacity of the image on the view window, 0 … 1; `None` means opaque, but faint if it would hide much of the
    /// scene.
    pub window_opacity: Option<f64>,
    /// The length of **u**, **v**, **n**, VUP and DOP, as a multiple of the usual one; `None` means 1.
    pub axes_length: Option<f64>,
    /// The visible parts of the world.
    pub parts: WorldParts,
}

/// The least and the greatest [`WorldLook::axes_length`].
pub const AXES_LENGTHS: [f64; 2] = [0.5, 4.0];

/// An optional part of the world picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorldPart {
    /// The grid on y = 0.
    Grid,
    /// The axes x, y, z of the world.
    Axes,
    /// The camera's body at C.
    CameraBody,
    /// The axes u, v, n of the camera.
    Vrc,
    /// VUP at C.
    ViewUp,
    /// DOP at C, and its axis through the volume.
    Dop,
    /// PF, and the line from C to it.
    FocalPoint,
    /// The view volume with its far face.
    Volume,
    /// The view window, and the lines from C to its corners.
    Window,
    /// The feet of C and PF on the ground, and the lines to them.
    GroundMarks,
    /// The names of all these.
    Names,
}

impl WorldPart {
    /// All, with their keys in `[world]`, in the order of menus.
    pub const ALL: [(Self, &'static str); 11] = [
        (Self::Grid, "grid"),
        (Self::Axes, "axes"),
        (Self::CameraBody, "camera_body"),
        (Self::Vrc, "vrc"),
        (Self::ViewUp, "view_up"),
        (Self::Dop, "dop"),
        (Self::FocalPoint, "focal_point"),
        (Self::Volume, "volume"),
        (Self::Window, "window"),
        (Self::GroundMarks, "ground_marks"),
        (Self::Names, "names"),
    ];
}

/// The visible parts of the world, by default all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorldParts {
    left_out: [bool; WorldPart::ALL.len()],
}

impl WorldParts {
    /// True if a part is drawn.
    pub fn has(&self, part: WorldPart) -> bool {
        !self.left_out[part as usize]
    }

    /// Draws a part, or leaves it out.
    pub fn set(&mut self, part: WorldPart, drawn: bool) {
        self.left_out[part as usize] = !drawn;
    }
}
