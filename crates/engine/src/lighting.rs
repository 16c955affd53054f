//! The reflection model of `[2]` and `[3]` §1.8, for faces, vertices and pixels alike: one point at a time, or eight.

use crate::appearance::Rgba;
use crate::drawing::Lighting;
use crate::simd::prelude::*;
use crate::simd::{ROUND_F32, round_bits, with_vectors};

/// Eight vectors, coordinate by coordinate.
pub(crate) type Eight<S> = [f32x8<S>; 3];

/// The colour that the viewer gets from a point of a surface: the one formula for faces, vertices and pixels.
///
/// `color · (ambient + diffuse Σ max(0, n·l)) + white · specular Σ max(0, n·h)^shininess`, with **h** halfway between
/// the directions to the light and to the viewer, and no specular term if the light is behind the surface. `normal` and
/// `position` are in view space. The normal may have any length, and without one only the ambient share is left. With
/// `two_sided`, a normal that points away from the viewer is turned round. Alpha stays. `[2]`, `[3]` §1.8
pub fn shade(lighting: &Lighting, normal: [f32; 3], position: [f32; 3], color: Rgba) -> Rgba {
    let lit = with_vectors!(simd => {
        let color = u32x8::splat(simd, packed(color));
        shade_eight(simd, lighting, splat(simd, normal), splat(simd, position), color, f32x8::splat(simd, 255.0))[0]
    });
    unpacked(lit)
}

/// [`shade`] for eight points at once. Colours are [`packed`]. `most` is the greatest value of their channels: 255, or
/// the alpha of each if they're premultiplied by it.
#[inline(always)]
pub(crate) fn shade_eight<S: Simd>(
    simd: S,
    lighting: &Lighting,
    normals: Eight<S>,
    positions: Eight<S>,
    colors: u32x8<S>,
    most: f32x8<S>,
) -> u32x8<S> {
    let shares = light_eight(simd, lighting, normals, positions, |_, _| None);
    with_light(simd, shares, colors, most)
}

/// The light on eight points, whatever their colours: the share of its own colour that a point sends back, `ambient +
/// diffuse Σ max(0, n·l)`, and the white that is added to it, 0 … 1. `arrives` is the share of the light of a lamp that
/// no shadow takes away, at the points that it lights. `None` means all of it.
#[inline(always)]
pub(crate) fn light_eight<S: Simd>(
    simd: S,
    lighting: &Lighting,
    normals: Eight<S>,
    positions: Eight<S>,
    arrives: impl Fn(usize, mask32x8<S>) -> Option<f32x8<S>>,
) -> [f32x8<S>; 2] {
    let zero = f32x8::splat(simd, 0.0);
    let mut n = unit(simd, normals);
    let to_viewer = if lighting.distant_viewer {
        splat(simd, [0.0, 0.0, 1.0])
    } else {
        unit(simd, [-positions[0], -positions[1], -positions[2]])
    };
    if lighting.two_sided {
        let away = dot(n, to_viewer).simd_lt(zero);
        n = [away.select(-n[0], n[0]), away.select(-n[1], n[1]), away.select(-n[2], n[2])];
    }
    let (mut diffuse, mut specular) = (zero, zero);
    for (k, light) in lighting.lights.iter().enumerate() {
        let vector = splat(simd, light.vector);
        let to_light = if light.distant { vector } else { unit(simd, minus(vector, positions)) };
        let cosine = dot(n, to_light);
        let arriving = arrives(k, cosine.simd_gt(zero));
        let part = |light: f32x8<S>| arriving.map_or(light, |share| light * share);
        diffuse += part(at_least_zero(simd, cosine));
        if lighting.specular > 0.0 {
            let half = unit(simd, plus(to_light, to_viewer));
            let power = power(simd, at_least_zero(simd, dot(n, half)), lighting.shininess);
            specular += part(cosine.simd_gt(zero).select(power, zero));
        }
    }
    [diffuse * lighting.diffuse + lighting.ambient, specular * lighting.specular]
}

/// Eight colours under the light of [`light_eight`].
#[inline(always)]
pub(crate) fn with_light<S: Simd>(
    simd: S,
    [share, white]: [f32x8<S>; 2],
    colors: u32x8<S>,
    most: f32x8<S>,
) -> u32x8<S> {
    let white = white * most;
    let red = channel(simd, colors, share, white, most);
    let green = channel(simd, colors >> 8, share, white, most) << 8;
    let blue = channel(simd, colors >> 16, share, white, most) << 16;
    red | green | blue | (colors & 0xff00_0000)
}

/// A colour in one number: red in the low byte, alpha in the high one.
#[inline(always)]
pub(crate) fn packed(color: Rgba) -> u32 {
    u32::from_le_bytes([color.r, color.g, color.b, color.a])
}

/// The colour that was [`packed`].
#[inline(always)]
pub(crate) fn unpacked(color: u32) -> Rgba {
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

/// The unit vectors along `v`. Zero if there is none.
#[inline(always)]
fn unit<S: Simd>(simd: S, v: Eight<S>) -> Eight<S> {
    let zero = f32x8::splat(simd, 0.0);
    let square = dot(v, v);
    let inverse = square.simd_gt(zero).select(f32x8::splat(simd, 1.0) / square.sqrt(), zero);
    [v[0] * inverse, v[1] * inverse, v[2] * inverse]
}

/// Clamps negative values to 0, and NaN too.
#[inline(always)]
fn at_least_zero<S: Simd>(simd: S, value: f32x8<S>) -> f32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    value.simd_gt(zero).select(value, zero)
}

/// Whole powers by squaring: the same on every machine.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates, and exponents are small")]
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

/// The low bytes of `colors` under light, rounded to the nearest of 0 … `most`. 0 for NaN.
#[inline(always)]
fn channel<S: Simd>(simd: S, colors: u32x8<S>, share: f32x8<S>, white: f32x8<S>, most: f32x8<S>) -> u32x8<S> {
    let value = at_least_zero(simd, (colors & 255).to_float::<f32x8<S>>() * share + white);
    round_bits(value.simd_lt(most).select(value, most), ROUND_F32) & 255
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::ViewLight;

    const CLAY: Rgba = Rgba::rgba(200, 100, 40, 128);

    fn lamp(light: ViewLight) -> Lighting {
        Lighting { ambient: 0.25, diffuse: 0.5, lights: vec![light], ..Lighting::default() }
    }

    #[test]
    fn diffuse_light_follows_the_cosine() {
        // 60° from the normal: share = 0.25 + 0.5 · 0.5 = 0.5
        let sine = 0.75_f32.sqrt();
        let lighting = lamp(ViewLight::directional([sine, 0.0, 0.5]));
        assert_eq!(shade(&lighting, [0.0, 0.0, 3.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(100, 50, 20, 128));
    }

    #[test]
    fn a_lamp_behind_the_face_leaves_the_ambient_share() {
        let lighting = Lighting { specular: 1.0, shininess: 1.0, ..lamp(ViewLight::point([0.0, 0.0, -9.0])) };
        assert_eq!(shade(&lighting, [0.0, 0.0, 1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
        assert_eq!(shade(&lighting, [0.0; 3], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
    }

    #[test]
    fn two_sided_faces_are_lit_on_the_side_that_is_seen() {
        let front = lamp(ViewLight::directional([0.0, 0.0, 1.0]));
        let both = Lighting { two_sided: true, ..front.clone() };
        assert_eq!(shade(&both, [0.0, 0.0, -1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(150, 75, 30, 128));
        assert_eq!(shade(&front, [0.0, 0.0, -1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(50, 25, 10, 128));
    }

    #[test]
    fn the_highlight_is_white_and_where_the_halfway_vector_meets_the_normal() {
        let lighting = Lighting { specular: 0.2, shininess: 2.0, ..lamp(ViewLight::directional([0.0, 0.0, 1.0])) };
        // n·h = 1: 0.75 of the colour and 0.2 · 255 = 51 of white
        assert_eq!(shade(&lighting, [0.0, 0.0, 1.0], [0.0, 0.0, -5.0], CLAY), Rgba::rgba(201, 126, 81, 128));
    }

    #[test]
    fn numbers_that_are_none_give_a_colour_all_the_same() {
        let lighting = lamp(ViewLight::point([f32::INFINITY, f32::NAN, 0.0]));
        assert_eq!(shade(&lighting, [f32::NAN; 3], [f32::INFINITY; 3], CLAY).a, 128);
    }
}
