//! Dimension lines, as engineers draw them: extension lines, arrows to both ends, the number between.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, Rgba};
use crate::camera::{ParameterKey, Projection};

use super::camera_gizmo::GizmoSizes;
use super::gizmos::{AnnotationBuilder, SMALL_TYPE};
use super::volume::DrawnVolume;
use crate::figure::words::{self, DIMENSIONS};
use crate::figure::{Measure, MeasureText, Measured};
use crate::inspect::quantity::{Quantity, WindowNumber};
use crate::views::{Palette, Request};

/// A length between two points, measured on a line beside them.
pub(in crate::views) struct Span<'a> {
    pub(in crate::views) ends: [DVec3; 2],
    /// From the points to the line.
    pub(in crate::views) aside: DVec3,
    pub(in crate::views) name: &'a str,
    pub(in crate::views) text: &'a str,
    /// The gap between the ends, as shares of the length.
    pub(in crate::views) gap: Option<[f64; 2]>,
}

/// The stroke of a dimension line.
#[derive(Clone, Copy)]
pub(in crate::views) struct Pen {
    pub(in crate::views) color: Rgba,
    pub(in crate::views) width: f32,
}

/// Draws the length of a span.
pub(in crate::views) fn span(builder: &mut AnnotationBuilder, span: &Span<'_>, pen: Pen) {
    let Span { ends: [a, b], aside, name, text, gap } = *span;
    for p in [a, b] {
        builder.line(vec![p, p + aside * 1.06], pen.color, 0.6 * pen.width, Dash::Solid);
    }
    let (p, q) = (a + aside, b + aside);
    let [from, to] = gap.unwrap_or([0.5, 0.5]).map(|share| p.lerp(q, share));
    builder.arrow(vec![from, p], pen.color, pen.width, Dash::Solid);
    builder.arrow(vec![to, q], pen.color, pen.width, Dash::Solid);
    if gap.is_some() {
        builder.breaks(from, to, pen.color);
    }
    let middle = p.lerp(q, 0.5);
    let toward = builder.screen.heading(middle, aside);
    builder.named(name, middle, text, toward, SMALL_TYPE, pen.color);
}

/// An angle at `corner` from one direction to another (unit vectors), with an arc of a radius and a side at its end.
pub(in crate::views) fn angle(
    builder: &mut AnnotationBuilder,
    corner: DVec3,
    [from, to]: [DVec3; 2],
    radius: f64,
    (name, text): (&str, &str),
    pen: Pen,
) {
    const STEPS: u32 = 24;
    let at = |i: u32| {
        let share = f64::from(i) / f64::from(STEPS);
        let angle = from.dot(to).clamp(-1.0, 1.0).acos() * share;
        let across = (to - from * from.dot(to)).normalize_or_zero();
        corner + (from * angle.cos() + across * angle.sin()) * radius
    };
    builder.line(vec![corner, corner + to * (1.15 * radius)], pen.color, 0.6 * pen.width, Dash::Solid);
    builder.arrow((0..=STEPS).map(at).collect(), pen.color, pen.width, Dash::Solid);
    let middle = at(STEPS / 2);
    let toward = builder.screen.heading(middle, middle - corner);
    let toward = if toward == DVec2::ZERO { DVec2::X } else { toward };
    builder.named(name, middle, text, toward, SMALL_TYPE, pen.color);
}

/// The dimension lines of the world: all that the figure asks for, and those under the pointer in a panel.
pub(in crate::views) fn in_world(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    volume: &DrawnVolume,
    gear: GizmoSizes,
) {
    let lit: Vec<Measured> = request.measured().collect();
    for measure in Measure::ALL {
        let hovered = lit.contains(&Measured::Dimension(measure));
        let by_author = request.shot.labels.measures.iter().any(|labelled| labelled.measure == measure);
        let for_all = request.shot.look.world.dimensions && measure.is_among_dimensions();
        if hovered || by_author || for_all {
            let pen = if hovered {
                Pen { color: palette.probe, width: 2.0 }
            } else {
                Pen { color: palette.soft, width: 1.2 }
            };
            one(builder, request, volume, gear, measure, pen);
        }
    }
}

/// Distance of the lowest of the dimension lines below the axis, in lengths of the camera's axes.
pub(in crate::views) const LOWEST: f64 = 1.75;

fn one(
    builder: &mut AnnotationBuilder,
    request: &Request,
    volume: &DrawnVolume,
    gear: GizmoSizes,
    measure: Measure,
    pen: Pen,
) {
    let camera = &request.camera;
    let (c, dop, basis) = (camera.position(), camera.direction_of_projection(), camera.basis());
    let [_, rb, rt, lt] = volume.window();
    let (name, text) = (words::name(DIMENSIONS, measure), text(request, measure));
    let mut along_axis = |to: f64, below: f64, gap: Option<[f64; 2]>| {
        let aside = basis.v * (-below * gear.usual_axis);
        span(builder, &Span { ends: [c, c + dop * to], aside, name, text: &text, gap }, pen);
    };
    match measure {
        Measure::Near => along_axis(volume.start, 0.75, volume.before.map(|gap| gap.map(|d| d / volume.start))),
        Measure::Distance => along_axis(camera.distance(), 1.25, None),
        Measure::Far => along_axis(volume.end, LOWEST, volume.gap.map(|gap| gap.map(|d| d / volume.end))),
        Measure::Width => {
            let aside = basis.v * (0.35 * gear.usual_axis);
            span(builder, &Span { ends: [lt, rt], aside, name, text: &text, gap: None }, pen);
        }
        Measure::Height => {
            let aside = basis.u * (0.35 * gear.usual_axis);
            span(builder, &Span { ends: [rb, rt], aside, name, text: &text, gap: None }, pen);
        }
        // Farther from the window than the whole, which may also be there.
        Measure::HalfWidth => {
            let (aside, middle) = (basis.v * (0.8 * gear.usual_axis), lt.lerp(rt, 0.5));
            span(builder, &Span { ends: [middle, rt], aside, name, text: &text, gap: None }, pen);
        }
        Measure::HalfHeight => {
            let (aside, middle) = (basis.u * (0.8 * gear.usual_axis), rb.lerp(rt, 0.5));
            span(builder, &Span { ends: [middle, rt], aside, name, text: &text, gap: None }, pen);
        }
        Measure::Angle => {
            if let Some(top) = half_angle(request) {
                // The lower side, mirroring the upper one about the axis.
                let bottom = 2.0 * top.dot(dop) * dop - top;
                let radius = 2.1 * gear.usual_axis;
                builder.line(vec![c, c + bottom * (1.15 * radius)], pen.color, 0.6 * pen.width, Dash::Solid);
                angle(builder, c, [bottom, top], radius, (name, &text), pen);
            }
        }
        Measure::HalfAngle => {
            if let Some(top) = half_angle(request) {
                angle(builder, c, [dop, top], 1.6 * gear.usual_axis, (name, &text), pen);
            }
        }
    }
}

/// The direction from C to the middle of the window's upper side; `None` if θ isn't a parameter.
pub(in crate::views) fn half_angle(request: &Request) -> Option<DVec3> {
    let camera = &request.camera;
    let has_angle = camera.projection() == Projection::Perspective && camera.parameters().window.is_none();
    let [_, _, rt, lt] = DrawnVolume::whole(camera).window();
    has_angle.then(|| (rt.lerp(lt, 0.5) - camera.position()).normalize_or_zero())
}

/// The symbol and the number of a measure, or one of them, as the author chose.
pub(in crate::views) fn text(request: &Request, measure: Measure) -> String {
    let (camera, window) = (&request.camera, request.camera.window());
    let half_angle = (window.height() / 2.0).atan2(camera.near()).to_degrees();
    let parameter = Quantity::Camera;
    let [width, height] = [WindowNumber::Width, WindowNumber::Height].map(Quantity::Window);
    let (quantity, value, unit) = match measure {
        Measure::Near => (parameter(ParameterKey::Near), camera.near(), ""),
        Measure::Far => (parameter(ParameterKey::Far), camera.far(), ""),
        Measure::Distance => (Quantity::Distance, camera.distance(), ""),
        Measure::Width => (width, window.width(), ""),
        Measure::Height => (height, window.height(), ""),
        Measure::HalfWidth => (width, window.width() / 2.0, ""),
        Measure::HalfHeight => (height, window.height() / 2.0, ""),
        Measure::Angle => (parameter(ParameterKey::ViewAngle), 2.0 * half_angle, "°"),
        Measure::HalfAngle => (parameter(ParameterKey::ViewAngle), half_angle, "°"),
    };
    let symbol = measure.symbol();
    let value = format!("{}{unit}", request.number(quantity, value));
    let labelled = request.shot.labels.measures.iter().find(|labelled| labelled.measure == measure);
    match labelled.map(|labelled| labelled.shown).unwrap_or_default() {
        MeasureText::Symbol => symbol.to_owned(),
        MeasureText::Value => value,
        MeasureText::Both => format!("{symbol} = {value}"),
    }
}
