//! Measures of the entries of the matrices in the world: components of axes and points, coordinates along an axis,
//! sides of the window.

use glam::DVec3;

use crate::appearance::{Dash, MarkShape};

use super::camera_gizmo::GizmoSizes;
use super::dimensions::{Pen, Span, span};
use super::gizmos::{AnnotationBuilder, SMALL_TYPE, symbol_of};
use super::volume::DrawnVolume;
use crate::camera::ParameterKey;
use crate::figure::{Measured, WindowSide};
use crate::inspect::quantity::{BasisAxis, Quantity, ReportMatrix, WindowNumber};
use crate::views::{Palette, Request};

const LETTERS: [&str; 3] = ["x", "y", "z"];
const AXES: [&str; 3] = ["u", "v", "n"];

/// Draws the measures of the panel's hover, except for those with a dimension line, and those of an object.
pub(in crate::views) fn in_world(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    volume: &DrawnVolume,
    gear: GizmoSizes,
) {
    let pen = Pen { color: palette.probe, width: 2.0 };
    let camera = &request.camera;
    let (c, axes) = (camera.position(), axes(request));
    for measured in request.measured() {
        let Some(text) = text(request, measured) else { continue };
        match measured {
            Measured::Dimension(_) | Measured::Translate(_) | Measured::Rotate(_) | Measured::Scale(_) => {}
            Measured::Axis(k, i) => component(builder, c, along(axes[k] * gear.axis, i), &text, pen),
            Measured::ViewUp(i) => component(builder, c, along(gear.view_up_tip(camera) - c, i), &text, pen),
            Measured::Position(i) => component(builder, DVec3::ZERO, along(c, i), &text, pen),
            Measured::FocalPoint(i) => component(builder, DVec3::ZERO, along(camera.focal_point(), i), &text, pen),
            Measured::OriginAlong(k) => {
                let foot = c - axes[k] * axes[k].dot(c);
                builder.line(vec![foot, DVec3::ZERO], pen.color, 0.8 * pen.width, Dash::Dotted);
                builder.mark_above(DVec3::ZERO, MarkShape::Ring, 4.0, pen.color);
                lettered(builder, [c, foot], &text, pen);
            }
            Measured::Side(side) => {
                let ends = to_side(request, volume, side);
                let name = symbol_of(&text);
                span(builder, &Span { ends, aside: DVec3::ZERO, name, text: &text, gap: None }, pen);
            }
        }
    }
}

fn axes(request: &Request) -> [DVec3; 3] {
    let basis = request.camera.basis();
    [basis.u, basis.v, basis.n]
}

/// From the foot of DOP in the window to one of its sides, in the window as drawn, which may be narrower.
fn to_side(request: &Request, volume: &DrawnVolume, side: WindowSide) -> [DVec3; 2] {
    let [lb, rb, _, lt] = volume.window();
    let (window, right, up) = (request.camera.window(), rb - lb, lt - lb);
    let share = |low: f64, high: f64| -low / (high - low);
    let (across, upwards) = (share(window.left, window.right), share(window.bottom, window.top));
    let foot = lb + right * across + up * upwards;
    let to = match side {
        WindowSide::Left => foot - right * across,
        WindowSide::Right => foot + right * (1.0 - across),
        WindowSide::Bottom => foot - up * upwards,
        WindowSide::Top => foot + up * (1.0 - upwards),
    };
    [foot, to]
}

/// A vector, and its component along an axis of the world.
fn along(vector: DVec3, i: usize) -> [DVec3; 2] {
    [vector, DVec3::AXES[i] * vector[i]]
}

/// A vector, and its component along an axis.
pub(in crate::views) fn component(
    builder: &mut AnnotationBuilder,
    from: DVec3,
    [vector, along]: [DVec3; 2],
    text: &str,
    pen: Pen,
) {
    builder.arrow(vec![from, from + vector], pen.color, pen.width, Dash::Solid);
    builder.line(vec![from + along, from + vector], pen.color, 0.8 * pen.width, Dash::Dotted);
    lettered(builder, [from, from + along], text, pen);
}

/// A strong stroke with its text beside its middle.
pub(in crate::views) fn lettered(builder: &mut AnnotationBuilder, [from, to]: [DVec3; 2], text: &str, pen: Pen) {
    builder.line(vec![from, to], pen.color, 2.0 * pen.width, Dash::Solid);
    let (middle, across) = (from.lerp(to, 0.5), builder.screen.heading(from, to - from).perp());
    builder.text(middle, text, across, SMALL_TYPE, pen.color);
}

/// The symbol and the number; `None` for measures drawn elsewhere.
fn text(request: &Request, measured: Measured) -> Option<String> {
    let (camera, axes) = (&request.camera, axes(request));
    let (window, c) = (camera.window(), camera.position());
    let parameter = Quantity::Camera;
    let (symbol, value, quantity) = match measured {
        Measured::Dimension(_) | Measured::Translate(_) | Measured::Rotate(_) | Measured::Scale(_) => return None,
        Measured::Axis(k, i) => (format!("{}_{}", AXES[k], LETTERS[i]), axes[k][i], Quantity::Axis(BasisAxis::ALL[k])),
        Measured::OriginAlong(k) => {
            (format!("−{} · c", AXES[k]), -axes[k].dot(c), Quantity::Matrix(ReportMatrix::View))
        }
        Measured::Position(i) => (format!("c_{}", LETTERS[i]), c[i], parameter(ParameterKey::Position)),
        Measured::FocalPoint(i) => {
            (format!("PF_{}", LETTERS[i]), camera.focal_point()[i], parameter(ParameterKey::FocalPoint))
        }
        Measured::ViewUp(i) => (format!("VUP_{}", LETTERS[i]), camera.view_up()[i], parameter(ParameterKey::ViewUp)),
        Measured::Side(WindowSide::Left) => ("l".to_owned(), window.left, Quantity::Window(WindowNumber::Left)),
        Measured::Side(WindowSide::Right) => ("r".to_owned(), window.right, Quantity::Window(WindowNumber::Right)),
        Measured::Side(WindowSide::Bottom) => ("b".to_owned(), window.bottom, Quantity::Window(WindowNumber::Bottom)),
        Measured::Side(WindowSide::Top) => ("t".to_owned(), window.top, Quantity::Window(WindowNumber::Top)),
    };
    Some(format!("{symbol} = {}", request.number(quantity, value + 0.0)))
}
