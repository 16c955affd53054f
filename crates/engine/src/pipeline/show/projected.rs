//! The mesh of an object after clipping and projection, made by [`Rebuilt`] from the parts that are in the volume.
//!
//! Each triangle is cut by the planes that it crosses, in clip space and before the division, as Sutherland and Hodgman
//! (1974) cut polygons. A new vertex keeps the two old ones that it lies between and its fraction of the way, so
//! positions, normals and colours are interpolated in one place. A side that lies in the plane of a cut is no edge of
//! the solid, so these sides are listed apart.

use glam::DVec3;

use crate::pipeline::mesh::each_chunk;
use crate::pipeline::mesh::resample::{Rebuilt, VertexOrigin};
use crate::pipeline::space::depths::{InView, Sheet};
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ClipPoint, NOT_A_NUMBER, ObjectPoint, PLANES, PlaneSet, outcode};
use crate::pipeline::stage::clip::Clipper;
use crate::pipeline::stage::vertex::{clip_from_view, view_point};
use crate::pipeline::stage::vertices::Vertices;
use crate::scene::{Mesh, SharedEdge};
use crate::simd::with_vectors;

/// `(x_n, y_n, −z_n)`. The last is twice the depth of the picture less one, so it has no cancellation either.
#[inline(always)]
pub(crate) fn displayed(projector: &Projector, p: ClipPoint) -> DVec3 {
    let z = match projector.sheet {
        None => 2.0 * projector.depths.depth(p.distance) - 1.0,
        Some(Sheet { farthest, slope, behind }) => behind + slope * (farthest - p.distance) / p.w,
    };
    DVec3::new(p.x / p.w, p.y / p.w, z)
}

/// The part of a mesh in the volume.
pub(crate) struct Projected<'a> {
    vertices: Vertices<'a>,
    outcodes: Vec<PlaneSet>,
    clipper: Clipper,
    /// Its vertices at their displayed positions.
    pub(crate) rebuilt: Rebuilt,
    pub(crate) in_view: InView,
    /// No triangle was cut or dropped.
    pub(crate) whole: bool,
    /// The sides along which triangles were cut.
    pub(crate) borders: Vec<[DVec3; 2]>,
}

impl<'a> Projected<'a> {
    pub(crate) fn new(vertices: Vertices<'a>, mesh: &Mesh) -> Self {
        let Vertices { projector, view_from_object, positions } = vertices;
        let mut outcodes = vec![0; positions.len()];
        each_chunk(&mut outcodes, |codes, first| {
            with_vectors!(_simd => for (code, &p) in codes.iter_mut().zip(&positions[first..]) {
                *code = outcode(projector, clip_from_view(projector, view_point(view_from_object, ObjectPoint(p))));
            });
        });
        let mut made = Self {
            vertices,
            outcodes,
            clipper: Clipper::default(),
            rebuilt: Rebuilt::new(mesh),
            in_view: InView::NOTHING,
            whole: true,
            borders: Vec::new(),
        };
        let mirrored = view_from_object.mirrored();
        for (source, &[a, b, c]) in (0..).zip(&mesh.triangles) {
            made.triangle(if mirrored { [a, c, b] } else { [a, b, c] }, source);
        }
        for &ends in &mesh.edges {
            let ends = made.edge(ends);
            made.rebuilt.edges.extend(ends);
        }
        for &edge in &mesh.adjacency.edges {
            let ends = made.edge(edge.ends);
            made.rebuilt.shared.extend(ends.map(|ends| SharedEdge { ends, ..edge }));
        }
        made
    }

    /// The planes that any vertex of the old mesh is outside of.
    pub(crate) fn outside(&self) -> PlaneSet {
        self.outcodes.iter().fold(0, |all, code| all | code)
    }

    /// Adds the part of a triangle that is in the volume.
    fn triangle(&mut self, triangle: [u32; 3], source: u32) {
        let codes = self.codes(triangle);
        if codes == Some([0; 3]) {
            let corners = triangle.map(|i| self.vertex(self.vertices.clip_point(i), VertexOrigin::Vertex(i)));
            return self.rebuilt.polygon(&corners, source);
        }
        self.whole = false;
        let Some([a, b, c]) = codes else { return };
        let planes = a | b | c;
        if a & b & c != 0 || planes & NOT_A_NUMBER != 0 {
            return;
        }
        let projector = self.vertices.projector;
        let corners = triangle.map(|i| self.vertices.clip_point(i));
        let kept = self.clipper.triangle(projector, corners, planes).to_vec();
        // A side whose ends both lie in a plane that the triangle crosses is where that plane cuts it.
        for (corner, next) in kept.iter().zip(kept.iter().cycle().skip(1)) {
            let lies_in = |plane: usize| corner.distances[plane] == 0.0 && next.distances[plane] == 0.0;
            if (0..PLANES).any(|plane| planes >> plane & 1 == 1 && lies_in(plane)) {
                self.borders.push([corner, next].map(|end| displayed(projector, end.point)));
            }
        }
        let polygon: Vec<u32> = kept.iter().map(|corner| self.vertex(corner.point, corner.origin(triangle))).collect();
        self.rebuilt.polygon(&polygon, source);
    }

    /// The part of an edge that is in the volume.
    fn edge(&mut self, ends: [u32; 2]) -> Option<[u32; 2]> {
        let [a, b] = ends;
        self.codes([a, b, b])?;
        let kept = self.clipper.segment(self.vertices.projector, ends.map(|i| self.vertices.clip_point(i)))?;
        Some(std::array::from_fn(|k| {
            let (point, cut) = kept[k];
            let own = ends[k];
            // An edge has no colour, so the origin of its new ends doesn't matter.
            let between = VertexOrigin::Between { of: [own; 3], weights: [1.0, 0.0, 0.0] };
            self.vertex(point, if cut { between } else { VertexOrigin::Vertex(own) })
        }))
    }

    /// The outcodes of three vertices; `None` if the mesh has no such vertices.
    fn codes(&self, corners: [u32; 3]) -> Option<[PlaneSet; 3]> {
        let code = |i: u32| self.outcodes.get(i as usize).copied();
        Some([code(corners[0])?, code(corners[1])?, code(corners[2])?])
    }

    /// The index of a vertex, which is new unless it is one of the old mesh and was there before.
    fn vertex(&mut self, point: ClipPoint, origin: VertexOrigin) -> u32 {
        let (projector, in_view) = (self.vertices.projector, &mut self.in_view);
        self.rebuilt.vertex(origin, || {
            *in_view = in_view.and(InView::between(point.distance, point.distance));
            displayed(projector, point)
        })
    }
}
