//! What the probe adds to each picture: the same point, or the same ray, three times.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, MarkShape};
use crate::camera::Projection;
use crate::geometry::Aabb;
use crate::pipeline::project::displayed_ndc;

use super::canonical_box::CanonicalBox;
use super::gizmos::{SMALL_TYPE, SceneBuilder, TYPE};
use super::volume::DrawnVolume;
use super::{Palette, Probe, Request, hits};

/// The ray of the probe from its origin O_R through its window point to the end of the volume, `[0]` Eqs. (5.17) to (5.21).
pub(super) struct Pixel {
    origin: DVec3,
    /// The point on the window.
    pub(super) window: DVec3,
    end: DVec3,
    /// The first point of the scene on it.
    pub(super) hit: Option<DVec3>,
}

impl Pixel {
    pub(super) fn new(request: &Request, point: DVec2) -> Self {
        let camera = &request.camera;
        let ray = camera.ray_through_window(point);
        // Depths along −n are what F and B measure.
        let per_depth = ray.direction / ray.direction.dot(camera.direction_of_projection());
        let (window, end) = (ray.origin + per_depth * camera.near(), ray.origin + per_depth * camera.far());
        Self { origin: ray.origin, window, end, hit: hits::first_hit(&request.scene, window, end) }
    }
}

/// The ray from O_R through the window, or the point with its projector.
pub(super) fn in_world(builder: &mut SceneBuilder, request: &Request, palette: Palette, volume: &DrawnVolume) {
    let color = palette.probe;
    match request.overlays.probe {
        None => {}
        Some(Probe::Point(p)) => {
            let camera = &request.camera;
            let c = camera.view_point(p);
            if c.z < 0.0 {
                let w = window_of(request, c);
                let pixel = Pixel::new(request, w);
                builder.line(vec![pixel.origin, p], color, 1.4, Dash::Solid);
                builder.mark(pixel.window, MarkShape::Square, 3.0, color);
            }
            builder.mark(p, MarkShape::Ring, 6.0, color);
            builder.text(p, "P", DVec2::new(0.8, -0.8), TYPE, color);
        }
        Some(Probe::Window(point)) => {
            let pixel = Pixel::new(request, point);
            let share =
                |distance: f64| (distance - request.camera.near()) / (request.camera.far() - request.camera.near());
            let end = pixel.window.lerp(pixel.end, share(volume.end));
            let window = pixel.window.lerp(pixel.end, share(volume.start));
            builder.line(vec![pixel.origin, pixel.hit.unwrap_or(end)], color, 1.6, Dash::Solid);
            if let Some(hit) = pixel.hit {
                builder.line(vec![hit, end], color, 1.2, Dash::Dotted);
                builder.mark(hit, MarkShape::Ring, 6.0, color);
                builder.text(hit, "P", DVec2::new(0.8, -0.8), TYPE, color);
            }
            builder.mark(window, MarkShape::Square, 3.0, color);
            if request.camera.projection() == Projection::Parallel {
                builder.mark(pixel.origin, MarkShape::Disc, 3.0, color);
                builder.text(pixel.origin, "O_R", DVec2::new(-0.7, 0.7), SMALL_TYPE, color);
            }
        }
    }
}

/// Projectors are parallel to z_n in the canonical volume, whatever the projection.
pub(super) fn in_canonical(builder: &mut SceneBuilder, request: &Request, palette: Palette) {
    let Some(probe) = request.overlays.probe else { return };
    let color = palette.probe;
    let canonical = CanonicalBox::of(request);
    let shown = |p: DVec3| displayed_ndc(&request.camera, p).map(|p| canonical.place(p));
    let Aabb { min, max } = canonical.bounds();
    let (through, marked) = match probe {
        Probe::Point(p) => (shown(p), shown(p)),
        Probe::Window(point) => {
            let pixel = Pixel::new(request, point);
            (shown(pixel.window), pixel.hit.and_then(shown))
        }
    };
    let Some(through) = through else { return };
    let (front, back) = (through.with_z(max.z), through.with_z(min.z));
    if through.x.abs() <= 1.0 && through.y.abs() <= 1.0 {
        let stop = marked.map_or(back, |p| p.with_z(p.z.clamp(min.z, max.z)));
        builder.line(vec![front, stop], color, 1.6, Dash::Solid);
        builder.line(vec![stop, back], color, 1.2, Dash::Dotted);
        builder.mark(front, MarkShape::Square, 3.0, color);
    }
    if let Some(p) = marked {
        builder.mark(p, MarkShape::Ring, 6.0, color);
        builder.text(p, "P", DVec2::new(0.8, -0.8), TYPE, color);
    }
}

/// A cross at the pixel, or a ring around the point.
pub(super) fn in_image(builder: &mut SceneBuilder, request: &Request, palette: Palette) {
    let (point, shape) = match request.overlays.probe {
        None => return,
        Some(Probe::Point(p)) => (p, MarkShape::Ring),
        Some(Probe::Window(point)) => (Pixel::new(request, point).window, MarkShape::Cross),
    };
    builder.mark(point, shape, 6.0, palette.probe);
}

/// (x_p, y_p) of a point in front of C (VRC), `[0]` Eqs. (5.9) and (5.10).
fn window_of(request: &Request, p_view: DVec3) -> DVec2 {
    match request.camera.projection() {
        Projection::Perspective => p_view.truncate() * (request.camera.near() / -p_view.z),
        Projection::Parallel => p_view.truncate(),
    }
}
