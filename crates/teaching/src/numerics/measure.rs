//! The error of a method, and its run time.

use std::future::poll_fn;
use std::hint::black_box;
use std::pin::pin;
use std::time::Duration;

use super::times::Interval;
use crate::clock;
use crate::progress::Progress;

/// The distance of one result from the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Off {
    /// In the unit of the study. The caller turns NaN into the worst error that the study knows.
    pub(super) error: f64,
    /// [`bits_off`], averaged over the components.
    pub(super) bits: f64,
}

/// log₂ of one more than the number of `f64`s between two numbers: 0 if they're equal, 64 if one of them isn't a
/// number. The measure of P. Panchekha et al., *Automatically improving accuracy for floating point expressions*
/// (2015).
pub(super) fn bits_off(computed: f64, exact: f64) -> f64 {
    if computed.is_nan() || exact.is_nan() {
        return 64.0;
    }
    // The numbers are ordered like these integers. Both zeros are 0.
    let place = |x: f64| {
        let magnitude = i128::from(x.to_bits() & !(1 << 63));
        if x.is_sign_negative() { -magnitude } else { magnitude }
    };
    let between = (place(computed) - place(exact)).unsigned_abs() as f64;
    (between + 1.0).log2()
}

/// The mean of [`bits_off`] over the components.
pub(super) fn mean_bits(pairs: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let (sum, count) = pairs.into_iter().fold((0.0, 0.0), |(sum, count), (a, b)| (sum + bits_off(a, b), count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

/// The clock of a study, and its cancellation.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    /// Time for repeating one method on the inputs of one case.
    pub(super) slice: Duration,
    /// The shortest time that the clock distinguishes.
    pub(super) tick: Duration,
    pub(super) progress: Progress,
}

/// The least number of timed passes over the inputs, if time is taken at all, after one that warms up.
const LEAST_PASSES: usize = 3;
/// A run shorter than this number of ticks of the clock is repeated until it's long enough. The error is a tenth at
/// most.
const TICKS: u32 = 10;
/// More passes add nothing new.
const MOST_PASSES: usize = 2000;

/// The results of one method on the inputs of one case.
#[derive(Clone, Debug, Default)]
pub(super) struct Trial {
    squares: f64,
    bits: f64,
    count: f64,
    worst: f64,
    worst_input: usize,
    /// Nanoseconds per item, for each pass of this turn.
    nanos: Vec<f64>,
    /// The median of the passes, for each turn before.
    turns: Vec<f64>,
}

impl Trial {
    /// Records one result. `input` is the index of its input.
    pub(super) fn note(&mut self, input: usize, off: Off) {
        self.squares += off.error * off.error;
        self.bits += off.bits;
        self.count += 1.0;
        if off.error > self.worst {
            (self.worst, self.worst_input) = (off.error, input);
        }
    }

    /// Times `f` on all `items`, as in [`time_whole`](Self::time_whole), and returns the results.
    pub(super) fn time<I, O>(&mut self, watch: &Watch, items: &[I], f: impl Fn(&I) -> O) -> Vec<O> {
        let mut results = Vec::with_capacity(items.len());
        self.time_whole(watch, items.len(), || {
            results.clear();
            results.extend(items.iter().map(|item| f(black_box(item))));
            black_box(&results);
        });
        results
    }

    /// Times `pass`, which does `items` things, once to warm up, then as often as the watch allows. The median of the
    /// passes of a turn counts, or of batches of them if the clock is too coarse for one.
    pub(super) fn time_whole(&mut self, watch: &Watch, items: usize, mut pass: impl FnMut()) {
        let mut timed = |passes: u32| {
            let start = clock::now();
            (0..passes).for_each(|_| pass());
            clock::now().saturating_sub(start)
        };
        let shortest = TICKS * watch.tick;
        let count = items as f64;
        let warm_up = timed(1);
        // A run longer than its slice is timed only once.
        if warm_up >= watch.slice.max(shortest) {
            return self.took(warm_up, count);
        }
        let end = clock::now() + watch.slice;
        let (mut done, mut batch) = (0, 1);
        while done < MOST_PASSES && !watch.progress.is_cancelled() {
            let time = timed(batch);
            if time < shortest {
                batch = batch.saturating_mul(2);
                continue;
            }
            self.took(time, count * f64::from(batch));
            done += 1;
            // A batch is a mean of many passes by itself.
            if (batch > 1 || done >= LEAST_PASSES) && clock::now() >= end {
                break;
            }
        }
    }

    /// Times `work`, which processes `items` items and is so long that it pauses. It runs once, and the pauses don't
    /// count.
    pub(super) async fn time_slices<T>(&mut self, items: usize, work: impl Future<Output = T>) -> T {
        let (mut work, mut time) = (pin!(work), Duration::ZERO);
        let outcome = poll_fn(|context| {
            let start = clock::now();
            let polled = work.as_mut().poll(context);
            time += clock::now().saturating_sub(start);
            polled
        })
        .await;
        self.took(time, items as f64);
        outcome
    }

    /// Records the time of this number of items.
    fn took(&mut self, time: Duration, items: f64) {
        self.nanos.push(time.as_secs_f64() * 1e9 / items.max(1.0));
    }

    /// True in the first turn. The results of the others are the same.
    pub(super) const fn is_first(&self) -> bool {
        self.turns.is_empty()
    }

    /// The number of results whose errors are to be noted: all in the first turn, and then none.
    pub(super) const fn to_judge(&self) -> usize {
        if self.is_first() { usize::MAX } else { 0 }
    }

    /// Ends a turn.
    pub(super) fn end_turn(&mut self) {
        self.turns.push(median(&std::mem::take(&mut self.nanos)));
    }

    /// Takes over the times of `other`, whose results were computed in the same passes.
    pub(super) fn takes_time_of(&mut self, other: &Self) {
        self.turns.clone_from(&other.turns);
    }

    /// The root of the mean square of the errors.
    pub(super) fn error(&self) -> f64 {
        (self.squares / self.count.max(1.0)).sqrt()
    }

    /// The greatest error.
    pub(super) const fn worst(&self) -> f64 {
        self.worst
    }

    /// The input of the greatest error.
    pub(super) const fn worst_input(&self) -> usize {
        self.worst_input
    }

    /// The mean of the bits that are off.
    pub(super) fn bits(&self) -> f64 {
        self.bits / self.count.max(1.0)
    }

    /// The time of one item, in nanoseconds, over the turns.
    pub(super) fn nanos(&self) -> Interval {
        Interval::of(if self.turns.is_empty() { &self.nanos } else { &self.turns })
    }
}

/// The middle of some times; 0 without any.
fn median(times: &[f64]) -> f64 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::pause;

    #[test]
    fn bits_count_the_numbers_between() {
        assert_eq!(bits_off(1.0, 1.0), 0.0);
        assert_eq!(bits_off(0.0, -0.0), 0.0);
        assert_eq!(bits_off(1.0, 1.0 + f64::EPSILON), 1.0);
        assert_eq!(bits_off(1.0, 1.0 + 7.0 * f64::EPSILON), 3.0);
        assert_eq!(bits_off(f64::NAN, 1.0), 64.0);
        // From −0 to 2, across zero: 2^62 numbers.
        assert_eq!(bits_off(-0.0, 2.0), 62.0);
        assert!((bits_off(-2.0, 2.0) - 63.0).abs() < 1e-9);
        // One rounding to single precision: 29 bits of 53 are lost, and it's off by half an ulp at most.
        assert!(bits_off(f64::from(0.1f32), 0.1) < 28.1);
    }

    #[test]
    fn a_trial_has_the_mean_square_and_the_worst() {
        let watch = Watch { slice: Duration::ZERO, tick: clock::resolution(), progress: Progress::default() };
        let mut trial = Trial::default();
        let results = trial.time(&watch, &[1.0, 2.0, 3.0], |x| x * 2.0);
        assert_eq!(results, [2.0, 4.0, 6.0]);
        for (i, error) in [3.0, 4.0, 0.0].into_iter().enumerate() {
            trial.note(i, Off { error, bits: 2.0 });
        }
        assert_eq!(trial.error(), (25.0f64 / 3.0).sqrt());
        assert_eq!((trial.worst(), trial.worst_input(), trial.bits()), (4.0, 1, 2.0));
        assert!(trial.nanos().median > 0.0);
    }

    #[test]
    fn pauses_are_not_timed() {
        let nap = || std::thread::sleep(Duration::from_millis(2));
        let work = async {
            nap();
            pause().await;
            nap();
            7
        };
        let mut trial = Trial::default();
        {
            let mut timed = pin!(trial.time_slices(4, work));
            let mut context = std::task::Context::from_waker(std::task::Waker::noop());
            assert!(timed.as_mut().poll(&mut context).is_pending());
            // So long that a slow machine doesn't take it for the naps.
            std::thread::sleep(Duration::from_secs(1));
            assert_eq!(timed.as_mut().poll(&mut context), std::task::Poll::Ready(7));
        }
        assert!((1e6..200e6).contains(&trial.nanos().median), "{:?}", trial.nanos());
    }

    #[test]
    fn work_too_short_for_a_coarse_clock_is_timed_in_batches() {
        // Ten milliseconds of any work take a measurable time.
        let watch = Watch { slice: Duration::ZERO, tick: Duration::from_millis(1), progress: Progress::default() };
        let (mut trial, mut passes) = (Trial::default(), 0_u32);
        let start = clock::now();
        trial.time_whole(&watch, 1, || passes = black_box(passes) + 1);
        let longest = (clock::now() - start).as_secs_f64() * 1e9;
        assert!(passes > 1000 && trial.nanos().median > 0.0, "{passes} passes");
        assert!(trial.nanos().median * f64::from(passes / 2 - 1) <= longest, "the last batch is half of all passes");
        let mut long = Trial::default();
        let once = |count: &mut u32| {
            *count += 1;
            std::thread::sleep(Duration::from_millis(11));
        };
        let mut count = 0;
        long.time_whole(&watch, 1, || once(&mut count));
        assert!(count == 1 && long.nanos().median >= 11e6, "{count}");
    }
}
