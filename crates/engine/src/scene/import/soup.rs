//! From the polygons of a file to a mesh: triangles, normals, edges, and whether the surface is closed.
//!
//! Files index points, normals and texture coordinates apart, or repeat a point for each of its normals. A mesh has one
//! index for each vertex, so vertices with the same point and normal become one. They're found in a list for each
//! point, which is short except in hostile files. A side that two faces have in opposite directions joins them. If
//! every side is like this, the surface is closed, and its back faces can be dropped.

use std::sync::Arc;

use glam::DVec3;

use super::part::{Imported, LeftOut, Part};
use crate::appearance::Rgba;
use crate::geometry::try_unit;
use crate::limits::MAX_VERTICES;
use crate::progress::{Progress, pause};
use crate::scene::MeshError;
use crate::scene::mesh::Mesh;
use crate::scene::mesh::adjacency::places;
use crate::scene::mesh::polygon::{self, Triangulator};
use crate::scene::texture::{CornerUv, split};

/// The threshold for missing normals, cos 45°. Faces that meet at less than this angle are smoothed together.
const CREASE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Number of vertices at one place that are compared before a new one is made. More come only from meshes made to
/// annoy.
const MOST_COMPARED: u32 = 64;

/// No index.
const NONE: u32 = u32::MAX;

/// Polygons as a file lists them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Soup {
    /// Points.
    pub(crate) positions: Vec<DVec3>,
    /// The corners of all polygons, one polygon after the other: indices into `positions`, all in range.
    pub(crate) corners: Vec<u32>,
    /// The number of corners of each polygon. Empty: 3 each.
    pub(crate) arities: Vec<u32>,
    /// Normals of any length. Empty means to be computed.
    pub(crate) normals: Vec<DVec3>,
    /// For each corner, its normal: indices into `normals`, all in range. Empty means the same as `corners`.
    pub(crate) corner_normals: Vec<u32>,
    /// For each corner, its texture coordinates. Empty means there are none.
    pub(crate) corner_uv: Vec<[f32; 2]>,
    /// For each corner, its base colour. Empty means that of the material.
    pub(crate) corner_colors: Vec<Rgba>,
}

/// The parts of a file that gives each its name, and nothing else, with the notice of what was left out.
pub(super) async fn named_parts(
    soups: Vec<(String, Soup)>,
    left_out: LeftOut,
    progress: &Progress,
) -> Result<Imported, MeshError> {
    let mut triangulator = Triangulator::default();
    let mut parts = Vec::new();
    for (name, mut soup) in soups {
        pause().await;
        if progress.is_cancelled() {
            return Err(MeshError::Cancelled);
        }
        soup.weld();
        parts.push(Part { name, ..soup.into_part(&mut triangulator)? });
    }
    parts.retain(|part| !part.mesh.triangles.is_empty());
    Ok(Imported { parts, notices: left_out.notice().into_iter().chain(triangulator.notice()).collect() })
}

impl Soup {
    /// Merges points with equal coordinates, because some formats repeat a point for each of its normals.
    pub(crate) fn weld(&mut self) {
        let first_of = places(&self.positions);
        if self.corner_normals.is_empty() && !self.normals.is_empty() {
            self.corner_normals.clone_from(&self.corners);
        }
        for corner in &mut self.corners {
            *corner = first_of[*corner as usize];
        }
    }

    /// The part of a file with this mesh. Its vertices are there once for each of their colours.
    pub(crate) fn into_part(self, triangulator: &mut Triangulator) -> Result<Part, MeshError> {
        let (mesh, uv, corner_colors) = self.into_mesh(triangulator)?;
        let first = corner_colors.first().map(|[first, ..]| *first);
        let color = first.filter(|first| corner_colors.iter().flatten().all(|color| color == first));
        let (mesh, colors) = match first {
            Some(first) if color.is_none() => split(&mesh, &corner_colors, first, |color| color),
            _ => (mesh, Vec::new()),
        };
        let two_sided = !mesh.closed;
        let (mesh, uv, colors) = (Arc::new(mesh), Arc::new(uv), Arc::new(colors));
        Ok(Part { mesh, uv, color, colors, two_sided, ..Part::default() })
    }

    /// The mesh. Polygons may be concave. Corners that repeat the one before are left out, and so are polygons that
    /// keep fewer than three. Given normals are taken unless one has no length. Missing ones are means over the faces
    /// that meet at a point (weighted by area), with creases at 45° and more.
    ///
    /// *Edges* are the sides of the polygons; *closed* means that each side is met by another one in the other
    /// direction.
    ///
    /// With it come the texture coordinates and the colours of the corners of each triangle, if there are any.
    fn into_mesh(self, triangulator: &mut Triangulator) -> Result<MeshAndCorners, MeshError> {
        if self.corners.len() >= MAX_VERTICES || self.positions.len() >= MAX_VERTICES {
            return Err(MeshError::TooLarge);
        }
        let normals: Option<Vec<DVec3>> = self.normals.iter().map(|&n| try_unit(n)).collect();
        let normals = normals.filter(|n| !n.is_empty());
        let mut maker = Maker { first_vertex: vec![NONE; self.positions.len()], ..Maker::default() };
        let mut start = 0;
        let mut polygon = Polygon::default();
        let polygons = if self.arities.is_empty() { self.corners.len() / 3 } else { self.arities.len() };
        for k in 0..polygons {
            let arity = self.arities.get(k).map_or(3, |&a| a as usize);
            let corners = start..(start + arity).min(self.corners.len());
            start = corners.end;
            polygon.take(&self, corners);
            if polygon.ids.len() < 3 {
                continue;
            }
            let area = polygon::doubled_area(polygon.points.iter().copied());
            let face_normal = try_unit(area);
            polygon.vertices.clear();
            for k in 0..polygon.ids.len() {
                let (id, point) = (polygon.ids[k], polygon.points[k]);
                let vertex = match &normals {
                    Some(normals) => {
                        let corner = polygon.corners[k];
                        let index = self.corner_normals.get(corner).unwrap_or(&self.corners[corner]);
                        let normal = normals[*index as usize];
                        maker.vertex(id, point, |known| known == normal, normal)
                    }
                    None => maker.smooth_vertex(id, point, area, face_normal),
                };
                polygon.vertices.push(vertex);
            }
            polygon.triangles.clear();
            triangulator.triangulate(&polygon.points, &mut polygon.triangles);
            maker.add(&polygon);
            polygon.append(&mut maker.uv, &self.corner_uv);
            polygon.append(&mut maker.colors, &self.corner_colors);
        }
        let (uv, colors) = (std::mem::take(&mut maker.uv), std::mem::take(&mut maker.colors));
        Ok((maker.finish(normals.is_none()), uv, colors))
    }
}

/// A mesh, and the texture coordinates and the colours of the corners of its triangles.
type MeshAndCorners = (Mesh, Vec<CornerUv>, Vec<[Rgba; 3]>);

/// One polygon, while it is worked on.
#[derive(Default)]
struct Polygon {
    corners: Vec<usize>,
    ids: Vec<u32>,
    points: Vec<DVec3>,
    vertices: Vec<u32>,
    triangles: Vec<[usize; 3]>,
}

impl Polygon {
    /// The corners of a polygon, without those that repeat the one before.
    fn take(&mut self, soup: &Soup, corners: std::ops::Range<usize>) {
        self.corners.clear();
        self.ids.clear();
        for corner in corners {
            let id = soup.corners[corner];
            if self.ids.last() != Some(&id) {
                self.corners.push(corner);
                self.ids.push(id);
            }
        }
        while self.ids.len() > 1 && self.ids.first() == self.ids.last() {
            self.ids.pop();
            self.corners.pop();
        }
        self.points.clear();
        self.points.extend(self.ids.iter().map(|&id| soup.positions[id as usize]));
    }

    /// Adds an attribute of its corners for each of its triangles, if the corners have it.
    fn append<T: Copy>(&self, to: &mut Vec<[T; 3]>, of_corners: &[T]) {
        if !of_corners.is_empty() {
            to.extend(self.triangles.iter().map(|t| t.map(|i| of_corners[self.corners[i]])));
        }
    }
}

/// The mesh, while it grows. The vertices at one point are a linked list.
#[derive(Default)]
struct Maker {
    first_vertex: Vec<u32>,
    next_vertex: Vec<u32>,
    mesh: Mesh,
    /// Direction and ends of each side (see [`side_key`]), and its two vertices.
    sides: Vec<(u64, [u32; 2])>,
    /// Texture coordinates of the corners of each triangle.
    uv: Vec<CornerUv>,
    /// The same of colours.
    colors: Vec<[Rgba; 3]>,
}

/// The ends of a side, the lesser first, and in the lowest bit its direction. Indices have 31 bits.
fn side_key(from: u32, to: u32) -> u64 {
    u64::from(from.min(to)) << 33 | u64::from(from.max(to)) << 1 | u64::from(from < to)
}

impl Maker {
    /// The vertex at point `id` whose normal is the `same`, or a new one.
    fn vertex(&mut self, id: u32, point: DVec3, same: impl Fn(DVec3) -> bool, normal: DVec3) -> u32 {
        let mut at = self.first_vertex[id as usize];
        for _ in 0..MOST_COMPARED {
            if at == NONE {
                break;
            }
            if same(self.mesh.normals[at as usize]) {
                return at;
            }
            at = self.next_vertex[at as usize];
        }
        let vertex = self.mesh.add_vertex(point, normal);
        self.next_vertex.push(self.first_vertex[id as usize]);
        self.first_vertex[id as usize] = vertex;
        vertex
    }

    /// The vertex at point `id` that a face belongs to: the first one whose faces so far are on average within the
    /// crease angle. Until the end `normals` holds the sum of the faces' areas.
    fn smooth_vertex(&mut self, id: u32, point: DVec3, area: DVec3, face_normal: Option<DVec3>) -> u32 {
        let Some(normal) = face_normal else {
            // A face without area belongs anywhere.
            return self.vertex(id, point, |_| true, DVec3::ZERO);
        };
        let fits = |sum: DVec3| try_unit(sum).is_none_or(|mean| mean.dot(normal) > CREASE);
        let vertex = self.vertex(id, point, fits, DVec3::ZERO);
        self.mesh.normals[vertex as usize] += area;
        vertex
    }

    fn add(&mut self, polygon: &Polygon) {
        let n = polygon.ids.len();
        self.mesh.triangles.extend(polygon.triangles.iter().map(|t| t.map(|i| polygon.vertices[i])));
        for k in 0..n {
            let next = (k + 1) % n;
            let key = side_key(polygon.ids[k], polygon.ids[next]);
            self.sides.push((key, [polygon.vertices[k], polygon.vertices[next]]));
        }
    }

    fn finish(mut self, computed: bool) -> Mesh {
        if computed {
            for n in &mut self.mesh.normals {
                *n = try_unit(*n).unwrap_or(DVec3::Y);
            }
        }
        self.sides.sort_unstable();
        self.mesh.closed = !self.sides.is_empty();
        for same in self.sides.chunk_by(|a, b| a.0 >> 1 == b.0 >> 1) {
            self.mesh.edges.push(same[0].1);
            let forward = same.iter().filter(|s| s.0 & 1 == 1).count();
            self.mesh.closed &= 2 * forward == same.len();
        }
        self.mesh.triangles.shrink_to_fit();
        self.mesh.positions.shrink_to_fit();
        self.mesh.normals.shrink_to_fit();
        self.mesh.edges.shrink_to_fit();
        self.mesh
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(weld_needed: bool) -> Soup {
        let mesh = crate::scene::mesh::primitives::cube();
        if weld_needed {
            return Soup { positions: mesh.positions, corners: mesh.triangles.concat(), ..Soup::default() };
        }
        let corner = |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2));
        Soup {
            positions: (0..8).map(corner).collect(),
            corners: vec![0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6],
            arities: vec![4; 6],
            ..Soup::default()
        }
    }

    #[test]
    fn a_cube_without_normals_gets_creases_and_its_twelve_edges() -> Result<(), MeshError> {
        let (mesh, ..) = cube(false).into_mesh(&mut Triangulator::default())?;
        assert_eq!((mesh.positions.len(), mesh.triangles.len(), mesh.edges.len()), (24, 12, 12));
        assert!(mesh.closed);
        for t in &mesh.triangles {
            let face = polygon::normal(t.map(|i| mesh.positions[i as usize]));
            assert!(t.iter().all(|&i| Some(mesh.normals[i as usize]) == face));
        }
        Ok(())
    }

    #[test]
    fn doubled_points_are_welded_before_the_border_is_looked_for() -> Result<(), MeshError> {
        assert!(!cube(true).into_mesh(&mut Triangulator::default())?.0.closed);
        let mut soup = cube(true);
        soup.weld();
        let (mesh, ..) = soup.into_mesh(&mut Triangulator::default())?;
        assert!(mesh.closed);
        assert_eq!((mesh.positions.len(), mesh.edges.len()), (24, 18));
        Ok(())
    }

    #[test]
    fn smooth_surfaces_share_their_vertices_and_their_normals_are_nearly_the_true_ones() -> Result<(), MeshError> {
        let sphere = crate::scene::mesh::primitives::sphere(64);
        let points = sphere.positions.len();
        let (mesh, ..) = Soup { positions: sphere.positions, corners: sphere.triangles.concat(), ..Soup::default() }
            .into_mesh(&mut Triangulator::default())?;
        assert_eq!(mesh.positions.len(), points);
        assert!(mesh.closed);
        for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
            assert!(p.dot(*n) > 0.995, "{}", p.dot(*n));
        }
        Ok(())
    }

    #[test]
    fn a_missing_or_turned_face_opens_the_surface_and_degenerate_faces_go() -> Result<(), MeshError> {
        let mut open = cube(false);
        open.arities.pop();
        open.corners.truncate(20);
        assert!(!open.into_mesh(&mut Triangulator::default())?.0.closed);
        let mut turned = cube(false);
        turned.corners[20..].reverse();
        assert!(!turned.into_mesh(&mut Triangulator::default())?.0.closed);
        let mut more = cube(false);
        more.corners.extend([0, 0, 1, 1, 0, 5, 5, 5]);
        more.arities.extend([5, 3]);
        let (mesh, ..) = more.into_mesh(&mut Triangulator::default())?;
        assert_eq!(mesh.triangles.len(), 12);
        assert!(mesh.closed);
        Ok(())
    }
}
