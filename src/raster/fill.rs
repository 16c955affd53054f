//! A band of rows: its triangles → its samples.
//!
//! Eight pixels of a row are worked on together. What a pixel gets depends on its triangles alone, never on the band or the
//! eight that it is in, nor on the machine's vectors: values are computed from the triangle's origin, not added up along the
//! way, and no operation is fused with another.
//!
//! All of it must become one function for each set of vector instructions, hence the many `#[inline(always)]`.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x4, f32x8, i32x8, mask32x8, u32x4, u32x8};

use crate::drawing::{Paint, Surface};

use super::batch::{BATCH, Batch, Corners, corners, gather};
use super::pixel::{self, Pixel};
use super::setup::{Borders, Plane, STEPS};
use super::shade::{Colors, FlatColors, GouraudColors, LANES, Shader, Slow};

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
    /// Places of the samples relative to the centre, in steps: as many as `fill` is told.
    pub(super) samples: &'a [[i32; 2]],
    /// Values from one row to the next; beyond `width` there is room for eight more.
    pub(super) pitch: usize,
    /// Values from one plane to the next.
    pub(super) plane: usize,
    pub(super) colors: &'a mut [Pixel],
    /// Empty where nothing writes depths: then no test can fail.
    pub(super) depths: &'a mut [f32],
    /// The slope of the face whose depth was written at the first sample (packed); empty where nobody wants to know.
    pub(super) slopes: &'a mut [u32],
    /// Each triangle is painted over those before it, whatever their depths.
    pub(super) in_order: bool,
    /// If anybody wants to know.
    pub(super) counts: Option<&'a mut Counts>,
}

/// What was done to samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Those inside of triangles.
    pub(super) covered: u64,
    /// Those of them that nothing nearer hid.
    pub(super) written: u64,
    /// The same, by pixel of a tile; since the last [`sum`](Self::sum).
    lanes: [[i32; LANES]; 2],
}

impl Counts {
    #[inline(always)]
    fn add<K: Simd>(simd: K, lanes: &mut [i32; LANES], mask: mask32x8<K>) {
        let one = i32x8::splat(simd, 1);
        (i32x8::from_slice(simd, lanes) + mask.select(one, one - 1)).store_slice(lanes);
    }

    /// To be called before the lanes run over: after at most 2³¹ tiles.
    fn sum(&mut self) {
        let [covered, written] =
            std::mem::take(&mut self.lanes).map(|lanes| lanes.iter().map(|&n| n as u64).sum::<u64>());
        self.covered += covered;
        self.written += written;
    }
}

/// Fills some triangles of a surface, in the order of the list.
#[inline(always)]
pub(super) fn fill<K: Simd, const S: usize>(simd: K, band: &mut Band, surface: &Surface, triangles: &[u32]) {
    for triangles in triangles.chunks(BATCH) {
        let corners = corners(surface, triangles);
        let [x, y, z] = gather(simd, &surface.positions, &corners);
        let batch = Batch::new(simd, &x, &y, S > 1, band.size);
        match &surface.paint {
            Paint::Solid(_) | Paint::Faces(_) => {
                eight::<K, S, FlatColors<K>>(simd, band, surface, triangles, &corners, &batch, &z);
            }
            Paint::Vertices(_) if !surface.translucent => {
                eight::<K, S, GouraudColors<K>>(simd, band, surface, triangles, &corners, &batch, &z);
            }
            _ => {
                for l in 0..triangles.len() {
                    let corners = [corners[0][l], corners[1][l], corners[2][l]];
                    if let Some(triangle) = batch.alone(l, &surface.positions, corners)
                        && let Some(shader) = Slow::new(simd, surface, &triangle, corners)
                    {
                        let z = triangle.plane([z[0][l], z[1][l], z[2][l]]);
                        let painter = Painter::<K, S, _>::new(simd, triangle.origin, z, band, surface, shader);
                        painter.wide(band, batch.rows(l, &band.rows), &triangle.v);
                    }
                }
            }
        }
    }
    if let Some(counts) = &mut band.counts {
        counts.sum();
    }
}

/// Fills the eight triangles of a batch: the small ones are set up together.
#[inline(always)]
fn eight<'a, K: Simd, const S: usize, C: Colors<'a, K>>(
    simd: K,
    band: &mut Band,
    surface: &'a Surface,
    triangles: &[u32],
    corners: &Corners,
    batch: &Batch<K>,
    z: &[f32x8<K>; 3],
) {
    let set_up = batch.set_up(band.rows.start);
    let colors = C::new(simd, surface, triangles, corners, &set_up, S > 1);
    let depths = set_up.planes(z);
    let narrow = batch.narrow & set_up.has_area & colors.simple();
    // What the one pixel gets that a tiny triangle can own.
    let tiny = if S == 1 { batch.one & narrow } else { mask32x8::splat(simd, 0) };
    let (mut first_depth, mut first_color) = ([0.0; BATCH], [0; BATCH]);
    if tiny.any_true() {
        let [x, y] = set_up.first();
        depths.hold(depths.at(x, y)).store_slice(&mut first_depth);
        colors.at(x, y).store_slice(&mut first_color);
    }
    for l in 0..triangles.len() {
        let rows = batch.rows(l, &band.rows);
        if rows.start >= rows.end {
            continue;
        }
        if tiny[l] != 0 {
            band.set(surface, [batch.left[l], rows.start], first_depth[l], &depths.of(l), first_color[l]);
        } else if narrow[l] != 0 {
            let columns = batch.left[l]..batch.right[l];
            let origin = [set_up.origin[0][l], set_up.origin[1][l]];
            let painter = Painter::<K, S, C::Simple>::new(simd, origin, depths.of(l), band, surface, colors.of(l));
            painter.narrow(band, columns, rows, &set_up.edges_of(l));
        } else {
            let corners = [corners[0][l], corners[1][l], corners[2][l]];
            if let Some(triangle) = batch.alone(l, &surface.positions, corners)
                && let Some(shader) = C::alone(simd, surface, &triangle, triangles[l], corners)
            {
                let z = triangle.plane([z[0][l], z[1][l], z[2][l]]);
                let painter = Painter::<K, S, C::Shader>::new(simd, triangle.origin, z, band, surface, shader);
                painter.wide(band, rows, &triangle.v);
            }
        }
    }
}

impl Band<'_> {
    /// Sets the one pixel of a tiny triangle.
    #[inline(always)]
    fn set(&mut self, surface: &Surface, [column, row]: [i32; 2], depth: f32, plane: &Plane, color: Pixel) {
        let start = (row - self.rows.start) as usize * self.pitch + column as usize;
        let Some(pixel) = self.colors.get_mut(start) else { return };
        if let Some(counts) = &mut self.counts {
            counts.covered += 1;
        }
        if surface.depth_test
            && let Some(old) = self.depths.get_mut(start)
        {
            // Not `<=`: a depth that is no number hides behind everything, as it does in `Painter`.
            if !(depth > *old || self.in_order) {
                return;
            }
            if !surface.translucent {
                *old = depth;
                if let Some(slope) = self.slopes.get_mut(start) {
                    *slope = pack_slope(plane.dx, plane.dy);
                }
            }
        }
        if let Some(counts) = &mut self.counts {
            counts.written += 1;
        }
        *pixel = if surface.translucent { pixel::over(color, *pixel) } else { color };
    }
}

fn in_pixels(steps: i32) -> f32 {
    steps as f32 / STEPS as f32
}

/// Eight pixels that are worked on together: eight of a row, or four of a row and the four below.
#[derive(Clone, Copy)]
struct Tile<K: Simd> {
    columns: i32x8<K>,
    rows: i32x8<K>,
    /// From the first four values to the others.
    second: usize,
    /// Rows from one tile to the next.
    height: i32,
}

impl<K: Simd> Tile<K> {
    #[inline(always)]
    fn level(simd: K) -> Self {
        let columns = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
        Self { columns, rows: i32x8::splat(simd, 0), second: 4, height: 1 }
    }

    #[inline(always)]
    fn square(simd: K, pitch: usize) -> Self {
        let columns = i32x8::from_slice(simd, &[0, 1, 2, 3, 0, 1, 2, 3]);
        let rows = i32x8::from_slice(simd, &[0, 0, 0, 0, 1, 1, 1, 1]);
        Self { columns, rows, second: pitch, height: 2 }
    }

    /// How far the centres are right of the origin, when the tile begins at column `i`. Exact: multiples of 1/256 below 2¹⁵.
    #[inline(always)]
    fn x(&self, i: i32, origin: [f32; 2]) -> f32x8<K> {
        self.columns.to_float::<f32x8<K>>() + ((i as f32 + 0.5) - origin[0])
    }

    /// How far they are below it, when the tile begins at row `j`.
    #[inline(always)]
    fn y(&self, j: i32, origin: [f32; 2]) -> f32x8<K> {
        self.rows.to_float::<f32x8<K>>() + ((j as f32 + 0.5) - origin[1])
    }

    /// The values of the tile at `start`, to be read and written.
    #[inline(always)]
    fn of<'a, T>(&self, values: &'a mut [T], start: usize) -> Option<&'a mut [T]> {
        values.get_mut(start..start + self.second + 4)
    }
}

/// What is the same for all pixels of a triangle.
struct Painter<K: Simd, const S: usize, P> {
    simd: K,
    origin: [f32; 2],
    z: Plane,
    /// From the depth at the centre to that at each sample.
    depth_steps: [f32; S],
    depth_test: bool,
    in_order: bool,
    translucent: bool,
    shader: P,
}

impl<K: Simd, const S: usize, P: Shader<K>> Painter<K, S, P> {
    #[inline(always)]
    fn new(simd: K, origin: [f32; 2], z: Plane, band: &Band, surface: &Surface, shader: P) -> Self {
        let mut depth_steps = [0.0; S];
        for (step, sample) in depth_steps.iter_mut().zip(band.samples) {
            *step = z.dx * in_pixels(sample[0]) + z.dy * in_pixels(sample[1]);
        }
        let depth_test = surface.depth_test && !band.depths.is_empty();
        let (in_order, translucent) = (band.in_order, surface.translucent);
        Self { simd, origin, z, depth_steps, depth_test, in_order, translucent, shader }
    }

    /// Fills a triangle of eight columns at most, by its edge functions: for each its change to the right, its change down,
    /// and its value at the centre of the first pixel.
    #[inline(always)]
    fn narrow(mut self, band: &mut Band, columns: Range<i32>, rows: Range<i32>, functions: &[[i32; 3]; 3]) {
        let tile =
            if columns.end - columns.start <= 4 { Tile::square(self.simd, band.pitch) } else { Tile::level(self.simd) };
        // The functions in whole pixels (as in `Borders`) on the tile, and by how much they are greater at other samples.
        let mut edges = [i32x8::splat(self.simd, 0); 3];
        let mut more = [[0; 3]; S];
        for k in 0..3 {
            let [a, b, start] = functions[k];
            let first = (start + a * band.samples[0][0] + b * band.samples[0][1]) >> 8;
            edges[k] = tile.columns * a + tile.rows * b + first;
            for (more, sample) in more.iter_mut().zip(band.samples) {
                more[k] = ((start + a * sample[0] + b * sample[1]) >> 8) - first;
            }
        }
        let down = [functions[0][1] * tile.height, functions[1][1] * tile.height, functions[2][1] * tile.height];
        let x = tile.x(columns.start, self.origin);
        let mut y = tile.y(rows.start, self.origin);
        self.shader.columns(x);
        let across = x * self.z.dx;
        let mut start = (rows.start - band.rows.start) as usize * band.pitch + columns.start as usize;
        let mut own = mask32x8::splat(self.simd, -1);
        let mut j = rows.start;
        while j < rows.end {
            let mut covered = [mask32x8::splat(self.simd, 0); S];
            for s in 0..S {
                // Not negative inside, for all three: then their common sign bit is not set.
                let outside = if s == 0 {
                    edges[0] | edges[1] | edges[2]
                } else {
                    (edges[0] + more[s][0]) | (edges[1] + more[s][1]) | (edges[2] + more[s][2])
                };
                covered[s] = outside.simd_gt(-1);
            }
            self.shader.rows(y);
            let center = across + (y * self.z.dy + self.z.value);
            if band.counts.is_some() {
                // What lies beyond belongs to the next band, or to nobody.
                own = tile.rows.simd_lt(rows.end - j) & tile.columns.simd_lt(band.size.width - columns.start);
            }
            self.paint(&tile, band, start, center, &mut covered, own);
            for k in 0..3 {
                edges[k] += down[k];
            }
            y += tile.height as f32;
            start += tile.height as usize * band.pitch;
            j += tile.height;
        }
    }

    /// Fills any triangle, row by row between its borders.
    #[inline(always)]
    fn wide(mut self, band: &mut Band, rows: Range<i32>, vertices: &[[i32; 2]; 3]) {
        let tile = Tile::level(self.simd);
        let all = mask32x8::splat(self.simd, -1);
        let mut borders = [Borders::default(); S];
        for (borders, &sample) in borders.iter_mut().zip(band.samples) {
            *borders = Borders::new(vertices, sample);
        }
        for j in rows {
            let mut ends = [(0, 0); S];
            let (mut first, mut last) = (i32::MAX, 0);
            for s in 0..S {
                ends[s] = borders[s].row(j, band.size.width);
                if ends[s].0 < ends[s].1 {
                    (first, last) = (first.min(ends[s].0), last.max(ends[s].1));
                }
            }
            if first >= last {
                continue;
            }
            let y = tile.y(j, self.origin);
            self.shader.rows(y);
            let down = y * self.z.dy + self.z.value;
            let mut start = (j - band.rows.start) as usize * band.pitch + first as usize;
            let mut i = first;
            while i < last {
                let mut covered = [mask32x8::splat(self.simd, 0); S];
                for (covered, &(from, to)) in covered.iter_mut().zip(&ends) {
                    *covered = tile.columns.simd_lt(to - i);
                    if S > 1 {
                        *covered &= tile.columns.simd_gt(from - i - 1);
                    }
                }
                let x = tile.x(i, self.origin);
                self.shader.columns(x);
                self.paint(&tile, band, start, x * self.z.dx + down, &mut covered, all);
                i += 8;
                start += 8;
            }
        }
    }

    /// Paints a tile where it is covered. `center`: its depths at the centres of pixels; `own`: the pixels that are counted.
    #[inline(always)]
    fn paint(
        &self,
        tile: &Tile<K>,
        band: &mut Band,
        start: usize,
        center: f32x8<K>,
        covered: &mut [mask32x8<K>; S],
        own: mask32x8<K>,
    ) {
        if let Some(counts) = &mut band.counts {
            for covered in &*covered {
                Counts::add(self.simd, &mut counts.lanes[0], *covered & own);
            }
        }
        if self.depth_test {
            for (s, covered) in covered.iter_mut().enumerate() {
                let Some(depths) = tile.of(band.depths, s * band.plane + start) else { return };
                let z = if S == 1 { center } else { center + self.depth_steps[s] };
                let z = z.max(self.z.low).min(self.z.high);
                let Some(old) = load::<K, f32x4<K>>(self.simd, depths) else { return };
                if !self.in_order {
                    *covered &= z.simd_gt(old);
                }
                if !self.translucent {
                    store(covered.select(z, old), depths);
                }
            }
            if !self.translucent
                && let Some(slopes) = tile.of(band.slopes, start)
                && let Some(old) = load::<K, u32x4<K>>(self.simd, slopes)
            {
                let slope = u32x8::splat(self.simd, pack_slope(self.z.dx, self.z.dy));
                store(covered[0].select(slope, old), slopes);
            }
        }
        if let Some(counts) = &mut band.counts {
            for covered in &*covered {
                Counts::add(self.simd, &mut counts.lanes[1], *covered & own);
            }
        }
        let mut wanted = covered[0];
        for covered in &covered[1..] {
            wanted |= *covered;
        }
        if !wanted.any_true() {
            return;
        }
        let colors = self.shader.colors(wanted);
        for (s, covered) in covered.iter().enumerate() {
            let Some(pixels) = tile.of(band.colors, s * band.plane + start) else { return };
            let Some(old) = load::<K, u32x4<K>>(self.simd, pixels) else { return };
            let colors = if self.translucent { over(colors, old) } else { colors };
            store(covered.select(colors, old), pixels);
        }
    }
}

/// The first four and the last four values of a tile.
#[inline(always)]
fn load<K: Simd, T: SimdBase<K> + SimdCombine<K>>(simd: K, tile: &[T::Element]) -> Option<T::Combined>
where
    T::Element: Copy,
{
    let (first, last) = (tile.get(..4)?, tile.get(tile.len() - 4..)?);
    Some(T::from_slice(simd, first).combine(T::from_slice(simd, last)))
}

/// Writes the first four and the last four values of a tile.
#[inline(always)]
fn store<K: Simd, T: SimdSplit<K>>(values: T, tile: &mut [T::Element])
where
    T::Split: SimdBase<K, Element = T::Element>,
{
    let (first, last) = values.split();
    let end = tile.len();
    if let Some(values) = tile.get_mut(..4) {
        first.store_slice(values);
    }
    if let Some(values) = tile.get_mut(end - 4..) {
        last.store_slice(values);
    }
}

/// Source over target, as [`pixel::over`](super::pixel::over).
#[inline(always)]
fn over<K: Simd>(source: u32x8<K>, target: u32x8<K>) -> u32x8<K> {
    let clear = !(source >> 24) & 0xff;
    source + (scale_alternate(target, clear) | (scale_alternate(target >> 8, clear) << 8))
}

/// v · a / 255, rounded, for the first and third byte of each lane; the others are 0.
#[inline(always)]
fn scale_alternate<K: Simd>(v: u32x8<K>, a: u32x8<K>) -> u32x8<K> {
    let t = (v & 0x00ff_00ff) * a + 0x0080_0080;
    ((t + ((t >> 8) & 0x00ff_00ff)) >> 8) & 0x00ff_00ff
}

/// Two slopes as the upper halves of two `f32`: 8 bits of each are enough.
fn pack_slope(dx: f32, dy: f32) -> u32 {
    (dx.to_bits() & 0xffff_0000) | dy.to_bits() >> 16
}

/// The slopes that [`pack_slope`] packed, towards 0 by 1/128 at most.
pub(super) fn unpack_slope(packed: u32) -> [f32; 2] {
    [f32::from_bits(packed & 0xffff_0000), f32::from_bits(packed << 16)]
}
