//! Sets of places in a mask, eight columns each.
//!
//! A thin stroke touches few pixels of its band, so going through the whole mask to paint and empty it would cost more
//! than the stroke. Here a bit for each eight columns marks touched pixels, and 64 of them are one number.

use crate::raster::pixel::LANES;

/// A set of eights of columns: a bit for each in each row.
#[derive(Clone, Debug, Default)]
pub(super) struct TouchedColumns {
    /// For one row.
    pub(super) words: usize,
    bits: Vec<u64>,
}

impl TouchedColumns {
    pub(super) fn fit(&mut self, width: usize, rows: usize) {
        self.words = width.div_ceil(LANES).div_ceil(64);
        self.bits.clear();
        self.bits.resize(self.words * rows, 0);
    }

    /// Adds the eights between two columns of a row, the second one included.
    #[inline(always)]
    pub(super) fn add(&mut self, row: usize, first: usize, last: usize) {
        let (first, last) = (first / LANES, last / LANES);
        for word in first / 64..=last / 64 {
            let start = first.max(64 * word) - 64 * word;
            let end = last.min(64 * word + 63) - 64 * word;
            if let Some(bits) = self.bits.get_mut(row * self.words + word) {
                *bits |= (!0 << start) & (!0 >> (63 - end));
            }
        }
    }

    /// For tests.
    #[cfg(test)]
    pub(super) fn is_empty(&self) -> bool {
        self.bits.iter().all(|&bits| bits == 0)
    }

    /// Takes 64 eights of a row out of the set.
    #[inline(always)]
    pub(super) fn take(&mut self, row: usize, word: usize) -> u64 {
        self.bits.get_mut(row * self.words + word).map_or(0, std::mem::take)
    }
}

/// Takes the lowest bit of a word away: the first column of that eight.
#[inline(always)]
pub(super) fn next_column(bits: &mut u64, word: usize) -> usize {
    let bit = bits.trailing_zeros() as usize;
    *bits &= *bits - 1;
    (64 * word + bit) * LANES
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_eight_that_was_added_comes_once_in_its_row() {
        let mut set = TouchedColumns::default();
        set.fit(1100, 2);
        assert_eq!(set.words, 3);
        for (row, first, last) in [(0, 7, 7), (0, 3, 8), (1, 500, 530), (1, 1099, 1099), (0, 0, 0)] {
            set.add(row, first, last);
        }
        let mut taken = Vec::new();
        for (row, word) in [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)] {
            let mut eights = set.take(row, word);
            while eights != 0 {
                taken.push((row, next_column(&mut eights, word)));
            }
        }
        assert_eq!(taken, [(0, 0), (0, 8), (1, 496), (1, 504), (1, 512), (1, 520), (1, 528), (1, 1096)]);
        assert!(set.is_empty());
    }

    #[test]
    fn a_whole_row_is_added_at_once() {
        let mut set = TouchedColumns::default();
        set.fit(1024, 1);
        set.add(0, 0, 1023);
        assert_eq!(set.bits, [!0, !0]);
    }
}
