//! What can be taken with the pointer in the world: where it is on the screen, and what dragging it does.

use glam::{DVec2, DVec3};

use crate::camera::Parameters;
use crate::figure::Observer;
use crate::geometry::{Ray, try_unit};

use super::Setup;
use super::screen::Screen;
use super::world::{self, Gear};

/// Something that can be dragged in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// C
    Position,
    /// PF
    FocalPoint,
    /// The tip of VUP.
    ViewUp,
    /// The front face.
    Near,
    /// The back face.
    Far,
}

/// The handles that lie in the picture, with their places in pixels.
#[must_use]
pub fn handles(setup: &Setup, observer: &Observer) -> Vec<(Handle, DVec2)> {
    let Some(screen) = world::screen(setup, observer) else { return Vec::new() };
    on_screen(setup, &screen).into_iter().filter_map(|(h, p)| Some((h, screen.place_inside(p)?))).collect()
}

/// The handle at `pointer` (pixels), within `reach` pixels. Of two at the same place the one that comes first in [`Handle`].
#[must_use]
pub fn handle_at(setup: &Setup, observer: &Observer, pointer: DVec2, reach: f64) -> Option<Handle> {
    handles(setup, observer)
        .into_iter()
        .map(|(handle, place)| (handle, place.distance(pointer)))
        .filter(|(_, distance)| *distance <= reach)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(handle, _)| handle)
}

/// Where the handles are in the world.
pub(super) fn on_screen(setup: &Setup, screen: &Screen) -> Vec<(Handle, DVec3)> {
    let camera = setup.camera;
    let mut all = vec![
        (Handle::Position, camera.position()),
        (Handle::FocalPoint, camera.focal_point()),
        (Handle::ViewUp, Gear::new(screen, camera).view_up_tip(camera)),
    ];
    all.extend(on_axis(setup, screen, 20.0));
    all
}

/// The handles of the clipping planes on the axis of projection, but at least `clear` pixels away from C, where a small F
/// would hide its handle; none where the axis is seen end-on.
pub(super) fn on_axis(setup: &Setup, screen: &Screen, clear: f64) -> Vec<(Handle, DVec3)> {
    let camera = setup.camera;
    let (c, dop) = (camera.position(), camera.direction_of_projection());
    let unit = screen.units_per_pixel(c);
    let pixels_per_step = match (screen.place(c), screen.place(c + dop * unit)) {
        (Some(a), Some(b)) => a.distance(b),
        _ => 0.0,
    };
    if pixels_per_step < 0.05 {
        return Vec::new();
    }
    let least = unit * clear / pixels_per_step;
    [(Handle::Near, camera.near()), (Handle::Far, camera.far())].map(|(h, d)| (h, c + dop * d.max(least))).to_vec()
}

/// The camera parameters after `handle` was taken at `from` and is now at `to` (pixels), beginning with the camera of `setup`,
/// which must be the one at the time of taking.
///
/// C and PF move on the plane y = their own height, or vertically; where that plane is seen from the edge they move in the
/// plane of the picture. Near and far move along the axis of projection and stop at each other. The tip of VUP moves in the
/// plane of the picture; VUP keeps its length.
///
/// # Guarantees
/// A drag that cannot be read (an axis seen end-on, an observer that is no camera) changes nothing.
#[must_use]
pub fn drag(setup: &Setup, observer: &Observer, handle: Handle, from: DVec2, to: DVec2, vertical: bool) -> Parameters {
    let mut parameters = *setup.camera.parameters();
    let Some(screen) = world::screen(setup, observer) else { return parameters };
    let grip = Grip { observer, from: screen.ray(from), to: screen.ray(to) };
    let camera = setup.camera;
    let along_axis = || grip.along(camera.position(), camera.direction_of_projection()).unwrap_or(0.0);
    match handle {
        Handle::Position => parameters.position += grip.shift(camera.position(), vertical),
        Handle::FocalPoint => parameters.focal_point += grip.shift(camera.focal_point(), vertical),
        Handle::Near => {
            let least = (1e-3 * camera.distance()).min(camera.near());
            parameters.near = (camera.near() + along_axis()).clamp(least, (0.99 * camera.far()).max(camera.near()));
        }
        Handle::Far => parameters.far = (camera.far() + along_axis()).max((1.01 * camera.near()).min(camera.far())),
        Handle::ViewUp => {
            let tip = Gear::new(&screen, camera).view_up_tip(camera);
            let moved = tip + grip.in_picture(tip) - camera.position();
            if let Some(up) = try_unit(moved) {
                parameters.view_up = up * camera.view_up().length();
            }
        }
    }
    parameters
}

/// The pointer's ray when it took something, and its ray now.
#[derive(Clone, Copy, Debug)]
struct Grip<'a> {
    observer: &'a Observer,
    from: Ray,
    to: Ray,
}

impl Grip<'_> {
    /// How far a point goes with the pointer, on its horizontal plane or vertically.
    fn shift(&self, p: DVec3, vertical: bool) -> DVec3 {
        /// Below this elevation a step of the pointer would throw a point on the ground too far.
        const EDGE_ON: f64 = 8.0;
        if vertical {
            // Seen from above, a vertical has no length on the screen.
            return self.along(p, DVec3::Y).map_or(DVec3::ZERO, |t| DVec3::Y * t);
        }
        if self.observer.elevation.abs() < EDGE_ON {
            return self.in_picture(p);
        }
        let hit = |ray: Ray| on_horizontal(ray, p.y, self.observer);
        hit(self.to) - hit(self.from)
    }

    /// How far a point goes with the pointer in the plane through it that is parallel to the picture.
    fn in_picture(&self, p: DVec3) -> DVec3 {
        let [_, _, back] = self.observer.axes();
        let hit = |ray: Ray| {
            let t = back.dot(p - ray.origin) / back.dot(ray.direction);
            ray.origin + ray.direction * t
        };
        let shift = hit(self.to) - hit(self.from);
        if shift.is_finite() { shift } else { DVec3::ZERO }
    }

    /// How far the point of a line nearest to the pointer's ray goes; `None` where the line is seen end-on.
    fn along(&self, origin: DVec3, direction: DVec3) -> Option<f64> {
        Some(nearest_on_line(origin, direction, self.to)? - nearest_on_line(origin, direction, self.from)?)
    }
}

/// Where a ray meets the plane y = `height`. A ray at or over the horizon is bent down (or up) to it, so that a point dragged
/// there goes far, but neither to infinity nor behind the eye.
fn on_horizontal(ray: Ray, height: f64, observer: &Observer) -> DVec3 {
    const LEAST_SLOPE: f64 = 0.03;
    let side = observer.elevation.signum();
    let slope = (-side * ray.direction.y).max(LEAST_SLOPE);
    let t = side * (ray.origin.y - height) / slope;
    let p = ray.origin + ray.direction * t;
    DVec3::new(p.x, height, p.z)
}

/// The parameter on a line (unit direction) of the point nearest to a ray; `None` for lines within about 1° of parallel.
fn nearest_on_line(origin: DVec3, direction: DVec3, ray: Ray) -> Option<f64> {
    let (d, r) = (direction, ray.direction);
    let cos = d.dot(r);
    let sin2 = d.cross(r).length_squared();
    let w = ray.origin - origin;
    (sin2 > 3e-4).then(|| (d.dot(w) - cos * r.dot(w)) / sin2)
}
