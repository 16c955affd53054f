//! The vertices of an object on the image: object → world → view → clip → pixels, in `f64` up to the pixels.

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use crate::drawing::single;
use crate::pipeline::Target;
use crate::pipeline::mesh::chunks::CHUNK;
use crate::pipeline::space::planes::{PlaneSet, outcode};
use crate::pipeline::space::projector::{BLOCK, ClipPoint, Projector, ViewFromObject};
use crate::simd::{round_to_steps, with_vectors};

/// The vertices of an object, and the way that they go.
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
    pub(crate) fn view(&self, index: u32) -> DVec3 {
        self.view_from_object.point(self.positions[index as usize])
    }

    /// A vertex in clip space.
    pub(crate) fn clip(&self, index: u32) -> ClipPoint {
        self.projector.clip(self.view(index))
    }
}

/// The vertices of an object on the image, in the order of the mesh; keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(crate) struct OnImage {
    /// Pixels, on the grid or not, and depth. What lies outside the volume is anywhere in the picture.
    pub(crate) positions: Vec<[f32; 3]>,
    /// See [`DepthScale::relative_inverse_w`](crate::pipeline::space::depths::DepthScale::relative_inverse_w); empty where nobody wants
    /// it.
    pub(crate) inverse_w: Vec<f32>,
    /// Of each vertex; empty where none is outside any plane.
    pub(crate) outcodes: Vec<PlaneSet>,
    /// The planes that any vertex is outside of.
    pub(crate) outside: PlaneSet,
    /// The picture is so large that differences of positions may not fit in single precision.
    pub(crate) huge: bool,
}

/// Some vertices on their way; the last two are empty where nobody wants them.
struct VertexChunk<'a> {
    given: &'a [DVec3],
    positions: &'a mut [[f32; 3]],
    inverse_w: &'a mut [f32],
    outcodes: &'a mut [PlaneSet],
}

impl OnImage {
    /// Takes each vertex once through all spaces, to the grid (`GRID`) or to where it lies, and holds it against the
    /// planes, if the object may cross any (`crosses`).
    pub(crate) fn fill<const GRID: bool>(
        &mut self,
        vertices: &Vertices,
        screen: &Screen,
        crosses: bool,
        want_inverse_w: bool,
    ) {
        let n = vertices.len();
        self.huge = screen.half_width.max(screen.half_height) > 0.5 * 65_536.0;
        // The old content is overwritten.
        self.positions.resize(n, [0.0; 3]);
        self.inverse_w.resize(if want_inverse_w { n } else { 0 }, 0.0);
        self.outcodes.resize(if crosses { n } else { 0 }, 0);
        let (mut inverse_w, mut outcodes) = (self.inverse_w.chunks_mut(CHUNK), self.outcodes.chunks_mut(CHUNK));
        let stretches = vertices.positions.chunks(CHUNK).zip(self.positions.chunks_mut(CHUNK));
        let stretches = stretches.map(|(given, positions)| VertexChunk {
            given,
            positions,
            inverse_w: inverse_w.next().unwrap_or_default(),
            outcodes: outcodes.next().unwrap_or_default(),
        });
        let fill = |mut stretch: VertexChunk| with_vectors!(_simd => stretch.fill::<GRID>(vertices, screen));
        let either = |a: PlaneSet, b: PlaneSet| a | b;
        self.outside = if n > 2 * CHUNK {
            stretches.collect::<Vec<_>>().into_par_iter().map(fill).reduce(|| 0, either)
        } else {
            stretches.map(fill).fold(0, either)
        };
        if self.outside == 0 {
            self.outcodes.clear();
        }
    }
}

impl VertexChunk<'_> {
    /// Returns the planes that any vertex is outside of.
    #[inline(always)]
    fn fill<const GRID: bool>(&mut self, vertices: &Vertices, screen: &Screen) -> PlaneSet {
        let Vertices { projector, view_from_object, .. } = *vertices;
        let (mut x, mut y, mut z, mut w) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        let mut image = [[0.0_f32; BLOCK]; 3];
        let mut outside = 0;
        for (k, given) in self.given.chunks(BLOCK).enumerate() {
            let here = k * BLOCK..k * BLOCK + given.len();
            view_from_object.offsets(given, [&mut x, &mut y, &mut z]);
            for l in 0..BLOCK {
                let p = projector.clip(view_from_object.of_offset(DVec3::new(x[l], y[l], z[l])));
                (x[l], y[l], z[l], w[l]) = (p.x, p.y, p.depth, p.w);
            }
            if let Some(outcodes) = self.outcodes.get_mut(here.clone()) {
                for (l, code) in outcodes.iter_mut().enumerate() {
                    *code = outcode(projector, ClipPoint { x: x[l], y: y[l], w: w[l], depth: z[l] });
                }
                outside = outcodes.iter().fold(outside, |all, code| all | code);
            }
            for l in 0..BLOCK {
                let p = screen.project(projector, ClipPoint { x: x[l], y: y[l], w: w[l], depth: z[l] });
                [image[0][l], image[1][l], image[2][l]] = if GRID { on_grid(p) } else { off_grid(p) };
            }
            for (l, position) in self.positions[here.clone()].iter_mut().enumerate() {
                *position = [image[0][l], image[1][l], image[2][l]];
            }
            if let Some(inverse_w) = self.inverse_w.get_mut(here) {
                for (l, inverse_w) in inverse_w.iter_mut().enumerate() {
                    *inverse_w = projector.depths.relative_inverse_w(w[l]);
                }
            }
        }
        outside
    }
}

/// Clip space → image pixels with depth: divide and viewport.
#[derive(Clone, Debug)]
pub(crate) struct Screen {
    half_width: f64,
    half_height: f64,
}

/// Corners of triangles lie on this grid of the pixel, so that decisions about a triangle (its orientation, its
/// coverage) are exact arithmetic on the very numbers that are drawn.
pub(crate) const SUBPIXELS: f64 = 256.0;

impl Screen {
    pub(crate) fn new(target: Target) -> Self {
        Self { half_width: f64::from(target.width) / 2.0, half_height: f64::from(target.height) / 2.0 }
    }

    /// Half of the picture's width and height, pixels.
    pub(crate) fn half_size(&self) -> DVec2 {
        DVec2::new(self.half_width, self.half_height)
    }

    /// A point of the window, by its x_n and y_n, in pixels (y down).
    pub(crate) fn pixels(&self, ndc: DVec2) -> DVec2 {
        self.half_size() + DVec2::new(ndc.x, -ndc.y) * self.half_size()
    }

    /// Greatest distance by which [`on_grid`] moves a point of this picture, pixels: half a step of the grid in x and
    /// in y, and no more than that by single precision, as long as that has the steps.
    pub(crate) fn of_grid(&self) -> f64 {
        let single = 2.0 * self.half_size().max_element() * f64::from(f32::EPSILON);
        2.0 * (0.5 / SUBPIXELS).max(single)
    }

    /// A point inside the volume in pixels (y down), with the depth of the display list.
    #[inline(always)]
    pub(crate) fn project(&self, projector: &Projector, p: ClipPoint) -> [f64; 3] {
        let inverse_w = 1.0 / p.w;
        [
            clamp((p.x * inverse_w) * self.half_width + self.half_width, 2.0 * self.half_width),
            clamp(self.half_height - (p.y * inverse_w) * self.half_height, 2.0 * self.half_height),
            clamp(projector.depths.depth_by(p.depth, inverse_w), projector.depths.greatest()),
        ]
    }
}

/// Into 0 … limit; 0 where it is not a number.
#[inline(always)]
fn clamp(value: f64, limit: f64) -> f64 {
    let v = if value > 0.0 { value } else { 0.0 };
    if v < limit { v } else { limit }
}

/// To the display list, exactly on the grid of [`SUBPIXELS`].
#[inline(always)]
pub(crate) fn on_grid(p: [f64; 3]) -> [f32; 3] {
    off_grid([round_to_steps(p[0], SUBPIXELS), round_to_steps(p[1], SUBPIXELS), p[2]])
}

/// To the display list, without the grid.
#[inline(always)]
pub(crate) fn off_grid(p: [f64; 3]) -> [f32; 3] {
    [single(p[0]), single(p[1]), single(p[2])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_has_256_places_a_pixel_and_rounds_to_the_nearest() {
        assert_eq!(on_grid([10.0, 0.0, 0.5]), [10.0, 0.0, 0.5]);
        assert_eq!(on_grid([100.0 + 1.4 / 256.0, 3.0 + 1.6 / 256.0, 0.5]), [100.0 + 1.0 / 256.0, 3.0078125, 0.5]);
    }
}
