//! The handles of the world: their places on the screen, and the effect of dragging them.

use glam::{DVec2, DVec3};

use crate::camera::Parameters;
use crate::figure::{Observer, WorldPart};
use crate::geometry::{Ray, try_unit};

use crate::views::screen::Screen;
use crate::views::world::camera_gizmo::GizmoSizes;
use crate::views::world::framing::Content;
use crate::views::world::volume::DrawnVolume;
use crate::views::world::world_framing;
use crate::views::{Handle, Request};

/// The handles that lie in the picture, with their places in pixels.
pub fn handles(request: &Request) -> Vec<(Handle, DVec2)> {
    let Some(screen) = world_framing::screen(request) else { return Vec::new() };
    let volume = Content::of(request).volume;
    on_screen(request, &screen, &volume).into_iter().filter_map(|(h, p)| Some((h, screen.place_inside(p)?))).collect()
}

/// The handle at `pointer` (pixels), within `reach` pixels. Of two at the same place, it's the one that comes first in
/// [`Handle`].
pub fn handle_at(request: &Request, pointer: DVec2, reach: f64) -> Option<Handle> {
    handles(request)
        .into_iter()
        .map(|(handle, place)| (handle, place.distance(pointer)))
        .filter(|(_, distance)| *distance <= reach)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(handle, _)| handle)
}

/// The places of the handles in the world. A hidden part has none.
pub(in crate::views) fn on_screen(request: &Request, screen: &Screen, volume: &DrawnVolume) -> Vec<(Handle, DVec3)> {
    let camera = &request.camera;
    let parts = request.shot.look.world.parts;
    let mut all = vec![(Handle::Position, camera.position())];
    if parts.has(WorldPart::FocalPoint) {
        all.push((Handle::FocalPoint, camera.focal_point()));
    }
    if parts.has(WorldPart::ViewUp) {
        all.push((Handle::ViewUp, GizmoSizes::new(screen, camera, &request.shot.look.world).view_up_tip(camera)));
    }
    if parts.has(WorldPart::Volume) {
        all.extend(on_axis(request, screen, volume, 20.0));
    }
    all
}

/// The handles of the clipping planes on the axis of projection, but at least `clear` pixels (at scale 1) away from C,
/// because a small F would hide its handle there. Empty if the axis is seen end-on. The handle of a broken volume's far
/// plane is where the plane is drawn.
pub(in crate::views) fn on_axis(
    request: &Request,
    screen: &Screen,
    volume: &DrawnVolume,
    clear: f64,
) -> Vec<(Handle, DVec3)> {
    let camera = &request.camera;
    let (c, dop) = (camera.position(), camera.direction_of_projection());
    let unit = screen.units_per_pixel(c);
    let pixels_per_step = match (screen.place(c), screen.place(c + dop * unit)) {
        (Some(a), Some(b)) => a.distance(b),
        _ => 0.0,
    };
    if pixels_per_step < 0.05 {
        return Vec::new();
    }
    let least = unit * clear * screen.scale / pixels_per_step;
    [(Handle::Near, volume.start), (Handle::Far, volume.end)].map(|(h, d)| (h, c + dop * d.max(least))).to_vec()
}

/// The camera parameters after `handle` was grabbed at `from` and is now at `to` (pixels), beginning with the camera of
/// `request`, which must be the one at the time of grabbing.
///
/// C and PF move on the plane y = their own height, or vertically. If that plane is seen edge-on, they move in the
/// plane of the picture. Near and far move along the axis of projection and stop at each other. The far plane of a
/// volume that's drawn broken moves in proportion, so if it's drawn half as far away, B is half as great. The tip of
/// VUP moves in the plane of the picture, and VUP keeps its length.
///
/// # Guarantees
/// A drag that can't be interpreted (an axis seen end-on, an observer that isn't a camera) changes nothing.
pub fn drag(request: &Request, handle: Handle, from: DVec2, to: DVec2, vertical: bool) -> Parameters {
    let mut parameters = *request.camera.parameters();
    let Some(screen) = world_framing::screen(request) else { return parameters };
    let observer = world_framing::seen_from(request);
    let grip = Grip { observer: &observer, from: screen.ray(from), to: screen.ray(to) };
    let camera = &request.camera;
    let along_axis = || grip.along(camera.position(), camera.direction_of_projection()).unwrap_or(0.0);
    match handle {
        Handle::Position => parameters.position += grip.shift(camera.position(), vertical),
        Handle::FocalPoint => parameters.focal_point += grip.shift(camera.focal_point(), vertical),
        Handle::Near => {
            let least = (1e-3 * camera.distance()).min(camera.near());
            let near = Content::of(request).volume.near_moved(along_axis());
            parameters.near = near.clamp(least, (0.99 * camera.far()).max(camera.near()));
        }
        Handle::Far => {
            let far = Content::of(request).volume.far_moved(along_axis());
            parameters.far = far.max((1.01 * camera.near()).min(camera.far()));
        }
        Handle::ViewUp => {
            let tip = GizmoSizes::new(&screen, camera, &request.shot.look.world).view_up_tip(camera);
            let moved = tip + grip.in_picture(tip) - camera.position();
            if let Some(up) = try_unit(moved) {
                parameters.view_up = up * camera.view_up().length();
            }
        }
    }
    parameters
}

/// The pointer's ray at the time of grabbing, and its ray now.
#[derive(Clone, Copy, Debug)]
pub(in crate::views) struct Grip<'a> {
    pub(in crate::views) observer: &'a Observer,
    pub(in crate::views) from: Ray,
    pub(in crate::views) to: Ray,
}

impl Grip<'_> {
    /// The displacement of a point with the pointer, on its horizontal plane or vertically.
    fn shift(&self, p: DVec3, vertical: bool) -> DVec3 {
        /// Below this elevation a step of the pointer would throw a point on the ground too far.
        const EDGE_ON: f64 = 8.0;
        if vertical {
            // Seen from above, a vertical line has no length on the screen.
            return self.along(p, DVec3::Y).map_or(DVec3::ZERO, |t| DVec3::Y * t);
        }
        if self.observer.elevation.abs() < EDGE_ON {
            return self.in_picture(p);
        }
        let hit = |ray: Ray| on_horizontal(ray, p.y, self.observer);
        hit(self.to) - hit(self.from)
    }

    /// The displacement of a point with the pointer in the plane through it that's parallel to the picture.
    fn in_picture(&self, p: DVec3) -> DVec3 {
        let [_, _, back] = self.observer.axes();
        let hit = |ray: Ray| {
            let t = back.dot(p - ray.origin) / back.dot(ray.direction);
            ray.origin + ray.direction * t
        };
        let shift = hit(self.to) - hit(self.from);
        if shift.is_finite() { shift } else { DVec3::ZERO }
    }

    /// The displacement of the point of a line nearest to the pointer's ray; `None` if the line is seen end-on.
    pub(in crate::views) fn along(&self, origin: DVec3, direction: DVec3) -> Option<f64> {
        let (from, to) = self.places_along(origin, direction)?;
        Some(to - from)
    }

    /// The places on a line (from `origin`, in lengths of its unit `direction`) of the points nearest to the two rays;
    /// `None` if the line is seen end-on.
    pub(in crate::views) fn places_along(&self, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
        let nearest = |ray| nearest_on_line(origin, direction, ray);
        Some((nearest(self.from)?, nearest(self.to)?))
    }
}

/// The point where a ray meets the plane y = `height`. A ray at or over the horizon is bent down (or up) to it, so that
/// a point dragged there goes far, but not to infinity or behind the eye.
fn on_horizontal(ray: Ray, height: f64, observer: &Observer) -> DVec3 {
    const LEAST_SLOPE: f64 = 0.03;
    let side = observer.elevation.signum();
    let slope = (-side * ray.direction.y).max(LEAST_SLOPE);
    let t = side * (ray.origin.y - height) / slope;
    let p = ray.origin + ray.direction * t;
    DVec3::new(p.x, height, p.z)
}

/// The parameter on a line (unit direction) of the point nearest to a ray; `None` for lines within about 1° of
/// parallel.
fn nearest_on_line(origin: DVec3, direction: DVec3, ray: Ray) -> Option<f64> {
    let (d, r) = (direction, ray.direction);
    let cos = d.dot(r);
    let sin2 = d.cross(r).length_squared();
    let w = ray.origin - origin;
    (sin2 > 3e-4).then(|| (d.dot(w) - cos * r.dot(w)) / sin2)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::Camera;
    use crate::figure::Figure;
    use crate::views::{SharedScene, Size, View, unlabelled};

    const FRONT: Observer =
        Observer { target: DVec3::ZERO, distance: 40.0, azimuth: 0.0, elevation: 0.0, roll: 0.0, parallel: true };
    const CORNER: Observer =
        Observer { target: DVec3::ZERO, distance: 40.0, azimuth: 100.0, elevation: 30.0, roll: 0.0, parallel: false };

    /// Calls `test` with the picture of a camera that has F = 2 and B = 9, and the pixels of an observer.
    fn with_picture(observer: Observer, test: impl Fn(&Request, &Screen)) {
        let parameters =
            Parameters { near: 2.0, far: 9.0, view_up: DVec3::new(0.0, 2.0, 0.0), ..Parameters::default() };
        let (figure, camera) = (Figure::default(), Camera::new(&parameters).unwrap());
        let (scene, size) = (SharedScene::default(), Size { width: 600, height: 400, scale: 1.0 });
        let request = Request::of(&figure, View::World, &camera, &scene, unlabelled(), size);
        let request = request.seen_by(Some(observer));
        test(&request, &world_framing::screen(&request).unwrap());
    }

    #[test]
    fn every_handle_is_found_where_it_is() {
        with_picture(CORNER, |request, _| {
            let all = handles(request);
            assert_eq!(all.len(), 5);
            for (handle, place) in all {
                assert_eq!(handle_at(request, place + DVec2::new(1.0, -2.0), 8.0), Some(handle));
            }
            assert_eq!(handle_at(request, DVec2::new(1.0, 1.0), 8.0), None);
        });
    }

    #[test]
    fn positions_move_on_their_own_height_under_the_pointer() {
        for observer in [CORNER, Observer { parallel: true, ..CORNER }, Observer { elevation: -20.0, ..CORNER }] {
            with_picture(observer, |request, screen| {
                let c = request.camera.position();
                let goal = c + DVec3::new(-1.5, 0.0, 2.5);
                let (from, to) = (screen.place(c).unwrap(), screen.place(goal).unwrap());
                let moved = drag(request, Handle::Position, from, to, false);
                assert!((moved.position - goal).length() < 1e-9, "{observer:?}: {}", moved.position);
                assert_eq!(moved.focal_point, request.camera.focal_point());
                let moved = drag(request, Handle::FocalPoint, from, to, false);
                assert_eq!(moved.position, c);
                assert!(moved.focal_point.y.abs() < 1e-9);
            });
        }
    }

    #[test]
    fn with_the_modifier_they_move_vertically() {
        with_picture(CORNER, |request, screen| {
            let c = request.camera.position();
            let goal = c + DVec3::Y * 1.25;
            let (from, to) = (screen.place(c).unwrap(), screen.place(goal).unwrap());
            let moved = drag(request, Handle::Position, from, to, true);
            assert!((moved.position - goal).length() < 1e-9);
        });
    }

    #[test]
    fn seen_along_the_ground_handles_move_in_the_picture() {
        with_picture(FRONT, |request, screen| {
            let c = request.camera.position();
            let goal = c + DVec3::new(1.0, 2.0, 0.0);
            let (from, to) = (screen.place(c).unwrap(), screen.place(goal).unwrap());
            let moved = drag(request, Handle::Position, from, to, false);
            assert!((moved.position - goal).length() < 1e-9, "{}", moved.position);
        });
    }

    #[test]
    fn a_point_dragged_into_the_sky_stays_before_the_eye() {
        with_picture(CORNER, |request, screen| {
            let from = screen.place(request.camera.focal_point()).unwrap();
            let [_, _, back] = CORNER.axes();
            let depth = |y: f64| {
                let moved = drag(request, Handle::FocalPoint, from, DVec2::new(from.x, y), false);
                assert!(moved.focal_point.is_finite());
                -back.dot(moved.focal_point)
            };
            let (near, far, sky) = (depth(150.0), depth(50.0), depth(-4000.0));
            assert!(0.0 < near && near < far && far < sky && sky < 1e4, "{near} {far} {sky}");
        });
    }

    #[test]
    fn clipping_planes_follow_the_pointer_along_the_axis_and_stop_at_each_other() {
        with_picture(CORNER, |request, screen| {
            let on_axis = |d: f64| {
                screen.place(request.camera.position() + request.camera.direction_of_projection() * d).unwrap()
            };
            let dragged = |handle, from, to| drag(request, handle, on_axis(from), on_axis(to), false);
            assert!((dragged(Handle::Near, 2.0, 2.7).near - 2.7).abs() < 1e-9);
            assert!((dragged(Handle::Far, 9.0, 6.5).far - 6.5).abs() < 1e-9);
            let (near, far) = (dragged(Handle::Near, 2.0, 12.0), dragged(Handle::Far, 9.0, 0.5));
            assert!(near.near < near.far && near.near > 8.0);
            assert!(far.near < far.far && far.far < 3.0);
            let behind = dragged(Handle::Near, 2.0, -3.0);
            assert!(behind.near > 0.0 && behind.near < 0.1);
            assert!([near, far, behind].iter().all(|p| Camera::new(p).is_ok()));
        });
    }

    #[test]
    fn the_tip_of_vup_follows_the_pointer_and_vup_keeps_its_length() {
        with_picture(CORNER, |request, screen| {
            let c = request.camera.position();
            let tip = GizmoSizes::new(screen, &request.camera, &request.shot.look.world).view_up_tip(&request.camera);
            let [right, ..] = CORNER.axes();
            let goal = tip + right * 0.8;
            let moved = drag(request, Handle::ViewUp, screen.place(tip).unwrap(), screen.place(goal).unwrap(), false);
            assert!((moved.view_up.length() - 2.0).abs() < 1e-12);
            assert!((moved.view_up.normalize() - (goal - c).normalize()).length() < 1e-9);
        });
    }

    #[test]
    fn an_axis_seen_end_on_has_no_handles_and_cannot_be_dragged() {
        // The observer looks along DOP of the default camera: (3, 4, 5) to the origin.
        let azimuth = 3.0_f64.atan2(5.0).to_degrees();
        let elevation = 4.0_f64.atan2(34.0_f64.sqrt()).to_degrees();
        let behind = Observer { azimuth, elevation, parallel: true, ..CORNER };
        with_picture(behind, |request, _| {
            assert!(handles(request).iter().all(|(h, _)| !matches!(h, Handle::Near | Handle::Far)));
            let moved = drag(request, Handle::Near, DVec2::new(300.0, 200.0), DVec2::new(350.0, 100.0), false);
            assert_eq!(moved, *request.camera.parameters());
        });
    }

    #[test]
    fn the_far_plane_of_a_broken_volume_is_dragged_in_proportion() {
        with_picture(CORNER, |request, screen| {
            let camera = Camera::new(&Parameters { far: 900.0, ..*request.camera.parameters() }).unwrap();
            let request = Request { camera: camera.clone(), ..request.clone() };
            let place = handles(&request).into_iter().find(|(handle, _)| *handle == Handle::Far).unwrap().1;
            let on_axis = |d: f64| screen.place(camera.position() + camera.direction_of_projection() * d).unwrap();
            let end = Content::of(&request).volume.end;
            assert!(end < 30.0 && place.distance(on_axis(end)) < 1e-9, "{end}");
            let moved = drag(&request, Handle::Far, place, on_axis(0.5 * end), false);
            assert!((moved.far - 450.0).abs() < 1e-6, "{}", moved.far);
            let stopped = drag(&request, Handle::Far, place, on_axis(-end), false);
            assert!(Camera::new(&stopped).is_ok());
        });
    }

    #[test]
    fn a_window_drawn_nearer_is_dragged_in_proportion() {
        with_picture(CORNER, |request, screen| {
            let camera = Camera::new(&Parameters { near: 5e3, far: 6e3, ..*request.camera.parameters() }).unwrap();
            let request = Request { camera: camera.clone(), ..request.clone() };
            let place = |wanted| handles(&request).into_iter().find(|(handle, _)| *handle == wanted).unwrap().1;
            let on_axis = |d: f64| screen.place(camera.position() + camera.direction_of_projection() * d).unwrap();
            let volume = Content::of(&request).volume;
            assert!(volume.start < 20.0 && place(Handle::Near).distance(on_axis(volume.start)) < 1e-9);
            assert!(volume.end < 30.0 && place(Handle::Far).distance(on_axis(volume.end)) < 1e-9);
            let moved = drag(&request, Handle::Near, place(Handle::Near), on_axis(0.5 * volume.start), false);
            assert!((moved.near - 2500.0).abs() < 1e-6, "{}", moved.near);
            let moved = drag(&request, Handle::Far, place(Handle::Far), on_axis(0.9 * volume.end), false);
            assert!((moved.far - 5400.0).abs() < 1e-6, "{}", moved.far);
        });
    }

    #[test]
    fn a_small_f_keeps_its_handle_clear_of_the_camera() {
        with_picture(CORNER, |request, screen| {
            let camera = Camera::new(&Parameters { near: 1e-6, ..*request.camera.parameters() }).unwrap();
            let request = Request { camera: camera.clone(), ..request.clone() };
            let places = handles(&request);
            let place = |h| places.iter().find(|(handle, _)| *handle == h).unwrap().1;
            let apart = place(Handle::Near).distance(place(Handle::Position));
            assert!((15.0..25.0).contains(&apart), "{apart} px");
            // It still moves by the pointer's motion along the axis.
            let step = camera.direction_of_projection() * 0.5;
            let to = screen.place(camera.position() + step).unwrap();
            let from = screen.place(camera.position()).unwrap();
            assert!((drag(&request, Handle::Near, from, to, false).near - 0.5).abs() < 1e-5);
        });
    }
}
