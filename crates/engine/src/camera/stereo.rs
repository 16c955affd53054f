//! A stereo pair: two cameras side by side, as the eyes of a viewer.

use glam::DVec3;

use super::{Camera, CameraError, Parameters, ViewWindow};

/// The way in which the two cameras of a stereo pair meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Convergence {
    /// The axes are parallel, and the windows are shifted towards each other, so that they coincide at distance D. A
    /// point has the same y in both images, and its disparity depends on its depth alone.
    #[default]
    ShiftedWindows,
    /// Both cameras look at PF. The images of one point differ in y too, except on the plane through both C and PF.
    ToeIn,
}

impl Camera {
    /// The left and the right camera of a stereo pair whose positions are `baseline` apart along **u**, with this
    /// camera in the middle.
    ///
    /// # Errors
    /// [`CameraError`] if a camera of the pair is impossible, for example because the baseline is infinite.
    pub fn stereo(&self, baseline: f64, convergence: Convergence) -> Result<[Self; 2], CameraError> {
        let one = |side: f64| Self::new(&self.aside(self.basis().u * (side * baseline), side * baseline, convergence));
        Ok([one(-0.5)?, one(0.5)?])
    }

    fn aside(&self, way: DVec3, along_u: f64, convergence: Convergence) -> Parameters {
        let own = self.parameters();
        let position = own.position + way;
        match convergence {
            Convergence::ToeIn => Parameters { position, ..*own },
            Convergence::ShiftedWindows => {
                // On the plane at F the window goes F/D of the way back: similar triangles.
                let back = along_u * own.near / self.distance();
                let ViewWindow { left, right, bottom, top } = self.window();
                let window = ViewWindow { left: left - back, right: right - back, bottom, top };
                Parameters { position, focal_point: own.focal_point + way, window: Some(window), ..*own }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::ImageSize;

    fn pixels(cameras: &[Camera; 2], p: DVec3) -> [glam::DVec2; 2] {
        let image = ImageSize { width: 4000, height: 3000 };
        cameras.each_ref().map(|camera| {
            let window = camera.stations(p, image, &crate::camera::Viewport::whole(image)).projected.unwrap().window;
            let ViewWindow { left, bottom, .. } = camera.window();
            window - glam::DVec2::new(left, bottom)
        })
    }

    #[test]
    fn with_shifted_windows_disparity_is_the_baseline_times_f_over_depth_less_that_at_d() {
        let middle = Camera::new(&Parameters::default()).unwrap();
        let (b, d) = (0.4, middle.distance());
        let pair = middle.stereo(b, Convergence::ShiftedWindows).unwrap();
        let apart = pair[0].position().distance(pair[1].position());
        assert!((apart - b).abs() < 1e-12);
        for along in [0.4, 1.0, 1.7] {
            let basis = middle.basis();
            let p = middle.position() - basis.n * (along * d) + basis.u * 0.3 - basis.v * 0.2;
            let [left, right] = pixels(&pair, p);
            assert!((left.y - right.y).abs() < 1e-12, "no vertical disparity");
            let depth = along * d;
            let disparity = b * middle.near() * (1.0 / depth - 1.0 / d);
            assert!((left.x - right.x - disparity).abs() < 1e-12, "{} {disparity}", left.x - right.x);
        }
    }

    #[test]
    fn with_toe_in_both_look_at_pf_and_points_beside_it_differ_in_height() {
        let middle = Camera::new(&Parameters::default()).unwrap();
        let pair = middle.stereo(0.6, Convergence::ToeIn).unwrap();
        let [left, right] = pixels(&pair, middle.focal_point());
        assert!((left - right).length() < 1e-12);
        let basis = middle.basis();
        let [left, right] = pixels(&pair, middle.focal_point() + basis.u * 0.8 + basis.v * 0.8);
        assert!((left.y - right.y).abs() > 1e-4, "keystone");
    }
}
