//! A band of rows: its triangles → its samples.
//!
//! The standard algorithm decides for each pixel: covered, nearer, which colour, blended or not. Here the unit is a
//! tile of eight pixels, eight of a row or two rows of four, and each step is one instruction for all of them, with a
//! mask of the pixels for which it counts. Edge functions grow by a constant from tile to tile. No colour is computed
//! if the mask is empty after the depth test. A pixel depends on its triangles alone, never on the band, the tile or
//! the machine's vectors: values are computed from the triangle's origin, not added up along the way, and no operation
//! is fused with another.
//!
//! ## Which path takes which surface
//!
//! | surface | colours | small | any other |
//! | --- | --- | --- | --- |
//! | one colour for a face, light in it | [`FlatColors`] | ≤ 32 × 128 pixels: [`Painter::small`] | [`Painter::wide`] |
//! | opaque colours of vertices, light in them | [`GouraudColors`] | if simple | and if not simple |
//! | textures, light apart, translucent vertices | [`PerPixel`] | if simple | and if not simple |
//!
//! *Simple* means that single precision is enough and perspective can be ignored ([`Colors::simple`]): no sliver with
//! colours that vary, no colours of vertices that perspective bends. Sixteen samples are painted as four times four.
//!
//! Tiny triangles, of a few pixels, could be filled eight at a time, each in a lane of its own, and in square tiles.
//! That pays only from some 100,000 triangles in a picture on, and not at all for 10,000.
//!
//! ## Which copies exist
//!
//! Each copy of a kernel costs compile time, so it has to pay. On x86 the library has for AVX2 and for SSE 4.2:
//!
//! | parameter | values | why |
//! | --- | --- | --- |
//! | vectors | AVX2, SSE 4.2 | plain numbers took 12 times as long to compile as SSE 4.2; such machines paint as the textbook does |
//! | samples `S` | 1, 4 | the loop over samples vanishes with one; sixteen use four |
//! | colours `C` | flat, Gouraud, per pixel | flat and Gouraud stay in registers; per pixel calls one function for each tile |
//!
//! These are twelve copies of [`all`], each a function of its own, called once for a surface in a band. In it
//! everything is inlined, since vectors pass through memory from one function to another: without that, frames take 20
//! times as long. Unoptimised builds keep the longest functions apart, because one function would ask for megabytes of
//! stack.

use std::ops::Range;

use crate::drawing::{Base, Surface, SurfaceLight};
use crate::simd::prelude::*;

use super::band::{Band, Kind, load, store};
use super::batch::{BATCH, Batch, corners, corners_at, gather_points};
use super::per_pixel::PerPixel;
use super::setup::{AffineValue, Borders, ROWS, any, stored};
use super::shade::{Colors, FlatColors, GouraudColors, Shader};
use crate::raster::depth::pack_slope;
use crate::raster::grid::in_pixels;
use crate::raster::pixel::{LANES, over};

/// Fills some triangles of a surface, in the order of the list.
#[inline(always)]
pub(super) fn fill<K: Simd, const S: usize>(simd: K, band: &mut Band, surface: &Surface, triangles: &[u32]) {
    match (&surface.base, &surface.light) {
        (Base::Solid(_) | Base::Faces(_), SurfaceLight::InBase) => {
            all::<K, S, FlatColors<K>>(simd, band, surface, triangles);
        }
        (Base::Vertices(_), SurfaceLight::InBase) if !surface.translucent => {
            all::<K, S, GouraudColors<K>>(simd, band, surface, triangles);
        }
        (Base::Vertices(_) | Base::Texture { .. }, SurfaceLight::InBase)
        | (_, SurfaceLight::Faces(_) | SurfaceLight::Vertices(_) | SurfaceLight::PerPixel(_)) => {
            all::<K, S, PerPixel<K>>(simd, band, surface, triangles);
        }
    }
    if let Some(counts) = &mut band.counts {
        counts.sum();
    }
}

/// Fills triangles in batches of eight, of which the small ones are set up together.
#[inline(never)]
fn all<'a, K: Simd, const S: usize, C: Colors<'a, K>>(
    simd: K,
    band: &mut Band,
    surface: &'a Surface,
    triangles: &[u32],
) {
    simd.vectorize(
        #[inline(always)]
        || {
            for triangles in triangles.chunks(BATCH) {
                eight::<K, S, C>(simd, band, surface, triangles);
            }
        },
    );
}

/// Fills the eight triangles of a batch.
#[inline(always)]
fn eight<'a, K: Simd, const S: usize, C: Colors<'a, K>>(
    simd: K,
    band: &mut Band,
    surface: &'a Surface,
    triangles: &[u32],
) {
    let corners = corners(surface, triangles);
    let [x, y, z] = gather_points(simd, &surface.positions, &corners);
    let batch = Batch::new(simd, &x, &y, S > 1, band.size);
    // All eight are set up, although some will go alone: a branch for each would cost more than the arithmetic.
    let set_up = batch.set_up(band.rows.start);
    let colors = C::new(simd, surface, triangles, &corners, &set_up, S > 1);
    let depths = set_up.planes(&z);
    let small = batch.small & set_up.has_area & colors.simple();
    for l in 0..triangles.len() {
        let rows = batch.rows(l, &band.rows);
        if rows.start >= rows.end {
            continue;
        }
        if small[l] != 0 {
            // Its edge functions fit in 32 bits, so it's scanned tile by tile over its box.
            let columns = batch.left[l]..batch.right[l];
            let origin = [set_up.origin[0][l], set_up.origin[1][l]];
            let z = depths.of(l);
            let painter =
                TrianglePainter::<K, S, C::Simple>::new(simd, origin, z, triangles[l], band, surface, colors.of(l));
            painter.small(band, columns, rows, &set_up.edges_of(l));
        } else {
            // It's large, a sliver, or has colours that perspective bends. Painted on its own, in 64 bits, row by row.
            let corners = corners_at(&corners, l);
            let Some(triangle) = batch.alone(l, &surface.positions, corners) else { continue };
            let borders = Borders::new(simd, &triangle.v, band.samples, band.size.width);
            // Most slivers own no pixel.
            if borders.are_empty(rows.clone(), ROWS / S) {
                continue;
            }
            if let Some(shader) = C::alone(simd, surface, &triangle, triangles[l], corners) {
                let z = triangle.plane([z[0][l], z[1][l], z[2][l]]);
                let painter = TrianglePainter::<K, S, C::Shader>::new(
                    simd,
                    triangle.origin,
                    z,
                    triangles[l],
                    band,
                    surface,
                    shader,
                );
                painter.wide(band, rows, &borders);
            }
        }
    }
}

/// Columns of a tile.
const WIDTH: i32 = 8;

/// Eight pixels of a row that are worked on together.
#[derive(Clone, Copy)]
struct Tile<K: Simd> {
    columns: i32x8<K>,
}

impl<K: Simd> Tile<K> {
    #[inline(always)]
    fn new(simd: K) -> Self {
        Self { columns: i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]) }
    }

    /// Distance of the centres to the right of the origin, when the tile begins at column `i`. Exact: multiples of
    /// 1/256 below 2¹⁵.
    #[inline(always)]
    fn x(&self, i: i32, origin: [f32; 2]) -> f32x8<K> {
        self.columns.to_float::<f32x8<K>>() + ((i as f32 + 0.5) - origin[0])
    }

    /// Distance of the centres below the origin, in row `j`.
    #[inline(always)]
    fn y(&self, j: i32, origin: [f32; 2]) -> f32x8<K> {
        f32x8::splat(self.columns.witness(), (j as f32 + 0.5) - origin[1])
    }
}

/// State shared by all pixels of a triangle.
struct TrianglePainter<K: Simd, const S: usize, P> {
    simd: K,
    origin: [f32; 2],
    z: AffineValue,
    /// Its place in the list of all.
    place: u32,
    /// The change from the depth at the centre to that at each sample.
    depth_steps: [f32; S],
    depth_test: bool,
    in_order: bool,
    greatest: f32,
    translucent: bool,
    shader: P,
}

impl<K: Simd, const S: usize, P: Shader<K>> TrianglePainter<K, S, P> {
    #[inline(always)]
    fn new(simd: K, origin: [f32; 2], z: AffineValue, number: u32, band: &Band, surface: &Surface, shader: P) -> Self {
        // Depth is affine, so a sample's differs from the centre's by the same everywhere.
        let mut depth_steps = [0.0; S];
        for (step, sample) in depth_steps.iter_mut().zip(band.samples) {
            *step = z.dx * in_pixels(sample[0]) + z.dy * in_pixels(sample[1]);
        }
        let depth_test = surface.depth_test && !band.depths.is_empty();
        let (in_order, greatest, translucent) = (band.in_order, band.greatest, surface.translucent);
        let place = band.first_place.wrapping_add(number);
        Self { simd, origin, z, place, depth_steps, depth_test, in_order, greatest, translucent, shader }
    }

    /// Fills a triangle by its edge functions, each given by its change to the right, its change down, and its value at
    /// the centre of the first pixel.
    #[inline(always)]
    fn small(mut self, band: &mut Band, columns: Range<i32>, rows: Range<i32>, functions: &[[i32; 3]; 3]) {
        let tile = Tile::<K>::new(self.simd);
        // The functions in whole pixels (as in `Borders`) on the tile, and by how much they are greater at other
        // samples.
        let mut first_edges = [i32x8::splat(self.simd, 0); 3];
        let mut more = [[0; 3]; S];
        for k in 0..3 {
            let [a, b, start] = functions[k];
            let first = (start + a * band.samples[0][0] + b * band.samples[0][1]) >> 8;
            first_edges[k] = tile.columns * a + first;
            for (more, sample) in more.iter_mut().zip(band.samples) {
                more[k] = ((start + a * sample[0] + b * sample[1]) >> 8) - first;
            }
        }
        let mut i = columns.start;
        // From the left to the right: eight columns, from above to below.
        while i < columns.end {
            let mut edges = first_edges;
            self.shader.columns(tile.x(i, self.origin));
            let across = tile.x(i, self.origin) * self.z.dx;
            let mut y = tile.y(rows.start, self.origin);
            let mut place = band.place(rows.start, i);
            let mut own = mask32x8::splat(self.simd, -1);
            let mut j = rows.start;
            while j < rows.end {
                let mut covered = [mask32x8::splat(self.simd, 0); S];
                for s in 0..S {
                    // Not negative inside, for all three: then their common sign bit isn't set.
                    let outside = if s == 0 {
                        edges[0] | edges[1] | edges[2]
                    } else {
                        (edges[0] + more[s][0]) | (edges[1] + more[s][1]) | (edges[2] + more[s][2])
                    };
                    covered[s] = outside.simd_gt(-1);
                }
                if any(&covered) {
                    self.shader.rows(y);
                    let center = across + (y * self.z.dy + self.z.value);
                    if band.counts.is_some() {
                        // Pixels beyond belong to none.
                        own = tile.columns.simd_lt(band.size.width - i);
                    }
                    self.paint(place, band, center, &mut covered, own);
                }
                for (edge, function) in edges.iter_mut().zip(functions) {
                    *edge += function[1];
                }
                y += 1.0;
                place = place.wrapping_add(band.pitch);
                j += 1;
            }
            for (edge, function) in first_edges.iter_mut().zip(functions) {
                *edge += function[0] * WIDTH;
            }
            i += WIDTH;
        }
    }

    /// Fills any triangle, row by row between its borders.
    #[inline(always)]
    fn wide(mut self, band: &mut Band, rows: Range<i32>, borders: &Borders<K>) {
        // Most tiles of a large triangle's box would be empty, so its borders say where each row begins and ends. With
        // one sample per pixel, four rows are bounded together.
        for four in rows.clone().step_by(ROWS / S) {
            let (from, to) = borders.rows(four);
            if S > 1 {
                self.row::<ROWS>(band, four, &from, &to);
            } else {
                for (j, (&from, &to)) in (four..rows.end).zip(from.iter().zip(&to)) {
                    self.row(band, j, &[from], &[to]);
                }
            }
        }
    }

    /// Fills a row, for each sample between two columns.
    #[inline(always)]
    fn row<const N: usize>(&mut self, band: &mut Band, j: i32, from: &[i32; N], to: &[i32; N]) {
        let (mut first, mut last) = (i32::MAX, 0);
        for (&from, &to) in from.iter().zip(to).filter(|(from, to)| from < to) {
            (first, last) = (first.min(from), last.max(to));
        }
        if first >= last {
            return;
        }
        let tile = Tile::<K>::new(self.simd);
        let y = tile.y(j, self.origin);
        self.shader.rows(y);
        let down = y * self.z.dy + self.z.value;
        let mut place = band.place(j, first);
        let mut columns = tile.columns + first;
        let mut x = tile.x(first, self.origin);
        let end = place.wrapping_add((last - first) as u32);
        while place < end {
            let mut covered = [mask32x8::splat(self.simd, -1); S];
            for (covered, (&from, &to)) in covered.iter_mut().zip(from.iter().zip(to)) {
                *covered = columns.simd_lt(to);
                if S > 1 {
                    *covered &= columns.simd_ge(from);
                }
            }
            self.shader.columns(x);
            self.paint(place, band, x * self.z.dx + down, &mut covered, mask32x8::splat(self.simd, -1));
            columns += WIDTH;
            x += LANES as f32;
            place = place.wrapping_add(WIDTH.cast_unsigned());
        }
    }

    /// Paints the covered part of a tile. `center` has its depths at the centres of pixels, and `own` the pixels that
    /// are counted.
    #[inline(always)]
    fn paint(&self, place: u32, band: &mut Band, center: f32x8<K>, covered: &mut [mask32x8<K>; S], own: mask32x8<K>) {
        if let Some(counts) = &mut band.counts {
            for covered in &*covered {
                counts.add(self.simd, Kind::Covered, *covered & own);
            }
        }
        // Depth comes before colour, sample by sample. A sample that fails is no longer covered.
        if self.depth_test {
            for (s, (covered, &step)) in (0..).zip(covered.iter_mut().zip(&self.depth_steps)) {
                let z = if S == 1 { center } else { center + step };
                let z = stored(z.max(self.z.low).min(self.z.high), self.greatest);
                let place = place.wrapping_add(s * band.plane);
                let Some(old) = load::<K, f32x8<K>>(self.simd, band.depths, place) else { return };
                if !self.in_order {
                    let mut is_visible = z.simd_gt(old);
                    if !self.translucent
                        && let Some(places) = load::<K, u32x8<K>>(self.simd, band.places, place)
                    {
                        // Of equal depths, the first in the list.
                        is_visible |= z.simd_ge(old) & places.simd_gt(self.place);
                        let own = u32x8::splat(self.simd, self.place);
                        store((*covered & is_visible).select(own, places), band.places, place);
                    }
                    *covered &= is_visible;
                }
                if !self.translucent {
                    store(covered.select(z, old), band.depths, place);
                }
            }
            if !self.translucent
                && let Some(old) = load::<K, u32x8<K>>(self.simd, band.slopes, place)
            {
                let slope = u32x8::splat(self.simd, pack_slope(self.z.dx, self.z.dy));
                store(covered[0].select(slope, old), band.slopes, place);
            }
        }
        if let Some(counts) = &mut band.counts {
            for covered in &*covered {
                counts.add(self.simd, Kind::Written, *covered & own);
            }
        }
        if !any(covered) {
            return;
        }
        // One colour for all samples of a pixel (only coverage and depth are sampled), and none if nothing is left to
        // paint, because light and textures cost more than all tests before.
        let mut wanted = covered[0];
        for covered in &covered[1..] {
            wanted |= *covered;
        }
        let colors = self.shader.colors(wanted);
        for (s, covered) in (0..).zip(&*covered) {
            let place = place.wrapping_add(s * band.plane);
            let Some(old) = load::<K, u32x8<K>>(self.simd, band.colors, place) else { return };
            let colors = if self.translucent { over(colors, old) } else { colors };
            store(covered.select(colors, old), band.colors, place);
        }
    }
}
