//! The photograph under the image.

/// A photograph that fills the image under the scene, for comparing the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Photograph {
    /// `[image] photograph`: the file, relative to the figure file.
    pub file: String,
    /// `[image] photograph_opacity`, 0 … 1: its share. The background has the rest.
    pub opacity: f64,
}

impl Photograph {
    /// The opacity without the key.
    pub const USUAL_OPACITY: f64 = 0.5;
}
