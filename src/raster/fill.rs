//! Triangles → samples.

use crate::appearance::{Rgba, Texture};
use crate::drawing::{Drawing, Paint, Surface};

use super::depth::DepthBuffer;
use super::setup::{Plane, STEPS, Triangle, samples, snap};

/// Premultiplied red, green, blue, alpha.
pub(super) type Pixel = [u8; 4];

/// The samples of a picture.
#[derive(Clone, Debug, Default)]
pub(super) struct Samples {
    pub(super) per_pixel: usize,
    pub(super) colors: Vec<Pixel>,
    pub(super) depths: Vec<f32>,
}

/// Paints all surfaces on `samples` (which hold the background), with their depth in `depth`.
pub(super) fn surfaces(drawing: &Drawing, out: &mut Samples, depth: &mut DepthBuffer) {
    for surface in drawing.surfaces.iter().filter(|s| !s.translucent) {
        for index in 0..surface.triangles.len() {
            triangle(drawing, surface, index, out, depth);
        }
    }
    let mut order: Vec<(f32, &Surface, usize)> = Vec::new();
    for surface in drawing.surfaces.iter().filter(|s| s.translucent) {
        for (index, triangle) in surface.triangles.iter().enumerate() {
            let z = triangle.map(|v| surface.positions.get(v as usize).map_or(f32::NAN, |p| p[2]));
            order.push((z[0] + z[1] + z[2], surface, index));
        }
    }
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, surface, index) in order {
        triangle(drawing, surface, index, out, depth);
    }
}

fn triangle(drawing: &Drawing, surface: &Surface, index: usize, out: &mut Samples, depth: &mut DepthBuffer) {
    let Some((triangle, z, shader)) = set_up(surface, index) else { return };
    #[expect(clippy::cast_possible_wrap, reason = "sides are at most 16384")]
    let (width, height) = (drawing.width as i32, drawing.height as i32);
    for (s, &offset) in samples(out.per_pixel).iter().enumerate() {
        for j in triangle.rows(offset, height) {
            for i in triangle.span(j, offset, width) {
                let place = |v: i32, shift: i32| f64::from(v) + 0.5 + f64::from(shift) / f64::from(STEPS);
                let (x, y) = (place(i, offset[0]), place(j, offset[1]));
                let (i, j) = (i.unsigned_abs() as usize, j.unsigned_abs() as usize);
                let index = (j * drawing.width as usize + i) * out.per_pixel + s;
                if surface.depth_test {
                    let new = z.at(x, y);
                    let old = &mut out.depths[index];
                    if new <= *old {
                        continue;
                    }
                    if !surface.translucent {
                        *old = new;
                        if s == 0 {
                            depth.set(i, j, new, z.slope());
                        }
                    }
                }
                let source = shader.at(x, y);
                let target = &mut out.colors[index];
                *target = if surface.translucent { over(source, *target) } else { source };
            }
        }
    }
}

/// `None` where there is nothing to fill or the surface's arrays do not fit together.
fn set_up(surface: &Surface, index: usize) -> Option<(Triangle, Plane, Shader<'_>)> {
    let corners = surface.triangles[index].map(|v| v as usize);
    let p = pick(&surface.positions, corners)?;
    let triangle = Triangle::new([snap(p[0])?, snap(p[1])?, snap(p[2])?])?;
    let z = triangle.plane(p.map(|p| p[2]));
    let weights = Weights::new(&triangle, &surface.inverse_w, corners)?;
    let shader = match &surface.paint {
        Paint::Solid(c) => Shader::Flat(premultiply(*c)),
        Paint::Faces(colors) => Shader::Flat(premultiply(*colors.get(index)?)),
        Paint::Vertices(colors) => {
            let colors = pick(colors, corners)?.map(|c| premultiply(c).map(f32::from));
            Shader::Vertices { weights, colors }
        }
        Paint::Phong(phong) => Shader::Phong {
            weights,
            normals: pick(&phong.normals, corners)?,
            positions: pick(&phong.positions, corners)?,
            phong,
        },
        Paint::Texture { image, uv, opacity } => {
            Shader::Texture { weights, uv: pick(uv, corners)?, image, opacity: f32::from(*opacity) / 255.0 }
        }
    };
    Some((triangle, z, shader))
}

fn pick<T: Copy>(values: &[T], at: [usize; 3]) -> Option<[T; 3]> {
    Some([*values.get(at[0])?, *values.get(at[1])?, *values.get(at[2])?])
}

/// The share of each vertex in a point of a triangle, perspective-correct.
struct Weights {
    planes: [Plane; 3],
    inverse_w: [f32; 3],
}

impl Weights {
    fn new(triangle: &Triangle, inverse_w: &[f32], corners: [usize; 3]) -> Option<Self> {
        let inverse_w = if inverse_w.is_empty() { [1.0; 3] } else { pick(inverse_w, corners)? };
        let planes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|q| triangle.plane(q));
        Some(Self { planes, inverse_w })
    }

    fn at(&self, x: f64, y: f64) -> [f32; 3] {
        let b: [f32; 3] = std::array::from_fn(|k| self.planes[k].at(x, y) * self.inverse_w[k]);
        let sum = b[0] + b[1] + b[2];
        b.map(|b| b / sum)
    }
}

fn mix<const N: usize>(weights: [f32; 3], values: &[[f32; N]; 3]) -> [f32; N] {
    std::array::from_fn(|k| weights[0] * values[0][k] + weights[1] * values[1][k] + weights[2] * values[2][k])
}

enum Shader<'a> {
    Flat(Pixel),
    Vertices { weights: Weights, colors: [[f32; 4]; 3] },
    Phong { weights: Weights, normals: [[f32; 3]; 3], positions: [[f32; 3]; 3], phong: &'a crate::drawing::Phong },
    Texture { weights: Weights, uv: [[f32; 2]; 3], image: &'a Texture, opacity: f32 },
}

impl Shader<'_> {
    fn at(&self, x: f64, y: f64) -> Pixel {
        match self {
            Self::Flat(color) => *color,
            Self::Vertices { weights, colors } => mix(weights.at(x, y), colors).map(byte),
            Self::Phong { weights, normals, positions, phong } => {
                let w = weights.at(x, y);
                premultiply(phong.lighting.shade(mix(w, normals), mix(w, positions), phong.color))
            }
            Self::Texture { weights, uv, image, opacity } => {
                texel(image, mix(weights.at(x, y), uv)).map(|c| byte(c * opacity))
            }
        }
    }
}

/// The texture between its four nearest texels; beyond the border the border goes on.
fn texel(image: &Texture, uv: [f32; 2]) -> [f32; 4] {
    let axis = |t: f32, size: u32| {
        let last = size.saturating_sub(1);
        #[expect(clippy::cast_precision_loss, reason = "pictures are far smaller than 2²⁴")]
        let t = (t * size as f32 - 0.5).clamp(0.0, last as f32);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped above")]
        let low = t as u32;
        #[expect(clippy::cast_precision_loss, reason = "as above")]
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

/// Rounds a channel.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates: 0 … 255, NaN is 0")]
fn byte(v: f32) -> u8 {
    (v + 0.5) as u8
}

pub(super) fn premultiply(c: Rgba) -> Pixel {
    let times = |v: u8| scale(v, c.a);
    [times(c.r), times(c.g), times(c.b), c.a]
}

/// v · a / 255, rounded.
pub(super) fn scale(v: u8, a: u8) -> u8 {
    let t = u32::from(v) * u32::from(a) + 128;
    #[expect(clippy::cast_possible_truncation, reason = "at most 255")]
    let r = ((t + (t >> 8)) >> 8) as u8;
    r
}

pub(super) fn over(source: Pixel, target: Pixel) -> Pixel {
    std::array::from_fn(|k| source[k].saturating_add(scale(target[k], 255 - source[3])))
}
