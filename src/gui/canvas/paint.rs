//! Has pictures drawn beside the window's thread, each only when something that made it has changed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use eframe::egui;

use super::easel::{Easel, Job, Sheet};
use crate::views::View;

/// Draws pictures, on a thread of its own where there are threads.
pub(super) struct Painter {
    shared: Arc<Shared>,
    threaded: bool,
    /// What was asked for last, by picture.
    asked: [Option<Job>; 3],
    /// How many pictures have been drawn, by picture.
    drawn: [u64; 3],
    /// What the last drawing of each picture took, and the last one that was no draft.
    cost: [Duration; 3],
    full_cost: [Duration; 3],
    /// For where there are no threads.
    easel: Easel,
}

#[derive(Default)]
struct Shared {
    desk: Mutex<Desk>,
    wake: Condvar,
    done: Condvar,
}

#[derive(Default)]
struct Desk {
    wanted: [Option<Job>; 3],
    busy: Option<usize>,
    finished: [Option<Finished>; 3],
    /// The window waits for `done`, and needs no other call.
    waited_for: bool,
    quit: bool,
}

struct Finished {
    sheet: Option<Sheet>,
    cost: Duration,
    draft: bool,
}

impl Shared {
    /// What a panic could leave half done is replaced as a whole, so a poisoned lock is as good as any.
    fn desk(&self) -> MutexGuard<'_, Desk> {
        self.desk.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Desk {
    fn pending(&self) -> bool {
        self.busy.is_some() || self.wanted.iter().any(Option::is_some)
    }
}

impl Painter {
    /// Starts the thread that draws; `ctx` is asked for a frame whenever a picture is done.
    pub(super) fn new(ctx: &egui::Context) -> Self {
        let shared = Arc::new(Shared::default());
        let (theirs, ctx) = (Arc::clone(&shared), ctx.clone());
        let threaded =
            std::thread::Builder::new().name("pictures".to_owned()).spawn(move || work(&theirs, &ctx)).is_ok();
        Self {
            shared,
            threaded,
            asked: Default::default(),
            drawn: [0; 3],
            cost: [Duration::ZERO; 3],
            full_cost: [Duration::ZERO; 3],
            easel: Easel::default(),
        }
    }

    /// How many pictures have been drawn, by picture.
    pub(super) fn drawn(&self) -> [u64; 3] {
        self.drawn
    }

    /// True for a picture that takes longer than `patience`: while the hand moves, a draft of it is better than a late one.
    pub(super) fn is_heavy(&self, picture: View, patience: Duration) -> bool {
        self.full_cost[picture.index()] > patience
    }

    /// Asks for a picture, unless it, or one of which it would be a draft, was asked for last. What was asked for before and has not been begun is
    /// forgotten.
    pub(super) fn ask(&mut self, job: Job) {
        let i = job.picture.index();
        // A picture that is there needs no draft of itself, and no second drawing without the account that it has.
        let better = |last: &Job| {
            let as_good =
                Job { draft: last.draft && job.draft, accounted: last.accounted || job.accounted, ..job.clone() };
            *last == as_good
        };
        if self.asked[i].as_ref().is_some_and(better) {
            return;
        }
        self.shared.desk().wanted[i] = Some(job.clone());
        self.asked[i] = Some(job);
        self.shared.wake.notify_one();
    }

    /// The pictures that are done. Waits for them up to `patience`, so that a light scene is never a frame late; where the
    /// last drawings took longer than that, it does not wait at all, and the window gets a frame of its own when they are done.
    pub(super) fn collect(&mut self, patience: Duration) -> [Option<Option<Sheet>>; 3] {
        let shared = Arc::clone(&self.shared);
        let mut desk = shared.desk();
        if !self.threaded {
            for i in 0..3 {
                if let Some(job) = desk.wanted[i].take() {
                    desk.finished[i] =
                        Some(Finished { sheet: self.easel.draw(&job), cost: Duration::ZERO, draft: job.draft });
                }
            }
        } else if desk.pending() {
            let expected: Duration =
                (0..3).filter(|&i| desk.wanted[i].is_some() || desk.busy == Some(i)).map(|i| self.cost[i]).sum();
            if expected <= patience {
                desk.waited_for = true;
                desk = match shared.done.wait_timeout_while(desk, patience, |desk| desk.pending()) {
                    Ok((desk, _)) => desk,
                    Err(poisoned) => poisoned.into_inner().0,
                };
                desk.waited_for = false;
            }
        }
        std::array::from_fn(|i| {
            let finished = desk.finished[i].take()?;
            self.drawn[i] += 1;
            self.cost[i] = finished.cost;
            if !finished.draft {
                self.full_cost[i] = finished.cost;
            }
            Some(finished.sheet)
        })
    }
}

impl Drop for Painter {
    fn drop(&mut self) {
        self.shared.desk().quit = true;
        self.shared.wake.notify_one();
    }
}

/// The thread. Every picture that waits gets the same share of the time: a light one is not as late as a heavy one, and none
/// starves while another is dragged.
fn work(shared: &Shared, ctx: &egui::Context) {
    let mut easel = Easel::default();
    let mut shares = Shares::default();
    loop {
        let mut desk = shared.desk();
        let (i, job) = loop {
            if desk.quit {
                return;
            }
            let turn = shares.next(std::array::from_fn(|i| desk.wanted[i].is_some()));
            if let Some((i, job)) = turn.and_then(|i| desk.wanted[i].take().map(|job| (i, job))) {
                break (i, job);
            }
            desk = shared.wake.wait(desk).unwrap_or_else(PoisonError::into_inner);
        };
        desk.busy = Some(i);
        drop(desk);

        let start = Instant::now();
        // A panic here is a bug, but not one for which the window should stand still for ever.
        let sheet = catch_unwind(AssertUnwindSafe(|| easel.draw(&job))).unwrap_or_else(|_| {
            easel = Easel::default();
            None
        });
        shares.book(i, start.elapsed());

        let mut desk = shared.desk();
        desk.busy = None;
        desk.finished[i] = Some(Finished { sheet, cost: start.elapsed(), draft: job.draft });
        let waited_for = desk.waited_for;
        drop(desk);
        shared.done.notify_one();
        if !waited_for {
            ctx.request_repaint();
        }
    }
}

/// How much time each picture has had, so that the next is the one that had least.
#[derive(Default)]
struct Shares {
    had: [Duration; 3],
    /// What the picture that came last had had before: who has not waited gets no credit for it.
    floor: Duration,
}

impl Shares {
    fn next(&mut self, waiting: [bool; 3]) -> Option<usize> {
        for i in (0..3).filter(|&i| waiting[i]) {
            self.had[i] = self.had[i].max(self.floor);
        }
        let next = (0..3).filter(|&i| waiting[i]).min_by_key(|&i| self.had[i])?;
        self.floor = self.had[next];
        Some(next)
    }

    fn book(&mut self, picture: usize, time: Duration) {
        self.had[picture] += time;
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::Camera;
    use crate::figure::Figure;
    use crate::scene::Scene;
    use crate::views::{Extras, Size};

    fn job(size: u32) -> Job {
        let camera = Camera::new(&Figure::default().camera).unwrap();
        Job {
            picture: View::Image,
            figure: Figure::default(),
            camera,
            scene: Arc::new(Scene::default()),
            labels: crate::i18n::pictures::labels(crate::i18n::Lang::En),
            size: Size { width: size, height: size, scale: 1.0 },
            observer: None,
            draft: false,
            extras: Extras::default(),
            max_side: 2048,
            accounted: false,
        }
    }

    #[test]
    fn a_window_that_does_not_wait_is_called_when_the_picture_is_done() {
        let ctx = egui::Context::default();
        let called = Arc::new(Mutex::new(0));
        let count = Arc::clone(&called);
        ctx.set_request_repaint_callback(move |_| *count.lock().unwrap() += 1);
        let mut painter = Painter::new(&ctx);
        painter.cost = [Duration::from_secs(1); 3];
        painter.ask(job(40));
        let mut sheets = painter.collect(Duration::from_millis(1));
        let start = Instant::now();
        while sheets[2].is_none() && start.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(2));
            sheets = painter.collect(Duration::ZERO);
        }
        assert_eq!(sheets[2].as_ref().unwrap().as_ref().unwrap().size, [40, 40]);
        assert_eq!(painter.drawn(), [0, 0, 1]);
        while *called.lock().unwrap() == 0 && start.elapsed() < Duration::from_secs(60) {
            std::thread::yield_now();
        }
        assert_eq!(*called.lock().unwrap(), 1);
    }

    #[test]
    fn a_light_picture_comes_more_often_than_a_heavy_one_and_none_starves() {
        let mut shares = Shares::default();
        let mut came = [0_u32; 3];
        let takes = [60, 180, 20].map(Duration::from_millis);
        for _ in 0..100 {
            let i = shares.next([true; 3]).unwrap();
            came[i] += 1;
            shares.book(i, takes[i]);
        }
        assert!(came[1] >= 6 && came[0] >= 3 * came[1] - 3 && came[2] >= 3 * came[0] - 3, "{came:?}");
        // Who had nothing to draw for long has no right to all the time after that.
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

    #[test]
    fn the_same_picture_is_not_drawn_twice_nor_as_a_draft_of_itself() {
        let mut painter = Painter::new(&egui::Context::default());
        let patience = Duration::from_secs(60);
        let full = job(30);
        let draft = Job { draft: true, ..full.clone() };
        let thirty_one = Size { width: 31, ..full.size };
        for (job, drawn) in [
            (full.clone(), 1),
            (full.clone(), 1),
            (draft.clone(), 1),
            (Job { draft: true, ..Job { size: thirty_one, ..full.clone() } }, 2),
            (Job { size: thirty_one, ..full.clone() }, 3),
        ] {
            painter.ask(job);
            painter.collect(patience);
            assert_eq!(painter.drawn()[2], drawn);
        }
    }

    #[test]
    fn where_there_are_no_threads_pictures_are_drawn_in_the_frame() {
        let mut painter = Painter::new(&egui::Context::default());
        painter.shared.desk().quit = true;
        painter.shared.wake.notify_one();
        painter.threaded = false;
        painter.ask(job(25));
        let sheets = painter.collect(Duration::ZERO);
        assert_eq!(sheets[2].as_ref().unwrap().as_ref().unwrap().size, [25, 25]);
    }
}
