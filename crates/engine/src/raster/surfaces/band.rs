//! The samples of a band while it is painted, and tiles of eight pixels in it.
//!
//! The usual layout stores the samples of a pixel next to one another. Here each sample has a plane of its own, so that
//! eight pixels of a row are eight numbers in a row of memory, which one instruction reads or writes. Behind each row
//! there is room for eight more, and a tile at the border needs no special case.

use std::ops::Range;

use crate::drawing::Surface;
use crate::simd::prelude::*;

use super::setup::Size;
use crate::raster::depth::pack_slope;
use crate::raster::pixel::{self, LANES, Pixel};

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
    /// Each triangle is painted over those before it, whatever their depths.
    pub(super) in_order: bool,
    /// Nothing of the surface at hand is painted behind the stored depths.
    pub(super) hides: bool,
    /// The greatest number of the format of the depths. 0 if they are stored as they are.
    pub(super) greatest: f32,
    /// If requested.
    pub(super) counts: Option<&'a mut Counts>,
}

impl Band<'_> {
    /// The position of a pixel's values.
    #[inline(always)]
    pub(super) fn place(&self, row: i32, column: i32) -> TileStart {
        TileStart { start: (row - self.rows.start) as u32 * self.pitch + column as u32, pitch: self.pitch }
    }

    /// The pixels, one for each lane, at which these depths, as they are stored, are nearer than the stored ones.
    #[inline(always)]
    pub(super) fn nearer<K: Simd>(
        &self,
        z: f32x8<K>,
        asked: mask32x8<K>,
        columns: i32x8<K>,
        rows: i32x8<K>,
    ) -> mask32x8<K> {
        let places = (rows - self.rows.start) * self.pitch.cast_signed() + columns;
        let places = asked.select(places, i32x8::splat(z.witness(), 0));
        let mut old = [f32::NEG_INFINITY; LANES];
        for l in 0..LANES {
            if let Some(&depth) = self.depths.get(places[l] as usize) {
                old[l] = depth;
            }
        }
        asked & z.simd_gt(f32x8::from_slice(z.witness(), &old))
    }

    /// Sets pixels of a triangle: each by its distance from `start`, its depth as it is stored, and its colour.
    #[inline(always)]
    pub(super) fn set_each(
        &mut self,
        surface: &Surface,
        start: u32,
        slope: [f32; 2],
        pixels: impl Iterator<Item = (u32, f32, Pixel)>,
    ) {
        for (offset, depth, color) in pixels {
            self.set(surface, start + offset, depth, slope, color);
        }
    }

    /// Sets a pixel.
    #[inline(always)]
    fn set(&mut self, surface: &Surface, pixel: u32, depth: f32, [dx, dy]: [f32; 2], color: Pixel) {
        let start = pixel as usize;
        let Some(pixel) = self.colors.get_mut(start) else { return };
        if let Some(counts) = &mut self.counts {
            counts.covered += 1;
        }
        if surface.depth_test
            && let Some(old) = self.depths.get_mut(start)
        {
            // Not `<=`, because a depth that isn't a number is behind everything, as in `Painter`.
            if !(depth > *old || self.in_order) {
                return;
            }
            if !surface.translucent {
                *old = depth;
                if let Some(slope) = self.slopes.get_mut(start) {
                    *slope = pack_slope(dx, dy);
                }
            }
        }
        if let Some(counts) = &mut self.counts {
            counts.written += 1;
        }
        *pixel = if surface.translucent { pixel::over(color, *pixel) } else { color };
    }
}

/// The start of a tile in the arrays of a band, and the distance from there to the next row.
#[derive(Clone, Copy)]
pub(super) struct TileStart {
    // 32 bits, so that the compiler knows that a sum in 64 doesn't overflow.
    pub(super) start: u32,
    pub(super) pitch: u32,
}

impl TileStart {
    /// The same pixels in the plane of another sample.
    #[inline(always)]
    pub(super) fn plane(self, start: u32) -> Self {
        Self { start: self.start.wrapping_add(start), ..self }
    }

    /// The values of a tile. `None` outside of the array.
    #[inline(always)]
    pub(super) fn load<K: Simd, T: SimdBase<K> + SimdCombine<K>, const SQUARE: bool>(
        self,
        simd: K,
        values: &[T::Element],
    ) -> Option<T::Combined>
    where
        T::Combined: SimdBase<K, Element = T::Element>,
    {
        let (start, pitch) = (self.start as usize, self.pitch as usize);
        Some(if SQUARE {
            let (first, last) = (values.get(start..start + 4)?, values.get(start + pitch..start + pitch + 4)?);
            T::from_slice(simd, first).combine(T::from_slice(simd, last))
        } else {
            T::Combined::from_slice(simd, values.get(start..start + LANES)?)
        })
    }

    /// Writes the values of a tile.
    #[inline(always)]
    pub(super) fn store<K: Simd, T: SimdSplit<K> + SimdBase<K>, const SQUARE: bool>(
        self,
        tile: T,
        values: &mut [T::Element],
    ) where
        T::Split: SimdBase<K, Element = T::Element>,
    {
        let (start, pitch) = (self.start as usize, self.pitch as usize);
        if SQUARE {
            let (first, last) = tile.split();
            if let Some(values) = values.get_mut(start..start + 4) {
                first.store_slice(values);
            }
            if let Some(values) = values.get_mut(start + pitch..start + pitch + 4) {
                last.store_slice(values);
            }
        } else if let Some(values) = values.get_mut(start..start + LANES) {
            tile.store_slice(values);
        }
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
