//! Does jobs without threads, a slice of them in each frame.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use super::shares::Shares;
use super::{Done, Make, Running, Shared, Slices, Work};
use crate::Wake;

/// Time for jobs in a frame, between steps of the animation.
const SLICE: Duration = Duration::from_millis(30);

/// If the frames themselves take longer, jobs get as much time as they, up to this. Users feel longer delays.
const LONGEST_SLICE: Duration = Duration::from_millis(100);

/// If a slice of a similar job took this long, a frame announces the job first.
const LONG: Duration = Duration::from_millis(500);

/// The backend that does the jobs in the frames.
pub(super) struct InFrames<Job, Outcome, const SLOTS: usize> {
    work: Work<Job, Outcome>,
    /// The window of the next frame.
    window: Box<dyn Wake>,
    shares: Shares<SLOTS>,
    under_way: Option<RunningJob<Outcome>>,
    /// When the last slice ended, if another follows in the next frame.
    ended: Option<Duration>,
    /// The longest slice of the last job of each slot.
    longest: [Duration; SLOTS],
    /// The slot whose long job has been announced in a frame.
    announced: Option<usize>,
}

/// A job that has been begun.
struct RunningJob<Outcome> {
    slot: usize,
    slices: Slices<Outcome>,
    /// The total time of its slices.
    time: Duration,
    /// The time of the longest of them.
    longest: Duration,
}

impl<Job: 'static, Outcome: 'static, const SLOTS: usize> InFrames<Job, Outcome, SLOTS> {
    pub(super) fn new(window: &dyn Wake, work: Work<Job, Outcome>) -> Self {
        Self {
            work,
            window: window.handle(),
            shares: Shares::default(),
            under_way: None,
            ended: None,
            longest: [Duration::ZERO; SLOTS],
            announced: None,
        }
    }

    /// A long job done in one slice, which therefore has to be announced before it begins.
    pub(super) fn announced(&self) -> Option<Running> {
        self.announced.map(|slot| Running { slot, time: self.longest[slot], now: None })
    }

    /// Goes on with the waiting jobs, and requests another frame if some are left.
    pub(super) fn go_on(
        &mut self,
        shared: &Shared<Job, Outcome, SLOTS>,
        make: &Make<Job, Outcome>,
        clock: fn() -> Duration,
    ) {
        let begin = clock();
        let slice = self.ended.take().map_or(SLICE, |ended| begin.saturating_sub(ended).clamp(SLICE, LONGEST_SLICE));
        while let Some(mut job) = self.under_way.take().or_else(|| self.next(shared, clock)) {
            match self.slice(&mut job, make, clock) {
                Poll::Pending => self.under_way = Some(job),
                Poll::Ready(outcome) => {
                    let RunningJob { slot, time, longest, .. } = job;
                    self.shares.book(slot, time);
                    self.longest[slot] = longest;
                    shared.mailbox().end(slot, Done { outcome, time });
                }
            }
            if clock().saturating_sub(begin) >= slice {
                break;
            }
        }
        if shared.mailbox().any_pending() {
            self.ended = Some(clock());
            self.window.wake();
        }
    }

    /// The next job. `None` if none waits, or if it has to be announced first.
    fn next(&mut self, shared: &Shared<Job, Outcome, SLOTS>, clock: fn() -> Duration) -> Option<RunningJob<Outcome>> {
        let slot = self.shares.next(shared.mailbox().waiting())?;
        let is_told = self.announced.take() == Some(slot);
        if self.longest[slot] >= LONG && !is_told {
            self.announced = Some(slot);
            return None;
        }
        let progress = &shared.progress[slot];
        let job = shared.mailbox().begin(slot, progress, clock)?;
        let slices = (self.work)(job, progress.clone());
        Some(RunningJob { slot, slices, time: Duration::ZERO, longest: Duration::ZERO })
    }

    /// Does a slice of a job. A job that has panicked has no outcome, and its half-done parts are created again.
    fn slice(
        &mut self,
        job: &mut RunningJob<Outcome>,
        make: &Make<Job, Outcome>,
        clock: fn() -> Duration,
    ) -> Poll<Option<Outcome>> {
        let start = clock();
        let mut context = Context::from_waker(Waker::noop());
        let polled = catch_unwind(AssertUnwindSafe(|| job.slices.as_mut().poll(&mut context)));
        let time = clock().saturating_sub(start);
        job.time += time;
        job.longest = job.longest.max(time);
        let outcome = match polled {
            Ok(Poll::Pending) => return Poll::Pending,
            Ok(Poll::Ready(outcome)) => outcome,
            Err(_) => None,
        };
        if outcome.is_none() {
            self.work = make();
        }
        Poll::Ready(outcome)
    }
}
