//! The content of the world picture besides scene and camera: the `[world]` section of a figure.

/// The `[world]` section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorldLook {
    /// The picture is the section through C along **u**, as in the side figures of `[0]`, and not the space.
    pub section: bool,
    /// F, B, D, W, H and θ/2 as dimension lines.
    pub dimensions: bool,
    /// Opacity of the image on the view window, 0 … 1; `None`: opaque, but faint where it would hide much of the scene.
    pub window_opacity: Option<f64>,
}
