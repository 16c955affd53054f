//! Faces that may be split, and the points at which splitting has cut their sides.

use std::collections::HashMap;

use glam::DVec3;

use crate::drawing::Surface;
use crate::pipeline::mesh::resample::{OWN_WEIGHTS, VertexOrigin};

/// A surface with the data for sorting it.
#[derive(Clone, Debug)]
pub(crate) struct Layer {
    /// The surface, shaded.
    pub(crate) surface: Surface,
    /// Its vertices in view space.
    pub(crate) view: Vec<DVec3>,
    /// No face of it can hide another, as the front faces of something convex.
    pub(crate) never_hides_itself: bool,
}

/// A face or a piece of one: convex, plane.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) layer: usize,
    pub(crate) triangle: u32,
    pub(crate) corners: Vec<Corner>,
}

/// A corner of a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// View space.
    pub(crate) view: DVec3,
    /// Share of each corner of the whole face.
    pub(crate) weights: [f64; 3],
    /// A corner of the whole face.
    pub(crate) original: bool,
    /// The line that the side from here to the next corner lies on.
    pub(crate) side: usize,
}

impl Corner {
    /// Its origin, if these are the vertices of the whole face.
    pub(crate) fn origin(&self, of: [u32; 3]) -> VertexOrigin {
        match self.weights.iter().position(|&weight| self.original && weight == 1.0) {
            Some(own) => VertexOrigin::Vertex(of[own]),
            None => VertexOrigin::Between { of, weights: self.weights },
        }
    }
}

/// All faces, unsplit, in the order of the layers, and the number of their sides. Those with the same ends are one.
pub(crate) fn pieces(layers: &[Layer]) -> (Vec<Piece>, usize) {
    let mut sides: HashMap<[[u64; 3]; 2], usize> = HashMap::new();
    let mut all = Vec::new();
    for (layer, of) in layers.iter().enumerate() {
        for (triangle, vertices) in (0_u32..).zip(&of.surface.triangles) {
            let views = vertices.map(|i| of.view[i as usize]);
            let corner = |k: usize| {
                let mut ends = [views[k], views[(k + 1) % 3]].map(|p| p.to_array().map(f64::to_bits));
                ends.sort_unstable();
                let next = sides.len();
                let side = *sides.entry(ends).or_insert(next);
                Corner { view: views[k], weights: OWN_WEIGHTS[k], original: true, side }
            };
            all.push(Piece { layer, triangle, corners: (0..3).map(corner).collect() });
        }
    }
    (all, sides.len())
}

/// The points at which any face was split, by sides. A face keeps its neighbour's points in its own border. Both sides
/// of the border have the same corners on the grid of the image, and no gap opens between them.
#[derive(Debug)]
pub(crate) struct Cuts(Vec<Vec<DVec3>>);

impl Cuts {
    /// No cuts yet. The faces have this number of sides.
    pub(crate) fn new(sides: usize) -> Self {
        Self(vec![Vec::new(); sides])
    }

    /// A side that splitting makes.
    pub(crate) fn new_side(&mut self) -> usize {
        self.0.push(Vec::new());
        self.0.len() - 1
    }

    pub(crate) fn add(&mut self, side: usize, point: DVec3) {
        self.0[side].push(point);
    }

    /// All corners of a piece, with those that its neighbours' pieces have in its border.
    pub(crate) fn border(&self, corners: &[Corner]) -> Vec<Corner> {
        let mut all = Vec::with_capacity(corners.len());
        for (corner, next) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            all.push(*corner);
            let along = next.view - corner.view;
            let length = along.length_squared();
            let cuts = self.0[corner.side].iter().filter(|&&p| p != corner.view && p != next.view);
            // Most are on other parts of the side.
            let cuts = cuts.map(|&p| ((p - corner.view).dot(along), p)).filter(|(t, _)| *t > 0.0 && *t < length);
            let cuts = cuts.map(|(t, p)| (t / length, p)).filter(|(t, _)| *t > 0.0);
            let mut cuts: Vec<(f64, DVec3)> = cuts.collect();
            cuts.sort_by(|p, q| p.0.total_cmp(&q.0));
            cuts.dedup_by_key(|cut| cut.1);
            let mean = |t: f64| std::array::from_fn(|k| corner.weights[k] * (1.0 - t) + next.weights[k] * t);
            let between = |(t, view)| Corner { view, weights: mean(t), original: false, side: corner.side };
            all.extend(cuts.into_iter().map(between));
        }
        all
    }
}
