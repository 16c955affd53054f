//! Counts of processed samples, and of the operations on them.
//!
//! Counting goes along with painting, eight samples at a time; how many operations each costs is looked up afterwards
//! in [`operations`](super::operations).

use crate::drawing::Surface;
use crate::simd::prelude::*;
use crate::simd::{Simd, i32x8, mask32x8};
use crate::stage::Cost;

use super::operations::{self, Depths, Tally};
use super::shade::LANES;

/// Counts of processed samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Those inside of triangles.
    pub(super) covered: u64,
    /// Those of them that nothing nearer has hidden.
    pub(super) written: u64,
    /// Operations on samples and triangles.
    pub(super) cost: Cost,
    /// Of the surface at hand, since the last [`sum`](Self::sum).
    pub(super) here: Tally,
    lanes: [[i32; LANES]; KINDS],
}

/// The things that are counted in lanes, by pixel of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Covered,
    Written,
    Colored,
    Divided,
}

const KINDS: usize = 4;

impl Counts {
    #[inline(always)]
    pub(super) fn add<K: Simd>(&mut self, simd: K, kind: Kind, mask: mask32x8<K>) {
        let one = i32x8::splat(simd, 1);
        let lanes = &mut self.lanes[kind as usize];
        (i32x8::from_slice(simd, lanes) + mask.select(one, one - 1)).store_slice(lanes);
    }

    /// Books the work on a surface. To be called before the lanes run over: after at most 2³¹ tiles.
    pub(super) fn sum(&mut self, surface: &Surface, depths: Depths) {
        let lanes = std::mem::take(&mut self.lanes).map(|lanes| lanes.iter().map(|&n| n as u64).sum::<u64>());
        let mut here = std::mem::take(&mut self.here);
        here.covered += lanes[Kind::Covered as usize];
        here.written += lanes[Kind::Written as usize];
        here.colored += lanes[Kind::Colored as usize];
        here.divided += lanes[Kind::Divided as usize];
        self.covered += here.covered;
        self.written += here.written;
        operations::of_surface(&mut self.cost, surface, depths, &here);
    }
}
