//! The section through C along **u**, as in the side figures of `[0]` 5.3: similar triangles, with their lengths.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, MarkShape, Role};
use crate::camera::{Camera, Projection};
use crate::figure::Observer;
use crate::geometry::Aabb;
use crate::inspect::quantity::{PointNumber, Quantity, WindowNumber};
use crate::sanitize;

use super::dimensions::{self, Pen, Span};
use super::framing;
use super::framing::Content;
use super::gizmos::{AnnotationBuilder, TYPE, symbol_of};
use super::volume::DrawnVolume;
use crate::figure::Measure;
use crate::views::observer::{Viewpoint, enclosing};
use crate::views::reveal::probe::Pixel;
use crate::views::{Palette, Probe, Request};

/// Number of vertices of a large scene that are searched for an example.
const MOST_VERTICES: usize = 20_000;

/// The content of the section, in the plane through C spanned by DOP and **v**.
struct Profile<'a> {
    camera: &'a Camera,
    volume: DrawnVolume,
    /// The point whose image is constructed, and its name.
    p: DVec3,
    name: String,
    /// The distance from one dimension line to the next.
    step: f64,
}

impl<'a> Profile<'a> {
    fn new(request: &'a Request, content: &Content) -> Self {
        let camera = &request.camera;
        let volume = content.volume.measured(camera);
        let around = Aabb::around(volume.all_corners().chain([camera.position()])).map_or(1.0, |b| b.radius());
        let (p, name) = example(request);
        Self { camera, volume, p, name, step: 0.13 * around }
    }

    /// The point of the plane at a distance from C along DOP, and a height along **v**.
    fn at(&self, distance: f64, height: f64) -> DVec3 {
        self.camera.position() + self.camera.direction_of_projection() * distance + self.camera.basis().v * height
    }

    /// Bottom and top of the volume at a distance.
    fn sides(&self, distance: f64) -> [DVec3; 2] {
        let window = self.camera.window();
        let scale = match self.camera.projection() {
            Projection::Perspective => distance / self.camera.near(),
            Projection::Parallel => 1.0,
        };
        [window.bottom, window.top].map(|y| self.at(distance, y * scale))
    }

    /// The lowest height in use. Lengths along DOP are measured below it.
    fn lowest(&self) -> f64 {
        let window = self.camera.window();
        let end = match self.camera.projection() {
            Projection::Perspective => self.volume.end / self.camera.near(),
            Projection::Parallel => 1.0,
        };
        (window.bottom * end).min(window.bottom).min(self.height()).min(0.0)
    }

    /// y_c of the point.
    fn height(&self) -> f64 {
        self.camera.view_point(self.p).y
    }

    /// −z_c of the point.
    fn distance(&self) -> f64 {
        -self.camera.view_point(self.p).z
    }

    /// y_p, `[0]` Eqs. (5.9) and (5.10).
    fn image(&self) -> f64 {
        match self.camera.projection() {
            Projection::Perspective => self.height() * self.camera.near() / self.distance(),
            Projection::Parallel => self.height(),
        }
    }

    /// All points that a picture should hold.
    fn points(&self) -> Vec<DVec3> {
        let below = self.lowest() - 3.6 * self.step;
        let mut points = vec![self.at(-0.8 * self.step, below), self.at(self.volume.end + self.step, below)];
        points.extend(self.sides(self.volume.end));
        points.extend(self.sides(self.camera.near()));
        points.extend([self.at(self.distance() + self.step, self.height()), self.at(-self.step, self.step)]);
        points
    }
}

/// The point of the hover. Without one, it's the first of the figure's points in front of C, or P if the scene names
/// one there; else the vertex inside the volume whose image is farthest from the axis, or PF. Also its name, which
/// distinguishes it from others.
fn example(request: &Request) -> (DVec3, String) {
    let camera = &request.camera;
    let labels = request.labels;
    let called = |kind: &str, p: DVec3| {
        let world = [Quantity::Point(0, PointNumber::World)];
        (p, format!("{kind} {}", request.written(&world, &p.to_array(), |mark| mark.tuple(&p.to_array(), 3))))
    };
    let in_front = |(p, _): &(DVec3, String)| -camera.view_point(*p).z > 0.0;
    let probed = match request.probe() {
        Some(Probe::Point(p)) => Some(called(labels.vertex, p)),
        Some(Probe::Window(point)) => Pixel::new(request, point).hit.map(|p| called(labels.point, p)),
        None => None,
    };
    // The depth of a point in the plane of the eye is zero except for rounding.
    let least = 1e-9 * camera.distance();
    let of_exercise = || {
        let text = request.scene.texts.iter().find(|text| text.text == "P")?;
        (-camera.view_point(text.position).z > least).then(|| (text.position, text.text.clone()))
    };
    let followed = || {
        let mut in_front = request.shot.points.iter().filter(|point| -camera.view_point(point.position).z > least);
        in_front.next().map(|point| (point.position, sanitize::escaped(&point.name)))
    };
    let image = |p: DVec3| {
        let clip = camera.clip_point(p);
        let ndc = clip.truncate() / clip.w;
        (clip.w > 0.0 && ndc.abs().max_element() <= 1.0).then_some(ndc.y.abs())
    };
    let vertices = || request.scene.vertices().take(MOST_VERTICES).map(|v| v.p_world);
    let farthest =
        || vertices().filter_map(|p| Some((p, image(p)?))).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(p, _)| p);
    probed
        .filter(in_front)
        .or_else(followed)
        .or_else(of_exercise)
        .or_else(|| farthest().map(|p| called(labels.vertex, p)))
        .unwrap_or_else(|| (camera.focal_point(), String::new()))
}

/// The observer of the section: along **u**, with everything in the picture.
pub(in crate::views) fn observer(request: &Request) -> Observer {
    let content = Content::of(request);
    let iso = framing::iso_direction(&request.camera);
    let direction = Viewpoint::AlongU.direction(iso, request.camera.basis());
    enclosing(&Profile::new(request, &content).points(), direction, request.size)
}

/// Adds the section: the volume's profile, the construction of a point's image, and the lengths.
pub(in crate::views) fn draw(builder: &mut AnnotationBuilder, request: &Request, palette: Palette, content: &Content) {
    let profile = Profile::new(request, content);
    outline(builder, request, palette, &profile);
    construction(builder, palette, &profile);
    lengths(builder, request, palette, &profile);
}

fn outline(builder: &mut AnnotationBuilder, request: &Request, palette: Palette, profile: &Profile) {
    let (camera, volume) = (profile.camera, &profile.volume);
    for [from, to] in volume.parts() {
        let ([a, b], [c, d]) = (profile.sides(from), profile.sides(to));
        builder.sheer("volume", &[[a, c, d, b]], palette.volume);
        builder.line(vec![a, c], palette.volume_edge, 1.3, Dash::Solid);
        builder.line(vec![b, d], palette.volume_edge, 1.3, Dash::Solid);
    }
    if let Some([from, to]) = volume.gap {
        for (from, to) in profile.sides(from).into_iter().zip(profile.sides(to)) {
            builder.breaks(from, to, palette.volume_edge);
        }
    }
    if camera.projection() == Projection::Perspective {
        for side in profile.sides(camera.near()) {
            builder.line(vec![camera.position(), side], palette.volume_edge, 1.0, Dash::Dotted);
        }
    }
    builder.line(profile.sides(camera.near()).to_vec(), palette.ink, 2.4, Dash::Solid);
    builder.line(profile.sides(volume.end).to_vec(), palette.volume_edge, 1.5, Dash::Dashed);
    let (near, far) = (profile.sides(camera.near())[1], profile.sides(volume.end)[1]);
    builder.role = Role::Window;
    builder.named("window", near, &format!("{} (F)", request.labels.window), DVec2::NEG_Y, TYPE, palette.ink);
    builder.role = Role::FarFace;
    builder.named("far", far, &format!("{} (B)", request.labels.far), DVec2::NEG_Y, TYPE, palette.ink);
}

/// The point, its projector and its image.
fn construction(builder: &mut AnnotationBuilder, palette: Palette, profile: &Profile) {
    let (camera, color) = (profile.camera, palette.probe);
    let (distance, height) = (profile.distance(), profile.height());
    let (p, image) = (profile.at(distance, height), profile.at(camera.near(), profile.image()));
    let from = match camera.projection() {
        Projection::Perspective => camera.position(),
        Projection::Parallel => profile.at(0.0, height),
    };
    builder.line(vec![from, p], color, 1.6, Dash::Solid);
    builder.line(vec![profile.at(distance, 0.0), p], color, 1.2, Dash::Dotted);
    builder.mark_above(p, MarkShape::Disc, 3.5, color);
    builder.mark_above(image, MarkShape::Square, 3.5, color);
    let above = if height < 0.0 { DVec2::Y } else { DVec2::NEG_Y };
    // PF has its name already.
    if !profile.name.is_empty() {
        builder.text(p, &profile.name, above, TYPE, color);
    }
}

fn lengths(builder: &mut AnnotationBuilder, request: &Request, palette: Palette, profile: &Profile) {
    let camera = profile.camera;
    let (step, dop, v) = (profile.step, camera.direction_of_projection(), camera.basis().v);
    let pen = |color| Pen { color, width: 1.2 };
    let (soft, probe) = (pen(palette.soft), pen(palette.probe));
    let lowest = profile.lowest();
    let along = |builder: &mut AnnotationBuilder, to: f64, row: f64, (name, text): (&str, &str), gap, pen| {
        let ends = [camera.position(), profile.at(to, 0.0)];
        let aside = v * (lowest - row * step);
        dimensions::span(builder, &Span { ends, aside, name, text, gap }, pen);
    };
    let [view, image] = [PointNumber::View, PointNumber::Window].map(|number| Quantity::Point(0, number));
    along(builder, camera.near(), 1.0, ("F", &dimensions::text(request, Measure::Near)), None, soft);
    let end = profile.volume.end;
    let gap = profile.volume.gap.map(|gap| gap.map(|d| d / end));
    along(builder, end, 3.0, ("B", &dimensions::text(request, Measure::Far)), gap, soft);
    let depth = format!("−z_c = {}", request.number(view, profile.distance()));
    along(builder, profile.distance(), 2.0, ("−z_c", &depth), None, probe);

    let window = camera.window();
    let upright = |builder: &mut AnnotationBuilder, at: f64, to: f64, aside: DVec3, text: &str, pen| {
        if to.abs() > 0.05 * step {
            let ends = [profile.at(at, 0.0), profile.at(at, to)];
            dimensions::span(builder, &Span { ends, aside, name: symbol_of(text), text, gap: None }, pen);
        }
    };
    let near = camera.near();
    let half = format!("H/2 = {}", request.number(Quantity::Window(WindowNumber::Height), window.height() / 2.0));
    if window.top == -window.bottom {
        // On the other side of the axis from the point, so that neither covers the other.
        let side = if profile.height() < 0.0 { window.top } else { window.bottom };
        upright(builder, near, side, -dop * (0.6 * step), &half, soft);
    }
    let on_window = format!("y_p = {}", request.number(image, profile.image()));
    upright(builder, near, profile.image(), dop * (0.6 * step), &on_window, probe);
    let height = format!("y_c = {}", request.number(view, profile.height()));
    upright(builder, profile.distance(), profile.height(), dop * (0.6 * step), &height, probe);
    if dimensions::half_angle(request).is_some() {
        let side = profile.sides(near)[usize::from(profile.height() < 0.0)];
        let toward = (side - camera.position()).normalize_or_zero();
        let text = dimensions::text(request, Measure::HalfAngle);
        dimensions::angle(builder, camera.position(), [dop, toward], 1.8 * step, ("theta/2", &text), soft);
    }
}
