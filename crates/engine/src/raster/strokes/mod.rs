//! All strokes of a picture, in bands of rows.
//!
//! The standard way draws one polyline after the other over the picture. Here all are cut into pieces first, by chunks
//! on several threads, and each piece is put into the bands that it touches. Then each thread paints one band after the
//! other, layer by layer, while its masks are in the cache. Together with vectors this took the edges of 100,000
//! triangles from 71.2 to 8.0 ms.

mod coverage;
mod eights;
mod fragments;
mod line;
mod pieces;
mod segment;

use std::ops::Range;

use rayon::prelude::*;
use tiny_skia::Pixmap;

use crate::appearance::{HiddenLines, LineStyle, Occlusion};
use crate::drawing::{Drawing, StrokeSet};
use crate::progress::{Progress, pause};
use crate::simd::prelude::Simd;
use crate::simd::with_vectors;

use crate::raster::bands::each_band;
use crate::raster::depth::Occluders;
use coverage::Coverage;
use fragments::Rank;
use line::Lines;
use pieces::{Bands, Bin, Pieces};

/// Polylines that are made into pieces as one piece of work: at least this many, and a share of all, so that no thread
/// waits long for the last.
const CHUNK: usize = 16;
const CHUNKS_OF_A_THREAD: usize = 8;
/// Fewer polylines than this aren't worth a second thread.
const FEW: usize = 64;
/// The pixels of a band, whose masks, with twelve bytes each, should stay in a processor's own cache.
const BAND_PIXELS: usize = 1 << 16;
/// Rows of the lowest and of the highest band. Powers of two.
const BAND_ROWS: (usize, usize) = (8, 64);

/// Draws strokes. Keeps its buffers from one picture to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Strokes {
    chunks: Vec<PolylineChunk>,
    layers: Vec<StrokeLayer>,
    /// One for each thread.
    coverages: Vec<Coverage>,
}

/// Some polylines of a set.
#[derive(Clone, Debug, Default)]
struct PolylineChunk {
    set: usize,
    polylines: Range<usize>,
    lines: Lines,
    pieces: Pieces,
}

/// The parts of a set that are painted in one way.
#[derive(Clone, Debug)]
struct StrokeLayer {
    chunks: Range<usize>,
    behind: Occlusion,
    style: LineStyle,
    /// `None` means painted over all layers with a rank.
    rank: Option<Rank>,
}

/// State shared by all bands.
#[derive(Clone, Copy)]
struct StrokeBands<'a> {
    chunks: &'a [PolylineChunk],
    layers: &'a [StrokeLayer],
    bands: Bands,
}

impl Strokes {
    /// Draws all strokes of a drawing over its surfaces, from back to front. One thread pauses after some polylines.
    pub(super) async fn draw(
        &mut self,
        pixmap: &mut Pixmap,
        faces: Occluders<'_>,
        drawing: &Drawing,
        progress: &Progress,
    ) {
        let sets = &drawing.strokes;
        let count: usize = sets.iter().map(|set| set.polylines.len()).sum();
        if count == 0 {
            return;
        }
        let threads = if count < FEW { 1 } else { rayon::current_num_threads() };
        let used = self.divide(sets, count.div_ceil(threads * CHUNKS_OF_A_THREAD).max(CHUNK));
        let (width, height) = (pixmap.width() as usize, pixmap.height() as usize);
        let rows_log = (BAND_PIXELS / width).clamp(BAND_ROWS.0, BAND_ROWS.1).ilog2();
        let bands = Bands { width, height, rows_log };
        let cut = |chunk: &mut PolylineChunk| chunk.cut(&sets[chunk.set], faces, bands, progress);
        let chunks = &mut self.chunks[..used];
        if threads > 1 {
            chunks.par_iter_mut().for_each(cut);
        } else {
            for chunk in &mut *chunks {
                if progress.is_cancelled() {
                    return;
                }
                cut(chunk);
                pause().await;
            }
        }

        let shared = StrokeBands { chunks, layers: &self.layers, bands };
        self.coverages.resize_with(self.coverages.len().max(threads), Coverage::default);
        let pixels = pixmap.data_mut().as_chunks_mut::<4>().0;
        let jobs = pixels.chunks_mut(width << rows_log).enumerate();
        let jobs = jobs.map(|(band, pixels)| (pixels.len() / width, (band, pixels)));
        let paint = |coverage: &mut Coverage, (band, pixels): (usize, _)| shared.paint(coverage, band, pixels);
        each_band(&mut self.coverages[..threads], jobs, progress, paint).await;
    }

    /// Divides sets into chunks of this many polylines, and lists their layers. Returns the number of chunks.
    fn divide(&mut self, sets: &[StrokeSet], size: usize) -> usize {
        self.layers.clear();
        let mut used = 0;
        for (index, set) in sets.iter().enumerate() {
            let first = used;
            for start in (0..set.polylines.len()).step_by(size) {
                self.chunks.resize_with(self.chunks.len().max(used + 1), PolylineChunk::default);
                let chunk = &mut self.chunks[used];
                (chunk.set, chunk.polylines) = (index, start..set.polylines.len().min(start + size));
                used += 1;
            }
            let on_top = set.style.hidden == HiddenLines::Shown;
            for behind in [Occlusion::Opaque, Occlusion::Translucent, Occlusion::None] {
                let rank = Rank { visible: behind != Occlusion::Opaque, width: set.style.width };
                let rank = (!on_top).then_some(rank);
                // A stroke shown although hidden is never found to be behind anything.
                if let Some(style) = set.style.behind(behind).filter(|_| !on_top || behind == Occlusion::None) {
                    self.layers.push(StrokeLayer { chunks: first..used, behind, style, rank });
                }
            }
        }
        used
    }
}

impl PolylineChunk {
    /// Finds the visible, the dimmed and the hidden pieces of the chunk's polylines.
    fn cut(&mut self, set: &StrokeSet, faces: Occluders, bands: Bands, progress: &Progress) {
        let faces = (set.style.hidden != HiddenLines::Shown && !faces.is_empty()).then_some(faces);
        self.pieces.fit(bands, if faces.is_some() { 3 } else { 1 });
        if !progress.is_cancelled() {
            self.lines.cut(set, self.polylines.clone(), faces, &mut self.pieces);
        }
    }
}

impl<'a> StrokeBands<'a> {
    fn paint(self, coverage: &mut Coverage, band: usize, pixels: &mut [[u8; 4]]) {
        coverage.fit(self.bands.width, self.bands.rows(band));
        with_vectors!(simd => self.paint_with(simd, coverage, band, pixels));
    }

    #[inline(always)]
    fn paint_with<K: Simd>(self, simd: K, coverage: &mut Coverage, band: usize, pixels: &mut [[u8; 4]]) {
        let mut ranked = 0;
        for layer in self.layers {
            ranked += usize::from(layer.rank.is_some() && self.is_in(layer, band));
        }
        for layer in self.layers {
            if layer.rank.is_some() && self.is_in(layer, band) {
                // A stroke alone is behind none of them.
                coverage.begin(layer.style.color, layer.rank.filter(|_| ranked > 1));
                self.cover(simd, coverage, layer, band);
                coverage.end(simd, pixels);
            }
        }
        if ranked > 1 {
            coverage.lay(pixels);
        }
        for layer in self.layers {
            if layer.rank.is_none() && self.is_in(layer, band) {
                coverage.begin(layer.style.color, None);
                self.cover(simd, coverage, layer, band);
                coverage.end(simd, pixels);
            }
        }
    }

    /// True if a layer has pieces in a band.
    fn is_in(self, layer: &StrokeLayer, band: usize) -> bool {
        self.bins(layer, band).any(|bin| !bin.is_empty())
    }

    fn bins(self, layer: &StrokeLayer, band: usize) -> impl Iterator<Item = &'a Bin> {
        let behind = layer.behind;
        self.chunks[layer.chunks.clone()].iter().filter_map(move |chunk| chunk.pieces.bin(behind, band))
    }

    #[inline(always)]
    fn cover<K: Simd>(self, simd: K, coverage: &mut Coverage, layer: &StrokeLayer, band: usize) {
        let radius = 0.5 * layer.style.width;
        for bin in self.bins(layer, band) {
            let mut done = 0;
            for (before, head) in &bin.heads {
                coverage.segments(simd, bin.segments.get(done..*before).unwrap_or_default(), radius);
                coverage.triangle(head.corners, head.depths);
                done = *before;
            }
            coverage.segments(simd, bin.segments.get(done..).unwrap_or_default(), radius);
        }
    }
}
