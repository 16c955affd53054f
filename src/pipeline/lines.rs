//! Edges and lines → strokes: clipped, projected, grouped by style.

use std::ops::Range;

use glam::DVec3;

use super::Target;
use super::clip::segment;
use super::transform::{ClipPoint, Projector, Screen, single};
use crate::appearance::LineStyle;
use crate::drawing::StrokeSet;

/// Collects strokes. Those that follow each other in the same style become one set; the order of styles is that of the lines.
pub(super) struct Strokes<'a> {
    projector: &'a Projector,
    screen: &'a Screen,
    scale: f32,
    pub(super) sets: Vec<StrokeSet>,
    /// Pieces of lines that were given, and of those that are left.
    pub(super) given: usize,
    pub(super) kept: usize,
}

impl<'a> Strokes<'a> {
    pub(super) fn new(projector: &'a Projector, screen: &'a Screen, target: Target) -> Self {
        Self { projector, screen, scale: target.scale, sets: Vec::new(), given: 0, kept: 0 }
    }

    /// A polyline through points of view space. Where it leaves the volume it ends, and where it comes back another begins; an
    /// arrow head stays only at the true end.
    pub(super) fn polyline(&mut self, points: impl IntoIterator<Item = DVec3>, style: LineStyle) {
        let mut points = points.into_iter().map(|p| self.projector.clip(p)).peekable();
        let Some(mut from) = points.next() else { return };
        let mut run: Vec<[f32; 3]> = Vec::new();
        let projector = self.projector;
        while let Some(to) = points.next() {
            self.given += 1;
            let Some([(a, _), (b, cut)]) = segment(projector, [from, to]) else {
                self.flush(&mut run, style, false);
                from = to;
                continue;
            };
            self.kept += 1;
            if run.is_empty() {
                run.push(self.point(a));
            }
            run.push(self.point(b));
            if cut || points.peek().is_none() {
                self.flush(&mut run, style, !cut);
            }
            from = to;
        }
        self.flush(&mut run, style, false);
    }

    fn point(&self, p: ClipPoint) -> [f32; 3] {
        single(self.screen.project(self.projector, p))
    }

    /// Ends a run; `whole_end` says that its last point is the last of the line.
    fn flush(&mut self, run: &mut Vec<[f32; 3]>, style: LineStyle, whole_end: bool) {
        if run.len() >= 2 {
            let style = LineStyle { width: style.width * self.scale, arrow: style.arrow && whole_end, ..style };
            push(&mut self.sets, run, style);
        }
        run.clear();
    }
}

fn push(sets: &mut Vec<StrokeSet>, run: &[[f32; 3]], style: LineStyle) {
    if sets.last().is_none_or(|set| set.style != style) {
        sets.push(StrokeSet { points: Vec::new(), polylines: Vec::new(), style });
    }
    if let Some(set) = sets.last_mut() {
        let start = set.points.len();
        set.points.extend_from_slice(run);
        set.polylines.push(range(start, set.points.len()));
    }
}

/// Indices of the display list are 32 bits wide; a longer list than that would not fit in memory.
fn range(start: usize, end: usize) -> Range<u32> {
    u32::try_from(start).unwrap_or(u32::MAX)..u32::try_from(end).unwrap_or(u32::MAX)
}
