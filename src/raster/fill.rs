//! A band of rows: its triangles → its samples.
//!
//! Eight pixels of a row are worked on together, in loops over arrays that the compiler turns into vector instructions. What
//! a pixel gets depends on its triangles alone, never on the band or the eight that it is in: values are computed from the
//! triangle's origin, not added up along the way.

use std::ops::Range;

use crate::appearance::Rgba;
use crate::drawing::{Paint, Surface};

use super::pixel::{Pixel, over, premultiply};
use super::setup::{Borders, Pixels, Plane, Triangle, samples, snap};
use super::shade::{
    Affine, Flat, LANES, Lanes, PerPixel, Perspective, Shader, Textured, inverse_w, nearly_affine, pick,
};

/// Sides of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) width: i32,
    pub(super) height: i32,
}

/// Some rows of a picture: colour and depth of each sample, in one plane for each place of a sample.
pub(super) struct Band<'a> {
    pub(super) size: Size,
    pub(super) rows: Range<i32>,
    /// Values from one row to the next; beyond `width` there is room for eight more.
    pub(super) pitch: usize,
    /// Values from one plane to the next.
    pub(super) plane: usize,
    pub(super) colors: &'a mut [Pixel],
    /// Empty where nothing writes depths: then no test can fail.
    pub(super) depths: &'a mut [f32],
    /// The slope of the face whose depth was written at the first sample (packed), where someone wants to know.
    pub(super) slopes: Option<&'a mut [u32]>,
    /// Each triangle is painted over those before it, whatever their depths.
    pub(super) in_order: bool,
}

/// Distance of the samples from the centre, in steps.
pub(super) const fn reach<const S: usize>() -> i32 {
    let samples = samples::<S>();
    let (mut k, mut reach) = (0, 0);
    while k < S {
        let (x, y) = (samples[k][0].abs(), samples[k][1].abs());
        let most = if x > y { x } else { y };
        reach = if most > reach { most } else { reach };
        k += 1;
    }
    reach
}

/// Fills some triangles of a surface, in the order of their numbers.
pub(super) fn fill<const S: usize>(band: &mut Band, surface: &Surface, triangles: impl Iterator<Item = u32>) {
    let opaque = |c: Rgba| premultiply(c.with_alpha(255));
    let own = |c: Rgba| if surface.translucent { premultiply(c) } else { opaque(c) };
    match &surface.paint {
        Paint::Solid(color) => {
            let color = own(*color);
            each::<S>(band, surface, triangles, |band, one| one.draw::<S, _>(band, surface, Flat(color)));
        }
        Paint::Faces(colors) => each::<S>(band, surface, triangles, |band, one| {
            let Some(&color) = colors.get(one.index) else { return };
            one.draw::<S, _>(band, surface, Flat(own(color)));
        }),
        Paint::Vertices(colors) => each::<S>(band, surface, triangles, |band, one| {
            let Some(colors) = pick(colors, one.corners) else { return };
            let Some(inverse_w) = inverse_w(surface, one.corners) else { return };
            let colors = colors.map(own);
            match (nearly_affine(colors, inverse_w), surface.translucent) {
                (true, false) => one.draw::<S, _>(band, surface, Affine::<3>::new(&one.triangle, colors)),
                (true, true) => one.draw::<S, _>(band, surface, Affine::<4>::new(&one.triangle, colors)),
                (false, false) => {
                    one.draw::<S, _>(band, surface, Perspective::<3>::new(&one.triangle, colors, inverse_w));
                }
                (false, true) => {
                    one.draw::<S, _>(band, surface, Perspective::<4>::new(&one.triangle, colors, inverse_w));
                }
            }
        }),
        Paint::Phong(phong) => each::<S>(band, surface, triangles, |band, one| {
            let Some(inverse_w) = inverse_w(surface, one.corners) else { return };
            let Some(shader) = PerPixel::new(&one.triangle, phong, one.corners, inverse_w) else { return };
            one.draw::<S, _>(band, surface, shader);
        }),
        Paint::Texture { image, uv, opacity } => each::<S>(band, surface, triangles, |band, one| {
            let Some(inverse_w) = inverse_w(surface, one.corners) else { return };
            let texture = (&**image, uv.as_slice(), *opacity);
            let Some(shader) = Textured::new(&one.triangle, texture, one.corners, inverse_w) else { return };
            one.draw::<S, _>(band, surface, shader);
        }),
    }
}

/// A triangle with its place in the band.
struct One {
    index: usize,
    corners: [usize; 3],
    triangle: Triangle,
    pixels: Pixels,
    z: Plane,
}

/// Calls `draw` for each triangle that has pixels in the band; those whose indices lead nowhere have none.
#[inline(always)]
fn each<const S: usize>(
    band: &mut Band,
    surface: &Surface,
    triangles: impl Iterator<Item = u32>,
    mut draw: impl FnMut(&mut Band, One),
) {
    for index in triangles {
        let index = index as usize;
        let Some(corners) = surface.triangles.get(index).map(|t| t.map(|v| v as usize)) else { continue };
        let Some(p) = pick(&surface.positions, corners) else { continue };
        let (Some(a), Some(b), Some(c)) = (snap(p[0]), snap(p[1]), snap(p[2])) else { continue };
        let v = [a, b, c];
        let mut pixels = Pixels::around(&v, reach::<S>(), band.size.width, band.size.height);
        pixels.rows = pixels.rows.start.max(band.rows.start)..pixels.rows.end.min(band.rows.end);
        if pixels.is_empty() {
            continue;
        }
        let Some(triangle) = Triangle::new(v) else { continue };
        let z = triangle.plane(p.map(|p| p[2]));
        draw(band, One { index, corners, triangle, pixels, z });
    }
}

impl One {
    #[inline(always)]
    fn draw<const S: usize, P: Shader>(&self, band: &mut Band, surface: &Surface, shader: P) {
        let mut painter = Painter::<S, P> {
            origin: self.triangle.origin,
            depth_steps: std::array::from_fn(|s| {
                let [x, y] = samples::<S>()[s].map(in_pixels);
                self.z.dx * x + self.z.dy * y
            }),
            z: self.z,
            row: 0.0,
            slope: pack_slope(self.z.dx, self.z.dy),
            depth_test: surface.depth_test && !band.depths.is_empty(),
            in_order: band.in_order,
            translucent: surface.translucent,
            shader,
        };
        if self.pixels.small {
            small(band, &self.triangle, &self.pixels, &mut painter);
        } else {
            large(band, &self.triangle, &self.pixels, &mut painter);
        }
    }
}

fn in_pixels(steps: i32) -> f32 {
    steps as f32 / super::setup::STEPS as f32
}

/// Fills a triangle whose box is at most eight pixels wide: edge functions in 32 bits, all columns at once.
#[inline(always)]
fn small<const S: usize, P: Shader>(
    band: &mut Band,
    triangle: &Triangle,
    pixels: &Pixels,
    painter: &mut Painter<S, P>,
) {
    let first = pixels.columns.start;
    // Within the box of a small triangle the edge functions, in units of 256 steps², stay far below 2³¹.
    #[expect(clippy::cast_possible_truncation, reason = "see above")]
    let starts: [[i32; 3]; S] = samples::<S>()
        .map(|sample| std::array::from_fn(|k| triangle.edge(k, [first, pixels.rows.start], sample) as i32));
    let columns: [Lanes<i32>; 3] = triangle.a.map(|a| lanes(|l| a * l));
    let last = pixels.columns.end - first;
    let inside: Lanes<i32> = lanes(|l| l - last);
    for j in pixels.rows.clone() {
        let down = j - pixels.rows.start;
        let covered: [Lanes<bool>; S] = std::array::from_fn(|s| {
            let e: [i32; 3] = std::array::from_fn(|k| starts[s][k] + triangle.b[k] * down);
            // The sign of each: not negative inside; and negative in the columns of the box.
            std::array::from_fn(|l| {
                ((e[0] + columns[0][l]) | (e[1] + columns[1][l]) | (e[2] + columns[2][l]) | !inside[l]) >= 0
            })
        });
        painter.start_row(j);
        painter.paint(band, j, first, covered);
    }
}

/// Fills any triangle: row by row between its borders.
#[inline(always)]
fn large<const S: usize, P: Shader>(
    band: &mut Band,
    triangle: &Triangle,
    pixels: &Pixels,
    painter: &mut Painter<S, P>,
) {
    let borders: [Borders; S] = samples::<S>().map(|sample| triangle.borders(sample));
    for j in pixels.rows.clone() {
        let rows: [(i32, i32); S] = std::array::from_fn(|s| borders[s].row(j, band.size.width));
        // The rows of the box may be too many by one for some samples: there a border must not be followed beyond its edge.
        let rows: [(i32, i32); S] =
            std::array::from_fn(|s| if triangle.has_row(j, samples::<S>()[s]) { rows[s] } else { (0, 0) });
        let first = rows.iter().filter(|r| r.0 < r.1).map(|r| r.0).min().unwrap_or(0);
        let end = rows.iter().map(|r| r.1).max().unwrap_or(0);
        if first >= end {
            continue;
        }
        painter.start_row(j);
        let mut i = first;
        while i < end {
            let covered = rows.map(|(first, end)| {
                let (from, to) = (first - i, end - i);
                lanes(|l| l >= from && l < to)
            });
            painter.paint(band, j, i, covered);
            i += 8;
        }
    }
}

/// Lane numbers → lanes.
#[inline(always)]
fn lanes<T>(f: impl Fn(i32) -> T) -> Lanes<T> {
    [f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)]
}

/// What is the same for all pixels of a triangle.
struct Painter<const S: usize, P> {
    origin: [f32; 2],
    z: Plane,
    /// From the depth at the centre to that at each sample.
    depth_steps: [f32; S],
    /// Depth in the row at hand, below the origin.
    row: f32,
    slope: u32,
    depth_test: bool,
    in_order: bool,
    translucent: bool,
    shader: P,
}

impl<const S: usize, P: Shader> Painter<S, P> {
    #[inline(always)]
    fn start_row(&mut self, j: i32) {
        let y = (j as f32 + 0.5) - self.origin[1];
        self.row = self.z.row(y);
        self.shader.row(y);
    }

    /// Paints eight pixels of row `j` from column `i` on, where they are covered.
    #[inline(always)]
    fn paint(&self, band: &mut Band, j: i32, i: i32, mut covered: [Lanes<bool>; S]) {
        let x: Lanes<f32> = lanes(|l| (i + l) as f32 + 0.5 - self.origin[0]);
        let start = (j - band.rows.start).unsigned_abs() as usize * band.pitch + i.unsigned_abs() as usize;
        if self.depth_test {
            let center = x.map(|x| self.row + self.z.dx * x);
            for s in 0..S {
                let Some(depths) = eight(band.depths, s * band.plane + start) else { return };
                for l in 0..LANES {
                    let z = self.z.hold(center[l] + self.depth_steps[s]);
                    let pass = covered[s][l] & ((z > depths[l]) | self.in_order);
                    covered[s][l] = pass;
                    if !self.translucent {
                        depths[l] = if pass { z } else { depths[l] };
                    }
                }
                if s == 0
                    && !self.translucent
                    && let Some(slopes) = band.slopes.as_deref_mut().and_then(|slopes| eight(slopes, start))
                {
                    for l in 0..LANES {
                        slopes[l] = if covered[0][l] { self.slope } else { slopes[l] };
                    }
                }
            }
        }
        let wanted = std::array::from_fn(|l| (0..S).any(|s| covered[s][l]));
        let colors = self.shader.colors(x, wanted);
        for (s, covered) in covered.iter().enumerate() {
            let Some(pixels) = eight(band.colors, s * band.plane + start) else { return };
            for l in 0..LANES {
                let color = if self.translucent { over(colors[l], pixels[l]) } else { colors[l] };
                pixels[l] = if covered[l] { color } else { pixels[l] };
            }
        }
    }
}

#[inline(always)]
fn eight<T>(values: &mut [T], start: usize) -> Option<&mut Lanes<T>> {
    values.get_mut(start..)?.first_chunk_mut()
}

/// Two slopes as the upper halves of two `f32`: 8 bits of each are enough.
fn pack_slope(dx: f32, dy: f32) -> u32 {
    (dx.to_bits() & 0xffff_0000) | dy.to_bits() >> 16
}

/// The slopes that [`pack_slope`] packed, towards 0 by 1/128 at most.
pub(super) fn unpack_slope(packed: u32) -> [f32; 2] {
    [f32::from_bits(packed & 0xffff_0000), f32::from_bits(packed << 16)]
}
