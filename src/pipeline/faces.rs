//! The faces of one object that are left to draw: culled, clipped, projected.

use glam::DVec3;

use super::clip::{ALL_PLANES, Clipper, NEAR, NOT_A_NUMBER, PlaneSet, outcode};
use super::cull::{area_on_image, facing};
use super::transform::{Projector, Screen, ViewVertices, on_grid};

/// A vertex that clipping made: attributes are the sum of those of three vertices, weighted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Vertices of the triangle that was cut.
    pub(super) of: [u32; 3],
    /// Their shares; they add up to 1.
    pub(super) weights: [f64; 3],
    /// Its homogeneous w.
    pub(super) w: f64,
}

impl Cut {
    /// An attribute of the vertex, from that of each vertex of the mesh.
    pub(super) fn mean(&self, attribute: impl Fn(u32) -> DVec3) -> DVec3 {
        (0..3).fold(DVec3::ZERO, |sum, i| sum + attribute(self.of[i]) * self.weights[i])
    }
}

/// What is left of the triangles of one object; keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(super) struct Faces {
    /// All vertices of the mesh on the image, then the cuts.
    pub(super) positions: Vec<[f32; 3]>,
    /// Indices into `positions`.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The triangle of the mesh that each one comes from.
    pub(super) source: Vec<u32>,
    /// The vertices that clipping made.
    pub(super) cuts: Vec<Cut>,
    /// Triangles that were dropped because they turn away.
    pub(super) back: usize,
    /// Triangles that turn the other way on the grid of the image than they do in the world: thin ones, at silhouettes.
    pub(super) turned_over: usize,
    /// Triangles that cross a plane: index in the mesh, corners, planes.
    crossing: Vec<(u32, [u32; 3], PlaneSet)>,
    /// Empty where the object crosses no plane.
    outcodes: Vec<PlaneSet>,
    clipper: Clipper,
}

/// What is done with the faces of one object.
#[derive(Clone, Copy, Debug)]
pub(super) struct FaceTask {
    /// Drop the faces that turn their back.
    pub(super) cull_back: bool,
    /// The object is mirrored: its triangles run the other way round.
    pub(super) mirrored: bool,
    /// Find out whether a triangle turned over.
    pub(super) watch_turning: bool,
}

impl Faces {
    /// Takes all vertices to the image, and holds them against the planes that the object may cross.
    pub(super) fn project(
        &mut self,
        projector: &Projector,
        screen: &Screen,
        vertices: &ViewVertices,
        planes: PlaneSet,
    ) {
        self.positions.clear();
        self.outcodes.clear();
        for i in 0..vertices.len() {
            let p = projector.clip(vertices.at(i));
            self.positions.push(on_grid(screen.project(projector, p)));
            if planes != 0 {
                self.outcodes.push(outcode(projector, p));
            }
        }
    }

    /// True where the near plane cuts the object, so that its inside may be seen.
    pub(super) fn cut_open(&self) -> bool {
        self.outcodes.iter().any(|code| code & NEAR != 0)
    }

    /// Drops triangles that lie outside one plane, and those that turn their back. Those that cross a plane are left to
    /// [`clip`](Self::clip).
    pub(super) fn cull(
        &mut self,
        projector: &Projector,
        vertices: &ViewVertices,
        triangles: &[[u32; 3]],
        task: FaceTask,
    ) {
        self.triangles.clear();
        self.source.clear();
        self.crossing.clear();
        (self.back, self.turned_over) = (0, 0);
        let front = if task.mirrored { -1.0 } else { 1.0 };
        for (source, &triangle) in (0_u32..).zip(triangles) {
            let [a, b, c] = triangle.map(|i| i as usize);
            if a.max(b).max(c) >= vertices.len() {
                continue;
            }
            let codes = match self.outcodes[..] {
                [] => [0; 3],
                _ => [self.outcodes[a], self.outcodes[b], self.outcodes[c]],
            };
            let crossed = codes[0] | codes[1] | codes[2];
            if codes[0] & codes[1] & codes[2] != 0 || crossed & NOT_A_NUMBER != 0 {
                continue;
            }
            let in_world = || facing(projector, triangle.map(|i| vertices.point(i)));
            let area = if crossed == 0 {
                let area = area_on_image(self.positions[a], self.positions[b], self.positions[c]);
                if task.watch_turning && area * in_world() < 0.0 {
                    self.turned_over += 1;
                }
                area
            } else {
                in_world()
            } * front;
            if area == 0.0 || (task.cull_back && area < 0.0) {
                self.back += 1;
            } else if crossed == 0 {
                self.triangles.push(triangle);
                self.source.push(source);
            } else {
                self.crossing.push((source, triangle, crossed));
            }
        }
    }

    /// Cuts the triangles that cross a plane, and adds what is left of each as a fan. With `all_planes`, also against the planes
    /// that they do not cross.
    pub(super) fn clip(&mut self, projector: &Projector, screen: &Screen, vertices: &ViewVertices, all_planes: bool) {
        self.cuts.clear();
        for &(source, triangle, crossed) in &self.crossing {
            let corners = triangle.map(|i| projector.clip(vertices.point(i)));
            let planes = if all_planes { ALL_PLANES } else { crossed };
            let mut fan = [0_u32; 2];
            for (i, corner) in self.clipper.triangle(projector, corners, planes).iter().enumerate() {
                let index = match corner.original() {
                    Some(own) => triangle[own],
                    None => {
                        let index = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
                        self.positions.push(on_grid(screen.project(projector, corner.point)));
                        self.cuts.push(Cut { of: triangle, weights: corner.weights, w: corner.point.w });
                        index
                    }
                };
                match i {
                    0 => fan[0] = index,
                    1 => fan[1] = index,
                    _ => {
                        self.triangles.push([fan[0], fan[1], index]);
                        self.source.push(source);
                        fan[1] = index;
                    }
                }
            }
        }
    }
}
