//! Light, textures and translucent colours between vertices: computed at each pixel, eight at a time.
//!
//! Attributes are interpolated with regard to perspective: a / w and 1 / w are affine on the picture, so the share of
//! each vertex in a pixel is found first, and every attribute is the sum of the three values with these shares.

use crate::appearance::{Rgba, Texture};
use crate::drawing::{Base, Lighting, Surface, SurfaceLight};
use crate::lighting::{packed, shade_eight};
use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, mask32x8, u32x8};

use super::pixel::{Pixel, channels, premultiply};
use super::setup::{AffineValue, Triangle, pick};
use super::shade::{LANES, Shader, inverse_w};

/// Premultiplied colours as floating-point channels.
type Channels = [f32; 4];

/// The shader of a triangle that is coloured pixel by pixel.
pub(super) struct PerPixel<'a, K: Simd> {
    weights: Weights,
    x: f32x8<K>,
    y: f32x8<K>,
    base: TriangleBase<'a>,
    light: Option<TriangleLight<'a>>,
    translucent: bool,
}

/// The base colours of a triangle; attributes of its vertices are in the order of the corners.
enum TriangleBase<'a> {
    /// Not premultiplied.
    One(Rgba),
    /// Premultiplied.
    Vertices([Channels; 3]),
    Texture {
        uv: [[f32; 2]; 3],
        image: &'a Texture,
        opacity: f32,
    },
}

/// The inputs for the light at the pixels of a triangle.
struct TriangleLight<'a> {
    normals: [[f32; 3]; 3],
    positions: [[f32; 3]; 3],
    lighting: &'a Lighting,
}

impl<'a, K: Simd> PerPixel<'a, K> {
    /// `None` where the surface's arrays have nothing for this triangle.
    pub(super) fn new(
        simd: K,
        surface: &'a Surface,
        triangle: &Triangle,
        index: u32,
        corners: [usize; 3],
    ) -> Option<Self> {
        let base = TriangleBase::new(surface, index, corners)?;
        let light = match &surface.light {
            SurfaceLight::InBase => None,
            SurfaceLight::PerPixel(light) => Some(TriangleLight {
                normals: pick(&light.normals, corners)?,
                positions: pick(&light.positions, corners)?,
                lighting: &light.lighting,
            }),
        };
        let weights = Weights::new(triangle, inverse_w(surface, corners)?);
        let zero = f32x8::splat(simd, 0.0);
        Some(Self { weights, x: zero, y: zero, base, light, translucent: surface.translucent })
    }
}

impl<K: Simd> Shader<K> for PerPixel<'_, K> {
    #[inline(always)]
    fn columns(&mut self, x: f32x8<K>) {
        self.x = x;
    }

    #[inline(always)]
    fn rows(&mut self, y: f32x8<K>) {
        self.y = y;
    }

    #[inline(always)]
    fn colors(&self, wanted: mask32x8<K>) -> u32x8<K> {
        let simd = wanted.witness();
        let w = self.weights.at(self.x, self.y);
        let own = match &self.base {
            TriangleBase::One(color) => u32x8::splat(simd, packed(*color)),
            TriangleBase::Vertices(colors) => bytes(mix(w, colors)),
            TriangleBase::Texture { uv, image, opacity } => {
                // Texels lie anywhere in memory: each pixel asks for its own.
                let [s, t] = mix(w, uv);
                let mut colors = u32x8::splat(simd, 0);
                for l in (0..LANES).filter(|&l| wanted[l] != 0) {
                    colors[l] = Pixel::from_le_bytes(texel(image, [s[l], t[l]]).map(|c| byte(c * opacity)));
                }
                colors
            }
        };
        let lit = self.light.as_ref().map_or(own, |light| {
            let most = match &self.base {
                TriangleBase::One(_) => f32x8::splat(simd, 255.0),
                TriangleBase::Vertices(_) | TriangleBase::Texture { .. } => (own >> 24).to_float(),
            };
            shade_eight(simd, light.lighting, mix(w, &light.normals), mix(w, &light.positions), own, most)
        });
        match &self.base {
            // The alpha of opaque surfaces does not count.
            _ if !self.translucent => lit | 0xff00_0000,
            TriangleBase::One(color) => premultiply_eight(lit, color.a),
            TriangleBase::Vertices(_) | TriangleBase::Texture { .. } => lit,
        }
    }
}

impl<'a> TriangleBase<'a> {
    fn new(surface: &'a Surface, index: u32, corners: [usize; 3]) -> Option<Self> {
        Some(match &surface.base {
            Base::Solid(_) | Base::Faces(_) => Self::One(surface.face_color(index as usize)?),
            Base::Vertices(colors) => Self::Vertices(pick(colors, corners)?.map(|c| channels(premultiply(c)))),
            Base::Texture { image, uv, opacity } => {
                Self::Texture { uv: pick(uv, corners)?, image, opacity: f32::from(*opacity) / 255.0 }
            }
        })
    }
}

/// The share of each vertex in the points of a triangle, perspective-correct.
struct Weights {
    planes: [AffineValue; 3],
    inverse_w: [f32; 3],
}

impl Weights {
    fn new(triangle: &Triangle, inverse_w: [f32; 3]) -> Self {
        let planes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|q| triangle.plane(q));
        Self { planes, inverse_w }
    }

    #[inline(always)]
    fn at<K: Simd>(&self, x: f32x8<K>, y: f32x8<K>) -> [f32x8<K>; 3] {
        let mut b = [x; 3];
        for (b, (plane, &inverse_w)) in b.iter_mut().zip(self.planes.iter().zip(&self.inverse_w)) {
            *b = plane.at(x, y) * inverse_w;
        }
        let sum = b[0] + b[1] + b[2];
        [b[0] / sum, b[1] / sum, b[2] / sum]
    }
}

/// The values between those of three vertices, component by component.
#[inline(always)]
fn mix<K: Simd, const N: usize>(weights: [f32x8<K>; 3], values: &[[f32; N]; 3]) -> [f32x8<K>; N] {
    let [w0, w1, w2] = weights;
    let mut mixed = [w0; N];
    for (k, mixed) in mixed.iter_mut().enumerate() {
        *mixed = w0 * values[0][k] + w1 * values[1][k] + w2 * values[2][k];
    }
    mixed
}

/// Channels → pixels: rounded, a half up, and held to 0 … 255.
#[inline(always)]
fn bytes<K: Simd>(channels: [f32x8<K>; 4]) -> u32x8<K> {
    let [r, g, b, a] = channels;
    let byte = |v: f32x8<K>| (v + 0.5).max(0.0).min(255.0).to_int::<u32x8<K>>();
    (byte(r) | (byte(g) << 8)) | ((byte(b) << 16) | (byte(a) << 24))
}

/// The same for one channel; 0 for NaN.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates: 0 … 255, NaN is 0")]
fn byte(channel: f32) -> u8 {
    (channel + 0.5) as u8
}

/// [`premultiply`] for eight colours with the same alpha.
#[inline(always)]
fn premultiply_eight<K: Simd>(colors: u32x8<K>, alpha: u8) -> u32x8<K> {
    let channel = |shift: u32| {
        let t = ((colors >> shift) & 0xff) * u32::from(alpha) + 127;
        // t / 255 for t < 2¹⁶, without a division.
        ((t + 1 + (t >> 8)) >> 8) << shift
    };
    (channel(0) | channel(8)) | (channel(16) | (u32::from(alpha) << 24))
}

/// The texture between its four nearest texels; beyond the border the border goes on.
fn texel(image: &Texture, uv: [f32; 2]) -> Channels {
    let axis = |t: f32, size: u32| {
        let last = size.saturating_sub(1);
        let t = (t * size as f32 - 0.5).clamp(0.0, last as f32);
        #[expect(clippy::cast_possible_truncation, reason = "clamped above")]
        let low = t as u32;
        (low as usize, (low + 1).min(last) as usize, t - low as f32)
    };
    let (x0, x1, s) = axis(uv[0], image.width);
    let (y0, y1, t) = axis(uv[1], image.height);
    let at = |x: usize, y: usize| {
        let start = 4 * (y * image.width as usize + x);
        image.rgba.get(start..start + 4).map_or([0.0; 4], |c| [c[0], c[1], c[2], c[3]].map(f32::from))
    };
    let (a, b, c, d) = (at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1));
    std::array::from_fn(|k| {
        let top = a[k] + s * (b[k] - a[k]);
        let bottom = c[k] + s * (d[k] - c[k]);
        top + t * (bottom - top)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::Rgba;
    use crate::simd::with_vectors;

    #[test]
    fn eight_colours_are_premultiplied_as_one_is() {
        for v in 0..=255_u8 {
            for a in 0..=255_u8 {
                let color = Rgba::rgba(v, 255 - v, v / 2, a);
                let eight = with_vectors!(simd => premultiply_eight(u32x8::splat(simd, packed(color)), a)[5]);
                assert_eq!(eight, premultiply(color), "{color:?}");
            }
        }
    }
}
