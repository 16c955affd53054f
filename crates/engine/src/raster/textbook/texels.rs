//! Texels around a point of a texture, and levels of detail, for the textbook's rasterizer.

use std::array::from_fn;

use super::{Triangle, mix};
use crate::appearance::{Filter, Level, Sampler, Texture, Wrap};

/// The texels around a coordinate along one axis.
pub(super) struct Around {
    /// The same one twice for the nearest.
    pub(super) texels: [u32; 2],
    /// The share of the second one.
    pub(super) share: f32,
}

/// The texels around a point along both axes.
pub(super) fn texels([u, v]: [f32; 2], level: &Level, sampler: &Sampler) -> [Around; 2] {
    let Sampler { wrap_u, wrap_v, filter, .. } = *sampler;
    [around(u, level.width, wrap_u, filter), around(v, level.height, wrap_v, filter)]
}

#[expect(clippy::cast_possible_truncation, reason = "`as` saturates at 0")]
fn around(t: f32, size: u32, wrap: Wrap, filter: Filter) -> Around {
    let (last, size) = (size - 1, size as f32);
    let folded = match wrap {
        Wrap::Clamp => t,
        Wrap::Repeat => t - t.floor(),
        Wrap::Mirror => {
            let twice = t - (t * 0.5).floor() * 2.0;
            if twice > 1.0 { 2.0 - twice } else { twice }
        }
    };
    if filter == Filter::Nearest {
        let nearest = ((folded * size) as u32).min(last);
        return Around { texels: [nearest; 2], share: 0.0 };
    }
    // Texel 0 has its middle at ½.
    let t = folded * size - 0.5;
    if wrap == Wrap::Repeat {
        let first = if t < 0.0 { last } else { (t as u32).min(last) };
        let second = if first == last { 0 } else { first + 1 };
        return Around { texels: [first, second], share: t - t.floor() };
    }
    let t = t.max(0.0).min(last as f32);
    let first = t as u32;
    Around { texels: [first, (first + 1).min(last)], share: t - first as f32 }
}

/// A colour between two.
pub(super) fn between(a: [f32; 4], b: [f32; 4], share: f32) -> [f32; 4] {
    from_fn(|k| a[k] + share * (b[k] - a[k]))
}

/// Texture coordinates less whole numbers, if the picture repeats: near 0 they are exact.
pub(super) fn near_zero(uv: [[f32; 2]; 3], sampler: &Sampler) -> [[f32; 2]; 3] {
    let whole: [f32; 2] = from_fn(|k| {
        let least = uv[0][k].min(uv[1][k]).min(uv[2][k]);
        match [sampler.wrap_u, sampler.wrap_v][k] {
            Wrap::Clamp => 0.0,
            Wrap::Repeat => least.floor(),
            // Mirrored, it's the same again after two.
            Wrap::Mirror => (least * 0.5).floor() * 2.0,
        }
    });
    uv.map(|[u, v]| [u - whole[0], v - whole[1]])
}

/// The level of detail: λ = log₂ of the longer of the two changes of (u, v) from pixel to pixel, in texels. With U, V
/// and W affine on the picture, u = U/W changes by (∂U/∂x − u ∂W/∂x)/W along x [Heckbert 1989].
pub(super) fn detail(triangle: &Triangle, uv: [[f32; 2]; 3], point: [f32; 2], w: f32, image: &Texture) -> f32 {
    let planes = triangle.share_planes();
    let sides = [image.width() as f32, image.height() as f32];
    let square_of_change = |slopes: [f32; 3]| {
        let change: [f32; 3] = from_fn(|k| triangle.inverse_w[k] * slopes[k]);
        let (divided, sum) = (mix(change, uv), change[0] + change[1] + change[2]);
        let [du, dv] = [0, 1].map(|k| (divided[k] * sides[k] - point[k] * (sum * sides[k])) * w);
        du * du + dv * dv
    };
    0.5 * log2(square_of_change(planes.map(|plane| plane.dx)).max(square_of_change(planes.map(|plane| plane.dy))))
}

/// log₂ to 0.01, by operations that every machine rounds alike: the exponent, and a parabola through 0 at 1 and 1 at 2
/// for the mantissa.
fn log2(value: f32) -> f32 {
    let exponent = (value.to_bits() >> 23) as f32 - 127.0;
    let mantissa = f32::from_bits((value.to_bits() & 0x7f_ffff) | 0x3f80_0000);
    exponent + (mantissa * (2.0 - mantissa / 3.0) - 5.0 / 3.0)
}
