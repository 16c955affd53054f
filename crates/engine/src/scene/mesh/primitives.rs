//! Tessellated solids about the y axis, `[3]` "Primitivas".
//!
//! Every solid is closed, with outward normals. Smooth sides share their vertices, creases double them. Angles start on
//! +x and grow counter-clockwise seen from +y. The point at angle φ is (cos φ, y, −sin φ).
//!
//! *Edges.* Faceted solids (box, prism, pyramid) name every side of every face. Curved solids name their rims and up to
//! [`MAX_MERIDIANS`] meridians (and as many parallels as keep the meshes of the net about square), each along sides of
//! the tessellation: with up to [`MAX_MERIDIANS`] segments the wireframe shows the tessellation itself, with more it
//! stays legible.

use glam::{DVec2, DVec3};

use crate::geometry::{Angle, try_unit};
use crate::limits::{MAX_MERIDIANS, MAX_SEGMENTS, MIN_SEGMENTS};
use crate::scene::mesh::Mesh;

/// Half axes of the shape `ellipsoid`.
pub const ELLIPSOID_HALF_AXES: DVec3 = DVec3::new(1.0, 2.0 / 3.0, 0.5);
/// Radius of the circle that is the middle of the torus' tube.
pub const TORUS_RADIUS: f64 = 0.7;
/// Radius of the torus' tube.
pub const TORUS_TUBE: f64 = 0.3;

/// The number of segments used for a requested number of `segments`.
fn allowed(segments: u32) -> u32 {
    segments.clamp(MIN_SEGMENTS, MAX_SEGMENTS)
}

/// Cosine and sine of the k-th of n equal turns.
fn turn(k: u32, n: u32) -> (f64, f64) {
    let (sin, cos) = Angle::from_degrees(360.0 * f64::from(k) / f64::from(n)).sin_cos();
    (cos, sin)
}

/// True for the (at most `lines`) indices out of `n` that are drawn as edges, evenly spread, 0 among them.
fn is_drawn(k: u32, n: u32, lines: u32) -> bool {
    n <= lines || k == 0 || k * lines / n != (k - 1) * lines / n
}

/// The cube \[−1, 1\]³.
pub fn cube() -> Mesh {
    cuboid(DVec3::NEG_ONE, DVec3::ONE)
}

/// The box between two corners. Faces in the order −x, +x, −y, +y, −z, +z, two triangles each.
pub fn cuboid(min: DVec3, max: DVec3) -> Mesh {
    let corners: [DVec3; 8] = std::array::from_fn(|i| {
        DVec3::new(
            if i & 1 == 0 { min.x } else { max.x },
            if i & 2 == 0 { min.y } else { max.y },
            if i & 4 == 0 { min.z } else { max.z },
        )
    });
    let faces: [&[usize]; 6] =
        [&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 2, 3, 1], &[4, 5, 7, 6]];
    Mesh { closed: true, convex: true, ..Mesh::polyhedron(&corners, &faces) }
}

/// A regular prism with `sides` sides, circumradius 1, from y = 0 to y = 2. One vertex of the base on −z, so that for
/// an odd number of sides a face looks to +z.
pub fn prism(sides: u32) -> Mesh {
    let n = allowed(sides) as usize;
    let mut corners = Vec::with_capacity(2 * n);
    for y in [0.0, 2.0] {
        // sin and cos change places: angles are counted from −z here.
        corners.extend((0..allowed(sides)).map(|k| {
            let (cos, sin) = turn(k, allowed(sides));
            DVec3::new(-sin, y, -cos)
        }));
    }
    let bottom: Vec<usize> = (0..n).rev().collect();
    let top: Vec<usize> = (n..2 * n).collect();
    let sides: Vec<[usize; 4]> = (0..n).map(|k| [k, (k + 1) % n, n + (k + 1) % n, n + k]).collect();
    let mut faces: Vec<&[usize]> = vec![&bottom, &top];
    faces.extend(sides.iter().map(<[usize; 4]>::as_slice));
    Mesh { closed: true, convex: true, ..Mesh::polyhedron(&corners, &faces) }
}

/// A plate with a polygonal outline in x and y, counter-clockwise seen from +z, convex or not, from z = −`half_depth`
/// to z = `half_depth`.
pub fn plate(outline: &[DVec2], half_depth: f64) -> Mesh {
    let n = outline.len();
    let at = |z: f64| outline.iter().map(move |p| p.extend(z));
    let corners: Vec<DVec3> = at(half_depth).chain(at(-half_depth)).collect();
    let front: Vec<usize> = (0..n).collect();
    let back: Vec<usize> = (n..2 * n).rev().collect();
    let sides: Vec<[usize; 4]> = (0..n).map(|k| [k, n + k, n + (k + 1) % n, (k + 1) % n]).collect();
    let mut faces: Vec<&[usize]> = vec![&front, &back];
    faces.extend(sides.iter().map(<[usize; 4]>::as_slice));
    Mesh { closed: true, ..Mesh::polyhedron(&corners, &faces) }
}

/// A pyramid on the square \[−1, 1\]² of y = 0, with its apex at (0, 2, 0).
pub fn pyramid() -> Mesh {
    let corners = [
        DVec3::new(-1.0, 0.0, -1.0),
        DVec3::new(1.0, 0.0, -1.0),
        DVec3::new(1.0, 0.0, 1.0),
        DVec3::new(-1.0, 0.0, 1.0),
        DVec3::new(0.0, 2.0, 0.0),
    ];
    let faces: [&[usize]; 5] = [&[0, 1, 2, 3], &[3, 2, 4], &[2, 1, 4], &[1, 0, 4], &[0, 3, 4]];
    Mesh { closed: true, convex: true, ..Mesh::polyhedron(&corners, &faces) }
}

/// The unit sphere: `segments` meridians, half as many bands.
pub fn sphere(segments: u32) -> Mesh {
    ellipsoid(DVec3::ONE, segments)
}

/// An ellipsoid with the given half axes (> 0): `segments` meridians, half as many bands.
pub fn ellipsoid(half_axes: DVec3, segments: u32) -> Mesh {
    let n = allowed(segments);
    let bands = (n / 2).max(2);
    let mut mesh = Mesh { closed: true, convex: true, ..Mesh::default() };
    let add = |mesh: &mut Mesh, on_unit_sphere: DVec3| {
        mesh.add_vertex(on_unit_sphere * half_axes, try_unit(on_unit_sphere / half_axes).unwrap_or(DVec3::Y))
    };
    let south = add(&mut mesh, DVec3::NEG_Y);
    for band in 1..bands {
        let (up, ring) = latitude(band, bands);
        for k in 0..n {
            let (cos, sin) = turn(k, n);
            add(&mut mesh, DVec3::new(ring * cos, up, -ring * sin));
        }
    }
    let north = add(&mut mesh, DVec3::Y);

    let at = |band: u32, k: u32| 1 + (band - 1) * n + k % n;
    for k in 0..n {
        mesh.triangles.push([south, at(1, k + 1), at(1, k)]);
        for band in 1..bands - 1 {
            mesh.add_polygon(&[at(band, k), at(band, k + 1), at(band + 1, k + 1), at(band + 1, k)]);
        }
        mesh.triangles.push([north, at(bands - 1, k), at(bands - 1, k + 1)]);
        if is_drawn(k, n, MAX_MERIDIANS) {
            mesh.edges.push([south, at(1, k)]);
            mesh.edges.extend((1..bands - 1).map(|band| [at(band, k), at(band + 1, k)]));
            mesh.edges.push([at(bands - 1, k), north]);
        }
    }
    for band in (1..bands).filter(|&band| is_drawn(band, bands, MAX_MERIDIANS / 2)) {
        mesh.edges.extend((0..n).map(|k| [at(band, k), at(band, k + 1)]));
    }
    mesh
}

/// Height and ring radius of the k-th of n bands of the unit sphere, from the south pole up.
fn latitude(band: u32, bands: u32) -> (f64, f64) {
    let (sin, cos) = Angle::from_degrees(180.0 * f64::from(band) / f64::from(bands) - 90.0).sin_cos();
    (sin, cos)
}

/// A cylinder of radius 1 from y = 0 to y = 2.
pub fn cylinder(segments: u32) -> Mesh {
    let n = allowed(segments);
    let mut mesh = Mesh { closed: true, convex: true, ..Mesh::default() };
    let rim = |y: f64| (0..n).map(move |k| turn(k, n)).map(move |(cos, sin)| DVec3::new(cos, y, -sin));
    for p in rim(0.0).chain(rim(2.0)) {
        mesh.add_vertex(p, DVec3::new(p.x, 0.0, p.z));
    }
    for k in 0..n {
        let next = (k + 1) % n;
        mesh.add_polygon(&[k, next, n + next, n + k]);
        mesh.edges.push([k, next]);
        mesh.edges.push([n + k, n + next]);
        if is_drawn(k, n, MAX_MERIDIANS) {
            mesh.edges.push([k, n + k]);
        }
    }
    add_cap(&mut mesh, rim(0.0), DVec3::NEG_Y);
    add_cap(&mut mesh, rim(2.0), DVec3::Y);
    mesh
}

/// A cone of radius 1 on y = 0, with its apex at (0, 2, 0).
pub fn cone(segments: u32) -> Mesh {
    const HEIGHT: f64 = 2.0;
    let n = allowed(segments);
    let mut mesh = Mesh { closed: true, convex: true, ..Mesh::default() };
    // The normal leans up by the slope of the side: (h cos φ, r, −h sin φ).
    let slant = (1.0 + HEIGHT * HEIGHT).sqrt();
    let normal = |(cos, sin): (f64, f64)| DVec3::new(HEIGHT * cos, 1.0, -HEIGHT * sin) / slant;
    let rim = || (0..n).map(|k| turn(k, n)).map(|(cos, sin)| DVec3::new(cos, 0.0, -sin));
    for k in 0..n {
        let (cos, sin) = turn(k, n);
        mesh.add_vertex(DVec3::new(cos, 0.0, -sin), normal((cos, sin)));
    }
    // The apex has no normal of its own, so it has one vertex for each side, with the normal of the side's middle.
    for k in 0..n {
        let apex = mesh.add_vertex(DVec3::Y * HEIGHT, normal(turn(2 * k + 1, 2 * n)));
        mesh.triangles.push([k, (k + 1) % n, apex]);
        mesh.edges.push([k, (k + 1) % n]);
        if is_drawn(k, n, MAX_MERIDIANS) {
            mesh.edges.push([k, apex]);
        }
    }
    add_cap(&mut mesh, rim(), DVec3::NEG_Y);
    mesh
}

/// Closes a horizontal rim, given counter-clockwise seen from above, with one flat polygon.
fn add_cap(mesh: &mut Mesh, rim: impl Iterator<Item = DVec3>, normal: DVec3) {
    let mut ids: Vec<u32> = rim.map(|p| mesh.add_vertex(p, normal)).collect();
    if normal.y < 0.0 {
        ids.reverse();
    }
    mesh.add_polygon(&ids);
}

/// A torus about y, centre at the origin, radii [`TORUS_RADIUS`] and [`TORUS_TUBE`]: `segments` around, half as many
/// about the tube.
pub fn torus(segments: u32) -> Mesh {
    let n = allowed(segments);
    let m = (n / 2).max(MIN_SEGMENTS);
    let mut mesh = Mesh { closed: true, ..Mesh::default() };
    for k in 0..n {
        let (cos, sin) = turn(k, n);
        for j in 0..m {
            let (out, up) = turn(j, m);
            let ring = TORUS_RADIUS + TORUS_TUBE * out;
            mesh.add_vertex(
                DVec3::new(ring * cos, TORUS_TUBE * up, -ring * sin),
                DVec3::new(out * cos, up, -out * sin),
            );
        }
    }
    let at = |k: u32, j: u32| (k % n) * m + j % m;
    for k in 0..n {
        for j in 0..m {
            mesh.add_polygon(&[at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1)]);
            if is_drawn(k, n, MAX_MERIDIANS) {
                mesh.edges.push([at(k, j), at(k, j + 1)]);
            }
            if is_drawn(j, m, MAX_MERIDIANS / 2) {
                mesh.edges.push([at(k, j), at(k + 1, j)]);
            }
        }
    }
    mesh
}

/// The lines of a grid of `cells` × `cells` on the square \[−1, 1\]² of y = 0, each from end to end.
pub fn grid_lines(cells: u32) -> Vec<[DVec3; 2]> {
    let n = cells.clamp(1, MAX_SEGMENTS);
    let mut lines = Vec::with_capacity(2 * (n as usize + 1));
    for k in 0..=n {
        let x = 2.0 * f64::from(k) / f64::from(n) - 1.0;
        lines.push([DVec3::new(x, 0.0, -1.0), DVec3::new(x, 0.0, 1.0)]);
        lines.push([DVec3::new(-1.0, 0.0, x), DVec3::new(1.0, 0.0, x)]);
    }
    lines
}

/// A tiled square on y = 0, seen from above: `nx` × `nz` tiles between two corners, two triangles a tile, row by row
/// along x. It isn't closed, so it's invisible from below unless drawn on two sides.
pub fn tiles(min: [f64; 2], max: [f64; 2], nx: u32, nz: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let at = |t: u32, n: u32, a: f64, b: f64| a + (b - a) * f64::from(t) / f64::from(n.max(1));
    for j in 0..=nz {
        for i in 0..=nx {
            mesh.add_vertex(DVec3::new(at(i, nx, min[0], max[0]), 0.0, at(j, nz, min[1], max[1])), DVec3::Y);
        }
    }
    let row = nx + 1;
    for j in 0..nz {
        for i in 0..nx {
            let a = j * row + i;
            mesh.add_polygon(&[a, a + row, a + row + 1, a + 1]);
        }
    }
    for j in 0..=nz {
        mesh.edges.extend((0..nx).map(|i| [j * row + i, j * row + i + 1]));
    }
    for i in 0..=nx {
        mesh.edges.extend((0..nz).map(|j| [j * row + i, (j + 1) * row + i]));
    }
    mesh
}
