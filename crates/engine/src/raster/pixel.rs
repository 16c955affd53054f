//! Colours as pixels: premultiplied bytes in one `u32`, red lowest.

use crate::appearance::Rgba;
use crate::simd::{Simd, u32x8};

/// Pixels that are worked on together.
pub(super) const LANES: usize = 8;

/// Premultiplied colour: `r | g << 8 | b << 16 | a << 24`.
pub(super) type Pixel = u32;

/// Bits of red and blue, and (shifted down by 8) of green and alpha.
const ALTERNATE: u32 = 0x00ff_00ff;

pub(super) fn premultiply(c: Rgba) -> Pixel {
    let share = |v: u8| (u32::from(v) * u32::from(c.a) + 127) / 255;
    share(c.r) | share(c.g) << 8 | share(c.b) << 16 | u32::from(c.a) << 24
}

/// p · a / 255 in each channel, rounded.
#[inline(always)]
pub(super) fn scale(p: Pixel, a: u32) -> Pixel {
    let part = |v: u32| {
        let t = (v & ALTERNATE) * a + 0x0080_0080;
        ((t + ((t >> 8) & ALTERNATE)) >> 8) & ALTERNATE
    };
    part(p) | part(p >> 8) << 8
}

/// Source over target.
#[inline(always)]
pub(super) fn over(source: Pixel, target: Pixel) -> Pixel {
    // The sum stays below 256 in each channel: premultiplied channels are at most their alpha, and 255 · a / 255 is a.
    source + scale(target, 255 - (source >> 24))
}

/// [`scale`] for eight.
#[inline(always)]
pub(super) fn scale_eight<K: Simd>(p: u32x8<K>, a: u32x8<K>) -> u32x8<K> {
    scale_alternate(p, a) | (scale_alternate(p >> 8, a) << 8)
}

/// [`over`] for eight.
#[inline(always)]
pub(super) fn over_eight<K: Simd>(source: u32x8<K>, target: u32x8<K>) -> u32x8<K> {
    source + scale_eight(target, !(source >> 24) & 0xff)
}

/// v · a / 255, rounded, for the first and third byte of each lane; the others are 0.
#[inline(always)]
fn scale_alternate<K: Simd>(v: u32x8<K>, a: u32x8<K>) -> u32x8<K> {
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
        // The brightest translucent colour on white cannot overflow.
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
}
