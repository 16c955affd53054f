//! The other cameras of a figure under the pointer.

use glam::DVec2;

use crate::views::world::camera_gizmo::GizmoSizes;
use crate::views::world::world_framing;
use crate::views::{OtherCamera, Request};

/// The camera of the list whose body is at `pointer` (pixels), or within `reach` pixels of it.
pub fn camera_at(request: &Request, pointer: DVec2, reach: f64) -> Option<usize> {
    /// Half the height of a body, and its position along **n**, in its units.
    const HALF: f64 = 0.5;
    const ALONG: [f64; 4] = [0.0, 0.6, 1.2, 1.8];
    if request.shot.cameras.is_empty() || request.shot.look.world.section {
        return None;
    }
    let screen = world_framing::screen(request)?;
    let distance = |other: &OtherCamera| {
        let camera = &other.camera;
        let body = GizmoSizes::new(&screen, camera, &request.shot.look.world).body;
        let places = ALONG.map(|along| screen.place_inside(camera.position() + camera.basis().n * (along * body)));
        let nearest = places.into_iter().flatten().map(|place| place.distance(pointer)).min_by(f64::total_cmp)?;
        let radius = HALF * body / screen.units_per_pixel(camera.position());
        (nearest <= reach.max(radius)).then_some(nearest)
    };
    let within = request.shot.cameras.iter().enumerate().filter_map(|(i, other)| Some((i, distance(other)?)));
    within.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
}
