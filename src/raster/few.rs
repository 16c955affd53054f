//! The pixels of tiny triangles: found for eight triangles at once, and set one by one afterwards.

use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, i32x8, mask32x8, u32x8};

use super::band::Band;
use super::batch::{BATCH, Batch, Planes, SetUp};
use super::counts::Kind;
use super::pixel::Pixel;
use super::shade::Colors;

/// Largest number of columns and rows of triangles that are filled together, and the pixels of their boxes.
pub(super) const FEW: (u32, usize) = (4, 16);
/// The same where colours cost much: a lane that waits costs more then than a larger box.
pub(super) const FEW_COSTLY: (u32, usize) = (8, 64);

/// The pixels of tiny triangles, in rows of `SIDE` from the first of the box on; `MOST` is `SIDE`².
pub(super) struct Few<const SIDE: u32, const MOST: usize> {
    /// Nothing is painted behind what is there.
    depth_test: bool,
    /// A bit for each pixel that the triangle owns.
    pub(super) owned: [u64; BATCH],
    pub(super) depths: [[f32; BATCH]; MOST],
    pub(super) colors: [[Pixel; BATCH]; MOST],
}

impl<const SIDE: u32, const MOST: usize> Few<SIDE, MOST> {
    pub(super) fn new(depth_test: bool) -> Self {
        Self { depth_test, owned: [0; BATCH], depths: [[0.0; BATCH]; MOST], colors: [[0; BATCH]; MOST] }
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
        // The lower and the higher bits.
        let mut owned = [zero; 2];
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
                    owned[k as usize / 32] |= own.select(zero + (1 << (k % 32)), zero);
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
        let (mut low, mut high) = ([0; BATCH], [0; BATCH]);
        owned[0].store_slice(&mut low);
        owned[1].store_slice(&mut high);
        for (owned, (low, high)) in self.owned.iter_mut().zip(low.into_iter().zip(high)) {
            *owned = u64::from(low) | u64::from(high) << 32;
        }
        if C::COSTLY {
            self.color(tiny.witness(), batch, set_up, band, depths, colors);
        } else if let Some(counts) = &mut band.counts {
            counts.here.colored += self.owned.iter().map(|owned| u64::from(owned.count_ones())).sum::<u64>();
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
        let mut left = self.owned;
        while left != [0; BATCH] {
            let (mut here, mut at) = ([0; BATCH], [MOST; BATCH]);
            let (mut across, mut down) = ([0.0; BATCH], [0.0; BATCH]);
            for (l, left) in left.iter_mut().enumerate().filter(|(_, left)| **left != 0) {
                let k = left.trailing_zeros();
                *left &= *left - 1;
                (here[l], at[l]) = (-1, k as usize);
                (across[l], down[l]) = ((k % SIDE) as f32, (k / SIDE) as f32);
            }
            let own = mask32x8::from_slice(simd, &here);
            let (across, down) = (f32x8::from_slice(simd, &across), f32x8::from_slice(simd, &down));
            let (x, y) = (x + across, y + down);
            let z = depths.hold(depths.at(x, y));
            let mut wanted = own;
            if self.depth_test {
                let columns = batch.left + across.to_int::<i32x8<K>>();
                wanted &= band.nearer(z, own, columns, set_up.top + down.to_int::<i32x8<K>>());
            }
            let pixels = if wanted.any_true() { colors.at(wanted, x, y) } else { u32x8::splat(simd, 0) };
            for l in 0..BATCH {
                if let (Some(depths), Some(colors)) = (self.depths.get_mut(at[l]), self.colors.get_mut(at[l])) {
                    (depths[l], colors[l]) = (z[l], pixels[l]);
                }
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
