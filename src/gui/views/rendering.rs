//! Draws pictures beside the window's thread, each only if its inputs have changed.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, PoisonError, RwLock};
use std::time::Duration;

use eframe::egui;

use super::texture::TextureTiles;
use crate::clock;
use crate::gui::kit::frames;
use crate::picture::{Pixels, RenderReport, Renderer};
use crate::pipeline::{OverBudget, ShadowMaps};
use crate::progress::Progress;
use crate::views::{Hover, LabelPlace, MAX_PICTURES, Request};
use camera_lab_desk::{Running, Worker};

/// A picture to draw. Two equal jobs give the same pixels.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RenderJob {
    /// Its place among the pictures of the shot.
    pub(super) picture: usize,
    pub(super) request: Request,
    /// One sample per pixel, regardless of the style.
    pub(super) draft: bool,
    /// The greatest side of a texture, pixels.
    pub(super) max_side: usize,
    /// Every stage is timed and counted.
    pub(super) accounted: bool,
}

/// A picture that has been drawn.
pub(super) struct Rendered {
    pub(super) tiles: TextureTiles,
    /// Its render report, if requested.
    pub(super) account: Option<RenderReport>,
    /// A shortfall of the picture.
    pub(super) over_budget: Option<OverBudget>,
    /// The places of its labels.
    pub(super) labels: Vec<LabelPlace>,
}

/// The reason why there is no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Missing {
    /// The user gave it up.
    Cancelled,
    /// It has no size, there isn't enough memory, or drawing has panicked.
    NotDrawn,
}

impl Missing {
    fn of(progress: &Progress) -> Self {
        if progress.is_cancelled() { Self::Cancelled } else { Self::NotDrawn }
    }
}

/// The result of a job.
struct DrawOutcome {
    rendered: Result<Rendered, Missing>,
    draft: bool,
    /// The part of its time in which it waited for other pictures.
    waited: Duration,
    /// Number of pictures that shared the processors with it, itself included.
    together: u32,
}

impl DrawOutcome {
    /// The approximate time that the picture would have taken alone.
    fn own_time(&self, time: Duration) -> Duration {
        time.saturating_sub(self.waited) / self.together.max(1)
    }
}

/// Has pictures drawn, one slot for each.
pub(super) struct Rendering {
    worker: Worker<RenderJob, DrawOutcome, MAX_PICTURES>,
    /// The last jobs, by picture.
    asked: [Option<RenderJob>; MAX_PICTURES],
    /// The jobs that the user cancelled, by picture.
    given_up: [Option<RenderJob>; MAX_PICTURES],
    /// Number of pictures drawn, by picture.
    drawn: [u64; MAX_PICTURES],
    /// The time of the last drawing of each picture, and that of the last one that wasn't a draft, as if alone.
    cost: [Duration; MAX_PICTURES],
    full_cost: [Duration; MAX_PICTURES],
}

impl Default for Rendering {
    fn default() -> Self {
        Self {
            worker: drawing(ShadowMaps::default()),
            asked: Default::default(),
            given_up: Default::default(),
            drawn: [0; MAX_PICTURES],
            cost: [Duration::ZERO; MAX_PICTURES],
            full_cost: [Duration::ZERO; MAX_PICTURES],
        }
    }
}

/// Draws pictures at the same time, but draws a timed picture alone, so that its times don't include waiting for the
/// others. All pictures have the same shadow maps.
fn drawing(shadow_maps: ShadowMaps) -> Worker<RenderJob, DrawOutcome, MAX_PICTURES> {
    let turn = Arc::new(Turn::default());
    Worker::new("pictures", clock::now, move || work(Arc::clone(&turn), &shadow_maps))
}

/// The pictures that are being drawn.
#[derive(Default)]
struct Turn {
    /// Held exclusively by one that is drawn alone, shared by the others.
    lock: RwLock<()>,
    drawing: AtomicU32,
}

/// A running job, until it's dropped.
struct RunningRender<'a>(&'a Turn);

impl Drop for RunningRender<'_> {
    fn drop(&mut self) {
        self.0.drawing.fetch_sub(1, Ordering::Relaxed);
    }
}

fn work(turn: Arc<Turn>, shadow_maps: &ShadowMaps) -> impl AsyncFnMut(RenderJob, &Progress) -> DrawOutcome + use<> {
    let mut renderer = Renderer::sharing(shadow_maps);
    let mut pictures: [Pixels; MAX_PICTURES] = Default::default();
    let mut last: [Vec<Arc<egui::ColorImage>>; MAX_PICTURES] = Default::default();
    async move |job: RenderJob, progress: &Progress| {
        // If jobs pause, none begins before the last one has ended. The lock holds no data that a panic could leave
        // half done.
        let asked = clock::now();
        let _alone = job.accounted.then(|| turn.lock.write().unwrap_or_else(PoisonError::into_inner));
        let _beside = (!job.accounted).then(|| turn.lock.read().unwrap_or_else(PoisonError::into_inner));
        let waited = clock::now().saturating_sub(asked);
        let before = turn.drawing.fetch_add(1, Ordering::Relaxed) + 1;
        let _under_way = RunningRender(&turn);
        let RenderJob { picture, mut request, draft, max_side, accounted } = job;
        if draft {
            request = request.with_shot(|shot| shot.look.style.antialias = crate::appearance::Samples::One);
        }
        renderer.measure(accounted.then_some(clock::now));
        renderer.watch(progress);
        let pixels = &mut pictures[picture];
        let account = if accounted {
            // By this thread, because one of the pool may do a part of other work in between.
            renderer.pixels_into(&request, pixels).await
        } else {
            renderer.all_into(&[request], std::slice::from_mut(pixels)).await.and_then(|mut all| all.pop())
        };
        let together = before.max(turn.drawing.load(Ordering::Relaxed));
        let rendered = account.map(|account| {
            let tiles = TextureTiles::of(pixels, max_side).since(&last[picture]);
            last[picture] = tiles.images();
            Rendered {
                tiles,
                over_budget: account.over_budget.clone(),
                labels: account.labels.clone(),
                account: accounted.then_some(account),
            }
        });
        DrawOutcome { rendered: rendered.ok_or_else(|| Missing::of(progress)), draft, waited, together }
    }
}

/// True if two pictures differ at most in the hover.
fn same_but_hover(one: &Request, other: &Request) -> bool {
    let bare = |request: &Request| Request { hover: Hover::default(), ..request.clone() };
    bare(one) == bare(other)
}

impl Rendering {
    /// Number of pictures drawn, by picture.
    pub(super) fn drawn(&self) -> [u64; MAX_PICTURES] {
        self.drawn
    }

    /// True for a picture that takes longer than `patience`. During a drag, a draft of it is better than a late one.
    pub(super) fn is_heavy(&self, picture: usize, patience: Duration) -> bool {
        self.full_cost[picture] > patience
    }

    /// Requests a picture, unless the last request was for it, or for one of which it would be a draft. Requests a
    /// frame of `ctx` when it's done.
    pub(super) fn ask(&mut self, ctx: &egui::Context, job: RenderJob) {
        let i = job.picture;
        // An existing picture needs no draft of itself, and no second drawing without the report that it has.
        let is_as_good = |last: &RenderJob| {
            (!last.draft || job.draft)
                && (last.accounted || !job.accounted)
                && last.max_side == job.max_side
                && last.request == job.request
        };
        let is_given_up = |up: &RenderJob| same_but_hover(&up.request, &job.request);
        if self.given_up[i].as_ref().is_some_and(is_given_up) {
            return;
        }
        self.given_up[i] = None;
        if !self.asked[i].as_ref().is_some_and(is_as_good) {
            self.worker.ask(&frames(ctx), i, job.clone());
            self.asked[i] = Some(job);
        }
    }

    /// The running job.
    pub(super) fn running(&self) -> Option<Running> {
        self.worker.running()
    }

    /// Cancels all running pictures. A new hover doesn't begin them again, only a new shot does.
    pub(super) fn cancel(&mut self) {
        for i in (0..MAX_PICTURES).filter(|&i| self.worker.is_pending(i)) {
            self.given_up[i].clone_from(&self.asked[i]);
        }
        self.worker.cancel();
    }

    /// The finished pictures. Waits for them up to `patience`, so that a light scene is never a frame late. If the last
    /// drawings took longer than that, it doesn't wait at all, and the window gets a frame of its own when they are
    /// done.
    pub(super) fn collect(&mut self, patience: Duration) -> [Option<Result<Rendered, Missing>>; MAX_PICTURES] {
        let pending = (0..MAX_PICTURES).filter(|&i| self.worker.is_pending(i));
        // They are drawn at the same time, and so were those whose costs were measured.
        let expected = pending.map(|i| self.cost[i]).max().unwrap_or_default();
        let mut done = self.worker.take(if expected <= patience { patience } else { Duration::ZERO });
        std::array::from_fn(|i| {
            let done = done[i].take()?;
            self.drawn[i] += 1;
            self.cost[i] = done.time;
            let Some(outcome) = done.outcome else { return Some(Err(Missing::NotDrawn)) };
            if !outcome.draft {
                self.full_cost[i] = outcome.own_time(done.time);
            }
            Some(outcome.rendered)
        })
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::Camera;
    use crate::figure::Figure;
    use crate::scene::no_files;
    use crate::views::{SharedScene, Size, View, scene_of};
    use camera_lab_words::{Lang, pictures};

    fn job(side: u32) -> RenderJob {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width: side, height: side, scale: 1.0 };
        let labels = pictures::labels(Lang::En);
        let request = Request::of(&figure, View::Image, &camera, &SharedScene::default(), labels, size);
        RenderJob { picture: 2, request, draft: false, max_side: 2048, accounted: false }
    }

    fn sized(job: &RenderJob, side: u32) -> RenderJob {
        let size = Size { width: side, height: side, scale: 1.0 };
        RenderJob { request: Request { size, ..job.request.clone() }, ..job.clone() }
    }

    #[test]
    fn slow_pictures_are_not_waited_for() {
        let ctx = egui::Context::default();
        let mut rendering = Rendering { cost: [Duration::from_secs(1); MAX_PICTURES], ..Rendering::default() };
        rendering.ask(&ctx, job(40));
        let mut rendered = rendering.collect(Duration::from_millis(1));
        let start = clock::now();
        while rendered[2].is_none() && clock::now() - start < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(2));
            rendered = rendering.collect(Duration::ZERO);
        }
        assert_eq!(rendered[2].as_ref().unwrap().as_ref().unwrap().tiles.size, [40, 40]);
        assert_eq!(rendering.drawn()[..3], [0, 0, 1]);
    }

    #[test]
    fn all_pictures_of_a_window_have_the_same_shadow_maps() {
        let figure = crate::figure::read::parse(
            "[scene]\npreset = \"house\"\n[[scene.lights]]\nkind = \"point\"\nshadows = true\nshadow_map = 64\n",
        )
        .unwrap();
        let scene = scene_of(&figure, &mut no_files, &Progress::default()).unwrap();
        let (scene, camera) = (SharedScene::new(scene), Camera::new(&figure.camera).unwrap());
        let (ctx, shadow_maps) = (egui::Context::default(), ShadowMaps::default());
        let mut worker = drawing(shadow_maps.clone());
        let labels = pictures::labels(Lang::En);
        for (picture, view) in View::ALL.into_iter().enumerate() {
            let size = Size { width: 40, height: 30, scale: 1.0 };
            let request = Request::of(&figure, view, &camera, &scene, labels, size);
            worker.ask(&frames(&ctx), picture, RenderJob { picture, request, ..job(1) });
        }
        let drawn = worker.take(Duration::from_secs(60)).into_iter().flatten();
        assert_eq!(drawn.filter(|done| done.outcome.as_ref().unwrap().rendered.is_ok()).count(), View::COUNT);
        let [map] = &shadow_maps.of_scene((&*scene).into())[..] else { panic!("one lamp") };
        assert!(map.depths().is_some(), "painted by one picture for all");
    }

    #[test]
    fn the_same_picture_is_not_drawn_twice_nor_as_a_draft_of_itself() {
        let ctx = egui::Context::default();
        let mut rendering = Rendering::default();
        let full = job(30);
        let draft = RenderJob { draft: true, ..full.clone() };
        for (job, drawn) in [
            (full.clone(), 1),
            (full.clone(), 1),
            (draft.clone(), 1),
            (sized(&draft, 31), 2),
            (sized(&full, 31), 3),
            (RenderJob { accounted: true, ..sized(&full, 31) }, 4),
            (sized(&full, 31), 4),
        ] {
            rendering.ask(&ctx, job);
            rendering.collect(Duration::from_secs(60));
            assert_eq!(rendering.drawn()[2], drawn);
        }
    }

    #[test]
    fn a_cancelled_drawing_restarts_for_another_picture_not_for_the_pointer() {
        let waiting = || {
            async |job: RenderJob, progress: &Progress| {
                while !progress.is_cancelled() {
                    std::thread::yield_now();
                }
                let rendered = Err(Missing::of(progress));
                DrawOutcome { rendered, draft: job.draft, waited: Duration::ZERO, together: 1 }
            }
        };
        let ctx = egui::Context::default();
        let worker = Worker::new("pictures", clock::now, waiting);
        let mut rendering = Rendering { worker, ..Rendering::default() };
        rendering.ask(&ctx, job(30));
        while rendering.running().is_none() {
            std::thread::yield_now();
        }
        assert_eq!(rendering.running().unwrap().slot, 2);
        rendering.cancel();
        assert!(matches!(rendering.collect(Duration::from_secs(60))[2], Some(Err(Missing::Cancelled))));
        let pointed_at = Hover { probe: Some(crate::views::Probe::Point(glam::DVec3::ZERO)), ..Hover::default() };
        let same = RenderJob { request: Request { hover: pointed_at, ..job(30).request }, ..job(30) };
        let same = RenderJob {
            request: Request { scene: rendering.asked[2].as_ref().unwrap().request.scene.clone(), ..same.request },
            ..same
        };
        rendering.ask(&ctx, same);
        assert!(!rendering.worker.is_pending(2));
        rendering.ask(&ctx, job(31));
        assert!(rendering.worker.is_pending(2));
        rendering.cancel();
        rendering.collect(Duration::from_secs(60));
    }

    #[test]
    fn without_threads_pictures_are_drawn_in_the_frame() {
        let ctx = egui::Context::default();
        let worker = drawing(ShadowMaps::default()).without_thread(&frames(&ctx));
        let mut rendering = Rendering { worker, ..Rendering::default() };
        rendering.ask(&ctx, job(25));
        let rendered = rendering.collect(Duration::ZERO);
        assert_eq!(rendered[2].as_ref().unwrap().as_ref().unwrap().tiles.size, [25, 25]);
    }

    #[test]
    fn a_picture_is_as_heavy_as_it_would_be_alone() {
        let outcome = |waited, together| DrawOutcome {
            rendered: Err(Missing::NotDrawn),
            draft: false,
            waited: Duration::from_millis(waited),
            together,
        };
        let time = Duration::from_millis(60);
        assert_eq!(outcome(0, 1).own_time(time), time);
        assert_eq!(outcome(24, 3).own_time(time), Duration::from_millis(12));
        assert_eq!(outcome(70, 2).own_time(time), Duration::ZERO);
        // None of several pictures waits for itself.
        let ctx = egui::Context::default();
        let mut rendering = Rendering::default();
        for picture in 0..3 {
            rendering.ask(&ctx, RenderJob { picture, accounted: picture == 1, ..job(60) });
        }
        assert_eq!(
            rendering.collect(Duration::from_secs(60)).iter().filter(|one| matches!(one, Some(Ok(_)))).count(),
            3
        );
        for i in 0..3 {
            assert!(rendering.full_cost[i] <= rendering.cost[i] && !rendering.full_cost[i].is_zero());
        }
    }

    #[test]
    fn a_picture_without_pixels_is_missing() {
        let mut rendering = Rendering::default();
        rendering.ask(&egui::Context::default(), job(0));
        assert!(matches!(rendering.collect(Duration::from_secs(60))[2], Some(Err(Missing::NotDrawn))));
    }
}
