//! Coordinates of one space → the world point with these coordinates.

use glam::{DVec2, DVec3};

use super::{ClipSpace, ImageSize, NotProjectable, Projection, Viewport};
use crate::geometry::double_double::{Dd, Dd3};

/// Coordinates of a point in one of its spaces.
///
/// A place names its space, so that a point of view space isn't taken for one of the world:
///
/// ```compile_fail,E0308
/// # use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Place, Viewport};
/// # use camera_lab_engine::glam::DVec3;
/// # let camera = Camera::new(&Parameters::default())?;
/// # let image = ImageSize::default();
/// let p_view = Place::View(DVec3::new(0.0, 0.0, -2.0));
/// camera.stations(p_view, image, &Viewport::whole(image)); // expects a point of the world
/// # Ok::<(), camera_lab_engine::camera::CameraError>(())
/// ```
///
/// A pixel has whole numbers, so that a point of the view window isn't taken for one:
///
/// ```compile_fail,E0308
/// # use camera_lab_engine::camera::{Camera, ImageSize, Parameters};
/// # use camera_lab_engine::glam::DVec2;
/// # let camera = Camera::new(&Parameters::default())?;
/// # let image = ImageSize::default();
/// let p_window = DVec2::new(0.25, -0.5);
/// camera.ray_through_pixel(image, p_window.x, p_window.y); // `ray_through_window` is meant
/// # Ok::<(), camera_lab_engine::camera::CameraError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// World.
    World(DVec3),
    /// VRC.
    View(DVec3),
    /// NDC, in the convention of the clip space.
    Ndc(DVec3),
    /// (x_p, y_p), and the distance −z_c from the plane of the eye.
    Window(DVec2, f64),
    /// (i, j), and Z of (5.25): the centre of the pixel.
    Pixel([i64; 2], f64),
}

impl ClipSpace<'_> {
    /// The world point at a place. M_p and M_v are undone in double-double and rounded once.
    ///
    /// # Errors
    /// [`NotProjectable`]: no point has these coordinates.
    ///
    /// NDC distinguish the sides of the eye in perspective: behind it, and only there, `z_n` is beyond its limit at
    /// infinity. So the NDC that the division gives to a point behind the eye lead back to it. Only those of its plane,
    /// and of infinity, have no point.
    pub fn world_of(&self, image: ImageSize, viewport: &Viewport, place: Place) -> Result<DVec3, NotProjectable> {
        let camera = self.camera();
        let (world, depth) = match place {
            Place::World(p) => (p, p.z),
            Place::View(p) => {
                let view = Dd3::new(Dd::new(p.x), Dd::new(p.y), Dd::new(p.z));
                (camera.world_of_view(view).value() + 0.0, p.z)
            }
            Place::Ndc(p) => {
                let window = self.window_of_ndc(p);
                (self.world_of_window(window, self.distance_of_ndc(p.z)?), p.z)
            }
            Place::Window(_, 0.0) if camera.projection() == Projection::Perspective => {
                return Err(NotProjectable::InPlaneOfEye);
            }
            Place::Window(p, distance) => {
                (self.world_of_window([Dd::new(p.x), Dd::new(p.y)], Dd::new(distance)), distance)
            }
            Place::Pixel(pixel, depth) => return Ok(self.way_back(image, viewport, pixel, depth)?.world),
        };
        if world.is_finite() { Ok(world) } else { Err(NotProjectable::Overflow { depth }) }
    }

    /// (x_p, y_p), `[0]` Eqs. (5.11) and (5.12) solved for them.
    fn window_of_ndc(&self, ndc: DVec3) -> [Dd; 2] {
        let w = &self.camera().wide_window;
        let y = if self.ndc().y_points_down() { -ndc.y } else { ndc.y };
        let along = |low: Dd, high: Dd, size: Dd, ndc: f64| ((low + high) + Dd::new(ndc) * size).scaled(-1);
        [along(w.left, w.right, w.width(), ndc.x), along(w.bottom, w.top, w.height(), y)]
    }

    /// The distance from the plane of the eye, below 0 behind it: in perspective z_n = d/distance − z, in parallel
    /// projection z_n = d − z distance.
    fn distance_of_ndc(&self, z_n: f64) -> Result<Dd, NotProjectable> {
        let (z, depth) = (self.lens.z, self.lens.depth);
        match self.camera().projection() {
            Projection::Parallel => Ok((depth - Dd::new(z_n)) / z),
            Projection::Perspective => {
                let distance = depth / (Dd::new(z_n) + z);
                if distance.value() != 0.0 && distance.value().is_finite() {
                    return Ok(distance);
                }
                let [near, _] = self.ndc().depths();
                Err(NotProjectable::BeyondInfinity { depth: z_n, near, infinity: (-z).value() + 0.0 })
            }
        }
    }

    fn world_of_window(&self, [x, y]: [Dd; 2], distance: Dd) -> DVec3 {
        let camera = self.camera();
        let view = match camera.projection() {
            Projection::Parallel => Dd3::new(x, y, -distance),
            Projection::Perspective => {
                let share = distance / Dd::new(camera.near());
                Dd3::new(x * share, y * share, -distance)
            }
        };
        camera.world_of_view(view).value() + 0.0
    }
}
