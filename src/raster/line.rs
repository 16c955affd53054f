//! Strokes.

use tiny_skia::{LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

use crate::appearance::Dash;
use crate::drawing::StrokeSet;

/// Strokes a set of polylines.
pub(super) fn stroke(pixmap: &mut Pixmap, set: &StrokeSet) {
    let width = set.style.width;
    let mut builder = PathBuilder::new();
    for range in &set.polylines {
        let Some(points) = set.points.get(range.start as usize..range.end as usize) else { continue };
        for (k, p) in points.iter().enumerate() {
            if k == 0 {
                builder.move_to(p[0], p[1]);
            } else {
                builder.line_to(p[0], p[1]);
            }
        }
    }
    let Some(path) = builder.finish() else { return };
    let pattern = match set.style.dash {
        Dash::Solid => None,
        Dash::Dashed => StrokeDash::new(vec![4.0 * width, 3.0 * width], 0.0),
        Dash::Dotted => StrokeDash::new(vec![0.01 * width, 2.5 * width], 0.0),
        Dash::DashDot => StrokeDash::new(vec![4.0 * width, 2.0 * width, 0.01 * width, 2.0 * width], 0.0),
    };
    let stroke =
        Stroke { width, line_cap: LineCap::Round, line_join: LineJoin::Round, dash: pattern, ..Stroke::default() };
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(super::color(set.style.color));
    pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
}
