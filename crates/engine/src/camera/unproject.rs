//! From a pixel with a depth back to the world: `[0]` Eqs. (5.23) and (5.25), then M_p and M_v undone.

use glam::{DVec2, DVec3, DVec4};

use super::ray::whole;
use super::{ClipSpace, ImageSize, Projection, Viewport};
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
