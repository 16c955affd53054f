//! The triangle followed step by step, in each picture.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, MarkShape, Rgba};
use crate::camera::ImageSize;
use crate::drawing::{Area, Drawing};
use crate::pipeline::canonical::displayed_ndc;
use crate::scene::Line;

use crate::figure::TriangleStep;
use crate::views::canonical::canonical_box::CanonicalBox;
use crate::views::pixels::PixelRect;
use crate::views::world::gizmos::{AnnotationBuilder, TYPE, stroke};
use crate::views::{Palette, Request, TriangleOverlay};

/// Opacity of a covered pixel.
const GLASS: u8 = 130;

/// Its corners, and from the cuts on, those of the rest.
fn shown(triangle: &TriangleOverlay) -> Vec<(char, DVec3)> {
    match triangle.step {
        TriangleStep::View | TriangleStep::Facing | TriangleStep::Outcodes => {
            "abc".chars().zip(triangle.corners).collect()
        }
        _ => triangle.left.clone(),
    }
}

/// The sides, the corners and their names, at places of a picture.
fn draw(
    builder: &mut AnnotationBuilder,
    triangle: &TriangleOverlay,
    palette: Palette,
    place: impl Fn(DVec3) -> Option<DVec3>,
) {
    let line = |builder: &mut AnnotationBuilder, points: &[DVec3], color: Rgba, width: f32, dash: Dash| {
        // Visible through anything in front of it.
        let style = stroke(color, width, dash, HiddenLines::Shown);
        builder.gear.lines.push(Line::new(points.to_vec(), style));
    };
    let closed = |points: Vec<DVec3>| points.iter().copied().chain(points.first().copied()).collect::<Vec<_>>();
    let whole: Option<Vec<DVec3>> = triangle.corners.iter().map(|&p| place(p)).collect();
    let corners = shown(triangle);
    if let Some(whole) = whole {
        line(builder, &closed(whole), palette.probe, 1.2, Dash::Dashed);
    }
    let polygon: Option<Vec<DVec3>> = corners.iter().map(|&(_, p)| place(p)).collect();
    let color = if triangle.step == TriangleStep::Cuts { palette.cut } else { palette.probe };
    if let Some(polygon) = polygon {
        line(builder, &closed(polygon), color, 2.6, Dash::Solid);
    }
    for (name, p) in corners {
        let Some(p) = place(p) else { continue };
        let is_new = name > 'c';
        let is_outside = "abc".find(name).is_some_and(|i| triangle.outside[i]);
        let marks_outside = triangle.step == TriangleStep::Outcodes && is_outside;
        let (shape, color) = match (is_new, marks_outside) {
            (true, _) => (MarkShape::Diamond, palette.cut),
            (false, true) => (MarkShape::Cross, palette.wrong),
            (false, false) => (MarkShape::Disc, palette.probe),
        };
        builder.mark_above(p, shape, 4.0, color);
        builder.text(p, &name.to_string(), DVec2::new(0.8, -0.8), TYPE, color);
    }
}

/// In the world. In its first steps it shows the way from the eye to each corner.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let Some(triangle) = &request.triangle else { return };
    draw(builder, triangle, palette, Some);
    if matches!(triangle.step, TriangleStep::View | TriangleStep::Divide) {
        let eye = request.camera.position();
        for (_, p) in shown(triangle) {
            builder.line(vec![eye, p], palette.probe, 1.0, Dash::Dotted);
        }
    }
    if triangle.step == TriangleStep::Facing {
        let [a, b, c] = triangle.corners;
        let normal = (b - a).cross(c - a);
        let length = (normal.length().sqrt() * 0.7).max(f64::MIN_POSITIVE);
        builder.vector((a + b + c) / 3.0, normal.normalize_or_zero() * length, palette.probe, 1.8, "N");
    }
}

/// In the canonical volume: the corners that can be divided.
pub(in crate::views) fn in_canonical(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let Some(triangle) = &request.triangle else { return };
    let canonical = CanonicalBox::of(request);
    let inside = |p: DVec3| displayed_ndc(&request.camera, p).filter(|p| p.abs().max_element() <= 1.0 + 1e-6);
    draw(builder, triangle, palette, |p| inside(p).map(|p| canonical.place(p)));
}

/// In the image: its sides and corners as far as they're in it.
pub(in crate::views) fn in_image(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let Some(triangle) = &request.triangle else { return };
    draw(builder, triangle, palette, Some);
}

/// The pixels that it covers, in the frame of the image.
pub(in crate::views) fn pixels(drawing: &mut Drawing, frame: PixelRect, request: &Request, palette: Palette) {
    let Some(triangle) = &request.triangle else { return };
    if !matches!(triangle.step, TriangleStep::Pixels | TriangleStep::Depth) {
        return;
    }
    let image = request.shot.look.image;
    let mut area = |row: [u32; 3], fill: Rgba, least: f64| {
        drawing.areas.push(pixel_run(frame, image, row, least, fill));
    };
    for &row in &triangle.rows {
        area(row, palette.probe.with_alpha(GLASS), 0.0);
    }
    if let Some([x, y]) = triangle.pixel.filter(|_| triangle.step == TriangleStep::Depth) {
        area([y, x, x + 1], palette.ink, 5.0 * f64::from(request.size.scale));
    }
}

/// A run of pixels of the image, m × n (row, first column, the one after the last), in its frame, with a minimum size.
#[expect(clippy::cast_possible_truncation, reason = "pixels")]
pub(in crate::views) fn pixel_run(
    frame: PixelRect,
    image: ImageSize,
    [y, first, after]: [u32; 3],
    least: f64,
    fill: Rgba,
) -> Area {
    let scale = [f64::from(frame.width) / f64::from(image.width), f64::from(frame.height) / f64::from(image.height)];
    let size = [(f64::from(after - first) * scale[0]).max(least), scale[1].max(least)].map(|v| v as f32);
    let corner = [
        (f64::from(frame.x) + f64::from(first) * scale[0]) as f32,
        (f64::from(frame.y) + f64::from(y) * scale[1]) as f32,
    ];
    Area { corner, size, radius: 0.0, fill }
}
