//! The samples of a band while it is painted, and tiles of eight pixels in it.
//!
//! The usual layout stores the samples of a pixel next to one another. Here each sample has a plane of its own, so that
//! eight pixels of a row are eight numbers in a row of memory, which one instruction reads or writes. Behind each row
//! there is room for eight more, and a tile at the border needs no special case.

use std::ops::Range;

use crate::simd::prelude::*;

use super::setup::Size;
use crate::raster::pixel::{LANES, Pixel};

/// Some rows of a picture: colour and depth of each sample, in one plane for each place of a sample.
pub(super) struct Band<'a> {
    pub(super) size: Size,
    pub(super) rows: Range<i32>,
    /// Offsets of the samples from the centre, in steps: as many as `fill` expects.
    pub(super) samples: &'a [[i32; 2]],
    /// Values from one row to the next. Beyond `width` there is room for eight more.
    pub(super) pitch: u32,
    /// Values from one plane to the next.
    pub(super) plane: u32,
    pub(super) colors: &'a mut [Pixel],
    /// Empty if nothing writes depths, since no test can fail then.
    pub(super) depths: &'a mut [f32],
    /// The slope of the face whose depth was written at the first sample (packed). Empty if not requested.
    pub(super) slopes: &'a mut [u32],
    /// The place in the list of the face whose depth was written, for each sample. Empty if faces come as they're
    /// listed, since the first one is painted first then.
    pub(super) places: &'a mut [u32],
    /// The place of the first triangle of the current surface.
    pub(super) first_place: u32,
    /// Each triangle is painted over those before it, whatever their depths.
    pub(super) in_order: bool,
    /// The greatest number of the format of the depths. 0 if they are stored as they are.
    pub(super) greatest: f32,
    /// If requested.
    pub(super) counts: Option<&'a mut Counts>,
}

impl Band<'_> {
    /// The position of a pixel's values.
    #[inline(always)]
    pub(super) fn place(&self, row: i32, column: i32) -> u32 {
        // 32 bits, so that the compiler knows that a sum in 64 doesn't overflow.
        (row - self.rows.start) as u32 * self.pitch + column as u32
    }
}

/// The values of the tile at a place. `None` outside of the array.
#[inline(always)]
pub(super) fn load<K: Simd, T: SimdBase<K>>(simd: K, values: &[T::Element], place: u32) -> Option<T> {
    let place = place as usize;
    Some(T::from_slice(simd, values.get(place..place + LANES)?))
}

/// Writes the values of a tile.
#[inline(always)]
pub(super) fn store<K: Simd, T: SimdBase<K>>(tile: T, values: &mut [T::Element], place: u32) {
    let place = place as usize;
    if let Some(values) = values.get_mut(place..place + LANES) {
        tile.store_slice(values);
    }
}

/// Counts of covered and of written samples, for the report.
///
/// A count for each pixel would cost as much as painting it. Here eight counters, one for each pixel of a tile, grow
/// with one instruction, and are added up when a surface is done. Without a clock there are no counts at all.
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
