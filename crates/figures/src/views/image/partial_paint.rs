//! An unfinished picture. Only the first of its triangles are painted, in the order of painting.

use crate::drawing::Drawing;

/// Keeps the first share (0 … 1) of the triangles, and returns their number, and that of all. Strokes and marks are
/// left out, because the faces that hide them may be missing.
pub(in crate::views) fn first(drawing: &mut Drawing, share: f64) -> [usize; 2] {
    let all: usize = drawing.surfaces.iter().map(|surface| surface.triangles.len()).sum();
    #[expect(clippy::cast_possible_truncation, reason = "a share of a count")]
    let count = (all as f64 * share.clamp(0.0, 1.0)).round() as usize;
    // Without an order, translucent faces are painted last, whatever their place in the list.
    let mut order: Vec<usize> = (0..drawing.surfaces.len()).collect();
    order.sort_by_key(|i| !drawing.painted_in_order && drawing.surfaces[*i].translucent);
    let mut left = count;
    for i in order {
        let surface = &mut drawing.surfaces[i];
        let kept = left.min(surface.triangles.len());
        left -= kept;
        surface.truncate(kept);
    }
    drawing.surfaces.retain(|surface| !surface.triangles.is_empty());
    drawing.strokes.clear();
    drawing.marks.clear();
    [count, all]
}
