//! Texture coordinates of the primitives, and vertices that are there once for each of theirs.
//!
//! u goes to the right and v up, seen from outside. Angles are counted as in
//! [`primitives`](crate::scene::mesh::primitives), from +x counter-clockwise seen from above.
//!
//! | shape | u, v |
//! | --- | --- |
//! | box | each face once |
//! | cylinder | side: angle / 360°, height / 2; ends: (x + 1)/2 and ±z likewise |
//! | prism | the same, with angles from the vertex on −z |
//! | cone | side: angle / 360°, height / 2; base as an end of the cylinder |
//! | pyramid | sides: as the face of a box below, height / 2; base as a face of a box |
//! | sphere, ellipsoid | angle / 360°, latitude / 180° from the south pole |
//! | torus | angle / 360°, angle about the tube / 360° from its inside |

use std::collections::HashMap;
use std::f64::consts::TAU;
use std::hash::Hash;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{CornerUv, UvMesh};
use crate::appearance::Rgba;
use crate::scene::mesh::adjacency::Adjacency;
use crate::scene::mesh::index_u32;
use crate::scene::mesh::primitives::{ELLIPSOID_HALF_AXES, TORUS_RADIUS};
use crate::scene::{Mesh, Shape};

/// The colour of vertices without one.
const NO_COLOR: Rgba = Rgba::rgb(255, 255, 255);

/// A primitive with its texture coordinates.
pub(in crate::scene) fn mapped(shape: &Shape, mesh: &Mesh) -> UvMesh {
    let uv: Vec<CornerUv> = mesh.triangles.iter().map(|triangle| corners(shape, mesh, *triangle)).collect();
    UvMesh::new(mesh, &uv, &[])
}

/// The coordinates at the corners of a triangle of a primitive.
fn corners(shape: &Shape, mesh: &Mesh, triangle: [u32; 3]) -> CornerUv {
    let of = |values: &[DVec3], i: u32| values.get(i as usize).copied().unwrap_or_default();
    let points = triangle.map(|i| of(&mesh.positions, i));
    let middle = (points[0] + points[1] + points[2]) / 3.0;
    let normal = of(&mesh.normals, triangle[0]);
    let is_end = normal.y.abs() > 0.999;
    let at = |p: DVec3| match shape {
        Shape::Sphere => on_ball(p, middle, DVec3::ONE),
        Shape::Ellipsoid => on_ball(p, middle, ELLIPSOID_HALF_AXES),
        Shape::Torus => {
            let tube = |p: DVec3| (-p.y).atan2(TORUS_RADIUS - p.x.hypot(p.z)) / TAU;
            DVec2::new(around(p, middle), near(tube(p) + 0.5, tube(middle) + 0.5))
        }
        // Counted from a vertex, so that no side has the border of the picture in its middle.
        Shape::Prism if !is_end => {
            let from_vertex = |p: DVec3| DVec3::new(-p.z, p.y, p.x);
            DVec2::new(around(from_vertex(p), from_vertex(middle)), 0.5 * p.y)
        }
        Shape::Cylinder | Shape::Cone if !is_end => DVec2::new(around(p, middle), 0.5 * p.y),
        Shape::Pyramid if !is_end => DVec2::new(on_face(p, normal.with_y(0.0)).x, 0.5 * p.y),
        _ => on_face(p, normal),
    };
    // The picture has its first row at the top.
    points.map(at).map(|uv| {
        #[expect(clippy::cast_possible_truncation, reason = "texture coordinates are single precision")]
        [uv.x as f32, (1.0 - uv.y) as f32]
    })
}

/// On the face of the box \[−1, 1\]³ that looks along this normal.
fn on_face(p: DVec3, normal: DVec3) -> DVec2 {
    let (n, most) = (normal, normal.abs().max_element());
    let (right, up) = match () {
        () if n.y.abs() >= most => (DVec3::X, DVec3::new(0.0, 0.0, -n.y.signum())),
        () if n.x.abs() >= most => (DVec3::new(0.0, 0.0, -n.x.signum()), DVec3::Y),
        () => (DVec3::new(n.z.signum(), 0.0, 0.0), DVec3::Y),
    };
    DVec2::new(0.5 * (p.dot(right) + 1.0), 0.5 * (p.dot(up) + 1.0))
}

fn on_ball(p: DVec3, middle: DVec3, half_axes: DVec3) -> DVec2 {
    let latitude = (p.y / half_axes.y).clamp(-1.0, 1.0).asin();
    DVec2::new(around(p / half_axes, middle / half_axes), latitude / std::f64::consts::PI + 0.5)
}

/// The angle about y, in turns. On the axis, and behind the seam, that of the middle of the triangle continues.
fn around(p: DVec3, middle: DVec3) -> f64 {
    let turns = |p: DVec3| {
        let turns = (-p.z).atan2(p.x) / TAU;
        if turns < 0.0 { turns + 1.0 } else { turns }
    };
    if p.x.hypot(p.z) < 1e-9 { turns(middle) } else { near(turns(p), turns(middle)) }
}

/// The same turn, within half a turn of another.
fn near(turns: f64, other: f64) -> f64 {
    turns - (turns - other).round()
}

impl UvMesh {
    /// A mesh in which each vertex is there once for each of its texture coordinates. `uv` has those of the corners of
    /// each triangle, and `colors` that of each vertex, or none. Missing coordinates are (0, 0).
    pub(in crate::scene) fn new(old: &Mesh, uv: &[CornerUv], colors: &[Rgba]) -> Self {
        let with_color = |(uv, triangle): (&CornerUv, &[u32; 3])| {
            let color = |i: u32| colors.get(i as usize).copied().unwrap_or(NO_COLOR);
            std::array::from_fn(|k| (uv[k], color(triangle[k])))
        };
        let corners: Vec<[([f32; 2], Rgba); 3]> = uv.iter().zip(&old.triangles).map(with_color).collect();
        let (mesh, values) = split(old, &corners, ([0.0; 2], NO_COLOR), |(uv, color)| (uv.map(f32::to_bits), color));
        let (uv, own): (Vec<_>, Vec<_>) = values.into_iter().unzip();
        let colors = if colors.is_empty() { Vec::new() } else { own };
        Self { mesh: Arc::new(mesh), uv: Arc::new(uv), colors: Arc::new(colors) }
    }
}

/// A mesh in which each vertex is there once for each value that it has at the corners of triangles, and its values.
/// Missing ones are `none`. Values with equal keys are equal.
pub(in crate::scene) fn split<T: Copy, K: Eq + Hash>(
    old: &Mesh,
    corners: &[[T; 3]],
    none: T,
    key: impl Fn(T) -> K,
) -> (Mesh, Vec<T>) {
    let mut mesh = Mesh { closed: old.closed, convex: old.convex, ..Mesh::default() };
    let mut all = Vec::new();
    let mut known: HashMap<(u32, K), u32> = HashMap::with_capacity(old.positions.len());
    let mut first: Vec<Option<u32>> = vec![None; old.positions.len()];
    let mut vertex = |mesh: &mut Mesh, i: u32, value: T| {
        *known.entry((i, key(value))).or_insert_with(|| {
            let new = index_u32(mesh.positions.len());
            mesh.positions.push(old.positions.get(i as usize).copied().unwrap_or_default());
            // A mesh without normals stays without.
            mesh.normals.extend(old.normals.get(i as usize));
            all.push(value);
            if let Some(first) = first.get_mut(i as usize) {
                first.get_or_insert(new);
            }
            new
        })
    };
    for (k, triangle) in old.triangles.iter().enumerate() {
        let values = corners.get(k).copied().unwrap_or([none; 3]);
        let new = [0, 1, 2].map(|c| vertex(&mut mesh, triangle[c], values[c]));
        mesh.triangles.push(new);
    }
    // An edge may have vertices that no face has.
    for end in old.edges.iter().flatten() {
        if let Some(first @ None) = first.get_mut(*end as usize) {
            *first = Some(index_u32(mesh.positions.len()));
            mesh.positions.push(old.positions.get(*end as usize).copied().unwrap_or_default());
            mesh.normals.extend(old.normals.get(*end as usize));
            all.push(none);
        }
    }
    let of = |i: u32| first.get(i as usize).copied().flatten().unwrap_or_default();
    mesh.edges = old.edges.iter().map(|edge| edge.map(of)).collect();
    if old.adjacency != Adjacency::default() {
        mesh.adjacency = Adjacency::of(&mesh.positions, &mesh.triangles);
    }
    (mesh, all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::mesh::primitives;

    fn meshes() -> Vec<(Shape, Mesh)> {
        vec![
            (Shape::Box, primitives::cube()),
            (Shape::Prism, primitives::prism(6)),
            (Shape::Pyramid, primitives::pyramid()),
            (Shape::Sphere, primitives::sphere(32)),
            (Shape::Ellipsoid, primitives::ellipsoid(ELLIPSOID_HALF_AXES, 32)),
            (Shape::Cylinder, primitives::cylinder(32)),
            (Shape::Cone, primitives::cone(32)),
            (Shape::Torus, primitives::torus(32)),
        ]
    }

    /// No triangle goes the wrong way round the seam, none is mirrored, and each vertex has its coordinates.
    #[test]
    fn pictures_are_neither_torn_nor_mirrored() {
        for (shape, mesh) in meshes() {
            let UvMesh { mesh: textured, uv, .. } = mapped(&shape, &mesh);
            assert_eq!((textured.positions.len(), textured.normals.len()), (uv.len(), uv.len()), "{shape:?}");
            assert_eq!(textured.triangles.len(), mesh.triangles.len());
            for (triangle, old) in textured.triangles.iter().zip(&mesh.triangles) {
                let at = triangle.map(|i| uv[i as usize]);
                let places = triangle.map(|i| textured.positions[i as usize]);
                assert_eq!(places, old.map(|i| mesh.positions[i as usize]));
                for axis in 0..2 {
                    let values = at.map(|uv| uv[axis]);
                    let (low, high) =
                        (values.iter().copied().fold(9.0, f32::min), values.iter().copied().fold(-9.0, f32::max));
                    assert!(high - low <= 1.0 && low >= -0.01 && high <= 1.01 + 1.0 / 32.0, "{shape:?} {at:?}");
                }
                let side = |k: usize| [at[k][0] - at[0][0], at[k][1] - at[0][1]];
                let (p, q) = (side(1), side(2));
                // Counter-clockwise outside is clockwise if v goes down.
                assert!(p[0] * q[1] - p[1] * q[0] <= 1e-6, "{shape:?} {at:?}");
            }
            for (edge, old) in textured.edges.iter().zip(&mesh.edges) {
                assert_eq!(edge.map(|i| textured.positions[i as usize]), old.map(|i| mesh.positions[i as usize]));
            }
            assert_eq!(textured.adjacency == Adjacency::default(), mesh.adjacency == Adjacency::default());
        }
    }
}
