//! Vanishing points of the scene's three directions, with their construction, `[4]`, ideal points under a projective
//! map.
//!
//! The lines of a direction **d** meet in the image of its ideal point, M (d, 0). If w ≠ 0, that's the point in which
//! the parallel to **d** through C meets the view plane. In parallel projection w = 0, so ideal points stay ideal, and
//! parallels stay parallel.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba};
use crate::camera::{Camera, Projection};
use crate::drawing::{Drawing, Label, Mark, StrokeSet, single};
use crate::geometry::Aabb;

use crate::views::words::label_obstacles::Box2;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE, stroke};
use crate::views::{Palette, PixelRect, Request, Size};

/// The directions, and the names of their vanishing points.
const DIRECTIONS: [(DVec3, &str); 3] = [(DVec3::X, "V_x"), (DVec3::Y, "V_y"), (DVec3::Z, "V_z")];

/// (x_p, y_p) of the vanishing point of a direction, `[0]` (5.9), (5.10) of its ideal point; `None` if that's ideal
/// itself. This happens in parallel projection, and for directions parallel to the view plane up to rounding.
pub(in crate::views) fn vanishing_point(camera: &Camera, direction: DVec3) -> Option<DVec2> {
    let basis = camera.basis();
    let along = direction.dot(basis.n);
    let perspective = camera.projection() == Projection::Perspective;
    (perspective && along.abs() > 1e-12 * direction.length())
        .then(|| DVec2::new(direction.dot(basis.u), direction.dot(basis.v)) * (-camera.near() / along))
        .filter(|p| p.is_finite())
}

/// True if the vanishing points of a photograph are drawn, also those outside it.
fn surround_photograph(request: &Request) -> bool {
    let look = &request.shot.look;
    let has_photograph = request.scene.photograph.is_some() && look.photograph_opacity > 0.0;
    look.reveal.vanishing && has_photograph && request.projector.is_none() && !request.finish.bare
}

/// The share of `most`, its greatest size, at which the image leaves room for the vanishing points of its photograph in
/// a picture of a size.
pub(super) fn share_beside(request: &Request, most: PixelRect, size: Size) -> f64 {
    /// Farthest vanishing point to include, in halves of the image from its middle.
    const FARTHEST: f64 = 3.0;
    /// Space up to it and beyond, for its name.
    const ROOM: f64 = 1.15;
    if !surround_photograph(request) {
        return 1.0;
    }
    let window = request.camera.window();
    let [low, high] = [DVec2::new(window.left, window.bottom), DVec2::new(window.right, window.top)];
    let points = DIRECTIONS.iter().filter_map(|(direction, _)| vanishing_point(&request.camera, *direction));
    let away = points.map(|point| (2.0 * point - low - high).abs() / (high - low));
    let near = away.filter(|away| away.max_element() < FARTHEST);
    let [whole, most] =
        [[size.width, size.height], [most.width, most.height]].map(|[w, h]| DVec2::new(w.into(), h.into()));
    near.map(|away| (whole / (ROOM * away * most)).min_element()).fold(1.0, f64::min)
}

/// Draws the parallels through C in the world, each up to the view plane, if the figure shows vanishing points.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    /// Farthest vanishing point to include, in windows from the middle of the window. A farther one would pull the eye
    /// away from the scene.
    const FARTHEST: f64 = 2.5;
    if !request.shot.look.reveal.vanishing {
        return;
    }
    let camera = &request.camera;
    let size = camera.window_width().max(camera.window_height());
    for ((direction, name), color) in DIRECTIONS.into_iter().zip(palette.axes) {
        let Some(point) = vanishing_point(camera, direction) else { continue };
        if point.length() > FARTHEST * size {
            continue;
        }
        let basis = camera.basis();
        let place = camera.position() + basis.u * point.x + basis.v * point.y - basis.n * camera.near();
        builder.line(vec![camera.position(), place], color, 1.2, Dash::Dashed);
        builder.mark(place, MarkShape::Diamond, 4.0, color);
        builder.text(place, name, DVec2::new(0.8, -0.8), SMALL_TYPE, color);
    }
}

/// Draws the edges of the box around the scene in the image, extended to their intersection, and the horizon.
pub(in crate::views) fn in_image(drawing: &mut Drawing, request: &Request, palette: Palette) -> Vec<LegendRow> {
    let camera = &request.camera;
    let labels = request.labels;
    if camera.projection() == Projection::Parallel {
        return vec![LegendRow::Title(LegendText::new("vanishing", labels.no_vanishing), palette.ink)];
    }
    let mut picture = WindowPicture::of(drawing, camera);
    if surround_photograph(request) {
        // All of the picture, in whose middle the image is.
        picture.room.half = DVec2::new(f64::from(request.size.width), f64::from(request.size.height)) / 2.0;
    }
    let scale = request.size.scale;
    let mut rows = Vec::new();
    horizon(drawing, &picture, request, palette);
    for ((direction, name), color) in DIRECTIONS.into_iter().zip(palette.axes) {
        let Some(point) = vanishing_point(camera, direction) else {
            rows.push(LegendRow::Swatch(color, LegendText::new(name, format!("{name}: {}", labels.ideal))));
            continue;
        };
        let vanishing = picture.place(point);
        if let Some(bounds) = request.scene.bounds() {
            for end in nearest_ends(camera, bounds, direction) {
                picture.line(
                    drawing,
                    [picture.place(end), vanishing],
                    stroke(color, 0.9 * scale, Dash::Dashed, HiddenLines::Shown),
                );
            }
        }
        if picture.holds(vanishing) {
            let position = [single(vanishing.x), single(vanishing.y), 1.0];
            drawing.marks.push(Mark::new(position, MarkShape::Diamond, 4.0 * scale, [color, palette.paper]));
            drawing.labels.push(label(vanishing, name, SMALL_TYPE * scale, color, palette));
        } else {
            let text = format!("{name}: {}", labels.beyond_image);
            rows.push(LegendRow::Swatch(color, LegendText::new(name, text)));
        }
    }
    rows
}

/// The line of all vanishing points of horizontal directions: (x_p **u** + y_p **v** − F **n**) · y = 0.
fn horizon(drawing: &mut Drawing, picture: &WindowPicture<'_>, request: &Request, palette: Palette) {
    let basis = request.camera.basis();
    let (a, b, c) = (basis.u.y, basis.v.y, -request.camera.near() * basis.n.y);
    let across = DVec2::new(a, b);
    // When the camera looks straight up or down, no horizontal direction has a vanishing point in reach.
    if across.length() < 1e-9 {
        return;
    }
    let foot = across * (-c / across.length_squared());
    let along = across.perp().normalize();
    let reach = 4.0 * (request.camera.window_width() + request.camera.window_height()) + foot.length();
    let ends = [picture.place(foot - along * reach), picture.place(foot + along * reach)];
    let style = stroke(palette.soft, request.size.scale, Dash::Solid, HiddenLines::Shown);
    if let Some([from, to]) = picture.line(drawing, ends, style) {
        let left = if from.x < to.x { from } else { to };
        let size = SMALL_TYPE * request.size.scale;
        let at = left + (from.max(to) - left) * 0.04 - DVec2::Y * (0.9 * f64::from(size));
        let name = "horizon".to_owned();
        drawing.labels.push(Label { name, ..label(at, request.labels.horizon, size, palette.soft, palette) });
    }
}

/// Draws the epipolar line of a pixel that is marked in the image of another camera: the image of its projector, across
/// the whole image, since any of its points may be the one that the pixel shows. All of them meet in the epipole, the
/// image of the other centre.
pub(super) fn epipolar_line(drawing: &mut Drawing, request: &Request, palette: Palette) {
    let Some(projector) = request.projector.flatten() else { return };
    let (camera, scale, labels) = (&request.camera, request.size.scale, request.labels);
    // (5.9) and (5.10), homogeneous.
    let [origin, end] = projector.ends.map(|p| camera.view_point(p));
    let seen = |v: DVec3, w: f64| match camera.projection() {
        Projection::Perspective => (v.truncate() * camera.near()).extend(-v.z),
        Projection::Parallel => v.truncate().extend(w),
    };
    let (from, direction) = (seen(origin, 1.0), seen(end - origin, 0.0));
    let DVec3 { x: a, y: b, z: c } = from.cross(direction);
    let across = DVec2::new(a, b);
    let picture = WindowPicture::of(drawing, camera);
    let foot = across * (-c / across.length_squared());
    let reach = 4.0 * (camera.window_width() + camera.window_height()) + foot.length();
    let along = across.perp().normalize_or_zero() * reach;
    let size = SMALL_TYPE * scale;
    let ends = [foot - along, foot + along].map(|end| picture.place(end));
    if let Some([from, to]) =
        picture.line(drawing, ends, stroke(palette.probe, 1.6 * scale, Dash::Solid, HiddenLines::Shown))
    {
        let name = "epipolar".to_owned();
        drawing.labels.push(Label { name, ..label(from.lerp(to, 0.1), labels.epipolar, size, palette.probe, palette) });
    }
    let epipole = if projector.projection == Projection::Perspective { from } else { direction };
    let epipole = picture.place(epipole.truncate() / epipole.z);
    if epipole.is_finite() && picture.holds(epipole) {
        let position = [single(epipole.x), single(epipole.y), 1.0];
        drawing.marks.push(Mark::new(position, MarkShape::Diamond, 4.0 * scale, [palette.probe, palette.paper]));
        let name = "epipole".to_owned();
        drawing.labels.push(Label { name, ..label(epipole, labels.epipole, size, palette.probe, palette) });
    }
}

/// For each edge of a box along a direction, the window point of the end from which it runs to the vanishing point.
/// It's the end nearer to the eye, in front of it.
fn nearest_ends(camera: &Camera, bounds: Aabb, direction: DVec3) -> Vec<DVec2> {
    let view = |p: DVec3| camera.view_point(p);
    let corners = bounds.corners();
    let low = corners.into_iter().filter(|p| (*p - bounds.min).dot(direction).abs() < 1e-12 * (1.0 + p.length()));
    let extent = direction * (bounds.max - bounds.min).dot(direction);
    let ends = low.filter_map(|p| {
        let ends = [view(p), view(p + extent)];
        let front = |c: &DVec3| -c.z > 1e-6 * camera.near();
        let nearer = ends.into_iter().filter(front).max_by(|a, b| a.z.total_cmp(&b.z))?;
        Some(nearer.truncate() * (camera.near() / -nearer.z))
    });
    ends.filter(|p| p.is_finite()).collect()
}

/// A picture of the view window.
struct WindowPicture<'a> {
    size: DVec2,
    /// The part of the plane that's drawn: the window, or more.
    room: Box2,
    camera: &'a Camera,
}

impl<'a> WindowPicture<'a> {
    fn of(drawing: &Drawing, camera: &'a Camera) -> Self {
        let size = DVec2::new(f64::from(drawing.width), f64::from(drawing.height));
        Self { size, room: Box2 { center: size / 2.0, half: size / 2.0 }, camera }
    }

    /// The place in pixels of a window point, also far outside.
    fn place(&self, point: DVec2) -> DVec2 {
        let w = self.camera.window();
        self.size * DVec2::new((point.x - w.left) / w.width(), (w.top - point.y) / w.height())
    }

    fn holds(&self, px: DVec2) -> bool {
        (px - self.room.center).abs().cmple(self.room.half).all()
    }

    /// Draws the part of a line in the picture. It computes in `f64`, because a vanishing point may be a billion pixels
    /// away.
    fn line(&self, drawing: &mut Drawing, [a, b]: [DVec2; 2], style: LineStyle) -> Option<[DVec2; 2]> {
        let ends = self.room.part_inside(a, b)?.map(|share| a.lerp(b, share));
        if !ends.iter().all(|p| p.is_finite()) {
            return None;
        }
        drawing.strokes.push(StrokeSet::line(ends.map(|p| [single(p.x), single(p.y), 1.0]).to_vec(), style));
        Some(ends)
    }
}

fn label(at: DVec2, text: &str, size: f32, color: Rgba, palette: Palette) -> Label {
    Label {
        name: text.to_owned(),
        offset: [0.6 * size, -0.6 * size],
        ..Label::new([single(at.x), single(at.y), 1.0], text, size, [color, palette.paper])
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{ImageSize, Parameters, Viewport};

    /// Points of a line, farther and farther away, approach the vanishing point.
    #[test]
    fn lines_run_to_the_vanishing_point_of_their_direction() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let image = ImageSize::default();
        for (direction, _) in DIRECTIONS {
            let vanishing = vanishing_point(&camera, direction).unwrap();
            // Towards the front.
            let ahead = if direction.dot(camera.basis().n) < 0.0 { direction } else { -direction };
            for start in [DVec3::ZERO, DVec3::new(1.0, -2.0, 0.5)] {
                let far = camera.stations(start + ahead * 1e9, image, &Viewport::whole(image)).projected.unwrap();
                assert!(far.window.distance(vanishing) < 1e-8, "{} is not {vanishing}", far.window);
            }
        }
        let parallel = Camera::new(&Parameters { projection: Projection::Parallel, ..Parameters::default() }).unwrap();
        assert_eq!(vanishing_point(&parallel, DVec3::X), None);
        let ahead = Parameters { position: DVec3::new(0.0, 0.0, 5.0), ..Parameters::default() };
        let ahead = Camera::new(&ahead).unwrap();
        assert_eq!(vanishing_point(&ahead, DVec3::X), None, "parallel to the view plane: one-point perspective");
        assert_eq!(vanishing_point(&ahead, DVec3::Z), Some(DVec2::ZERO));
    }
}
