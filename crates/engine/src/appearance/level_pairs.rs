//! The levels of detail of a picture in one array, laid out for a filter that mixes four texels of two levels.
//!
//! Each texel stands beside the one below it, and behind the last of a row comes the first once more. The four texels
//! around a point are sixteen bytes in a row of memory, wherever it lies. That's twice the memory of the picture, for a
//! quarter of the places that are read.

use super::level::Level;

/// The levels of detail of a picture, from the largest on.
#[derive(Clone, Debug)]
pub(crate) struct LevelPairs {
    /// For each level the place of its first pair, its width and its height in texels. The last stands here twice, so
    /// that each has one behind it.
    sizes: Vec<[i32; 4]>,
    /// A texel, as its bytes lie in memory, and the one below. Below the last row is the first.
    pairs: Vec<[u32; 2]>,
}

impl LevelPairs {
    pub(super) fn new(levels: &[Level]) -> Self {
        let number = |n: u32| i32::try_from(n).unwrap_or(i32::MAX);
        let (mut sizes, mut pairs) = (Vec::new(), Vec::new());
        for level in levels {
            let first = i32::try_from(pairs.len()).unwrap_or(i32::MAX);
            sizes.push([first, number(level.width), number(level.height), 0]);
            let texel = |x: u32, y: u32| u32::from_le_bytes(level.texel(x, y));
            for y in 0..level.height {
                let below = (y + 1) % level.height;
                pairs.extend((0..level.width).chain([0]).map(|x| [texel(x, y), texel(x, below)]));
            }
        }
        sizes.extend(sizes.last().copied());
        Self { sizes, pairs }
    }

    /// The number of the smallest level.
    #[inline(always)]
    pub(crate) fn last(&self) -> i32 {
        // A picture has fifteen levels at most.
        i32::try_from(self.sizes.len()).map_or(0, |n| n - 2)
    }

    /// A level and the next smaller one. For each the place of its first pair, its width, its height, and nothing.
    #[inline(always)]
    pub(crate) fn sizes(&self, level: i32) -> &[[i32; 4]] {
        // A negative number becomes one that is far too large.
        let level = level.cast_unsigned() as usize;
        self.sizes.get(level..level.wrapping_add(2)).unwrap_or_default()
    }

    /// The texel at a place, the one below it, the one to its right, and the one below that, as their bytes lie in
    /// memory. `None` if there is none.
    #[inline(always)]
    pub(crate) fn four(&self, place: i32) -> Option<&[u32]> {
        let place = place.cast_unsigned() as usize;
        self.pairs.get(place..place.wrapping_add(2)).map(<[[u32; 2]]>::as_flattened)
    }
}
