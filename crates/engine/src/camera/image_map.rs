//! Window ↔ image, `[0]` Eqs. (5.22) and (5.23), and the viewport with its depth range, Eqs. (5.24) and (5.25).
//!
//! The notes write the maps for a symmetric window. With l, r, b, t they read i : m = (x_p − l) : W and j : n = (t −
//! y_p) : H. The pixel (i, j) owns its left and its upper border. So the right and the lower border of the window
//! belong to the pixels i = m and j = n, which lie outside the image (see [`ImageSize::contains`]).

use glam::DVec2;

use super::{Camera, ViewWindow};
use crate::geometry::double_double::Dd;

/// The size of an image in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ImageSize {
    /// m
    pub width: u32,
    /// n
    pub height: u32,
}

impl Default for ImageSize {
    fn default() -> Self {
        Self { width: 1024, height: 768 }
    }
}

impl ImageSize {
    /// m / n.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// True if (i, j), as (5.22) gives it, is a pixel of the image. False on the right and on the lower border, where i
    /// = m, j = n.
    pub fn contains(self, pixel: DVec2) -> bool {
        pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < f64::from(self.width) && pixel.y < f64::from(self.height)
    }

    /// The image coordinates (x to the right, y down, (0, 0) the corner at the top left) of a window point, before
    /// (5.22) takes the floor.
    pub fn image_from_window(self, window: &ViewWindow, point: DVec2) -> DVec2 {
        DVec2::new(
            f64::from(self.width) * ((point.x - window.left) / window.width()),
            f64::from(self.height) * ((window.top - point.y) / window.height()),
        )
    }

    /// The window point at image coordinates, `[0]` Eq. (5.23): whole numbers are the upper left corners of pixels,
    /// (i + 1/2, j + 1/2) is the centre of one.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{ImageSize, ViewWindow};
    /// # use glam::DVec2;
    /// let window = ViewWindow { left: -4.0, right: 4.0, bottom: -3.0, top: 3.0 };
    /// let image = ImageSize { width: 8, height: 6 };
    /// assert_eq!(image.window_from_image(&window, DVec2::new(0.0, 0.0)), DVec2::new(-4.0, 3.0));
    /// assert_eq!(image.window_from_image(&window, DVec2::new(0.5, 0.5)), DVec2::new(-3.5, 2.5));
    /// ```
    pub fn window_from_image(self, window: &ViewWindow, image: DVec2) -> DVec2 {
        DVec2::new(
            window.left + window.width() * (image.x / f64::from(self.width)),
            window.top - window.height() * (image.y / f64::from(self.height)),
        )
    }
}

/// glViewport and glDepthRange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Left, pixels.
    pub x: i32,
    /// Bottom, pixels.
    pub y: i32,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Depth of z_n = −1.
    pub depth_near: f64,
    /// Depth of z_n = 1.
    pub depth_far: f64,
}

impl Viewport {
    /// The whole image, depth 0 … 1.
    pub fn whole(image: ImageSize) -> Self {
        Self { x: 0, y: 0, width: image.width, height: image.height, depth_near: 0.0, depth_far: 1.0 }
    }

    /// (X, Y, Z) of a point in NDC: (5.24) with X and Y floored, and (5.25). `noise` is that of x and y, as parts of W
    /// and H.
    pub(super) fn of_ndc(&self, [x, y, z]: [Dd; 3], noise: [f64; 2]) -> [f64; 3] {
        let along = |size: u32, start: i32, t: Dd, noise: f64| {
            let size = f64::from(size);
            (Dd::new(size) * (t + Dd::ONE).scaled(-1) + Dd::new(f64::from(start))).floor(size * noise)
        };
        let (near, far) = (Dd::new(self.depth_near), Dd::new(self.depth_far));
        let depth = ((far - near).scaled(-1) * z).plus((far + near).scaled(-1));
        [along(self.width, self.x, x, noise[0]), along(self.height, self.y, y, noise[1]), depth.value()]
    }
}

impl Camera {
    /// (5.22): the pixel of a window point. `noise` is that of x and y, as parts of W and H.
    pub(super) fn pixel_of_window(&self, image: ImageSize, [x, y]: [Dd; 2], noise: [f64; 2]) -> [f64; 2] {
        let w = &self.wide_window;
        let (m, n) = (f64::from(image.width), f64::from(image.height));
        let (i, j) = ((x - w.left) / w.width(), (w.top - y) / w.height());
        [(Dd::new(m) * i).floor(m * noise[0]), (Dd::new(n) * j).floor(n * noise[1])]
    }

    /// (5.23): the window point at image coordinates.
    pub(super) fn window_of_image(&self, image: ImageSize, [i, j]: [Dd; 2]) -> [Dd; 2] {
        let w = &self.wide_window;
        let (m, n) = (Dd::new(f64::from(image.width)), Dd::new(f64::from(image.height)));
        [w.left + w.width() * (i / m), w.top - w.height() * (j / n)]
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

    use super::*;
    use crate::camera::Parameters;

    #[test]
    fn a_window_point_is_on_a_border_of_pixels_within_the_noise_of_its_computation_and_no_farther() {
        let window = ViewWindow { left: 0.0, right: 1.0, bottom: 0.0, top: 1.0 };
        let camera = Camera::new(&Parameters { window: Some(window), ..Parameters::default() }).unwrap();
        let image = ImageSize { width: 100, height: 50 };
        // Parts of W and H: 1e-7 of a pixel across, 5e-8 down.
        let noise = [1e-9, 1e-9];
        let pixel = |x: f64, y: f64| camera.pixel_of_window(image, [x, y].map(Dd::new), noise);
        assert_eq!(pixel(0.3 - 5e-10, 0.4 + 5e-10), [30.0, 30.0], "within the noise: on the border");
        assert_eq!(pixel(0.3 - 2e-9, 0.4 + 2e-9), [29.0, 29.0], "beyond it: the pixel before");
        assert_eq!(pixel(0.3 + 2e-9, 0.4 - 2e-9), [30.0, 30.0]);
        // A bound of one direction doesn't hold for the other.
        let across = camera.pixel_of_window(image, [0.3 - 5e-10, 0.4 + 5e-10].map(Dd::new), [1e-9, 0.0]);
        assert_eq!(across, [30.0, 29.0]);
    }
}
