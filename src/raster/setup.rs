//! One triangle, made ready to be filled: integer edge functions and planes.
//!
//! Positions are snapped to 1/256 pixel and everything about coverage is exact from there on, so that two triangles with a
//! common edge never both own a pixel of it and never both leave it. With p a sample point and a → b an edge,
//! E(p) = (b − a) × (p − a) is positive inside; where E = 0 the **top-left rule** decides: a top edge (horizontal, with the
//! triangle below it) or a left edge owns its points, the others do not.

use std::ops::Range;

/// Steps of the snapping grid per pixel.
pub(super) const STEPS: i32 = 256;
/// Coordinates beyond this are not the picture's (whose largest side it is); a triangle that has one is not drawn.
pub(super) const LIMIT: f32 = 16384.0;
/// The width and height of a triangle's box, in steps, up to which it counts as small: its samples lie in eight columns.
const SMALL: [i32; 2] = [7 * STEPS, 64 * STEPS];

/// Half a pixel in steps: the place of a centre.
const HALF: i32 = STEPS / 2;

/// Places of a pixel's samples relative to its centre, in steps. 4 and 16 lie on a turned lattice: no two share a row or a
/// column, so upright and level edges get as many shades as there are samples.
pub(super) const fn samples<const S: usize>() -> [[i32; 2]; S] {
    let mut result = [[0, 0]; S];
    let side: i32 = match S {
        1 => return result,
        4 => 2,
        _ => 4,
    };
    let unit = STEPS / (side * side);
    let (mut k, mut i, mut j) = (0, 0, 0);
    while k < S {
        result[k] = [unit * (side * i + j) + unit / 2 - HALF, unit * (side * j + side - 1 - i) + unit / 2 - HALF];
        i += 1;
        if i == side {
            (i, j) = (0, j + 1);
        }
        k += 1;
    }
    result
}

/// A position on the snapping grid; `None` where it is not a number or far outside.
#[inline(always)]
pub(super) fn snap(p: [f32; 3]) -> Option<[i32; 2]> {
    // 1.5 · 2⁵² leaves no bits for fractions: the sum is rounded (ties to even), and its low bits are the integer.
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    #[expect(clippy::cast_possible_truncation, reason = "the low 32 bits hold the whole number, |v| ≤ 2²²")]
    let grid = |v: f32| (f64::from(v) * f64::from(STEPS) + MAGIC).to_bits() as i32;
    let inside = p[0].abs() <= LIMIT && p[1].abs() <= LIMIT && p[2].is_finite();
    inside.then(|| [grid(p[0]), grid(p[1])])
}

/// The pixels that a triangle may own: those with a sample in the box around it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pixels {
    pub(super) columns: Range<i32>,
    pub(super) rows: Range<i32>,
    /// At most eight columns, and no coordinate far from the others.
    pub(super) small: bool,
}

impl Pixels {
    /// `reach`: how far samples lie from the centre, in steps. Points on the right and lower border belong to no one.
    #[inline(always)]
    pub(super) fn around(v: &[[i32; 2]; 3], reach: i32, width: i32, height: i32) -> Self {
        let low = |k: usize| v[0][k].min(v[1][k]).min(v[2][k]) - HALF - reach;
        let high = |k: usize| v[0][k].max(v[1][k]).max(v[2][k]) - HALF + reach;
        let (left, right, top, bottom) = (low(0), high(0), low(1), high(1));
        // Rounded up to a whole pixel.
        let pixel = |steps: i32| (steps + STEPS - 1) >> 8;
        Self {
            columns: pixel(left).max(0)..pixel(right).min(width),
            rows: pixel(top).max(0)..pixel(bottom).min(height),
            small: right - left <= SMALL[0] && bottom - top <= SMALL[1],
        }
    }

    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.columns.start >= self.columns.end || self.rows.start >= self.rows.end
    }
}

/// A triangle that is ready to be filled.
#[derive(Clone, Debug)]
pub(super) struct Triangle {
    /// The vertices on the grid, turned so that the edge functions are positive inside.
    v: [[i32; 2]; 3],
    /// Edge functions: a·x + b·y for a step along x and y. Edge k runs from vertex k to the next.
    pub(super) a: [i32; 3],
    pub(super) b: [i32; 3],
    /// Vertex 0 in pixels: where the planes are anchored. Exact.
    pub(super) origin: [f32; 2],
    /// What makes a gradient of the differences to vertex 0, per pixel: ∂q/∂x = d1·m[0] − d2·m[1], ∂q/∂y = d2·m[2] − d1·m[3].
    m: [f64; 4],
    /// Vertices 1 and 2 changed places.
    swapped: bool,
}

impl Triangle {
    /// `None` for a triangle without area on the grid.
    #[inline(always)]
    pub(super) fn new(v: [[i32; 2]; 3]) -> Option<Self> {
        // Differences are below 2²³ and products below 2⁴⁶: exact in f64.
        let side = |a: [i32; 2], b: [i32; 2]| [f64::from(b[0] - a[0]), f64::from(b[1] - a[1])];
        let (p, q) = (side(v[0], v[1]), side(v[0], v[2]));
        let area = p[0] * q[1] - p[1] * q[0];
        if area == 0.0 {
            return None;
        }
        let swapped = area < 0.0;
        let (v, p, q) = if swapped { ([v[0], v[2], v[1]], q, p) } else { (v, p, q) };
        let scale = f64::from(STEPS) / area.abs();
        let origin = v[0].map(|v| v as f32 / STEPS as f32);
        Some(Self {
            a: [v[0][1] - v[1][1], v[1][1] - v[2][1], v[2][1] - v[0][1]],
            b: [v[1][0] - v[0][0], v[2][0] - v[1][0], v[0][0] - v[2][0]],
            origin,
            m: [q[1] * scale, p[1] * scale, p[0] * scale, q[0] * scale],
            v,
            swapped,
        })
    }

    /// The edge function of edge `k` at a sample of a pixel, divided by [`STEPS`] and rounded down: not negative inside. It
    /// changes by `a[k]` and `b[k]` from pixel to pixel.
    #[inline(always)]
    pub(super) fn edge(&self, k: usize, pixel: [i32; 2], sample: [i32; 2]) -> i64 {
        let (a, b) = (i64::from(self.a[k]), i64::from(self.b[k]));
        let place = |c: usize| i64::from(pixel[c]) * i64::from(STEPS) + i64::from(HALF + sample[c] - self.v[k][c]);
        let owns_its_points = a > 0 || (a == 0 && b > 0);
        (a * place(0) + b * place(1) - i64::from(!owns_its_points)) >> 8
    }

    /// True where row `j` has points of the triangle, or of its upper border, at this sample.
    #[inline(always)]
    pub(super) fn has_row(&self, j: i32, sample: [i32; 2]) -> bool {
        let y = j * STEPS + HALF + sample[1];
        let v = &self.v;
        v[0][1].min(v[1][1]).min(v[2][1]) <= y && y < v[0][1].max(v[1][1]).max(v[2][1])
    }

    /// The plane through values at the three vertices, in the order in which they came.
    #[inline(always)]
    pub(super) fn plane(&self, q: [f32; 3]) -> Plane {
        let (q1, q2) = if self.swapped { (q[2], q[1]) } else { (q[1], q[2]) };
        let (d1, d2) = (f64::from(q1) - f64::from(q[0]), f64::from(q2) - f64::from(q[0]));
        #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
        let (dx, dy) = ((d1 * self.m[0] - d2 * self.m[1]) as f32, (d2 * self.m[2] - d1 * self.m[3]) as f32);
        Plane { value: q[0], dx, dy, low: q[0].min(q1).min(q2), high: q[0].max(q1).max(q2) }
    }

    /// The borders of the rows of this triangle, for one sample of each pixel.
    pub(super) fn borders(&self, sample: [i32; 2]) -> Borders {
        let mut borders = Borders { lines: [(0.0, -1.0), (0.0, -1.0), (0.0, 1e9), (0.0, 1e9)] };
        let (mut left, mut right) = (0, 2);
        for k in 0..3 {
            if self.a[k] == 0 {
                // A level edge bounds rows, and the box has seen to that.
                continue;
            }
            // The half keeps the quotient away from whole numbers, by 0.5/|a| at least; see `Borders`.
            let r = self.edge(k, [0, 0], sample) as f64 + 0.5;
            let inverse = -1.0 / f64::from(self.a[k]);
            let side = if self.a[k] > 0 { &mut left } else { &mut right };
            borders.lines[*side] = (r * inverse, f64::from(self.b[k]) * inverse);
            *side += 1;
        }
        if left == 1 {
            borders.lines[1] = borders.lines[0];
        }
        if right == 3 {
            borders.lines[3] = borders.lines[2];
        }
        borders
    }
}

/// Where the rows of a triangle begin and end: two lines at the left, two at the right.
///
/// Row j of edge a·i + b·j + c ≥ 0 (whole numbers) begins after x = −(b·j + c + ½)/a where a > 0, and ends before that
/// x + 1 where a < 0: in both cases at ⌊x⌋ + 1. x is at least ½/|a| ≥ 2⁻²⁴ away from whole numbers, while its three roundings
/// together are below 2⁻¹³/|a|: the result is that of exact arithmetic.
#[derive(Clone, Copy, Debug)]
pub(super) struct Borders {
    /// x at row 0, and its change from row to row.
    lines: [(f64, f64); 4],
}

impl Borders {
    /// The first pixel of row `j` inside the triangle and the first one behind it, between 0 and `width`.
    #[inline(always)]
    pub(super) fn row(&self, j: i32, width: i32) -> (i32, i32) {
        // 1.5 · 2⁵²: see `snap`.
        const MAGIC: f64 = 6_755_399_441_055_744.0;
        let y = f64::from(j);
        let x = |k: usize| self.lines[k].0 + self.lines[k].1 * y;
        // ⌊x⌋ + 1 is x + ½ rounded to nearest, as x is no whole number.
        #[expect(clippy::cast_possible_truncation, reason = "the low 32 bits hold the whole number")]
        let after = |x: f64| (lesser(greater(x, -0.75), f64::from(width)) + 0.5 + MAGIC).to_bits() as i32;
        (after(greater(x(0), x(1))), after(lesser(x(2), x(3))).min(width))
    }
}

/// A value that is affine over the picture: `value` at the origin of its triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub(super) value: f32,
    /// Change per pixel.
    pub(super) dx: f32,
    pub(super) dy: f32,
    /// The range of the vertices.
    pub(super) low: f32,
    pub(super) high: f32,
}

impl Plane {
    /// The value in the row at `y` from the origin, at x = 0.
    #[inline(always)]
    pub(super) fn row(&self, y: f32) -> f32 {
        self.value + self.dy * y
    }

    /// The value at `x` from the origin in a row, held to the range of the vertices: rounding, and pixels whose centre lies
    /// outside while a sample is inside, would leave it.
    #[inline(always)]
    pub(super) fn at(&self, row: f32, x: f32) -> f32 {
        self.hold(row + self.dx * x)
    }

    #[inline(always)]
    pub(super) fn hold(&self, value: f32) -> f32 {
        lesser(greater(value, self.low), self.high)
    }
}

/// The greater of two numbers; one machine instruction, where `f64::max` takes four for the sake of NaN.
#[inline(always)]
pub(super) fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The lesser of two numbers.
#[inline(always)]
pub(super) fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}
