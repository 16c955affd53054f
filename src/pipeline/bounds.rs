//! Bounds of a mesh, known before it is looked at: the box and the ball around it.

use glam::DVec3;
use rayon::prelude::*;

use super::transform::CHUNK;
use crate::geometry::Aabb;
use crate::scene::Mesh;

/// The bounds of a mesh, in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    /// The box around all finite vertices.
    pub(super) aabb: Aabb,
    /// The ball around the middle of the box that holds them all.
    pub(super) radius: f64,
    /// Every coordinate is a number.
    pub(super) finite: bool,
}

impl Bounds {
    /// `None` without a finite vertex.
    pub(super) fn of(mesh: &Mesh) -> Option<Self> {
        let stretches = || mesh.positions.par_chunks(CHUNK);
        let aabb = match mesh.positions.len() {
            0..CHUNK => mesh.bounds()?,
            _ => stretches().filter_map(|some| Aabb::around(some.iter().copied())).reduce_with(Aabb::union)?,
        };
        let middle = aabb.center();
        let farthest = |some: &[DVec3]| {
            some.iter().fold((0.0_f64, true), |(square, finite), p| {
                let distance = (*p - middle).length_squared();
                (square.max(distance), finite & distance.is_finite())
            })
        };
        let (square, finite) = match mesh.positions.len() {
            0..CHUNK => farthest(&mesh.positions),
            _ => stretches().map(farthest).reduce(|| (0.0, true), |(a, b), (c, d)| (a.max(c), b & d)),
        };
        Some(Self { aabb, radius: square.sqrt(), finite })
    }
}
