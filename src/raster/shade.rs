//! The colours of a triangle's pixels, eight at a time.

use crate::appearance::Texture;
use crate::drawing::{Phong, Surface};

use super::pixel::{Pixel, channels, premultiply};
use super::setup::{Plane, Triangle, greater, lesser};

/// Pixels that are worked on together.
pub(super) const LANES: usize = 8;
pub(super) type Lanes<T> = [T; LANES];

/// What colours one triangle.
pub(super) trait Shader {
    /// Goes to the row whose pixel centres are `y` below the triangle's origin.
    fn row(&mut self, y: f32);
    /// The colours of pixels whose centres are `x` to the right of the origin. Only those in `wanted` need be right.
    fn colors(&self, x: Lanes<f32>, wanted: Lanes<bool>) -> Lanes<Pixel>;
}

/// One colour.
pub(super) struct Flat(pub(super) Pixel);

impl Shader for Flat {
    #[inline(always)]
    fn row(&mut self, _y: f32) {}

    #[inline(always)]
    fn colors(&self, _x: Lanes<f32>, _wanted: Lanes<bool>) -> Lanes<Pixel> {
        [self.0; LANES]
    }
}

/// The channels of premultiplied colours that are interpolated: three for what is opaque, four for what is not.
const OPAQUE: usize = 3;

/// Colours between those of the vertices: affine.
pub(super) struct Affine<const N: usize> {
    planes: [Plane; N],
    rows: [f32; N],
}

impl<const N: usize> Affine<N> {
    #[inline(always)]
    pub(super) fn new(triangle: &Triangle, colors: [Pixel; 3]) -> Self {
        let [p, q, r] = colors.map(channels);
        Self { planes: std::array::from_fn(|k| triangle.plane([p[k], q[k], r[k]])), rows: [0.0; N] }
    }
}

impl<const N: usize> Shader for Affine<N> {
    #[inline(always)]
    fn row(&mut self, y: f32) {
        self.rows = std::array::from_fn(|k| self.planes[k].row(y));
    }

    #[inline(always)]
    fn colors(&self, x: Lanes<f32>, _wanted: Lanes<bool>) -> Lanes<Pixel> {
        pack::<N>(std::array::from_fn(|k| x.map(|x| self.planes[k].at(self.rows[k], x))))
    }
}

/// Colours between those of the vertices: perspective-correct, as c/w and 1/w are affine on the picture.
pub(super) struct Perspective<const N: usize> {
    colors: Affine<N>,
    low: [f32; N],
    high: [f32; N],
    inverse_w: Plane,
    row: f32,
}

impl<const N: usize> Perspective<N> {
    #[inline(always)]
    pub(super) fn new(triangle: &Triangle, colors: [Pixel; 3], inverse_w: [f32; 3]) -> Self {
        let [p, q, r] = colors.map(channels);
        let [u, v, w] = inverse_w;
        Self {
            colors: Affine {
                planes: std::array::from_fn(|k| triangle.plane([p[k] * u, q[k] * v, r[k] * w])),
                rows: [0.0; N],
            },
            low: std::array::from_fn(|k| p[k].min(q[k]).min(r[k])),
            high: std::array::from_fn(|k| p[k].max(q[k]).max(r[k])),
            inverse_w: triangle.plane(inverse_w),
            row: 0.0,
        }
    }
}

impl<const N: usize> Shader for Perspective<N> {
    #[inline(always)]
    fn row(&mut self, y: f32) {
        self.colors.row(y);
        self.row = self.inverse_w.row(y);
    }

    #[inline(always)]
    fn colors(&self, x: Lanes<f32>, _wanted: Lanes<bool>) -> Lanes<Pixel> {
        let w = x.map(|x| 1.0 / self.inverse_w.at(self.row, x));
        pack::<N>(std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                let value = (self.colors.rows[k] + self.colors.planes[k].dx * x[l]) * w[l];
                lesser(greater(value, self.low[k]), self.high[k])
            })
        }))
    }
}

/// Channels, 0 … 255 each, to pixels; without a fourth channel they are opaque.
#[inline(always)]
fn pack<const N: usize>(channels: [Lanes<f32>; N]) -> Lanes<Pixel> {
    std::array::from_fn(|l| {
        let alpha = if N == OPAQUE { 0xff } else { round(channels[N - 1][l]) };
        round(channels[0][l]) | round(channels[1][l]) << 8 | round(channels[2][l]) << 16 | alpha << 24
    })
}

/// True where the colours of a triangle come out the same, but for less than half a step of 255, whether they are
/// interpolated with regard to perspective or not.
///
/// Between two vertices whose w have the ratio r, the perspective share of one differs from the affine share by at most
/// (√r − 1)/(√r + 1) ≤ (r − 1)/4.
#[inline(always)]
pub(super) fn nearly_affine(colors: [Pixel; 3], inverse_w: [f32; 3]) -> bool {
    let low = lesser(lesser(inverse_w[0], inverse_w[1]), inverse_w[2]);
    let high = greater(greater(inverse_w[0], inverse_w[1]), inverse_w[2]);
    let [p, q, r] = colors.map(Pixel::to_le_bytes);
    let spread = (0..4).map(|k| p[k].max(q[k]).max(r[k]) - p[k].min(q[k]).min(r[k])).max().unwrap_or(0);
    f32::from(spread) * (high - low) < 2.0 * low
}

/// The share of each vertex in the points of a triangle, perspective-correct, for what is not affine in itself.
struct Weights {
    planes: [Plane; 3],
    rows: [f32; 3],
    inverse_w: [f32; 3],
}

impl Weights {
    fn new(triangle: &Triangle, inverse_w: [f32; 3]) -> Self {
        let planes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|q| triangle.plane(q));
        Self { planes, rows: [0.0; 3], inverse_w }
    }

    fn row(&mut self, y: f32) {
        self.rows = std::array::from_fn(|k| self.planes[k].row(y));
    }

    fn at(&self, x: f32) -> [f32; 3] {
        let b: [f32; 3] = std::array::from_fn(|k| self.planes[k].at(self.rows[k], x) * self.inverse_w[k]);
        let sum = b[0] + b[1] + b[2];
        b.map(|b| b / sum)
    }
}

fn mix<const N: usize>(weights: [f32; 3], values: &[[f32; N]; 3]) -> [f32; N] {
    std::array::from_fn(|k| weights[0] * values[0][k] + weights[1] * values[1][k] + weights[2] * values[2][k])
}

/// Light at each pixel.
pub(super) struct PerPixel<'a> {
    weights: Weights,
    normals: [[f32; 3]; 3],
    positions: [[f32; 3]; 3],
    phong: &'a Phong,
}

impl<'a> PerPixel<'a> {
    pub(super) fn new(triangle: &Triangle, phong: &'a Phong, corners: [usize; 3], inverse_w: [f32; 3]) -> Option<Self> {
        Some(Self {
            weights: Weights::new(triangle, inverse_w),
            normals: pick(&phong.normals, corners)?,
            positions: pick(&phong.positions, corners)?,
            phong,
        })
    }
}

impl Shader for PerPixel<'_> {
    fn row(&mut self, y: f32) {
        self.weights.row(y);
    }

    fn colors(&self, x: Lanes<f32>, wanted: Lanes<bool>) -> Lanes<Pixel> {
        std::array::from_fn(|k| {
            if !wanted[k] {
                return 0;
            }
            let w = self.weights.at(x[k]);
            let (normal, position) = (mix(w, &self.normals), mix(w, &self.positions));
            premultiply(self.phong.lighting.shade(normal, position, self.phong.color))
        })
    }
}

/// A picture on the face.
pub(super) struct Textured<'a> {
    weights: Weights,
    uv: [[f32; 2]; 3],
    image: &'a Texture,
    opacity: f32,
}

impl<'a> Textured<'a> {
    pub(super) fn new(
        triangle: &Triangle,
        (image, uv, opacity): (&'a Texture, &[[f32; 2]], u8),
        corners: [usize; 3],
        inverse_w: [f32; 3],
    ) -> Option<Self> {
        let opacity = f32::from(opacity) / 255.0;
        Some(Self { weights: Weights::new(triangle, inverse_w), uv: pick(uv, corners)?, image, opacity })
    }
}

impl Shader for Textured<'_> {
    fn row(&mut self, y: f32) {
        self.weights.row(y);
    }

    fn colors(&self, x: Lanes<f32>, wanted: Lanes<bool>) -> Lanes<Pixel> {
        std::array::from_fn(|k| {
            if !wanted[k] {
                return 0;
            }
            let [r, g, b, a] = texel(self.image, mix(self.weights.at(x[k]), &self.uv)).map(|c| round(c * self.opacity));
            r | g << 8 | b << 16 | a << 24
        })
    }
}

/// The texture between its four nearest texels; beyond the border the border goes on.
fn texel(image: &Texture, uv: [f32; 2]) -> [f32; 4] {
    let axis = |t: f32, size: u32| {
        let last = size.saturating_sub(1);
        let t = (t * size as f32 - 0.5).clamp(0.0, last as f32);
        #[expect(clippy::cast_possible_truncation, reason = "clamped above")]
        let low = t as u32;
        let part = t - low as f32;
        (low as usize, (low + 1).min(last) as usize, part)
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

/// Rounds a channel, 0 … 255.
#[inline(always)]
fn round(v: f32) -> u32 {
    // 1.5 · 2²³ leaves no bits for fractions, and the low bits are the integer.
    (v + 12_582_912.0).to_bits() & 0xff
}

/// The values at three indices; `None` where one is missing.
#[inline(always)]
pub(super) fn pick<T: Copy>(values: &[T], at: [usize; 3]) -> Option<[T; 3]> {
    Some([*values.get(at[0])?, *values.get(at[1])?, *values.get(at[2])?])
}

/// 1/w at the vertices of a triangle: 1 where the surface has none.
#[inline(always)]
pub(super) fn inverse_w(surface: &Surface, corners: [usize; 3]) -> Option<[f32; 3]> {
    if surface.inverse_w.is_empty() { Some([1.0; 3]) } else { pick(&surface.inverse_w, corners) }
}
