//! The triangle mesh with its edges.

pub(crate) mod adjacency;
pub(crate) mod polygon;
pub mod primitives;

use std::collections::BTreeSet;

use glam::DVec3;

use crate::geometry::Aabb;
use crate::limits::MAX_VERTICES;
pub use adjacency::{Adjacency, SharedEdge};
use polygon::Triangulator;

/// A mesh in its object's own space. Vertices that lie on a crease are there once for each side, each with its own
/// normal.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub positions: Vec<DVec3>,
    /// Unit normals, one for each vertex. Only an object that no light falls on may go without.
    pub normals: Vec<DVec3>,
    /// Counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The edges to draw: sides of polygons, not the diagonals that triangulation adds. Indices into `positions`, each
    /// edge once (even if vertices are doubled). Curved shapes name only some of their sides: see
    /// [`primitives`].
    pub edges: Vec<[u32; 2]>,
    /// Adjacency of the faces of curved solids, from which their outline is found. Empty for other meshes.
    pub adjacency: Adjacency,
    /// The surface has no border, so no back face can be seen from outside.
    pub closed: bool,
    /// The surface is convex (and closed).
    pub convex: bool,
}

impl Mesh {
    /// A polyhedron with flat faces. `faces` lists the corners of each planar face (convex or not), counter-clockwise
    /// seen from outside. Each corner becomes one vertex per face, with the face's normal. Every side of a face is an
    /// edge, once. A face without area gets the normal +y. An index out of range leaves its face out.
    pub fn polyhedron(corners: &[DVec3], faces: &[&[usize]]) -> Self {
        let mut mesh = Self::default();
        let mut known_edges = BTreeSet::new();
        let (mut triangulator, mut triangles) = (Triangulator::default(), Vec::new());
        for face in faces {
            if face.len() < 3 || face.iter().any(|&i| i >= corners.len()) {
                continue;
            }
            let points: Vec<DVec3> = face.iter().map(|&i| corners[i]).collect();
            let normal = polygon::normal(points.iter().copied()).unwrap_or(DVec3::Y);
            let ids: Vec<u32> = points.iter().map(|&p| mesh.add_vertex(p, normal)).collect();
            triangles.clear();
            triangulator.triangulate(&points, &mut triangles);
            mesh.triangles.extend(triangles.iter().map(|t| t.map(|i| ids[i])));
            for k in 0..face.len() {
                let next = (k + 1) % face.len();
                if known_edges.insert((face[k].min(face[next]), face[k].max(face[next]))) {
                    mesh.edges.push([ids[k], ids[next]]);
                }
            }
        }
        mesh
    }

    /// Points without faces or edges.
    pub fn point_cloud(points: impl IntoIterator<Item = DVec3>) -> Self {
        let mut mesh = Self::default();
        for p in points {
            mesh.add_vertex(p, DVec3::Y);
        }
        mesh
    }

    /// Segments without faces.
    pub fn segments(segments: impl IntoIterator<Item = [DVec3; 2]>) -> Self {
        let mut mesh = Self::default();
        for [p, q] in segments {
            let edge = [mesh.add_vertex(p, DVec3::Y), mesh.add_vertex(q, DVec3::Y)];
            mesh.edges.push(edge);
        }
        mesh
    }

    /// The box around all vertices. `None` for an empty mesh.
    pub fn bounds(&self) -> Option<Aabb> {
        Aabb::around(self.positions.iter().copied())
    }

    /// Adds a vertex and gives its index.
    pub(crate) fn add_vertex(&mut self, position: DVec3, normal: DVec3) -> u32 {
        let index = index_u32(self.positions.len());
        self.positions.push(position);
        self.normals.push(normal);
        index
    }

    /// Adds a convex polygon as a fan of triangles around its first corner.
    pub(crate) fn add_polygon(&mut self, corners: &[u32]) {
        for k in 1..corners.len().saturating_sub(1) {
            self.triangles.push([corners[0], corners[k], corners[k + 1]]);
        }
    }
}

/// A vertex number. Meshes are indexed with 32 bits. Importers refuse larger ones ([`MAX_VERTICES`]).
#[expect(
    clippy::cast_possible_truncation,
    reason = "importers refuse meshes beyond 32-bit indices; primitives are small"
)]
pub(crate) fn index_u32(index: usize) -> u32 {
    assert!(index < MAX_VERTICES, "refused by importers");
    index as u32
}
