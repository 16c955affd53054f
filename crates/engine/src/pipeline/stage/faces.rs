//! The faces of one object on their way from the mesh to the drawing: the buffers that
//! [`cull_faces`](super::cull_faces::cull_faces) and [`clip`](super::clip::clip) fill.

use std::collections::HashSet;
use std::sync::atomic::{AtomicBool, Ordering};

use super::vertices::OnImage;
use crate::pipeline::mesh::resample::VertexOrigin;
use crate::pipeline::space::{NEAR, NOT_A_NUMBER, PlaneSet};

/// Vertices that are lit together. [`Faces::used`] has one entry for each such group.
pub(crate) const LANES: usize = 8;

/// A triangle that crosses planes of the volume.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// Its index in the mesh.
    pub(super) source: u32,
    pub(super) triangle: [u32; 3],
    pub(super) planes: PlaneSet,
}

/// The result of culling a chunk of triangles.
#[derive(Debug, Default)]
pub(super) struct CulledChunk {
    /// Triangles that cross a plane, for clipping.
    pub(super) crossing: Vec<Crossing>,
    /// Number of triangles that remain whole.
    pub(super) kept: usize,
    /// Number of back faces.
    pub(super) back: usize,
    /// See [`Faces::turned_over`].
    pub(super) turned_over: usize,
}

/// The remaining triangles of one object. Reuses its buffers.
#[derive(Debug, Default)]
pub(crate) struct Faces {
    /// All vertices of the mesh on the image, then the cuts.
    pub(crate) image: OnImage,
    /// Indices of vertices.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangle of the mesh that each one comes from. Empty if not requested.
    pub(crate) source: Vec<u32>,
    /// The vertices that clipping made.
    pub(crate) cuts: Vec<VertexOrigin>,
    /// For each group of [`LANES`] vertices, whether a remaining triangle uses one of them. Empty if not requested.
    pub(crate) used: Vec<AtomicBool>,
    /// Triangles that were dropped because they turn away.
    pub(crate) back: usize,
    /// Triangles whose orientation on the grid of the image differs from that in view space: thin ones, at silhouettes.
    pub(crate) turned_over: usize,
    /// A bit for each triangle of the mesh that is left and crosses no plane, the first in the lowest bit.
    pub(super) kept: Vec<u8>,
    /// The result of culling, chunk by chunk.
    pub(super) chunks: Vec<CulledChunk>,
}

impl Faces {
    /// True if the near plane cuts the object, so that its inside may be seen.
    pub(crate) fn cut_open(&self) -> bool {
        self.image.outside & NEAR != 0
    }

    /// Number of the `count` vertices that are in groups used by any remaining triangle.
    pub(crate) fn used_vertices(&self, count: usize) -> usize {
        let used = self.used.iter().enumerate().filter(|(_, used)| used.load(Ordering::Relaxed));
        used.map(|(group, _)| LANES.min(count - group * LANES)).sum()
    }

    /// The result of culling each triangle: `true` for a remaining one, `false` for a back face; `None` outside a
    /// plane. Valid after culling.
    pub(crate) fn outcomes(&self, triangles: &[[u32; 3]]) -> Vec<Option<bool>> {
        let crossing: HashSet<u32> =
            self.chunks.iter().flat_map(|chunk| &chunk.crossing).map(|crossing| crossing.source).collect();
        let codes = &self.image.outcodes;
        let outcome = |(k, triangle): (u32, &[u32; 3])| {
            let is_kept = self.kept.get(k as usize / 8).is_some_and(|byte| byte >> (k % 8) & 1 == 1);
            let code = |i: u32| codes.get(i as usize).copied().unwrap_or(0);
            let is_outside = triangle.iter().fold(PlaneSet::MAX, |all, &i| all & code(i)) != 0;
            let is_number = triangle.iter().all(|&i| code(i) & NOT_A_NUMBER == 0);
            (is_kept || is_number && !is_outside).then(|| is_kept || crossing.contains(&k))
        };
        (0..).zip(triangles).map(outcome).collect()
    }

    /// The triangles that cross a plane.
    pub(crate) fn crossing(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.chunks.iter().flat_map(|chunk| &chunk.crossing).map(|crossing| crossing.triangle)
    }

    /// The pieces that clipping has left of them.
    pub(crate) fn pieces(&self) -> &[[u32; 3]] {
        let whole: usize = self.chunks.iter().map(|chunk| chunk.kept).sum();
        self.triangles.get(whole..).unwrap_or_default()
    }
}

/// Meshes are indexed with 32 bits.
pub(super) fn to_u32(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}
