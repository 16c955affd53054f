//! The display list: what a picture consists of, in pixels with depth. The only thing that outputs know.
//!
//! Pixels: (0, 0) is the top-left corner of the top-left pixel, x to the right, y down; the centre of pixel (i, j) is
//! (i + ½, j + ½). Depth: **1 at the near plane, 0 at the far plane** (reversed, so that `f32` keeps its resolution where
//! perspective crowds the depths), affine in the picture's plane; the greater depth is nearer.
//!
//! Order, the same for every output, unless [`Drawing::painted_in_order`]: opaque surfaces (the nearest wins; of equal depths the first drawn stays), then
//! translucent surfaces from back to front (hidden by what is opaque and nearer), then strokes and marks (the hidden parts of
//! them as [`HiddenLines`](crate::appearance::HiddenLines) says; a stroke on a face counts as visible), then labels.

use std::ops::Range;
use std::sync::{Arc, LazyLock};

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, u32x8};

use crate::appearance::{LineStyle, MarkShape, Rgba, Texture};

/// A picture, ready for an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What is under everything.
    pub background: Rgba,
    /// Samples per pixel for surfaces: 1, 4 or 16. Strokes and labels are always smooth.
    pub antialias: u8,
    /// The surfaces are listed from back to front: each triangle, opaque or translucent, is painted over those before it,
    /// whatever their depths. The last opaque one painted still leaves its depth, for what strokes and labels ask.
    pub painted_in_order: bool,
    /// Faces.
    pub surfaces: Vec<Surface>,
    /// Lines.
    pub strokes: Vec<StrokeSet>,
    /// Point marks.
    pub marks: Vec<Mark>,
    /// Texts.
    pub labels: Vec<Label>,
}

/// A set of triangles painted one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// x, y in pixels and depth, one per vertex; all inside the picture (clipping has been done).
    pub positions: Vec<[f32; 3]>,
    /// 1/w of each vertex for perspective-correct interpolation; empty where w is the same everywhere or nothing is
    /// interpolated.
    pub inverse_w: Vec<f32>,
    /// Indices into `positions`; either winding (culling has been done).
    pub triangles: Vec<[u32; 3]>,
    /// The colours.
    pub paint: Paint,
    /// Drawn after all that is opaque, from back to front, with the alpha of its colours.
    pub translucent: bool,
    /// False: no depth test and no depth written (the plan has shown that no test can change the picture).
    pub depth_test: bool,
}

/// The colours of a [`Surface`].
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// One colour for everything.
    Solid(Rgba),
    /// One colour for each triangle.
    Faces(Vec<Rgba>),
    /// One colour for each vertex, interpolated (Gouraud).
    Vertices(Vec<Rgba>),
    /// A normal for each vertex, interpolated; light at each pixel (Phong).
    Phong(Phong),
    /// A picture, stretched over the surface.
    Texture {
        /// The picture.
        image: Arc<Texture>,
        /// Texture coordinates of each vertex, 0 … 1, (0, 0) at the top left.
        uv: Vec<[f32; 2]>,
        /// 255 is opaque.
        opacity: u8,
    },
}

/// What is needed to light a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Phong {
    /// Unit normals in view space, one per vertex.
    pub normals: Vec<[f32; 3]>,
    /// Positions in view space, one per vertex, in any unit of length that the lights share.
    pub positions: Vec<[f32; 3]>,
    /// The colour of the material.
    pub color: Rgba,
    /// The lights, in view space.
    pub lighting: Lighting,
}

/// Lights in view space, in the simple model of `[2]` and `[3]`: ambient + diffuse + specular.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Lighting {
    /// Ambient share of the colour, 0 … 1.
    pub ambient: f32,
    /// Share of the diffuse term, 0 … 1.
    pub diffuse: f32,
    /// Share of the specular term, 0 … 1.
    pub specular: f32,
    /// Exponent of the specular term, a whole number.
    pub shininess: f32,
    /// True where the viewer is at infinity (parallel projection).
    pub distant_viewer: bool,
    /// Light both sides of a face.
    pub two_sided: bool,
    /// The lights.
    pub lights: Vec<ViewLight>,
}

/// Eight vectors, coordinate by coordinate.
pub type Eight<S> = [f32x8<S>; 3];

impl Lighting {
    /// The colour that the viewer gets from a point of a surface: the one formula for faces, vertices and pixels.
    ///
    /// `color · (ambient + diffuse Σ max(0, n·l)) + white · specular Σ max(0, n·h)^shininess`, with **h** halfway between the
    /// directions to the light and to the viewer, and no specular term where the light is behind the surface. `normal` and
    /// `position` are in view space; the normal may have any length, and without one only the ambient share is left. With
    /// `two_sided`, a normal that points away from the viewer is turned round. Alpha is not touched. `[2]`, `[3]` §1.8
    #[must_use]
    pub fn shade(&self, normal: [f32; 3], position: [f32; 3], color: Rgba) -> Rgba {
        static LEVEL: LazyLock<Level> = LazyLock::new(Level::new);
        let lit = dispatch!(*LEVEL, simd => {
            let color = u32x8::splat(simd, packed(color));
            self.shade_eight(simd, splat(simd, normal), splat(simd, position), color)[0]
        });
        unpacked(lit)
    }

    /// [`shade`](Self::shade) for eight points at once. Colours are [`packed`].
    #[inline(always)]
    pub fn shade_eight<S: Simd>(&self, simd: S, normals: Eight<S>, positions: Eight<S>, colors: u32x8<S>) -> u32x8<S> {
        let zero = f32x8::splat(simd, 0.0);
        let mut n = unit(simd, normals);
        let to_viewer = if self.distant_viewer {
            splat(simd, [0.0, 0.0, 1.0])
        } else {
            unit(simd, [-positions[0], -positions[1], -positions[2]])
        };
        if self.two_sided {
            let away = dot(n, to_viewer).simd_lt(zero);
            n = [away.select(-n[0], n[0]), away.select(-n[1], n[1]), away.select(-n[2], n[2])];
        }
        let (mut diffuse, mut specular) = (zero, zero);
        for light in &self.lights {
            let to_light = match *light {
                ViewLight::Directional(direction) => splat(simd, direction),
                ViewLight::Point(place) => unit(simd, minus(splat(simd, place), positions)),
            };
            let cosine = dot(n, to_light);
            diffuse += at_least_zero(simd, cosine);
            if self.specular > 0.0 {
                let half = unit(simd, plus(to_light, to_viewer));
                let power = power(simd, at_least_zero(simd, dot(n, half)), self.shininess);
                specular += cosine.simd_gt(zero).select(power, zero);
            }
        }
        let share = diffuse * self.diffuse + self.ambient;
        let white = specular * (255.0 * self.specular);
        let red = channel(simd, colors, share, white);
        let green = channel(simd, colors >> 8, share, white) << 8;
        let blue = channel(simd, colors >> 16, share, white) << 16;
        red | green | blue | (colors & 0xff00_0000)
    }

    /// True where the positions of the points matter.
    #[must_use]
    pub fn needs_positions(&self) -> bool {
        let viewer = !self.distant_viewer && (self.two_sided || self.specular > 0.0);
        viewer || self.lights.iter().any(|light| matches!(light, ViewLight::Point(_)))
    }
}

/// A colour in one number: red in the low byte, alpha in the high one.
#[must_use]
#[inline(always)]
pub fn packed(color: Rgba) -> u32 {
    u32::from_le_bytes([color.r, color.g, color.b, color.a])
}

/// The colour that was [`packed`].
#[must_use]
#[inline(always)]
pub fn unpacked(color: u32) -> Rgba {
    let [r, g, b, a] = color.to_le_bytes();
    Rgba::rgba(r, g, b, a)
}

/// Eight times the same vector.
#[inline(always)]
fn splat<S: Simd>(simd: S, v: [f32; 3]) -> Eight<S> {
    [f32x8::splat(simd, v[0]), f32x8::splat(simd, v[1]), f32x8::splat(simd, v[2])]
}

#[inline(always)]
fn plus<S: Simd>(a: Eight<S>, b: Eight<S>) -> Eight<S> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn minus<S: Simd>(a: Eight<S>, b: Eight<S>) -> Eight<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn dot<S: Simd>(a: Eight<S>, b: Eight<S>) -> f32x8<S> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The unit vectors along `v`; zero where there is none.
#[inline(always)]
pub(crate) fn unit<S: Simd>(simd: S, v: Eight<S>) -> Eight<S> {
    let zero = f32x8::splat(simd, 0.0);
    let square = dot(v, v);
    let inverse = square.simd_gt(zero).select(f32x8::splat(simd, 1.0) / square.sqrt(), zero);
    [v[0] * inverse, v[1] * inverse, v[2] * inverse]
}

/// 0 also for what is no number.
#[inline(always)]
fn at_least_zero<S: Simd>(simd: S, value: f32x8<S>) -> f32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    value.simd_gt(zero).select(value, zero)
}

/// Whole powers by squaring: the same on every machine.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates, and exponents are small")]
fn power<S: Simd>(simd: S, mut base: f32x8<S>, exponent: f32) -> f32x8<S> {
    let mut result = f32x8::splat(simd, 1.0);
    let mut left = exponent as u32;
    while left > 0 {
        if left & 1 == 1 {
            result *= base;
        }
        left >>= 1;
        base = base * base;
    }
    result
}

/// The low bytes of `colors` under light, rounded to the nearest of 0 … 255; 0 for what is no number.
#[inline(always)]
fn channel<S: Simd>(simd: S, colors: u32x8<S>, share: f32x8<S>, white: f32x8<S>) -> u32x8<S> {
    let most = f32x8::splat(simd, 255.0);
    let value = at_least_zero(simd, (colors & 255).to_float::<f32x8<S>>() * share + white);
    // Next to 1.5 · 2²³ single precision has no places left for fractions: the low byte is the number.
    (value.simd_lt(most).select(value, most) + 12_582_912.0).bitcast::<u32x8<S>>() & 255
}

/// One light, in view space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewLight {
    /// A unit vector **towards** the light.
    Directional([f32; 3]),
    /// The position of the light.
    Point([f32; 3]),
}

/// A set of polylines that look the same.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeSet {
    /// x, y in pixels and depth.
    pub points: Vec<[f32; 3]>,
    /// Each polyline: a range of `points`. The arrow head, where the style has one, is at the last point of each.
    pub polylines: Vec<Range<u32>>,
    /// How they look; the width is in pixels of this drawing (already scaled).
    pub style: LineStyle,
}

/// A point mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// x, y in pixels and depth.
    pub position: [f32; 3],
    /// Its shape.
    pub shape: MarkShape,
    /// Half its width in pixels.
    pub radius: f32,
    /// Its colour.
    pub color: Rgba,
    /// Colour of a thin outline, so that it shows on any ground.
    pub outline: Rgba,
    /// Drawn faintly (true) or fully (false) where a face stands before it.
    pub fade_if_hidden: bool,
}

/// Where a text lies relative to its point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// The point is at the left end of the text.
    #[default]
    Left,
    /// The point is at the middle of the text.
    Center,
    /// The point is at the right end of the text.
    Right,
}

/// A text. `_c` in the text lowers one character, `_{prp}` several (subscripts).
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// x, y in pixels (before `offset`) and depth.
    pub position: [f32; 3],
    /// Moves the text, in pixels.
    pub offset: [f32; 2],
    /// The text.
    pub text: String,
    /// Height of the type in pixels.
    pub size: f32,
    /// Colour of the letters.
    pub color: Rgba,
    /// Colour of the halo that keeps the letters legible on any ground.
    pub halo: Rgba,
    /// Horizontal place; vertically the middle of the x-height is at the point.
    pub anchor: Anchor,
    /// Drawn faintly (true) or fully (false) where a face stands before its point.
    pub fade_if_hidden: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAY: Rgba = Rgba::rgba(200, 100, 40, 128);

    fn lamp(light: ViewLight) -> Lighting {
        Lighting { ambient: 0.25, diffuse: 0.5, lights: vec![light], ..Lighting::default() }
    }

    #[test]
    fn diffuse_light_follows_the_cosine() {
        // 60° from the normal: share = 0.25 + 0.5 · 0.5 = 0.5
        let sine = 0.75_f32.sqrt();
        let lighting = lamp(ViewLight::Directional([sine, 0.0, 0.5]));
        assert_eq!(lighting.shade([0.0, 0.0, 3.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(100, 50, 20, 128));
    }

    #[test]
    fn a_lamp_behind_the_face_leaves_the_ambient_share() {
        let lighting = Lighting { specular: 1.0, shininess: 1.0, ..lamp(ViewLight::Point([0.0, 0.0, -9.0])) };
        assert_eq!(lighting.shade([0.0, 0.0, 1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
        assert_eq!(lighting.shade([0.0; 3], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
    }

    #[test]
    fn two_sided_faces_are_lit_on_the_side_that_is_seen() {
        let front = lamp(ViewLight::Directional([0.0, 0.0, 1.0]));
        let both = Lighting { two_sided: true, ..front.clone() };
        assert_eq!(both.shade([0.0, 0.0, -1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(150, 75, 30, 128));
        assert_eq!(front.shade([0.0, 0.0, -1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
    }

    #[test]
    fn the_highlight_is_white_and_where_the_halfway_vector_meets_the_normal() {
        let lighting = Lighting { specular: 0.2, shininess: 2.0, ..lamp(ViewLight::Directional([0.0, 0.0, 1.0])) };
        // n·h = 1: 0.75 of the colour and 0.2 · 255 = 51 of white
        assert_eq!(lighting.shade([0.0, 0.0, 1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(201, 126, 81, 128));
    }

    #[test]
    fn numbers_that_are_none_give_a_colour_all_the_same() {
        let lighting = lamp(ViewLight::Point([f32::INFINITY, f32::NAN, 0.0]));
        assert_eq!(lighting.shade([f32::NAN; 3], [f32::INFINITY; 3], CLAY).a, 128);
    }
}
