//! Shading of pixels for the textbook's rasterizer: flat, Gouraud's and Phong's. `[2]`, `[3]` §1.8

use std::array::from_fn;

use glam::Vec3;

use super::triangle::{has_face_colors, is_flat, perspective_matters, spread, vertex_colors};
use super::{Color, Triangle, interpolate, mix, shadow, texture};
use crate::appearance::{LightShare, Rgba};
use crate::drawing::{Base, BlockedLight, Lighting, SurfaceLight};
use crate::raster::pixel::premultiply;

/// The colour of a triangle at a point relative to its first vertex. `None` if an attribute is missing.
pub(super) fn color_at(triangle: &Triangle, center: [f32; 2]) -> Option<Color> {
    let surface = triangle.surface;
    if is_flat(surface) {
        let color = surface.face_color(triangle.number)?;
        return Some(if surface.translucent { premultiplied(color) } else { [color.r, color.g, color.b, 255] });
    }
    match vertex_colors(surface) {
        Some(colors) => Some(gouraud(triangle, triangle.of(colors)?, center)),
        None => per_pixel(triangle, center),
    }
}

/// Opaque colours between those of the vertices, channel by channel. With perspective, the channel divided by w is
/// affine on the picture, and so is 1/w. `[2]`
fn gouraud(triangle: &Triangle, colors: [Rgba; 3], center: [f32; 2]) -> Color {
    let perspective = perspective_matters(spread(colors), triangle.inverse_w);
    let inverse_w = triangle.plane(triangle.inverse_w);
    let channel = |of: fn(Rgba) -> u8| {
        let c = colors.map(|color| f32::from(of(color)));
        let plane = triangle.plane(c);
        nearest(plane.hold(if perspective {
            let divided = triangle.plane(from_fn(|k| c[k] * triangle.inverse_w[k]));
            divided.at(center) * (1.0 / inverse_w.hold(inverse_w.at(center)))
        } else {
            plane.at(center)
        }))
    };
    [channel(|c| c.r), channel(|c| c.g), channel(|c| c.b), 255]
}

/// A colour from interpolated attributes. The base, in light, less what shadows take away.
fn per_pixel(triangle: &Triangle, center: [f32; 2]) -> Option<Color> {
    let surface = triangle.surface;
    let (shares, w) = interpolate(triangle, center);
    // Colours are premultiplied before they're mixed, so that clear ones don't show.
    let [r, g, b, alpha] = match &surface.base {
        Base::Solid(_) | Base::Faces(_) => straight(surface.face_color(triangle.number)?),
        Base::Vertices(colors) => {
            let colors = triangle.of(colors)?.map(|color| premultiplied(color).map(f32::from));
            mix(shares, colors).map(half_up)
        }
        Base::Texture { .. } => texture(triangle, shares, w)?.map(half_up),
    };
    let most = if has_face_colors(surface) { 255 } else { alpha };
    let light = match &surface.light {
        SurfaceLight::InBase => None,
        SurfaceLight::Faces(lights) => Some(shadowed(triangle, shares, [*lights.get(triangle.number)?; 3])),
        SurfaceLight::Vertices(lights) => Some(shadowed(triangle, shares, triangle.of(lights)?)),
        SurfaceLight::PerPixel(light) => {
            let (normals, positions) = (triangle.of(&light.normals)?, triangle.of(&light.positions)?);
            let arriving = |k| {
                let of_lamp = surface.shadows.iter().find(|shadow| shadow.taken == BlockedLight::Light(k));
                of_lamp.map_or(1.0, |of_lamp| shadow(triangle, of_lamp, shares))
            };
            Some(reflected(&light.lighting, mix(shares, normals).into(), mix(shares, positions).into(), arriving))
        }
    };
    let [r, g, b] = light.map_or([r, g, b], |light| [r, g, b].map(|c| lit(c, light, most)));
    Some(match has_face_colors(surface) {
        _ if !surface.translucent => [r, g, b, 255],
        true => premultiplied(Rgba::rgba(r, g, b, alpha)),
        false => [r, g, b, alpha],
    })
}

/// Light from vertices or faces, less the part of lamps that don't arrive.
fn shadowed(triangle: &Triangle, shares: [f32; 3], lights: [LightShare; 3]) -> LightShare {
    let mut light = mix(shares, lights);
    for of_lamp in &triangle.surface.shadows {
        let taken = match &of_lamp.taken {
            BlockedLight::Faces(lights) => lights.get(triangle.number).map(|&light| [light; 3]),
            BlockedLight::Vertices(lights) => triangle.of(lights),
            BlockedLight::Light(_) => None,
        };
        if let Some(taken) = taken.map(|taken| mix(shares, taken))
            && (taken[0] > 0.0 || taken[1] > 0.0)
        {
            let missing = 1.0 - shadow(triangle, of_lamp, shares);
            light = from_fn(|k| light[k] - taken[k] * missing);
        }
    }
    light
}

/// The reflection model of [`lighting`](crate::lighting), for one point: the share of its own colour that it sends
/// back, and the white added to that. `arriving`: the share of each lamp's light. `[2]`, `[3]` §1.8
fn reflected(lighting: &Lighting, normal: Vec3, position: Vec3, arriving: impl Fn(usize) -> f32) -> LightShare {
    let unit = |v: Vec3| if v.dot(v) > 0.0 { v * (1.0 / v.dot(v).sqrt()) } else { Vec3::ZERO };
    let to_viewer = if lighting.distant_viewer { Vec3::Z } else { unit(-position) };
    let mut n = unit(normal);
    if lighting.two_sided && n.dot(to_viewer) < 0.0 {
        n = -n;
    }
    let (mut diffuse, mut specular) = (0.0, 0.0);
    for (k, light) in lighting.lights.iter().enumerate() {
        let vector = Vec3::from(light.vector);
        let to_light = if light.distant { vector } else { unit(vector - position) };
        let cosine = n.dot(to_light);
        if cosine > 0.0 {
            let share = arriving(k);
            diffuse += cosine * share;
            let halfway = unit(to_light + to_viewer);
            specular += power(n.dot(halfway).max(0.0), lighting.shininess) * share;
        }
    }
    let specular = if lighting.specular > 0.0 { specular * lighting.specular } else { 0.0 };
    [diffuse * lighting.diffuse + lighting.ambient, specular]
}

/// A whole power by squaring, which every machine rounds alike.
#[expect(clippy::cast_possible_truncation, reason = "exponents are small")]
fn power(mut base: f32, exponent: f32) -> f32 {
    let (mut left, mut result) = (exponent as u32, 1.0);
    while left > 0 {
        if left % 2 == 1 {
            result *= base;
        }
        (left, base) = (left / 2, base * base);
    }
    result
}

/// A channel in light; `most`: the greatest value it can have.
fn lit(channel: u8, [share, white]: LightShare, most: u8) -> u8 {
    let most = f32::from(most);
    nearest((f32::from(channel) * share + white * most).max(0.0).min(most))
}

fn straight(color: Rgba) -> Color {
    [color.r, color.g, color.b, color.a]
}

fn premultiplied(color: Rgba) -> Color {
    premultiply(color).to_le_bytes()
}

/// The nearest whole number of 0 … 255; of two, the even one.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates")]
fn nearest(value: f32) -> u8 {
    value.round_ties_even() as u8
}

/// The nearest whole number of 0 … 255; of two, the upper one.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates")]
fn half_up(value: f32) -> u8 {
    (value + 0.5) as u8
}
