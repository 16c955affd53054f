//! The faces of one object that are left to draw: projected, culled, clipped.

use std::collections::HashSet;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::clip::Clipper;
use super::cull_objects::{area_on_image, facing};
use super::reflection::LANES;
use super::vertices::{OnImage, Screen, Vertices, on_grid};
use crate::pipeline::mesh::chunks::CHUNK;
use crate::pipeline::mesh::resample::VertexOrigin;
use crate::pipeline::space::planes::{ALL_PLANES, NEAR, NOT_A_NUMBER, PlaneSet};

/// A triangle that crosses planes of the volume.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    /// Its index in the mesh.
    source: u32,
    triangle: [u32; 3],
    planes: PlaneSet,
}

/// The result of culling a stretch of [`CHUNK`] triangles.
#[derive(Debug, Default)]
struct CulledChunk {
    crossing: Vec<Crossing>,
    kept: usize,
    back: usize,
    turned_over: usize,
}

/// The remaining triangles of one object; reuses its buffers.
#[derive(Debug, Default)]
pub(crate) struct Faces {
    /// All vertices of the mesh on the image, then the cuts.
    pub(crate) image: OnImage,
    /// Indices of vertices.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangle of the mesh that each one comes from; empty where nobody wants it.
    pub(crate) source: Vec<u32>,
    /// The vertices that clipping made.
    pub(crate) cuts: Vec<VertexOrigin>,
    /// For each [`LANES`] vertices of the mesh whether a triangle that is left has one of them; empty where nobody
    /// wants it.
    pub(crate) used: Vec<AtomicBool>,
    /// Triangles that were dropped because they turn away.
    pub(crate) back: usize,
    /// Triangles that turn the other way on the grid of the image than they do in the world: thin ones, at silhouettes.
    pub(crate) turned_over: usize,
    /// A bit for each triangle of the mesh that is left and crosses no plane, the first in the lowest bit.
    kept: Vec<u8>,
    stretches: Vec<CulledChunk>,
    clipper: Clipper,
}

/// The work on the faces of one object.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FaceTask {
    /// Drop the faces that turn their back.
    pub(crate) cull_back: bool,
    /// Find out whether a triangle turned over.
    pub(crate) watch_turning: bool,
    /// Say which triangle of the mesh each one comes from.
    pub(crate) want_source: bool,
    /// Say which vertices are used.
    pub(crate) want_used: bool,
}

impl Faces {
    /// True where the near plane cuts the object, so that its inside may be seen.
    pub(crate) fn cut_open(&self) -> bool {
        self.image.outside & NEAR != 0
    }

    /// Number of the `count` vertices that are in groups used by any remaining triangle.
    pub(crate) fn used_vertices(&self, count: usize) -> usize {
        let used = self.used.iter().enumerate().filter(|(_, used)| used.load(Ordering::Relaxed));
        used.map(|(group, _)| LANES.min(count - group * LANES)).sum()
    }

    /// The result of culling each triangle: `true` for a remaining one, `false` for a back face; `None` outside a
    /// plane. Valid after [`cull`](Self::cull).
    pub(crate) fn fates(&self, triangles: &[[u32; 3]]) -> Vec<Option<bool>> {
        let crossing: HashSet<u32> =
            self.stretches.iter().flat_map(|stretch| &stretch.crossing).map(|crossing| crossing.source).collect();
        let codes = &self.image.outcodes;
        let fate = |(k, triangle): (u32, &[u32; 3])| {
            let is_kept = self.kept.get(k as usize / 8).is_some_and(|byte| byte >> (k % 8) & 1 == 1);
            let code = |i: u32| codes.get(i as usize).copied().unwrap_or(0);
            let is_outside = triangle.iter().fold(PlaneSet::MAX, |all, &i| all & code(i)) != 0;
            let is_number = triangle.iter().all(|&i| code(i) & NOT_A_NUMBER == 0);
            (is_kept || is_number && !is_outside).then(|| is_kept || crossing.contains(&k))
        };
        (0..).zip(triangles).map(fate).collect()
    }

    /// The triangles that cross a plane.
    pub(crate) fn crossing(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.stretches.iter().flat_map(|stretch| &stretch.crossing).map(|crossing| crossing.triangle)
    }

    /// The pieces that [`clip`](Self::clip) has left of them.
    pub(crate) fn pieces(&self) -> &[[u32; 3]] {
        let whole: usize = self.stretches.iter().map(|stretch| stretch.kept).sum();
        self.triangles.get(whole..).unwrap_or_default()
    }

    /// Drops triangles that lie outside one plane, and those that turn their back. Those that cross a plane are left to
    /// [`clip`](Self::clip).
    pub(crate) fn cull(&mut self, vertices: &Vertices, triangles: &[[u32; 3]], task: FaceTask) {
        let groups = if task.want_used { vertices.len().div_ceil(LANES) } else { 0 };
        self.used.resize_with(groups, AtomicBool::default);
        self.used.iter_mut().for_each(|used| *used.get_mut() = false);
        self.kept.resize(triangles.len().div_ceil(8), 0);
        self.stretches.resize_with(triangles.len().div_ceil(CHUNK), CulledChunk::default);

        let culling = Culling { image: &self.image, vertices, used: &self.used, task };
        let stretches = self.stretches.iter_mut().zip(triangles.chunks(CHUNK)).zip(self.kept.chunks_mut(CHUNK / 8));
        let stretches = (0..).step_by(CHUNK).zip(stretches);
        let cull = |(first, ((stretch, triangles), kept))| culling.stretch(stretch, triangles, kept, first);
        if triangles.len() > 2 * CHUNK {
            stretches.collect::<Vec<_>>().into_par_iter().for_each(cull);
        } else {
            stretches.for_each(cull);
        }
        self.back = self.stretches.iter().map(|stretch| stretch.back).sum();
        self.turned_over = self.stretches.iter().map(|stretch| stretch.turned_over).sum();
        self.gather(triangles, task.want_source);
    }

    /// Puts the triangles that are left one behind the other.
    fn gather(&mut self, triangles: &[[u32; 3]], want_source: bool) {
        let count = self.stretches.iter().map(|stretch| stretch.kept).sum();
        self.triangles.resize(count, [0; 3]);
        self.source.resize(if want_source { count } else { 0 }, 0);
        let (mut left, mut sources) = (&mut self.triangles[..], &mut self.source[..]);
        let stretches = self.stretches.iter().zip(triangles.chunks(CHUNK)).zip(self.kept.chunks(CHUNK / 8));
        let stretches = (0..).step_by(CHUNK).zip(stretches).map(|(first, ((stretch, triangles), kept))| {
            let (out, rest) = std::mem::take(&mut left).split_at_mut(stretch.kept);
            left = rest;
            let (source, rest) = std::mem::take(&mut sources).split_at_mut(if want_source { stretch.kept } else { 0 });
            sources = rest;
            (first, triangles, kept, out, source)
        });
        type ChunkOutput<'a> = (u32, &'a [[u32; 3]], &'a [u8], &'a mut [[u32; 3]], &'a mut [u32]);
        let gather = |(first, triangles, kept, out, source): ChunkOutput| {
            let mut next = 0;
            for (k, &byte) in kept.iter().enumerate() {
                let mut bits = byte;
                while bits != 0 {
                    let k = 8 * k + bits.trailing_zeros() as usize;
                    out[next] = triangles[k];
                    if let Some(source) = source.get_mut(next) {
                        *source = first + to_u32(k);
                    }
                    next += 1;
                    bits &= bits - 1;
                }
            }
        };
        if triangles.len() > 2 * CHUNK {
            stretches.collect::<Vec<_>>().into_par_iter().for_each(gather);
        } else {
            stretches.for_each(gather);
        }
    }

    /// Cuts the triangles that cross a plane, and adds the rest of each as a fan. With `all_planes`, also against the
    /// planes that they do not cross.
    pub(crate) fn clip(&mut self, vertices: &Vertices, screen: &Screen, want_source: bool, all_planes: bool) {
        self.cuts.clear();
        for &Crossing { source, triangle, planes } in self.stretches.iter().flat_map(|stretch| &stretch.crossing) {
            let corners = triangle.map(|i| vertices.clip(i));
            let planes = if all_planes { ALL_PLANES } else { planes };
            let mut fan = [0_u32; 2];
            for (i, corner) in self.clipper.triangle(vertices.projector, corners, planes).iter().enumerate() {
                let index = match corner.origin(triangle) {
                    VertexOrigin::Vertex(own) => own,
                    new @ VertexOrigin::Between { .. } => {
                        let index = to_u32(self.image.positions.len());
                        self.image.positions.push(on_grid(screen.project(vertices.projector, corner.point)));
                        if !self.image.inverse_w.is_empty() {
                            self.image.inverse_w.push(vertices.projector.depths.relative_inverse_w(corner.point.w));
                        }
                        self.cuts.push(new);
                        index
                    }
                };
                match i {
                    0 => fan[0] = index,
                    1 => fan[1] = index,
                    _ => {
                        self.triangles.push([fan[0], fan[1], index]);
                        if want_source {
                            self.source.push(source);
                        }
                        fan[1] = index;
                    }
                }
            }
        }
    }
}

/// The inputs for judging a triangle.
struct Culling<'a> {
    image: &'a OnImage,
    vertices: &'a Vertices<'a>,
    used: &'a [AtomicBool],
    task: FaceTask,
}

impl Culling<'_> {
    /// Sets the bits of triangles that are left and cross no plane.
    fn stretch(&self, stretch: &mut CulledChunk, triangles: &[[u32; 3]], kept: &mut [u8], first: u32) {
        *stretch = CulledChunk { crossing: std::mem::take(&mut stretch.crossing), ..CulledChunk::default() };
        stretch.crossing.clear();
        for ((k, byte), eight) in (first..).step_by(8).zip(kept).zip(triangles.chunks(8)) {
            let mut bits = 0;
            let [every, any] = self.outcodes(eight);
            if every != 0 {
                // All of them are outside of the same plane.
            } else if self.task.watch_turning || any != 0 {
                for (l, &triangle) in eight.iter().enumerate() {
                    bits |= u8::from(self.judge(stretch, k + to_u32(l), triangle)) << l;
                }
            } else {
                bits = self.turned_here(eight);
                stretch.back += eight.len() - bits.count_ones() as usize;
            }
            *byte = bits;
            stretch.kept += bits.count_ones() as usize;
            let mut left = if self.used.is_empty() { 0 } else { bits };
            while left != 0 {
                self.mark(eight[left.trailing_zeros() as usize]);
                left &= left - 1;
            }
        }
    }

    /// The bits of those of up to eight triangles, none of which crosses a plane, that are to be drawn.
    #[inline(always)]
    fn turned_here(&self, eight: &[[u32; 3]]) -> u8 {
        let positions = &self.image.positions[..];
        // The two products of which the area is the difference, in single precision. Sides of triangles on the grid of
        // subpixels are exact, and rounding keeps the order of the products, but for those that it makes equal.
        let (mut first, mut second) = ([0.0_f32; 8], [0.0_f32; 8]);
        for (l, &[a, b, c]) in eight.iter().enumerate().take(8) {
            let [a, b, c] = [positions.get(a as usize), positions.get(b as usize), positions.get(c as usize)];
            if let (Some(a), Some(b), Some(c)) = (a, b, c) {
                first[l] = (b[1] - a[1]) * (c[0] - a[0]);
                second[l] = (b[0] - a[0]) * (c[1] - a[1]);
            }
        }
        let (mut front, mut behind) = (0, 0);
        if !self.image.huge {
            for l in 0..8 {
                front |= u8::from(first[l] > second[l]) << l;
                behind |= u8::from(first[l] < second[l]) << l;
            }
        }
        let decided = front | behind;
        for (l, &[a, b, c]) in eight.iter().enumerate().filter(|(l, _)| decided >> l & 1 == 0) {
            let [a, b, c] = [positions.get(a as usize), positions.get(b as usize), positions.get(c as usize)];
            if let (Some(&a), Some(&b), Some(&c)) = (a, b, c) {
                let area = area_on_image(a, b, c);
                front |= u8::from(area > 0.0) << l;
                behind |= u8::from(area < 0.0) << l;
            }
        }
        if self.vertices.view_from_object.mirrored() {
            std::mem::swap(&mut front, &mut behind);
        }
        if self.task.cull_back { front } else { front | behind }
    }

    /// The planes that every vertex of the triangles is outside of, and those that any is.
    #[inline(always)]
    fn outcodes(&self, triangles: &[[u32; 3]]) -> [PlaneSet; 2] {
        let codes = &self.image.outcodes[..];
        if codes.is_empty() {
            return [0, 0];
        }
        triangles.iter().flatten().fold([PlaneSet::MAX, 0], |[every, any], &i| {
            let code = codes.get(i as usize).copied().unwrap_or(0);
            [every & code, any | code]
        })
    }

    fn mark(&self, triangle: [u32; 3]) {
        for i in triangle {
            if let Some(used) = self.used.get(i as usize / LANES) {
                used.store(true, Ordering::Relaxed);
            }
        }
    }

    /// Judges any triangle: false for one that crosses a plane, which is put aside.
    fn judge(&self, stretch: &mut CulledChunk, source: u32, triangle: [u32; 3]) -> bool {
        let Vertices { projector, view_from_object, .. } = *self.vertices;
        let [a, b, c] = [triangle[0] as usize, triangle[1] as usize, triangle[2] as usize];
        if a.max(b).max(c) >= self.image.positions.len() {
            return false;
        }
        let codes = match self.image.outcodes[..] {
            [] => [0; 3],
            _ => [self.image.outcodes[a], self.image.outcodes[b], self.image.outcodes[c]],
        };
        let planes = codes[0] | codes[1] | codes[2];
        if codes[0] & codes[1] & codes[2] != 0 || planes & NOT_A_NUMBER != 0 {
            return false;
        }
        let positions = &self.image.positions;
        let in_world = || facing(projector, triangle.map(|i| self.vertices.view(i)));
        let area = if planes == 0 { area_on_image(positions[a], positions[b], positions[c]) } else { in_world() };
        if self.task.watch_turning && planes == 0 && area * in_world() < 0.0 {
            stretch.turned_over += 1;
        }
        if area == 0.0 || (self.task.cull_back && area * view_from_object.outward() < 0.0) {
            stretch.back += 1;
            return false;
        }
        if planes != 0 {
            stretch.crossing.push(Crossing { source, triangle, planes });
            self.mark(triangle);
        }
        planes == 0
    }
}

/// Meshes are indexed with 32 bits.
fn to_u32(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::pipeline::space::projector::Projector;
    use glam::DMat4;

    #[test]
    fn triangles_are_judged_as_whole_numbers_judge_them() {
        let projector = Projector::new(&Camera::new(&Parameters::default()).unwrap());
        let view_from_object = projector.view_from_object(DMat4::IDENTITY);
        let vertices = Vertices { projector: &projector, view_from_object: &view_from_object, positions: &[] };
        let task = FaceTask { cull_back: true, watch_turning: false, want_source: false, want_used: false };
        // Slivers between far corners of a large picture: single precision rounds their products, and makes many equal.
        let mut state = 1_u64;
        let mut below = |limit: i64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i64::try_from(state >> 33).unwrap() % limit
        };
        let mut seen = [0, 0];
        for _ in 0..2000 {
            let a = [below(1 << 20), below(1 << 20)];
            let b = [a[0] + below(1 << 22), a[1] + below(1 << 22)];
            let k = below(4) + 1;
            let c = [0, 1].map(|i| a[i] + (b[i] - a[i]) * k / 4 + below(3) - 1);
            let pixels = |p: [i64; 2]| [p[0], p[1]].map(|c| c as f32 / 256.0);
            let positions = [a, b, c].map(pixels).map(|[x, y]| [x, y, 0.5]).to_vec();
            let image = OnImage { positions, ..OnImage::default() };
            let culling = Culling { image: &image, vertices: &vertices, used: &[], task };
            let area = (b[1] - a[1]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[1] - a[1]);
            assert_eq!(culling.turned_here(&[[0, 1, 2], [0, 2, 1]]), u8::from(area > 0) | u8::from(area < 0) << 1);
            seen[usize::from(area > 0)] += 1;
        }
        assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
    }
}
