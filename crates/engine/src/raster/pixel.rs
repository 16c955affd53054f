//! Colours as pixels: premultiplied bytes in one `u32`, red lowest.
//!
//! Blending works on two channels in one number, and on one pixel or eight by the same formula.

use std::ops::{Add, BitAnd, BitOr, Mul, Not, Shl, Shr};

use crate::appearance::Rgba;
use crate::lighting::packed;
use crate::simd::prelude::*;

/// Pixels that are worked on together.
pub(super) const LANES: usize = 8;

/// Premultiplied colour: `r | g << 8 | b << 16 | a << 24`.
pub(super) type Pixel = u32;

/// Bits of red and blue, and (shifted down by 8) of green and alpha.
const ALTERNATE: u32 = 0x00ff_00ff;

/// The arithmetic that one pixel and eight share.
pub(super) trait Pixels:
    Copy
    + BitAnd<u32, Output = Self>
    + BitOr<Self, Output = Self>
    + Add<Self, Output = Self>
    + Add<u32, Output = Self>
    + Mul<Self, Output = Self>
    + Shl<u32, Output = Self>
    + Shr<u32, Output = Self>
    + Not<Output = Self>
{
}

impl Pixels for Pixel {}
impl<K: Simd> Pixels for u32x8<K> {}

pub(super) fn premultiply(color: Rgba) -> Pixel {
    premultiply_packed(packed(color))
}

/// Colours in the order of [`Pixel`], premultiplied.
#[inline(always)]
pub(super) fn premultiply_packed<P: Pixels>(colors: P) -> P {
    let alpha = colors >> 24;
    let share = |shift: u32| {
        let t = ((colors >> shift) & 0xff) * alpha + 127;
        // t / 255 for t < 2¹⁶, without a division.
        (t + 1 + (t >> 8)) >> 8
    };
    (share(0) | (share(8) << 8)) | ((share(16) << 16) | (alpha << 24))
}

/// p · a / 255 in each channel, rounded.
///
/// The standard way takes a pixel apart into four numbers. Here two channels are in one number with room for a product,
/// so that a pixel has two multiplications, and a vector of eight pixels has two as well.
#[inline(always)]
pub(super) fn scale<P: Pixels>(p: P, a: P) -> P {
    scale_alternate(p, a) | (scale_alternate(p >> 8, a) << 8)
}

/// Source over target.
#[inline(always)]
pub(super) fn over<P: Pixels>(source: P, target: P) -> P {
    // The sum stays below 256 in each channel: premultiplied channels are at most their alpha, and 255 · a / 255 is a.
    source + scale(target, !(source >> 24) & 0xff)
}

/// v · a / 255, rounded, for the first and third byte. The others are 0.
#[inline(always)]
fn scale_alternate<P: Pixels>(v: P, a: P) -> P {
    let t = (v & ALTERNATE) * a + 0x0080_0080;
    ((t + ((t >> 8) & ALTERNATE)) >> 8) & ALTERNATE
}

/// The mean of some pixels, rounded to nearest (a half rounds up). `S` is a power of two, 16 at most.
#[inline(always)]
pub(super) fn mean<const S: usize>(pixels: [Pixel; S]) -> Pixel {
    let shift = S.trailing_zeros();
    let half = if S > 1 { 0x0001_0001 << (shift - 1) } else { 0 };
    let (mut even, mut odd) = (half, half);
    for p in pixels {
        even += p & ALTERNATE;
        odd += (p >> 8) & ALTERNATE;
    }
    ((even >> shift) & ALTERNATE) | ((odd >> shift) & ALTERNATE) << 8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_rounds_to_nearest() {
        for v in 0..=255_u32 {
            for a in 0..=255_u32 {
                // No product of two bytes is half way between two multiples of 255.
                let expected = (2 * v * a + 255) / 510;
                assert_eq!(scale(v << 16 | v, a), expected * 0x1_0001, "{v} · {a}");
            }
        }
    }

    #[test]
    fn opaque_covers_and_clear_leaves() {
        assert_eq!(over(0xff_30_20_10, 0xff_ff_ff_ff), 0xff_30_20_10);
        assert_eq!(over(0, 0xff_12_34_56), 0xff_12_34_56);
        assert_eq!(over(0x80_80_80_80, 0xff_00_00_00), 0xff_80_80_80);
        // The brightest translucent colour on white can't overflow.
        for a in 0..=255 {
            assert_eq!(over(a * 0x0101_0101, 0xffff_ffff), 0xffff_ffff, "alpha {a}");
        }
    }

    #[test]
    fn the_mean_is_by_channel() {
        assert_eq!(mean([0xff_01_ff_00, 0xff_02_ff_00, 0xff_03_ff_ff, 0xff_04_ff_00]), 0xff_03_ff_40);
        assert_eq!(mean([0xffff_ffff; 16]), 0xffff_ffff);
        assert_eq!(mean([0x1234_5678]), 0x1234_5678);
    }

    #[test]
    fn premultiplied_channels_never_exceed_alpha() {
        for a in 0..=255 {
            let [r, g, b, alpha] = premultiply(Rgba::rgba(255, 128, 0, a)).to_le_bytes();
            assert!(r == a && g <= a && b == 0 && alpha == a);
        }
    }

    #[test]
    fn premultiplied_channels_are_the_nearest() {
        for v in 0..=255_u8 {
            for a in 0..=255_u8 {
                let [r, ..] = premultiply(Rgba::rgba(v, 0, 0, a)).to_le_bytes();
                assert_eq!(u32::from(r), (u32::from(v) * u32::from(a) + 127) / 255, "{v} · {a}");
            }
        }
    }
}
