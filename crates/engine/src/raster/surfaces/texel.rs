//! Pictures on triangles: the colour of a texture at a pixel.
//!
//! The level of detail comes from the change of (u, v) from pixel to pixel, which is exact for perspective: with U, V
//! and W affine on the picture, u = U/W changes by (∂U/∂x − u ∂W/∂x)/W along x. A level whose texels are as large as a
//! pixel is λ = log₂ of the longer of the two changes, in texels of the picture itself [Heckbert 1989].

use crate::appearance::{Filter, LEVEL_COLORS, Rgba, Sampler, Texture, TextureReveal, Wrap};
use crate::simd::prelude::*;

use super::filter::{Channels, bilinear, nearest, trilinear};
use crate::raster::pixel::LANES;

/// A triangle with a picture on it in each lane.
#[derive(Clone)]
pub(super) struct Textured<'a, K: Simd> {
    image: &'a Texture,
    sampler: Sampler,
    /// No texel lets anything through.
    opaque: bool,
    /// The channels of the tint, 0 … 1, premultiplied.
    tint: [f32; 4],
    /// Texture coordinates, u and v, of the three vertices, near 0 if the picture repeats, so that they are exact.
    pub(super) uv: [[f32x8<K>; 3]; 2],
    /// The change of u/w and v/w in texels, and of 1/w, along x and y. Only for a filter that asks for it.
    change: Option<[[f32x8<K>; 3]; 2]>,
}

impl<'a, K: Simd> Textured<'a, K> {
    /// `change` is that of the share of each vertex along x and y, before it's divided by the sum of all three.
    #[inline(always)]
    pub(super) fn new(
        image: &'a Texture,
        sampler: Sampler,
        tint: Rgba,
        uv: [[f32x8<K>; 3]; 2],
        change: [[f32x8<K>; 3]; 2],
    ) -> Self {
        let uv = [near_zero(uv[0], sampler.wrap_u), near_zero(uv[1], sampler.wrap_v)];
        let alpha = f32::from(tint.a) / 255.0;
        let tint = [tint.r, tint.g, tint.b, 255].map(|c| f32::from(c) / 255.0 * alpha);
        let asks = sampler.filter == Filter::Trilinear && image.levels().len() > 1
            || matches!(sampler.reveal, Some(TextureReveal::Levels | TextureReveal::Texels));
        let [wide, high] = [image.width() as f32, image.height() as f32];
        let change = if asks {
            Some([texels_changed(change[0], &uv, [wide, high]), texels_changed(change[1], &uv, [wide, high])])
        } else {
            None
        };
        Self { image, sampler, opaque: image.is_opaque(), tint, uv, change }
    }

    /// The triangle of one lane in each.
    #[inline(always)]
    pub(super) fn of(&self, lane: usize) -> Self {
        let uv = [all(&self.uv[0], lane), all(&self.uv[1], lane)];
        let change = match &self.change {
            Some([x, y]) => Some([all(x, lane), all(y, lane)]),
            None => None,
        };
        Self { uv, change, ..*self }
    }

    /// The colours of eight pixels at these coordinates, premultiplied, 0 … 255; `w`: the interpolated w there.
    #[inline(always)]
    pub(super) fn colors(&self, wanted: mask32x8<K>, uv: [f32x8<K>; 2], w: f32x8<K>) -> Channels<K> {
        let simd = wanted.witness();
        // The squares of the changes of u and v in texels, from pixel to pixel: along x, along y.
        let sides = [self.image.width() as f32, self.image.height() as f32];
        let zero = f32x8::splat(simd, 0.0);
        let (mut x, mut y, mut detail) = ([zero; 2], [zero; 2], zero);
        if let Some([change_x, change_y]) = &self.change {
            (x, y) = (squares(change_x, uv, w, sides), squares(change_y, uv, w, sides));
            // Of the longer change. The root is taken by halving the logarithm.
            detail = log2((x[0] + x[1]).max(y[0] + y[1])) * 0.5;
        }
        let texel = match self.sampler.reveal {
            None | Some(TextureReveal::Affine) => self.texel(wanted, uv, detail),
            Some(TextureReveal::Levels) => self.with_level(wanted, uv, detail),
            // The widths of a pixel in texels, along u and along v.
            Some(TextureReveal::Texels) => self.with_lines(wanted, uv, [(x[0] + y[0]).sqrt(), (x[1] + y[1]).sqrt()]),
        };
        let mut tinted = texel;
        for k in 0..4 {
            tinted[k] = texel[k] * self.tint[k];
        }
        tinted
    }

    /// The colours at points, half of which are those of the level of detail.
    #[inline(always)]
    fn with_level(&self, wanted: mask32x8<K>, uv: [f32x8<K>; 2], detail: f32x8<K>) -> Channels<K> {
        let last = self.image.levels().len().min(LEVEL_COLORS.len()).saturating_sub(1);
        let own = self.texel(wanted, uv, detail);
        let mut mixed = own;
        for l in 0..LANES {
            let detail = match self.sampler.filter {
                Filter::Trilinear => detail[l].clamp(0.0, last as f32),
                Filter::Nearest | Filter::Bilinear => 0.0,
            };
            #[expect(clippy::cast_possible_truncation, reason = "0 … 5")]
            let finer = (detail as usize).min(last);
            let share = detail - finer as f32;
            let [fine, coarse] = [finer, (finer + 1).min(last)].map(|level| LEVEL_COLORS[level]);
            let between = |a: u8, b: u8| f32::from(a) + share * (f32::from(b) - f32::from(a));
            let level = [between(fine.r, coarse.r), between(fine.g, coarse.g), between(fine.b, coarse.b), 255.0];
            for k in 0..4 {
                mixed[k][l] = 0.5 * (own[k][l] + level[k] * own[3][l] / 255.0);
            }
        }
        mixed
    }

    /// The nearest texels, and lines between texels. `width` is that of a pixel in texels, along u and along v.
    #[inline(always)]
    fn with_lines(&self, wanted: mask32x8<K>, uv: [f32x8<K>; 2], width: [f32x8<K>; 2]) -> Channels<K> {
        let simd = wanted.witness();
        let Some(level) = self.image.levels().first() else { return [f32x8::splat(simd, 0.0); 4] };
        let own = nearest(level, self.sampler, wanted, uv);
        let near = near_line(uv[0], level.width, width[0]) | near_line(uv[1], level.height, width[1]);
        // Dark on light texels and light on dark ones.
        let light = (own[0] + own[1] + own[2]).simd_gt(own[3] * 1.5);
        let line = light.select(f32x8::splat(simd, 0.0), own[3]);
        let mut mixed = own;
        for k in 0..3 {
            mixed[k] = near.select((own[k] + line) * 0.5, own[k]);
        }
        mixed
    }

    /// The colours at points, premultiplied, 0 … 255. `detail`: λ.
    #[inline(always)]
    fn texel(&self, wanted: mask32x8<K>, uv: [f32x8<K>; 2], detail: f32x8<K>) -> Channels<K> {
        let simd = wanted.witness();
        let Some(first) = self.image.levels().first() else { return [f32x8::splat(simd, 0.0); 4] };
        let opaque = self.opaque;
        match self.sampler.filter {
            Filter::Nearest => nearest(first, self.sampler, wanted, uv),
            Filter::Trilinear if let Some(levels) = self.image.level_pairs() => {
                trilinear(levels, self.sampler, opaque, wanted, uv, detail)
            }
            Filter::Trilinear | Filter::Bilinear => bilinear(first, self.sampler, opaque, wanted, uv),
        }
    }
}

/// Three values of one lane in each.
#[inline(always)]
pub(super) fn all<K: Simd>(values: &[f32x8<K>; 3], lane: usize) -> [f32x8<K>; 3] {
    let simd = values[0].witness();
    [f32x8::splat(simd, values[0][lane]), f32x8::splat(simd, values[1][lane]), f32x8::splat(simd, values[2][lane])]
}

/// The changes of u/w and v/w in texels, and of 1/w, from those of the shares of the vertices.
#[inline(always)]
fn texels_changed<K: Simd>(c: [f32x8<K>; 3], [u, v]: &[[f32x8<K>; 3]; 2], sides: [f32; 2]) -> [f32x8<K>; 3] {
    [
        (c[0] * u[0] + c[1] * u[1] + c[2] * u[2]) * sides[0],
        (c[0] * v[0] + c[1] * v[1] + c[2] * v[2]) * sides[1],
        c[0] + c[1] + c[2],
    ]
}

/// The squares of the changes of u and v in texels along one axis.
#[inline(always)]
fn squares<K: Simd>(change: &[f32x8<K>; 3], uv: [f32x8<K>; 2], w: f32x8<K>, sides: [f32; 2]) -> [f32x8<K>; 2] {
    let du = (change[0] - uv[0] * (change[2] * sides[0])) * w;
    let dv = (change[1] - uv[1] * (change[2] * sides[1])) * w;
    [du * du, dv * dv]
}

/// Texture coordinates less whole numbers, if the picture repeats. Near 0 they're exact.
#[inline(always)]
fn near_zero<K: Simd>(q: [f32x8<K>; 3], wrap: Wrap) -> [f32x8<K>; 3] {
    let least = q[0].min(q[1]).min(q[2]);
    let whole = match wrap {
        Wrap::Clamp => return q,
        Wrap::Repeat => least.floor(),
        // Mirrored, it is the same again after two.
        Wrap::Mirror => (least * 0.5).floor() * 2.0,
    };
    let whole = whole.abs().simd_lt(f32::INFINITY).select(whole, f32x8::splat(whole.witness(), 0.0));
    [q[0] - whole, q[1] - whole, q[2] - whole]
}

/// The points within half a pixel of a line between texels, along one axis. `width` is that of a pixel in texels.
#[inline(always)]
fn near_line<K: Simd>(t: f32x8<K>, size: u32, width: f32x8<K>) -> mask32x8<K> {
    /// Texels of fewer pixels would be all lines.
    const SMALLEST: f32 = 4.0;
    let within = t * size as f32;
    let within = within - within.floor();
    let distance = within.min(f32x8::splat(t.witness(), 1.0) - within);
    (width * SMALLEST).simd_lt(1.0) & distance.simd_lt(width * 0.5)
}

/// log₂ to 0.01, by operations that every machine does alike. Very small for 0, and for anything that isn't a number.
#[inline(always)]
fn log2<K: Simd>(value: f32x8<K>) -> f32x8<K> {
    let bits = value.bitcast::<u32x8<K>>();
    let exponent = (bits >> 23).bitcast::<i32x8<K>>().to_float::<f32x8<K>>() - 127.0;
    let mantissa = ((bits & 0x7f_ffff) | 0x3f80_0000).bitcast::<f32x8<K>>();
    // A parabola through 0 at 1 and 1 at 2.
    exponent + (mantissa * (f32x8::splat(value.witness(), 2.0) - mantissa / 3.0) - 5.0 / 3.0)
}
