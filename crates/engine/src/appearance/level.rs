//! A level of detail of a picture, and the next smaller one: means over areas, in linear light.

use std::sync::LazyLock;

/// One level of detail: premultiplied RGBA, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Width in texels, at least 1.
    pub width: u32,
    /// Height in texels, at least 1.
    pub height: u32,
    /// 4 bytes a texel, premultiplied.
    pub rgba: Vec<u8>,
}

impl Level {
    /// The level that is half as wide and high. `None` if this one is one texel.
    pub(super) fn half(&self) -> Option<Self> {
        if self.width <= 1 && self.height <= 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let (columns, rows) = (Shares::new(self.width, width), Shares::new(self.height, height));
        let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0_f32; 4];
                for (row, tall) in rows.of(y) {
                    for (column, wide) in columns.of(x) {
                        let texel = linear(self.texel(column, row));
                        for (sum, channel) in sum.iter_mut().zip(texel) {
                            *sum += tall * wide * channel;
                        }
                    }
                }
                rgba.extend(encoded(sum));
            }
        }
        Some(Self { width, height, rgba })
    }

    /// A texel by its column and row. Clear outside.
    #[inline]
    pub fn texel(&self, x: u32, y: u32) -> [u8; 4] {
        self.at(y as usize * self.width as usize + x as usize)
    }

    /// A texel by its number, row by row. Clear behind the last.
    #[inline]
    pub fn at(&self, index: usize) -> [u8; 4] {
        self.rgba.as_chunks::<4>().0.get(index).copied().unwrap_or_default()
    }
}

/// The texels of one axis that lie under each texel of a shorter one, with their shares.
struct Shares {
    long: u32,
    short: u32,
}

impl Shares {
    fn new(long: u32, short: u32) -> Self {
        Self { long, short }
    }

    /// Indices and shares of the texels under the `k`-th of the shorter axis. The shares add up to 1.
    fn of(&self, k: u32) -> impl Iterator<Item = (u32, f32)> {
        let step = f64::from(self.long) / f64::from(self.short);
        let (begin, end) = (f64::from(k) * step, f64::from(k + 1) * step);
        #[expect(clippy::cast_possible_truncation, reason = "0 … long")]
        let (first, last) = (begin.floor() as u32, (end.ceil() as u32).min(self.long));
        (first..last).map(move |i| {
            let covered = end.min(f64::from(i + 1)) - begin.max(f64::from(i));
            #[expect(clippy::cast_possible_truncation, reason = "a share")]
            let share = (covered / step) as f32;
            (i, share)
        })
    }
}

/// The light of each byte.
static DECODED: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| u8::try_from(byte).map_or(1.0, |byte| decoded(f32::from(byte) / 255.0)))
});

/// A premultiplied texel in linear light, still premultiplied. Alpha 0 … 1.
fn linear(texel: [u8; 4]) -> [f32; 4] {
    let alpha = f32::from(texel[3]) / 255.0;
    match texel[3] {
        0 => return [0.0; 4],
        255 => {
            return [
                DECODED[usize::from(texel[0])],
                DECODED[usize::from(texel[1])],
                DECODED[usize::from(texel[2])],
                1.0,
            ];
        }
        _ => {}
    }
    let channel = |c: u8| alpha * decoded(f32::from(c) / 255.0 / alpha);
    [channel(texel[0]), channel(texel[1]), channel(texel[2]), alpha]
}

/// The way back from [`linear`].
fn encoded([r, g, b, alpha]: [f32; 4]) -> [u8; 4] {
    #[expect(clippy::cast_possible_truncation, reason = "`as` saturates: 0 … 255")]
    let byte = |v: f32| (v * 255.0 + 0.5) as u8;
    if alpha <= 0.0 {
        return [0; 4];
    }
    let channel = |c: f32| byte(alpha * srgb((c / alpha).min(1.0)));
    [channel(r), channel(g), channel(b), byte(alpha)]
}

/// sRGB → linear light, both 0 … 1 (IEC 61966-2-1), in double precision, so that every machine rounds to the same byte.
fn decoded(v: f32) -> f32 {
    let v = f64::from(v);
    let light = if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let light = light as f32;
    light
}

/// Linear light → sRGB, both 0 … 1.
pub(super) fn srgb(v: f32) -> f32 {
    let v = f64::from(v);
    let encoded = if v <= 0.003_130_8 { v * 12.92 } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let encoded = encoded as f32;
    encoded
}

/// The levels of detail of a picture, from the largest on, in one array, laid out for a filter that mixes four texels
/// of two levels.
///
/// Each texel stands beside the one below it, and behind the last of a row comes the first once more. The four texels
/// around a point are sixteen bytes in a row of memory, wherever it lies. That's twice the memory of the picture, for a
/// quarter of the places that are read.
#[derive(Clone, Debug)]
pub(crate) struct LevelPairs {
    /// For each level the place of its first pair, its width and its height in texels. The last stands here twice, so
    /// that each has one behind it.
    sizes: Vec<[i32; 4]>,
    /// A texel, as its bytes lie in memory, and the one below. Below the last row is the first.
    pairs: Vec<[u32; 2]>,
}

impl LevelPairs {
    pub(super) fn new(levels: &[Level]) -> Self {
        let number = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
        let (mut sizes, mut pairs) = (Vec::new(), Vec::new());
        for level in levels {
            let first = i32::try_from(pairs.len()).unwrap_or(i32::MAX);
            sizes.push([first, number(level.width), number(level.height), 0]);
            let texel = |x: u32, y: u32| u32::from_le_bytes(level.texel(x, y));
            for y in 0..level.height {
                let below = (y + 1) % level.height;
                pairs.extend((0..level.width).chain([0]).map(|x| [texel(x, y), texel(x, below)]));
            }
        }
        sizes.extend(sizes.last().copied());
        Self { sizes, pairs }
    }

    /// The number of the smallest level.
    #[inline(always)]
    pub(crate) fn last(&self) -> i32 {
        // A picture has fifteen levels at most.
        i32::try_from(self.sizes.len()).map_or(0, |n| n - 2)
    }

    /// A level and the next smaller one. For each the place of its first pair, its width, its height, and nothing.
    #[inline(always)]
    pub(crate) fn sizes(&self, level: i32) -> &[[i32; 4]] {
        // A negative number becomes one that is far too large.
        let level = level.cast_unsigned() as usize;
        self.sizes.get(level..level.wrapping_add(2)).unwrap_or_default()
    }

    /// The texel at a place, the one below it, the one to its right, and the one below that, as their bytes lie in
    /// memory. `None` if there is none.
    #[inline(always)]
    pub(crate) fn four(&self, place: i32) -> Option<&[u32]> {
        let place = place.cast_unsigned() as usize;
        self.pairs.get(place..place.wrapping_add(2)).map(<[[u32; 2]]>::as_flattened)
    }
}
