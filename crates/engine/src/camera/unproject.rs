//! From a window point or a pixel back to the world. Without a depth it's a ray, `[0]` §5.4, Eqs. (5.17) to (5.21);
//! with one a point, Eqs. (5.23) and (5.25), then M_p and M_v undone.

use glam::{DVec2, DVec3, DVec4};

use super::{Camera, ClipSpace, ImageSize, Projection, Viewport};
use crate::geometry::Ray;
use crate::geometry::double_double::{Dd, Dd3};

/// The centre of a pixel at a depth, in every space on its way back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unprojected {
    /// (i, j)
    pub pixel: [i64; 2],
    /// Z of (5.25)
    pub depth: f64,
    /// (x_p, y_p) on the plane of the view window.
    pub window: DVec2,
    /// NDC, in the convention of the clip space.
    pub ndc: DVec3,
    /// Clip coordinates.
    pub clip: DVec4,
    /// VRC.
    pub view: DVec3,
    /// World.
    pub world: DVec3,
}

/// The reason why a depth belongs to no point.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotProjectable {
    /// glDepthRange(n, n).
    #[error("every depth is {depth}: with depth_near = depth_far there is no way back")]
    EmptyDepthRange {
        /// n = f
        depth: f64,
    },
    /// Z reaches a limit at infinity in perspective.
    #[error(
        "depth {depth}: no point of the world is that far; from the front plane to infinity, depths go from {near} towards {infinity}"
    )]
    BeyondInfinity {
        /// Z
        depth: f64,
        /// Z on the near plane
        near: f64,
        /// Z at infinity
        infinity: f64,
    },
    /// Every line of sight goes through C in perspective, so points in its plane have no place on the window.
    #[error("distance 0: in the plane of the eye no point has an image; allowed: any other distance, such as F")]
    InPlaneOfEye,
    /// A coordinate exceeds the range of `f64`.
    #[error("depth {depth}: the point's coordinates would exceed the range of numbers (about 1e-308 to 1e308)")]
    Overflow {
        /// Z
        depth: f64,
    },
}

impl ClipSpace<'_> {
    /// The world point at the centre of pixel (i, j) that has the depth Z of (5.25).
    ///
    /// With t = (Z − n)/(f − n), 0 on the near plane and 1 on the far one: −z_c = F + t (B − F) in parallel projection,
    /// and `1/(−z_c)` = (1 − t)/F + t/B in perspective, where nothing cancels however large B/F.
    ///
    /// ```
    /// use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Viewport};
    /// use glam::DVec3;
    ///
    /// let position = DVec3::new(0.0, 0.0, 5.0);
    /// let p = Parameters { position, view_angle: 90.0, near: 1.0, far: 3.0, aspect: 1.0, ..Parameters::default() };
    /// let camera = Camera::new(&p)?;
    /// let image = ImageSize { width: 100, height: 100 };
    /// let way = camera.notes_clip_space().way_back(image, &Viewport::whole(image), [75, 75], 0.75)?;
    /// // The centre of the pixel of (1, −1, 3), half a pixel from it.
    /// assert_eq!(way.view, DVec3::new(1.02, -1.02, -2.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NotProjectable`]: an empty depth range, or a depth that no point in front of the camera has.
    pub fn way_back(
        &self,
        image: ImageSize,
        viewport: &Viewport,
        pixel: [i64; 2],
        depth: f64,
    ) -> Result<Unprojected, NotProjectable> {
        let camera = self.camera();
        let Viewport { depth_near, depth_far, .. } = *viewport;
        if depth_near == depth_far {
            return Err(NotProjectable::EmptyDepthRange { depth: depth_near });
        }
        let (near, far) = (Dd::new(camera.near()), Dd::new(camera.far()));
        let range = Dd::difference(depth_far, depth_near);
        let (t, rest) = (Dd::difference(depth, depth_near) / range, Dd::difference(depth_far, depth) / range);
        let half = Dd::new(0.5);
        let [x, y] = camera.window_of_image(image, [whole(pixel[0]) + half, whole(pixel[1]) + half]);
        let view = match camera.projection() {
            Projection::Perspective => {
                let over_distance = rest / near + t / far;
                if over_distance.value() <= 0.0 {
                    // t/F = (t − 1)... : where 1/(−z_c) is 0.
                    let limit = far / (far - near);
                    let infinity = (Dd::new(depth_near) + range * limit).value();
                    return Err(NotProjectable::BeyondInfinity { depth, near: depth_near, infinity });
                }
                let distance = Dd::ONE / over_distance;
                Dd3::new(x * distance / near, y * distance / near, -distance)
            }
            Projection::Parallel => Dd3::new(x, y, -(near + t * (far - near))),
        };
        let clip = self.lens.clip(camera.projection(), view);
        let ndc = [0, 1, 2].map(|k| (clip[k] / clip[3]).value() + 0.0);
        let way = Unprojected {
            pixel,
            depth,
            window: DVec2::new(x.value() + 0.0, y.value() + 0.0),
            ndc: DVec3::from_array(ndc),
            clip: DVec4::from_array(clip.map(|c| c.value() + 0.0)),
            view: view.value() + 0.0,
            world: camera.world_of_view(view).value() + 0.0,
        };
        let finite = way.ndc.is_finite() && way.clip.is_finite() && way.view.is_finite() && way.world.is_finite();
        if finite { Ok(way) } else { Err(NotProjectable::Overflow { depth }) }
    }
}

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
fn whole(i: i64) -> Dd {
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
