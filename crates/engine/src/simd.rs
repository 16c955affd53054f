//! Wide vectors: the one door to the library that has them, which is young and may change.
//!
//! Results computed in vectors have the same bits on every machine. No operation is fused with another, and none is
//! left to an instruction that only approximates.

use std::sync::LazyLock;

use fearless_simd::Level;
use prelude::*;

/// The vectors and their methods.
pub(crate) mod prelude {
    pub(crate) use fearless_simd::prelude::*;
    pub(crate) use fearless_simd::{Simd, f32x4, f32x8, f64x4, i32x4, i32x8, mask32x8, u32x4, u32x8};
}

/// The vector instructions of this machine.
pub(crate) fn level() -> Level {
    static LEVEL: LazyLock<Level> = LazyLock::new(Level::new);
    *LEVEL
}

/// Runs an expression with `$simd`, the best set of vector instructions that the machine has. With `else`, an x86
/// machine without any runs that instead.
///
/// Each set is a copy of all code in the expression, so sets have to pay. On x86 there are three: AVX2 (Intel since
/// 2013, AMD since 2015), SSE 4.2 (Celeron and Pentium until 2020), and plain numbers (Intel before 2008, AMD before
/// 2011). The compiler takes 12 times as long for eight plain numbers as for a vector of eight. All kernels in plain
/// numbers took 207 of the 256 seconds of this crate. So large kernels have an `else`.
macro_rules! with_vectors {
    ($simd:ident => $run:expr) => {
        $crate::simd::with_vectors!($simd => $run, else {
            let $simd = fearless_simd::Fallback::new();
            $run
        })
    };
    ($simd:ident => $run:expr, else $otherwise:expr) => {{
        let level = $crate::simd::level();
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            if let Some($simd) = level.as_avx2() {
                fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $run,
                )
            } else if let Some($simd) = level.as_sse4_2() {
                fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $run,
                )
            } else {
                $otherwise
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        {
            fearless_simd::dispatch!(level, $simd => $run)
        }
    }};
}
pub(crate) use with_vectors;

/// True if this machine has vectors at all. Only x86 processors without SSE 4.2 have none.
pub(crate) fn has_vectors() -> bool {
    with_vectors!(_simd => true, else false)
}

// Rounding without an instruction for it, on every machine alike: a float has so many bits that next to a large enough
// number there are none left for fractions. Adding such a number rounds (ties go to the even neighbour), and the low
// bits of the sum **are** the integer. The high bits are those of the added number, as long as the sum doesn't leave
// the range in which floats have this spacing. Between 2²³ and 2²⁴ the spacing of an `f32` is 1, between 2⁵² and 2⁵³
// that of an `f64`.

/// For numbers of −2²² … 2²²: in the middle of the range, so that either sign has room.
pub(crate) const ROUND_F32: f32 = 1.5 * 8_388_608.0;
/// For numbers of −2⁵¹ … 2⁵¹.
pub(crate) const ROUND_F64: f64 = 1.5 * 4_503_599_627_370_496.0;

/// The nearest whole numbers, in the low bits. `zero` is the added number, such as [`ROUND_F32`].
#[inline(always)]
pub(crate) fn round_bits<K: Simd>(v: f32x8<K>, zero: f32) -> u32x8<K> {
    (v + zero).bitcast()
}

/// [`round_bits`] for one number.
#[inline(always)]
pub(crate) fn round_bits_of_one(v: f32, zero: f32) -> u32 {
    (v + zero).to_bits()
}

/// The nearest whole numbers to four that 32 bits hold.
#[inline(always)]
pub(crate) fn round_bits_f64<K: Simd>(v: f64x4<K>) -> [i32; 4] {
    let bits = (v + ROUND_F64).bitcast::<i32x8<K>>();
    [bits[0], bits[2], bits[4], bits[6]]
}

/// The nearest multiple of 1/`steps`, a power of two. A number is added and subtracted again.
#[inline(always)]
pub(crate) fn round_to_steps(v: f64, steps: f64) -> f64 {
    let zero = ROUND_F64 / steps;
    (v + zero) - zero
}

#[cfg(test)]
mod tests {
    #![expect(clippy::cast_possible_truncation, reason = "small numbers")]

    use super::*;

    #[test]
    fn the_low_bits_of_the_sum_are_the_nearest_integer() {
        for v in [0.0_f32, 0.49, 0.5, 0.51, 1.5, 2.5, 254.5, 255.0, -0.4, -1.5, -3.7, 4_000_000.3] {
            let nearest = v.round_ties_even() as i32;
            let low = |bits: u32| bits.wrapping_sub(ROUND_F32.to_bits()).cast_signed();
            assert_eq!(low(round_bits_of_one(v, ROUND_F32)), nearest, "{v}");
            let eight = with_vectors!(simd => round_bits(f32x8::splat(simd, v), ROUND_F32)[3]);
            assert_eq!(low(eight), nearest, "{v}");
            let four = with_vectors!(simd => round_bits_f64(f64x4::splat(simd, f64::from(v))));
            assert_eq!(four, [nearest; 4], "{v}");
            let steps = round_to_steps(f64::from(v) / 256.0, 256.0);
            assert_eq!(steps, f64::from(nearest) / 256.0, "{v}");
        }
    }
}
