//! The faces of one object that are left to draw: culled, clipped, projected.

use glam::DVec3;

use super::clip::{Clipper, NOT_A_NUMBER, PlaneSet, outcode};
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

/// How many triangles went where.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct FaceCounts {
    /// Outside one plane of the volume, dropped whole.
    pub(super) outside: usize,
    /// Turned away, or without area on the image.
    pub(super) back: usize,
    /// Cut by a plane of the volume.
    pub(super) cut: usize,
    /// Left to draw.
    pub(super) drawn: usize,
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
    outcodes: Vec<PlaneSet>,
    clipper: Clipper,
}

/// What is done with the faces of one object.
#[derive(Clone, Copy, Debug)]
pub(super) struct FaceTask {
    /// The planes that the object may cross.
    pub(super) planes: PlaneSet,
    /// Drop the faces that turn their back.
    pub(super) cull_back: bool,
    /// The object is mirrored: its triangles run the other way round.
    pub(super) mirrored: bool,
}

impl Faces {
    /// Culls, clips and projects `triangles` over `vertices`.
    pub(super) fn collect(
        &mut self,
        projector: &Projector,
        screen: &Screen,
        vertices: &ViewVertices,
        triangles: &[[u32; 3]],
        task: FaceTask,
    ) -> FaceCounts {
        self.project(projector, screen, vertices, task.planes);
        let mut counts = FaceCounts::default();
        let front = if task.mirrored { -1.0 } else { 1.0 };
        for (source, &triangle) in (0_u32..).zip(triangles) {
            let [a, b, c] = triangle.map(|i| i as usize);
            if a.max(b).max(c) >= vertices.len() {
                continue;
            }
            let codes = if task.planes == 0 { [0; 3] } else { [self.outcodes[a], self.outcodes[b], self.outcodes[c]] };
            let either = codes[0] | codes[1] | codes[2];
            if codes[0] & codes[1] & codes[2] != 0 || either & NOT_A_NUMBER != 0 {
                counts.outside += 1;
                continue;
            }
            let area = if either == 0 {
                area_on_image(self.positions[a], self.positions[b], self.positions[c])
            } else {
                facing(projector, triangle.map(|i| vertices.point(i)))
            } * front;
            if area == 0.0 || (task.cull_back && area < 0.0) {
                counts.back += 1;
                continue;
            }
            if either == 0 {
                self.triangles.push(triangle);
                self.source.push(source);
            } else {
                counts.cut += 1;
                self.clip(projector, screen, vertices, triangle, source, either);
            }
        }
        counts.drawn = self.triangles.len();
        counts
    }

    fn project(&mut self, projector: &Projector, screen: &Screen, vertices: &ViewVertices, planes: PlaneSet) {
        self.positions.clear();
        self.triangles.clear();
        self.source.clear();
        self.cuts.clear();
        self.outcodes.clear();
        for i in 0..vertices.len() {
            let p = projector.clip(vertices.at(i));
            self.positions.push(on_grid(screen.project(projector, p)));
            if planes != 0 {
                self.outcodes.push(outcode(projector, p));
            }
        }
    }

    /// Cuts one triangle, and adds what is left as a fan.
    fn clip(
        &mut self,
        projector: &Projector,
        screen: &Screen,
        vertices: &ViewVertices,
        triangle: [u32; 3],
        source: u32,
        planes: PlaneSet,
    ) {
        let corners = triangle.map(|i| projector.clip(vertices.point(i)));
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
