//! Filled areas and point marks on the picture, and what texts share with them.

use tiny_skia::{FillRule, LineJoin, Paint, Path, PathBuilder, PathSegment, Pixmap, Point, Stroke, Transform};

use crate::appearance::{MarkShape, Occlusion, Rgba};
use crate::drawing::{Area, Mark};
use crate::text::Element;

use super::depth::Occluders;

/// Opacity of a label or a mark behind a face, relative to its own.
pub const FADED: f32 = 0.45;
/// Width of the halo's stroke, as a share of the type size. Half of it is outside the letter.
pub const HALO: f32 = 0.28;

/// The greatest distance from the corner of the picture, in pixels, at which anything is drawn. Beyond it an `f32` has
/// no pixels any more, and from some thirty times that distance on the filling of paths counts past the end of its
/// rows.
const FARTHEST: f32 = 16_777_216.0;

/// True if a path at a place, with a stroke of some width around it, is near enough to be drawn.
pub(super) fn is_near(path: &Path, [x, y]: [f32; 2], stroke: f32) -> bool {
    // A mitred corner reaches out by four widths.
    let is_near = |v: f32| v.abs() + 4.0 * stroke < FARTHEST;
    let bounds = path.bounds();
    [bounds.left() + x, bounds.right() + x, bounds.top() + y, bounds.bottom() + y].into_iter().all(is_near)
}

/// A path; `None` if there is nothing to fill.
pub fn path_of(elements: &[Element]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for element in elements {
        match *element {
            Element::Move([x, y]) => builder.move_to(x, y),
            Element::Line([x, y]) => builder.line_to(x, y),
            Element::Quad([cx, cy], [x, y]) => builder.quad_to(cx, cy, x, y),
            Element::Cubic([ax, ay], [bx, by], [x, y]) => builder.cubic_to(ax, ay, bx, by, x, y),
            Element::Close => builder.close(),
        }
    }
    builder.finish()
}

/// Fills an area.
pub(super) fn area(pixmap: &mut Pixmap, area: &Area) {
    let Area { corner: [x, y], size: [width, height], radius, fill } = *area;
    let path = rounded([x, y, x + width, y + height], radius);
    if let Some(path) = path.filter(|path| is_near(path, [0.0; 2], 0.0)) {
        pixmap.fill_path(&path, &paint(fill, 1.0), FillRule::Winding, Transform::identity(), None);
    }
}

/// A rectangle (left, top, right, bottom) with round corners; `None` if it is empty or one of the numbers isn't
/// finite.
fn rounded([left, top, right, bottom]: [f32; 4], radius: f32) -> Option<Path> {
    /// Distance of the handles of a cubic curve from its ends, in radii, to make it a quarter of a circle (within 0.03
    /// %).
    const HANDLE: f32 = 0.552_284_8;
    let rect = tiny_skia::Rect::from_ltrb(left, top, right, bottom)?;
    let mut b = PathBuilder::new();
    let r = radius.min(0.5 * rect.width()).min(0.5 * rect.height());
    if r.is_nan() || r <= 0.0 {
        b.push_rect(rect);
        return b.finish();
    }
    let h = r * (1.0 - HANDLE);
    b.move_to(left + r, top);
    b.line_to(right - r, top);
    b.cubic_to(right - h, top, right, top + h, right, top + r);
    b.line_to(right, bottom - r);
    b.cubic_to(right, bottom - h, right - h, bottom, right - r, bottom);
    b.line_to(left + r, bottom);
    b.cubic_to(left + h, bottom, left, bottom - h, left, bottom - r);
    b.line_to(left, top + r);
    b.cubic_to(left, top + h, left + h, top, left + r, top);
    b.close();
    b.finish()
}

/// Draws a point mark.
pub(super) fn mark(pixmap: &mut Pixmap, faces: Occluders, mark: &Mark) {
    if !finite(mark.position, mark.radius) {
        return;
    }
    let [x, y, _] = mark.position;
    let r = mark.radius;
    let Some(path) = mark_path(mark.shape, x, y, r) else { return };
    let opacity = opacity(mark.fade_if_hidden && faces.before(mark.position) != Occlusion::None);
    if !is_near(&path, [0.0; 2], 2.0 * mark_line(r) + 1.5) {
        return;
    }
    let still = Transform::identity();
    for layer in mark_layers(mark) {
        let paint = paint(layer.color, opacity);
        match layer.stroke {
            Some(width) => {
                let stroke = Stroke { width, line_join: LineJoin::Miter, ..Stroke::default() };
                pixmap.stroke_path(&path, &paint, &stroke, still, None);
            }
            None => pixmap.fill_path(&path, &paint, FillRule::Winding, still, None),
        }
    }
}

/// One of the two paints of a mark's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MarkLayer {
    /// The width of its stroke in pixels; `None` means it is filled.
    pub stroke: Option<f32>,
    /// sRGB, with opacity.
    pub color: Rgba,
}

fn mark_line(radius: f32) -> f32 {
    (0.35 * radius).max(1.0)
}

/// The paints of a mark, the lower one first.
pub fn mark_layers(mark: &Mark) -> [MarkLayer; 2] {
    let line = mark_line(mark.radius);
    let (outer, inner) = match mark.shape {
        MarkShape::Ring | MarkShape::Cross => (2.0 * line + 1.5, Some(2.0 * line)),
        MarkShape::Disc | MarkShape::Square | MarkShape::Diamond => (2.0, None),
    };
    [MarkLayer { stroke: Some(outer), color: mark.outline }, MarkLayer { stroke: inner, color: mark.color }]
}

/// The outline of a mark. Empty if it has none that can be drawn.
pub fn mark_outline(mark: &Mark) -> Vec<Element> {
    let [x, y, _] = mark.position;
    let path = finite(mark.position, mark.radius).then(|| mark_path(mark.shape, x, y, mark.radius)).flatten();
    path.map(|path| elements(&path)).unwrap_or_default()
}

/// The outline of an area. Empty if it has none that can be drawn.
pub fn area_outline(area: &Area) -> Vec<Element> {
    let Area { corner: [x, y], size: [width, height], radius, .. } = *area;
    rounded([x, y, x + width, y + height], radius).map(|path| elements(&path)).unwrap_or_default()
}

fn elements(path: &Path) -> Vec<Element> {
    let at = |p: Point| [p.x, p.y];
    let element = |segment| match segment {
        PathSegment::MoveTo(p) => Element::Move(at(p)),
        PathSegment::LineTo(p) => Element::Line(at(p)),
        PathSegment::QuadTo(c, p) => Element::Quad(at(c), at(p)),
        PathSegment::CubicTo(a, b, p) => Element::Cubic(at(a), at(b), at(p)),
        PathSegment::Close => Element::Close,
    };
    path.segments().map(element).collect()
}

fn mark_path(shape: MarkShape, x: f32, y: f32, r: f32) -> Option<Path> {
    let mut b = PathBuilder::new();
    match shape {
        MarkShape::Disc => b.push_circle(x, y, r),
        MarkShape::Ring => b.push_circle(x, y, 0.8 * r),
        MarkShape::Square => {
            b.push_rect(tiny_skia::Rect::from_ltrb(x - 0.9 * r, y - 0.9 * r, x + 0.9 * r, y + 0.9 * r)?);
        }
        MarkShape::Diamond => {
            let r = 1.2 * r;
            b.move_to(x, y - r);
            b.line_to(x + r, y);
            b.line_to(x, y + r);
            b.line_to(x - r, y);
            b.close();
        }
        MarkShape::Cross => {
            let r = 0.8 * r;
            b.move_to(x - r, y - r);
            b.line_to(x + r, y + r);
            b.move_to(x - r, y + r);
            b.line_to(x + r, y - r);
        }
    }
    b.finish()
}

pub(super) fn finite(position: [f32; 3], size: f32) -> bool {
    position.iter().all(|v| v.is_finite()) && size.is_finite() && size > 0.0
}

pub(super) fn opacity(hidden: bool) -> f32 {
    if hidden { FADED } else { 1.0 }
}

pub(super) fn paint(c: Rgba, opacity: f32) -> Paint<'static> {
    let mut color = super::color(c);
    color.apply_opacity(opacity);
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(color);
    paint
}

#[cfg(all(test, feature = "text"))]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use proptest::prelude::*;

    use super::*;
    use crate::drawing::{Anchor, Label};
    use crate::raster::{DepthBuffer, text};

    fn wild() -> impl Strategy<Value = f32> {
        prop_oneof![
            (-45..39_i32).prop_map(|e| 10f32.powi(e)),
            (-45..39_i32).prop_map(|e| -10f32.powi(e)),
            0.0..70.0_f32,
            any::<f32>(),
        ]
    }

    /// Paints a name, a mark and an area.
    fn painted([x, y, size]: [f32; 3], shape: MarkShape) -> Pixmap {
        let (color, position) = (Rgba::rgb(20, 30, 200), [x, y, 0.5]);
        let mut pixmap = Pixmap::new(64, 48).unwrap();
        let depth = DepthBuffer::default();
        let (text, halo) = ("PF_c".to_owned(), Rgba::rgb(255, 255, 255));
        let (anchor, offset, fade_if_hidden) = (Anchor::Center, [3.0, -2.0], false);
        text::draw(
            &mut pixmap,
            &depth,
            &Label { anchor, offset, fade_if_hidden, ..Label::new(position, text, size, [color, halo]) },
        );
        let faces = Occluders { opaque: &depth, tints: None };
        mark(&mut pixmap, faces, &Mark { position, shape, radius: size, color, outline: halo, fade_if_hidden });
        area(&mut pixmap, &Area { corner: [x, y], size: [size; 2], radius: 3.0, fill: color });
        pixmap
    }

    #[test]
    fn letters_of_any_size_are_drawn_or_left_out() {
        let is_empty = |place| painted(place, MarkShape::Disc).pixels().iter().all(|p| p.alpha() == 0);
        assert!(!is_empty([30.0, 20.0, 12.0]) && !is_empty([30.0, 20.0, 1e5]));
        // Found where the filling of paths counted past the end of a row.
        for size in [1e9, 2.5e10, 4e10, 1e12, 1e20] {
            assert!(is_empty([30.0, 20.0, size]), "{size}");
        }
    }

    proptest! {
        #[test]
        fn nothing_is_too_large_or_too_far_to_be_drawn(
            place in [wild(), wild(), wild()],
            shape in prop::sample::select(vec![MarkShape::Disc, MarkShape::Ring, MarkShape::Square, MarkShape::Diamond, MarkShape::Cross]),
        ) {
            painted(place, shape);
        }
    }
}
