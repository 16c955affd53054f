//! Tiny triangles, eight at a time.
//!
//! The standard algorithm goes through the pixels of one triangle. In a triangle of three pixels, five of eight lanes
//! of a vector would be idle. Here each lane has a triangle of its own, and all eight go through their boxes in step:
//! pixel (0, 0) of eight boxes, then pixel (1, 0), and so on. Pixels are written afterwards, one triangle after the
//! other, because if two triangles own the same pixel the first one in the list has to come first. If colours cost much
//! (light at each pixel, textures), coverage comes first for the whole box, and each lane then moves on to its next
//! pixel inside, wherever it lies. Few lanes wait that way, and boxes of 11 × 11 pixels count as tiny.

use crate::simd::prelude::*;

use super::band::Band;
use super::batch::{BATCH, Batch, Planes, SetUp};
use super::setup::stored;
use super::shade::Colors;
use crate::raster::pixel::Pixel;

/// Largest number of columns and rows of triangles that are filled together.
pub(super) const FEW: u32 = 4;
/// The same if colours cost much, when a lane that waits costs more than a larger box.
pub(super) const FEW_COSTLY: u32 = 11;

/// Pixels of the largest box.
const MOST: usize = (FEW_COSTLY * FEW_COSTLY) as usize;

/// The pixels of tiny triangles, eight at a time. Kept for the next eight, since to clear them would cost as much as to
/// find them.
#[derive(Clone, Debug)]
pub(super) struct TinyBatch {
    /// The number of pixels that each triangle owns.
    owned: [usize; BATCH],
    /// The pixels of its box that it owns, row by row.
    places: [[u32; BATCH]; MOST],
    /// By the pixel's place in its box, or if colours cost much, by its number among those that the triangle owns.
    depths: [[f32; BATCH]; MOST],
    colors: [[Pixel; BATCH]; MOST],
}

impl Default for TinyBatch {
    fn default() -> Self {
        let (owned, places) = ([0; BATCH], [[0; BATCH]; MOST]);
        Self { owned, places, depths: [[0.0; BATCH]; MOST], colors: [[0; BATCH]; MOST] }
    }
}

impl TinyBatch {
    /// The pixels that a triangle owns: where they lie from the first of its box, in a band with this many values from
    /// row to row, their depths and colours.
    #[inline(always)]
    pub(super) fn pixels<'a, K: Simd, const SIDE: u32, C: Colors<'a, K>>(
        &self,
        lane: usize,
        pitch: u32,
    ) -> impl Iterator<Item = (u32, f32, Pixel)> {
        self.places.iter().take(self.owned[lane]).enumerate().filter_map(move |(n, place)| {
            let k = place[lane];
            let at = if C::COSTLY { n } else { k as usize };
            Some(((k / SIDE) * pitch + k % SIDE, self.depths.get(at)?[lane], self.colors.get(at)?[lane]))
        })
    }

    /// Goes through the boxes of the eight triangles of a batch together. `tiny` marks the triangles to fill, of at
    /// most `SIDE` columns and rows.
    #[inline(always)]
    pub(super) fn find<'a, K: Simd, const SIDE: u32, C: Colors<'a, K>>(
        &mut self,
        tiny: mask32x8<K>,
        batch: &Batch<K>,
        set_up: &SetUp<K>,
        band: &mut Band,
        depths: &Planes<K>,
        colors: &C,
    ) {
        let zero = u32x8::splat(tiny.witness(), 0);
        let (rows, columns) = (batch.bottom.min(band.rows.end) - set_up.top, batch.right - batch.left);
        let [x, y] = set_up.first();
        // Lane l is triangle l, and all go through the pixels of their own boxes in step: pixel (i, j) of eight boxes
        // at a time.
        // A bit for each pixel of a box.
        let mut owned = [zero; MOST.div_ceil(32)];
        let mut row_edges = set_up.edges;
        for j in 0..SIDE {
            let row = tiny & rows.simd_gt(j as i32);
            if !row.any_true() {
                break;
            }
            let mut edges = row_edges;
            for i in 0..SIDE {
                let mut own = row & columns.simd_gt(i as i32);
                if !own.any_true() {
                    break;
                }
                // No sign bit is set inside all three edges.
                own &= (edges[0] | edges[1] | edges[2]).simd_gt(-1);
                if own.any_true() {
                    let k = SIDE * j + i;
                    owned[k as usize / 32] |= own.select(zero + (1 << (k % 32)), zero);
                    if !C::COSTLY {
                        let (x, y) = (x + i as f32, y + j as f32);
                        let z = stored(depths.hold(depths.at(x, y)), band.greatest);
                        z.store_slice(&mut self.depths[k as usize]);
                        colors.at(own, x, y).store_slice(&mut self.colors[k as usize]);
                    }
                }
                for (edge, a) in edges.iter_mut().zip(set_up.a) {
                    *edge += a << 8;
                }
            }
            for (edge, b) in row_edges.iter_mut().zip(set_up.b) {
                *edge += b << 8;
            }
        }
        self.list(&owned[..(SIDE * SIDE).div_ceil(32) as usize]);
        if C::COSTLY {
            self.color::<K, SIDE, C>(tiny.witness(), batch, set_up, band, depths, colors);
        }
    }

    /// Lists the pixels that the triangles own, by a bit for each.
    #[inline(always)]
    fn list<K: Simd>(&mut self, words: &[u32x8<K>]) {
        self.owned = [0; BATCH];
        for (word, owned) in (0..).zip(words) {
            let mut bits = [0; BATCH];
            owned.store_slice(&mut bits);
            for l in 0..BATCH {
                let mut left: u32 = bits[l];
                while left != 0 {
                    if let Some(places) = self.places.get_mut(self.owned[l]) {
                        places[l] = 32 * word + left.trailing_zeros();
                    }
                    self.owned[l] += 1;
                    left &= left - 1;
                }
            }
        }
    }

    /// Depths and colours if colours cost much. Each triangle moves on to its next pixel, wherever in the box it
    /// lies, so that few lanes wait, and a pixel that is hidden by now gets no colour.
    #[inline(always)]
    fn color<'a, K: Simd, const SIDE: u32, C: Colors<'a, K>>(
        &mut self,
        simd: K,
        batch: &Batch<K>,
        set_up: &SetUp<K>,
        band: &mut Band,
        depths: &Planes<K>,
        colors: &C,
    ) {
        let [x, y] = set_up.first();
        let number = self.owned.map(|owned| i32::try_from(owned).unwrap_or(i32::MAX));
        let number = i32x8::from_slice(simd, &number);
        let most = self.owned.iter().copied().max().unwrap_or_default();
        let pixels = self.places.iter().zip(self.depths.iter_mut().zip(&mut self.colors));
        for (n, (places, (depths_here, colors_here))) in (0..).zip(pixels.take(most)) {
            let own = number.simd_gt(n);
            // The whole part of k / SIDE, with half a pixel more, so that no rounding goes below a whole number.
            let k = u32x8::from_slice(simd, places).bitcast::<i32x8<K>>();
            let down = ((k.to_float::<f32x8<K>>() + 0.5) * (1.0 / SIDE as f32)).to_int::<i32x8<K>>();
            let across = k - down * SIDE.cast_signed();
            let (x, y) = (x + across.to_float::<f32x8<K>>(), y + down.to_float::<f32x8<K>>());
            let z = stored(depths.hold(depths.at(x, y)), band.greatest);
            let mut wanted = own;
            if band.hides {
                wanted &= band.nearer(z, own, batch.left + across, set_up.top + down);
            }
            z.store_slice(depths_here);
            if wanted.any_true() {
                colors.at(wanted, x, y).store_slice(colors_here);
            }
        }
    }
}
