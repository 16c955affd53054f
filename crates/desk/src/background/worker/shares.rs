//! The shares of the slots in the time, which decide the next turn.

use std::time::Duration;

/// Time used by each slot, so that the slot with the least comes next.
#[derive(Debug)]
pub(super) struct Shares<const SLOTS: usize> {
    had: [Duration; SLOTS],
    /// The time that the last slot had had before. A slot that hasn't waited gets no credit for it.
    floor: Duration,
}

impl<const SLOTS: usize> Default for Shares<SLOTS> {
    fn default() -> Self {
        Self { had: [Duration::ZERO; SLOTS], floor: Duration::ZERO }
    }
}

impl<const SLOTS: usize> Shares<SLOTS> {
    pub(super) fn next(&mut self, waiting: [bool; SLOTS]) -> Option<usize> {
        for slot in (0..SLOTS).filter(|&slot| waiting[slot]) {
            self.had[slot] = self.had[slot].max(self.floor);
        }
        let next = (0..SLOTS).filter(|&slot| waiting[slot]).min_by_key(|&slot| self.had[slot])?;
        self.floor = self.had[next];
        Some(next)
    }

    pub(super) fn book(&mut self, slot: usize, time: Duration) {
        self.had[slot] += time;
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn a_light_job_comes_more_often_than_a_heavy_one_and_none_starves() {
        let mut shares = Shares::default();
        let mut came = [0_u32; 3];
        let takes = [60, 180, 20].map(Duration::from_millis);
        for _ in 0..100 {
            let i = shares.next([true; 3]).unwrap();
            came[i] += 1;
            shares.book(i, takes[i]);
        }
        assert!(came[1] >= 6 && came[0] >= 3 * came[1] - 3 && came[2] >= 3 * came[0] - 3, "{came:?}");
        // A slot that was idle for long has no right to all the time after that.
        for _ in 0..50 {
            let i = shares.next([false, false, true]).unwrap();
            shares.book(i, takes[i]);
        }
        let first: Vec<usize> = (0..12)
            .map(|_| {
                let i = shares.next([true; 3]).unwrap();
                shares.book(i, takes[i]);
                i
            })
            .collect();
        assert!(first.contains(&2) && first.contains(&1) && first.contains(&0), "{first:?}");
        assert_eq!(shares.next([false; 3]), None);
    }
}
