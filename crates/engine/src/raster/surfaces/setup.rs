//! The set-up of one triangle of any size.
//!
//! The standard algorithm evaluates three edge functions at each pixel of the box, and in a large triangle half of the
//! box is outside. Here a row's first and last pixel inside are computed from the edges, for four rows (or the four
//! samples of a row) at once, and the pixels between them need no test. Double precision makes them exact, see
//! [`Borders`]. The gradients of attributes are computed in double precision too, because those of slivers are
//! differences of large numbers. The textbook's `triangle` has the same formulas in plain numbers.

use std::ops::Range;

use crate::raster::grid::{HALF, STEPS, snapped};
use crate::simd::prelude::*;
use crate::simd::round_bits_f64;

/// A triangle of any size, ready to be filled.
#[derive(Clone, Debug)]
pub(super) struct Triangle {
    /// The vertices on the grid, turned so that the edge functions are positive inside.
    pub(super) v: [[i32; 2]; 3],
    /// Vertex 0 in pixels, the anchor of the planes. Exact.
    pub(super) origin: [f32; 2],
    /// Coefficients of a gradient from the differences to vertex 0, per pixel: ∂q/∂x = d1·m[0] − d2·m[1], ∂q/∂y =
    /// d2·m[2] − d1·m[3].
    m: [f64; 4],
    /// Vertices 1 and 2 changed places.
    turned: bool,
}

impl Triangle {
    /// `None` for a triangle without area on the grid, or out of its reach.
    pub(super) fn new(p: &[[f32; 3]; 3]) -> Option<Self> {
        let v = [snapped(p[0])?, snapped(p[1])?, snapped(p[2])?];
        // Differences are below 2²⁴ and products below 2⁴⁸: exact in f64.
        let side = |a: [i32; 2], b: [i32; 2]| [f64::from(b[0] - a[0]), f64::from(b[1] - a[1])];
        let (p, q) = (side(v[0], v[1]), side(v[0], v[2]));
        let area = p[0] * q[1] - p[1] * q[0];
        if area == 0.0 {
            return None;
        }
        let turned = area < 0.0;
        let (v, p, q) = if turned { ([v[0], v[2], v[1]], q, p) } else { (v, p, q) };
        let scale = f64::from(STEPS) / area.abs();
        Some(Self {
            origin: [v[0][0] as f32 / STEPS as f32, v[0][1] as f32 / STEPS as f32],
            m: [q[1] * scale, p[1] * scale, p[0] * scale, q[0] * scale],
            v,
            turned,
        })
    }

    /// The values of the three vertices in the triangle's own order.
    pub(super) fn own_order<T: Copy>(&self, q: [T; 3]) -> [T; 3] {
        if self.turned { [q[0], q[2], q[1]] } else { q }
    }

    /// The plane through values at the three vertices, in the order in which they came.
    pub(super) fn plane(&self, q: [f32; 3]) -> AffineValue {
        let q = self.own_order(q);
        let (d1, d2) = (f64::from(q[1]) - f64::from(q[0]), f64::from(q[2]) - f64::from(q[0]));
        #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
        let (dx, dy) = ((d1 * self.m[0] - d2 * self.m[1]) as f32, (d2 * self.m[2] - d1 * self.m[3]) as f32);
        let (low, high) = (lesser(lesser(q[0], q[1]), q[2]), greater(greater(q[0], q[1]), q[2]));
        AffineValue { value: q[0], dx, dy, low, high }
    }
}

/// The starts and ends of the rows of a triangle: two lines at the left, two at the right. Four at a time: the rows of
/// the four samples of a pixel, or with one sample per pixel, four rows that follow one another.
///
/// The edge function of a → b at a sample of pixel (i, j), divided by [`STEPS`] and rounded down, isn't negative
/// inside. It is a·i + b·j + c in whole numbers. Row j of that edge begins after x = −(b·j + c + ½)/a if a > 0, and
/// ends before that x + 1 if a < 0: in both cases at ⌊x⌋ + 1. x is at least ½/|a| ≥ 2⁻²⁵ away from whole numbers,
/// while its three roundings together are below 2⁻¹²/|a|. The result is that of exact arithmetic.
#[derive(Clone, Copy)]
pub(super) struct Borders<K: Simd> {
    /// x at row 0, and its change from row to row.
    lines: [(f64x4<K>, f64x4<K>); 4],
    /// The rows that the triangle has.
    first: f64x4<K>,
    end: f64x4<K>,
    width: f64x4<K>,
    /// The rows that are found together, from the first.
    down: f64x4<K>,
}

/// Rows that [`Borders`] finds together.
pub(super) const ROWS: usize = 4;

impl<K: Simd> Borders<K> {
    /// Finds the borders of a triangle whose edge functions are positive inside. `samples` is one or four, `width` that
    /// of the picture.
    #[inline(always)]
    pub(super) fn new(simd: K, v: &[[i32; 2]; 3], samples: &[[i32; 2]], width: i32) -> Self {
        let sample: [[i32; 2]; ROWS] = std::array::from_fn(|l| samples[l % samples.len()]);
        let constant = |value: f64| (f64x4::splat(simd, 0.0), f64x4::splat(simd, value));
        let mut lines = [constant(-1.0), constant(-1.0), constant(1e9), constant(1e9)];
        let (mut left, mut right) = (0, 2);
        for k in 0..3 {
            let (from, to) = (v[k], v[(k + 1) % 3]);
            let (a, b) = (from[1] - to[1], to[0] - from[0]);
            if a == 0 {
                // A level edge bounds rows, and no columns.
                continue;
            }
            // Only a left edge, whose a is positive, owns its points. The other is moved inwards by the least step.
            let place = |l: usize, c: usize| i64::from(HALF + sample[l][c] - from[c]);
            let c = |l: usize| i64::from(a) * place(l, 0) + i64::from(b) * place(l, 1) - i64::from(a < 0);
            let inverse = -1.0 / f64::from(a);
            let starts: [f64; ROWS] = std::array::from_fn(|l| ((c(l) >> 8) as f64 + 0.5) * inverse);
            let line = (f64x4::from_slice(simd, &starts), f64x4::splat(simd, f64::from(b) * inverse));
            let side = if a > 0 { &mut left } else { &mut right };
            lines[*side] = line;
            *side += 1;
        }
        if left == 1 {
            lines[1] = lines[0];
        }
        if right == 3 {
            lines[3] = lines[2];
        }
        // Rows with a sample in the box. Samples on its lower border belong to the triangle below.
        let rows = |y: i32| {
            let row = |l: usize| f64::from((y - HALF - sample[l][1] + STEPS - 1) >> 8);
            f64x4::from_slice(simd, &[row(0), row(1), row(2), row(3)])
        };
        let first = rows(v[0][1].min(v[1][1]).min(v[2][1]));
        let end = rows(v[0][1].max(v[1][1]).max(v[2][1]));
        let down = if samples.len() == 1 { [0.0, 1.0, 2.0, 3.0] } else { [0.0; ROWS] };
        let down = f64x4::from_slice(simd, &down);
        Self { lines, first, end, width: f64x4::splat(simd, f64::from(width)), down }
    }

    /// True if no row has a pixel inside. `together`: rows that [`rows`](Self::rows) finds, one or four.
    #[inline(always)]
    pub(super) fn are_empty(&self, rows: Range<i32>, together: usize) -> bool {
        for first in rows.step_by(together) {
            let (from, to) = self.rows(first);
            for l in 0..ROWS {
                if from[l] < to[l] {
                    return false;
                }
            }
        }
        true
    }

    /// The first pixels of rows inside the triangle and the first ones behind it, between 0 and the width. They are
    /// equal or the wrong way round for rows without a pixel inside. `first` is the first row, or the only one.
    #[inline(always)]
    pub(super) fn rows(&self, first: i32) -> ([i32; ROWS], [i32; ROWS]) {
        let j = self.down + f64::from(first);
        let x = |k: usize| self.lines[k].0 + self.lines[k].1 * j;
        // ⌊x⌋ + 1 is x + ½ rounded to nearest, as x isn't a whole number.
        let after = |x: f64x4<K>| round_bits_f64(x + 0.5);
        let zero = f64x4::splat(self.width.witness(), -0.75);
        let from = x(0).max(x(1)).max(zero).min(self.width);
        // A row outside the triangle ends at 0.
        let own = j.simd_ge(self.first) & j.simd_lt(self.end);
        let to = own.select(x(2).min(x(3)).max(zero).min(self.width - 0.75), zero);
        (after(from), after(to))
    }
}

/// A value that is affine over the picture: `value` at the origin of its triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct AffineValue {
    pub(super) value: f32,
    /// Change per pixel.
    pub(super) dx: f32,
    pub(super) dy: f32,
    /// The range of the vertices.
    pub(super) low: f32,
    pub(super) high: f32,
}

/// Above this number of a format, 2²³, single precision has whole numbers only. Added and taken away, it rounds the
/// numbers below.
const WHOLE: f32 = 8_388_608.0;

/// Depths as stored by a format whose greatest number is `greatest`. 0 leaves them as they are.
#[inline(always)]
pub(super) fn stored<K: Simd>(z: f32x8<K>, greatest: f32) -> f32x8<K> {
    if greatest <= 0.0 {
        return z;
    }
    let steps = z * greatest;
    let whole = steps.simd_lt(WHOLE).select((steps + WHOLE) - WHOLE, steps);
    whole * (1.0 / greatest)
}

/// True if a pixel of any of the masks is set.
#[inline(always)]
pub(super) fn any<K: Simd>(masks: &[mask32x8<K>]) -> bool {
    let mut all = masks[0];
    for mask in &masks[1..] {
        all |= *mask;
    }
    all.any_true()
}

/// The greater of two numbers. One machine instruction, while `f64::max` takes four for the sake of NaN.
#[inline(always)]
pub(super) fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The lesser of two numbers.
#[inline(always)]
pub(super) fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// Sides of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) width: i32,
    pub(super) height: i32,
}

/// The values at three indices; `None` if one is missing.
#[inline(always)]
pub(super) fn pick<T: Copy>(values: &[T], at: [usize; 3]) -> Option<[T; 3]> {
    Some([*values.get(at[0])?, *values.get(at[1])?, *values.get(at[2])?])
}
