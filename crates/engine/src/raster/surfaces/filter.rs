//! Texels → colours: the nearest, the four around a point, and those of two levels of detail, for eight points at once.
//!
//! A trilinear colour reads eight texels, and they lie anywhere in memory. Here levels are stored in
//! [pairs](crate::appearance), so that the four texels around a point are sixteen bytes in a row: two reads instead of
//! eight. A lane that wants no texel reads the first one, so that no branch is guessed wrong.

use crate::appearance::{Level, LevelPairs, Sampler, Wrap};
use crate::simd::prelude::*;

use crate::raster::pixel::LANES;

/// The channels of eight colours.
pub(super) type Channels<K> = [f32x8<K>; 4];

/// The nearest texels.
#[inline(always)]
pub(super) fn nearest<K: Simd>(level: &Level, sampler: Sampler, wanted: mask32x8<K>, uv: [f32x8<K>; 2]) -> Channels<K> {
    let [width, height] = sides(wanted.witness(), level);
    let x = nearest_along(uv[0], width, sampler.wrap_u);
    let y = nearest_along(uv[1], height, sampler.wrap_v);
    channels(texels(level, wanted, x, y))
}

/// Between the four nearest texels. Beyond a border that isn't repeated the border continues.
#[inline(always)]
pub(super) fn bilinear<K: Simd>(
    level: &Level,
    sampler: Sampler,
    opaque: bool,
    wanted: mask32x8<K>,
    uv: [f32x8<K>; 2],
) -> Channels<K> {
    let [width, height] = sides(wanted.witness(), level);
    let (x0, x1, s) = between_along(uv[0], width, sampler.wrap_u);
    let (y0, y1, t) = between_along(uv[1], height, sampler.wrap_v);
    let of = [
        texels(level, wanted, x0, y0),
        texels(level, wanted, x0, y1),
        texels(level, wanted, x1, y0),
        texels(level, wanted, x1, y1),
    ];
    mixed(of, opaque, s, t)
}

/// Between the four nearest texels of the two levels of detail on either side of `detail`, and between these.
#[inline(always)]
pub(super) fn trilinear<K: Simd>(
    levels: &LevelPairs,
    sampler: Sampler,
    opaque: bool,
    wanted: mask32x8<K>,
    uv: [f32x8<K>; 2],
    detail: f32x8<K>,
) -> Channels<K> {
    let simd = wanted.witness();
    let last = levels.last();
    let finer = detail.max(0.0).min(last as f32).to_int::<i32x8<K>>();
    let share = detail - finer.to_float::<f32x8<K>>();
    let two = wanted & detail.simd_gt(0.0) & finer.simd_lt(last);
    let [fine, coarse] = sizes(simd, levels, finer);
    let mut colors = within(levels, &fine, sampler, opaque, wanted, uv);
    if two.any_true() {
        let coarse = within(levels, &coarse, sampler, opaque, two, uv);
        for k in 0..4 {
            colors[k] = two.select(colors[k] + share * (coarse[k] - colors[k]), colors[k]);
        }
    }
    colors
}

/// A level of detail for each point: the place of its first texel, its width and its height.
type LevelSize<K> = [i32x8<K>; 3];

/// The levels, and those behind them.
#[inline(always)]
fn sizes<K: Simd>(simd: K, levels: &LevelPairs, which: i32x8<K>) -> [LevelSize<K>; 2] {
    // Most often it is the same for all.
    let first = which[0];
    if !which.simd_eq(first).any_false() {
        let two = levels.sizes(first).as_flattened();
        let size = |k: usize| i32x8::splat(simd, two.get(k).copied().unwrap_or_default());
        return [[size(0), size(1), size(2)], [size(4), size(5), size(6)]];
    }
    let zero = i32x4::splat(simd, 0);
    let mut sizes = [[zero; LANES]; 2];
    for l in 0..LANES {
        if let Some(two) = levels.sizes(which[l]).as_flattened().get(..8) {
            sizes[0][l] = i32x4::from_slice(simd, &two[..4]);
            sizes[1][l] = i32x4::from_slice(simd, &two[4..]);
        }
    }
    let [fine, coarse] = &sizes;
    let [[first, width, height, _], [next, next_width, next_height, _]] = [turned(fine), turned(coarse)];
    [[first, width, height], [next, next_width, next_height]]
}

/// Eight rows of four numbers as four columns.
#[inline(always)]
fn turned<K: Simd>(rows: &[i32x4<K>; LANES]) -> [i32x8<K>; 4] {
    let (low, high) =
        (four_turned([rows[0], rows[1], rows[2], rows[3]]), four_turned([rows[4], rows[5], rows[6], rows[7]]));
    [low[0].combine(high[0]), low[1].combine(high[1]), low[2].combine(high[2]), low[3].combine(high[3])]
}

#[inline(always)]
fn four_turned<K: Simd>([a, b, c, d]: [i32x4<K>; 4]) -> [i32x4<K>; 4] {
    let (ac, bd) = (a.zip_low(c), b.zip_low(d));
    let (ac_high, bd_high) = (a.zip_high(c), b.zip_high(d));
    [ac.zip_low(bd), ac.zip_high(bd), ac_high.zip_low(bd_high), ac_high.zip_high(bd_high)]
}

/// Between the four nearest texels of one level for each point.
#[inline(always)]
fn within<K: Simd>(
    levels: &LevelPairs,
    [first, width, height]: &LevelSize<K>,
    sampler: Sampler,
    opaque: bool,
    wanted: mask32x8<K>,
    uv: [f32x8<K>; 2],
) -> Channels<K> {
    let simd = wanted.witness();
    let (x, _, s) = between_along(uv[0], *width, sampler.wrap_u);
    let (y, _, t) = between_along(uv[1], *height, sampler.wrap_v);
    // Behind each row stands its first texel once more.
    let places = wanted.select(*first + y * (*width + 1) + x, i32x8::splat(simd, 0));
    let mut found = [i32x4::splat(simd, 0); LANES];
    for l in 0..LANES {
        if let Some(four) = levels.four(places[l]) {
            found[l] = u32x4::from_slice(simd, four).bitcast();
        }
    }
    let [a, b, c, d] = turned(&found);
    mixed([a.bitcast(), b.bitcast(), c.bitcast(), d.bitcast()], opaque, s, t)
}

/// The sides of a level.
#[inline(always)]
fn sides<K: Simd>(simd: K, level: &Level) -> [i32x8<K>; 2] {
    [i32x8::splat(simd, level.width.cast_signed()), i32x8::splat(simd, level.height.cast_signed())]
}

/// The texels at these columns and rows, if requested, as they lie in memory.
#[inline(always)]
fn texels<K: Simd>(level: &Level, wanted: mask32x8<K>, x: i32x8<K>, y: i32x8<K>) -> u32x8<K> {
    let places = wanted.select(y * level.width.cast_signed() + x, i32x8::splat(wanted.witness(), 0));
    let mut texels = [0; LANES];
    for l in 0..LANES {
        texels[l] = u32::from_le_bytes(level.at(places[l] as usize));
    }
    u32x8::from_slice(wanted.witness(), &texels)
}

/// The colours between four texels: upper left, lower left, upper right, lower right. `s` and `t` are the shares of the
/// right and of the lower ones. `opaque` means that no texel lets anything through.
#[inline(always)]
fn mixed<K: Simd>(texels: [u32x8<K>; 4], opaque: bool, s: f32x8<K>, t: f32x8<K>) -> Channels<K> {
    // The means of 255 are 255.
    let alpha = if opaque { f32x8::splat(s.witness(), 255.0) } else { mixed_channel(texels, 24, s, t) };
    [mixed_channel(texels, 0, s, t), mixed_channel(texels, 8, s, t), mixed_channel(texels, 16, s, t), alpha]
}

#[inline(always)]
fn mixed_channel<K: Simd>([a, c, b, d]: [u32x8<K>; 4], shift: u32, s: f32x8<K>, t: f32x8<K>) -> f32x8<K> {
    let (a, b, c, d) = (channel(a >> shift), channel(b >> shift), channel(c >> shift), channel(d >> shift));
    let top = a + s * (b - a);
    let bottom = c + s * (d - c);
    top + t * (bottom - top)
}

/// The nearest texels along one axis.
#[inline(always)]
fn nearest_along<K: Simd>(t: f32x8<K>, size: i32x8<K>, wrap: Wrap) -> i32x8<K> {
    let index = (folded(t, wrap) * size.to_float::<f32x8<K>>()).to_int::<i32x8<K>>();
    // A coordinate that isn't a number, or too large for one, is at either end.
    index.max(0).min(size - 1)
}

/// The two nearest texels along one axis, and the share of the second.
#[inline(always)]
fn between_along<K: Simd>(t: f32x8<K>, size: i32x8<K>, wrap: Wrap) -> (i32x8<K>, i32x8<K>, f32x8<K>) {
    let last = size - 1;
    let t = folded(t, wrap) * size.to_float::<f32x8<K>>() - 0.5;
    if wrap == Wrap::Repeat {
        let low = t.floor();
        let share = t - low;
        let low = low.to_int::<i32x8<K>>();
        return (round_the_picture(low, last), round_the_picture(low + 1, last), share);
    }
    let t = t.max(0.0).min(last.to_float::<f32x8<K>>());
    let low = t.to_int::<i32x8<K>>().max(0).min(last);
    (low, (low + 1).min(last), t - low.to_float::<f32x8<K>>())
}

/// One before the first is the last, and one behind the last is the first.
#[inline(always)]
fn round_the_picture<K: Simd>(at: i32x8<K>, last: i32x8<K>) -> i32x8<K> {
    let at = at.simd_lt(0).select(last, at);
    at.simd_gt(last).select(i32x8::splat(at.witness(), 0), at)
}

/// The channels of texels.
#[inline(always)]
fn channels<K: Simd>(texels: u32x8<K>) -> Channels<K> {
    [channel(texels), channel(texels >> 8), channel(texels >> 16), channel(texels >> 24)]
}

/// The lowest channel as a number.
#[inline(always)]
pub(super) fn channel<K: Simd>(pixels: u32x8<K>) -> f32x8<K> {
    // Signed numbers become floats in one instruction.
    (pixels & 0xff).bitcast::<i32x8<K>>().to_float()
}

/// Coordinates as those of the picture, 0 … 1. Unchanged if the border continues.
#[inline(always)]
fn folded<K: Simd>(t: f32x8<K>, wrap: Wrap) -> f32x8<K> {
    match wrap {
        Wrap::Clamp => t,
        Wrap::Repeat => t - t.floor(),
        Wrap::Mirror => {
            let twice = t - (t * 0.5).floor() * 2.0;
            twice.simd_gt(1.0).select(f32x8::splat(t.witness(), 2.0) - twice, twice)
        }
    }
}
