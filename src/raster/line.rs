//! Strokes: the visible parts of a polyline, its dashes, its arrow head.
//!
//! Everything along a polyline is measured by arc length in pixels from its first point, so that dashes do not start
//! anew where it bends or goes behind a face.

use std::ops::Range;

use rayon::prelude::*;
use tiny_skia::Pixmap;

use crate::appearance::{HiddenLines, LineStyle, Occlusion, head_corners};
use crate::drawing::{Drawing, StrokeSet};
use crate::progress::{Activity, Progress};

use super::coverage::{Coverage, LayerDepth, Point, length};
use super::depth::Occluders;

/// Distance of the points of a stroke that are held against the depth buffer, in pixels.
const STEP: f32 = 0.5;
/// A run shorter than this (pixels) between two of another kind is taken for rounding.
const SHORTEST: f32 = 1.25;
/// Polylines longer than this (pixels) are not part of a picture.
const LONGEST: f32 = 1e6;
/// The most points that are tried on one segment: enough for the longest diagonal.
const MOST_STEPS: f32 = 60_000.0;
/// Polylines that are held against the depth buffer as one piece of work.
const CHUNK: usize = 16;
/// Fewer polylines than this are not worth a second thread.
const FEW: usize = 64;

/// Draws strokes; keeps its buffers from one picture to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Strokes {
    chunks: Vec<Chunk>,
    /// For as many strips of rows as there are threads.
    strips: Vec<Strip>,
}

/// Some polylines of a set.
#[derive(Clone, Debug, Default)]
struct Chunk {
    set: usize,
    polylines: Range<usize>,
    runs: Vec<ArcRun>,
    line: Polyline,
}

/// A run of a polyline, behind the same faces throughout, by arc length.
#[derive(Clone, Debug, PartialEq)]
struct ArcRun {
    polyline: usize,
    range: Range<f32>,
    behind: Occlusion,
}

/// The painter of some rows of the picture.
#[derive(Clone, Debug, Default)]
struct Strip {
    coverage: Coverage,
    line: Polyline,
}

/// The arc length at each point of a polyline.
#[derive(Clone, Debug, Default)]
struct Polyline {
    arcs: Vec<f32>,
}

impl Strokes {
    /// Draws all strokes of a drawing over its surfaces, from back to front.
    pub(super) fn draw(&mut self, pixmap: &mut Pixmap, faces: Occluders, drawing: &Drawing, progress: &Progress) {
        let sets = &drawing.strokes;
        let mut used = 0;
        for (set, polylines) in sets.iter().map(|s| s.polylines.len()).enumerate() {
            for first in (0..polylines).step_by(CHUNK) {
                self.chunks.resize_with(self.chunks.len().max(used + 1), Chunk::default);
                (self.chunks[used].set, self.chunks[used].polylines) = (set, first..polylines.min(first + CHUNK));
                used += 1;
            }
        }
        let chunks = &mut self.chunks[..used];
        let count: usize = sets.iter().map(|s| s.polylines.len()).sum();
        if count == 0 {
            return;
        }
        let threads = if count < FEW { 1 } else { rayon::current_num_threads() };
        progress.begin(Activity::Painting, 0);
        let split = |chunk: &mut Chunk| {
            chunk.runs.clear();
            if !progress.is_cancelled() {
                chunk.split(&sets[chunk.set], faces);
            }
        };
        if threads > 1 {
            chunks.par_iter_mut().for_each(split);
        } else {
            chunks.iter_mut().for_each(split);
        }

        let (width, height) = (pixmap.width() as usize, pixmap.height() as usize);
        let rows = height.div_ceil(threads);
        self.strips.resize_with(self.strips.len().max(threads), Strip::default);
        let pixels = pixmap.data_mut().as_chunks_mut::<4>().0;
        let work = |(k, (strip, pixels)): (usize, (&mut Strip, &mut [[u8; 4]]))| {
            strip.coverage.fit(width, k * rows..k * rows + pixels.len() / width);
            strip.draw(pixels, sets, chunks, progress);
        };
        if threads > 1 {
            self.strips.par_iter_mut().zip(pixels.par_chunks_mut(rows * width)).enumerate().for_each(work);
        } else {
            self.strips.iter_mut().zip(pixels.chunks_mut(rows * width)).enumerate().for_each(work);
        }
    }
}

/// The points of a polyline, where they are two or more, all of them numbers and not too far apart.
fn points<'a>(set: &'a StrokeSet, polyline: usize, line: &mut Polyline) -> Option<&'a [[f32; 3]]> {
    let range = set.polylines.get(polyline)?;
    let points = set.points.get(range.start as usize..range.end as usize)?;
    let fits = points.len() >= 2 && points.iter().all(|p| p.iter().all(|v| v.is_finite()));
    (fits && line.measure(points) < LONGEST).then_some(points)
}

impl Chunk {
    /// Finds the visible, the dimmed and the hidden parts of the chunk's polylines, whose runs are empty before.
    fn split(&mut self, set: &StrokeSet, faces: Occluders) {
        let test = set.style.hidden != HiddenLines::Shown && !faces.is_empty();
        for polyline in self.polylines.clone() {
            let Some(points) = points(set, polyline, &mut self.line) else { continue };
            let first = self.runs.len();
            if test {
                self.line.split(points, faces, |range, behind| {
                    push(&mut self.runs, first, ArcRun { polyline, range, behind });
                });
                smooth(&mut self.runs, first);
            } else {
                self.runs.push(ArcRun { polyline, range: 0.0..self.line.length(), behind: Occlusion::None });
            }
        }
    }
}

impl Strip {
    fn draw(&mut self, pixels: &mut [[u8; 4]], sets: &[StrokeSet], chunks: &[Chunk], progress: &Progress) {
        for (index, set) in sets.iter().enumerate() {
            if progress.is_cancelled() {
                break;
            }
            let first = chunks.partition_point(|c| c.set < index);
            let chunks = &chunks[first..][..chunks[first..].partition_point(|c| c.set == index)];
            let on_top = set.style.hidden == HiddenLines::Shown;
            for behind in [Occlusion::Opaque, Occlusion::Translucent, Occlusion::None] {
                let Some(style) = set.style.behind(behind) else { continue };
                let mut runs = chunks.iter().flat_map(|c| &c.runs).filter(|run| run.behind == behind).peekable();
                if runs.peek().is_none() {
                    continue;
                }
                let tested = LayerDepth::Tested { visible: behind != Occlusion::Opaque, width: set.style.width };
                self.coverage.begin(style.color, if on_top { LayerDepth::OnTop } else { tested });
                for run in runs {
                    self.cover(set, run, style);
                }
            }
        }
        self.coverage.lay(pixels);
    }

    /// Covers a run of a polyline, with the arrow head if that is in it.
    fn cover(&mut self, set: &StrokeSet, run: &ArcRun, style: LineStyle) {
        let Some(points) = points(set, run.polyline, &mut self.line) else { return };
        let length = self.line.length();
        let head = style.head_length(length);
        // The shaft ends a little inside the head, whose point would be blunt otherwise.
        let shaft = length - 0.8 * head;
        dashes(run.range.start..run.range.end.min(shaft), style, |from, to| {
            self.line.cover(points, from..to, &mut self.coverage, 0.5 * style.width);
        });
        let middle = length - 0.5 * head;
        if head > 0.0 && run.range.start < middle && middle <= run.range.end {
            let (tip, base) = (self.line.at(points, length), self.line.at(points, length - head));
            let corners = head_corners([[tip[0], tip[1]], [base[0], base[1]]]);
            self.coverage.triangle(corners, [tip[2].min(base[2]), tip[2].max(base[2])]);
        }
    }
}

impl Polyline {
    /// Measures a polyline; its length.
    fn measure(&mut self, points: &[[f32; 3]]) -> f32 {
        self.arcs.clear();
        let mut arc = 0.0;
        self.arcs.push(arc);
        for pair in points.windows(2) {
            arc += length(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
            self.arcs.push(arc);
        }
        arc
    }

    fn length(&self) -> f32 {
        self.arcs.last().copied().unwrap_or(0.0)
    }

    /// Calls `run` for each stretch of the polyline that is behind the same faces throughout.
    fn split(&self, points: &[[f32; 3]], faces: Occluders, mut run: impl FnMut(Range<f32>, Occlusion)) {
        for (k, pair) in points.windows(2).enumerate() {
            let (start, end) = (self.arcs[k], self.arcs[k + 1]);
            let point = |t: f32| -> [f32; 3] { std::array::from_fn(|c| pair[0][c] + t * (pair[1][c] - pair[0][c])) };
            let steps = ((end - start) / STEP).ceil().clamp(1.0, MOST_STEPS);
            let mut before = faces.before(point(0.0));
            let mut from = start;
            let mut step = 1.0;
            while step <= steps {
                let now = faces.before(point(step / steps));
                if now != before {
                    // The position between the two points, to 1/16 of a step.
                    let (mut low, mut high) = ((step - 1.0) / steps, step / steps);
                    for _ in 0..4 {
                        let middle = 0.5 * (low + high);
                        if faces.before(point(middle)) == before { low = middle } else { high = middle }
                    }
                    let change = start + high * (end - start);
                    run(from..change, before);
                    (from, before) = (change, now);
                }
                step += 1.0;
            }
            run(from..end, before);
        }
    }

    /// The point at an arc length.
    fn at(&self, points: &[[f32; 3]], arc: f32) -> Point {
        let k = self.arcs.partition_point(|&a| a < arc).clamp(1, self.arcs.len() - 1);
        let (start, end) = (self.arcs[k - 1], self.arcs[k]);
        let t = if end > start { ((arc - start) / (end - start)).clamp(0.0, 1.0) } else { 0.0 };
        let (p, q) = (points[k - 1], points[k]);
        std::array::from_fn(|k| p[k] + t * (q[k] - p[k]))
    }

    /// Covers the polyline between two arc lengths.
    fn cover(&self, points: &[[f32; 3]], range: Range<f32>, coverage: &mut Coverage, radius: f32) {
        let mut from = self.at(points, range.start);
        let first = self.arcs.partition_point(|&a| a <= range.start);
        for (&corner, _) in points.iter().zip(&self.arcs).skip(first).take_while(|&(_, &arc)| arc < range.end) {
            coverage.capsule(from, corner, radius);
            from = corner;
        }
        coverage.capsule(from, self.at(points, range.end), radius);
    }
}

/// Adds a run of the polyline whose runs begin at `first`; one that goes on as the last did makes that longer.
fn push(runs: &mut Vec<ArcRun>, first: usize, run: ArcRun) {
    match runs[first..].last_mut() {
        Some(last) if last.behind == run.behind => last.range.end = run.range.end,
        _ => runs.push(run),
    }
}

/// Drops runs that are too short to mean anything, of the polyline whose runs begin at `first`.
fn smooth(runs: &mut Vec<ArcRun>, first: usize) {
    if runs.len() < first + 2 {
        return;
    }
    let all = runs.split_off(first);
    let last = all.len() - 1;
    for (k, run) in all.iter().enumerate() {
        let length = run.range.end - run.range.start;
        // At the ends of a line there is only one neighbour to rely on: a shorter run is enough.
        let shortest = if k == 0 || k == last { 0.5 * SHORTEST } else { SHORTEST };
        let before = runs[first..].last().map_or(all[1].behind, |p| p.behind);
        let behind = if length < shortest { before } else { run.behind };
        push(runs, first, ArcRun { behind, ..run.clone() });
    }
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
        let run = |range, visible| {
            let behind = if visible { Occlusion::None } else { Occlusion::Opaque };
            ArcRun { polyline: 3, range, behind }
        };
        // Of another polyline: stays as it is.
        let mut runs = vec![run(0.0..0.1, true)];
        for (range, visible) in [(0.0..10.0, true), (10.0..10.5, false), (10.5..20.0, true), (20.0..23.0, false)] {
            push(&mut runs, 1, run(range, visible));
        }
        assert_eq!(runs.len(), 5);
        smooth(&mut runs, 1);
        assert_eq!(runs, [run(0.0..0.1, true), run(0.0..20.0, true), run(20.0..23.0, false)]);
    }

    #[test]
    fn a_point_is_found_by_its_arc_length() {
        let points = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [3.0, 4.0, 0.5], [3.0, 14.0, 0.0]];
        let mut line = Polyline::default();
        assert_eq!(line.measure(&points), 15.0);
        assert_eq!(line.arcs, [0.0, 5.0, 5.0, 15.0]);
        assert_eq!(line.at(&points, 2.5), [1.5, 2.0, 0.0]);
        assert_eq!(line.at(&points, 10.0), [3.0, 9.0, 0.25]);
        assert_eq!(line.at(&points, 99.0), [3.0, 14.0, 0.0]);
        assert_eq!(line.at(&points, -1.0), [0.0, 0.0, 0.0]);
    }
}
