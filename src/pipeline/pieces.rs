//! Faces that may be split, and the points at which splitting has cut their sides.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU32, Ordering};

use glam::DVec3;

use super::resample::{OWN_WEIGHTS, VertexOrigin};
use crate::drawing::Surface;

/// A surface with the data for sorting it.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// As it was shaded.
    pub(super) surface: Surface,
    /// Its vertices in view space.
    pub(super) view: Vec<DVec3>,
    /// No face of it can hide another: front faces of something convex.
    pub(super) never_hides_itself: bool,
}

/// A face or a piece of one: convex, plane. Its corners are in [`Corners`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The place of its first corner.
    pub(super) first: usize,
    /// Number of its corners.
    pub(super) count: u32,
    pub(super) layer: u32,
    pub(super) triangle: u32,
    /// The place of its plane, as soon as that is known; [`u32::MAX`] before.
    pub(super) plane: u32,
}

impl Piece {
    pub(super) fn layer(&self) -> usize {
        self.layer as usize
    }
}

/// A corner, apart from its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Share of each corner of the whole face.
    pub(super) weights: [f64; 3],
    /// A corner of the whole face.
    pub(super) original: bool,
    /// The line that the side from here to the next corner lies on.
    pub(super) side: u32,
}

impl Corner {
    /// Its origin, if these are the vertices of the whole face.
    pub(super) fn origin(&self, of: [u32; 3]) -> VertexOrigin {
        match self.weights.iter().position(|&weight| self.original && weight == 1.0) {
            Some(own) => VertexOrigin::Vertex(of[own]),
            None => VertexOrigin::Between { of, weights: self.weights },
        }
    }
}

/// The corners of pieces, one after the other: their places in view space, of which trees are made, apart.
#[derive(Clone, Debug, Default)]
pub(super) struct Corners {
    pub(super) views: Vec<DVec3>,
    pub(super) rest: Vec<Corner>,
}

impl Corners {
    /// The places of the corners of a piece.
    #[inline(always)]
    pub(super) fn of(&self, piece: &Piece) -> &[DVec3] {
        &self.views[piece.first..piece.first + piece.count as usize]
    }

    /// All that is known of them.
    pub(super) fn whole(&self, piece: &Piece) -> (&[DVec3], &[Corner]) {
        let all = piece.first..piece.first + piece.count as usize;
        (&self.views[all.clone()], &self.rest[all])
    }

    /// Adds a piece that is a part of another.
    pub(super) fn add(&mut self, part_of: &Piece, corners: &[(DVec3, Corner)]) -> Piece {
        let first = self.views.len();
        self.views.extend(corners.iter().map(|(view, _)| *view));
        self.rest.extend(corners.iter().map(|(_, rest)| *rest));
        Piece { first, count: to_u32(corners.len()), plane: u32::MAX, ..*part_of }
    }

    /// The corners of some pieces alone; the pieces become those of the result.
    pub(super) fn extracted(&self, pieces: &mut [Piece]) -> Self {
        let count = pieces.iter().map(|piece| piece.count as usize).sum();
        let mut found = Self { views: Vec::with_capacity(count), rest: Vec::with_capacity(count) };
        for piece in pieces {
            let (views, rest) = self.whole(piece);
            piece.first = found.views.len();
            piece.plane = u32::MAX;
            found.views.extend_from_slice(views);
            found.rest.extend_from_slice(rest);
        }
        found
    }
}

/// All faces, unsplit, in the order of the layers, with their corners, in memory that is no longer needed; and the
/// number of their sides.
pub(super) fn pieces(layers: &[Layer], (mut all, mut corners): (Vec<Piece>, Corners)) -> (Vec<Piece>, Corners, u32) {
    let faces = layers.iter().map(|layer| layer.surface.triangles.len()).sum();
    all.clear();
    all.reserve(faces);
    corners.views.clear();
    corners.views.reserve(3 * faces);
    corners.rest.clear();
    corners.rest.reserve(3 * faces);
    let mut ends = Vec::with_capacity(3 * faces);
    let mut known: HashMap<[u64; 3], u32> = HashMap::with_capacity(layers.iter().map(|layer| layer.view.len()).sum());
    for (layer, of) in (0_u32..).zip(layers) {
        // Points with the same coordinates are one.
        let number = |p: &DVec3| {
            let next = to_u32(known.len());
            *known.entry(p.to_array().map(f64::to_bits)).or_insert(next)
        };
        let points: Vec<u32> = of.view.iter().map(number).collect();
        for (triangle, vertices) in (0_u32..).zip(&of.surface.triangles) {
            all.push(Piece { first: corners.views.len(), count: 3, layer, triangle, plane: u32::MAX });
            for k in 0..3 {
                let [from, to] = [vertices[k], vertices[(k + 1) % 3]].map(|i| points[i as usize]);
                ends.push([from.min(to), from.max(to)]);
                corners.views.push(of.view[vertices[k] as usize]);
                corners.rest.push(Corner { weights: OWN_WEIGHTS[k], original: true, side: 0 });
            }
        }
    }
    let sides = number_sides(&ends, known.len(), |corner, side| corners.rest[corner].side = side);
    (all, corners, sides)
}

/// Gives each side a number, the same one to all with the same two ends, the lesser first; there are so many `points`.
/// Returns how many numbers were given.
fn number_sides(ends: &[[u32; 2]], points: usize, mut give: impl FnMut(usize, u32)) -> u32 {
    // Sides by their first ends: counts are summed up, and the beginnings move on while they are filled.
    let mut first = vec![0_usize; points + 2];
    ends.iter().for_each(|[a, _]| first[*a as usize + 2] += 1);
    for k in 2..first.len() {
        first[k] += first[k - 1];
    }
    let mut sorted = vec![(0_u32, 0_usize); ends.len()];
    for (side, [a, b]) in ends.iter().enumerate() {
        let next = &mut first[*a as usize + 1];
        sorted[*next] = (*b, side);
        *next += 1;
    }
    let mut count = 0;
    for at in first.windows(2).take(points) {
        let of_point = &mut sorted[at[0]..at[1]];
        of_point.sort_unstable();
        for same in of_point.chunk_by(|(b, _), (c, _)| b == c) {
            same.iter().for_each(|(_, side)| give(*side, count));
            count += 1;
        }
    }
    count
}

/// Numbers for the sides that splitting makes.
#[derive(Debug)]
pub(super) struct NewSides(AtomicU32);

impl NewSides {
    /// After those of the faces.
    pub(super) fn after(known: u32) -> Self {
        Self(AtomicU32::new(known))
    }

    pub(super) fn next(&self) -> u32 {
        self.0.fetch_add(1, Ordering::Relaxed)
    }

    /// Number of all sides.
    pub(super) fn count(&self) -> u32 {
        self.0.load(Ordering::Relaxed)
    }
}

/// A point at which a face was split, and on which side that is.
pub(super) type Cut = (u32, DVec3);

/// The points at which any face was split, by sides. A face keeps its neighbour's points in its own border: both sides
/// of the border have the same corners on the grid of the image, and no gap opens between them.
#[derive(Debug)]
pub(super) struct Cuts {
    /// Where those of each side begin; one more is the end.
    first: Vec<u32>,
    points: Vec<DVec3>,
}

impl Cuts {
    /// Sorts cuts by their sides, of which there are `sides`.
    pub(super) fn new(sides: u32, cuts: &[&[Cut]]) -> Self {
        let mut first = vec![0_u32; sides as usize + 2];
        let all = || cuts.iter().copied().flatten();
        // Each begins where the one before ends: counts are summed up, and beginnings move on while they are filled.
        all().for_each(|(side, _)| first[*side as usize + 2] += 1);
        for k in 2..first.len() {
            first[k] += first[k - 1];
        }
        let mut points = vec![DVec3::ZERO; all().count()];
        for &(side, point) in all() {
            let next = &mut first[side as usize + 1];
            points[*next as usize] = point;
            *next += 1;
        }
        Self { first, points }
    }

    fn on(&self, side: u32) -> &[DVec3] {
        let side = side as usize;
        &self.points[self.first[side] as usize..self.first[side + 1] as usize]
    }

    /// Adds all corners of a piece, with those that its neighbours' pieces have in its border.
    pub(super) fn complete(&self, (views, rest): (&[DVec3], &[Corner]), all: &mut Vec<(DVec3, Corner)>) {
        for (i, (&from, corner)) in views.iter().zip(rest).enumerate() {
            all.push((from, *corner));
            let on_side = self.on(corner.side);
            if on_side.is_empty() {
                continue;
            }
            let next = (i + 1) % views.len();
            let along = views[next] - from;
            let length = along.length_squared();
            let cuts = on_side.iter().filter(|&&p| p != from && p != views[next]);
            // Most are on other parts of the side.
            let cuts = cuts.map(|&p| ((p - from).dot(along), p)).filter(|(t, _)| *t > 0.0 && *t < length);
            let cuts = cuts.map(|(t, p)| (t / length, p)).filter(|(t, _)| *t > 0.0);
            let mut cuts: Vec<(f64, DVec3)> = cuts.collect();
            cuts.sort_by(|p, q| p.0.total_cmp(&q.0));
            cuts.dedup_by_key(|cut| cut.1);
            let mean = |t: f64| std::array::from_fn(|k| corner.weights[k] * (1.0 - t) + rest[next].weights[k] * t);
            let between = |t: f64| Corner { weights: mean(t), original: false, side: corner.side };
            all.extend(cuts.iter().map(|&(t, view)| (view, between(t))));
        }
    }
}

/// Corners and pieces are counted with 32 bits.
pub(super) fn to_u32(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}
