//! The outline of a curved solid: its silhouette, which depends on the viewpoint, and its creases.
//!
//! A mesh's edge is on the silhouette if one of its two faces is seen from outside and the other isn't. The drawn
//! contour is that of the mesh, which borders the filled area, and not that of the ideal surface.

use glam::DVec4;

use crate::scene::SharedEdge;
use crate::scene::mesh::Mesh;

/// A face is seen edge-on if it's turned from the eye by less than this, relative to the numbers that decide it.
const EDGE_ON: f64 = 1e-9;

/// The outline of a mesh seen from `eye`, as polylines of vertices: silhouettes, then creases, each from end to end or
/// round to its beginning. `eye` is homogeneous, in the mesh's own space: a point, or with w = 0 the direction towards
/// the eye.
pub(crate) fn outline(mesh: &Mesh, eye: DVec4) -> Vec<Vec<u32>> {
    let adjacency = &mesh.adjacency;
    let seen: Vec<bool> = adjacency.planes.iter().map(|&plane| is_seen(plane, eye)).collect();
    let is_seen = |face: u32| seen.get(face as usize) == Some(&true);
    let [mut silhouette, mut creases] = [Vec::new(), Vec::new()];
    for edge in &adjacency.edges {
        let SharedEdge { ends, faces: [one, other], crease } = *edge;
        if crease {
            creases.push(ends);
        } else if is_seen(one) != is_seen(other) {
            silhouette.push(ends);
        }
    }
    let mut chains = chained(&silhouette);
    chains.extend(chained(&creases));
    chains
}

/// True if the eye is before a face. False if the face is edge-on, whatever rounding says, so that both triangles of a
/// quadrilateral agree.
fn is_seen(plane: DVec4, eye: DVec4) -> bool {
    let size = plane.truncate().length() * eye.truncate().length() + (plane.w * eye.w).abs();
    plane.dot(eye) > EDGE_ON * size
}

/// Edges, joined to polylines of maximal length so that dashes don't begin again at each vertex.
fn chained(edges: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut at: Vec<(u32, usize)> =
        edges.iter().enumerate().flat_map(|(k, ends)| ends.map(|vertex| (vertex, k))).collect();
    at.sort_unstable();
    let mut used = vec![false; edges.len()];
    let mut chains = Vec::new();
    let mut walk = |start: u32| {
        let mut chain = vec![start];
        let mut here = start;
        while let Some(k) = edges_at(&at, here).find(|&k| !used[k]) {
            used[k] = true;
            let [a, b] = edges[k];
            here = if a == here { b } else { a };
            chain.push(here);
        }
        if chain.len() > 1 {
            chains.push(chain);
        }
    };
    // Those with an end begin there; the rest are closed.
    for ends in at.chunk_by(|a, b| a.0 == b.0).filter(|ends| ends.len() % 2 == 1) {
        walk(ends[0].0);
    }
    edges.iter().for_each(|ends| walk(ends[0]));
    chains
}

/// The edges that end at a vertex.
fn edges_at(at: &[(u32, usize)], vertex: u32) -> impl Iterator<Item = usize> {
    let first = at.partition_point(|&(v, _)| v < vertex);
    at[first..].iter().take_while(move |&&(v, _)| v == vertex).map(|&(_, k)| k)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_joined_from_an_end_or_round() {
        assert_eq!(chained(&[[2, 3], [1, 2], [3, 4]]), [vec![1, 2, 3, 4]]);
        assert_eq!(chained(&[[5, 6], [7, 6], [5, 7]]), [vec![5, 6, 7, 5]]);
        assert_eq!(chained(&[[1, 2], [8, 9]]), [vec![1, 2], vec![8, 9]]);
        assert_eq!(chained(&[]), Vec::<Vec<u32>>::new());
    }

    #[test]
    fn each_edge_is_drawn_once_where_many_meet() {
        let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [4, 5]];
        let chains = chained(&edges);
        let mut drawn: Vec<[u32; 2]> =
            chains.iter().flat_map(|chain| chain.windows(2)).map(|p| [p[0].min(p[1]), p[0].max(p[1])]).collect();
        drawn.sort_unstable();
        assert_eq!(drawn, edges);
    }
}
