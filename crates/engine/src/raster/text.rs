//! Texts on the picture.

use tiny_skia::{FillRule, LineJoin, Pixmap, Stroke, Transform};

use super::depth::DepthBuffer;
use super::label::{HALO, finite, is_near, opacity, paint, path_of};
use crate::drawing::{Anchor, Label};
use crate::text;

/// Draws a text, on a halo.
pub(super) fn draw(pixmap: &mut Pixmap, depth: &DepthBuffer, label: &Label) {
    if !finite(label.position, label.size) || !label.offset.iter().all(|v| v.is_finite()) {
        return;
    }
    let Some(path) = path_of(&text::outline(&label.text, label.size, label.mathematical)) else { return };
    let [x, y] = baseline(label);
    let place = Transform::from_translate(x, y);
    let opacity = opacity(label.fade_if_hidden && !depth.shows(label.position));
    if !is_near(&path, [x, y], HALO * label.size) {
        return;
    }
    let stroke = Stroke { width: HALO * label.size, line_join: LineJoin::Round, ..Stroke::default() };
    pixmap.stroke_path(&path, &paint(label.halo, opacity), &stroke, place, None);
    pixmap.fill_path(&path, &paint(label.color, opacity), FillRule::Winding, place, None);
}

/// The left end of the baseline of a label.
pub fn baseline(label: &Label) -> [f32; 2] {
    let width = text::measure(&label.text, label.size, label.mathematical).width;
    let left = match label.anchor {
        Anchor::Left => 0.0,
        Anchor::Center => 0.5 * width,
        Anchor::Right => width,
    };
    let [x, y] = [0, 1].map(|k| label.position[k] + label.offset[k]);
    [x - left, y + 0.5 * text::x_height(label.size)]
}
