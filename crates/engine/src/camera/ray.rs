//! The ray through a window point or a pixel: `[0]` §5.4, Eqs. (5.17) to (5.21).

use glam::DVec2;

use super::{Camera, ImageSize, Projection};
use crate::geometry::Ray;
use crate::geometry::double_double::{Dd, Dd3};

impl Camera {
    /// The ray through a point of the view window, `[0]` Eqs. (5.17) to (5.21). In parallel projection it starts on
    /// the plane through C, as (5.21) has it, not on the window.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, Parameters, Projection};
    /// # use glam::{DVec2, DVec3};
    /// // [0] Exercise 5.1, parallel projection: the ray through (1, 1).
    /// let position = DVec3::new(3.0, 4.0, 0.0);
    /// let parallel = Parameters { position, projection: Projection::Parallel, ..Parameters::default() };
    /// let ray = Camera::new(&parallel)?.ray_through_window(DVec2::ONE);
    /// assert_eq!(ray.origin, DVec3::new(2.2, 4.6, -1.0));
    /// assert_eq!(ray.direction, DVec3::new(-0.6, -0.8, 0.0));
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    pub fn ray_through_window(&self, point: DVec2) -> Ray {
        self.ray(Dd::new(point.x), Dd::new(point.y))
    }

    /// The ray through the centre of the pixel (i, j): (5.23) at (i + 1/2, j + 1/2), then (5.17) to (5.21).
    ///
    /// *Guarantees*: rounded once, at the end.
    pub fn ray_through_pixel(&self, image: ImageSize, i: i64, j: i64) -> Ray {
        let half = Dd::new(0.5);
        let [x, y] = self.window_of_image(image, [whole(i) + half, whole(j) + half]);
        self.ray(x, y)
    }

    fn ray(&self, x: Dd, y: Dd) -> Ray {
        match self.projection() {
            Projection::Perspective => {
                let p = Dd3::new(x, y, Dd::new(-self.near())).unit();
                Ray { origin: self.position(), direction: self.world_direction(p).value() }
            }
            Projection::Parallel => Ray {
                origin: self.world_of_view(Dd3::new(x, y, Dd::ZERO)).value(),
                direction: self.direction_of_projection(),
            },
        }
    }
}

/// Exactly `i`: 63 bits fit into two halves of 32.
pub(super) fn whole(i: i64) -> Dd {
    let (high, low) = ((i >> 32) as i32, (i & 0xffff_ffff) as u32);
    Dd::sum(f64::from(high) * 4_294_967_296.0, f64::from(low))
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn whole_numbers_of_63_bits_are_taken_exactly() {
        for i in [0, 1, -1, 4_294_967_295, 4_294_967_296, -4_294_967_297, (1 << 53) + 1, i64::MAX, i64::MIN + 1] {
            // Each part is a whole number below 2^64.
            #[expect(clippy::cast_possible_truncation, reason = "both parts are whole numbers of at most 64 bits")]
            let sum: i128 = whole(i).parts().iter().map(|&part| part as i128).sum();
            assert_eq!(sum, i128::from(i));
        }
    }
}
