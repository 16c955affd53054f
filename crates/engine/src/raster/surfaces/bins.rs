//! The triangles that touch each band of rows, in the order of painting.
//!
//! The standard algorithm sets a triangle up once and paints it. With bands, a triangle would be set up in each of
//! them, and most triangles of a fine mesh own no sample at all. So the boxes of eight triangles are computed at once,
//! and a triangle whose only pixel has its centre outside is dropped here, once for all bands. The columns that
//! triangles touch are kept for each band, so that the rest of a band isn't cleared.

use std::ops::Range;

use rayon::prelude::*;

use crate::appearance::FaceOrder;
use crate::drawing::{Drawing, Surface};
use crate::simd::prelude::*;
use crate::simd::with_vectors;

use super::batch::{BATCH, Batch, corners_of, gather_points};
use super::setup::Size;

/// Triangles that are sorted into bands as one piece of work.
const CHUNK: usize = 8192;

/// The opaque triangles of a picture by band, and the translucent ones from back to front. In a drawing that is painted
/// in order, all triangles are treated as the opaque ones here. In one with an order of its own for opaque triangles,
/// they're treated as the translucent ones, and precede these. Kept between pictures.
#[derive(Clone, Debug, Default)]
pub(super) struct Bins {
    chunks: Vec<Stretch>,
    used: usize,
    /// Triangles that may own a sample.
    pub(super) kept: usize,
    sorted: Vec<Sorted>,
    /// The sorted triangles that touch each band.
    runs: Vec<Runs>,
}

/// Triangles in their order.
#[derive(Clone, Debug, Default)]
struct Runs {
    triangles: Vec<u32>,
    columns: ColumnSpan,
    /// The surface of some that follow one another, and the end of these in the list.
    surfaces: Vec<(usize, usize)>,
}

/// The triangles of a stretch that touch a band.
#[derive(Clone, Debug, Default)]
struct TriangleBin {
    triangles: Vec<u32>,
    columns: ColumnSpan,
}

/// The columns that triangles touch: the first, and the one after the last.
#[derive(Clone, Copy, Debug)]
struct ColumnSpan([i32; 2]);

impl Default for ColumnSpan {
    fn default() -> Self {
        Self([i32::MAX, 0])
    }
}

impl ColumnSpan {
    fn and(self, Self([first, end]): Self) -> Self {
        Self([self.0[0].min(first), self.0[1].max(end)])
    }
}

/// A stretch of the triangles of one surface.
#[derive(Clone, Debug, Default)]
struct Stretch {
    surface: usize,
    first: u32,
    end: u32,
    bands: Vec<TriangleBin>,
    /// Number of triangles that touch any.
    kept: usize,
}

/// A triangle whose depth decides when it's painted.
#[derive(Clone, Copy, Debug)]
struct Sorted {
    /// 0 if it's opaque, 1 if it's translucent, 2 if it also has no depth test: it lies over all others then.
    layer: u8,
    /// Sum of the depths of its vertices: the order of centroids. Negative if the nearest comes first.
    depth: f32,
    surface: usize,
    triangle: u32,
    columns: ColumnSpan,
    first_band: usize,
    last_band: usize,
}

impl Bins {
    /// Sorts all triangles of a drawing. `many` means several samples per pixel. `height` is the rows of a band, a
    /// power of two.
    pub(super) fn sort(&mut self, drawing: &Drawing, many: bool, size: Size, height: usize, bands: usize) {
        self.used = 0;
        let order = drawing.face_order();
        let is_sorted =
            |s: &Surface| !drawing.painted_in_order && (s.translucent || s.depth_test && order != FaceOrder::AsListed);
        for (surface, s) in drawing.surfaces.iter().enumerate().filter(|(_, s)| !is_sorted(s)) {
            for first in (0..s.triangles.len()).step_by(CHUNK) {
                if self.used == self.chunks.len() {
                    self.chunks.push(Stretch::default());
                }
                let chunk = &mut self.chunks[self.used];
                (chunk.surface, chunk.first) = (surface, number(first));
                chunk.end = number(s.triangles.len().min(first + CHUNK));
                self.used += 1;
            }
        }
        let fill = |chunk: &mut Stretch| chunk.fill(&drawing.surfaces[chunk.surface], many, size, height, bands);
        let chunks = &mut self.chunks[..self.used];
        if chunks.len() > 1 && rayon::current_num_threads() > 1 {
            chunks.par_iter_mut().for_each(fill);
        } else {
            chunks.iter_mut().for_each(fill);
        }
        let kept: usize = self.chunks[..self.used].iter().map(|chunk| chunk.kept).sum();
        self.sort_by_depth(drawing, is_sorted, many, size, height);
        self.sort_runs(bands);
        self.kept = kept + self.sorted.len();
    }

    fn sort_by_depth(
        &mut self,
        drawing: &Drawing,
        is_sorted: impl Fn(&Surface) -> bool,
        many: bool,
        size: Size,
        height: usize,
    ) {
        self.sorted.clear();
        for (surface, s) in drawing.surfaces.iter().enumerate().filter(|(_, s)| is_sorted(s)) {
            let layer = u8::from(s.translucent) + u8::from(s.translucent && !s.depth_test);
            let sign = if layer == 0 && drawing.order == FaceOrder::FrontToBack { -1.0 } else { 1.0 };
            boxes(s, 0..s.triangles.len(), many, size, |triangle, rows, columns| {
                let depth = |k: usize| s.positions[s.triangles[triangle as usize][k] as usize][2];
                self.sorted.push(Sorted {
                    layer,
                    depth: sign * (depth(0) + depth(1) + depth(2)),
                    surface,
                    triangle,
                    columns,
                    first_band: rows.start as usize / height,
                    last_band: (rows.end - 1) as usize / height,
                });
            });
        }
        // The sort is stable, so the first in the drawing is drawn first if depths are equal.
        self.sorted.sort_by(|a, b| a.layer.cmp(&b.layer).then(a.depth.total_cmp(&b.depth)));
    }

    fn sort_runs(&mut self, bands: usize) {
        self.runs.resize_with(bands, Runs::default);
        for runs in &mut self.runs {
            runs.triangles.clear();
            runs.columns = ColumnSpan::default();
            runs.surfaces.clear();
        }
        for t in &self.sorted {
            for runs in self.runs.get_mut(t.first_band..=t.last_band).unwrap_or_default() {
                runs.triangles.push(t.triangle);
                runs.columns = runs.columns.and(t.columns);
                let end = runs.triangles.len();
                match runs.surfaces.last_mut() {
                    Some((surface, old_end)) if *surface == t.surface => *old_end = end,
                    _ => runs.surfaces.push((t.surface, end)),
                }
            }
        }
    }

    /// The columns that the triangles of a band touch.
    pub(super) fn columns(&self, band: usize) -> Range<usize> {
        let opaque = self.chunks[..self.used].iter().map(|chunk| chunk.bands[band].columns);
        let ColumnSpan([first, end]) = opaque.fold(self.runs[band].columns, ColumnSpan::and);
        let [first, end] = [first.min(end), end].map(|column| usize::try_from(column).unwrap_or_default());
        first..end
    }

    /// The triangles that touch a band, surface and numbers: those in the order of the drawing, then the sorted ones.
    pub(super) fn band(&self, band: usize) -> impl Iterator<Item = (usize, &[u32])> {
        let listed =
            self.chunks[..self.used].iter().map(move |chunk| (chunk.surface, chunk.bands[band].triangles.as_slice()));
        let runs = &self.runs[band];
        let sorted = runs.surfaces.iter().scan(0, |start, &(surface, end)| {
            let triangles = &runs.triangles[*start..end];
            *start = end;
            Some((surface, triangles))
        });
        listed.filter(|(_, triangles)| !triangles.is_empty()).chain(sorted)
    }
}

impl Stretch {
    fn fill(&mut self, surface: &Surface, many: bool, size: Size, height: usize, bands: usize) {
        self.bands.resize_with(bands, TriangleBin::default);
        for bin in &mut self.bands {
            bin.triangles.clear();
            bin.columns = ColumnSpan::default();
        }
        // Heights of bands are powers of two.
        let shift = height.trailing_zeros();
        self.kept = 0;
        boxes(surface, self.first as usize..self.end as usize, many, size, |triangle, rows, columns| {
            self.kept += 1;
            for band in rows.start >> shift..=(rows.end - 1) >> shift {
                if let Some(bin) = self.bands.get_mut(band as usize) {
                    bin.triangles.push(triangle);
                    bin.columns = bin.columns.and(columns);
                }
            }
        });
    }
}

/// Calls `found` for each triangle that may own a sample, in order, with the rows and columns of the picture that it
/// touches.
fn boxes(
    surface: &Surface,
    range: Range<usize>,
    many: bool,
    size: Size,
    mut found: impl FnMut(u32, Range<i32>, ColumnSpan),
) {
    let triangles = surface.triangles.get(range.clone()).unwrap_or_default();
    for (first, triangles) in (range.start..).step_by(BATCH).zip(triangles.chunks(BATCH)) {
        let boxes = with_vectors!(simd => eight_boxes(simd, surface, triangles, many, size));
        for (l, [top, bottom, left, right]) in
            boxes.into_iter().enumerate().filter(|(_, [top, bottom, ..])| top < bottom)
        {
            found(number(first + l), top..bottom, ColumnSpan([left, right]));
        }
    }
}

/// The rows and columns that eight triangles touch, first and end of each. Zeros for those that own no sample.
#[inline(always)]
fn eight_boxes<K: Simd>(
    simd: K,
    surface: &Surface,
    triangles: &[[u32; 3]],
    many: bool,
    size: Size,
) -> [[i32; 4]; BATCH] {
    let [x, y, _] = gather_points(simd, &surface.positions, &corners_of(triangles));
    let batch = Batch::new(simd, &x, &y, many, size);
    let mut some = batch.some;
    if !many && (batch.one & some).any_true() {
        // Most triangles of a fine mesh have one pixel in their box and don't own it. They are dropped here, once for
        // all bands.
        some &= !batch.one | batch.set_up(0).own_first();
    }
    let mut result = [[0; 4]; BATCH];
    for (l, of) in result.iter_mut().enumerate() {
        if some[l] != 0 {
            *of = [batch.top[l], batch.bottom[l], batch.left[l], batch.right[l]];
        }
    }
    result
}

/// Numbers of triangles are 32 bits wide. Their vertices' are, too, and 2³² triangles would fill 48 GB.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
fn number(index: usize) -> u32 {
    index as u32
}
