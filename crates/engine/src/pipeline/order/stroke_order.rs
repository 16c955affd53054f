//! The order of strokes for outputs that have no depth buffer: later strokes cover earlier ones.
//!
//! If two runs touch on the picture, the rule of [`drawing`](crate::drawing) decides which is over the other. The runs
//! are sorted so that each comes after all runs that it's over. If runs lie over one another in a cycle, they are split
//! between the places where they touch. As in the depth sort of Newell, Newell and Sancha (1972), but with strokes.
//!
//! A grid of squares finds the contacts: the work grows with the length of all strokes, and with the square of the
//! number of segments in one square of 32 pixels.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use glam::DVec2;

use super::stroke_runs::{KEPT, LISTED, Run, SQUARE, WorkBudget, runs_within};
use crate::appearance::{HiddenLines, LineStyle, Occlusion};
use crate::drawing::order::{StrokePoint, later_is_over, stroke_reach};
use crate::drawing::{Drawing, single};
use crate::pipeline::budget::OverBudget;

/// Runs of the strokes of a drawing, from back to front.
///
/// *Guarantees*: if two runs of different strokes touch, the one that is over the other where they touch comes later.
/// There are two exceptions: three or more runs that touch at one place and don't agree on an order there, and a run
/// that passes another twice within the sum of their widths. The parts of a split run follow one another along the
/// polyline without a gap. A part's [`start`](Run::start) lets its dashes continue. Runs that aren't painted are left
/// out.
///
/// # Errors
/// [`OverBudget::Strokes`].
pub fn painted_runs(drawing: &Drawing) -> Result<Vec<Run>, OverBudget> {
    runs_in_order(drawing, &mut WorkBudget::default())
}

fn runs_in_order(drawing: &Drawing, steps: &mut WorkBudget) -> Result<Vec<Run>, OverBudget> {
    let painted = runs_within(drawing, steps)?
        .into_iter()
        .filter_map(|run| run.style(drawing).map(|style| Painted { run, style }));
    let (on_top, mut tested): (Vec<Painted>, Vec<Painted>) =
        painted.partition(|painted| painted.style.hidden == HiddenLines::Shown);
    // The hidden runs of a set come before its visible ones if all else is equal.
    tested.sort_by_key(Painted::layer);
    let contacts = find_contacts(&tested, drawing, steps)?;
    let cycles = in_cycles(tested.len(), &contacts);
    let order = if cycles.contains(&true) {
        tested = split(tested, &cycles, &contacts);
        let contacts = find_contacts(&tested, drawing, steps)?;
        back_to_front(tested.len(), &contacts)
    } else {
        back_to_front(tested.len(), &contacts)
    };
    let mut tested: Vec<Option<Run>> = tested.into_iter().map(|painted| Some(painted.run)).collect();
    let sorted = order.into_iter().filter_map(|k| tested[k].take());
    Ok(sorted.chain(on_top.into_iter().map(|painted| painted.run)).collect())
}

/// A run with the style in which it is painted.
#[derive(Clone)]
struct Painted {
    run: Run,
    style: LineStyle,
}

impl Painted {
    /// Runs of one layer have one colour, so their order changes nothing.
    fn layer(&self) -> (usize, Occlusion) {
        (self.run.set, self.run.behind)
    }
}

/// A place where two runs touch.
#[derive(Clone, Copy, Debug)]
struct Contact {
    /// The runs, the earlier one first.
    runs: [usize; 2],
    /// The place along each of them, in pixels from its first point.
    arcs: [f64; 2],
    /// The distance of their middle lines there.
    gap: f64,
    /// The second one is over the first.
    second_is_over: bool,
}

impl Contact {
    /// The run below, and the one over it.
    fn below_and_over(&self) -> [usize; 2] {
        let [first, second] = self.runs;
        if self.second_is_over { [first, second] } else { [second, first] }
    }
}

/// A segment of a run, or its arrow head.
struct Segment {
    run: usize,
    layer: (usize, Occlusion),
    from: [f64; 3],
    along: [f64; 3],
    /// Its beginning along the run.
    arc: f64,
    length: f64,
    radius: f64,
    /// The width by which the rule compares strokes.
    width: f32,
}

impl Segment {
    fn at(&self, t: f64) -> [f64; 3] {
        std::array::from_fn(|k| self.from[k] + t * self.along[k])
    }

    /// The input to the rule of the order, if its middle line has this depth.
    fn point(&self, depth: f64) -> StrokePoint {
        let reach = stroke_reach(single(self.radius), single(self.along[2]), single(self.length));
        StrokePoint { depth: single(depth), reach, visible: self.layer.1 != Occlusion::Opaque, width: self.width }
    }

    /// The share of the way at which it is nearest to a point.
    fn nearest_to(&self, p: [f64; 3]) -> f64 {
        let square = self.length * self.length;
        let along = (p[0] - self.from[0]) * self.along[0] + (p[1] - self.from[1]) * self.along[1];
        if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The places where two segments are nearest to each other on the picture, as shares of their lengths. For parallel
    /// segments, the middle of their common stretch.
    fn nearest(&self, other: &Self) -> [f64; 2] {
        let (d, e) = (self.along, other.along);
        let w = [other.from[0] - self.from[0], other.from[1] - self.from[1]];
        let cross = d[0] * e[1] - d[1] * e[0];
        if cross.abs() > 1e-9 * self.length * other.length {
            let s = (w[0] * e[1] - w[1] * e[0]) / cross;
            let t = (w[0] * d[1] - w[1] * d[0]) / cross;
            if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
                return [s, t];
            }
        }
        let ends = [
            [0.0, other.nearest_to(self.at(0.0))],
            [1.0, other.nearest_to(self.at(1.0))],
            [self.nearest_to(other.at(0.0)), 0.0],
            [self.nearest_to(other.at(1.0)), 1.0],
        ];
        let gaps = ends.map(|[s, t]| distance(self.at(s), other.at(t)));
        let least = gaps.into_iter().fold(f64::INFINITY, f64::min) + 1e-6;
        let nearest = ends.iter().zip(gaps).filter(|(_, gap)| *gap <= least);
        let (sum, count) =
            nearest.fold(([0.0; 2], 0.0), |(sum, n), (end, _)| ([sum[0] + end[0], sum[1] + end[1]], n + 1.0));
        sum.map(|sum| sum / count)
    }

    /// The places where it touches a segment of a later run, as shares of the lengths. There are two if the segments
    /// run along each other and one is over the other on the first part of that stretch and below it on the rest, else
    /// one. `None` if they don't touch.
    fn places(&self, later: &Self) -> [Option<[f64; 2]>; 2] {
        let nearest = self.nearest(later);
        let gap = distance(self.at(nearest[0]), later.at(nearest[1]));
        if gap > self.radius + later.radius {
            return [None, None];
        }
        let extent = extent(self.radius, later.radius) / self.length;
        let Some([from, to]) = self.beside(later).filter(|[from, to]| to - from > 2.0 * extent) else {
            return [Some(nearest), None];
        };
        let pair = |s: f64| [s, later.nearest_to(self.at(s))];
        let is_under = |s: f64| self.is_under(later, pair(s));
        let first = is_under(from);
        if first == is_under(to) {
            return [Some(nearest), None];
        }
        // Depths are affine, so there is one place where the order turns round.
        let (mut before, mut after) = (from, to);
        for _ in 0..40 {
            let middle = 0.5 * (before + after);
            *if is_under(middle) == first { &mut before } else { &mut after } = middle;
        }
        let shorter = (before - from).min(to - before);
        if 2.0 * shorter > extent {
            // Near enough for a cut between them to be where the order turns, and far enough to be two places.
            let step = shorter.min(0.75 * extent);
            [Some(pair(before - step)), Some(pair(before + step))]
        } else {
            let longer = if before - from > to - before { 0.5 * (from + before) } else { 0.5 * (before + to) };
            [Some(pair(longer)), None]
        }
    }

    /// The part of the way on which it touches another, as shares.
    fn beside(&self, other: &Self) -> Option<[f64; 2]> {
        let reach = self.radius + other.radius;
        let [ux, uy] = [other.along[0] / other.length, other.along[1] / other.length];
        let [x, y] = [self.from[0] - other.from[0], self.from[1] - other.from[1]];
        let [dx, dy] = [self.along[0], self.along[1]];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (start, change, low, high) in [
            (x * uy - y * ux, dx * uy - dy * ux, -reach, reach),
            (x * ux + y * uy, dx * ux + dy * uy, -reach, other.length + reach),
        ] {
            if change != 0.0 {
                let (a, b) = ((low - start) / change, (high - start) / change);
                (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
            } else if !(low..=high).contains(&start) {
                return None;
            }
        }
        (from < to).then_some([from, to])
    }

    /// True if a segment of a later run is over it.
    fn is_under(&self, later: &Self, [s, t]: [f64; 2]) -> bool {
        later_is_over(later.point(later.at(t)[2]), self.point(self.at(s)[2]))
    }

    /// The contact with a segment of a later run at a place, and its position on the picture.
    fn contact(&self, later: &Self, [s, t]: [f64; 2]) -> (Contact, [f64; 2]) {
        let (p, q) = (self.at(s), later.at(t));
        let contact = Contact {
            runs: [self.run, later.run],
            arcs: [self.arc + s * self.length, later.arc + t * later.length],
            gap: distance(p, q),
            second_is_over: self.is_under(later, [s, t]),
        };
        // Within the band of each, so that the squares of both know the place.
        let share = self.radius / (self.radius + later.radius).max(f64::MIN_POSITIVE);
        (contact, [p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])])
    }
}

/// Length of a contact along two strokes with these half widths.
fn extent(radius: f64, other: f64) -> f64 {
    2.0 * (radius + other)
}

fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    DVec2::new(p[0], p[1]).distance(DVec2::new(q[0], q[1]))
}

/// The segments of runs, and their arrow heads.
fn segments(all: &[Painted], drawing: &Drawing) -> Vec<Segment> {
    let mut segments = Vec::new();
    for (k, painted) in all.iter().enumerate() {
        let radius = 0.5 * f64::from(painted.style.width);
        let width = drawing.strokes[painted.run.set].style.width;
        let layer = painted.layer();
        let mut arc = 0.0;
        for pair in painted.run.points.windows(2) {
            let (from, to) = (pair[0].map(f64::from), pair[1].map(f64::from));
            let along: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
            let length = DVec2::new(along[0], along[1]).length();
            segments.push(Segment { run: k, layer, from, along, arc, length, radius, width });
            arc += length;
        }
        let Some(last) = segments.last().filter(|_| painted.style.arrow && painted.run.has_end) else { continue };
        let head = f64::from(painted.style.head_length(painted.run.start + single(arc)));
        let share = if last.length > 0.0 { (head / last.length).min(1.0) } else { 0.0 };
        if share > 0.0 {
            let (from, to) = (last.at(1.0 - share), last.at(1.0));
            let along: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
            let length = share * last.length;
            let of_head = Segment { from, along, arc: arc - length, length, radius: 0.38 * head, ..*last };
            segments.push(of_head);
        }
    }
    segments
}

/// The index of a square among those of the picture. Places beside the picture belong to those at its border.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates")]
fn square(v: f64, count: usize) -> usize {
    ((v / SQUARE).max(0.0) as usize).min(count - 1)
}

/// The contacts of runs of different layers, each place once.
fn find_contacts(all: &[Painted], drawing: &Drawing, steps: &mut WorkBudget) -> Result<Vec<Contact>, OverBudget> {
    let segments = segments(all, drawing);
    let count = |side: u32| square(f64::from(side), usize::MAX) + 1;
    let (columns, rows) = (count(drawing.width), count(drawing.height));
    let mut squares: Vec<Vec<usize>> = vec![Vec::new(); columns * rows];
    for (k, segment) in segments.iter().enumerate() {
        let mut listed = 0;
        for_squares(segment, columns, rows, |square| {
            squares[square].push(k);
            listed += LISTED;
        });
        steps.take(listed)?;
    }
    let mut found = Vec::new();
    for (index, members) in squares.iter().enumerate() {
        for (k, &first) in members.iter().enumerate() {
            steps.take(members.len() - k)?;
            for &second in &members[k + 1..] {
                let (first, second) = (&segments[first], &segments[second]);
                if first.layer == second.layer {
                    continue;
                }
                // Several squares may list both. Only the one in which they touch counts.
                let touches = first.places(second).into_iter().flatten().map(|place| first.contact(second, place));
                let here = touches.filter(|(_, [x, y])| square(*y, rows) * columns + square(*x, columns) == index);
                let before = found.len();
                found.extend(here.map(|(contact, _)| contact));
                steps.take(KEPT * (found.len() - before))?;
            }
        }
    }
    let radius: Vec<f64> = all.iter().map(|painted| 0.5 * f64::from(painted.style.width)).collect();
    Ok(one_each(found, |contact| extent(radius[contact.runs[0]], radius[contact.runs[1]])))
}

/// Calls `visit` for the squares that a segment touches with its width.
fn for_squares(segment: &Segment, columns: usize, rows: usize, mut visit: impl FnMut(usize)) {
    let reach = segment.radius + 1e-3;
    let ([x, y, _], [dx, dy, _]) = (segment.from, segment.along);
    let range = |a: f64, b: f64, count: usize| square(a.min(b) - reach, count)..=square(a.max(b) + reach, count);
    for column in range(x, x + dx, columns) {
        // The rows that it passes in this column. Parts beside the picture are in the columns at its border.
        let share = |border: f64| if dx == 0.0 { 0.0 } else { (border - x) / dx };
        let left = if column == 0 { x.min(x + dx) } else { column as f64 * SQUARE - reach };
        let right = if column + 1 == columns { x.max(x + dx) } else { (column + 1) as f64 * SQUARE + reach };
        let (t0, t1) = if dx == 0.0 { (0.0, 1.0) } else { (share(left), share(right)) };
        let (t0, t1) = (t0.min(t1).clamp(0.0, 1.0), t0.max(t1).clamp(0.0, 1.0));
        for row in range(y + t0 * dy, y + t1 * dy, rows) {
            visit(row * columns + column);
        }
    }
}

/// Keeps, of the contacts of two runs at one place (joints of segments), the one where they are nearest to each other.
/// `extent` is how far along the runs a place goes.
fn one_each(mut found: Vec<Contact>, extent: impl Fn(&Contact) -> f64) -> Vec<Contact> {
    found.sort_by(|a, b| a.runs.cmp(&b.runs).then(a.arcs[0].total_cmp(&b.arcs[0])));
    let mut places: Vec<Contact> = Vec::new();
    let mut begins = [0.0; 2];
    for contact in found {
        let extent = extent(&contact);
        match places
            .last_mut()
            .filter(|last| last.runs == contact.runs && (0..2).all(|k| (contact.arcs[k] - begins[k]).abs() <= extent))
        {
            Some(last) if contact.gap < last.gap => *last = contact,
            Some(_) => {}
            None => {
                begins = contact.arcs;
                places.push(contact);
            }
        }
    }
    places
}

/// The runs over each run, and the number of runs that it is over.
fn neighbours(count: usize, pairs: impl Iterator<Item = [usize; 2]>) -> (Vec<Vec<usize>>, Vec<usize>) {
    let (mut next, mut before) = (vec![Vec::new(); count], vec![0; count]);
    for [from, to] in pairs {
        next[from].push(to);
        before[to] += 1;
    }
    (next, before)
}

/// The runs that lie over one another in a cycle, or between two cycles.
fn in_cycles(count: usize, contacts: &[Contact]) -> Vec<bool> {
    let mut left = vec![true; count];
    let up = contacts.iter().map(Contact::below_and_over);
    let down = up.clone().map(|[below, over]| [over, below]);
    for (next, mut before) in [neighbours(count, up), neighbours(count, down)] {
        let mut free: Vec<usize> = (0..count).filter(|&k| before[k] == 0).collect();
        while let Some(k) = free.pop() {
            left[k] = false;
            for &n in &next[k] {
                before[n] -= 1;
                if before[n] == 0 {
                    free.push(n);
                }
            }
        }
    }
    left
}

/// Sorts each run after all runs that it's over. If that leaves a choice, or no run to begin with, the order of the
/// drawing decides.
fn back_to_front(count: usize, contacts: &[Contact]) -> Vec<usize> {
    let (next, mut before) = neighbours(count, contacts.iter().map(Contact::below_and_over));
    let mut free: BinaryHeap<Reverse<usize>> = (0..count).filter(|&k| before[k] == 0).map(Reverse).collect();
    let mut order = Vec::with_capacity(count);
    let mut done = vec![false; count];
    let mut rest = 0..count;
    while let Some(k) = free.pop().map(|Reverse(k)| k).or_else(|| rest.find(|&k| !done[k])) {
        if std::mem::replace(&mut done[k], true) {
            continue;
        }
        order.push(k);
        for &n in &next[k] {
            before[n] -= 1;
            if before[n] == 0 {
                free.push(Reverse(n));
            }
        }
    }
    order
}

/// Splits the runs of cycles half way between the places where they touch one another.
fn split(all: Vec<Painted>, cycles: &[bool], contacts: &[Contact]) -> Vec<Painted> {
    let mut arcs: Vec<Vec<f64>> = vec![Vec::new(); all.len()];
    for contact in contacts.iter().filter(|contact| contact.runs.iter().all(|&run| cycles[run])) {
        for (run, arc) in contact.runs.into_iter().zip(contact.arcs) {
            arcs[run].push(arc);
        }
    }
    let mut parts = Vec::new();
    for (painted, mut arcs) in all.into_iter().zip(arcs) {
        arcs.sort_by(f64::total_cmp);
        let apart = f64::from(painted.style.width);
        let between = arcs.windows(2).filter(|pair| pair[1] - pair[0] > apart).map(|pair| 0.5 * (pair[0] + pair[1]));
        let cuts: Vec<f64> = between.collect();
        parts.extend(pieces(&painted.run, &cuts).into_iter().map(|run| Painted { run, ..painted.clone() }));
    }
    parts
}

/// A run, cut at distances from its first point, which grow.
fn pieces(run: &Run, cuts: &[f64]) -> Vec<Run> {
    let mut done = Vec::new();
    let mut piece = Run { points: run.points.iter().take(1).copied().collect(), ..run.clone() };
    let mut cuts = cuts.iter().copied().peekable();
    let mut arc = 0.0;
    for pair in run.points.windows(2) {
        let (from, to) = (pair[0].map(f64::from), pair[1].map(f64::from));
        let length = distance(from, to);
        let inside = |cut: f64, Range { start, end }: Range<f64>| start < cut && cut < end;
        while let Some(cut) = cuts.next_if(|&cut| inside(cut, arc..arc + length)) {
            let t = (cut - arc) / length;
            let point: [f32; 3] = std::array::from_fn(|k| single(from[k] + t * (to[k] - from[k])));
            piece.points.push(point);
            let next = Run { points: vec![point], start: run.start + single(cut), ..run.clone() };
            done.push(Run { has_end: false, ..std::mem::replace(&mut piece, next) });
        }
        // A cut on a corner is left out, because it would be in no segment.
        while cuts.next_if(|&cut| cut <= arc + length).is_some() {}
        piece.points.push(pair[1]);
        arc += length;
    }
    done.push(piece);
    done
}

#[cfg(test)]
mod tests;
