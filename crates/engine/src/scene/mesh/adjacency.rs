//! Adjacency of the faces of a mesh along their edges, from which silhouettes are found.

use glam::{DVec3, DVec4};

/// The faces of a mesh and the edges at which two of them meet. An edge that one face has alone, a border, is not among
/// them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Adjacency {
    /// The plane of each face, in the mesh's own space. The inner product with (p, 1) is positive where p is before the
    /// face.
    pub planes: Vec<DVec4>,
    /// Each edge once, even if the mesh has its vertices doubled: one that two edges end at has one index in both.
    pub edges: Vec<SharedEdge>,
}

/// An edge at which two faces meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SharedEdge {
    /// Indices into the mesh's `positions`.
    pub ends: [u32; 2],
    /// Indices into [`Adjacency::planes`].
    pub faces: [u32; 2],
    /// The surface has an edge here, however fine its tessellation. The faces don't share the vertices of either end.
    pub crease: bool,
}

/// A side of a triangle.
#[derive(Clone, Copy)]
struct Side {
    /// Its ends, one index for all vertices at one place, the lesser first.
    place: [u32; 2],
    /// Its own vertices, in the same order.
    own: [u32; 2],
    face: u32,
}

impl Adjacency {
    /// The adjacency of the triangles of a mesh. Vertices are at one place if their coordinates are equal.
    pub fn of(positions: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let places = places(positions);
        let mut sides: Vec<Side> = Vec::with_capacity(3 * triangles.len());
        for (face, &[a, b, c]) in (0..).zip(triangles) {
            for own in [[a, b], [b, c], [c, a]] {
                let place = own.map(|i| places[i as usize]);
                let (place, own) =
                    if place[0] > place[1] { ([place[1], place[0]], [own[1], own[0]]) } else { (place, own) };
                sides.push(Side { place, own, face });
            }
        }
        sides.sort_by_key(|side| (side.place, side.face));
        let together = sides.chunk_by(|a, b| a.place == b.place);
        let edges = together.filter_map(|sides| match sides {
            [one, other] => Some(SharedEdge {
                ends: one.place,
                faces: [one.face, other.face],
                crease: (0..2).all(|end| one.own[end] != other.own[end]),
            }),
            _ => None,
        });
        Self {
            edges: edges.collect(),
            planes: triangles.iter().map(|t| plane(t.map(|i| positions[i as usize]))).collect(),
        }
    }
}

/// The first vertex at the place of each.
pub(crate) fn places(positions: &[DVec3]) -> Vec<u32> {
    // −0 is 0.
    let bits = |i: u32| (positions[i as usize] + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut sorted: Vec<u32> = (0..).zip(positions).map(|(i, _)| i).collect();
    sorted.sort_unstable_by_key(|&i| (bits(i), i));
    let mut places = vec![0; positions.len()];
    for same in sorted.chunk_by(|&i, &j| bits(i) == bits(j)) {
        for &i in same {
            places[i as usize] = same[0];
        }
    }
    places
}

fn plane([a, b, c]: [DVec3; 3]) -> DVec4 {
    let normal = (b - a).cross(c - a).normalize_or_zero();
    // Measured from the middle, because no corner is more exact than another.
    normal.extend(-normal.dot((a + b + c) / 3.0))
}
