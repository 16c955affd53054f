//! A triangle of the textbook's rasterizer: its edges, and the planes of its attributes.

use std::ops::Range;

use crate::appearance::Rgba;
use crate::drawing::{Base, Surface, SurfaceLight};
use crate::raster::grid::{self, FINER, HIGHEST, REACH, STEEPEST, WIDEST, snapped_finely};

/// Steps of the grid per pixel.
pub(super) const STEPS: i32 = FINER * grid::STEPS;

/// A triangle, set up for painting.
pub(super) struct Triangle<'a> {
    pub(super) surface: &'a Surface,
    /// Its number in the surface.
    pub(super) number: usize,
    /// The numbers of its vertices in the lists of the surface.
    corners: [usize; 3],
    /// Depths and 1/w of the vertices.
    pub(super) depths: [f32; 3],
    pub(super) inverse_w: [f32; 3],
    /// The vertices in steps of 1/4096 pixel, in the order that makes edge functions positive inside.
    v: [[i32; 2]; 3],
    /// Vertices 1 and 2 changed places for that.
    turned: bool,
    /// Gradients are computed in single precision.
    single: bool,
}

/// A value that is affine over the picture.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    /// The value at the triangle's first vertex.
    value: f32,
    /// The change per pixel.
    pub(super) dx: f32,
    pub(super) dy: f32,
    /// The range of the vertices.
    pub(super) low: f32,
    pub(super) high: f32,
}

impl Plane {
    /// The value at a point relative to the first vertex, in pixels.
    pub(super) fn at(&self, [x, y]: [f32; 2]) -> f32 {
        x * self.dx + (y * self.dy + self.value)
    }

    /// Keeps a value in the range of the vertices. The centre of a pixel can lie outside a triangle that has samples
    /// of it, and there a plane leaves the range.
    pub(super) fn hold(&self, value: f32) -> f32 {
        value.max(self.low).min(self.high)
    }
}

impl<'a> Triangle<'a> {
    /// Returns `None` if it has no area on the grid, is out of the grid's reach, or lacks an attribute.
    pub(super) fn new(surface: &'a Surface, number: usize, samples: usize, fine: bool) -> Option<Self> {
        let corners = surface.triangles.get(number)?.map(|corner| corner as usize);
        let [a, b, c] = at_corners(&surface.positions, corners)?;
        let v = [snapped_finely(a, fine)?, snapped_finely(b, fine)?, snapped_finely(c, fine)?];
        let inverse_w = if surface.inverse_w.is_empty() { [1.0; 3] } else { at_corners(&surface.inverse_w, corners)? };
        let depths = [a[2], b[2], c[2]];
        let mut triangle = Self { surface, number, corners, depths, inverse_w, v, turned: false, single: false };
        if triangle.area() == 0 {
            return None;
        }
        if triangle.area() < 0 {
            (triangle.v, triangle.turned) = ([v[0], v[2], v[1]], true);
        }
        triangle.single = triangle.allows_single(samples)?;
        Some(triangle)
    }

    /// True if single precision is enough for gradients. It is for small triangles, of which the fast path sets up
    /// eight at once. It isn't for slivers, whose gradients are differences of large numbers, nor for colours that have
    /// to be divided by w.
    fn allows_single(&self, samples: usize) -> Option<bool> {
        let [wide, high] = [0, 1].map(|k| {
            let [p, q, r] = self.v.map(|v| v[k]);
            p.max(q).max(r) - p.min(q).min(r) + 2 * FINER * REACH[usize::from(samples > 1)]
        });
        let (differences, perspective) = if is_flat(self.surface) {
            (0.0, false)
        } else if let Some(colors) = vertex_colors(self.surface) {
            let differences = spread(self.of(colors)?);
            (differences, perspective_matters(differences, self.inverse_w))
        } else {
            (255.0, false)
        };
        // Bounds for the two terms of a gradient, whose difference it is.
        let scale = STEPS as f32 / self.area() as f32;
        let [ax, ay, bx, by] = self.sides().map(|side| (side as f32 * scale).abs());
        let steep = differences * (by + ay).max(ax + bx) >= STEEPEST;
        Some(wide < FINER * WIDEST && high < FINER * HIGHEST && !steep && !perspective)
    }

    /// The values of an attribute at the vertices. `None` if one is missing.
    pub(super) fn of<T: Copy>(&self, values: &[T]) -> Option<[T; 3]> {
        at_corners(values, self.corners)
    }

    /// The edges, each from a vertex to the next, in steps.
    pub(super) fn edges(&self) -> [[[i64; 2]; 2]; 3] {
        let [a, b, c] = self.v.map(|v| v.map(i64::from));
        [[a, b], [b, c], [c, a]]
    }

    /// The pixels of some rows of a picture in the triangle's box.
    pub(super) fn pixels(&self, width: u32, rows: &Range<u32>) -> impl Iterator<Item = [i32; 2]> + use<> {
        let [columns, rows] = [(0, &(0..width)), (1, rows)].map(|(k, all)| {
            let [p, q, r] = self.v.map(|v| v[k].div_euclid(STEPS));
            let [first, end] = [all.start, all.end].map(u32::cast_signed);
            p.min(q).min(r).max(first)..(p.max(q).max(r) + 1).min(end)
        });
        rows.flat_map(move |y| columns.clone().map(move |x| [x, y]))
    }

    /// The way from the first vertex to the centre of a pixel, in pixels. Exact.
    pub(super) fn to_center(&self, pixel: [i32; 2]) -> [f32; 2] {
        [0, 1].map(|k| (pixel[k] * STEPS + STEPS / 2 - self.v[0][k]) as f32 / STEPS as f32)
    }

    /// The place of the first vertex on the grid, in pixels.
    pub(super) fn origin(&self) -> [f64; 2] {
        self.v[0].map(|v| f64::from(v) / f64::from(STEPS))
    }

    /// The plane through values at the three vertices. The differences to the first vertex are two linear equations for
    /// the gradient, solved by Cramer's rule.
    pub(super) fn plane(&self, q: [f32; 3]) -> Plane {
        let [q0, q1, q2] = if self.turned { [q[0], q[2], q[1]] } else { q };
        macro_rules! gradient {
            ($float:ty) => {{
                let scale = STEPS as $float / self.area() as $float;
                let [ax, ay, bx, by] = self.sides().map(|side| side as $float * scale);
                let (a, b) = (<$float>::from(q1) - <$float>::from(q0), <$float>::from(q2) - <$float>::from(q0));
                [a * by - b * ay, b * ax - a * bx]
            }};
        }
        #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
        let [dx, dy] = if self.single { gradient!(f32) } else { gradient!(f64).map(|change| change as f32) };
        Plane { value: q0, dx, dy, low: q0.min(q1).min(q2), high: q0.max(q1).max(q2) }
    }

    /// The planes of the share of each vertex, which is 1 there and 0 at the others: barycentric coordinates.
    pub(super) fn share_planes(&self) -> [Plane; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|q| self.plane(q))
    }

    /// Twice the area, in steps².
    fn area(&self) -> i64 {
        let [ax, ay, bx, by] = self.sides().map(i64::from);
        ax * by - ay * bx
    }

    /// The sides from the first vertex to the other two, in steps.
    fn sides(&self) -> [i32; 4] {
        let [o, a, b] = self.v;
        [a[0] - o[0], a[1] - o[1], b[0] - o[0], b[1] - o[1]]
    }
}

fn at_corners<T: Copy>(values: &[T], [a, b, c]: [usize; 3]) -> Option<[T; 3]> {
    Some([*values.get(a)?, *values.get(b)?, *values.get(c)?])
}

/// True if a triangle has one colour, with its light.
pub(super) fn is_flat(surface: &Surface) -> bool {
    has_face_colors(surface) && surface.light == SurfaceLight::InBase
}

/// The colours of vertices, if nothing else is between the vertices and a pixel's colour.
pub(super) fn vertex_colors(surface: &Surface) -> Option<&[Rgba]> {
    match (&surface.base, &surface.light) {
        (Base::Vertices(colors), SurfaceLight::InBase) if !surface.translucent => Some(colors),
        _ => None,
    }
}

/// True if a triangle has one base colour, whatever its light.
pub(super) fn has_face_colors(surface: &Surface) -> bool {
    matches!(surface.base, Base::Solid(_) | Base::Faces(_))
}

/// The greatest difference between the channels of three colours.
pub(super) fn spread(colors: [Rgba; 3]) -> f32 {
    let range = |[a, b, c]: [u8; 3]| a.max(b).max(c) - a.min(b).min(c);
    f32::from(range(colors.map(|c| c.r)).max(range(colors.map(|c| c.g))).max(range(colors.map(|c| c.b))))
}

/// True if perspective can move a channel by half a step. If the w of two vertices have the ratio r, their perspective
/// shares differ from their affine ones by at most (√r − 1)/(√r + 1) ≤ (r − 1)/4.
pub(super) fn perspective_matters(spread: f32, [a, b, c]: [f32; 3]) -> bool {
    let (far, near) = (a.min(b).min(c), a.max(b).max(c));
    spread * (near - far) > 2.0 * far
}
