//! **Cull faces**: drop the faces that turn their back.
//!
//! *Notes*: `[3]` §1.1 step 4, *back-face culling*; §1.4: the order of a polygon's vertices tells its front from its
//! back. *Textbook*: the sign of **n** · **v**, the stored normal of the polygon times the direction to the eye, in
//! view space, before anything is projected. *Here*: the sign of the triangle's area on the image, where its corners
//! are already known, so that no normal is needed. The corners lie on the grid of the image and the sign is exact:
//! neighbours agree about the silhouette, and a closed mesh shows no holes. Eight triangles are decided at a time. A
//! triangle that crosses a plane of the volume has no corners on the image yet, so it's decided in view space
//! ([`facing`]). Faces outside one plane of the volume are dropped in the same pass, because their outcodes are here.

use std::sync::atomic::{AtomicBool, Ordering};

use super::faces::{Crossing, CulledChunk, Faces, LANES, to_u32};
use super::vertices::{OnImage, Vertices};
use crate::pipeline::mesh::{CHUNK, each};
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{NOT_A_NUMBER, PlaneSet, ViewPoint};

/// The work on the faces of one object.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FaceTask {
    /// Drop the faces that turn their back.
    pub(crate) cull_back: bool,
    /// Count the triangles that turn over on the grid ([`Faces::turned_over`]).
    pub(crate) watch_turning: bool,
    /// Record which triangle of the mesh each one comes from.
    pub(crate) want_source: bool,
    /// Record which vertices are used.
    pub(crate) want_used: bool,
}

/// Drops the triangles that lie outside one plane, and those that turn their back. Triangles that cross a plane are put
/// aside for [`clip`](super::clip::clip). The vertices have to be on the image already.
pub(crate) fn cull_faces(faces: &mut Faces, vertices: &Vertices, triangles: &[[u32; 3]], task: FaceTask) {
    let groups = if task.want_used { vertices.len().div_ceil(LANES) } else { 0 };
    faces.used.resize_with(groups, AtomicBool::default);
    faces.used.iter_mut().for_each(|used| *used.get_mut() = false);
    faces.kept.resize(triangles.len().div_ceil(8), 0);
    faces.chunks.resize_with(triangles.len().div_ceil(CHUNK), CulledChunk::default);

    let culling = Culling { image: &faces.image, vertices, used: &faces.used, task };
    let chunks = faces.chunks.iter_mut().zip(triangles.chunks(CHUNK)).zip(faces.kept.chunks_mut(CHUNK / 8));
    let chunks = (0..).step_by(CHUNK).zip(chunks);
    each(triangles.len(), chunks, |(first, ((chunk, triangles), kept))| culling.chunk(chunk, triangles, kept, first));
    faces.back = faces.chunks.iter().map(|chunk| chunk.back).sum();
    faces.turned_over = faces.chunks.iter().map(|chunk| chunk.turned_over).sum();
    gather(faces, triangles, task.want_source);
}

/// Puts the remaining triangles one behind the other. Their number in each chunk is known, so each chunk has its place
/// in the array, and all threads can write.
fn gather(faces: &mut Faces, triangles: &[[u32; 3]], want_source: bool) {
    let count = faces.chunks.iter().map(|chunk| chunk.kept).sum();
    faces.triangles.resize(count, [0; 3]);
    faces.source.resize(if want_source { count } else { 0 }, 0);
    let (mut left, mut sources) = (&mut faces.triangles[..], &mut faces.source[..]);
    let chunks = faces.chunks.iter().zip(triangles.chunks(CHUNK)).zip(faces.kept.chunks(CHUNK / 8));
    let chunks = (0..).step_by(CHUNK).zip(chunks).map(|(first, ((chunk, triangles), kept))| {
        let (out, rest) = std::mem::take(&mut left).split_at_mut(chunk.kept);
        left = rest;
        let (source, rest) = std::mem::take(&mut sources).split_at_mut(if want_source { chunk.kept } else { 0 });
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
    each(triangles.len(), chunks, gather);
}

/// Twice the area of a triangle on the image, positive if its corners run counter-clockwise as they are seen (y is
/// down).
///
/// Exact: corners on the grid of subpixels have few enough digits for every product and sum.
#[inline(always)]
pub(crate) fn area_on_image(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> f64 {
    let edge = |p: [f32; 3]| [f64::from(p[0]) - f64::from(a[0]), f64::from(p[1]) - f64::from(a[1])];
    let (e1, e2) = (edge(b), edge(c));
    e1[1] * e2[0] - e1[0] * e2[1]
}

/// The same sign for a triangle that is still to be clipped: positive if the eye is on the outer side of its plane.
/// Differences are taken before products, so that thin triangles far away keep their sign.
pub(crate) fn facing(projector: &Projector, [a, b, c]: [ViewPoint; 3]) -> f64 {
    let [a, b, c] = [a.0, b.0, c.0];
    let normal = (b - a).cross(c - a);
    if projector.projection.is_perspective() { -normal.dot(a) } else { normal.z }
}

/// The data that decides about a triangle.
struct Culling<'a> {
    image: &'a OnImage,
    vertices: &'a Vertices<'a>,
    used: &'a [AtomicBool],
    task: FaceTask,
}

impl Culling<'_> {
    /// Classifies a chunk of triangles and sets the bits of those to draw. Puts those that cross a plane aside.
    fn chunk(&self, chunk: &mut CulledChunk, triangles: &[[u32; 3]], kept: &mut [u8], first: u32) {
        *chunk = CulledChunk { crossing: std::mem::take(&mut chunk.crossing), ..CulledChunk::default() };
        chunk.crossing.clear();
        for ((k, byte), eight) in (first..).step_by(8).zip(kept).zip(triangles.chunks(8)) {
            let mut bits = 0;
            let [every, any] = self.outcodes(eight);
            if every != 0 {
                // All of them are outside the same plane.
            } else if self.task.watch_turning || any != 0 {
                for (l, &triangle) in eight.iter().enumerate() {
                    bits |= u8::from(self.classify(chunk, k + to_u32(l), triangle)) << l;
                }
            } else {
                bits = self.facing_bits(eight);
                chunk.back += eight.len() - bits.count_ones() as usize;
            }
            *byte = bits;
            chunk.kept += bits.count_ones() as usize;
            let mut left = if self.used.is_empty() { 0 } else { bits };
            while left != 0 {
                self.mark(eight[left.trailing_zeros() as usize]);
                left &= left - 1;
            }
        }
    }

    /// The bits of the triangles to draw, among up to eight of which none crosses a plane.
    #[inline(always)]
    fn facing_bits(&self, eight: &[[u32; 3]]) -> u8 {
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
        for l in 0..8 {
            front |= u8::from(first[l] > second[l]) << l;
            behind |= u8::from(first[l] < second[l]) << l;
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

    /// The planes that all vertices of the triangles are outside of, and the planes that any vertex is outside of.
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

    /// Classifies any triangle. True if it stays whole. One that crosses a plane is put aside.
    fn classify(&self, chunk: &mut CulledChunk, source: u32, triangle: [u32; 3]) -> bool {
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
        let in_view = || facing(projector, triangle.map(|i| self.vertices.view_point(i)));
        let area = if planes == 0 { area_on_image(positions[a], positions[b], positions[c]) } else { in_view() };
        if self.task.watch_turning && planes == 0 && area * in_view() < 0.0 {
            chunk.turned_over += 1;
        }
        if area == 0.0 || (self.task.cull_back && area * view_from_object.outward() < 0.0) {
            chunk.back += 1;
            return false;
        }
        if planes != 0 {
            chunk.crossing.push(Crossing { source, triangle, planes });
            self.mark(triangle);
        }
        planes == 0
    }
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
            assert_eq!(culling.facing_bits(&[[0, 1, 2], [0, 2, 1]]), u8::from(area > 0) | u8::from(area < 0) << 1);
            seen[usize::from(area > 0)] += 1;
        }
        assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
    }
}
