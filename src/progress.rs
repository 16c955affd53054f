//! How far long work has come, and whether it is still wanted: shared by whoever does it and whoever waits for it.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicUsize, Ordering};

/// What takes long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
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

impl Doing {
    /// Everything that takes long.
    pub const ALL: [Self; 5] = [Self::Reading, Self::Ordering, Self::Painting, Self::Encoding, Self::Measuring];
}

/// How far one piece of work has come. A clone is of the same work. What is done never depends on it, but for being given up.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<State>);

/// Each value says something by itself: no order between them is needed.
#[derive(Debug, Default)]
struct State {
    cancelled: AtomicBool,
    /// The index of what is being done, from 1; 0: nothing that is told.
    doing: AtomicU8,
    done: AtomicUsize,
    of: AtomicUsize,
}

impl Progress {
    /// The work is not wanted any more.
    pub fn cancel(&self) {
        self.0.cancelled.store(true, Ordering::Relaxed);
    }

    /// True where the work is to end soon; what comes of it is thrown away.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.0.cancelled.load(Ordering::Relaxed)
    }

    /// Other work begins, and is wanted.
    pub fn begin_anew(&self) {
        self.0.doing.store(0, Ordering::Relaxed);
        self.0.cancelled.store(false, Ordering::Relaxed);
    }

    /// Says what is done from now on, and how many steps that takes; 0: nobody knows.
    pub fn begin(&self, doing: Doing, steps: usize) {
        self.0.of.store(0, Ordering::Relaxed);
        self.0.done.store(0, Ordering::Relaxed);
        self.0.of.store(steps, Ordering::Relaxed);
        let index = Doing::ALL.iter().position(|&d| d == doing).and_then(|i| u8::try_from(i + 1).ok());
        self.0.doing.store(index.unwrap_or(0), Ordering::Relaxed);
    }

    /// More steps are done.
    pub fn advance(&self, steps: usize) {
        self.0.done.fetch_add(steps, Ordering::Relaxed);
    }

    /// What is being done, and which share of it has been, where that is known.
    #[must_use]
    pub fn now(&self) -> Option<(Doing, Option<f32>)> {
        let doing = *Doing::ALL.get(usize::from(self.0.doing.load(Ordering::Relaxed)).checked_sub(1)?)?;
        let (done, of) = (self.0.done.load(Ordering::Relaxed), self.0.of.load(Ordering::Relaxed));
        #[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
        let share = (of > 0).then(|| (done as f32 / of as f32).min(1.0));
        Some((doing, share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clone_is_of_the_same_work_and_what_comes_next_is_wanted() {
        let (work, waits) = (Progress::default(), Progress::default());
        let seen = work.clone();
        assert_eq!(seen.now(), None);
        work.begin(Doing::Painting, 4);
        work.advance(1);
        assert_eq!(seen.now(), Some((Doing::Painting, Some(0.25))));
        work.begin(Doing::Ordering, 0);
        assert_eq!(seen.now(), Some((Doing::Ordering, None)));
        seen.cancel();
        assert!(work.is_cancelled() && !waits.is_cancelled());
        work.begin_anew();
        assert!(!seen.is_cancelled() && seen.now().is_none());
    }
}
