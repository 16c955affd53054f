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
use std::sync::Arc;

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

/// One value for each of `N` points that are lit together.
type Lanes<const N: usize> = [f32; N];

impl Lighting {
    /// The colour that the viewer gets from a point of a surface: the one formula for faces, vertices and pixels.
    ///
    /// `color · (ambient + diffuse Σ max(0, n·l)) + white · specular Σ max(0, n·h)^shininess`, with **h** halfway between the
    /// directions to the light and to the viewer, and no specular term where the light is behind the surface. `normal` and
    /// `position` are in view space; the normal may have any length, and without one only the ambient share is left. With
    /// `two_sided`, a normal that points away from the viewer is turned round. Alpha is not touched. `[2]`, `[3]` §1.8
    #[must_use]
    pub fn shade(&self, normal: [f32; 3], position: [f32; 3], color: Rgba) -> Rgba {
        let [lit] = self.shade_each(&normal.map(|c| [c]), &position.map(|c| [c]), &[color]);
        lit
    }

    /// [`shade`](Self::shade) for `N` points at once, for loops that the compiler can turn into vector instructions.
    #[must_use]
    #[inline]
    pub fn shade_each<const N: usize>(
        &self,
        normals: &[Lanes<N>; 3],
        positions: &[Lanes<N>; 3],
        colors: &[Rgba; N],
    ) -> [Rgba; N] {
        let mut n = unit(normals);
        let to_viewer = if self.distant_viewer {
            [[0.0; N], [0.0; N], [1.0; N]]
        } else {
            unit(&positions.map(|axis| axis.map(|c| -c)))
        };
        if self.two_sided {
            let away = dot(&n, &to_viewer).map(|cosine| cosine < 0.0);
            for axis in &mut n {
                *axis = std::array::from_fn(|l| if away[l] { -axis[l] } else { axis[l] });
            }
        }
        let (mut diffuse, mut specular) = ([0.0_f32; N], [0.0_f32; N]);
        for light in &self.lights {
            let to_light = match *light {
                ViewLight::Directional(direction) => direction.map(|c| [c; N]),
                ViewLight::Point(place) => unit(&std::array::from_fn(|axis| positions[axis].map(|c| place[axis] - c))),
            };
            let cosine = dot(&n, &to_light);
            diffuse = std::array::from_fn(|l| diffuse[l] + at_least_zero(cosine[l]));
            if self.specular > 0.0 {
                let half = unit(&std::array::from_fn(|axis| sum(&to_light[axis], &to_viewer[axis])));
                let power = power(dot(&n, &half).map(at_least_zero), self.shininess);
                specular = std::array::from_fn(|l| specular[l] + if cosine[l] > 0.0 { power[l] } else { 0.0 });
            }
        }
        std::array::from_fn(|l| {
            let share = self.ambient + self.diffuse * diffuse[l];
            let white = 255.0 * self.specular * specular[l];
            let channel = |c: u8| to_byte(f32::from(c) * share + white);
            let Rgba { r, g, b, a } = colors[l];
            Rgba::rgba(channel(r), channel(g), channel(b), a)
        })
    }

    /// True where the positions of the points matter.
    #[must_use]
    pub fn needs_positions(&self) -> bool {
        let viewer = !self.distant_viewer && (self.two_sided || self.specular > 0.0);
        viewer || self.lights.iter().any(|light| matches!(light, ViewLight::Point(_)))
    }
}

#[inline(always)]
fn sum<const N: usize>(a: &Lanes<N>, b: &Lanes<N>) -> Lanes<N> {
    std::array::from_fn(|l| a[l] + b[l])
}

#[inline(always)]
fn dot<const N: usize>(a: &[Lanes<N>; 3], b: &[Lanes<N>; 3]) -> Lanes<N> {
    std::array::from_fn(|l| a[0][l] * b[0][l] + a[1][l] * b[1][l] + a[2][l] * b[2][l])
}

/// The unit vectors along `v`; zero where there is none.
#[inline(always)]
fn unit<const N: usize>(v: &[Lanes<N>; 3]) -> [Lanes<N>; 3] {
    let inverse = dot(v, v).map(|square| if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 });
    v.map(|axis| std::array::from_fn(|l| axis[l] * inverse[l]))
}

/// 0 also for what is no number.
#[inline(always)]
fn at_least_zero(value: f32) -> f32 {
    if value > 0.0 { value } else { 0.0 }
}

/// Whole powers by squaring: the same on every machine, and without a call.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates, and exponents are small")]
fn power<const N: usize>(mut base: Lanes<N>, exponent: f32) -> Lanes<N> {
    let mut result = [1.0; N];
    let mut left = exponent as u32;
    while left > 0 {
        if left & 1 == 1 {
            result = std::array::from_fn(|l| result[l] * base[l]);
        }
        left >>= 1;
        base = base.map(|b| b * b);
    }
    result
}

/// Rounded to the nearest of 0 … 255; 0 for what is no number.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the low byte is the number")]
fn to_byte(value: f32) -> u8 {
    let value = at_least_zero(value);
    // Next to 1.5 · 2²³ single precision has no places left for fractions.
    ((if value < 255.0 { value } else { 255.0 }) + 12_582_912.0).to_bits() as u8
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
