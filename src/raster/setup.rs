//! One triangle, made ready to be filled: integer edge functions and planes.
//!
//! Positions are snapped to 1/256 pixel and everything about coverage is integer from there on, so that two triangles with a
//! common edge never both own a pixel of it and never both leave it. With p a sample point and a → b an edge,
//! E(p) = (b − a) × (p − a) is positive inside; where E = 0 the **top-left rule** decides: a top edge (horizontal, with the
//! triangle below it) or a left edge owns its points, the others do not.

use std::ops::Range;

/// Steps of the snapping grid per pixel.
pub(super) const STEPS: i32 = 256;
/// Coordinates beyond this are not the picture's (whose largest side it is); a triangle that has one is not drawn.
pub(super) const LIMIT: f32 = 16384.0;

/// Places of a pixel's samples relative to its centre, in steps. 4 and 16 lie on a turned lattice: no two share a row or a
/// column, so upright and level edges get as many shades as there are samples.
pub(super) fn samples(count: usize) -> &'static [[i32; 2]] {
    match count {
        4 => &LATTICE_4,
        16 => &LATTICE_16,
        _ => &[[0, 0]],
    }
}

static LATTICE_4: [[i32; 2]; 4] = lattice(2);
static LATTICE_16: [[i32; 2]; 16] = lattice(4);

const fn lattice<const N: usize>(side: i32) -> [[i32; 2]; N] {
    let mut result = [[0, 0]; N];
    let unit = STEPS / (side * side);
    let (mut k, mut i, mut j) = (0, 0, 0);
    while k < N {
        result[k] =
            [unit * (side * i + j) + unit / 2 - STEPS / 2, unit * (side * j + side - 1 - i) + unit / 2 - STEPS / 2];
        i += 1;
        if i == side {
            i = 0;
            j += 1;
        }
        k += 1;
    }
    result
}

/// A position on the snapping grid; `None` where it is not a number or far outside.
pub(super) fn snap(p: [f32; 3]) -> Option<[i32; 2]> {
    // 1.5 · 2⁵² leaves no bits for fractions: the sum is rounded (ties to even), and its low bits are the integer.
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    #[expect(clippy::cast_possible_truncation, reason = "the low 32 bits hold the whole number, |v| ≤ 2²²")]
    let grid = |v: f32| (f64::from(v) * f64::from(STEPS) + MAGIC).to_bits() as i32;
    (p[0].abs() <= LIMIT && p[1].abs() <= LIMIT && p[2].is_finite()).then(|| [grid(p[0]), grid(p[1])])
}

/// An edge: a·i + b·j + c ≥ 0 where pixel (i, j)'s centre is inside; the top-left rule is in `c`, which counts steps².
#[derive(Clone, Copy, Debug)]
struct Edge {
    a: i64,
    b: i64,
    c: i64,
}

impl Edge {
    fn new(from: [i32; 2], to: [i32; 2]) -> Self {
        let (a, b) = (i64::from(from[1] - to[1]), i64::from(to[0] - from[0]));
        let owns_its_points = a > 0 || (a == 0 && b > 0);
        let half = STEPS / 2;
        let c = a * i64::from(half - from[0]) + b * i64::from(half - from[1]);
        Self { a, b, c: c - i64::from(!owns_its_points) }
    }
}

/// A triangle that is ready to be filled.
#[derive(Clone, Debug)]
pub(super) struct Triangle {
    edges: [Edge; 3],
    /// Vertex 0 in pixels: where the planes are anchored.
    origin: [f64; 2],
    /// What makes a gradient of the differences to vertex 0, per pixel: ∂q/∂x = d1·m[0] − d2·m[1], ∂q/∂y = d2·m[2] − d1·m[3].
    m: [f64; 4],
    /// The box of snapped positions, in steps.
    low: [i32; 2],
    high: [i32; 2],
    /// Vertices 1 and 2 changed places to make the triangle run clockwise on the screen.
    pub(super) swapped: bool,
}

impl Triangle {
    /// `None` for a triangle without area on the grid.
    pub(super) fn new(v: [[i32; 2]; 3]) -> Option<Self> {
        let side = |a: [i32; 2], b: [i32; 2]| [i64::from(b[0] - a[0]), i64::from(b[1] - a[1])];
        let (p, q) = (side(v[0], v[1]), side(v[0], v[2]));
        let area = p[0] * q[1] - p[1] * q[0];
        let swapped = area < 0;
        let (v, p, q) = if swapped { ([v[0], v[2], v[1]], q, p) } else { (v, p, q) };
        let area = area.abs();
        if area == 0 {
            return None;
        }
        let scale = f64::from(STEPS) / exact(area);
        Some(Self {
            edges: [Edge::new(v[0], v[1]), Edge::new(v[1], v[2]), Edge::new(v[2], v[0])],
            origin: [f64::from(v[0][0]) / f64::from(STEPS), f64::from(v[0][1]) / f64::from(STEPS)],
            m: [exact(q[1]) * scale, exact(p[1]) * scale, exact(p[0]) * scale, exact(q[0]) * scale],
            low: [v[0][0].min(v[1][0]).min(v[2][0]), v[0][1].min(v[1][1]).min(v[2][1])],
            high: [v[0][0].max(v[1][0]).max(v[2][0]), v[0][1].max(v[1][1]).max(v[2][1])],
            swapped,
        })
    }

    /// The rows whose sample at `offset` may be inside, in a picture `height` high.
    pub(super) fn rows(&self, offset: [i32; 2], height: i32) -> Range<i32> {
        let shift = STEPS / 2 + offset[1];
        let first = (self.low[1] - shift + STEPS - 1).div_euclid(STEPS);
        let last = (self.high[1] - shift).div_euclid(STEPS);
        first.max(0)..(last + 1).min(height)
    }

    /// The pixels of row `j` whose sample at `offset` is inside, in a picture `width` wide. Exact.
    pub(super) fn span(&self, j: i32, offset: [i32; 2], width: i32) -> Range<i32> {
        let (mut first, mut end) = (0_i64, i64::from(width));
        for e in &self.edges {
            // a·i + r ≥ 0 in whole numbers: the fraction of c / 256 can be dropped, as a·i and b·j are whole.
            let r = e.b * i64::from(j)
                + (e.c + e.a * i64::from(offset[0]) + e.b * i64::from(offset[1])).div_euclid(i64::from(STEPS));
            if e.a > 0 {
                first = first.max(-r.div_euclid(e.a));
            } else if e.a < 0 {
                end = end.min(r.div_euclid(-e.a) + 1);
            } else if r < 0 {
                end = 0;
            }
        }
        #[expect(clippy::cast_possible_truncation, reason = "both lie in 0 … width")]
        let (first, end) = (first.clamp(0, i64::from(width)) as i32, end.clamp(0, i64::from(width)) as i32);
        first..end.max(first)
    }

    /// The plane through values at the three vertices (in the triangle's own order).
    pub(super) fn plane(&self, q: [f32; 3]) -> Plane {
        let q = if self.swapped { [q[0], q[2], q[1]] } else { q };
        let (d1, d2) = (f64::from(q[1]) - f64::from(q[0]), f64::from(q[2]) - f64::from(q[0]));
        Plane {
            origin: self.origin,
            value: f64::from(q[0]),
            dx: d1 * self.m[0] - d2 * self.m[1],
            dy: d2 * self.m[2] - d1 * self.m[3],
            low: q[0].min(q[1]).min(q[2]),
            high: q[0].max(q[1]).max(q[2]),
        }
    }
}

/// A value that is affine over the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    origin: [f64; 2],
    value: f64,
    /// Change per pixel.
    dx: f64,
    dy: f64,
    low: f32,
    high: f32,
}

impl Plane {
    /// The value at a point in pixels, held to the range of the vertices (rounding and samples outside would leave it).
    pub(super) fn at(&self, x: f64, y: f64) -> f32 {
        #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
        let v = (self.value + self.dx * (x - self.origin[0]) + self.dy * (y - self.origin[1])) as f32;
        v.clamp(self.low, self.high)
    }

    /// Change per pixel to the right and down.
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
    pub(super) fn slope(&self) -> [f32; 2] {
        [self.dx as f32, self.dy as f32]
    }
}

/// Products of two coordinates in steps: below 2⁴⁸.
#[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
fn exact(v: i64) -> f64 {
    v as f64
}
