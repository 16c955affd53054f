//! scene + camera → [`Drawing`]: the stages in the order of the notes.

use crate::appearance::Style;
use crate::camera::Camera;
use crate::drawing::Drawing;
use crate::scene::Scene;

/// The picture to make: its size in pixels, and how large a stroke's or letter's unit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Pixels of this picture for one unit of stroke width or type size.
    pub scale: f32,
    /// Ground of the picture.
    pub background: crate::appearance::Rgba,
}

/// Draws `scene` as `camera` sees it. The view window fills the whole target: who wants no distortion gives a target with the
/// window's aspect.
#[must_use]
pub fn draw(_scene: &Scene, _camera: &Camera, target: Target, style: &Style) -> Drawing {
    Drawing {
        width: target.width,
        height: target.height,
        background: target.background,
        antialias: style.antialias,
        surfaces: Vec::new(),
        strokes: Vec::new(),
        marks: Vec::new(),
        labels: Vec::new(),
    }
}
