//! The probe and the figure's points in each picture: the same point, or the same ray, three times.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, MarkShape, Rgba};
use crate::camera::Projection;
use crate::figure::NamedPoint;
use crate::geometry::Aabb;
use crate::pipeline::canonical::displayed_ndc;
use crate::sanitize;

use crate::views::canonical::canonical_box::CanonicalBox;
use crate::views::interact::hits;
use crate::views::world::cameras;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE, TYPE};
use crate::views::world::volume::DrawnVolume;
use crate::views::{Palette, Probe, Projector, Request};

/// The ray of the probe from its origin O_R through its window point to the end of the volume, `[0]` Eqs. (5.17) to
/// (5.21).
pub(in crate::views) struct Pixel {
    origin: DVec3,
    /// The point on the window.
    pub(in crate::views) window: DVec3,
    end: DVec3,
    /// The first point of the scene on it.
    pub(in crate::views) hit: Option<DVec3>,
}

impl Pixel {
    pub(in crate::views) fn new(request: &Request, point: DVec2) -> Self {
        let (origin, window, end) = ray_of(request, point);
        Self { origin, window, end, hit: hits::first_hit(&request.scene, window, end) }
    }
}

/// The projector of a probe: from O_R through its pixel, or through its point.
pub(in crate::views) fn projector(request: &Request, probe: Probe) -> Projector {
    let (ends, point) = match probe {
        Probe::Window(point) => {
            let pixel = Pixel::new(request, point);
            ([pixel.origin, pixel.end], pixel.hit)
        }
        Probe::Point(p) => {
            let (origin, _, end) = ray_of(request, window_of(request, request.camera.view_point(p)));
            ([origin, end], Some(p))
        }
    };
    Projector { ends, projection: request.camera.projection(), point }
}

/// The look of a point: a probe, or one of the figure's.
#[derive(Clone, Copy)]
pub(in crate::views) struct Look<'a> {
    pub(in crate::views) name: &'a str,
    mark: (MarkShape, f32),
    ray: f32,
    pub(in crate::views) color: Rgba,
}

impl<'a> Look<'a> {
    /// The look of the probe.
    fn probe(palette: Palette) -> Self {
        Self { name: "P", mark: (MarkShape::Ring, 6.0), ray: 1.4, color: palette.probe }
    }

    fn named(point: &'a NamedPoint, palette: Palette) -> Self {
        Self { name: &point.name, mark: (MarkShape::Disc, 3.6), ray: 1.1, color: palette.probe }
    }

    /// The mark, and the name beside it.
    fn mark(self, builder: &mut AnnotationBuilder, p: DVec3) {
        builder.mark(p, self.mark.0, self.mark.1, self.color);
        if !self.name.is_empty() {
            builder.text(p, &sanitize::escaped(self.name), DVec2::new(0.8, -0.8), TYPE, self.color);
        }
    }
}

/// The point of the probe, and those of the figure. If the probe is at one of them, only this has a name.
pub(in crate::views) fn points<'a>(request: &'a Request, palette: Palette) -> impl Iterator<Item = (DVec3, Look<'a>)> {
    let named = request.shot.points.iter().map(move |point| (point.position, Look::named(point, palette)));
    let probed = match request.probe() {
        Some(Probe::Point(p)) => {
            let name = if request.shot.points.iter().any(|point| point.position == p) { "" } else { "P" };
            Some((p, Look { name, ..Look::probe(palette) }))
        }
        Some(Probe::Window(_)) | None => None,
    };
    named.chain(probed)
}

/// A point with its projector from O_R, extended to the window if that lies behind the point. If the point is behind
/// the eye, the line back to it is dotted, since nothing of it reaches the window.
fn point_in_world(builder: &mut AnnotationBuilder, request: &Request, p: DVec3, look: Look<'_>) {
    let c = request.camera.view_point(p);
    let parallel = request.camera.projection() == Projection::Parallel;
    if c.is_finite() {
        if c.z < 0.0 || parallel {
            let (origin, window, _) = ray_of(request, window_of(request, c));
            if c.z < 0.0 {
                builder.line(vec![origin, p], look.color, look.ray, Dash::Solid);
            }
            if -c.z < request.camera.near() {
                builder.line(vec![p, window], look.color, 0.85 * look.ray, Dash::Dotted);
            }
            builder.mark(window, MarkShape::Square, 3.0, look.color);
        } else {
            builder.line(vec![request.camera.position(), p], look.color, 0.85 * look.ray, Dash::Dotted);
        }
    }
    look.mark(builder, p);
}

/// The rays of points, from O_R to each, or the ray from O_R through the window.
pub(in crate::views) fn in_world(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    volume: &DrawnVolume,
) {
    for (p, look) in points(request, palette) {
        cameras::projectors(builder, request, palette, p);
        point_in_world(builder, request, p, look);
    }
    let color = palette.probe;
    match request.probe() {
        None | Some(Probe::Point(_)) => {}
        Some(Probe::Window(point)) => {
            let pixel = Pixel::new(request, point);
            let share =
                |distance: f64| (distance - request.camera.near()) / (request.camera.far() - request.camera.near());
            let end = pixel.window.lerp(pixel.end, share(volume.end));
            let window = pixel.window.lerp(pixel.end, share(volume.start));
            builder.line(vec![pixel.origin, pixel.hit.unwrap_or(end)], color, 1.6, Dash::Solid);
            if let Some(hit) = pixel.hit {
                cameras::projectors(builder, request, palette, hit);
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

/// Projectors are parallel to z_n in the canonical volume, in both projections.
pub(in crate::views) fn in_canonical(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let canonical = CanonicalBox::of(request);
    let shown = |p: DVec3| displayed_ndc(&request.camera, p).map(|p| canonical.place(p));
    for (p, look) in points(request, palette) {
        if let Some(place) = shown(p) {
            ray_through_box(builder, &canonical, place, Some(place), look);
        }
    }
    if let Some(Probe::Window(point)) = request.probe() {
        let pixel = Pixel::new(request, point);
        if let Some(through) = shown(pixel.window) {
            let look = Look { ray: 1.6, ..Look::probe(palette) };
            ray_through_box(builder, &canonical, through, pixel.hit.and_then(shown), look);
        }
    }
}

/// The projector through a place, up to the mark on it, and dotted to the back of the box.
fn ray_through_box(
    builder: &mut AnnotationBuilder,
    canonical: &CanonicalBox,
    through: DVec3,
    marked: Option<DVec3>,
    look: Look<'_>,
) {
    let Aabb { min, max } = canonical.bounds();
    let (front, back) = (through.with_z(max.z), through.with_z(min.z));
    if through.x.abs() <= 1.0 && through.y.abs() <= 1.0 {
        let stop = marked.map_or(back, |p| p.with_z(p.z.clamp(min.z, max.z)));
        builder.line(vec![front, stop], look.color, look.ray, Dash::Solid);
        builder.line(vec![stop, back], look.color, 0.75 * look.ray, Dash::Dotted);
        builder.mark(front, MarkShape::Square, 3.0, look.color);
    }
    if let Some(p) = marked {
        look.mark(builder, p);
    }
}

/// The figure's points on the way from the world to the canonical volume, as far as they're visible with the volume.
pub(in crate::views) fn on_the_way(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    place: impl Fn(DVec3) -> Option<DVec3>,
) {
    for point in request.shot.points.iter() {
        if let Some(p) = place(point.position) {
            Look::named(point, palette).mark(builder, p);
        }
    }
}

/// A cross at the pixel, or a ring around the point, and the figure's points with their names.
pub(in crate::views) fn in_image(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    for (p, look) in points(request, palette) {
        // A ring around a corner of the scene hides nothing of it, and needs no name.
        let name = if look.mark.0 == MarkShape::Ring { "" } else { look.name };
        Look { name, ..look }.mark(builder, p);
    }
    if let Some(Probe::Window(point)) = request.probe() {
        // A hair behind the window, because rounding decides if a point in the front plane is clipped, and any point of
        // the ray has this pixel.
        let (origin, window, end) = ray_of(request, point);
        let behind = origin + (window - origin) * 1.001;
        let p = if behind.distance(origin) < end.distance(origin) { behind } else { window.midpoint(end) };
        builder.mark(p, MarkShape::Cross, 6.0, palette.probe);
    }
    if let Some(p) = request.projector.flatten().and_then(|projector| projector.point) {
        builder.mark(p, MarkShape::Ring, 6.0, palette.probe);
    }
}

/// The origin of a ray through a point of the window, its intersections with the window and with the back plane.
pub(in crate::views) fn ray_of(request: &Request, point: DVec2) -> (DVec3, DVec3, DVec3) {
    let camera = &request.camera;
    let ray = camera.ray_through_window(point);
    // F and B measure depths along −n.
    let per_depth = ray.direction / ray.direction.dot(camera.direction_of_projection());
    (ray.origin, ray.origin + per_depth * camera.near(), ray.origin + per_depth * camera.far())
}

/// (x_p, y_p) of a point in front of C (VRC), `[0]` Eqs. (5.9) and (5.10).
fn window_of(request: &Request, p_view: DVec3) -> DVec2 {
    match request.camera.projection() {
        Projection::Perspective => p_view.truncate() * (request.camera.near() / -p_view.z),
        Projection::Parallel => p_view.truncate(),
    }
}
