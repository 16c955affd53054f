//! The loop over the vertices of an object: the stages Transform, Off-axis window, Divide and Viewport in one go.
//!
//! *Notes*: `[0]` §5.3, object → world → view → clip by M_m, M_v and M_p, then NDC by Eq. (5.6), and §5.5 for the
//! pixel. `[2]`, *Transformações de um vértice*, draws the same way. *Textbook*: a pass over all vertices for each
//! stage, or one 4 × 4 matrix for all of them up to the divide. *Here*: each vertex goes through all spaces while it's
//! in registers, [`BLOCK`] vertices at a time with an array for each coordinate, so that the compiler makes vector
//! instructions of every step (eight lanes of `f32`, two or four of `f64`). That's why the four stages have one time
//! in the report, and why a vertex outside the volume is divided too. Each vertex is worked on once, however many
//! triangles share it.

use glam::DVec3;
use rayon::prelude::*;

use super::vertex::{
    clip_from_view, divide, oblique, project_symmetric, snap, transform, unsnapped, view_point, viewport,
};
use crate::appearance::VertexFormat;
use crate::pipeline::mesh::CHUNK;
use crate::pipeline::space::projector::{BLOCK, Projector, ViewFromObject};
use crate::pipeline::space::{ClipPoint, FromEye, ObjectPoint, PlaneSet, Screen, ViewPoint, outcode};
use crate::simd::with_vectors;

/// The vertices of an object, and the transforms that they go through.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertices<'a> {
    pub(crate) projector: &'a Projector,
    pub(crate) view_from_object: &'a ViewFromObject,
    /// In object space.
    pub(crate) positions: &'a [DVec3],
}

impl Vertices<'_> {
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }

    /// A vertex in view space.
    pub(crate) fn view_point(&self, index: u32) -> ViewPoint {
        view_point(self.view_from_object, ObjectPoint(self.positions[index as usize]))
    }

    /// A vertex in clip space.
    pub(crate) fn clip_point(&self, index: u32) -> ClipPoint {
        clip_from_view(self.projector, self.view_point(index))
    }
}

/// The vertices of an object on the image, in the order of the mesh. Keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(crate) struct OnImage {
    /// Pixels, on the grid or not, and depth. A vertex outside the volume is anywhere on the image.
    pub(crate) positions: Vec<[f32; 3]>,
    /// See [`DepthScale::relative_inverse_w`](crate::pipeline::space::depths::DepthScale::relative_inverse_w); empty if
    /// not requested.
    pub(crate) inverse_w: Vec<f32>,
    /// The planes that each vertex is outside of. Empty if none is outside any.
    pub(crate) outcodes: Vec<PlaneSet>,
    /// The planes that any vertex is outside of.
    pub(crate) outside: PlaneSet,
}

/// The precision of places on the image.
#[derive(Clone, Copy)]
pub(crate) enum Snap {
    /// On the grid of the image, for corners of triangles: neighbours agree.
    Grid,
    /// Exact, for ends of lines.
    Exact,
}

/// The data of vertices besides their places.
#[derive(Clone, Copy)]
pub(crate) struct Wanted {
    /// The planes of the volume that each is outside of. Needless if the object crosses none.
    pub(crate) outcodes: bool,
    /// 1/w, for attributes that perspective bends.
    pub(crate) inverse_w: bool,
}

/// A chunk of vertices. `inverse_w` and `outcodes` are empty if not requested.
struct VertexChunk<'a> {
    given: &'a [DVec3],
    positions: &'a mut [[f32; 3]],
    inverse_w: &'a mut [f32],
    outcodes: &'a mut [PlaneSet],
}

impl OnImage {
    /// Takes each vertex once through all spaces to the image.
    pub(crate) fn fill(&mut self, vertices: &Vertices, screen: &Screen, snap: Snap, wanted: Wanted) {
        let n = vertices.len();
        // The old content is overwritten.
        self.positions.resize(n, [0.0; 3]);
        self.inverse_w.resize(if wanted.inverse_w { n } else { 0 }, 0.0);
        self.outcodes.resize(if wanted.outcodes { n } else { 0 }, 0);
        let (mut inverse_w, mut outcodes) = (self.inverse_w.chunks_mut(CHUNK), self.outcodes.chunks_mut(CHUNK));
        let chunks = vertices.positions.chunks(CHUNK).zip(self.positions.chunks_mut(CHUNK));
        let chunks = chunks.map(|(given, positions)| VertexChunk {
            given,
            positions,
            inverse_w: inverse_w.next().unwrap_or_default(),
            outcodes: outcodes.next().unwrap_or_default(),
        });
        let fill = |mut chunk: VertexChunk| match snap {
            Snap::Grid => with_vectors!(_simd => chunk.fill::<true>(vertices, screen)),
            Snap::Exact => with_vectors!(_simd => chunk.fill::<false>(vertices, screen)),
        };
        let either = |a: PlaneSet, b: PlaneSet| a | b;
        self.outside = if n > 2 * CHUNK {
            chunks.collect::<Vec<_>>().into_par_iter().map(fill).reduce(|| 0, either)
        } else {
            chunks.map(fill).fold(0, either)
        };
        if self.outside == 0 {
            self.outcodes.clear();
        }
    }
}

impl VertexChunk<'_> {
    /// Takes the vertices from object space to the image. Returns the planes that any of them is outside of.
    ///
    /// `x`, `y` and `distance` first hold p − C, then the clip point. The compiler turns each loop over [`BLOCK`] into
    /// vector instructions. That's also why a short last block is worked on whole.
    #[inline(always)]
    fn fill<const GRID: bool>(&mut self, vertices: &Vertices, screen: &Screen) -> PlaneSet {
        let Vertices { projector, view_from_object, .. } = *vertices;
        let depths = &projector.depths;
        let (mut x, mut y, mut distance, mut w) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        let mut image = [[0.0_f32; BLOCK]; 3];
        let mut outside = 0;
        for (k, given) in self.given.chunks(BLOCK).enumerate() {
            let here = k * BLOCK..k * BLOCK + given.len();
            // Object → view → clip.
            view_from_object.offsets_from_eye(given, [&mut x, &mut y, &mut distance]);
            for l in 0..BLOCK {
                let from_eye = FromEye(DVec3::new(x[l], y[l], distance[l]));
                let p = oblique(projector, project_symmetric(projector, transform(view_from_object, from_eye)));
                (x[l], y[l], distance[l], w[l]) = (p.x, p.y, p.distance, p.w);
            }
            if projector.format != VertexFormat::F64 {
                for (l, &p) in given.iter().enumerate() {
                    let p = clip_from_view(projector, view_point(view_from_object, ObjectPoint(p)));
                    (x[l], y[l], distance[l], w[l]) = (p.x, p.y, p.distance, p.w);
                }
            }
            // The side of each plane, for culling and clipping.
            if let Some(outcodes) = self.outcodes.get_mut(here.clone()) {
                for (l, code) in outcodes.iter_mut().enumerate() {
                    *code = outcode(projector, ClipPoint { x: x[l], y: y[l], w: w[l], distance: distance[l] });
                }
                outside = outcodes.iter().fold(outside, |all, code| all | code);
            }
            // Clip → NDC → pixels.
            for l in 0..BLOCK {
                let p = divide(depths, ClipPoint { x: x[l], y: y[l], w: w[l], distance: distance[l] });
                let p = viewport(screen, p);
                [image[0][l], image[1][l], image[2][l]] = if GRID { snap(screen, p) } else { unsnapped(p) };
            }
            for (l, position) in self.positions[here.clone()].iter_mut().enumerate() {
                *position = [image[0][l], image[1][l], image[2][l]];
            }
            if let Some(inverse_w) = self.inverse_w.get_mut(here) {
                for (l, inverse_w) in inverse_w.iter_mut().enumerate() {
                    *inverse_w = depths.relative_inverse_w(w[l]);
                }
            }
        }
        outside
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::appearance::Rgba;
    use crate::camera::{Camera, Parameters};
    use crate::pipeline::Target;
    use crate::pipeline::space::{NdcPoint, Pixel};
    use glam::DMat4;

    #[test]
    fn a_vertex_goes_from_space_to_space() {
        // The eye is 5 before the origin and sees 90°: the window is ±1 on F = 1.
        let camera = Camera::new(&Parameters {
            position: DVec3::new(0.0, 0.0, 5.0),
            view_angle: 90.0,
            aspect: 1.0,
            near: 1.0,
            far: 3.0,
            ..Parameters::default()
        });
        let projector = Projector::new(&camera.unwrap());
        let screen = Screen::new(Target { width: 100, height: 100, scale: 1.0, background: Rgba::rgb(0, 0, 0) });
        // The object lies 2 to the right of the origin.
        let view_from_object = projector.view_from_object(DMat4::from_translation(2.0 * DVec3::X));
        let p_object = ObjectPoint(DVec3::new(-1.0, -1.0, 3.0));

        let from_eye = view_from_object.offset_from_eye(p_object);
        assert_eq!(from_eye, FromEye(DVec3::new(1.0, -1.0, -2.0)), "from C = (−2, 0, 5) in the object's space");
        let p_view = transform(&view_from_object, from_eye);
        assert_eq!(p_view, ViewPoint(DVec3::new(1.0, -1.0, -2.0)), "the camera isn't turned");
        let p_clip = clip_from_view(&projector, p_view);
        assert_eq!(p_clip, ClipPoint { x: 1.0, y: -1.0, w: 2.0, distance: 2.0 }, "w is the distance");
        let p_ndc = divide(&projector.depths, p_clip);
        assert_eq!(p_ndc, NdcPoint { x: 0.5, y: -0.5, depth: 0.25 }, "(B − d)/(B − F) · F/d = ½ · ½");
        let pixel = viewport(&screen, p_ndc);
        assert_eq!(pixel, Pixel { x: 75.0, y: 75.0, depth: 0.25 }, "y is down");
        assert_eq!(snap(&screen, pixel), [75.0, 75.0, 0.25]);

        // The loop over the vertices does the same.
        let positions = vec![p_object.0; 40];
        let vertices = Vertices { projector: &projector, view_from_object: &view_from_object, positions: &positions };
        let mut image = OnImage::default();
        image.fill(&vertices, &screen, Snap::Grid, Wanted { outcodes: true, inverse_w: true });
        assert_eq!(image.positions, [[75.0, 75.0, 0.25]; 40]);
        assert_eq!((image.inverse_w, image.outside), (vec![0.5; 40], 0));
    }

    /// The matrices of `[0]` in `f64`, with a rounding before and after each.
    #[test]
    fn a_format_rounds_before_and_after_both_matrices() {
        let camera = Camera::new(&Parameters {
            position: DVec3::new(3.1, 2.2, 4.7),
            focal_point: DVec3::new(0.3, -0.2, 0.1),
            view_angle: 50.0,
            near: 1.0,
            far: 9.0,
            ..Parameters::default()
        })
        .unwrap();
        let projection = camera.notes_clip_space().clip_from_view();
        for format in [VertexFormat::F32, VertexFormat::F16, VertexFormat::Bf16, VertexFormat::Fixed16] {
            let mut projector = Projector::new(&camera);
            projector.format = format;
            let round = |v: &[f64]| v.iter().map(|x| format.round(*x)).collect::<Vec<_>>();
            let view_from_object = projector.view_from_object(DMat4::from_translation(0.3 * DVec3::Y));
            let positions: Vec<DVec3> =
                (0..50).map(|k| DVec3::new(1.3, 0.7, 0.9) * (f64::from(k) * 0.7).sin()).collect();
            let vertices =
                Vertices { projector: &projector, view_from_object: &view_from_object, positions: &positions };
            for (k, p) in (0..).zip(&positions) {
                let world = DVec3::from_slice(&round(&(*p + 0.3 * DVec3::Y).to_array()));
                let view = DVec3::from_slice(&round(&camera.view_from_world().transform_point3(world).to_array()));
                assert_eq!(vertices.view_point(k).0, view, "{format:?}");
                let [x, y, z, w] = round(&(projection * view.extend(1.0)).to_array())[..] else { unreachable!() };
                let clip = vertices.clip_point(k);
                assert_eq!([clip.x, clip.y, clip.w], [x, y, w], "{format:?}");
                // (1 − z_n)/2 is the depth of the volume, to the rounding of z_r − w_r in f64.
                let depth = projector.depths.depth_by(clip.distance, 1.0 / clip.w);
                assert!((depth - 0.5 * (1.0 - z / w)).abs() < 1e-12, "{format:?}: {depth}");
            }
        }
    }
}
