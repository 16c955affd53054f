//! The image that a picture is drawn on, in pixels.

use glam::DVec2;

use crate::pipeline::Target;

/// The size of the image.
#[derive(Clone, Debug)]
pub(crate) struct Screen {
    /// Half of the width, pixels.
    pub(crate) half_width: f64,
    /// Half of the height, pixels.
    pub(crate) half_height: f64,
}

/// Corners of triangles lie on this grid of the pixel, so decisions about a triangle (its orientation, its coverage)
/// are exact arithmetic on the very numbers that are drawn.
pub(crate) const SUBPIXELS: f64 = 256.0;

impl Screen {
    pub(crate) fn new(target: Target) -> Self {
        Self { half_width: f64::from(target.width) / 2.0, half_height: f64::from(target.height) / 2.0 }
    }

    /// Half of the image's width and height, pixels.
    pub(crate) fn half_size(&self) -> DVec2 {
        DVec2::new(self.half_width, self.half_height)
    }

    /// A point of the window, by its x_n and y_n, in pixels (y down).
    pub(crate) fn pixels(&self, ndc: DVec2) -> DVec2 {
        self.half_size() + DVec2::new(ndc.x, -ndc.y) * self.half_size()
    }

    /// Greatest distance by which [`snap`](crate::pipeline::stage::vertex::snap) moves a point of this image, pixels:
    /// half a step of the grid in x and in y, and no more than that by single precision, as long as that has the steps.
    pub(crate) fn snap_distance(&self) -> f64 {
        let single = 2.0 * self.half_size().max_element() * f64::from(f32::EPSILON);
        2.0 * (0.5 / SUBPIXELS).max(single)
    }
}
