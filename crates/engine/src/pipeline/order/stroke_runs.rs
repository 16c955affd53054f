//! The visible, the dimmed and the hidden runs of strokes, for outputs that have no depth buffer.
//!
//! A raster asks its depth buffer pixel by pixel. Here each segment of a stroke is compared with each triangle that it
//! passes. Both are straight on the picture, and so are their depths (see [`drawing`](crate::drawing)). So a triangle
//! hides a segment between two points, which are found without steps (the quantitative invisibility of Appel 1967, one
//! face at a time).

use std::ops::Range;

use glam::DVec2;

use crate::appearance::{HiddenLines, LineStyle, Occlusion};
use crate::drawing::order::on_a_face;
use crate::drawing::{Drawing, StrokeSet, Surface, single};
use crate::limits::MAX_STROKE_STEPS;
use crate::pipeline::budget::OverBudget;

/// A part of a polyline that is behind the same faces throughout.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The index of its set in the drawing's `strokes`.
    pub set: usize,
    /// The index of its polyline in the set.
    pub polyline: usize,
    /// x, y in pixels and depth. Two or more.
    pub points: Vec<[f32; 3]>,
    /// Pixels along the polyline from its first point, so that dashes continue from one run to the next.
    pub start: f32,
    /// The faces in front of it.
    pub behind: Occlusion,
    /// It ends with the polyline, and has its arrow head.
    pub has_end: bool,
}

impl Run {
    /// Its painted style; `None` means not painted.
    pub fn style(&self, drawing: &Drawing) -> Option<LineStyle> {
        drawing.strokes.get(self.set)?.style.behind(self.behind)
    }
}

/// Splits the strokes of a drawing into runs, in its order. [`painted_runs`](super::stroke_order::painted_runs) returns
/// them in the order of painting.
///
/// *Guarantees*: the runs of a polyline follow one another and make it up. A stroke on a face is visible. A stroke that
/// is [`Shown`](HiddenLines::Shown) although hidden is one visible run.
///
/// # Errors
/// [`OverBudget::Strokes`].
pub fn stroke_runs(drawing: &Drawing) -> Result<Vec<Run>, OverBudget> {
    runs_within(drawing, &mut WorkBudget::default())
}

pub(crate) fn runs_within(drawing: &Drawing, steps: &mut WorkBudget) -> Result<Vec<Run>, OverBudget> {
    let faces = HidingFaces::new(drawing, steps)?;
    let mut runs = Vec::new();
    for (set, strokes) in drawing.strokes.iter().enumerate() {
        for polyline in 0..strokes.polylines.len() {
            let Some(points) = points(strokes, polyline) else { continue };
            let hides = strokes.style.hidden != HiddenLines::Shown;
            split(points, if hides { Some(&faces) } else { None }, steps, |part| {
                runs.push(Run { set, polyline, ..part });
            })?;
        }
    }
    Ok(runs)
}

/// The number of steps that may still be taken.
pub(crate) struct WorkBudget(usize);

impl Default for WorkBudget {
    fn default() -> Self {
        Self(MAX_STROKE_STEPS)
    }
}

impl WorkBudget {
    pub(crate) fn take(&mut self, steps: usize) -> Result<(), OverBudget> {
        self.0 = self.0.checked_sub(steps).ok_or(OverBudget::Strokes)?;
        Ok(())
    }

    /// A small budget, for tests.
    #[cfg(test)]
    pub(crate) fn few(steps: usize) -> Self {
        Self(steps)
    }
}

/// Steps for an entry of a square, a run, or a contact.
pub(crate) const LISTED: usize = 8;
pub(crate) const KEPT: usize = 64;

/// The faces in front of places in a drawing. Labels behind opaque ones are painted faintly if they say so, and marks
/// behind any.
///
/// # Errors
/// [`OverBudget::Strokes`].
pub fn occlusions(drawing: &Drawing, places: impl IntoIterator<Item = [f32; 3]>) -> Result<Vec<Occlusion>, OverBudget> {
    let faces = HidingFaces::new(drawing, &mut WorkBudget::default())?;
    Ok(places.into_iter().map(|place| faces.before(place.map(f64::from))).collect())
}

fn points(strokes: &StrokeSet, polyline: usize) -> Option<&[[f32; 3]]> {
    let Range { start, end } = strokes.polylines.get(polyline)?.clone();
    let points = strokes.points.get(start as usize..end as usize)?;
    (points.len() >= 2 && points.iter().flatten().all(|v| v.is_finite())).then_some(points)
}

/// Parts of a stroke shorter than this (pixels) are rounding and go with the part before them.
const SHORTEST: f64 = 0.02;

/// Calls `found` for each run of a polyline. Its set and its index are left to the caller.
fn split(
    points: &[[f32; 3]],
    faces: Option<&HidingFaces>,
    steps: &mut WorkBudget,
    mut found: impl FnMut(Run),
) -> Result<(), OverBudget> {
    let mut run: Option<Run> = None;
    let mut arc = 0.0;
    let (mut hidden, mut dimmed) = (Vec::new(), Vec::new());
    for pair in points.windows(2) {
        let segment = Segment::new(pair[0], pair[1]);
        hidden.clear();
        dimmed.clear();
        if let Some(faces) = faces {
            faces.opaque.hidden_parts(&segment, steps, &mut hidden)?;
            faces.tints.hidden_parts(&segment, steps, &mut dimmed)?;
        }
        steps.take(KEPT * (1 + hidden.len() + dimmed.len()))?;
        let part = |(range, behind): (Range<f64>, Occlusion)| {
            let ends = [segment.at(range.start), segment.at(range.end)];
            match run.as_mut().filter(|run| run.behind == behind) {
                Some(run) => run.points.push(ends[1]),
                None => {
                    let start = single(arc + range.start * segment.length);
                    let next = Run { set: 0, polyline: 0, points: ends.to_vec(), start, behind, has_end: false };
                    if let Some(done) = run.replace(next) {
                        found(done);
                    }
                }
            }
        };
        parts(&hidden, &dimmed).into_iter().for_each(part);
        arc += segment.length;
    }
    if let Some(last) = run {
        found(Run { has_end: true, ..last });
    }
    Ok(())
}

/// The parts of a segment behind opaque faces, and those behind tints alone, as shares of the way.
fn parts(hidden: &[Range<f64>], dimmed: &[Range<f64>]) -> Vec<(Range<f64>, Occlusion)> {
    let mut parts = Vec::with_capacity(2 * (hidden.len() + dimmed.len()) + 1);
    let mut from = 0.0;
    for range in hidden.iter().cloned().chain([1.0..1.0]) {
        for tint in dimmed {
            let tint = tint.start.max(from)..tint.end.min(range.start);
            if tint.start < tint.end {
                parts.push((from..tint.start, Occlusion::None));
                from = tint.end;
                parts.push((tint, Occlusion::Translucent));
            }
        }
        parts.push((from..range.start, Occlusion::None));
        from = range.end;
        parts.push((range, Occlusion::Opaque));
    }
    parts.retain(|(range, _)| range.start < range.end);
    parts
}

/// From one point of a polyline to the next.
struct Segment {
    from: [f64; 3],
    along: [f64; 3],
    length: f64,
}

impl Segment {
    fn new(from: [f32; 3], to: [f32; 3]) -> Self {
        let (from, to) = (from.map(f64::from), to.map(f64::from));
        let along = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        Self { from, along, length: DVec2::new(along[0], along[1]).length() }
    }

    /// The point at a share of the way.
    fn at(&self, t: f64) -> [f32; 3] {
        std::array::from_fn(|k| single(self.from[k] + t * self.along[k]))
    }
}

/// The faces in front of which a stroke may be hidden or dimmed.
struct HidingFaces {
    opaque: Faces,
    tints: Faces,
}

impl HidingFaces {
    fn new(drawing: &Drawing, steps: &mut WorkBudget) -> Result<Self, OverBudget> {
        // A surface that leaves no depth hides nothing, as in a depth buffer.
        let hiding = drawing.surfaces.iter().filter(|s| s.depth_test && !s.translucent);
        let opaque = hiding.flat_map(|s| s.triangles.iter().map(move |&triangle| (s, triangle)));
        let tints = drawing.surfaces.iter().flat_map(|s| s.tints().map(move |triangle| (s, triangle)));
        Ok(Self { opaque: Faces::new(drawing, opaque, steps)?, tints: Faces::new(drawing, tints, steps)? })
    }

    /// The faces in front of a place.
    fn before(&self, place: [f64; 3]) -> Occlusion {
        if self.opaque.hide(place) {
            Occlusion::Opaque
        } else if self.tints.hide(place) {
            Occlusion::Translucent
        } else {
            Occlusion::None
        }
    }
}

/// A triangle of the picture.
struct HidingFace {
    /// Its edges as lines a·x + b·y + c, positive inside.
    edges: [[f64; 3]; 3],
    /// Depth = dx·x + dy·y + c.
    depth: [f64; 3],
}

/// Faces that are compared with strokes, by the squares of the picture that they touch.
struct Faces {
    faces: Vec<HidingFace>,
    columns: usize,
    rows: usize,
    squares: Vec<Vec<u32>>,
}

/// The side of a square in pixels.
pub(crate) const SQUARE: f64 = 32.0;

/// Number of squares along a side of the picture, including one for places on its border.
fn square_count(side: u32) -> usize {
    squares(0.0, f64::from(side), usize::MAX).len()
}

impl Faces {
    fn new<'a>(
        drawing: &Drawing,
        triangles: impl Iterator<Item = (&'a Surface, [u32; 3])>,
        steps: &mut WorkBudget,
    ) -> Result<Self, OverBudget> {
        let (columns, rows) = (square_count(drawing.width), square_count(drawing.height));
        let mut all = Self { faces: Vec::new(), columns, rows, squares: vec![Vec::new(); columns * rows] };
        for (surface, triangle) in triangles {
            let corners = triangle.map(|i| surface.positions.get(i as usize).map(|p| p.map(f64::from)));
            if let [Some(a), Some(b), Some(c)] = corners {
                all.add([a, b, c], steps)?;
            }
        }
        Ok(all)
    }

    fn add(&mut self, [a, b, c]: [[f64; 3]; 3], steps: &mut WorkBudget) -> Result<(), OverBudget> {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        // Also for NaN.
        if !(area.abs() > 0.0 && area.is_finite()) {
            return Ok(());
        }
        let edge = |p: [f64; 3], q: [f64; 3]| {
            let [a, b] = [(p[1] - q[1]) * area.signum(), (q[0] - p[0]) * area.signum()];
            [a, b, -(a * p[0] + b * p[1])]
        };
        let dx = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
        let dy = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
        let index = u32::try_from(self.faces.len()).unwrap_or(u32::MAX);
        let least = |k: usize| a[k].min(b[k]).min(c[k]);
        let most = |k: usize| a[k].max(b[k]).max(c[k]);
        let (columns, rows) = (self.columns(least(0), most(0)), self.rows(least(1), most(1)));
        steps.take(KEPT + LISTED * rows.len() * columns.len())?;
        for row in rows {
            for column in columns.clone() {
                self.squares[row * self.columns + column].push(index);
            }
        }
        let edges = [edge(a, b), edge(b, c), edge(c, a)];
        self.faces.push(HidingFace { edges, depth: [dx, dy, a[2] - dx * a[0] - dy * a[1]] });
        Ok(())
    }

    fn columns(&self, from: f64, to: f64) -> Range<usize> {
        squares(from, to, self.columns)
    }

    fn rows(&self, from: f64, to: f64) -> Range<usize> {
        squares(from, to, self.rows)
    }

    /// True if any face is before a place.
    fn hide(&self, place: [f64; 3]) -> bool {
        let [x, y, _] = place;
        self.rows(y, y).any(|row| {
            self.columns(x, x).any(|column| {
                self.squares[row * self.columns + column].iter().any(|&k| self.faces[k as usize].is_before(place))
            })
        })
    }

    /// The parts of a segment that faces hide, as shares of the way, in order and apart from one another.
    fn hidden_parts(
        &self,
        segment: &Segment,
        steps: &mut WorkBudget,
        hidden: &mut Vec<Range<f64>>,
    ) -> Result<(), OverBudget> {
        if self.faces.is_empty() {
            return Ok(());
        }
        let [x, y, _] = segment.from;
        let [dx, dy, _] = segment.along;
        let mut near: Vec<u32> = Vec::new();
        for column in self.columns(x.min(x + dx), x.max(x + dx)) {
            // The rows that the segment passes in this column.
            let share = |edge: usize| if dx == 0.0 { 0.0 } else { (edge as f64 * SQUARE - x) / dx };
            let (t0, t1) = if dx == 0.0 { (0.0, 1.0) } else { (share(column), share(column + 1)) };
            let (t0, t1) = (t0.min(t1).max(0.0), t0.max(t1).min(1.0));
            let (y0, y1) = (y + t0 * dy, y + t1 * dy);
            // A little more, for rounding.
            for row in self.rows(y0.min(y1) - 1e-3, y0.max(y1) + 1e-3) {
                let square = &self.squares[row * self.columns + column];
                steps.take(1 + square.len())?;
                near.extend_from_slice(square);
            }
        }
        near.sort_unstable();
        near.dedup();
        let mut parts: Vec<Range<f64>> = near.iter().filter_map(|&k| self.faces[k as usize].hides(segment)).collect();
        parts.sort_by(|a, b| a.start.total_cmp(&b.start));
        let shortest = SHORTEST / segment.length.max(SHORTEST);
        for part in parts {
            match hidden.last_mut() {
                // Faces that share an edge hide without a gap.
                Some(last) if part.start <= last.end + shortest => last.end = last.end.max(part.end),
                _ => hidden.push(part),
            }
        }
        hidden.retain(|part| part.end - part.start >= shortest);
        if let Some(first) = hidden.first_mut().filter(|first| first.start < shortest) {
            first.start = 0.0;
        }
        if let Some(last) = hidden.last_mut().filter(|last| last.end > 1.0 - shortest) {
            last.end = 1.0;
        }
        Ok(())
    }
}

/// The squares of a row of `count` that lie between two places, in pixels.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates, and the end is held to the count")]
fn squares(from: f64, to: f64, count: usize) -> Range<usize> {
    let first = (from / SQUARE).floor().max(0.0) as usize;
    let end = ((to / SQUARE).floor().max(-1.0) + 1.0) as usize;
    first.min(count)..end.min(count)
}

/// Distance of a face's border outside the face, in pixels (negative: outside).
const BORDER: f64 = -1e-6;

impl HidingFace {
    /// The part of a segment that lies behind the face; `None` if no part does.
    fn hides(&self, segment: &Segment) -> Option<Range<f64>> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        // The part of the segment in which a linear function with this start and change is positive.
        let mut keep = |start: f64, change: f64, least: f64| {
            let zero = -start / change;
            if change > 0.0 {
                from = from.max(zero);
            } else if change < 0.0 {
                to = to.min(zero);
            } else if start <= least {
                to = f64::NEG_INFINITY;
            }
        };
        let ([x, y, _], [dx, dy, dz]) = (segment.from, segment.along);
        for [a, b, c] in self.edges {
            // Both hide along the border that two faces may share, because neither would otherwise.
            keep(a * x + b * y + c, a * dx + b * dy, BORDER * DVec2::new(a, b).length());
        }
        let [px, py, _] = self.depth;
        keep(self.nearer_by(segment.from), px * dx + py * dy - dz, 0.0);
        (from < to).then_some(from..to)
    }

    /// How much nearer than a place its plane is, less the rounding.
    fn nearer_by(&self, [x, y, z]: [f64; 3]) -> f64 {
        let [px, py, c] = self.depth;
        px * x + py * y + c - z - f64::from(on_a_face(single(z), [single(px), single(py)]))
    }

    /// True if it is before a place. Also on its border, which two faces may share.
    fn is_before(&self, place: [f64; 3]) -> bool {
        let [x, y, _] = place;
        let inside = |[a, b, c]: [f64; 3]| a * x + b * y + c >= BORDER * DVec2::new(a, b).length();
        self.edges.into_iter().all(inside) && self.nearer_by(place) > 0.0
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::appearance::{Dash, Rgba, Samples};

    const WALL: [[f32; 3]; 4] = [[20.0, 10.0, 0.5], [60.0, 10.0, 0.5], [60.0, 50.0, 0.5], [20.0, 50.0, 0.5]];

    fn drawing(points: &[[f32; 3]], hidden: HiddenLines) -> Drawing {
        let style = LineStyle { color: Rgba::rgb(0, 0, 0), width: 1.0, dash: Dash::Solid, hidden, arrow: false };
        Drawing {
            width: 100,
            height: 70,
            background: Rgba::rgb(255, 255, 255),
            antialias: Samples::One,
            painted_in_order: false,
            depth_format: Default::default(),
            fine_grid: false,
            order: Default::default(),
            surfaces: vec![Surface::solid(WALL.to_vec(), vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(200, 200, 200))],
            strokes: vec![StrokeSet::line(points.to_vec(), style)],
            areas: Vec::new(),
            marks: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// Start and end of each run on the x axis, and whether it is visible.
    fn found(points: &[[f32; 3]]) -> Vec<(f32, f32, bool)> {
        let runs = stroke_runs(&drawing(points, HiddenLines::Dashed)).unwrap();
        let x = |p: Option<&[f32; 3]>| p.map_or(f32::NAN, |p| (p[0] * 1000.0).round() / 1000.0);
        runs.iter().map(|run| (x(run.points.first()), x(run.points.last()), run.behind == Occlusion::None)).collect()
    }

    #[test]
    fn a_line_behind_a_wall_is_hidden_between_its_borders() {
        let behind = [[0.0, 30.0, 0.2], [90.0, 30.0, 0.2]];
        assert_eq!(found(&behind), [(0.0, 20.0, true), (20.0, 60.0, false), (60.0, 90.0, true)]);
        let runs = stroke_runs(&drawing(&behind, HiddenLines::Dashed)).unwrap();
        assert_eq!(runs.iter().map(|run| run.start.round()).collect::<Vec<_>>(), [0.0, 20.0, 60.0]);
        assert_eq!(runs.iter().map(|run| run.has_end).collect::<Vec<_>>(), [false, false, true]);
    }

    #[test]
    fn a_line_through_a_wall_is_hidden_from_where_it_enters() {
        // Its depth is that of the wall, 0.5, half way; within the tolerance of equal depths.
        let [(_, entry, before), (_, leaving, behind), (_, _, beyond)] =
            found(&[[0.0, 30.0, 0.9], [80.0, 30.0, 0.1]])[..]
        else {
            panic!("three runs");
        };
        assert!((before, behind, beyond) == (true, false, true) && (entry - 40.0).abs() < 0.02 && leaving == 60.0);
    }

    #[test]
    fn a_line_on_a_face_or_before_it_is_visible() {
        for depth in [0.5, 0.7] {
            assert_eq!(found(&[[0.0, 30.0, depth], [90.0, 30.0, depth]]), [(0.0, 90.0, true)]);
        }
        // Along the diagonal, where the two triangles of the wall meet, in it and behind it.
        assert_eq!(found(&[[20.0, 10.0, 0.2], [60.0, 50.0, 0.2]]), [(20.0, 60.0, false)]);
        assert_eq!(found(&[[20.0, 10.0, 0.5], [60.0, 50.0, 0.5]]), [(20.0, 60.0, true)]);
    }

    #[test]
    fn runs_go_on_round_corners_and_make_up_the_line() {
        let line = [[0.0, 30.0, 0.2], [40.0, 30.0, 0.2], [40.0, 60.0, 0.2], [40.0, 65.0, 0.2]];
        let runs = stroke_runs(&drawing(&line, HiddenLines::Hidden)).unwrap();
        assert_eq!(runs.iter().map(|run| run.points.len()).collect::<Vec<_>>(), [2, 3, 3]);
        let joined = runs.windows(2).all(|pair| pair[0].points.last() == pair[1].points.first());
        assert!(joined && runs.iter().map(|run| run.behind == Occlusion::None).eq([true, false, true]));
        assert_eq!(runs[1].points.last(), Some(&[40.0, 50.0, 0.2]));
    }

    #[test]
    fn a_place_is_hidden_behind_a_face_and_behind_the_border_of_two() {
        let drawing = drawing(&[], HiddenLines::Hidden);
        // Inside a triangle, on the diagonal, on the wall, in front of it, beside it, outside the picture.
        let places = [
            [50.0, 20.0, 0.2],
            [40.0, 30.0, 0.2],
            [40.0, 30.0, 0.5],
            [40.0, 30.0, 0.9],
            [70.0, 30.0, 0.2],
            [-400.0, 30.0, 0.2],
        ];
        let hidden = occlusions(&drawing, places).unwrap().into_iter().map(|faces| faces == Occlusion::Opaque);
        assert!(hidden.eq([true, true, false, false, false, false]));
    }

    #[test]
    fn what_is_shown_although_hidden_is_one_run() {
        let runs = stroke_runs(&drawing(&[[0.0, 30.0, 0.2], [90.0, 30.0, 0.2]], HiddenLines::Shown)).unwrap();
        assert!(runs.len() == 1 && runs[0].behind == Occlusion::None && runs[0].has_end);
    }

    #[test]
    fn what_is_not_a_number_has_no_runs() {
        assert_eq!(found(&[[0.0, f32::NAN, 0.2], [90.0, 30.0, 0.2]]), []);
        // A point, seen end on, is one run.
        assert_eq!(found(&[[30.0, 30.0, 0.9], [30.0, 30.0, 0.8]]), [(30.0, 30.0, true)]);
    }

    #[test]
    fn what_takes_too_many_steps_is_given_up() {
        let drawing = drawing(&[[0.0, 30.0, 0.2], [90.0, 30.0, 0.2]], HiddenLines::Hidden);
        let steps = |few| runs_within(&drawing, &mut WorkBudget::few(few)).map(|runs| runs.len());
        assert_eq!(steps(2000), Ok(3));
        // For the faces alone, and for the contacts of the stroke.
        assert_eq!([steps(100), steps(300)], [Err(OverBudget::Strokes), Err(OverBudget::Strokes)]);
    }
}
