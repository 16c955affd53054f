//! The order of strokes in depth: the fragments of each pixel, painted from back to front when all are known.
//!
//! An A-buffer (Carpenter 1984) keeps a list for each pixel. Here all fragments of a band are in one array, in which
//! each points to the one before it in the same pixel, so that a fragment costs no allocation. Most pixels have one
//! fragment and aren't sorted.

use crate::drawing::order::{StrokePoint, later_is_over};

use super::eights::{TouchedColumns, next_column};
use crate::raster::pixel::{LANES, Pixel, over, scale};

/// The pixels of some rows of a picture, with the fragments that layers of strokes cover. Empty once it's painted.
#[derive(Clone, Debug, Default)]
pub(super) struct Fragments {
    width: usize,
    rows: usize,
    layers: Vec<FragmentLayer>,
    fragments: Vec<Fragment>,
    /// The fragment of each pixel that came last, counted from 1. 0 if there is none.
    last: Vec<u32>,
    touched: TouchedColumns,
    /// The fragments of the current pixel, from back to front.
    order: Vec<Fragment>,
}

/// A set of pieces painted in one way.
#[derive(Clone, Copy, Debug)]
struct FragmentLayer {
    color: Pixel,
    rank: Rank,
}

/// The criteria besides depth by which a layer is put before or behind others: those of [`later_is_over`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rank {
    /// No face hides it.
    pub(super) visible: bool,
    /// Width of the stroke, in pixels.
    pub(super) width: f32,
}

/// The share of a pixel that a layer covers.
#[derive(Clone, Copy, Debug)]
struct Fragment {
    layer: u32,
    /// The fragment of the same pixel that came before, counted from 1.
    before: u32,
    share: u8,
    /// Depth of the stroke's middle line where it is nearest to the pixel.
    depth: f32,
    /// The greatest difference between that depth and those of the places on the stroke around that touch the pixel.
    reach: f32,
}

impl Fragments {
    /// Makes room for some rows of a picture. Only when it's empty.
    pub(super) fn fit(&mut self, width: usize, rows: usize) {
        (self.width, self.rows) = (width, rows);
        self.last.clear();
        self.last.resize(width * rows, 0);
        self.touched.fit(width, rows);
    }

    /// Begins a layer.
    pub(super) fn begin(&mut self, color: Pixel, rank: Rank) {
        self.layers.push(FragmentLayer { color, rank });
    }

    /// Adds the layer's fragment in a pixel, one of eight that were [touched](Self::touch): its share, the depth there,
    /// and the reach of that depth.
    #[inline]
    pub(super) fn add(&mut self, [row, column]: [usize; 2], share: u8, depth: f32, reach: f32) {
        let layer = number(self.layers.len().wrapping_sub(1));
        let last = &mut self.last[row * self.width + column];
        self.fragments.push(Fragment { layer, before: *last, share, depth, reach });
        *last = number(self.fragments.len());
    }

    /// Marks that pixels among the eight columns from this one have fragments.
    #[inline]
    pub(super) fn touch(&mut self, row: usize, column: usize) {
        self.touched.add(row, column, column);
    }

    /// Lays all layers on `pixels`, from back to front, and forgets them.
    pub(super) fn lay(&mut self, pixels: &mut [[u8; 4]]) {
        for row in 0..self.rows {
            for word in 0..self.touched.words {
                let mut eights = self.touched.take(row, word);
                while eights != 0 {
                    let first = next_column(&mut eights, word);
                    for column in first..self.width.min(first + LANES) {
                        let at = row * self.width + column;
                        self.lay_pixel(at, &mut pixels[at]);
                    }
                }
            }
        }
        self.layers.clear();
        self.fragments.clear();
    }

    fn lay_pixel(&mut self, at: usize, pixel: &mut [u8; 4]) {
        let (fragments, layers) = (&self.fragments, &self.layers);
        let get = |number: u32| fragments.get((number as usize).wrapping_sub(1)).copied();
        let Some(last) = get(std::mem::take(&mut self.last[at])) else { return };
        let mut lay = |fragment: &Fragment| {
            let source = scale(layers[fragment.layer as usize].color, u32::from(fragment.share));
            *pixel = over(source, u32::from_le_bytes(*pixel)).to_le_bytes();
        };
        // Most pixels have one, and nothing to sort.
        if last.before == 0 {
            lay(&last);
            return;
        }
        self.order.clear();
        self.order.extend(std::iter::successors(Some(last), |fragment| get(fragment.before)));
        self.order.reverse();
        sort(&mut self.order, layers);
        self.order.iter().for_each(lay);
    }

    /// For tests: nothing is left of an earlier picture.
    #[cfg(test)]
    pub(super) fn is_empty(&self) -> bool {
        self.fragments.is_empty() && self.layers.is_empty() && self.last.iter().all(|&last| last == 0)
    }
}

/// Sorts the fragments of a pixel, which come in the order of the drawing, from back to front. Each goes below those
/// that it's behind. ("Of the same depth" isn't an order, because it means within bounds, so each is compared with one
/// after the other.)
fn sort(fragments: &mut [Fragment], layers: &[FragmentLayer]) {
    for k in 1..fragments.len() {
        let mut at = k;
        while at > 0 && is_behind(&fragments[at], &fragments[at - 1], layers) {
            fragments.swap(at, at - 1);
            at -= 1;
        }
    }
}

/// True if a fragment is behind one that came before it in the drawing.
fn is_behind(later: &Fragment, earlier: &Fragment, layers: &[FragmentLayer]) -> bool {
    let point = |&Fragment { layer, depth, reach, .. }: &Fragment| {
        let Rank { visible, width } = layers[layer as usize].rank;
        StrokePoint { depth, reach, visible, width }
    };
    !later_is_over(point(later), point(earlier))
}

/// Fragments are counted with 32 bits. Each pixel of a picture has room for thirty.
fn number(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}
