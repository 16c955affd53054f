//! The pieces of strokes that touch each band of rows, by the kind of face in front of them.
//!
//! Without this each thread would go through all pieces of the picture for each of its bands.

use std::ops::Range;

use crate::appearance::Occlusion;

use super::segment::Point;

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

    /// The bands that may have pixels whose centres lie in a box.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "held to the picture")]
    fn touched(self, [left, right]: [f32; 2], [top, bottom]: [f32; 2]) -> Range<usize> {
        let (width, height) = (self.width as f32, self.height as f32);
        // False if anything isn't a number.
        if !(right > 0.0 && left < width && bottom > 0.0 && top < height) {
            return 0..0;
        }
        let (first, last) = (top.max(0.0) as u32, bottom.min(height - 1.0) as u32);
        (first >> self.rows_log) as usize..(last >> self.rows_log) as usize + 1
    }
}

/// The pieces of some strokes, by layer and band. Keeps its buffers.
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
        let x = [a[0].min(b[0]) - reach, a[0].max(b[0]) + reach];
        let y = [a[1].min(b[1]) - reach, a[1].max(b[1]) + reach];
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

/// The visible parts first. A stroke that nothing hides has no others.
fn layer(behind: Occlusion) -> usize {
    match behind {
        Occlusion::None => 0,
        Occlusion::Translucent => 1,
        Occlusion::Opaque => 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bands in which a segment of half width 1 is, in a picture of 100 × 70 in bands of 16 rows.
    fn bands(ends: [[f32; 2]; 2]) -> Vec<usize> {
        let bands = Bands { width: 100, height: 70, rows_log: 4 };
        let mut pieces = Pieces::default();
        pieces.fit(bands, 3);
        pieces.segment(Occlusion::Opaque, ends.map(|[x, y]| [x, y, 0.5]), 1.0);
        let is_in = |behind, band| pieces.bin(behind, band).is_some_and(|bin| !bin.is_empty());
        assert!((0..bands.count()).all(|band| !is_in(Occlusion::None, band) && !is_in(Occlusion::Translucent, band)));
        (0..bands.count()).filter(|&band| is_in(Occlusion::Opaque, band)).collect()
    }

    #[test]
    fn a_piece_is_in_each_band_that_it_touches_and_in_no_other() {
        assert_eq!(bands([[10.0, 8.0], [90.0, 8.0]]), [0]);
        // It covers a part of the first row of the second band.
        assert_eq!(bands([[10.0, 15.2], [90.0, 15.2]]), [0, 1]);
        assert_eq!(bands([[10.0, 66.0], [10.0, 20.0]]), [1, 2, 3, 4]);
        assert_eq!(bands([[-40.0, -30.0], [300.0, 400.0]]), [0, 1, 2, 3, 4]);
        for outside in [[[-9.0, 5.0], [-2.0, 9.0]], [[102.0, 5.0], [200.0, 9.0]], [[5.0, -2.0], [9.0, -8.0]]] {
            assert_eq!(bands(outside), [0_usize; 0]);
        }
        assert_eq!(bands([[5.0, 72.0], [9.0, 78.0]]), [0_usize; 0]);
        assert_eq!(bands([[5.0, f32::NAN], [f32::NAN, 78.0]]), [0_usize; 0]);
    }
}
