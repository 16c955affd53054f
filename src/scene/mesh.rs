//! The triangle mesh with its edges.

use glam::DVec3;

use crate::geometry::Aabb;

/// A mesh in its object's own space. Vertices that lie on a crease are there once for each side, each with its own normal.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub positions: Vec<DVec3>,
    /// Unit normals, one for each vertex; only an object that no light falls on may go without.
    pub normals: Vec<DVec3>,
    /// Counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The edges to draw: sides of polygons, not the diagonals that triangulation adds. Indices into `positions`, each
    /// edge once (also where vertices are doubled).
    pub edges: Vec<[u32; 2]>,
    /// The surface has no border: from outside no back face can be seen.
    pub closed: bool,
    /// The surface is convex (and closed).
    pub convex: bool,
}

impl Mesh {
    /// The box around all vertices; `None` for an empty mesh.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        Aabb::around(self.positions.iter().copied())
    }
}
