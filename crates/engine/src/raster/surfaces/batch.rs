//! The set-up of eight triangles at a time.
//!
//! The standard algorithm sets up one triangle after the other. In a fine mesh a triangle has one or two pixels, so the
//! set-up is most of the work. Here eight triangles are set up at once, one in each lane of a vector, in whole numbers
//! of 32 bits and in single precision. The others go alone, through [`Triangle`](super::setup::Triangle). With a
//! million triangles, gathering and set-up are half of the rasterizer's time even so. The table in
//! [`fill`](super::fill) shows which triangle takes which path; the box of a triangle, the pixels whose samples it may
//! own, decides: [`one`](Batch::one), [`small`](Batch::small), or none of them.

use std::ops::Range;

use crate::drawing::Surface;
use crate::simd::prelude::*;
use crate::simd::round_bits;

use super::setup::{AffineValue, Size, Triangle, pick};
use crate::raster::grid::{FRACTION, GRID_ZERO, HALF, HIGHEST, OFFSET, REACH, STEPS, WIDEST};

/// Triangles in a batch.
pub(super) const BATCH: usize = 8;

/// Eight triangles by their vertices.
pub(super) struct Batch<K: Simd> {
    simd: K,
    /// Vertices on the snapping grid.
    x: [i32x8<K>; 3],
    y: [i32x8<K>; 3],
    /// The pixels that they may own.
    pub(super) left: i32x8<K>,
    pub(super) right: i32x8<K>,
    pub(super) top: i32x8<K>,
    pub(super) bottom: i32x8<K>,
    /// The triangles that may own a pixel at all.
    pub(super) some: mask32x8<K>,
    /// The triangles that 32 bits are enough for.
    pub(super) small: mask32x8<K>,
    /// The triangles that may own only one pixel.
    pub(super) one: mask32x8<K>,
}

/// The indices of the vertices of up to eight triangles, [`INVALID`] for missing ones.
pub(super) type Corners = [[u32; BATCH]; 3];

/// An index beyond the vertices of any surface.
const INVALID: u32 = u32::MAX;

#[inline(always)]
pub(super) fn corners(surface: &Surface, triangles: &[u32]) -> Corners {
    let mut corners = [[INVALID; BATCH]; 3];
    for (l, &triangle) in triangles.iter().take(BATCH).enumerate() {
        if let Some(triangle) = surface.triangles.get(triangle as usize) {
            for k in 0..3 {
                corners[k][l] = triangle[k];
            }
        }
    }
    corners
}

/// The corners of eight triangles that follow one another.
#[inline(always)]
pub(super) fn corners_of(triangles: &[[u32; 3]]) -> Corners {
    let mut corners = [[INVALID; BATCH]; 3];
    for (l, triangle) in triangles.iter().take(BATCH).enumerate() {
        for k in 0..3 {
            corners[k][l] = triangle[k];
        }
    }
    corners
}

/// The corners of one of them.
pub(super) fn corners_at(corners: &Corners, lane: usize) -> [usize; 3] {
    [corners[0][lane] as usize, corners[1][lane] as usize, corners[2][lane] as usize]
}

/// The value at each corner. NaN if there is none.
#[inline(always)]
pub(super) fn gather<K: Simd>(simd: K, values: &[f32], corners: &Corners) -> [f32x8<K>; 3] {
    let mut result = [f32x8::splat(simd, f32::NAN); 3];
    for k in 0..3 {
        let mut lanes = [f32::NAN; BATCH];
        for l in 0..BATCH {
            lanes[l] = values.get(corners[k][l] as usize).copied().unwrap_or(f32::NAN);
        }
        result[k] = f32x8::from_slice(simd, &lanes);
    }
    result
}

/// The points at each corner, by component. NaN if there is none.
#[inline(always)]
pub(super) fn gather_points<K: Simd>(simd: K, points: &[[f32; 3]], corners: &Corners) -> [[f32x8<K>; 3]; 3] {
    let mut result = [[f32x8::splat(simd, f32::NAN); 3]; 3];
    for k in 0..3 {
        let four = |first: usize| {
            let p = |l: usize| point(simd, points, corners[k][first + l] as usize);
            let [a, b, c, d] = [p(0), p(1), p(2), p(3)];
            let (ac, bd) = (a.zip_low(c), b.zip_low(d));
            [ac.zip_low(bd), ac.zip_high(bd), a.zip_high(c).zip_low(b.zip_high(d))]
        };
        let (low, high) = (four(0), four(4));
        for c in 0..3 {
            result[c][k] = low[c].combine(high[c]);
        }
    }
    result
}

/// A point, and anything behind it.
#[inline(always)]
fn point<K: Simd>(simd: K, points: &[[f32; 3]], index: usize) -> f32x4<K> {
    // Four numbers are read at once, except from the last point.
    match points.get(index..index.wrapping_add(2)) {
        Some(two) => f32x4::from_slice(simd, &two.as_flattened()[..4]),
        None => last_point(simd, points, index),
    }
}

#[cold]
fn last_point<K: Simd>(simd: K, points: &[[f32; 3]], index: usize) -> f32x4<K> {
    let [x, y, z] = points.get(index).copied().unwrap_or([f32::NAN; 3]);
    f32x4::from_slice(simd, &[x, y, z, 0.0])
}

impl<K: Simd> Batch<K> {
    /// Makes a batch from the coordinates of the vertices in pixels. `many` means several samples in a pixel.
    #[inline(always)]
    pub(super) fn new(simd: K, x: &[f32x8<K>; 3], y: &[f32x8<K>; 3], many: bool, size: Size) -> Self {
        let zero = i32x8::splat(simd, 0);
        let (mut grid_x, mut grid_y) = ([zero; 3], [zero; 3]);
        let mut wrong = zero;
        for k in 0..3 {
            let (bits_x, bits_y) = (grid_bits(x[k]), grid_bits(y[k]));
            wrong |= (bits_x ^ GRID_ZERO_BITS) | (bits_y ^ GRID_ZERO_BITS);
            grid_x[k] = (bits_x & FRACTION_BITS) - OFFSET;
            grid_y[k] = (bits_y & FRACTION_BITS) - OFFSET;
        }
        let reach = REACH[usize::from(many)];
        let low_x = grid_x[0].min(grid_x[1]).min(grid_x[2]) - (HALF + reach);
        let high_x = grid_x[0].max(grid_x[1]).max(grid_x[2]) - (HALF - reach);
        let low_y = grid_y[0].min(grid_y[1]).min(grid_y[2]) - (HALF + reach);
        let high_y = grid_y[0].max(grid_y[1]).max(grid_y[2]) - (HALF - reach);
        // Rounded up to a whole pixel.
        let left = ((low_x + (STEPS - 1)) >> 8).max(0);
        let right = ((high_x + (STEPS - 1)) >> 8).min(size.width);
        let top = ((low_y + (STEPS - 1)) >> 8).max(0);
        let bottom = ((high_y + (STEPS - 1)) >> 8).min(size.height);
        let valid = (wrong & !FRACTION_BITS).simd_eq(0);
        let some = valid & left.simd_lt(right) & top.simd_lt(bottom);
        let (width, height) = (high_x - low_x, high_y - low_y);
        let small = width.simd_lt(WIDEST) & height.simd_lt(HIGHEST);
        let one = small & (right - left).simd_eq(1) & (bottom - top).simd_eq(1);
        Self { simd, x: grid_x, y: grid_y, left, top, bottom, some, small, one, right }
    }

    /// The rows of one that lie in a band. None if it owns no sample.
    #[inline(always)]
    pub(super) fn rows(&self, lane: usize, band: &Range<i32>) -> Range<i32> {
        let end = if self.some[lane] != 0 { self.bottom[lane].min(band.end) } else { 0 };
        self.top[lane].max(band.start)..end
    }

    /// One of them on its own.
    pub(super) fn alone(&self, lane: usize, positions: &[[f32; 3]], corners: [usize; 3]) -> Option<Triangle> {
        if self.some[lane] == 0 {
            return None;
        }
        Triangle::new(&pick(positions, corners)?)
    }

    /// Prepares the small triangles. `first_row` is the row where the band begins.
    #[inline(always)]
    pub(super) fn set_up(&self, first_row: i32) -> SetUp<K> {
        let [mut x, mut y] = [self.x, self.y];
        let area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
        let turned = area.simd_lt(0);
        (x[1], x[2]) = (turned.select(x[2], x[1]), turned.select(x[1], x[2]));
        (y[1], y[2]) = (turned.select(y[2], y[1]), turned.select(y[1], y[2]));
        let area = turned.select(-area, area);
        let top = self.top.max(first_row);
        let zero = i32x8::splat(self.simd, 0);
        let (mut a, mut b, mut edges) = ([zero; 3], [zero; 3], [zero; 3]);
        let (center_x, center_y) = ((self.left << 8) + HALF, (top << 8) + HALF);
        for k in 0..3 {
            let next = (k + 1) % 3;
            (a[k], b[k]) = (y[k] - y[next], x[next] - x[k]);
            // An edge owns its points if it's left or top. Others are moved inwards by the least step.
            let owns = a[k].simd_gt(0) | (a[k].simd_eq(0) & b[k].simd_gt(0));
            let bias = owns.select(zero, zero - 1);
            edges[k] = a[k] * (center_x - x[k]) + b[k] * (center_y - y[k]) + bias;
        }
        let scale = f32x8::splat(self.simd, STEPS as f32) / area.to_float::<f32x8<K>>();
        let [m0, m1] = [(y[2] - y[0]).to_float::<f32x8<K>>() * scale, (y[1] - y[0]).to_float::<f32x8<K>>() * scale];
        let [m2, m3] = [(x[1] - x[0]).to_float::<f32x8<K>>() * scale, (x[2] - x[0]).to_float::<f32x8<K>>() * scale];
        SetUp {
            turned,
            has_area: area.simd_gt(0),
            a,
            b,
            edges,
            m: [m0, m1, m2, m3],
            origin: [x[0].to_float::<f32x8<K>>() * (1.0 / 256.0), y[0].to_float::<f32x8<K>>() * (1.0 / 256.0)],
        }
    }
}

/// [`GRID_ZERO`] and [`FRACTION`] as signed numbers.
const GRID_ZERO_BITS: i32 = GRID_ZERO.to_bits().cast_signed();
const FRACTION_BITS: i32 = FRACTION.cast_signed();

#[inline(always)]
fn grid_bits<K: Simd>(v: f32x8<K>) -> i32x8<K> {
    round_bits(v * STEPS as f32, GRID_ZERO).bitcast::<i32x8<K>>()
}

/// Eight small triangles, ready to be filled. See [`Triangle`](super::setup::Triangle).
pub(super) struct SetUp<K: Simd> {
    /// Vertices 1 and 2 changed places.
    turned: mask32x8<K>,
    pub(super) has_area: mask32x8<K>,
    pub(super) a: [i32x8<K>; 3],
    pub(super) b: [i32x8<K>; 3],
    /// The edge functions at the centre of the first pixel, in steps².
    pub(super) edges: [i32x8<K>; 3],
    m: [f32x8<K>; 4],
    pub(super) origin: [f32x8<K>; 2],
}

impl<K: Simd> SetUp<K> {
    /// The triangles that own the centre of the first pixel of their box.
    #[inline(always)]
    pub(super) fn own_first(&self) -> mask32x8<K> {
        (self.edges[0] | self.edges[1] | self.edges[2]).simd_gt(-1) & self.has_area
    }

    /// For each edge function of one triangle, the change to the right, the change down and the value at the first
    /// pixel's centre.
    #[inline(always)]
    pub(super) fn edges_of(&self, lane: usize) -> [[i32; 3]; 3] {
        let [a, b, e] = [&self.a, &self.b, &self.edges];
        [
            [a[0][lane], b[0][lane], e[0][lane]],
            [a[1][lane], b[1][lane], e[1][lane]],
            [a[2][lane], b[2][lane], e[2][lane]],
        ]
    }

    /// Factor of the greatest difference of values at the vertices that bounds the terms of their gradient. A sliver
    /// has large ones that nearly cancel, and then most of the gradient is rounding.
    #[inline(always)]
    pub(super) fn steepness(&self) -> f32x8<K> {
        let m = self.m.map(|m| m.abs());
        (m[0] + m[1]).max(m[2] + m[3])
    }

    /// The planes through values at the vertices.
    #[inline(always)]
    pub(super) fn planes(&self, q: &[f32x8<K>; 3]) -> Planes<K> {
        let (q1, q2) = (self.turned.select(q[2], q[1]), self.turned.select(q[1], q[2]));
        let (d1, d2) = (q1 - q[0], q2 - q[0]);
        Planes {
            value: q[0],
            dx: d1 * self.m[0] - d2 * self.m[1],
            dy: d2 * self.m[2] - d1 * self.m[3],
            low: q[0].min(q1).min(q2),
            high: q[0].max(q1).max(q2),
        }
    }
}

/// A [`AffineValue`] of each of eight triangles.
#[derive(Clone, Copy)]
pub(super) struct Planes<K: Simd> {
    pub(super) value: f32x8<K>,
    pub(super) dx: f32x8<K>,
    pub(super) dy: f32x8<K>,
    pub(super) low: f32x8<K>,
    pub(super) high: f32x8<K>,
}

impl<K: Simd> Planes<K> {
    #[inline(always)]
    pub(super) fn of(&self, lane: usize) -> AffineValue {
        AffineValue {
            value: self.value[lane],
            dx: self.dx[lane],
            dy: self.dy[lane],
            low: self.low[lane],
            high: self.high[lane],
        }
    }

    /// One plane for all eight.
    #[inline(always)]
    pub(super) fn splat(simd: K, plane: AffineValue) -> Self {
        let AffineValue { value, dx, dy, low, high } = plane;
        let [value, dx, dy, low, high] = [value, dx, dy, low, high].map(|v| f32x8::splat(simd, v));
        Self { value, dx, dy, low, high }
    }

    /// That of one for all eight.
    #[inline(always)]
    pub(super) fn all(&self, lane: usize) -> Self {
        Self::splat(self.value.witness(), self.of(lane))
    }

    /// The greatest difference of the values.
    #[inline(always)]
    pub(super) fn spread(&self) -> f32x8<K> {
        self.high - self.low
    }

    /// The value of each triangle at a point, not held to its range.
    #[inline(always)]
    pub(super) fn at(&self, x: f32x8<K>, y: f32x8<K>) -> f32x8<K> {
        x * self.dx + (y * self.dy + self.value)
    }

    #[inline(always)]
    pub(super) fn hold(&self, value: f32x8<K>) -> f32x8<K> {
        value.max(self.low).min(self.high)
    }
}
