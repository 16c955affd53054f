//! Counts of covered and of written samples, for the report.
//!
//! A count for each pixel would cost as much as painting it. Here eight counters, one for each pixel of a tile, grow
//! with one instruction, and are added up when a surface is done. Without a clock there are no counts at all.

use crate::simd::prelude::*;

use crate::raster::pixel::LANES;

/// Counts of processed samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Samples inside triangles.
    pub(super) covered: u64,
    /// Samples that nothing nearer has hidden.
    pub(super) written: u64,
    lanes: [[i32; LANES]; 2],
}

/// A kind of samples that is counted in lanes, by pixel of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Covered,
    Written,
}

impl Counts {
    #[inline(always)]
    pub(super) fn add<K: Simd>(&mut self, simd: K, kind: Kind, mask: mask32x8<K>) {
        let one = i32x8::splat(simd, 1);
        let lanes = &mut self.lanes[kind as usize];
        (i32x8::from_slice(simd, lanes) + mask.select(one, one - 1)).store_slice(lanes);
    }

    /// Adds up the lanes. Must be called before they overflow, after at most 2³¹ tiles.
    pub(super) fn sum(&mut self) {
        let [covered, written] =
            std::mem::take(&mut self.lanes).map(|lanes| lanes.iter().map(|&n| n as u64).sum::<u64>());
        self.covered += covered;
        self.written += written;
    }
}
