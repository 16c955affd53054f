//! Light, textures and translucent colours between vertices: computed at each pixel, eight at a time.
//!
//! Attributes are interpolated with regard to perspective: a / w and 1 / w are affine on the picture, so the share of
//! each vertex in a pixel is found first, and every attribute is the sum of the three values with these shares.

use crate::appearance::{LightShare, Rgba, TextureReveal};
use crate::drawing::{Base, Lighting, Shadow, Surface, SurfaceLight, TakenLight};
use crate::lighting::{light_eight, packed, with_light};
use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, mask32x8, u32x8};

use super::pixel::{channels, premultiply};
use super::setup::{AffineValue, Triangle, pick};
use super::shade::{Shader, inverse_w};
use super::shadow::TriangleShadow;
use super::texel::TexturedTriangle;

/// Premultiplied colours as floating-point channels.
type Channels = [f32; 4];

/// The shader of a triangle that is coloured pixel by pixel.
pub(super) struct PerPixel<'a, K: Simd> {
    weights: Weights,
    x: f32x8<K>,
    y: f32x8<K>,
    base: TriangleBase<'a>,
    light: TriangleLight<'a>,
    shadows: &'a [Shadow],
    index: usize,
    corners: [usize; 3],
    translucent: bool,
}

/// The base colours of a triangle; attributes of its vertices are in the order of the corners.
enum TriangleBase<'a> {
    /// Not premultiplied.
    One(Rgba),
    /// Premultiplied.
    Vertices([Channels; 3]),
    Texture(TexturedTriangle<'a>),
}

/// The light on a triangle.
enum TriangleLight<'a> {
    /// In its colours.
    InBase,
    /// Found at its vertices.
    Vertices([LightShare; 3]),
    /// To be found at each pixel, from what is interpolated between the vertices.
    Pixels { normals: [[f32; 3]; 3], positions: [[f32; 3]; 3], lighting: &'a Lighting },
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
        let affine =
            matches!(&surface.base, Base::Texture { sampler, .. } if sampler.reveal == Some(TextureReveal::Affine));
        let inverse_w = if affine { [1.0; 3] } else { inverse_w(surface, corners)? };
        let weights = Weights::new(triangle, inverse_w);
        let base = TriangleBase::new(surface, index, corners, &weights)?;
        let light = match &surface.light {
            SurfaceLight::InBase => TriangleLight::InBase,
            SurfaceLight::Faces(shares) => TriangleLight::Vertices([*shares.get(index as usize)?; 3]),
            SurfaceLight::Vertices(shares) => TriangleLight::Vertices(pick(shares, corners)?),
            SurfaceLight::PerPixel(light) => TriangleLight::Pixels {
                normals: pick(&light.normals, corners)?,
                positions: pick(&light.positions, corners)?,
                lighting: &light.lighting,
            },
        };
        let zero = f32x8::splat(simd, 0.0);
        Some(Self {
            weights,
            x: zero,
            y: zero,
            base,
            light,
            shadows: &surface.shadows,
            index: index as usize,
            corners,
            translucent: surface.translucent,
        })
    }

    /// The share of a light that arrives at pixels, with these shares of the vertices in them; `None` where nothing is
    /// known of its shadows.
    #[inline(always)]
    fn arriving(&self, shadow: &Shadow, wanted: mask32x8<K>, w: [f32x8<K>; 3]) -> Option<f32x8<K>> {
        let places = pick(&shadow.places, self.corners)?;
        Some(TriangleShadow::new(shadow, self.index)?.arriving(wanted, mix(w, &places)))
    }

    /// Baked light where shadows fall: the rest of it.
    #[inline(always)]
    fn shadowed(&self, mut left: [f32x8<K>; 2], wanted: mask32x8<K>, w: [f32x8<K>; 3]) -> [f32x8<K>; 2] {
        for shadow in self.shadows {
            let taken = match &shadow.taken {
                TakenLight::Faces(shares) => shares.get(self.index).map(|share| [*share; 3]),
                TakenLight::Vertices(shares) => pick(shares, self.corners),
                TakenLight::Light(_) => None,
            };
            if let Some(taken) = taken
                && let Some(arriving) = self.arriving(shadow, wanted, w)
            {
                let (taken, missing) = (mix(w, &taken), 1.0 - arriving);
                left = [left[0] - taken[0] * missing, left[1] - taken[1] * missing];
            }
        }
        left
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
        let (w, sum) = self.weights.at(self.x, self.y);
        let own = match &self.base {
            TriangleBase::One(color) => u32x8::splat(simd, packed(*color)),
            TriangleBase::Vertices(colors) => bytes(mix(w, colors)),
            TriangleBase::Texture(texture) => texture.colors(wanted, mix(w, &texture.uv), 1.0 / sum),
        };
        let most = || match &self.base {
            TriangleBase::One(_) => f32x8::splat(simd, 255.0),
            TriangleBase::Vertices(_) | TriangleBase::Texture(_) => (own >> 24).to_float(),
        };
        let lit = match &self.light {
            TriangleLight::InBase => own,
            TriangleLight::Vertices(shares) => with_light(simd, self.shadowed(mix(w, shares), wanted, w), own, most()),
            TriangleLight::Pixels { normals, positions, lighting } => {
                let arrives = |light: usize| {
                    let of_light = |shadow: &&Shadow| shadow.taken == TakenLight::Light(light);
                    self.shadows.iter().find(of_light).and_then(|shadow| self.arriving(shadow, wanted, w))
                };
                let shares = light_eight(simd, lighting, mix(w, normals), mix(w, positions), arrives);
                with_light(simd, shares, own, most())
            }
        };
        match &self.base {
            // The alpha of opaque surfaces does not count.
            _ if !self.translucent => lit | 0xff00_0000,
            TriangleBase::One(color) => premultiply_eight(lit, color.a),
            TriangleBase::Vertices(_) | TriangleBase::Texture(_) => lit,
        }
    }

    #[inline(always)]
    fn divides(&self) -> bool {
        true
    }

    #[inline(always)]
    fn two_levels(&self) -> u64 {
        match &self.base {
            TriangleBase::Texture(texture) => texture.two_levels.get(),
            TriangleBase::One(_) | TriangleBase::Vertices(_) => 0,
        }
    }
}

impl<'a> TriangleBase<'a> {
    fn new(surface: &'a Surface, index: u32, corners: [usize; 3], weights: &Weights) -> Option<Self> {
        Some(match &surface.base {
            Base::Solid(_) | Base::Faces(_) => Self::One(surface.face_color(index as usize)?),
            Base::Vertices(colors) => Self::Vertices(pick(colors, corners)?.map(|c| channels(premultiply(c)))),
            Base::Texture { image, sampler, uv, tint } => {
                let change = weights.change();
                Self::Texture(TexturedTriangle::new(image, *sampler, *tint, pick(uv, corners)?, change))
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

    /// The change of each vertex' share, before it is divided by the sum of all, from pixel to pixel: along x, along y.
    fn change(&self) -> [[f32; 2]; 3] {
        std::array::from_fn(|k| [self.planes[k].dx * self.inverse_w[k], self.planes[k].dy * self.inverse_w[k]])
    }

    /// The shares, and the sum by which they were divided.
    #[inline(always)]
    fn at<K: Simd>(&self, x: f32x8<K>, y: f32x8<K>) -> ([f32x8<K>; 3], f32x8<K>) {
        let mut b = [x; 3];
        for (b, (plane, &inverse_w)) in b.iter_mut().zip(self.planes.iter().zip(&self.inverse_w)) {
            *b = plane.at(x, y) * inverse_w;
        }
        let sum = b[0] + b[1] + b[2];
        ([b[0] / sum, b[1] / sum, b[2] / sum], sum)
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
