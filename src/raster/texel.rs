//! Pictures on triangles: the colour of a texture at a pixel.
//!
//! The level of detail comes from the change of (u, v) from pixel to pixel, which is exact for perspective: with U, V
//! and W affine on the picture, u = U/W changes by (∂U/∂x − u ∂W/∂x)/W along x. A level whose texels are as large as a
//! pixel is λ = log₂ of the longer of the two changes, in texels of the picture itself [Heckbert 1989].

use std::cell::Cell;

use crate::appearance::{Filter, LEVEL_COLORS, Level, Rgba, Sampler, Texture, TextureReveal, Wrap};
use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, mask32x8, u32x8};

use super::pixel::Pixel;
use super::shade::LANES;

/// A triangle with a picture on it.
pub(super) struct TexturedTriangle<'a> {
    image: &'a Texture,
    sampler: Sampler,
    /// The channels of the tint, 0 … 1, premultiplied.
    tint: [f32; 4],
    /// Texture coordinates of its vertices, near 0 where the picture repeats, so that they are exact.
    pub(super) uv: [[f32; 2]; 3],
    /// The change of u/w and v/w in texels, and of 1/w, along x and y; only for a filter that asks for it.
    change: Option<[[f32; 3]; 2]>,
    /// Pixels between two levels of detail so far.
    pub(super) two_levels: Cell<u64>,
}

impl<'a> TexturedTriangle<'a> {
    /// `change`: that of the share of each vertex along x and y, before it is divided by the sum of all three.
    pub(super) fn new(
        image: &'a Texture,
        sampler: Sampler,
        tint: Rgba,
        uv: [[f32; 2]; 3],
        change: [[f32; 2]; 3],
    ) -> Self {
        let uv = near_zero(uv, sampler);
        let alpha = f32::from(tint.a) / 255.0;
        let tint = [tint.r, tint.g, tint.b, 255].map(|c| f32::from(c) / 255.0 * alpha);
        let asks = sampler.filter == Filter::Trilinear && image.levels().len() > 1
            || matches!(sampler.reveal, Some(TextureReveal::Levels | TextureReveal::Texels));
        #[expect(clippy::cast_precision_loss, reason = "sides of pictures are far below 2²⁴")]
        let size = [image.width() as f32, image.height() as f32];
        let change = asks.then(|| {
            [0, 1].map(|axis| {
                let sum = |value: &dyn Fn(usize) -> f32| (0..3).map(|k| change[k][axis] * value(k)).sum::<f32>();
                [sum(&|k| uv[k][0] * size[0]), sum(&|k| uv[k][1] * size[1]), sum(&|_| 1.0)]
            })
        });
        Self { image, sampler, tint, uv, change, two_levels: Cell::new(0) }
    }

    /// The colours of eight pixels at these coordinates, premultiplied; `w`: the interpolated w there.
    #[inline(always)]
    pub(super) fn colors<K: Simd>(&self, wanted: mask32x8<K>, [s, t]: [f32x8<K>; 2], w: f32x8<K>) -> u32x8<K> {
        let simd = wanted.witness();
        // The changes of u and v in texels, from pixel to pixel: along x, along y.
        let changes = self.change.map(|change| {
            let (wide, high) = (self.image.width() as f32, self.image.height() as f32);
            change.map(|[u, v, sum]| {
                let du = (f32x8::splat(simd, u) - s * (sum * wide)) * w;
                let dv = (f32x8::splat(simd, v) - t * (sum * high)) * w;
                [du * du, dv * dv]
            })
        });
        // Squares of the longer change: the root is taken by halving the logarithm.
        let change = changes.map(|[x, y]| (x[0] + x[1]).max(y[0] + y[1]));
        // The widths of a pixel in texels, along u and along v.
        let width = changes.map(|[x, y]| [(x[0] + y[0]).sqrt(), (x[1] + y[1]).sqrt()]);
        let mut colors = u32x8::splat(simd, 0);
        // Texels lie anywhere in memory: each pixel asks for its own.
        for l in (0..LANES).filter(|&l| wanted[l] != 0) {
            let detail = change.map_or(0.0, |change| 0.5 * log2(change[l]));
            let texel = match self.sampler.reveal {
                None | Some(TextureReveal::Affine) => self.texel([s[l], t[l]], detail),
                Some(TextureReveal::Levels) => self.with_level([s[l], t[l]], detail),
                Some(TextureReveal::Texels) => {
                    self.with_lines([s[l], t[l]], width.map_or([1.0; 2], |[u, v]| [u[l], v[l]]))
                }
            };
            colors[l] = Pixel::from_le_bytes(std::array::from_fn(|k| byte(texel[k] * self.tint[k])));
        }
        colors
    }

    /// The colour at a point, half of which is that of the level of detail.
    fn with_level(&self, uv: [f32; 2], detail: f32) -> [f32; 4] {
        let last = self.image.levels().len().min(LEVEL_COLORS.len()).saturating_sub(1);
        let detail = match self.sampler.filter {
            Filter::Trilinear => detail.clamp(0.0, last as f32),
            Filter::Nearest | Filter::Bilinear => 0.0,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 5")]
        let finer = (detail as usize).min(last);
        let share = detail - finer as f32;
        let [fine, coarse] = [finer, (finer + 1).min(last)].map(|level| LEVEL_COLORS[level]);
        let mixed = |a: u8, b: u8| f32::from(a) + share * (f32::from(b) - f32::from(a));
        let level = [mixed(fine.r, coarse.r), mixed(fine.g, coarse.g), mixed(fine.b, coarse.b), 255.0];
        let own = self.texel(uv, detail);
        std::array::from_fn(|k| 0.5 * (own[k] + level[k] * own[3] / 255.0))
    }

    /// The nearest texel, and lines between texels. `width`: that of a pixel in texels, along u and along v.
    fn with_lines(&self, uv: [f32; 2], width: [f32; 2]) -> [f32; 4] {
        /// Texels of fewer pixels would be all lines.
        const SMALLEST: f32 = 4.0;
        let Some(level) = self.image.levels().first() else { return [0.0; 4] };
        let own = nearest(level, self.sampler, uv);
        let is_near = |t: f32, size: u32, width: f32| {
            let within = t * size as f32;
            let within = within - within.floor();
            width * SMALLEST < 1.0 && within.min(1.0 - within) < 0.5 * width
        };
        if is_near(uv[0], level.width, width[0]) || is_near(uv[1], level.height, width[1]) {
            // Dark on light texels and light on dark ones.
            let line = if own[0] + own[1] + own[2] > 1.5 * own[3] { 0.0 } else { own[3] };
            return [0.5 * (own[0] + line), 0.5 * (own[1] + line), 0.5 * (own[2] + line), own[3]];
        }
        own
    }

    /// The colour at a point, premultiplied, 0 … 255. `detail`: λ.
    fn texel(&self, uv: [f32; 2], detail: f32) -> [f32; 4] {
        let levels = self.image.levels();
        let between = |level: &Level| bilinear(level, self.sampler, uv);
        match (self.sampler.filter, levels) {
            (Filter::Nearest, [level, ..]) => nearest(level, self.sampler, uv),
            (Filter::Bilinear, [level, ..]) | (Filter::Trilinear, [level]) => between(level),
            (Filter::Trilinear, [level, ..]) if detail <= 0.0 => between(level),
            (Filter::Trilinear, [.., last]) => {
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative; saturates")]
                let finer = detail as usize;
                match levels.get(finer..) {
                    Some([fine, coarse, ..]) => {
                        self.two_levels.set(self.two_levels.get() + 1);
                        let share = detail - finer as f32;
                        let (fine, coarse) = (between(fine), between(coarse));
                        std::array::from_fn(|k| fine[k] + share * (coarse[k] - fine[k]))
                    }
                    _ => between(last),
                }
            }
            (_, []) => [0.0; 4],
        }
    }
}

/// Texture coordinates less whole numbers, where the picture repeats: near 0 they are exact.
fn near_zero(mut uv: [[f32; 2]; 3], sampler: Sampler) -> [[f32; 2]; 3] {
    for (axis, wrap) in [sampler.wrap_u, sampler.wrap_v].into_iter().enumerate() {
        let least = uv.iter().map(|uv| uv[axis]).fold(f32::INFINITY, f32::min);
        let whole = match wrap {
            Wrap::Clamp => 0.0,
            Wrap::Repeat => least.floor(),
            // Mirrored, it is the same again after two.
            Wrap::Mirror => 2.0 * (0.5 * least).floor(),
        };
        if whole.is_finite() {
            uv.iter_mut().for_each(|uv| uv[axis] -= whole);
        }
    }
    uv
}

/// The nearest texel.
fn nearest(level: &Level, sampler: Sampler, uv: [f32; 2]) -> [f32; 4] {
    let axis = |t: f32, size: u32, wrap: Wrap| {
        let last = size.saturating_sub(1);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped; NaN is 0")]
        let index = (folded(t, wrap) * size as f32).clamp(0.0, last as f32) as u32;
        index.min(last)
    };
    let (x, y) = (axis(uv[0], level.width, sampler.wrap_u), axis(uv[1], level.height, sampler.wrap_v));
    level.texel(x, y).map(f32::from)
}

/// Between the four nearest texels. Beyond a border that is not repeated the border goes on.
fn bilinear(level: &Level, sampler: Sampler, uv: [f32; 2]) -> [f32; 4] {
    let axis = |t: f32, size: u32, wrap: Wrap| {
        let last = size.saturating_sub(1);
        let t = folded(t, wrap) * size as f32 - 0.5;
        if wrap == Wrap::Repeat {
            let low = t.floor();
            let index = |at: f32| {
                // One before the first is the last, and one behind the last is the first.
                let at = if at < 0.0 { last as f32 } else { at };
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates; NaN is 0")]
                let index = at as u32;
                if index > last { 0 } else { index }
            };
            return (index(low), index(low + 1.0), t - low);
        }
        let t = t.clamp(0.0, last as f32);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped above")]
        let low = t as u32;
        (low, (low + 1).min(last), t - low as f32)
    };
    let (x0, x1, s) = axis(uv[0], level.width, sampler.wrap_u);
    let (y0, y1, t) = axis(uv[1], level.height, sampler.wrap_v);
    let at = |x: u32, y: u32| level.texel(x, y).map(f32::from);
    let (a, b, c, d) = (at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1));
    std::array::from_fn(|k| {
        let top = a[k] + s * (b[k] - a[k]);
        let bottom = c[k] + s * (d[k] - c[k]);
        top + t * (bottom - top)
    })
}

/// A coordinate as one of the picture, 0 … 1; as it is where the border goes on.
#[inline(always)]
fn folded(t: f32, wrap: Wrap) -> f32 {
    match wrap {
        Wrap::Clamp => t,
        Wrap::Repeat => t - t.floor(),
        Wrap::Mirror => {
            let twice = t - 2.0 * (0.5 * t).floor();
            if twice > 1.0 { 2.0 - twice } else { twice }
        }
    }
}

/// log₂ to 0.01, by operations that every machine does alike; very small for 0, and for what is none.
fn log2(value: f32) -> f32 {
    let bits = value.to_bits();
    #[expect(clippy::cast_precision_loss, clippy::cast_possible_wrap, reason = "an exponent")]
    let exponent = (bits >> 23) as i32 as f32 - 127.0;
    let mantissa = f32::from_bits(bits & 0x7f_ffff | 0x3f80_0000);
    // A parabola through 0 at 1 and 1 at 2.
    exponent + (mantissa * (2.0 - mantissa / 3.0) - 5.0 / 3.0)
}

/// A channel; 0 for NaN.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates: 0 … 255, NaN is 0")]
fn byte(channel: f32) -> u8 {
    (channel + 0.5) as u8
}
