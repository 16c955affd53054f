//! The rules of coverage and precision that the textbook's rasterizer and the fast one share: the grid on which
//! vertices lie, the samples of a pixel, and when single precision is enough.

use crate::appearance::Samples;
use crate::simd::round_bits_of_one;

/// Steps of the snapping grid per pixel.
pub(super) const STEPS: i32 = 256;
/// Half a pixel in steps: the place of a centre.
pub(super) const HALF: i32 = STEPS / 2;
/// Triangles less wide and less high than this, in steps, have edge functions (in steps²) that 32 bits hold.
pub(super) const WIDEST: i32 = 32 * STEPS;
pub(super) const HIGHEST: i32 = 128 * STEPS;

/// A position (pixels) is put on the grid by [`round_bits`](crate::simd::round_bits) of v · STEPS with this zero, which
/// isn't in the middle of the range because positions are hardly ever negative and pictures are large. The lower bits
/// are the integer, greater by `OFFSET`. If the upper bits aren't those of `GRID_ZERO`, the position isn't a number or
/// out of reach: −4096 … 28671 pixels, of which a picture has 0 … 16384.
pub(super) const GRID_ZERO: f32 = 8_388_608.0 + 1_048_576.0;
pub(super) const OFFSET: i32 = 1 << 20;
/// The lower bits.
pub(super) const FRACTION: u32 = (1 << 23) - 1;

/// Places of a pixel's samples relative to its centre, in steps. 4 and 16 lie on a turned lattice. No two share a row
/// or a column, so upright and level edges get as many shades as there are samples.
pub(super) fn samples(samples: Samples) -> &'static [[i32; 2]] {
    match samples {
        Samples::One => &[[0, 0]],
        Samples::Four => &LATTICE_4,
        Samples::Sixteen => &LATTICE_16,
    }
}

static LATTICE_4: [[i32; 2]; 4] = lattice(2);
static LATTICE_16: [[i32; 2]; 16] = lattice(4);

const fn lattice<const N: usize>(side: i32) -> [[i32; 2]; N] {
    let mut result = [[0, 0]; N];
    let unit = STEPS / (side * side);
    let (mut k, mut i, mut j) = (0, 0, 0);
    while k < N {
        result[k] = [unit * (side * i + j) + unit / 2 - HALF, unit * (side * j + side - 1 - i) + unit / 2 - HALF];
        i += 1;
        if i == side {
            (i, j) = (0, j + 1);
        }
        k += 1;
    }
    result
}

/// Greatest distance of samples from the centre, in steps: with one sample, and with several.
pub(super) const REACH: [i32; 2] = [0, HALF - STEPS / 32];

/// A position on the grid. `None` if it's out of reach, or not a number.
pub(super) fn snapped([x, y, _]: [f32; 3]) -> Option<[i32; 2]> {
    let snapped = |v: f32| {
        let bits = round_bits_of_one(v * STEPS as f32, GRID_ZERO);
        let is_in_reach = bits & !FRACTION == GRID_ZERO.to_bits() & !FRACTION;
        is_in_reach.then_some((bits & FRACTION).cast_signed() - OFFSET)
    };
    Some([snapped(x)?, snapped(y)?])
}

/// Steps between places of samples in pixels.
pub(super) fn in_pixels(steps: i32) -> f32 {
    steps as f32 / STEPS as f32
}

/// Steps of the textbook's grid in a step of this one: it has room for corners with 12 bits behind the point.
/// Everything it computes is scaled by a power of two, so corners on the coarser grid give the same bits.
pub(super) const FINER: i32 = 16;

/// A position on the textbook's grid, rounded to a step of that if it's `fine`, else to one of this grid. `None` if
/// it's out of reach, or not a number.
#[expect(clippy::cast_possible_truncation, reason = "within reach")]
pub(super) fn snapped_finely(p: [f32; 3], fine: bool) -> Option<[i32; 2]> {
    let snapped = snapped(p)?;
    let finely = |v: f32| (f64::from(v) * f64::from(FINER * STEPS)).round_ties_even() as i32;
    Some(if fine { [p[0], p[1]].map(finely) } else { snapped.map(|v| FINER * v) })
}

/// Threshold for the terms of a gradient (steps of 255 per pixel): above it the triangle is a sliver, and the gradient
/// mostly rounding. Below it, and less than a hundred pixels away, the error of a channel is far below half a step.
pub(super) const STEEPEST: f32 = 4096.0;
