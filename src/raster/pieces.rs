//! The pieces of strokes that touch each band of rows, by what is in front of them.

use std::ops::Range;

use crate::appearance::Occlusion;

use super::coverage::Point;
use super::segment::pixels;

/// An arrow head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Head {
    pub(super) corners: [[f32; 2]; 3],
    /// The least and the greatest in it.
    pub(super) depths: [f32; 2],
}

/// Pieces of one layer that touch a band, in the order of the drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Bin {
    pub(super) segments: Vec<[Point; 2]>,
    /// Arrow heads, each with the number of segments before it.
    pub(super) heads: Vec<(usize, Head)>,
}

impl Bin {
    pub(super) fn is_empty(&self) -> bool {
        self.segments.is_empty() && self.heads.is_empty()
    }
}

/// Bands of a picture.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bands {
    pub(super) width: usize,
    pub(super) height: usize,
    /// Rows of a band, as the exponent of 2.
    pub(super) rows_log: u32,
}

impl Bands {
    /// The number of bands.
    pub(super) fn count(self) -> usize {
        self.height.div_ceil(1 << self.rows_log)
    }

    /// The rows of a band.
    pub(super) fn rows(self, band: usize) -> Range<usize> {
        let first = band << self.rows_log;
        first..self.height.min(first + (1 << self.rows_log))
    }

    /// The bands with pixels whose centres lie in a box.
    #[inline(always)]
    fn touched(self, [left, right]: [f32; 2], [top, bottom]: [f32; 2]) -> Range<usize> {
        let (columns, rows) = (pixels(left, right, 0..self.width), pixels(top, bottom, 0..self.height));
        if columns.is_empty() || rows.is_empty() {
            return 0..0;
        }
        rows.start >> self.rows_log..((rows.end - 1) >> self.rows_log) + 1
    }
}

/// The pieces of some strokes, by layer and band; keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    bands: Bands,
    /// The bands of the first layer, of the second …
    bins: Vec<Bin>,
}

impl Pieces {
    /// Makes room for a picture in `layers` layers, and empties it.
    pub(super) fn fit(&mut self, bands: Bands, layers: usize) {
        self.bands = bands;
        self.bins.resize_with(bands.count() * layers, Bin::default);
        for bin in &mut self.bins {
            bin.segments.clear();
            bin.heads.clear();
        }
    }

    /// The pieces of a layer that touch a band.
    pub(super) fn bin(&self, behind: Occlusion, band: usize) -> Option<&Bin> {
        self.bins.get(layer(behind) * self.bands.count() + band)
    }

    /// Adds a segment with its half width.
    #[inline(always)]
    pub(super) fn segment(&mut self, behind: Occlusion, [a, b]: [Point; 2], radius: f32) {
        let reach = radius + 0.5;
        let [x, y] = [0, 1].map(|k| [a[k].min(b[k]) - reach, a[k].max(b[k]) + reach]);
        let first = layer(behind) * self.bands.count();
        for band in self.bands.touched(x, y) {
            if let Some(bin) = self.bins.get_mut(first + band) {
                bin.segments.push([a, b]);
            }
        }
    }

    /// Adds an arrow head.
    pub(super) fn head(&mut self, behind: Occlusion, head: Head) {
        let [a, b, c] = head.corners;
        let [x, y] = [0, 1].map(|k| [a[k].min(b[k]).min(c[k]) - 0.5, a[k].max(b[k]).max(c[k]) + 0.5]);
        let first = layer(behind) * self.bands.count();
        for band in self.bands.touched(x, y) {
            if let Some(bin) = self.bins.get_mut(first + band) {
                bin.heads.push((bin.segments.len(), head));
            }
        }
    }
}

/// The visible parts first: of what nothing hides there are no others.
fn layer(behind: Occlusion) -> usize {
    match behind {
        Occlusion::None => 0,
        Occlusion::Translucent => 1,
        Occlusion::Opaque => 2,
    }
}
