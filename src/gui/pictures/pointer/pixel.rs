//! Pixels of the figure's image, from points of the view window and back.

use glam::DVec2;

use crate::camera::{Camera, ImageSize};

/// The pixel (i, j) of the figure's image at a point of the view window, `[0]` Eq. (5.22). On the right and the lower
/// border, the last one.
pub(in crate::gui::pictures) fn pixel_of(image: ImageSize, camera: &Camera, point: DVec2) -> DVec2 {
    let last = DVec2::new(f64::from(image.width), f64::from(image.height)) - 1.0;
    image.image_from_window(&camera.window(), point).floor().clamp(DVec2::ZERO, last.max(DVec2::ZERO))
}

/// The point of the view window at the centre of a pixel, `[0]` Eq. (5.23).
pub(in crate::gui::pictures) fn center_of(image: ImageSize, camera: &Camera, pixel: DVec2) -> DVec2 {
    image.window_from_image(&camera.window(), pixel + 0.5)
}
