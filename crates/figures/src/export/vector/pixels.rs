//! A page as pixels.

use tiny_skia::{FillRule, LineCap, LineJoin, Paint, Pixmap, PixmapPaint, Stroke, StrokeDash, Transform};

use super::{Item, Page};
use crate::appearance::Rgba;
use crate::raster::path_of;
use crate::text::Element;

/// The pixels of a page, `zoom` per unit; `None` if there would be too many.
pub fn pixels(page: &Page, zoom: f32) -> Option<Pixmap> {
    paint(&page.items, [0.0, 0.0, page.size[0], page.size[1]], zoom)
}

/// The part of some things inside a rectangle: left, top, right and bottom in units.
fn paint(items: &[Item], [left, top, right, bottom]: [f32; 4], zoom: f32) -> Option<Pixmap> {
    #[expect(clippy::cast_possible_truncation, reason = "a pixmap refuses too large a size")]
    let [width, height] = [right - left, bottom - top].map(|side| (side * zoom).round() as u32);
    let mut pixmap = Pixmap::new(width, height)?;
    let place = Transform::from_row(zoom, 0.0, 0.0, zoom, -left * zoom, -top * zoom);
    for item in items {
        match item {
            Item::Group { corner, scale, clip, items } => {
                let own = paint(items, *clip, zoom * scale)?;
                #[expect(clippy::cast_possible_truncation, reason = "a place in a picture")]
                let [x, y] = [0, 1].map(|k| ((corner[k] + scale * clip[k] - [left, top][k]) * zoom).round() as i32);
                pixmap.draw_pixmap(x, y, own.as_ref(), &PixmapPaint::default(), Transform::identity(), None);
            }
            Item::Fill { path, color } => fill(&mut pixmap, path, *color, place),
            Item::Stroke { path, color, width, dashes, phase, round } => {
                let (line_cap, line_join) =
                    if *round { (LineCap::Round, LineJoin::Round) } else { (LineCap::Butt, LineJoin::Miter) };
                let dash = StrokeDash::new(dashes.clone(), *phase);
                stroke(
                    &mut pixmap,
                    path,
                    *color,
                    &Stroke { width: *width, line_cap, line_join, dash, ..Stroke::default() },
                    place,
                );
            }
            Item::Text(text) => {
                let outline = text.outline();
                if text.halo.a > 0 {
                    let around = Stroke { width: text.halo_width, line_join: LineJoin::Round, ..Stroke::default() };
                    stroke(&mut pixmap, &outline, text.halo, &around, place);
                }
                fill(&mut pixmap, &outline, text.color, place);
            }
            Item::Picture { corner, size, pixels } => {
                let [x, y] = [size[0] / pixels.width() as f32, size[1] / pixels.height() as f32];
                let place = place.pre_translate(corner[0], corner[1]).pre_scale(x, y);
                pixmap.draw_pixmap(0, 0, pixels.as_ref(), &PixmapPaint::default(), place, None);
            }
        }
    }
    Some(pixmap)
}

fn fill(pixmap: &mut Pixmap, path: &[Element], color: Rgba, place: Transform) {
    if let Some(path) = path_of(path) {
        pixmap.fill_path(&path, &paint_of(color), FillRule::Winding, place, None);
    }
}

fn stroke(pixmap: &mut Pixmap, path: &[Element], color: Rgba, stroke: &Stroke, place: Transform) {
    if let Some(path) = path_of(path) {
        pixmap.stroke_path(&path, &paint_of(color), stroke, place, None);
    }
}

fn paint_of(Rgba { r, g, b, a }: Rgba) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, a);
    paint
}
