//! Work that is done beside the window's thread, or in slices in the frames if there are no threads.

mod in_frames;
mod shares;

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use in_frames::InFrames;

use crate::Wake;
use crate::progress::{Activity, Progress, at_once};

/// Begins jobs, one at a time.
type Work<Job, Outcome> = Box<dyn FnMut(Job, Progress) -> Slices<Outcome>>;

/// Creates the function that does the jobs.
type Make<Job, Outcome> = Arc<dyn Fn() -> Work<Job, Outcome> + Send + Sync>;

/// A running job, which ends a slice at each [pause](crate::progress::pause).
type Slices<Outcome> = std::pin::Pin<Box<dyn Future<Output = Option<Outcome>>>>;

/// Work done by `work`, with its state from one job to the next.
fn one_by_one<Job: 'static, Outcome: 'static>(
    work: impl AsyncFnMut(Job, &Progress) -> Outcome + 'static,
) -> Work<Job, Outcome> {
    let kept = Rc::new(std::cell::Cell::new(Some(work)));
    Box::new(move |job, progress| {
        let kept = Rc::clone(&kept);
        Box::pin(async move {
            // It's there because no job begins before the last one has ended, and after a panic all of it is created
            // again.
            let mut work = kept.take()?;
            let outcome = work(job, &progress).await;
            kept.set(Some(work));
            Some(outcome)
        })
    })
}

/// Does the jobs of each slot one after the other, and those of several slots side by side. Of each slot the latest job
/// wins, so one that hasn't been started is dropped when the next comes. Without threads every waiting slot gets the
/// same share of the time, so that a light job isn't as late as a heavy one, and none starves.
pub struct Worker<Job, Outcome, const SLOTS: usize = 1> {
    shared: Arc<Shared<Job, Outcome, SLOTS>>,
    place: Backend<Job, Outcome, SLOTS>,
    name: &'static str,
    make: Make<Job, Outcome>,
    clock: fn() -> Duration,
}

/// The place of the work.
enum Backend<Job, Outcome, const SLOTS: usize> {
    /// On a thread for each slot, begun with its first job. True for existing threads.
    Threads([bool; SLOTS]),
    /// In the frames.
    InFrames(InFrames<Job, Outcome, SLOTS>),
}

/// A job that has been done.
pub struct Done<Outcome> {
    /// The result. `None` if the work panicked.
    pub outcome: Option<Outcome>,
    /// Its duration.
    pub time: Duration,
}

/// A running job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Running {
    /// Its slot, from 0.
    pub slot: usize,
    /// Its duration. For work in one slice in a frame, that of the last one.
    pub time: Duration,
    /// The activity, and its finished share, if known.
    pub now: Option<(Activity, Option<f32>)>,
}

struct Shared<Job, Outcome, const SLOTS: usize> {
    progress: [Progress; SLOTS],
    mailbox: Mutex<Mailbox<Job, Outcome, SLOTS>>,
    wake: Condvar,
    done: Condvar,
}

struct Mailbox<Job, Outcome, const SLOTS: usize> {
    wanted: [Option<Job>; SLOTS],
    /// The slots with running jobs, and their start.
    busy: [Option<Duration>; SLOTS],
    /// Slots with cancelled jobs, whose results are still taken.
    cancelled: [bool; SLOTS],
    finished: [Option<Done<Outcome>>; SLOTS],
    /// True if the window waits for `done`, and needs no other call.
    waited_for: bool,
    quit: bool,
}

impl<Job, Outcome, const SLOTS: usize> Default for Shared<Job, Outcome, SLOTS> {
    fn default() -> Self {
        let mailbox = Mailbox {
            wanted: std::array::from_fn(|_| None),
            busy: [None; SLOTS],
            cancelled: [false; SLOTS],
            finished: std::array::from_fn(|_| None),
            waited_for: false,
            quit: false,
        };
        Self {
            progress: std::array::from_fn(|_| Progress::default()),
            mailbox: Mutex::new(mailbox),
            wake: Condvar::new(),
            done: Condvar::new(),
        }
    }
}

impl<Job, Outcome, const SLOTS: usize> Shared<Job, Outcome, SLOTS> {
    /// A panic could leave only parts that are replaced as a whole, so a poisoned lock is as good as any.
    fn mailbox(&self) -> MutexGuard<'_, Mailbox<Job, Outcome, SLOTS>> {
        self.mailbox.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<Job, Outcome, const SLOTS: usize> Mailbox<Job, Outcome, SLOTS> {
    fn is_pending(&self, slot: usize) -> bool {
        self.busy[slot].is_some() || self.wanted[slot].is_some()
    }

    fn any_pending(&self) -> bool {
        (0..SLOTS).any(|slot| self.is_pending(slot))
    }

    /// Slots whose next job can begin.
    fn waiting(&self) -> [bool; SLOTS] {
        std::array::from_fn(|slot| self.wanted[slot].is_some() && self.busy[slot].is_none())
    }

    /// Takes the job of a slot to do it. While the mailbox is locked, a cancellation means this job.
    fn begin(&mut self, slot: usize, progress: &Progress, clock: fn() -> Duration) -> Option<Job> {
        let job = self.wanted[slot].take()?;
        self.busy[slot] = Some(clock());
        progress.begin_anew();
        if std::mem::take(&mut self.cancelled[slot]) {
            progress.cancel();
        }
        Some(job)
    }

    /// Keeps the result of the job of a slot.
    fn end(&mut self, slot: usize, done: Done<Outcome>) {
        self.busy[slot] = None;
        self.finished[slot] = Some(done);
    }
}

impl<Job: Send + 'static, Outcome: Send + 'static, const SLOTS: usize> Worker<Job, Outcome, SLOTS> {
    /// `make` creates the function that does the jobs of a slot, on its thread, with the first job and again after a
    /// panic. Without threads, there is one for all slots. `name` names the threads.
    pub fn new<W: AsyncFnMut(Job, &Progress) -> Outcome + 'static>(
        name: &'static str,
        clock: fn() -> Duration,
        make: impl Fn() -> W + Send + Sync + 'static,
    ) -> Self {
        Self {
            shared: Arc::new(Shared::default()),
            place: Backend::Threads([false; SLOTS]),
            name,
            make: Arc::new(move || one_by_one(make())),
            clock,
        }
    }

    /// A worker for the same jobs, with nothing to do. The jobs of this one are no longer wanted, and one that hangs
    /// holds up nothing.
    #[must_use]
    pub fn restarted(&self) -> Self {
        let shared = Arc::new(Shared::default());
        Self {
            shared,
            place: Backend::Threads([false; SLOTS]),
            name: self.name,
            make: Arc::clone(&self.make),
            clock: self.clock,
        }
    }

    /// Does the jobs in the frames, as in a page without threads.
    #[must_use]
    pub fn without_thread(mut self, window: &dyn Wake) -> Self {
        self.place = Backend::InFrames(InFrames::new(window, (self.make)()));
        self
    }

    /// Requests a job. Requests a frame of `window` when it's done.
    pub fn ask(&mut self, window: &dyn Wake, slot: usize, job: Job) {
        if let Backend::Threads(begun) = &mut self.place
            && !begun[slot]
        {
            let (shared, wake, clock) = (Arc::clone(&self.shared), window.handle(), self.clock);
            let make = Arc::clone(&self.make);
            let thread = std::thread::Builder::new().name(self.name.to_owned());
            match thread.spawn(move || work(&shared, slot, &*wake, &make, clock)) {
                Ok(_) => begun[slot] = true,
                Err(_) if begun.contains(&true) => {
                    // The existing threads continue, and this job counts as not done.
                    self.shared.mailbox().end(slot, Done { outcome: None, time: Duration::ZERO });
                    window.wake();
                    return;
                }
                Err(_) => self.place = Backend::InFrames(InFrames::new(window, (self.make)())),
            }
        }
        let mut mailbox = self.shared.mailbox();
        mailbox.wanted[slot] = Some(job);
        mailbox.cancelled[slot] = false;
        drop(mailbox);
        self.shared.wake.notify_all();
        if matches!(self.place, Backend::InFrames(_)) {
            // The next frame does it, and nothing else may request one.
            window.wake();
        }
    }

    /// True if the last requested job isn't done yet.
    pub fn is_pending(&self, slot: usize) -> bool {
        self.shared.mailbox().is_pending(slot)
    }

    /// The job that has been running for the longest time, or one that the next frame will do and that takes long
    /// there.
    pub fn running(&self) -> Option<Running> {
        if let Backend::InFrames(in_frames) = &self.place
            && let Some(announced) = in_frames.announced()
        {
            return Some(announced);
        }
        let busy = self.shared.mailbox().busy;
        let (slot, since) =
            busy.iter().enumerate().filter_map(|(slot, since)| Some((slot, (*since)?))).min_by_key(|of| of.1)?;
        Some(Running { slot, time: (self.clock)().saturating_sub(since), now: self.shared.progress[slot].now() })
    }

    /// Cancels all requested jobs. Each one still ends, but soon.
    pub fn cancel(&self) {
        let mut mailbox = self.shared.mailbox();
        mailbox.cancelled = std::array::from_fn(|slot| mailbox.wanted[slot].is_some());
        let busy = mailbox.busy.iter().zip(&self.shared.progress).filter(|(since, _)| since.is_some());
        busy.for_each(|(_, progress)| progress.cancel());
    }

    /// Takes results. Waits up to `patience` for all.
    pub fn take(&mut self, patience: Duration) -> [Option<Done<Outcome>>; SLOTS] {
        let mut mailbox = self.shared.mailbox();
        match &mut self.place {
            Backend::Threads(_) if patience.is_zero() || !mailbox.any_pending() => {}
            Backend::Threads(_) => {
                mailbox.waited_for = true;
                let waiting = self.shared.done.wait_timeout_while(mailbox, patience, |mailbox| mailbox.any_pending());
                mailbox = match waiting {
                    Ok((mailbox, _)) => mailbox,
                    Err(poisoned) => poisoned.into_inner().0,
                };
                mailbox.waited_for = false;
            }
            Backend::InFrames(in_frames) => {
                drop(mailbox);
                in_frames.go_on(&self.shared, &self.make, self.clock);
                mailbox = self.shared.mailbox();
            }
        }
        std::array::from_fn(|slot| mailbox.finished[slot].take())
    }
}

impl<Job, Outcome, const SLOTS: usize> Drop for Worker<Job, Outcome, SLOTS> {
    fn drop(&mut self) {
        self.shared.mailbox().quit = true;
        self.shared.progress.iter().for_each(Progress::cancel);
        self.shared.wake.notify_all();
    }
}

impl<Job, Outcome, const SLOTS: usize> fmt::Debug for Worker<Job, Outcome, SLOTS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Worker").field("name", &self.name).finish_non_exhaustive()
    }
}

/// The thread of a slot.
fn work<Job, Outcome, const SLOTS: usize>(
    shared: &Shared<Job, Outcome, SLOTS>,
    slot: usize,
    window: &dyn Wake,
    make: &Make<Job, Outcome>,
    clock: fn() -> Duration,
) {
    let (mut work, progress) = (make(), &shared.progress[slot]);
    loop {
        let mut mailbox = shared.mailbox();
        let job = loop {
            if mailbox.quit {
                return;
            }
            if let Some(job) = mailbox.begin(slot, progress, clock) {
                break job;
            }
            mailbox = shared.wake.wait(mailbox).unwrap_or_else(PoisonError::into_inner);
        };
        drop(mailbox);

        let start = clock();
        // A panic here is a bug, but not one for which the window should freeze. Half-done parts are created again.
        let outcome = catch_unwind(AssertUnwindSafe(|| at_once(work(job, progress.clone())))).ok().flatten();
        if outcome.is_none() {
            work = make();
        }
        let time = clock().saturating_sub(start);

        let mut mailbox = shared.mailbox();
        mailbox.end(slot, Done { outcome, time });
        if !mailbox.waited_for {
            // Before a frame can take the outcome: afterwards, it would be one frame too many.
            window.wake();
        }
        drop(mailbox);
        shared.done.notify_one();
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::clock;

    const MINUTE: Duration = Duration::from_secs(60);

    /// Doubles numbers, counts them, and panics at 0.
    fn doubling<const SLOTS: usize>() -> Worker<u32, (u32, u32), SLOTS> {
        Worker::new("doubling", clock::now, || {
            let mut count = 0;
            async move |n, _: &Progress| {
                count += 1;
                assert_ne!(n, 0, "as the test wants it");
                (2 * n, count)
            }
        })
    }

    fn one<const SLOTS: usize>(worker: &mut Worker<u32, (u32, u32), SLOTS>, n: u32) -> Option<(u32, u32)> {
        worker.ask(&(), 0, n);
        let [done, ..] = worker.take(MINUTE).map(|done| done.unwrap().outcome)[..] else { panic!("a slot") };
        done
    }

    #[test]
    fn a_panic_resets_the_worker_on_a_thread_and_in_the_frame() {
        for mut worker in [doubling::<1>(), doubling::<1>().without_thread(&())] {
            assert_eq!(one(&mut worker, 4), Some((8, 1)));
            assert_eq!(one(&mut worker, 5), Some((10, 2)));
            assert_eq!(one(&mut worker, 0), None);
            assert!(!worker.is_pending(0));
            assert_eq!(one(&mut worker, 6), Some((12, 1)), "made anew");
        }
    }

    #[test]
    fn in_the_frame_each_slot_has_its_latest_job_done_when_it_is_taken() {
        let mut worker = doubling::<3>().without_thread(&());
        worker.ask(&(), 2, 1);
        worker.ask(&(), 0, 2);
        worker.ask(&(), 2, 3);
        assert!(worker.is_pending(2) && !worker.is_pending(1));
        let done = worker.take(Duration::ZERO).map(|done| done.and_then(|done| done.outcome));
        assert_eq!(done, [Some((4, 1)), None, Some((6, 2))]);
        assert!(worker.take(Duration::ZERO).iter().all(Option::is_none));
    }

    #[test]
    fn heavy_jobs_in_frames_are_announced_and_others_come_in_between() {
        static NOW: Mutex<Duration> = Mutex::new(Duration::ZERO);
        // Each job takes as many milliseconds as its number.
        let mut worker: Worker<u64, u64, 3> = Worker::new(
            "waiting",
            || *NOW.lock().unwrap(),
            || {
                async |job, _: &Progress| {
                    *NOW.lock().unwrap() += Duration::from_millis(job);
                    job
                }
            },
        )
        .without_thread(&());
        let mut frame = |asked: &[(usize, u64)]| {
            asked.iter().for_each(|(slot, job)| worker.ask(&(), *slot, *job));
            let done = worker.take(Duration::ZERO).map(|done| done.and_then(|done| done.outcome));
            (done, worker.running().map(|running| (running.slot, running.time)))
        };
        // Light ones at once, as many as fit into the time.
        assert_eq!(frame(&[(0, 10), (1, 25), (2, 10)]), ([Some(10), Some(25), None], None));
        assert_eq!(frame(&[]), ([None, None, Some(10)], None));
        // The worker doesn't know yet that this one takes long.
        assert_eq!(frame(&[(2, 700)]), ([None, None, Some(700)], None));
        // Now it knows, and light work comes before.
        assert_eq!(frame(&[(2, 800), (0, 40)]), ([Some(40), None, None], None));
        assert_eq!(frame(&[]), ([None; 3], Some((2, Duration::from_millis(700)))));
        assert_eq!(frame(&[]), ([None, None, Some(800)], None));
        assert_eq!(frame(&[]), ([None; 3], None));
    }

    #[test]
    fn in_the_frames_slices_show_how_far_they_are_and_are_given_up() {
        static NOW: Mutex<Duration> = Mutex::new(Duration::ZERO);
        // Four steps of twenty milliseconds, and the number of finished ones.
        let mut worker: Worker<u32, u32, 2> = Worker::new(
            "steps",
            || *NOW.lock().unwrap(),
            || {
                async |job, progress: &Progress| {
                    progress.begin(Activity::Measuring, 4);
                    let mut done = job;
                    for _ in 0..4 {
                        if progress.is_cancelled() {
                            break;
                        }
                        *NOW.lock().unwrap() += Duration::from_millis(20);
                        done += 1;
                        progress.advance_and_pause(1).await;
                    }
                    done
                }
            },
        )
        .without_thread(&());
        let measured = |share, millis| {
            let now = Some((Activity::Measuring, Some(share)));
            Some(Running { slot: 0, time: Duration::from_millis(millis), now })
        };
        let frame = |worker: &mut Worker<u32, u32, 2>| {
            worker.take(Duration::ZERO).map(|done| done.map(|done| (done.outcome.unwrap(), done.time.as_millis())))
        };
        worker.ask(&(), 0, 10);
        assert_eq!(frame(&mut worker), [None; 2]);
        assert_eq!(worker.running(), measured(0.5, 40));
        // Jobs requested meanwhile wait until it's done.
        worker.ask(&(), 1, 20);
        assert_eq!(frame(&mut worker), [None; 2]);
        assert_eq!(worker.running(), measured(1.0, 80));
        assert_eq!(frame(&mut worker), [Some((14, 80)), None]);
        assert!(worker.is_pending(1) && worker.running().is_some());
        worker.cancel();
        assert_eq!(frame(&mut worker), [None, Some((22, 40))]);
        assert!(!worker.is_pending(1) && worker.running().is_none());
        // A cancelled job is done when it's requested again. No slice of it took long, so it needn't be announced.
        worker.ask(&(), 1, 30);
        assert_eq!(frame(&mut worker), [None; 2]);
        assert_eq!(worker.running().map(|running| running.time.as_millis()), Some(40));
        // If the frame itself takes long, so does the slice.
        *NOW.lock().unwrap() += Duration::from_millis(50);
        assert_eq!(frame(&mut worker), [None, Some((34, 80))]);
    }

    #[test]
    fn jobs_of_several_slots_are_done_at_the_same_time() {
        let both = Arc::new(std::sync::Barrier::new(2));
        let mut worker: Worker<u32, u32, 2> = Worker::new("meeting", clock::now, move || {
            let both = Arc::clone(&both);
            async move |n, _: &Progress| {
                both.wait();
                n
            }
        });
        for slot in 0..2 {
            worker.ask(&(), slot, 7 + u32::try_from(slot).unwrap());
        }
        assert_eq!(worker.take(MINUTE).map(|done| done.unwrap().outcome), [Some(7), Some(8)]);
    }

    #[test]
    fn a_cancelled_job_ends_soon_and_the_next_one_is_done() {
        let mut worker: Worker<bool, bool, 2> = Worker::new("waiting", clock::now, || {
            async |waits, progress: &Progress| {
                while waits && !progress.is_cancelled() {
                    std::thread::yield_now();
                }
                progress.is_cancelled()
            }
        });
        worker.ask(&(), 0, true);
        worker.ask(&(), 1, true);
        let start = clock::now();
        while worker.running().is_none() && clock::now() - start < MINUTE {
            std::thread::yield_now();
        }
        assert!(worker.running().is_some());
        worker.cancel();
        let given_up = worker.take(MINUTE).map(|done| done.unwrap().outcome);
        assert_eq!(given_up, [Some(true), Some(true)]);
        worker.ask(&(), 0, false);
        assert_eq!(worker.take(MINUTE)[0].as_ref().unwrap().outcome, Some(false));
        assert_eq!(worker.running(), None);
    }

    #[test]
    fn the_window_is_called_when_it_does_not_wait() {
        #[derive(Clone)]
        struct Counted(Arc<Mutex<u32>>);
        impl Wake for Counted {
            fn wake_after(&self, _: Duration) {
                *self.0.lock().unwrap() += 1;
            }

            fn handle(&self) -> Box<dyn Wake> {
                Box::new(self.clone())
            }
        }
        let called = Arc::new(Mutex::new(0));
        let mut worker = doubling::<1>();
        worker.ask(&Counted(Arc::clone(&called)), 0, 1);
        let start = clock::now();
        while *called.lock().unwrap() == 0 && clock::now() - start < MINUTE {
            std::thread::yield_now();
        }
        assert_eq!(*called.lock().unwrap(), 1);
        assert_eq!(worker.take(Duration::ZERO)[0].as_ref().unwrap().outcome, Some((2, 1)));
    }
}
