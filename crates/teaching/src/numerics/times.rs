//! Times with their uncertainty, and what follows from them.

/// Medians nearer than this to one another, as a share, are the same: the place of code and data in memory alone moves
/// them as far.
const SAME: f64 = 0.01;
/// A gap between two intervals that's narrower than this share of a time is open: from one process to the next, the
/// same frame takes so much more or less.
const OPEN: f64 = 0.02;

/// A median with an interval that holds it with 95 %.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Interval {
    /// The median.
    pub median: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// The median of times, and its interval by the [bootstrap](Self::bootstrap), which reaches at least a hundredth to
    /// each side. A single time has none.
    pub fn of(times: &[f64]) -> Self {
        let Self { median, low, high } = Self::bootstrap(times);
        if times.len() < 2 {
            return Self { median, low, high };
        }
        Self { median, low: low.min(median * (1.0 - SAME)), high: high.max(median * (1.0 + SAME)) }
    }

    /// The median of numbers, and its interval by the bootstrap over the rounds (Efron 1979): what the median would be
    /// if the rounds were drawn again from those that were.
    ///
    /// *Textbook*: some thousand draws. *Here*: none. The median of a draw is at most the k-th of n numbers if half of
    /// the draw is, and that's a binomial probability with k/n.
    pub fn bootstrap(numbers: &[f64]) -> Self {
        let mut sorted = numbers.to_vec();
        sorted.sort_by(f64::total_cmp);
        let n = sorted.len();
        let at = |k: usize| sorted.get(k.min(n.saturating_sub(1))).copied().unwrap_or(0.0);
        let median = 0.5 * (at(n.saturating_sub(1) / 2) + at(n / 2));
        // The other end is as far from the greatest number.
        let first = (1..=n).find(|&k| median_within(n, k) >= 0.025).unwrap_or(n).saturating_sub(1);
        Self { median, low: at(first), high: at(n.saturating_sub(1 + first)) }
    }
}

/// The probability that the median of n draws from n numbers is at most the k-th of them: that half of the draws are.
/// Of two medians, the lower one.
fn median_within(n: usize, k: usize) -> f64 {
    if k >= n {
        return 1.0;
    }
    let share = k as f64 / n as f64;
    let (mut log_choose, mut sum) = (0.0, 0.0);
    for hits in 0..=n {
        if hits > 0 {
            log_choose += ((n - hits + 1) as f64 / hits as f64).ln();
        }
        if 2 * hits >= n {
            sum += (log_choose + hits as f64 * share.ln() + (n - hits) as f64 * (1.0 - share).ln()).exp();
        }
    }
    sum
}

/// For each row, whether it's on the front, and whether more rounds could change that. A row is on the front if no
/// other one is at most as costly and has an interval of time wholly below its own. It's undecided if the gap that
/// decides is less than two hundredths of its time.
pub fn decide<C>(rows: &[(C, Interval)], is_at_most: impl Fn(&C, &C) -> bool) -> Vec<(bool, bool)> {
    let verdict = |k: usize| {
        let (cost, time) = &rows[k];
        let rivals = rows.iter().enumerate().filter(|(other, (of, _))| *other != k && is_at_most(of, cost));
        let gap = rivals.map(|(_, (_, of))| (time.low - of.high) / time.median).fold(f64::NEG_INFINITY, f64::max);
        (gap <= 0.0, gap.abs() < OPEN)
    };
    (0..rows.len()).map(verdict).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::random::Random;

    #[test]
    fn a_single_round_has_no_spread_and_two_have_both_ends() {
        assert_eq!(Interval::of(&[3.0]), Interval { median: 3.0, low: 3.0, high: 3.0 });
        assert_eq!(Interval::of(&[5.0, 3.0]), Interval { median: 4.0, low: 3.0, high: 5.0 });
        // As near as these, times are the same.
        assert_eq!(Interval::of(&[100.0, 100.0, 100.0]), Interval { median: 100.0, low: 99.0, high: 101.0 });
    }

    /// The median of the distribution is 1. Times are skewed, as real ones are.
    #[test]
    fn the_interval_holds_the_median_with_95_percent() {
        let mut random = Random::new(1, 0);
        for rounds in [10, 25, 100] {
            let trials = 2000_u32;
            let mut held = 0_u32;
            for _ in 0..trials {
                let times: Vec<f64> = (0..rounds).map(|_| 2f64.powf(random.between(-1.0, 1.0).powi(3))).collect();
                let Interval { low, high, .. } = Interval::of(&times);
                held += u32::from(low <= 1.0 && 1.0 <= high);
            }
            assert!(f64::from(held) >= 0.94 * f64::from(trials), "{rounds}: {held}");
        }
    }

    #[test]
    fn a_row_is_off_the_front_only_if_an_interval_lies_wholly_below_its_own() {
        let time = |median: f64, half: f64| Interval { median, low: median - half, high: median + half };
        let rows = [
            (1.0, time(10.0, 0.5)),
            (2.0, time(11.0, 0.2)),
            (2.0, time(10.2, 0.5)),
            (0.5, time(20.0, 1.0)),
            (3.0, time(10.65, 0.1)),
        ];
        let verdicts = decide(&rows, |a, b| a <= b);
        assert_eq!(verdicts.iter().map(|(front, _)| *front).collect::<Vec<_>>(), [true, false, true, true, false]);
        // Only the last is decided by less than a fiftieth.
        assert_eq!(verdicts.iter().map(|(_, open)| *open).collect::<Vec<_>>(), [false, false, false, false, true]);
    }
}
