//! The faces of one object that are left to draw: projected, culled, clipped.

use glam::DVec3;
use rayon::prelude::*;

use super::clip::{ALL_PLANES, Clipper, NEAR, NOT_A_NUMBER, PlaneSet};
use super::cull::{area_on_image, facing};
use super::transform::{OnImage, Screen, Vertices, on_grid};

/// A vertex that clipping made: attributes are the sum of those of three vertices, weighted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Vertices of the triangle that was cut.
    pub(super) of: [u32; 3],
    /// Their shares; they add up to 1.
    pub(super) weights: [f64; 3],
}

impl Cut {
    /// An attribute of the vertex, from that of each vertex of the mesh.
    pub(super) fn mean(&self, attribute: impl Fn(u32) -> DVec3) -> DVec3 {
        (0..3).fold(DVec3::ZERO, |sum, i| sum + attribute(self.of[i]) * self.weights[i])
    }
}

/// A triangle that crosses planes of the volume.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    /// Its index in the mesh.
    source: u32,
    triangle: [u32; 3],
    planes: PlaneSet,
}

/// What culling leaves of a stretch of triangles; one for each thread.
#[derive(Clone, Debug, Default)]
struct Part {
    triangles: Vec<[u32; 3]>,
    source: Vec<u32>,
    crossing: Vec<Crossing>,
    back: usize,
    turned_over: usize,
}

/// What is left of the triangles of one object; keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(super) struct Faces {
    /// All vertices of the mesh on the image, then the cuts.
    pub(super) image: OnImage,
    /// Indices of vertices.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The triangle of the mesh that each one comes from.
    pub(super) source: Vec<u32>,
    /// The vertices that clipping made.
    pub(super) cuts: Vec<Cut>,
    /// Triangles that were dropped because they turn away.
    pub(super) back: usize,
    /// Triangles that turn the other way on the grid of the image than they do in the world: thin ones, at silhouettes.
    pub(super) turned_over: usize,
    parts: Vec<Part>,
    clipper: Clipper,
}

/// What is done with the faces of one object.
#[derive(Clone, Copy, Debug)]
pub(super) struct FaceTask {
    /// Drop the faces that turn their back.
    pub(super) cull_back: bool,
    /// Find out whether a triangle turned over.
    pub(super) watch_turning: bool,
}

impl Faces {
    /// True where the near plane cuts the object, so that its inside may be seen.
    pub(super) fn cut_open(&self) -> bool {
        self.image.outcodes.iter().any(|code| code & NEAR != 0)
    }

    /// Drops triangles that lie outside one plane, and those that turn their back. Those that cross a plane are left to
    /// [`clip`](Self::clip).
    pub(super) fn cull(&mut self, vertices: &Vertices, triangles: &[[u32; 3]], task: FaceTask) {
        const FEW: usize = 1 << 14;
        let threads = if triangles.len() < FEW { 1 } else { rayon::current_num_threads() };
        let stretch = triangles.len().div_ceil(threads).max(1);
        let count = triangles.len().div_ceil(stretch);
        self.parts.resize_with(count.max(self.parts.len()), Part::default);
        let (image, parts) = (&self.image, &mut self.parts[..count]);
        let cull = |(k, part): (usize, &mut Part)| {
            let first = k * stretch;
            let end = triangles.len().min(first + stretch);
            part.cull(image, vertices, &triangles[first..end], first, task);
        };
        if count > 1 {
            parts.par_iter_mut().enumerate().for_each(cull);
        } else {
            parts.iter_mut().enumerate().for_each(cull);
        }
        self.triangles.clear();
        self.source.clear();
        (self.back, self.turned_over) = (0, 0);
        for part in &mut self.parts[..count] {
            self.back += part.back;
            self.turned_over += part.turned_over;
            if self.triangles.is_empty() {
                std::mem::swap(&mut self.triangles, &mut part.triangles);
                std::mem::swap(&mut self.source, &mut part.source);
            } else {
                self.triangles.extend_from_slice(&part.triangles);
                self.source.extend_from_slice(&part.source);
            }
        }
        self.parts[count..].iter_mut().for_each(|part| part.crossing.clear());
    }

    /// Cuts the triangles that cross a plane, and adds what is left of each as a fan. With `all_planes`, also against the planes
    /// that they do not cross.
    pub(super) fn clip(&mut self, vertices: &Vertices, screen: &Screen, all_planes: bool) {
        self.cuts.clear();
        for &Crossing { source, triangle, planes } in self.parts.iter().flat_map(|part| &part.crossing) {
            let corners = triangle.map(|i| vertices.clip(i));
            let planes = if all_planes { ALL_PLANES } else { planes };
            let mut fan = [0_u32; 2];
            for (i, corner) in self.clipper.triangle(vertices.projector, corners, planes).iter().enumerate() {
                let index = match corner.original() {
                    Some(own) => triangle[own],
                    None => {
                        let index = u32::try_from(self.image.positions.len()).unwrap_or(u32::MAX);
                        self.image.positions.push(on_grid(screen.project(vertices.projector, corner.point)));
                        if !self.image.inverse_w.is_empty() {
                            self.image.inverse_w.push(vertices.projector.relative_inverse_w(corner.point.w));
                        }
                        self.cuts.push(Cut { of: triangle, weights: corner.weights });
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

impl Part {
    fn cull(&mut self, image: &OnImage, vertices: &Vertices, triangles: &[[u32; 3]], first: usize, task: FaceTask) {
        self.triangles.clear();
        self.source.clear();
        self.crossing.clear();
        (self.back, self.turned_over) = (0, 0);
        let positions = &image.positions[..];
        let front = vertices.view_from_object.outward();
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        for (source, &triangle) in (first..).zip(triangles) {
            let [a, b, c] = triangle.map(|i| i as usize);
            let (Some(&p), Some(&q), Some(&r)) = (positions.get(a), positions.get(b), positions.get(c)) else {
                continue;
            };
            let planes = match image.outcodes[..] {
                [] => 0,
                _ => {
                    let codes = [image.outcodes[a], image.outcodes[b], image.outcodes[c]];
                    if codes[0] & codes[1] & codes[2] != 0 || (codes[0] | codes[1] | codes[2]) & NOT_A_NUMBER != 0 {
                        continue;
                    }
                    codes[0] | codes[1] | codes[2]
                }
            };
            let in_world = || facing(vertices.projector, triangle.map(|i| vertices.view(i)));
            let area = if planes == 0 { area_on_image(p, q, r) } else { in_world() };
            if task.watch_turning && planes == 0 && area * in_world() < 0.0 {
                self.turned_over += 1;
            }
            if area == 0.0 || (task.cull_back && area * front < 0.0) {
                self.back += 1;
            } else if planes == 0 {
                self.triangles.push(triangle);
                self.source.push(source);
            } else {
                self.crossing.push(Crossing { source, triangle, planes });
            }
        }
    }
}
