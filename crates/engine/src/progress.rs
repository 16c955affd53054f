//! Progress and cancellation of long work, shared by the code that does it and the code that waits for it.
//!
//! Without threads, long work is done in slices, with other work between them. It's written as a future, which pauses
//! after each step. Nothing wakes it: its worker [polls](Future::poll) it when there is time, or does it [all at
//! once](at_once).

use std::future::poll_fn;
use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicUsize, Ordering};
use std::task::{Context, Poll, Waker};

crate::listed! {
    /// A kind of long work.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Activity {
        /// A mesh file is read.
        Reading,
        /// Faces are put in order.
        Ordering,
        /// Pixels are painted.
        Painting,
        /// A picture is made into a file.
        Encoding,
        /// Errors and times of methods are measured.
        Measuring,
    }
}

/// The progress of one piece of work. A clone is of the same work. Results never depend on it, but for cancellation.
#[derive(Clone, Debug, Default)]
pub struct Progress {
    cancelled: Arc<AtomicBool>,
    steps: Arc<StepCounts>,
}

/// Each value has a meaning by itself, so no order between them is needed.
#[derive(Debug, Default)]
struct StepCounts {
    /// The index of the present activity, from 1. 0 if there's nothing to report.
    doing: AtomicU8,
    done: AtomicUsize,
    of: AtomicUsize,
}

impl Progress {
    /// The work was cancelled.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// A part of the work, which has steps of its own and is given up with the whole.
    #[must_use]
    pub fn part(&self) -> Self {
        Self { cancelled: Arc::clone(&self.cancelled), steps: Arc::default() }
    }

    /// True if the work is to end soon. Its result is discarded.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Other work begins, and isn't cancelled.
    pub fn begin_anew(&self) {
        self.steps.doing.store(0, Ordering::Relaxed);
        self.cancelled.store(false, Ordering::Relaxed);
    }

    /// Starts an activity of this number of steps. 0 means unknown.
    pub fn begin(&self, doing: Activity, steps: usize) {
        self.steps.of.store(0, Ordering::Relaxed);
        self.steps.done.store(0, Ordering::Relaxed);
        self.steps.of.store(steps, Ordering::Relaxed);
        let index = Activity::ALL.iter().position(|&d| d == doing).and_then(|i| u8::try_from(i + 1).ok());
        self.steps.doing.store(index.unwrap_or(0), Ordering::Relaxed);
    }

    /// Starts one of several passes, each an equal share of an activity. This one has a number of steps.
    pub fn begin_pass(&self, doing: Activity, steps: usize, [pass, passes]: [usize; 2]) {
        self.begin(doing, 0);
        self.advance(steps * pass);
        self.steps.of.store(steps * passes, Ordering::Relaxed);
    }

    /// More steps are done.
    pub fn advance(&self, steps: usize) {
        self.steps.done.fetch_add(steps, Ordering::Relaxed);
    }

    /// Records more steps done, and pauses work that is done in slices.
    pub async fn advance_and_pause(&self, steps: usize) {
        self.advance(steps);
        pause().await;
    }

    /// The present activity, and its share done, if known.
    pub fn now(&self) -> Option<(Activity, Option<f32>)> {
        let doing = *Activity::ALL.get(usize::from(self.steps.doing.load(Ordering::Relaxed)).checked_sub(1)?)?;
        let (done, of) = (self.steps.done.load(Ordering::Relaxed), self.steps.of.load(Ordering::Relaxed));
        let share = (of > 0).then(|| (done as f32 / of as f32).min(1.0));
        Some((doing, share))
    }
}

/// Is pending once, to end a slice of work.
pub async fn pause() {
    let mut paused = false;
    poll_fn(|_| if std::mem::replace(&mut paused, true) { Poll::Ready(()) } else { Poll::Pending }).await;
}

/// Does work that pauses, without the pauses. Work that waits for anything but [`pause`] would keep a processor busy.
pub fn at_once<T>(work: impl Future<Output = T>) -> T {
    let mut work = pin!(work);
    loop {
        if let Poll::Ready(outcome) = work.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return outcome;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_is_a_slice_and_all_of_them_are_done_at_once_too() {
        let progress = Progress::default();
        let work = || async {
            progress.begin(Activity::Measuring, 3);
            for _ in 0..3 {
                progress.advance_and_pause(1).await;
            }
            progress.now()
        };
        let whole = Some((Activity::Measuring, Some(1.0)));
        assert_eq!(at_once(work()), whole);
        let mut slices = pin!(work());
        let mut slice = || slices.as_mut().poll(&mut Context::from_waker(Waker::noop()));
        for done in 1..=3_u8 {
            assert!(slice().is_pending());
            assert_eq!(progress.now(), Some((Activity::Measuring, Some(f32::from(done) / 3.0))));
        }
        assert_eq!(slice(), Poll::Ready(whole));
    }

    #[test]
    fn passes_are_equal_shares_however_many_steps_they_have() {
        let progress = Progress::default();
        let mut shares = Vec::new();
        for (pass, steps) in [4, 1, 10].into_iter().enumerate() {
            progress.begin_pass(Activity::Painting, steps, [pass, 3]);
            shares.push(progress.now());
            progress.advance(steps);
            shares.push(progress.now());
        }
        let share = |thirds: f32| Some((Activity::Painting, Some(thirds / 3.0)));
        assert_eq!(shares, [0.0, 1.0, 1.0, 2.0, 2.0, 3.0].map(share));
    }

    #[test]
    fn a_part_has_its_own_steps_and_is_given_up_with_the_whole() {
        let whole = Progress::default();
        let part = whole.part();
        whole.begin(Activity::Encoding, 2);
        part.begin(Activity::Painting, 4);
        part.advance(4);
        assert_eq!(whole.now(), Some((Activity::Encoding, Some(0.0))));
        whole.cancel();
        assert!(part.is_cancelled());
    }

    #[test]
    fn a_clone_is_of_the_same_work_and_what_comes_next_is_wanted() {
        let (work, waits) = (Progress::default(), Progress::default());
        let seen = work.clone();
        assert_eq!(seen.now(), None);
        work.begin(Activity::Painting, 4);
        work.advance(1);
        assert_eq!(seen.now(), Some((Activity::Painting, Some(0.25))));
        work.begin(Activity::Ordering, 0);
        assert_eq!(seen.now(), Some((Activity::Ordering, None)));
        seen.cancel();
        assert!(work.is_cancelled() && !waits.is_cancelled());
        work.begin_anew();
        assert!(!seen.is_cancelled() && seen.now().is_none());
    }
}
