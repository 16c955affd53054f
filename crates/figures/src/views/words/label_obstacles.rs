//! The parts of a picture that its texts avoid: marks, the heads of arrows, and lines.

use glam::DVec2;

use crate::appearance::Role;
use crate::drawing::{Drawing, StrokeSet, single};

/// A rectangle in pixels: its middle and half its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::views) struct Box2 {
    pub(in crate::views) center: DVec2,
    pub(in crate::views) half: DVec2,
}

impl Box2 {
    /// The area that both cover.
    pub(in crate::views) fn overlap(&self, other: &Self) -> f64 {
        let d = (self.half + other.half - (self.center - other.center).abs()).max(DVec2::ZERO);
        (d.x * d.y).min(4.0 * self.half.x * self.half.y)
    }

    /// True if both have a place in common.
    pub(in crate::views) fn overlaps(&self, other: &Self) -> bool {
        (self.center - other.center).abs().cmple(self.half + other.half).all()
    }

    /// The length of a segment's part inside.
    pub(in crate::views) fn length_inside(&self, a: DVec2, b: DVec2) -> f64 {
        self.part_inside(a, b).map_or(0.0, |[from, to]| (to - from) * (b - a).length())
    }

    /// The part of a segment inside it, 0 … 1 (Liang and Barsky 1984).
    pub(in crate::views) fn part_inside(&self, a: DVec2, b: DVec2) -> Option<[f64; 2]> {
        let (from, d) = (a - self.center, b - a);
        let (mut t0, mut t1) = (0.0_f64, 1.0_f64);
        for (p, d, h) in [(from.x, d.x, self.half.x), (from.y, d.y, self.half.y)] {
            if d.abs() < 1e-12 {
                if p.abs() > h {
                    return None;
                }
                continue;
            }
            let (s, e) = ((-h - p) / d, (h - p) / d);
            t0 = t0.max(s.min(e));
            t1 = t1.min(s.max(e));
        }
        (t0 < t1).then_some([t0, t1])
    }
}

/// The areas that a text must not cover: marks, and the heads of arrows.
pub(in crate::views) fn marked(drawing: &Drawing) -> Vec<Box2> {
    let marks = drawing.marks.iter().map(|m| (point(m.position), f64::from(m.radius)));
    let heads = drawing.strokes.iter().filter(|s| s.style.arrow).flat_map(|s| {
        s.polylines.iter().filter_map(move |range| {
            let points = s.points.get(range.start as usize..range.end as usize)?;
            let [.., before, tip] = points else { return None };
            let (before, tip) = (point(*before), point(*tip));
            let radius = 0.5 * f64::from(s.style.head_length(single((tip - before).length())));
            Some((tip - (tip - before).normalize_or_zero() * radius, radius))
        })
    });
    marks.chain(heads).map(|(center, radius)| Box2 { center, half: DVec2::splat(radius) }).collect()
}

/// Cost of covering a part of a line that's as long as a letter is high.
const PLAIN: f64 = 1.2;
/// The same for an arrow's shaft.
const STRONG: f64 = 3.0;

/// The segments that a text should not cover, and the cost of covering them.
pub(in crate::views) fn lines(strokes: &[StrokeSet]) -> Vec<([DVec2; 2], f64)> {
    /// Beyond this, a picture is a mesh of edges, and no place is free of them.
    const MOST: usize = 4000;
    let strong = strokes.iter().filter(|s| s.role != Role::Ground && s.points.len() <= MOST);
    strong
        .flat_map(|s| {
            let weight = if s.style.arrow { STRONG } else { PLAIN };
            s.polylines.iter().flat_map(move |range| {
                let points = s.points.get(range.start as usize..range.end as usize).unwrap_or_default();
                points.windows(2).map(move |w| ([point(w[0]), point(w[1])], weight))
            })
        })
        .collect()
}

/// A point of a drawing without its depth.
pub(in crate::views) fn point(p: [f32; 3]) -> DVec2 {
    DVec2::new(f64::from(p[0]), f64::from(p[1]))
}
