//! Work that is done beside the window's thread, or, where there are no threads, in the frame.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use eframe::egui;

use crate::progress::{Doing, Progress};

/// What does the jobs, with what it keeps from one to the next.
pub(super) type Work<Job, Outcome> = Box<dyn FnMut(Job, &Progress) -> Outcome>;

/// Does one job after the other. Of each slot the latest job wins: one that has not been begun is forgotten when the next comes.
/// Every slot that waits gets the same share of the time: a light job is not as late as a heavy one, and none starves.
pub(super) struct Worker<Job, Outcome, const SLOTS: usize = 1> {
    shared: Arc<Shared<Job, Outcome, SLOTS>>,
    place: Place<Job, Outcome, SLOTS>,
    name: &'static str,
    make: fn() -> Work<Job, Outcome>,
    clock: fn() -> Duration,
    /// What the first job is expected to take.
    expected: Duration,
}

/// Where the work is done.
enum Place<Job, Outcome, const SLOTS: usize> {
    /// Nothing has been asked for.
    Nowhere,
    /// On a thread.
    Thread,
    /// In the frames.
    Here(Here<Job, Outcome, SLOTS>),
}

/// What does the jobs where there are no threads: in the frames, some of them in each.
struct Here<Job, Outcome, const SLOTS: usize> {
    work: Work<Job, Outcome>,
    /// What is asked for the next frame.
    ctx: egui::Context,
    shares: Shares<SLOTS>,
    /// What the last job of each slot took, or the first is expected to.
    took: [Duration; SLOTS],
    /// The slot whose job takes long, and of which that has been told in a frame.
    told: Option<usize>,
}

/// In a frame no further job is begun after this time: what people see moves on in between.
const SLICE: Duration = Duration::from_millis(30);

/// Before a job that is expected to take so long there is a frame that tells it.
const LONG: Duration = Duration::from_millis(500);

impl<Job, Outcome, const SLOTS: usize> Here<Job, Outcome, SLOTS> {
    fn new(ctx: &egui::Context, work: Work<Job, Outcome>, expected: Duration) -> Self {
        Self { work, ctx: ctx.clone(), shares: Shares::default(), took: [expected; SLOTS], told: None }
    }

    /// Does some of the jobs that wait, and asks for another frame where some are left.
    fn go_on(
        &mut self,
        shared: &Shared<Job, Outcome, SLOTS>,
        make: fn() -> Work<Job, Outcome>,
        clock: fn() -> Duration,
    ) {
        let begin = clock();
        let mut mailbox = shared.mailbox();
        while let Some(slot) = self.shares.next(std::array::from_fn(|slot| mailbox.wanted[slot].is_some())) {
            let is_told = self.told.take() == Some(slot);
            if self.took[slot] >= LONG && !is_told {
                self.told = Some(slot);
                break;
            }
            let Some(job) = mailbox.wanted[slot].take() else { break };
            shared.progress.begin_anew();
            if std::mem::take(&mut mailbox.cancelled[slot]) {
                shared.progress.cancel();
            }
            let done = carry_out(&mut self.work, job, &shared.progress, make, clock);
            self.shares.book(slot, done.time);
            self.took[slot] = done.time;
            mailbox.finished[slot] = Some(done);
            if clock().saturating_sub(begin) >= SLICE {
                break;
            }
        }
        if mailbox.any_pending() {
            self.ctx.request_repaint();
        }
    }
}

/// A job that has been done.
pub(super) struct Done<Outcome> {
    /// What came of it; `None` where the work panicked.
    pub(super) outcome: Option<Outcome>,
    /// How long it took.
    pub(super) time: Duration,
}

/// A job that is being done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Running {
    pub(super) slot: usize,
    /// For how long; in the frames, how long the last one took.
    pub(super) time: Duration,
    /// What is being done for it, and which share of that is done, where that is known.
    pub(super) now: Option<(Doing, Option<f32>)>,
}

struct Shared<Job, Outcome, const SLOTS: usize> {
    progress: Progress,
    mailbox: Mutex<Mailbox<Job, Outcome, SLOTS>>,
    wake: Condvar,
    done: Condvar,
}

struct Mailbox<Job, Outcome, const SLOTS: usize> {
    wanted: [Option<Job>; SLOTS],
    /// The slot whose job is being done, and since when.
    busy: Option<(usize, Duration)>,
    /// Slots whose jobs are not wanted any more, but for what comes of that.
    cancelled: [bool; SLOTS],
    finished: [Option<Done<Outcome>>; SLOTS],
    /// The window waits for `done`, and needs no other call.
    waited_for: bool,
    quit: bool,
}

impl<Job, Outcome, const SLOTS: usize> Shared<Job, Outcome, SLOTS> {
    /// What a panic could leave half done is replaced as a whole, so a poisoned lock is as good as any.
    fn mailbox(&self) -> MutexGuard<'_, Mailbox<Job, Outcome, SLOTS>> {
        self.mailbox.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<Job, Outcome, const SLOTS: usize> Mailbox<Job, Outcome, SLOTS> {
    fn is_pending(&self, slot: usize) -> bool {
        self.busy.is_some_and(|(busy, _)| busy == slot) || self.wanted[slot].is_some()
    }

    fn any_pending(&self) -> bool {
        (0..SLOTS).any(|slot| self.is_pending(slot))
    }
}

impl<Job: Send + 'static, Outcome: Send + 'static, const SLOTS: usize> Worker<Job, Outcome, SLOTS> {
    /// `make` makes what does the jobs: on the thread, with the first job, and anew after a panic. `name` is the thread's.
    pub(super) fn new(name: &'static str, clock: fn() -> Duration, make: fn() -> Work<Job, Outcome>) -> Self {
        let mailbox = Mailbox {
            wanted: std::array::from_fn(|_| None),
            busy: None,
            cancelled: [false; SLOTS],
            finished: std::array::from_fn(|_| None),
            waited_for: false,
            quit: false,
        };
        let shared = Arc::new(Shared {
            progress: Progress::default(),
            mailbox: Mutex::new(mailbox),
            wake: Condvar::new(),
            done: Condvar::new(),
        });
        Self { shared, place: Place::Nowhere, name, make, clock, expected: Duration::ZERO }
    }

    /// Expects the first job to take long already: where there are no threads, a frame tells it before.
    pub(super) fn taking_long(mut self) -> Self {
        self.expected = LONG;
        self
    }

    /// Does the jobs in the frame, as where there are no threads.
    #[cfg(test)]
    pub(super) fn without_thread(mut self, ctx: &egui::Context) -> Self {
        self.place = Place::Here(Here::new(ctx, (self.make)(), self.expected));
        self
    }

    /// Asks for a job; `ctx` is asked for a frame when it is done.
    pub(super) fn ask(&mut self, ctx: &egui::Context, slot: usize, job: Job) {
        if matches!(self.place, Place::Nowhere) {
            let (shared, wake, make, clock) = (Arc::clone(&self.shared), ctx.clone(), self.make, self.clock);
            let thread = std::thread::Builder::new().name(self.name.to_owned());
            self.place = match thread.spawn(move || work(&shared, &wake, make, clock)) {
                Ok(_) => Place::Thread,
                Err(_) => Place::Here(Here::new(ctx, make(), self.expected)),
            };
        }
        let mut mailbox = self.shared.mailbox();
        mailbox.wanted[slot] = Some(job);
        mailbox.cancelled[slot] = false;
        drop(mailbox);
        self.shared.wake.notify_one();
        if matches!(self.place, Place::Here(_)) {
            // It is done in the next frame: nothing else may call for one.
            ctx.request_repaint();
        }
    }

    /// True where the job that was asked for last has not been done.
    pub(super) fn is_pending(&self, slot: usize) -> bool {
        self.shared.mailbox().is_pending(slot)
    }

    /// The job that is being done, if any; in the frames, the one that is going to take long.
    pub(super) fn running(&self) -> Option<Running> {
        if let Place::Here(here) = &self.place {
            return here.told.map(|slot| Running { slot, time: here.took[slot], now: None });
        }
        let (slot, since) = self.shared.mailbox().busy?;
        Some(Running { slot, time: (self.clock)().saturating_sub(since), now: self.shared.progress.now() })
    }

    /// Says of all that has been asked for that it is not wanted any more. Each job still comes to its end, but soon.
    pub(super) fn cancel(&self) {
        let mut mailbox = self.shared.mailbox();
        mailbox.cancelled = std::array::from_fn(|slot| mailbox.wanted[slot].is_some());
        if mailbox.busy.is_some() {
            self.shared.progress.cancel();
        }
    }

    /// Takes what has been done. Waits up to `patience` until all is.
    pub(super) fn take(&mut self, patience: Duration) -> [Option<Done<Outcome>>; SLOTS] {
        let mut mailbox = self.shared.mailbox();
        match &mut self.place {
            Place::Nowhere => {}
            Place::Thread if patience.is_zero() || !mailbox.any_pending() => {}
            Place::Thread => {
                mailbox.waited_for = true;
                let waiting = self.shared.done.wait_timeout_while(mailbox, patience, |mailbox| mailbox.any_pending());
                mailbox = match waiting {
                    Ok((mailbox, _)) => mailbox,
                    Err(poisoned) => poisoned.into_inner().0,
                };
                mailbox.waited_for = false;
            }
            Place::Here(here) => {
                drop(mailbox);
                here.go_on(&self.shared, self.make, self.clock);
                mailbox = self.shared.mailbox();
            }
        }
        std::array::from_fn(|slot| mailbox.finished[slot].take())
    }
}

impl<Job, Outcome, const SLOTS: usize> Drop for Worker<Job, Outcome, SLOTS> {
    fn drop(&mut self) {
        self.shared.mailbox().quit = true;
        self.shared.progress.cancel();
        self.shared.wake.notify_one();
    }
}

impl<Job, Outcome, const SLOTS: usize> fmt::Debug for Worker<Job, Outcome, SLOTS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Worker").field("name", &self.name).finish_non_exhaustive()
    }
}

/// The thread.
fn work<Job, Outcome, const SLOTS: usize>(
    shared: &Shared<Job, Outcome, SLOTS>,
    ctx: &egui::Context,
    make: fn() -> Work<Job, Outcome>,
    clock: fn() -> Duration,
) {
    let mut work = make();
    let mut shares = Shares::<SLOTS>::default();
    loop {
        let mut mailbox = shared.mailbox();
        let (slot, job) = loop {
            if mailbox.quit {
                return;
            }
            let turn = shares.next(std::array::from_fn(|slot| mailbox.wanted[slot].is_some()));
            if let Some(next) = turn.and_then(|slot| mailbox.wanted[slot].take().map(|job| (slot, job))) {
                break next;
            }
            mailbox = shared.wake.wait(mailbox).unwrap_or_else(PoisonError::into_inner);
        };
        mailbox.busy = Some((slot, clock()));
        // While the mailbox is held, so that whoever cancels means this job.
        shared.progress.begin_anew();
        if std::mem::take(&mut mailbox.cancelled[slot]) {
            shared.progress.cancel();
        }
        drop(mailbox);

        let done = carry_out(&mut work, job, &shared.progress, make, clock);
        shares.book(slot, done.time);

        let mut mailbox = shared.mailbox();
        mailbox.busy = None;
        mailbox.finished[slot] = Some(done);
        let waited_for = mailbox.waited_for;
        drop(mailbox);
        shared.done.notify_one();
        if !waited_for {
            ctx.request_repaint();
        }
    }
}

/// A panic here is a bug, but not one for which the window should stand still for ever: what it left half done is made anew.
fn carry_out<Job, Outcome>(
    work: &mut Work<Job, Outcome>,
    job: Job,
    progress: &Progress,
    make: fn() -> Work<Job, Outcome>,
    clock: fn() -> Duration,
) -> Done<Outcome> {
    let start = clock();
    let outcome = catch_unwind(AssertUnwindSafe(|| work(job, progress))).ok();
    if outcome.is_none() {
        *work = make();
    }
    Done { outcome, time: clock().saturating_sub(start) }
}

/// How much time each slot has had, so that the next is the one that had least.
struct Shares<const SLOTS: usize> {
    had: [Duration; SLOTS],
    /// What the slot that came last had had before: one that has not waited gets no credit for it.
    floor: Duration,
}

impl<const SLOTS: usize> Default for Shares<SLOTS> {
    fn default() -> Self {
        Self { had: [Duration::ZERO; SLOTS], floor: Duration::ZERO }
    }
}

impl<const SLOTS: usize> Shares<SLOTS> {
    fn next(&mut self, waiting: [bool; SLOTS]) -> Option<usize> {
        for slot in (0..SLOTS).filter(|&slot| waiting[slot]) {
            self.had[slot] = self.had[slot].max(self.floor);
        }
        let next = (0..SLOTS).filter(|&slot| waiting[slot]).min_by_key(|&slot| self.had[slot])?;
        self.floor = self.had[next];
        Some(next)
    }

    fn book(&mut self, slot: usize, time: Duration) {
        self.had[slot] += time;
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
            Box::new(move |n, _| {
                count += 1;
                assert_ne!(n, 0, "as the test wants it");
                (2 * n, count)
            })
        })
    }

    fn one<const SLOTS: usize>(worker: &mut Worker<u32, (u32, u32), SLOTS>, n: u32) -> Option<(u32, u32)> {
        worker.ask(&egui::Context::default(), 0, n);
        let [done, ..] = worker.take(MINUTE).map(|done| done.unwrap().outcome)[..] else { panic!("a slot") };
        done
    }

    #[test]
    fn a_panic_resets_what_does_the_work_on_a_thread_and_in_the_frame() {
        for mut worker in [doubling::<1>(), doubling::<1>().without_thread(&egui::Context::default())] {
            assert_eq!(one(&mut worker, 4), Some((8, 1)));
            assert_eq!(one(&mut worker, 5), Some((10, 2)));
            assert_eq!(one(&mut worker, 0), None);
            assert!(!worker.is_pending(0));
            assert_eq!(one(&mut worker, 6), Some((12, 1)), "made anew");
        }
    }

    #[test]
    fn in_the_frame_each_slot_has_its_latest_job_done_when_it_is_taken() {
        let ctx = egui::Context::default();
        let mut worker = doubling::<3>().without_thread(&ctx);
        worker.ask(&ctx, 2, 1);
        worker.ask(&ctx, 0, 2);
        worker.ask(&ctx, 2, 3);
        assert!(worker.is_pending(2) && !worker.is_pending(1));
        let done = worker.take(Duration::ZERO).map(|done| done.and_then(|done| done.outcome));
        assert_eq!(done, [Some((4, 1)), None, Some((6, 2))]);
        assert!(worker.take(Duration::ZERO).iter().all(Option::is_none));
    }

    #[test]
    fn in_the_frames_heavy_jobs_are_told_before_and_others_come_in_between() {
        static NOW: Mutex<Duration> = Mutex::new(Duration::ZERO);
        let ctx = egui::Context::default();
        // Each job takes as many milliseconds as it is told.
        let mut worker: Worker<u64, u64, 3> = Worker::new(
            "waiting",
            || *NOW.lock().unwrap(),
            || {
                Box::new(|job, _| {
                    *NOW.lock().unwrap() += Duration::from_millis(job);
                    job
                })
            },
        )
        .without_thread(&ctx);
        let mut frame = |asked: &[(usize, u64)]| {
            asked.iter().for_each(|(slot, job)| worker.ask(&ctx, *slot, *job));
            let done = worker.take(Duration::ZERO).map(|done| done.and_then(|done| done.outcome));
            (done, worker.running().map(|running| (running.slot, running.time)))
        };
        // Light ones at once, as many as there is time for.
        assert_eq!(frame(&[(0, 10), (1, 25), (2, 10)]), ([Some(10), Some(25), None], None));
        assert_eq!(frame(&[]), ([None, None, Some(10)], None));
        // Nobody knows that this one takes long.
        assert_eq!(frame(&[(2, 700)]), ([None, None, Some(700)], None));
        // Now it is known, and what is light comes before.
        assert_eq!(frame(&[(2, 800), (0, 40)]), ([Some(40), None, None], None));
        assert_eq!(frame(&[]), ([None; 3], Some((2, Duration::from_millis(700)))));
        assert_eq!(frame(&[]), ([None, None, Some(800)], None));
        assert_eq!(frame(&[]), ([None; 3], None));
    }

    #[test]
    fn what_takes_long_is_told_the_first_time_too() {
        let ctx = egui::Context::default();
        let mut worker = doubling::<1>().taking_long().without_thread(&ctx);
        worker.ask(&ctx, 0, 1);
        assert!(worker.take(Duration::ZERO)[0].is_none() && worker.running().is_some(), "a frame that tells it");
        assert_eq!(worker.take(Duration::ZERO)[0].as_ref().unwrap().outcome, Some((2, 1)));
        assert_eq!(worker.running(), None);
        // It was light.
        worker.ask(&ctx, 0, 2);
        assert_eq!(worker.take(Duration::ZERO)[0].as_ref().unwrap().outcome, Some((4, 2)));
    }

    #[test]
    fn what_is_given_up_ends_soon_and_what_is_asked_for_then_is_done() {
        let mut worker: Worker<bool, bool, 2> = Worker::new("waiting", clock::now, || {
            Box::new(|waits, progress| {
                while waits && !progress.is_cancelled() {
                    std::thread::yield_now();
                }
                progress.is_cancelled()
            })
        });
        let ctx = egui::Context::default();
        worker.ask(&ctx, 0, true);
        worker.ask(&ctx, 1, true);
        let start = clock::now();
        while worker.running().is_none() && clock::now() - start < MINUTE {
            std::thread::yield_now();
        }
        assert!(worker.running().is_some());
        worker.cancel();
        let given_up = worker.take(MINUTE).map(|done| done.unwrap().outcome);
        assert_eq!(given_up, [Some(true), Some(true)]);
        worker.ask(&ctx, 0, false);
        assert_eq!(worker.take(MINUTE)[0].as_ref().unwrap().outcome, Some(false));
        assert_eq!(worker.running(), None);
    }

    #[test]
    fn the_window_is_called_when_it_does_not_wait() {
        let ctx = egui::Context::default();
        let called = Arc::new(Mutex::new(0));
        let count = Arc::clone(&called);
        ctx.set_request_repaint_callback(move |_| *count.lock().unwrap() += 1);
        let mut worker = doubling::<1>();
        worker.ask(&ctx, 0, 1);
        let start = clock::now();
        while *called.lock().unwrap() == 0 && clock::now() - start < MINUTE {
            std::thread::yield_now();
        }
        assert_eq!(*called.lock().unwrap(), 1);
        assert_eq!(worker.take(Duration::ZERO)[0].as_ref().unwrap().outcome, Some((2, 1)));
    }

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
        // One that had nothing to do for long has no right to all the time after that.
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
