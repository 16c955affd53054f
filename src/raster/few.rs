//! The pixels of tiny triangles: found for eight triangles at once, and set one by one afterwards.

use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, i32x8, mask32x8, u32x8};

use super::band::Band;
use super::batch::{BATCH, Batch, Planes, SetUp};
use super::counts::Kind;
use super::pixel::Pixel;
use super::shade::Colors;

/// Largest number of columns and rows of triangles that are filled together, the pixels of their boxes, and the words
/// that have a bit for each.
pub(super) const FEW: (u32, usize, usize) = (4, 16, 1);
/// The same where colours cost much: a lane that waits costs more then than a larger box.
pub(super) const FEW_COSTLY: (u32, usize, usize) = (11, 121, 2);

/// The pixels of tiny triangles; `MOST` is `SIDE`².
pub(super) struct Few<const SIDE: u32, const MOST: usize, const WORDS: usize> {
    /// Nothing is painted behind what is there.
    depth_test: bool,
    /// A bit for each pixel that the triangle owns, in rows of `SIDE` from the first of the box on.
    pub(super) owned: [[u64; WORDS]; BATCH],
    /// By the pixel's place in its box; where colours cost much, by its number among those that the triangle owns.
    depths: [[f32; BATCH]; MOST],
    colors: [[Pixel; BATCH]; MOST],
}

impl<const SIDE: u32, const MOST: usize, const WORDS: usize> Few<SIDE, MOST, WORDS> {
    pub(super) fn new(depth_test: bool) -> Self {
        Self { depth_test, owned: [[0; WORDS]; BATCH], depths: [[0.0; BATCH]; MOST], colors: [[0; BATCH]; MOST] }
    }

    /// Depth and colour of a pixel that a triangle owns: the bit `k`, the `n`-th that is set.
    #[inline(always)]
    pub(super) fn pixel<'a, K: Simd, C: Colors<'a, K>>(&self, lane: usize, k: u32, n: usize) -> Option<(f32, Pixel)> {
        let at = if C::COSTLY { n } else { k as usize };
        Some((self.depths.get(at)?[lane], self.colors.get(at)?[lane]))
    }

    /// Goes through the boxes of the eight triangles of a batch together. `tiny`: those that are meant.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn find<'a, K: Simd, C: Colors<'a, K>>(
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
        // Half a word in each.
        let mut owned = [[zero; 2]; WORDS];
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
                // Inside of all three edges no sign bit is set.
                own &= (edges[0] | edges[1] | edges[2]).simd_gt(-1);
                if own.any_true() {
                    let k = SIDE * j + i;
                    owned[k as usize / 64][k as usize / 32 % 2] |= own.select(zero + (1 << (k % 32)), zero);
                    if !C::COSTLY {
                        let (x, y) = (x + i as f32, y + j as f32);
                        let z = depths.hold(depths.at(x, y));
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
        for (word, [lower, higher]) in owned.iter().enumerate() {
            let (mut low, mut high) = ([0; BATCH], [0; BATCH]);
            lower.store_slice(&mut low);
            higher.store_slice(&mut high);
            for l in 0..BATCH {
                self.owned[l][word] = u64::from(low[l]) | u64::from(high[l]) << 32;
            }
        }
        if C::COSTLY {
            self.color(tiny.witness(), batch, set_up, band, depths, colors);
        } else if let Some(counts) = &mut band.counts {
            let owned = self.owned.as_flattened();
            counts.here.colored += owned.iter().map(|word| u64::from(word.count_ones())).sum::<u64>();
        }
    }

    /// Depths and colours where colours cost much: each triangle goes on to its next pixel, wherever in the box it
    /// lies, so that few lanes wait, and what is hidden by now gets no colour.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn color<'a, K: Simd, C: Colors<'a, K>>(
        &mut self,
        simd: K,
        batch: &Batch<K>,
        set_up: &SetUp<K>,
        band: &mut Band,
        depths: &Planes<K>,
        colors: &C,
    ) {
        let [x, y] = set_up.first();
        let end = u32x8::splat(simd, u128::BITS);
        let mut left = [0; BATCH];
        for (left, words) in left.iter_mut().zip(&self.owned) {
            for (k, word) in words.iter().enumerate() {
                *left |= u128::from(*word) << (64 * k);
            }
        }
        for (depths_here, colors_here) in self.depths.iter_mut().zip(&mut self.colors) {
            if left == [0; BATCH] {
                break;
            }
            let mut next = [0; BATCH];
            for l in 0..BATCH {
                next[l] = left[l].trailing_zeros();
                left[l] &= left[l].wrapping_sub(1);
            }
            let next = u32x8::from_slice(simd, &next);
            let own = next.simd_lt(end);
            // The whole part of k / SIDE: half a pixel more, so that no rounding goes below a whole number.
            let k = next.bitcast::<i32x8<K>>();
            let down = ((k.to_float::<f32x8<K>>() + 0.5) * (1.0 / SIDE as f32)).to_int::<i32x8<K>>();
            let across = k - down * SIDE.cast_signed();
            let (x, y) = (x + across.to_float::<f32x8<K>>(), y + down.to_float::<f32x8<K>>());
            let z = depths.hold(depths.at(x, y));
            let mut wanted = own;
            if self.depth_test {
                wanted &= band.nearer(z, own, batch.left + across, set_up.top + down);
            }
            z.store_slice(depths_here);
            if wanted.any_true() {
                colors.at(wanted, x, y).store_slice(colors_here);
            }
            if let Some(counts) = &mut band.counts {
                counts.add(simd, Kind::Divided, wanted);
            }
        }
        if let Some(counts) = &mut band.counts {
            counts.here.two_levels += colors.two_levels();
        }
    }
}
