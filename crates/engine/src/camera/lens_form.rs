//! The lens in the words of other programs and of photography: horizontal and diagonal angle, focal length with a
//! sensor, focal lengths in pixels, and the lens shift.
//!
//! The notes have θ, vertical. Photographs have a focal length in millimetres and a sensor, of which one side spans the
//! image: f / s = F / S with s the side of the sensor and S the same side of the view window.

use super::window::WideWindow;
use super::{Camera, ImageSize, Projection, ViewWindow};
use crate::geometry::double_double::{Dd, atan_degrees, tan_half_degrees};

/// The side of the sensor that spans the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SensorFit {
    /// Its width spans the width of the image.
    #[default]
    Horizontal,
    /// Its height spans the height of the image.
    Vertical,
    /// Its width spans the larger side of the image, as *Auto* of Blender.
    Larger,
}

/// A sensor, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// In pixels.
    pub width: f64,
    /// In pixels.
    pub height: f64,
    /// The side that spans the image.
    pub fit: SensorFit,
}

impl Default for Sensor {
    /// Film of 35 mm: 36 × 24.
    fn default() -> Self {
        Self { width: 36.0, height: 24.0, fit: SensorFit::default() }
    }
}

impl Sensor {
    /// The length that spans a side of an image with this aspect, and true if that side is the width.
    fn spanned(self, aspect: f64) -> (f64, bool) {
        match self.fit {
            SensorFit::Horizontal => (self.width, true),
            SensorFit::Vertical => (self.height, false),
            SensorFit::Larger => (self.width, aspect >= 1.0),
        }
    }
}

/// A way to give the lens of a symmetric window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LensForm {
    /// The horizontal angle in degrees.
    HorizontalAngle(f64),
    /// The angle in degrees from corner to corner.
    DiagonalAngle(f64),
    /// A focal length in millimetres.
    FocalLength {
        /// f.
        focal_length: f64,
        /// The sensor behind it.
        sensor: Sensor,
    },
}

impl LensForm {
    /// θ in degrees, vertical, for a window with aspect A. Rounded once, except for the diagonal angle.
    ///
    /// ```
    /// use camera_lab_engine::camera::{LensForm, Sensor};
    ///
    /// // Half of the width over f is 18/50, and the height is 9/16 of the width.
    /// let lens = LensForm::FocalLength { focal_length: 50.0, sensor: Sensor::default() };
    /// let theta = lens.view_angle(16.0 / 9.0);
    /// assert!(((theta.to_radians() / 2.0).tan() - 18.0 / 50.0 * 9.0 / 16.0).abs() < 1e-15);
    /// ```
    pub fn view_angle(self, aspect: f64) -> f64 {
        let aspect_wide = Dd::new(aspect);
        let slope = match self {
            Self::HorizontalAngle(degrees) => tan_half_degrees(degrees) / aspect_wide,
            Self::DiagonalAngle(degrees) => tan_half_degrees(degrees) / Dd::new(aspect.hypot(1.0)),
            Self::FocalLength { focal_length, sensor } => {
                let (side, is_width) = sensor.spanned(aspect);
                let slope = Dd::new(side).scaled(-1) / Dd::new(focal_length);
                if is_width { slope / aspect_wide } else { slope }
            }
        };
        atan_degrees(slope).scaled(1).value()
    }
}

/// The lens of a perspective camera in other words than θ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LensNumbers {
    /// The horizontal angle in degrees that the window spans, seen from C.
    pub horizontal_angle: f64,
    /// The angle in degrees from its corner (l, b) to its corner (r, t).
    pub diagonal_angle: f64,
    /// `f_x` and `f_y`: F in pixels of the image.
    pub focal_length_pixels: [f64; 2],
}

impl Camera {
    /// The lens in other words. `None` in parallel projection, because parallel projectors span no angle.
    pub fn lens_numbers(&self, image: ImageSize) -> Option<LensNumbers> {
        if self.projection() == Projection::Parallel {
            return None;
        }
        let WideWindow { left, right, bottom, top } = self.wide_window;
        let near = Dd::new(self.near());
        let [l, r, b, t] = [left, right, bottom, top].map(|side| (side / near).value());
        // tan of the angle between (l, b, −1) and (r, t, −1): |cross| over dot.
        let cross = (t - b).hypot(r - l).hypot(l * t - r * b);
        let focal = |pixels: u32, side: Dd| (Dd::new(f64::from(pixels)) * near / side).value();
        Some(LensNumbers {
            horizontal_angle: (atan_degrees(right / near) - atan_degrees(left / near)).value(),
            diagonal_angle: cross.atan2(l * r + b * t + 1.0).to_degrees(),
            focal_length_pixels: [
                focal(image.width, self.wide_window.width()),
                focal(image.height, self.wide_window.height()),
            ],
        })
    }

    /// `f_x`, `f_y`, `c_x` and `c_y` of K in pixels, from the top left corner as in (5.22). In parallel projection
    /// `f_x` and `f_y` are the pixels of a unit of length.
    pub fn intrinsics(&self, image: ImageSize) -> [f64; 4] {
        let [m, n] = [image.width, image.height].map(f64::from);
        let (window, width, height) = (self.window(), self.window_width(), self.window_height());
        let near = if self.projection() == Projection::Perspective { self.near() } else { 1.0 };
        [near / width * m, near / height * n, -window.left / width * m, window.top / height * n]
    }

    /// The focal length in millimetres with a sensor: F / S = f / s for the side that spans the image.
    pub fn focal_length(&self, sensor: Sensor) -> f64 {
        let (side, spanned) = self.spanned(sensor);
        (Dd::new(side) * Dd::new(self.near()) / spanned).value()
    }

    /// The lens shift: the middle of the window, to the right and up, as shares of the side that the sensor spans.
    /// Blender counts it this way, in both projections.
    pub fn lens_shift(&self, sensor: Sensor) -> [f64; 2] {
        let (_, spanned) = self.spanned(sensor);
        let WideWindow { left, right, bottom, top } = self.wide_window;
        [left + right, bottom + top].map(|twice| (twice.scaled(-1) / spanned).value() + 0.0)
    }

    /// The window of the same size with another [`Self::lens_shift`].
    pub fn window_with_shift(&self, sensor: Sensor, [x, y]: [f64; 2]) -> ViewWindow {
        let (_, side) = self.spanned(sensor);
        let ends = |share: f64, length: Dd| {
            [-1.0, 1.0].map(|sign| (Dd::new(share) * side + Dd::new(sign) * length.scaled(-1)).value())
        };
        let ([left, right], [bottom, top]) = (ends(x, self.wide_window.width()), ends(y, self.wide_window.height()));
        ViewWindow { left, right, bottom, top }
    }

    /// The length of the sensor that spans a side of the window, and that side.
    fn spanned(&self, sensor: Sensor) -> (f64, Dd) {
        let (side, is_width) = sensor.spanned(self.window_aspect());
        (side, if is_width { self.wide_window.width() } else { self.wide_window.height() })
    }

    /// W × H of the view at a distance from C, with which they grow in perspective.
    pub fn view_size_at(&self, distance: f64) -> [f64; 2] {
        let scale = match self.projection() {
            Projection::Perspective => Dd::new(distance) / Dd::new(self.near()),
            Projection::Parallel => Dd::new(1.0),
        };
        [self.wide_window.width(), self.wide_window.height()].map(|side| (side * scale).value())
    }
}
