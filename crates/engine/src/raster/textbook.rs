//! The rasterizer of the textbook: read this file first.
//!
//! It paints the surfaces of a [`Drawing`] in the steps of `[3]` §1.1, each a function under the name of its
//! [stage](crate::stage::Stage): `fill` finds the samples of a triangle, `hidden_surfaces` is the z-buffer of `[2]`,
//! `interpolate` finds the share of each vertex in a pixel, `texture` and `shadow` add the effects, `blend` lays a
//! translucent colour over the pixel, `antialias` averages the samples of a pixel, and `write` stores the result.
//! [`paint`] calls them: for each triangle, for each pixel of its box. Nothing is kept from one pixel to the next. One
//! step comes early: hidden surfaces (8) before the colour (7), so that hidden pixels cost no colour. `triangle` holds
//! the edges and the planes of attributes, `colors` the shading, `texels` the filters, `lamp` the view of a lamp.
//! `cost` counts the work instead of painting.
//!
//! The program paints with [`Rasterizer`](super::Rasterizer), which gives the same bytes much faster. It cuts the
//! picture into bands of rows, one at a time for each thread, and looks at a triangle only in the bands that it
//! touches. One instruction works on eight triangles, or on eight pixels. Edge functions grow by a constant from pixel
//! to pixel instead of being evaluated. None of this may change a picture: `crates/engine/tests/it/textbook.rs` paints
//! random drawings both ways and demands the same bytes.
//!
//! So the order of operations is part of what this file says, because `a·x + (b·y + c)` isn't `(a·x + b·y) + c` in
//! floating point. Two choices of the fast path show: small triangles take their gradients in single precision
//! (`Triangle::new`), and the colours of vertices are divided by w only if that makes a difference (`gouraud`).
//! Strokes, marks and labels aren't painted here, nor what a texture can reveal of its own work
//! ([`TextureReveal`](crate::appearance::TextureReveal)).

mod colors;
mod cost;
mod lamp;
mod texels;
mod triangle;

use std::array::from_fn;
use std::ops::Range;

use tiny_skia::Pixmap;

use super::grid::{FINER, in_pixels, samples};
use super::new_pixmap;
use super::pixel::premultiply;
use crate::appearance::{DepthFormat, FaceOrder, Filter, Level};
use crate::drawing::{Base, Drawing, Shadow, Surface};
use colors::color_at;
pub use cost::{FaceAtPixel, PixelCost, cost, faces_at};
use lamp::{MapPoint, under};
use texels::{between, detail, near_zero, texels};
use triangle::{Plane, STEPS, Triangle};

/// A picture and the depths of its surfaces.
#[derive(Clone, Debug)]
pub struct Painted {
    /// Averages of the samples, premultiplied sRGB.
    pub image: Pixmap,
    /// The depth at the first sample of each pixel, row by row; −∞ if there is no surface.
    pub depths: Vec<f32>,
    /// The change of that depth per pixel, to the right and down, on the face that is visible there. Strokes on a face
    /// are compared with its plane.
    pub slopes: Vec<[f32; 2]>,
}

/// A premultiplied colour: red, green, blue, alpha.
type Color = [u8; 4];

/// A sample of a pixel: its colour, its depth, and the slope of the face there with its place in the list.
#[derive(Clone, Copy)]
struct Sample {
    color: Color,
    depth: f32,
    slope: [f32; 2],
    place: usize,
}

/// A triangle of a drawing: its surface, its number there, and its place among all triangles in the list.
#[derive(Clone, Copy)]
struct Face<'a> {
    surface: &'a Surface,
    number: usize,
    place: usize,
}

/// A pixel that a triangle has samples of.
struct Met<'a> {
    /// Its place among the scanned ones.
    pixel: usize,
    /// Its centre, relative to the first vertex of the triangle.
    center: [f32; 2],
    /// The samples inside the triangle, and those of them that nothing nearer hides.
    covered: &'a [usize],
    visible: &'a [usize],
}

/// Paints the surfaces of `drawing`, and the shadow maps that they need. Returns `None` if a side is 0 or the picture
/// is too large.
pub fn paint(drawing: &Drawing) -> Option<Painted> {
    let mut image = new_pixmap(drawing)?;
    paint_shadow_maps(drawing);
    let count = samples(drawing.antialias).len();
    let mut samples = cleared(drawing, drawing.height);
    for face in painting_order(drawing) {
        scan(drawing, face, 0..drawing.height, &mut samples, |triangle, met, pixel| {
            // A sample has its own coverage and its own depth, but all samples of a pixel have the colour at the
            // centre.
            if !met.visible.is_empty()
                && let Some(color) = color_at(triangle, met.center)
            {
                for &s in met.visible {
                    pixel[s].color = if face.surface.translucent { blend(color, pixel[s].color) } else { color };
                }
            }
        });
    }
    for (k, pixel) in samples.chunks(count).enumerate() {
        write(&mut image, k, antialias(pixel));
    }
    let first = || samples.iter().step_by(count);
    let (depths, slopes) = (first().map(|sample| sample.depth).collect(), first().map(|sample| sample.slope).collect());
    Some(Painted { image, depths, slopes })
}

/// The samples of some rows before anything is painted.
fn cleared(drawing: &Drawing, rows: u32) -> Vec<Sample> {
    let count = drawing.width as usize * rows as usize * samples(drawing.antialias).len();
    let color = premultiply(drawing.background).to_le_bytes();
    vec![Sample { color, depth: f32::NEG_INFINITY, slope: [0.0; 2], place: 0 }; count]
}

/// Takes a triangle to the samples of some rows of the picture. `meets` gets each pixel of which it has samples, after
/// the depth test.
fn scan(
    drawing: &Drawing,
    face: Face,
    rows: Range<u32>,
    all: &mut [Sample],
    mut meets: impl FnMut(&Triangle, Met, &mut [Sample]),
) {
    let places = samples(drawing.antialias);
    let Some(triangle) = Triangle::new(face.surface, face.number, places.len(), drawing.fine_grid) else { return };
    for [x, y] in triangle.pixels(drawing.width, &rows) {
        let pixel = (y.cast_unsigned() - rows.start) as usize * drawing.width as usize + x as usize;
        let samples = &mut all[pixel * places.len()..][..places.len()];
        let center = triangle.to_center([x, y]);
        let covered = fill(&triangle, [x, y], places);
        let visible = hidden_surfaces(&covered, samples, (&triangle, face.place), center, places, drawing);
        if !covered.is_empty() {
            meets(&triangle, Met { pixel, center, covered: &covered, visible: &visible }, samples);
        }
    }
}

/// Paints each light's view, unless that has been done. It's a drawing of its own, of which only the depths stay.
fn paint_shadow_maps(drawing: &Drawing) {
    for shadow in drawing.surfaces.iter().flat_map(|surface| &surface.shadows) {
        if let Some(views) = shadow.map.unpainted() {
            let depths = |view: &Drawing| if view.surfaces.is_empty() { None } else { Some(paint(view)?.depths) };
            shadow.map.keep(views.iter().map(|view| depths(view).unwrap_or_default()).collect());
        }
    }
}

/// The triangles in the order of painting. Opaque ones come as they're listed or sorted by the depths of their
/// centroids ([`Drawing::order`]), because the z-buffer gives the same image in any order. Translucent ones follow from
/// back to front, as in the painter's model of `[2]`; of these, the ones without a depth test come last. A drawing that
/// is painted in order keeps its own order.
fn painting_order(drawing: &Drawing) -> Vec<Face<'_>> {
    let all = drawing.surfaces.iter().flat_map(|surface| (0..surface.triangles.len()).map(move |k| (surface, k)));
    let all = all.enumerate().map(|(place, (surface, number))| Face { surface, number, place });
    if drawing.painted_in_order {
        return all.collect();
    }
    let (mut translucent, mut order): (Vec<_>, Vec<_>) = all.partition(|face| face.surface.translucent);
    let middle = |&Face { surface, number, .. }: &Face| {
        let [a, b, c] = surface.triangles[number].map(|v| surface.positions.get(v as usize).map_or(f32::NAN, |p| p[2]));
        a + b + c
    };
    let nearer = |a: &Face, b: &Face| middle(b).total_cmp(&middle(a));
    let tested = order.iter().position(|face| face.surface.depth_test).unwrap_or(order.len());
    match drawing.face_order() {
        FaceOrder::AsListed => {}
        FaceOrder::FrontToBack => order[tested..].sort_by(nearer),
        FaceOrder::BackToFront => order[tested..].sort_by(|a, b| nearer(b, a)),
    }
    translucent.sort_by(|a, b| b.surface.depth_test.cmp(&a.surface.depth_test).then(nearer(b, a)));
    order.append(&mut translucent);
    order
}

/// **Fill**: finds the samples of a pixel inside a triangle. The edge function E(p) = (b − a) × (p − a) of an edge a →
/// b is positive on its inner side (Pineda 1988). If E = 0, the sample lies on the edge. The top-left rule then gives
/// it to one of the two triangles at this edge: the one on the right of the edge, or below it if the edge is
/// horizontal. All numbers are whole, so no sample is lost or painted twice. `[3]` §1.1, step 6
fn fill(triangle: &Triangle, pixel: [i32; 2], places: &[[i32; 2]]) -> Vec<usize> {
    let is_inside = |place: [i32; 2]| {
        let p = [0, 1].map(|k| i64::from(pixel[k] * STEPS + STEPS / 2 + FINER * place[k]));
        triangle.edges().into_iter().all(|[a, b]| {
            let (right, down) = (b[0] - a[0], b[1] - a[1]);
            let e = right * (p[1] - a[1]) - down * (p[0] - a[0]);
            e > 0 || e == 0 && (down < 0 || down == 0 && right > 0)
        })
    };
    (0..places.len()).filter(|&s| is_inside(places[s])).collect()
}

/// **Hidden surfaces**: the z-buffer of `[2]`. Depths are reversed, so the greater one is nearer. A sample stays if the
/// triangle is nearer there than the stored depth. An opaque triangle then stores its own depth, a translucent one
/// doesn't. Of equal depths the first one in the list stays, in whatever order they're painted, while `<=` in `[2]`
/// lets the last one win. In a drawing that is painted in order, every sample stays. `[3]` §1.1, step 8
fn hidden_surfaces(
    covered: &[usize],
    pixel: &mut [Sample],
    (triangle, place): (&Triangle, usize),
    center: [f32; 2],
    places: &[[i32; 2]],
    drawing: &Drawing,
) -> Vec<usize> {
    let surface = triangle.surface;
    let mut visible = covered.to_vec();
    if !surface.depth_test {
        return visible;
    }
    let plane = triangle.plane(triangle.depths);
    visible.retain(|&s| {
        let z = depth(&plane, center, places[s], drawing.depth_format);
        let old = &pixel[s];
        let is_first = z >= old.depth && place < old.place && !surface.translucent;
        let is_visible = z > old.depth || is_first || drawing.painted_in_order;
        if is_visible && !surface.translucent {
            (pixel[s].depth, pixel[s].slope, pixel[s].place) = (z, [plane.dx, plane.dy], place);
        }
        is_visible
    });
    visible
}

/// The depth of a triangle at a sample of a pixel, as it's stored.
fn depth(plane: &Plane, center: [f32; 2], place: [i32; 2], format: DepthFormat) -> f32 {
    let step = plane.dx * in_pixels(place[0]) + plane.dy * in_pixels(place[1]);
    stored(plane.hold(plane.at(center) + step), format)
}

/// A depth as a format stores it: as it is, or as the nearest integer of the format.
fn stored(z: f32, format: DepthFormat) -> f32 {
    format.greatest().map_or(z, |greatest| (z * greatest).round_ties_even() * (1.0 / greatest))
}

/// **Interpolate**: finds the share of each vertex at a point, and w there. An attribute isn't affine on the picture,
/// but the attribute divided by w is, and so is 1/w. So each vertex counts with its affine share times its own 1/w. The
/// sum of the three is 1/w of the point, and dividing by it makes the shares add up to 1. `[3]` §1.1, step 7
fn interpolate(triangle: &Triangle, center: [f32; 2]) -> ([f32; 3], f32) {
    let planes = triangle.share_planes();
    let shares: [f32; 3] = from_fn(|k| triangle.inverse_w[k] * planes[k].hold(planes[k].at(center)));
    let sum = shares[0] + shares[1] + shares[2];
    (shares.map(|share| share / sum), 1.0 / sum)
}

/// An attribute between its values at the vertices.
fn mix<const N: usize>(shares: [f32; 3], [a, b, c]: [[f32; N]; 3]) -> [f32; N] {
    from_fn(|k| shares[0] * a[k] + shares[1] * b[k] + shares[2] * c[k])
}

/// **Texture**: reads a picture at interpolated coordinates, and multiplies by the tint. The result is premultiplied,
/// 0 … 255. The bilinear filter mixes the four texels around the point. The trilinear one does so in the two levels of
/// the mipmap whose texels are about as large as the pixel, and mixes those (Williams 1983). `None` if the triangle has
/// no picture. `[3]` §1.1, step 9
fn texture(triangle: &Triangle, shares: [f32; 3], w: f32) -> Option<[f32; 4]> {
    let Base::Texture { image, sampler, uv, tint, tints } = &triangle.surface.base else { return None };
    let uv = near_zero(triangle.of(uv)?, sampler);
    let point = mix(shares, uv);
    let at_level = |level: &Level| {
        let [x, y] = texels(point, level, sampler);
        let texel = |x, y| level.texel(x, y).map(f32::from);
        let row = |y| between(texel(x.texels[0], y), texel(x.texels[1], y), x.share);
        between(row(y.texels[0]), row(y.texels[1]), y.share)
    };
    let levels = image.levels();
    let mut color = at_level(levels.first()?);
    if sampler.filter == Filter::Trilinear && levels.len() > 1 {
        let (detail, last) = (detail(triangle, uv, point, w, image), levels.len() - 1);
        #[expect(clippy::cast_possible_truncation, reason = "0 … 15")]
        let finer = detail.max(0.0).min(last as f32) as usize;
        color = at_level(&levels[finer]);
        if detail > 0.0 && finer < last {
            color = between(color, at_level(&levels[finer + 1]), detail - finer as f32);
        }
    }
    if !tints.is_empty() {
        let tints = triangle.of(tints)?.map(|tint| premultiply(tint).to_le_bytes().map(f32::from));
        let tint = mix(shares, tints);
        return Some(from_fn(|k| color[k] * (tint[k] * (1.0 / 255.0))));
    }
    let alpha = f32::from(tint.a) / 255.0;
    let tint = [tint.r, tint.g, tint.b, 255].map(|c| f32::from(c) / 255.0 * alpha);
    Some(from_fn(|k| color[k] * tint[k]))
}

/// The tolerance of a bias of 1: half a texel's length, and 1/32 of the change of depth within a texel.
const BIAS: [f32; 2] = [0.5, 1.0 / 32.0];

/// **Shadow**: finds the share of a lamp's light that arrives at a point. A texel of the shadow map hides the point if
/// its depth is nearer to the lamp, that is greater, than the point's own with some tolerance (Williams 1978). The
/// texels under a square around the point, the soft edge, are averaged (Reeves 1987). `[3]` §1.1, step 9
fn shadow(triangle: &Triangle, shadow: &Shadow, shares: [f32; 3]) -> f32 {
    let (map, bias, softness) = (&shadow.map, shadow.bias, shadow.map.softness.max(0.0));
    let Some(MapPoint { depths, x, y, z, slope: [dx, dy], step }) = MapPoint::new(triangle, shadow, shares) else {
        return 1.0;
    };
    let limit = z + (step * BIAS[0] + (dx.abs() + dy.abs()) * BIAS[1]) * bias;
    let (left, top) = ((x - 0.5 * softness).floor(), (y - 0.5 * softness).floor());
    #[expect(clippy::cast_possible_truncation, reason = "8 at most")]
    let side = if softness > 0.0 { softness.ceil() as u8 + 1 } else { 1 };
    let mut sum = 0.0;
    for row in (0..side).map(|j| top + f32::from(j)) {
        for column in (0..side).map(|i| left + f32::from(i)) {
            let size = map.size as f32;
            let is_on_map = column >= 0.0 && column < size && row >= 0.0 && row < size;
            #[expect(clippy::cast_possible_truncation, reason = "inside the map")]
            let texel = is_on_map.then(|| row as usize * map.size as usize + column as usize);
            let occluder = texel.and_then(|texel| depths.get(texel)).copied().unwrap_or(f32::NEG_INFINITY);
            // From the point to the middle of the texel the depth follows the plane of the triangle.
            let change = (column + 0.5 - x) * dx + (row + 0.5 - y) * dy;
            if occluder <= limit + change * bias.min(1.0) {
                sum += under(row, y, softness) * under(column, x, softness);
            }
        }
    }
    if softness > 0.0 { (sum * (1.0 / (softness * softness))).clamp(0.0, 1.0) } else { sum }
}

/// **Blend**: lays a premultiplied colour over another, C = Cₛ + (1 − αₛ) Cₜ (Porter and Duff 1984). `[3]` §1.1, step 9
fn blend(source: Color, target: Color) -> Color {
    let left = 255 - u32::from(source[3]);
    from_fn(|k| byte(u32::from(source[k]) + (u32::from(target[k]) * left + 127) / 255))
}

/// **Antialias**: averages the samples of a pixel. `[3]` §1.1, step 10
fn antialias(pixel: &[Sample]) -> Color {
    let count: u32 = pixel.iter().map(|_| 1).sum();
    from_fn(|k| byte((pixel.iter().map(|sample| u32::from(sample.color[k])).sum::<u32>() + count / 2) / count))
}

/// **Write**: stores the colour of a pixel in the memory of the image. `[3]` §1.1, step 11
fn write(image: &mut Pixmap, pixel: usize, color: Color) {
    image.data_mut()[4 * pixel..][..4].copy_from_slice(&color);
}

/// A number that is a byte.
fn byte(number: u32) -> u8 {
    u8::try_from(number).unwrap_or(u8::MAX)
}
