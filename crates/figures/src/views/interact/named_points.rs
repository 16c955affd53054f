//! The figure's points under the pointer: the one at a place, and its new place after a drag.

use glam::{DVec2, DVec3};

use super::pick;
use crate::camera::Projection;
use crate::views::world::world_framing;
use crate::views::{Request, View, image};

/// The figure's point whose mark is within `reach` of a place (pixels) of the world or of the image, by its place in
/// the list.
pub fn point_at(request: &Request, pointer: DVec2, reach: f64) -> Option<usize> {
    if request.view == View::Canonical {
        return None;
    }
    let place = pick::places(request)?;
    let distances = request.shot.points.iter().enumerate().filter_map(|(i, point)| {
        let distance = place(point.position)?.distance(pointer);
        (distance <= reach).then_some((i, distance))
    });
    distances.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
}

/// The new place of a point of the world dragged from one place to another (pixels). It moves in the plane through it
/// that's parallel to the view window, so its distance from the eye stays. If the world shows this plane edge-on, it
/// moves in the plane of the picture. `None` if there's no such point.
pub fn dragged(request: &Request, p: DVec3, from: DVec2, to: DVec2) -> Option<DVec3> {
    /// The sine of the angle below which a plane counts as seen edge-on.
    const EDGE: f64 = 0.2;
    let camera = &request.camera;
    let basis = camera.basis();
    let moved = match request.view {
        View::Canonical => return None,
        View::Image => {
            let screen = image::screen(request);
            let by = screen.window_point(to) - screen.window_point(from);
            let share = match camera.projection() {
                Projection::Perspective => -camera.view_point(p).z / camera.near(),
                Projection::Parallel => 1.0,
            };
            p + (basis.u * by.x + basis.v * by.y) * share
        }
        View::World => {
            let screen = world_framing::screen(request)?;
            if screen.camera().basis().n.dot(basis.n).abs() < EDGE {
                screen.moved(p, to - from)
            } else {
                let meets = |px| {
                    let ray = screen.ray(px);
                    let along = (p - ray.origin).dot(basis.n) / ray.direction.dot(basis.n);
                    (along > 0.0).then(|| ray.origin + ray.direction * along)
                };
                p + (meets(to)? - meets(from)?)
            }
        }
    };
    moved.is_finite().then_some(moved)
}
