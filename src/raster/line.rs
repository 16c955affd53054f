//! Strokes: what of a polyline can be seen, its dashes, its arrow head.
//!
//! Everything along a polyline is measured by arc length in pixels from its first point, so that dashes do not start anew
//! where it bends or goes behind a face.

use std::ops::Range;

use tiny_skia::Pixmap;

use crate::appearance::{HiddenLines, LineStyle};
use crate::drawing::StrokeSet;

use super::coverage::Coverage;
use super::depth::DepthBuffer;

/// Distance of the points of a stroke that are held against the depth buffer, in pixels.
const STEP: f32 = 0.5;
/// A visible or hidden part shorter than this (pixels) between two of the other kind is taken for rounding.
const SHORTEST: f32 = 1.25;
/// The most points that are tried on one segment: enough for the longest diagonal.
const MOST_STEPS: f32 = 60_000.0;

/// Draws strokes; keeps its buffers from one to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Strokes {
    pub(super) coverage: Coverage,
    /// Arc length at each point of the polyline at hand.
    arcs: Vec<f32>,
    parts: Vec<Part>,
}

/// A part of a polyline, by arc length.
#[derive(Clone, Debug)]
struct Part {
    range: Range<f32>,
    visible: bool,
}

impl Strokes {
    /// Draws a set: first what is hidden of it, then what can be seen.
    pub(super) fn draw(&mut self, pixmap: &mut Pixmap, depth: &DepthBuffer, set: &StrokeSet) {
        self.coverage.resize(pixmap.width() as usize, pixmap.height() as usize);
        let test = set.style.hidden != HiddenLines::Shown && !depth.is_empty();
        if test && let Some(style) = set.style.behind_a_face() {
            self.cover(depth, set, style, test, false);
            self.coverage.lay(pixmap, style.color);
        }
        self.cover(depth, set, set.style, test, true);
        self.coverage.lay(pixmap, set.style.color);
    }

    /// Covers the visible or the hidden parts of all polylines of a set.
    fn cover(&mut self, depth: &DepthBuffer, set: &StrokeSet, style: LineStyle, test: bool, visible: bool) {
        for polyline in &set.polylines {
            let Some(points) = set.points.get(polyline.start as usize..polyline.end as usize) else { continue };
            // Strokes with a coordinate that is no number, and points alone, cannot be drawn.
            if points.len() < 2 || points.iter().any(|p| !p.iter().all(|v| v.is_finite())) {
                continue;
            }
            self.measure(points);
            self.split(points, depth, test);
            let length = self.arcs.last().copied().unwrap_or(0.0);
            let head = if set.style.arrow { head_length(style.width, length) } else { 0.0 };
            // The shaft ends a little inside the head, whose point would be blunt otherwise.
            let shaft = length - 0.8 * head;
            for part in self.parts.iter().filter(|p| p.visible == visible) {
                let end = part.range.end.min(shaft);
                dashes(part.range.start..end, style, |from, to| {
                    cover_part(&mut self.coverage, points, &self.arcs, from..to, 0.5 * style.width);
                });
            }
            if head > 0.0 {
                let middle = length - 0.5 * head;
                if self.parts.iter().find(|p| p.range.end >= middle).is_some_and(|p| p.visible == visible) {
                    let (tip, base) = (at(points, &self.arcs, length), at(points, &self.arcs, length - head));
                    self.cover_head(tip, base);
                }
            }
        }
    }

    fn measure(&mut self, points: &[[f32; 3]]) {
        self.arcs.clear();
        let mut arc = 0.0;
        self.arcs.push(arc);
        for pair in points.windows(2) {
            arc += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
            self.arcs.push(arc);
        }
    }

    /// Splits the polyline into its visible and its hidden parts.
    fn split(&mut self, points: &[[f32; 3]], depth: &DepthBuffer, test: bool) {
        self.parts.clear();
        let length = self.arcs.last().copied().unwrap_or(0.0);
        if !test {
            self.parts.push(Part { range: 0.0..length, visible: true });
            return;
        }
        for (k, pair) in points.windows(2).enumerate() {
            let (start, end) = (self.arcs[k], self.arcs[k + 1]);
            let point = |t: f32| -> [f32; 3] { std::array::from_fn(|c| pair[0][c] + t * (pair[1][c] - pair[0][c])) };
            let steps = ((end - start) / STEP).ceil().clamp(1.0, MOST_STEPS);
            let mut before = depth.shows(point(0.0));
            let mut from = start;
            let mut step = 1.0;
            while step <= steps {
                let now = depth.shows(point(step / steps));
                if now != before {
                    // Where between the two points: to 1/16 of a step.
                    let (mut low, mut high) = ((step - 1.0) / steps, step / steps);
                    for _ in 0..4 {
                        let middle = 0.5 * (low + high);
                        if depth.shows(point(middle)) == before { low = middle } else { high = middle }
                    }
                    let change = start + high * (end - start);
                    push(&mut self.parts, from..change, before);
                    (from, before) = (change, now);
                }
                step += 1.0;
            }
            push(&mut self.parts, from..end, before);
        }
        smooth(&mut self.parts);
    }

    /// An arrow head from the middle of its base to its tip.
    fn cover_head(&mut self, tip: [f32; 2], base: [f32; 2]) {
        let (dx, dy) = (tip[0] - base[0], tip[1] - base[1]);
        let (nx, ny) = (-0.38 * dy, 0.38 * dx);
        self.coverage.triangle([tip, [base[0] + nx, base[1] + ny], [base[0] - nx, base[1] - ny]]);
    }
}

/// Length of an arrow head on a stroke of this width; short strokes get small heads, and none below a few pixels.
fn head_length(width: f32, stroke_length: f32) -> f32 {
    let length = (4.0 * width + 4.0).min(0.6 * stroke_length);
    if length < 2.0 { 0.0 } else { length }
}

/// Adds a part; one that goes on as the last did makes that longer.
fn push(parts: &mut Vec<Part>, range: Range<f32>, visible: bool) {
    match parts.last_mut() {
        Some(last) if last.visible == visible => last.range.end = range.end,
        _ => parts.push(Part { range, visible }),
    }
}

/// Drops parts that are too short to mean anything.
fn smooth(parts: &mut Vec<Part>) {
    if parts.len() < 2 {
        return;
    }
    let mut kept: Vec<Part> = Vec::with_capacity(parts.len());
    let last = parts.len() - 1;
    for (k, part) in parts.iter().enumerate() {
        let length = part.range.end - part.range.start;
        // At the ends of a line there is but one neighbour to believe: less is asked for.
        let shortest = if k == 0 || k == last { 0.5 * SHORTEST } else { SHORTEST };
        let visible =
            if length < shortest { kept.last().map_or(parts[1].visible, |p| p.visible) } else { part.visible };
        push(&mut kept, part.range.clone(), visible);
    }
    *parts = kept;
}

/// Calls `draw` with each dash in a range of arc length, from the middle of its first round end to that of its last.
fn dashes(range: Range<f32>, style: LineStyle, mut draw: impl FnMut(f32, f32)) {
    let pattern = style.dash.pattern();
    let width = style.width;
    let period: f32 = pattern.iter().sum::<f32>() * width;
    if range.end <= range.start && range.start > 0.0 {
        return;
    }
    // A pattern finer than a fifth of a pixel is seen as a plain line.
    if pattern.is_empty() || period < 0.2 || !period.is_finite() {
        draw(range.start, range.end.max(range.start));
        return;
    }
    let mut start = (range.start / period).floor() * period;
    let mut lengths = pattern.iter().cycle();
    while start < range.end {
        let (Some(on), Some(off)) = (lengths.next(), lengths.next()) else { return };
        // A dot is a dash of length 0: rounding must not make it less.
        let first = start + 0.5 * width;
        let last = (start + on * width - 0.5 * width).max(first);
        let (from, to) = (first.max(range.start), last.min(range.end));
        if from <= to {
            draw(from, to);
        }
        start += (on + off) * width;
    }
}

/// The point at an arc length.
fn at(points: &[[f32; 3]], arcs: &[f32], arc: f32) -> [f32; 2] {
    let k = arcs.partition_point(|&a| a < arc).clamp(1, arcs.len() - 1);
    let (start, end) = (arcs[k - 1], arcs[k]);
    let t = if end > start { ((arc - start) / (end - start)).clamp(0.0, 1.0) } else { 0.0 };
    let (p, q) = (points[k - 1], points[k]);
    [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
}

/// Covers a polyline between two arc lengths.
fn cover_part(coverage: &mut Coverage, points: &[[f32; 3]], arcs: &[f32], range: Range<f32>, radius: f32) {
    let mut from = at(points, arcs, range.start);
    let first = arcs.partition_point(|&a| a <= range.start);
    for k in first..arcs.len() {
        if arcs[k] >= range.end {
            break;
        }
        let corner = [points[k][0], points[k][1]];
        coverage.capsule(from, corner, radius);
        from = corner;
    }
    coverage.capsule(from, at(points, arcs, range.end), radius);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::{Dash, Rgba};

    fn style(dash: Dash) -> LineStyle {
        LineStyle { color: Rgba::rgb(0, 0, 0), width: 2.0, dash, hidden: HiddenLines::Dashed, arrow: false }
    }

    fn drawn(range: Range<f32>, dash: Dash) -> Vec<(f32, f32)> {
        let mut result = Vec::new();
        dashes(range, style(dash), |a, b| result.push((a, b)));
        result
    }

    #[test]
    fn dashes_with_their_round_ends_have_the_lengths_of_the_pattern() {
        // 8 on, 6 off; a round end adds 1 at each side.
        assert_eq!(drawn(0.0..30.0, Dash::Dashed), [(1.0, 7.0), (15.0, 21.0), (29.0, 30.0)]);
        assert_eq!(drawn(0.0..15.0, Dash::Dotted), [(1.0, 1.0), (8.0, 8.0), (15.0, 15.0)]);
        assert_eq!(drawn(0.0..18.0, Dash::DashDot), [(1.0, 7.0), (14.0, 14.0)]);
    }

    #[test]
    fn a_part_keeps_the_phase_of_the_whole() {
        let whole = drawn(0.0..100.0, Dash::Dashed);
        let cut: Vec<_> = [drawn(0.0..18.0, Dash::Dashed), drawn(18.0..100.0, Dash::Dashed)].concat();
        let joined: Vec<_> = cut.iter().filter(|d| d.0 != 18.0 && d.1 != 18.0).collect();
        assert!(joined.iter().all(|d| whole.contains(d)), "{joined:?}");
        assert!(cut.contains(&(15.0, 18.0)) && cut.contains(&(18.0, 21.0)));
    }

    #[test]
    fn short_parts_are_taken_for_rounding() {
        let mut parts = Vec::new();
        for (range, visible) in [(0.0..10.0, true), (10.0..10.5, false), (10.5..20.0, true), (20.0..23.0, false)] {
            push(&mut parts, range, visible);
        }
        smooth(&mut parts);
        let found: Vec<_> = parts.iter().map(|p| (p.range.clone(), p.visible)).collect();
        assert_eq!(found, [(0.0..20.0, true), (20.0..23.0, false)]);
    }

    #[test]
    fn a_point_is_found_by_its_arc_length() {
        let points = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [3.0, 4.0, 0.5], [3.0, 14.0, 0.0]];
        let mut strokes = Strokes::default();
        strokes.measure(&points);
        assert_eq!(strokes.arcs, [0.0, 5.0, 5.0, 15.0]);
        assert_eq!(at(&points, &strokes.arcs, 2.5), [1.5, 2.0]);
        assert_eq!(at(&points, &strokes.arcs, 10.0), [3.0, 9.0]);
        assert_eq!(at(&points, &strokes.arcs, 99.0), [3.0, 14.0]);
        assert_eq!(at(&points, &strokes.arcs, -1.0), [0.0, 0.0]);
    }
}
