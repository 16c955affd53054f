//! The mesh of an object after clipping and projection. Triangles are held against the planes by all threads, a stretch
//! of them each; a stretch that is wholly inside is taken over as it is.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::clip::Clipper;
use super::depths::{InView, Sheet};
use super::planes::{NOT_A_NUMBER, PLANES, PlaneSet, outcode};
use super::projector::{ClipPoint, Projector};
use super::resample::VertexOrigin;
use super::transform::{CHUNK, Vertices, each_chunk};
use crate::scene::{Mesh, SharedEdge};
use crate::simd::with_vectors;

/// `(x_n, y_n, −z_n)`; the last is twice the depth of the picture less one, so it has no cancellation either.
#[inline(always)]
pub(super) fn displayed(projector: &Projector, p: ClipPoint) -> DVec3 {
    let z = match projector.sheet {
        None => 2.0 * projector.depths.depth(p.depth) - 1.0,
        Some(Sheet { farthest, slope, behind }) => behind + slope * (farthest - p.depth) / p.w,
    };
    DVec3::new(p.x / p.w, p.y / p.w, z)
}

/// Arrays that serve one mesh after the other.
#[derive(Debug, Default)]
pub(super) struct MeshArrays {
    outcodes: Vec<PlaneSet>,
    /// Vertices of the old mesh that are still used.
    used: Vec<AtomicBool>,
    /// The new index of each of them, where not all are.
    ranks: Vec<u32>,
    /// Those of meshes that are no longer needed, the first one on top.
    pub(super) positions: Vec<Vec<DVec3>>,
    pub(super) triangles: Vec<Vec<[u32; 3]>>,
    pub(super) edges: Vec<Vec<[u32; 2]>>,
}

/// The result of clipping and projection. Vertices of the old mesh that are still used come first, in its order; then
/// those that clipping made.
pub(super) struct Projected {
    pub(super) positions: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) edges: Vec<[u32; 2]>,
    /// The remaining edges of the old mesh's adjacency; the faces are still the old ones.
    pub(super) shared: Vec<SharedEdge>,
    pub(super) in_view: InView,
    /// No triangle was cut or dropped.
    pub(super) whole: bool,
    /// The sides along which triangles were cut.
    pub(super) borders: Vec<[DVec3; 2]>,
    pub(super) origins: Origins,
}

/// Where vertices and triangles come from.
pub(super) struct Origins {
    /// Number of vertices of the old mesh.
    of: u32,
    /// The old vertices that are still used; `None`: all.
    own: Option<Vec<u32>>,
    /// The vertices that clipping made.
    new: Vec<VertexOrigin>,
    /// The old triangle of each; `None`: they are the old ones.
    sources: Option<Vec<u32>>,
    faces: usize,
    /// The planes that any old vertex is outside of.
    pub(super) outside: PlaneSet,
}

impl Origins {
    /// The origin of each vertex.
    pub(super) fn vertices(&self) -> impl Iterator<Item = VertexOrigin> {
        let all = 0..if self.own.is_none() { self.of } else { 0 };
        let own = self.own.iter().flatten().copied();
        all.chain(own).map(VertexOrigin::Vertex).chain(self.new.iter().copied())
    }

    /// True where vertices and triangles are those of the old mesh.
    pub(super) fn is_same(&self) -> bool {
        self.own.is_none() && self.new.is_empty() && self.sources.is_none()
    }

    /// Number of triangles.
    pub(super) fn faces(&self) -> usize {
        self.faces
    }

    /// The old triangle of a new one.
    #[inline(always)]
    pub(super) fn source(&self, face: usize) -> u32 {
        match &self.sources {
            None => u32::try_from(face).unwrap_or(u32::MAX),
            Some(sources) => sources[face],
        }
    }

    /// The old triangle of each.
    pub(super) fn sources(&self) -> Vec<u32> {
        (0..self.faces).map(|face| self.source(face)).collect()
    }

    /// Of each group of `lanes` old vertices, whether any is still used; empty: all are.
    pub(super) fn used(&self, lanes: usize) -> Vec<AtomicBool> {
        let Some(own) = &self.own else { return Vec::new() };
        let groups = (self.of as usize).div_ceil(lanes);
        let mut used: Vec<AtomicBool> = (0..groups).map(|_| AtomicBool::new(false)).collect();
        let new = self.new.iter().flat_map(|origin| match *origin {
            VertexOrigin::Vertex(i) => [i; 3],
            VertexOrigin::Between { of, .. } => of,
        });
        own.iter().copied().chain(new).for_each(|i| *used[i as usize / lanes].get_mut() = true);
        used
    }
}

/// A vertex that clipping made.
type NewVertex = (VertexOrigin, ClipPoint);

/// The rest of a stretch of triangles, or of edges. Corners that clipping made are counted from the number of old
/// vertices on.
#[derive(Default)]
struct Part<const N: usize> {
    /// All are left as they were, and the lists are empty.
    whole: bool,
    count: usize,
    left: Vec<[u32; N]>,
    new: Vec<NewVertex>,
    /// Of triangles: whether any was cut, the old one of each, and the sides along which they were cut.
    cut: bool,
    sources: Vec<u32>,
    borders: Vec<[DVec3; 2]>,
}

/// A mesh on its way into the volume.
struct Task<'a> {
    vertices: Vertices<'a>,
    mesh: &'a Mesh,
    mirrored: bool,
    outcodes: &'a [PlaneSet],
    used: &'a [AtomicBool],
}

/// All of a mesh that is in the volume.
pub(super) fn projected(vertices: Vertices, mesh: &Mesh, arrays: &mut MeshArrays) -> Projected {
    let Vertices { projector, view_from_object, positions } = vertices;
    let MeshArrays { outcodes, used, ranks, .. } = arrays;
    outcodes.resize(positions.len(), 0);
    each_chunk(outcodes, |codes, first| {
        with_vectors!(_simd => for (code, &p) in codes.iter_mut().zip(&positions[first..]) {
            *code = outcode(projector, projector.clip(view_from_object.point(p)));
        });
    });
    let outside = outcodes.iter().fold(0, |all, code| all | code);
    used.resize_with(positions.len(), AtomicBool::default);
    used.iter_mut().for_each(|used| *used.get_mut() = false);
    let task = Task { vertices, mesh, mirrored: view_from_object.mirrored(), outcodes, used };
    let stretches = each_stretch(mesh.triangles.len(), |range| task.triangles(range));
    let edge_stretches = each_stretch(mesh.edges.len(), |range| task.edges(range));
    let (mut of_shared, mut clipper) = (Vec::new(), Clipper::default());
    let shared = mesh.adjacency.edges.iter();
    let shared = shared
        .filter_map(|edge| Some(SharedEdge { ends: task.edge(edge.ends, &mut clipper, &mut of_shared)?, ..*edge }));
    let mut shared: Vec<SharedEdge> = shared.collect();

    let all = |used: &AtomicBool| used.load(Ordering::Relaxed);
    let own: Option<Vec<u32>> = (!used.iter().all(all)).then(|| {
        let mut own = Vec::new();
        ranks.clear();
        for (i, used) in (0_u32..).zip(used.iter_mut()) {
            ranks.push(to_u32(own.len()));
            own.extend(used.get_mut().then_some(i));
        }
        own
    });
    let ranks = own.as_ref().map(|_| ranks.as_slice());
    let numbering =
        Numbering { of: to_u32(positions.len()), own: own.as_ref().map_or(positions.len(), Vec::len), ranks };

    let mut new: Vec<NewVertex> = Vec::new();
    let mut add = |more: &[NewVertex]| {
        let base = to_u32(new.len());
        new.extend_from_slice(more);
        base
    };
    let bases: Vec<u32> = stretches.iter().map(|part| add(&part.new)).collect();
    let edge_bases: Vec<u32> = edge_stretches.iter().map(|part| add(&part.new)).collect();
    let base = add(&of_shared);
    shared.iter_mut().for_each(|edge| edge.ends = edge.ends.map(|i| numbering.of(i, base)));
    let mut points = arrays.positions.pop().unwrap_or_default();
    let in_view = display(&vertices, own.as_deref(), &new, &mut points);
    let mut triangles = arrays.triangles.pop().unwrap_or_default();
    numbering.write(&mut triangles, &stretches, &bases, &mesh.triangles);
    let mut edges = arrays.edges.pop().unwrap_or_default();
    numbering.write(&mut edges, &edge_stretches, &edge_bases, &mesh.edges);
    let faces = triangles.len();
    let is_same = stretches.iter().all(|part| part.whole);
    let sources = (!is_same).then(|| {
        let all = stretches.iter().enumerate().map(|(k, part)| (to_u32(k * CHUNK), part));
        let mut sources = Vec::with_capacity(faces);
        for (first, part) in all {
            if part.whole {
                sources.extend(first..first + to_u32(part.count));
            } else {
                sources.extend_from_slice(&part.sources);
            }
        }
        sources
    });
    let whole = faces == mesh.triangles.len() && !stretches.iter().any(|part| part.cut);
    let borders = stretches.into_iter().flat_map(|part| part.borders).collect();
    let new = new.into_iter().map(|(origin, _)| origin).collect();
    let origins = Origins { of: to_u32(positions.len()), own, new, sources, faces, outside };
    Projected { positions: points, triangles, edges, shared, in_view, whole, borders, origins }
}

/// The new index of each vertex.
#[derive(Clone, Copy)]
struct Numbering<'a> {
    /// Number of old vertices.
    of: u32,
    /// Number of those that are still used.
    own: usize,
    ranks: Option<&'a [u32]>,
}

impl Numbering<'_> {
    /// Of an old vertex, or of one that clipping made: `base` is the number of those made before its stretch.
    #[inline(always)]
    fn of(&self, index: u32, base: u32) -> u32 {
        if index >= self.of {
            return to_u32(self.own) + base + (index - self.of);
        }
        self.ranks.map_or(index, |ranks| ranks[index as usize])
    }

    /// Puts the triangles, or the edges, of all stretches one after the other.
    fn write<const N: usize>(self, into: &mut Vec<[u32; N]>, parts: &[Part<N>], bases: &[u32], old: &[[u32; N]]) {
        into.resize(parts.iter().map(|part| part.count).sum(), [0; N]);
        let mut rest = into.as_mut_slice();
        let mut tasks = Vec::with_capacity(parts.len());
        for ((part, old), &base) in parts.iter().zip(old.chunks(CHUNK)).zip(bases) {
            let (own, behind) = rest.split_at_mut(part.count);
            tasks.push((own, part, old, base));
            rest = behind;
        }
        let write = |(into, part, old, base): (&mut [[u32; N]], &Part<N>, &[[u32; N]], u32)| {
            if part.whole && self.ranks.is_none() {
                into.copy_from_slice(old);
                return;
            }
            let from = if part.whole { old } else { part.left.as_slice() };
            into.iter_mut().zip(from).for_each(|(into, from)| *into = from.map(|i| self.of(i, base)));
        };
        if tasks.len() > 2 {
            tasks.into_par_iter().for_each(write);
        } else {
            tasks.into_iter().for_each(write);
        }
    }
}

/// The places of all vertices in the volume, and between which distances they are.
fn display(
    vertices: &Vertices,
    own: Option<&[u32]>,
    new: &[(VertexOrigin, ClipPoint)],
    into: &mut Vec<DVec3>,
) -> InView {
    let Vertices { projector, view_from_object, positions } = *vertices;
    let count = own.map_or(positions.len(), <[u32]>::len);
    into.resize(count + new.len(), DVec3::ZERO);
    let (own_points, new_points) = into.split_at_mut(count);
    let show = |(k, into): (usize, &mut [DVec3])| {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut one = |into: &mut DVec3, p: DVec3| {
            let p = projector.clip(view_from_object.point(p));
            (least, most) = (least.min(p.depth), most.max(p.depth));
            *into = displayed(projector, p);
        };
        let here = k * CHUNK..k * CHUNK + into.len();
        match own {
            None => with_vectors!(_simd => into.iter_mut().zip(&positions[here]).for_each(|(into, &p)| one(into, p))),
            Some(own) => into.iter_mut().zip(&own[here]).for_each(|(into, &i)| one(into, positions[i as usize])),
        }
        if least <= most { InView::between(least, most) } else { InView::NOTHING }
    };
    let in_view = if own_points.len() > 2 * CHUNK {
        own_points.par_chunks_mut(CHUNK).enumerate().map(show).reduce(|| InView::NOTHING, InView::and)
    } else {
        own_points.chunks_mut(CHUNK).enumerate().map(show).fold(InView::NOTHING, InView::and)
    };
    for (into, (_, point)) in new_points.iter_mut().zip(new) {
        *into = displayed(projector, *point);
    }
    new.iter().fold(in_view, |all, (_, point)| all.and(InView::between(point.depth, point.depth)))
}

/// Calls `work` for all stretches of `count` things, many over all threads, and gives the results in order.
fn each_stretch<T: Send>(count: usize, work: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
    let stretch = |k: usize| work(k * CHUNK..((k + 1) * CHUNK).min(count));
    let stretches = 0..count.div_ceil(CHUNK);
    if stretches.len() > 2 {
        stretches.into_par_iter().map(stretch).collect()
    } else {
        stretches.map(stretch).collect()
    }
}

impl Task<'_> {
    /// The rest of a stretch of triangles.
    fn triangles(&self, range: Range<usize>) -> Part<3> {
        let all = &self.mesh.triangles[range.clone()];
        let mut part = Part { whole: !self.mirrored, ..Part::default() };
        let mut clipper = Clipper::default();
        for (k, &triangle) in all.iter().enumerate() {
            let codes = self.codes(triangle);
            if codes.is_some_and(|[a, b, c]| a | b | c == 0) {
                triangle.iter().for_each(|&i| self.uses(i));
                if part.whole {
                    continue;
                }
            } else if part.whole {
                // Up to here it was.
                part.whole = false;
                part.left.extend_from_slice(&all[..k]);
                part.sources.extend((range.start..range.start + k).map(to_u32));
            }
            let source = to_u32(range.start + k);
            let triangle = if self.mirrored { [triangle[0], triangle[2], triangle[1]] } else { triangle };
            let Some([a, b, c]) = codes else { continue };
            let either = a | b | c;
            if either == 0 {
                part.polygon(&triangle, source);
            } else if a & b & c == 0 && either & NOT_A_NUMBER == 0 {
                self.cut(triangle, source, either, &mut clipper, &mut part);
            }
        }
        part.count = if part.whole { all.len() } else { part.left.len() };
        part
    }

    /// Clips a triangle against some planes.
    fn cut(&self, triangle: [u32; 3], source: u32, planes: PlaneSet, clipper: &mut Clipper, part: &mut Part<3>) {
        part.cut = true;
        let projector = self.vertices.projector;
        let kept = clipper.triangle(projector, triangle.map(|i| self.vertices.clip(i)), planes);
        let polygon: Vec<u32> =
            kept.iter().map(|corner| self.vertex(corner.point, corner.origin(triangle), &mut part.new)).collect();
        // A side whose ends both lie in a plane that the triangle crosses is where that plane cuts it.
        for (corner, next) in kept.iter().zip(kept.iter().cycle().skip(1)) {
            let lies_in = |plane: usize| corner.distances[plane] == 0.0 && next.distances[plane] == 0.0;
            if (0..PLANES).any(|plane| planes >> plane & 1 == 1 && lies_in(plane)) {
                part.borders.push([corner, next].map(|end| displayed(projector, end.point)));
            }
        }
        part.polygon(&polygon, source);
    }

    /// The rest of a stretch of edges.
    fn edges(&self, range: Range<usize>) -> Part<2> {
        let all = &self.mesh.edges[range];
        let mut part = Part { whole: true, ..Part::default() };
        let mut clipper = Clipper::default();
        for (k, &ends) in all.iter().enumerate() {
            let left = self.edge(ends, &mut clipper, &mut part.new);
            if part.whole && left != Some(ends) {
                // Up to here it was.
                part.whole = false;
                part.left.extend_from_slice(&all[..k]);
            }
            if !part.whole {
                part.left.extend(left);
            }
        }
        part.count = if part.whole { all.len() } else { part.left.len() };
        part
    }

    /// The part of an edge that is in the volume.
    fn edge(&self, ends: [u32; 2], clipper: &mut Clipper, new: &mut Vec<NewVertex>) -> Option<[u32; 2]> {
        let [a, b] = ends;
        let [of_a, of_b, _] = self.codes([a, b, b])?;
        if of_a | of_b == 0 {
            ends.iter().for_each(|&i| self.uses(i));
            return Some(ends);
        }
        let kept = clipper.segment(self.vertices.projector, ends.map(|i| self.vertices.clip(i)))?;
        Some(std::array::from_fn(|k| {
            let (point, cut) = kept[k];
            let own = ends[k];
            // An edge has no colour: the origin of its new ends does not matter.
            let between = VertexOrigin::Between { of: [own; 3], weights: [1.0, 0.0, 0.0] };
            self.vertex(point, if cut { between } else { VertexOrigin::Vertex(own) }, new)
        }))
    }

    /// The outcodes of three vertices; `None` where the mesh has no such vertices.
    #[inline(always)]
    fn codes(&self, corners: [u32; 3]) -> Option<[u8; 3]> {
        let code = |i: u32| self.outcodes.get(i as usize).copied();
        Some([code(corners[0])?, code(corners[1])?, code(corners[2])?])
    }

    #[inline(always)]
    fn uses(&self, vertex: u32) {
        let used = &self.used[vertex as usize];
        // Most are known to be, and threads do not take the memory from one another.
        if !used.load(Ordering::Relaxed) {
            used.store(true, Ordering::Relaxed);
        }
    }

    /// The index of a vertex, which is new unless it is one of the old mesh.
    fn vertex(&self, point: ClipPoint, origin: VertexOrigin, new: &mut Vec<NewVertex>) -> u32 {
        if let VertexOrigin::Vertex(i) = origin {
            self.uses(i);
            return i;
        }
        new.push((origin, point));
        to_u32(self.vertices.len() + new.len() - 1)
    }
}

impl Part<3> {
    /// Adds a convex polygon, which is a part of the old triangle `source`, as a fan.
    fn polygon(&mut self, corners: &[u32], source: u32) {
        for k in 1..corners.len().saturating_sub(1) {
            self.left.push([corners[0], corners[k], corners[k + 1]]);
            self.sources.push(source);
        }
    }
}

/// Vertices and triangles are counted with 32 bits.
fn to_u32(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}
