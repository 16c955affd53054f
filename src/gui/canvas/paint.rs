//! Draws pictures beside the window's thread, each only when something that made it has changed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use eframe::egui::{self, ColorImage};
use tiny_skia::Pixmap;

use crate::appearance::Texture;
use crate::camera::Camera;
use crate::figure::{Figure, Observer};
use crate::gui::state::Picture;
use crate::raster::Rasterizer;
use crate::scene::Scene;
use crate::views::{self, Extras, Labels, Setup, Size};

/// Width of the image that is painted on the view window in the world, in texels.
const PAINTED_WIDTH: u32 = 512;

/// Everything that makes a picture. Two equal jobs make the same pixels.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) picture: Picture,
    /// Of the figure only what no other field holds: image size, viewport and style; the rest is as in a new figure.
    pub(super) figure: Figure,
    pub(super) camera: Camera,
    pub(super) scene: Arc<Scene>,
    pub(super) labels: &'static Labels,
    pub(super) size: Size,
    /// From where a three-dimensional picture is seen.
    pub(super) observer: Option<Observer>,
    /// Without the painted image, which the drawing of the world makes.
    pub(super) extras: Extras,
    /// The greatest side of a texture, pixels.
    pub(super) max_side: usize,
}

impl PartialEq for Job {
    /// Scenes are equal where they are the same one: the canvas makes a new one only when the figure's has changed.
    fn eq(&self, other: &Self) -> bool {
        self.picture == other.picture
            && Arc::ptr_eq(&self.scene, &other.scene)
            && self.size == other.size
            && self.observer == other.observer
            && self.camera == other.camera
            && self.extras == other.extras
            && self.labels == other.labels
            && self.figure == other.figure
            && self.max_side == other.max_side
    }
}

/// A picture as it came from the rasterizer, in tiles no larger than a texture may be.
pub(super) struct Sheet {
    /// Width and height in pixels.
    pub(super) size: [usize; 2],
    /// The place of each tile (left, top, in pixels) and its pixels.
    pub(super) tiles: Vec<([usize; 2], ColorImage)>,
}

/// Draws pictures, on a thread of its own where there are threads.
pub(super) struct Painter {
    shared: Arc<Shared>,
    threaded: bool,
    /// What was asked for last, by picture.
    asked: [Option<Job>; 3],
    /// How many pictures have been drawn, by picture.
    drawn: [u64; 3],
    /// What the last drawing of each picture took.
    cost: [Duration; 3],
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
            easel: Easel::default(),
        }
    }

    /// How many pictures have been drawn, by picture.
    pub(super) fn drawn(&self) -> [u64; 3] {
        self.drawn
    }

    /// Asks for a picture, unless it is the one that was asked for last. What was asked for before and has not been begun is
    /// forgotten.
    pub(super) fn ask(&mut self, job: Job) {
        let i = job.picture.index();
        if self.asked[i].as_ref() == Some(&job) {
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
                    desk.finished[i] = Some(Finished { sheet: self.easel.draw(&job), cost: Duration::ZERO });
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

/// The thread: takes the pictures in turn, so that none starves while another is dragged.
fn work(shared: &Shared, ctx: &egui::Context) {
    let mut easel = Easel::default();
    let mut next = 0;
    loop {
        let mut desk = shared.desk();
        let (i, job) = loop {
            if desk.quit {
                return;
            }
            let turn = (0..3).map(|k| (next + k) % 3).find(|&i| desk.wanted[i].is_some());
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
        next = (i + 1) % 3;

        let mut desk = shared.desk();
        desk.busy = None;
        desk.finished[i] = Some(Finished { sheet, cost: start.elapsed() });
        let waited_for = desk.waited_for;
        drop(desk);
        shared.done.notify_one();
        if !waited_for {
            ctx.request_repaint();
        }
    }
}

/// Buffers that are kept from one picture to the next, and the image that is painted in the world.
#[derive(Default)]
struct Easel {
    rasterizer: Rasterizer,
    painted: Option<(Job, Arc<Texture>)>,
}

impl Easel {
    /// `None`: the picture has no size, or no memory is left for it.
    fn draw(&mut self, job: &Job) -> Option<Sheet> {
        let mut extras = job.extras.clone();
        if job.picture == Picture::World {
            extras.painted_image = self.painted(job);
        }
        let setup = Setup {
            figure: &job.figure,
            camera: &job.camera,
            scene: &job.scene,
            labels: job.labels,
            size: job.size,
            extras: &extras,
        };
        let drawing = match (job.picture, &job.observer) {
            (Picture::World, Some(observer)) => views::world::draw(&setup, observer),
            (Picture::Canonical, Some(observer)) => views::canonical::draw(&setup, observer),
            _ => views::image::draw(&setup),
        };
        let pixmap = self.rasterizer.paint(&drawing)?;
        Some(tiles(&pixmap, job.max_side))
    }

    /// The image, small, as it is painted on the view window; drawn again only when the camera or the scene has changed.
    fn painted(&mut self, job: &Job) -> Option<Arc<Texture>> {
        let image = Job {
            picture: Picture::Image,
            size: painted_size(job.camera.window().aspect()),
            observer: None,
            extras: Extras::default(),
            ..job.clone()
        };
        if let Some((made_from, texture)) = &self.painted
            && *made_from == image
        {
            return Some(Arc::clone(texture));
        }
        let setup = Setup {
            figure: &image.figure,
            camera: &image.camera,
            scene: &image.scene,
            labels: image.labels,
            size: image.size,
            extras: &image.extras,
        };
        let pixmap = self.rasterizer.paint(&views::image::draw(&setup))?;
        let (width, height) = (pixmap.width(), pixmap.height());
        let texture = Arc::new(Texture { width, height, rgba: pixmap.take() });
        self.painted = Some((image, Arc::clone(&texture)));
        Some(texture)
    }
}

/// A size with about this aspect, no side longer than [`PAINTED_WIDTH`].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "rounded and clamped to 1 … 512 before the cast"
)]
fn painted_size(aspect: f64) -> Size {
    let longest = f64::from(PAINTED_WIDTH);
    let side = |s: f64| (longest * s.min(1.0)).round().clamp(1.0, longest) as u32;
    Size { width: side(aspect), height: side(aspect.recip()), scale: 1.0 }
}

/// Cuts a picture into tiles.
fn tiles(pixmap: &Pixmap, max_side: usize) -> Sheet {
    let (width, height) = (pixmap.width() as usize, pixmap.height() as usize);
    let side = max_side.max(1);
    let mut tiles = Vec::new();
    for top in (0..height).step_by(side) {
        for left in (0..width).step_by(side) {
            let (w, h) = (side.min(width - left), side.min(height - top));
            let image = if w == width {
                ColorImage::from_rgba_premultiplied([w, h], &pixmap.data()[4 * width * top..4 * width * (top + h)])
            } else {
                let mut rgba = Vec::with_capacity(4 * w * h);
                for y in top..top + h {
                    let start = 4 * (y * width + left);
                    rgba.extend_from_slice(&pixmap.data()[start..start + 4 * w]);
                }
                ColorImage::from_rgba_premultiplied([w, h], &rgba)
            };
            tiles.push(([left, top], image));
        }
    }
    Sheet { size: [width, height], tiles }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn tiles_hold_each_pixel_once_at_its_place() {
        let (width, height) = (7_u8, 5_u8);
        let mut pixmap = Pixmap::new(width.into(), height.into()).unwrap();
        for (i, p) in pixmap.data_mut().chunks_exact_mut(4).enumerate() {
            let i = u8::try_from(i).unwrap();
            p.copy_from_slice(&[i % width, i / width, 0, 255]);
        }
        for max_side in [2, 3, 5, 7, 100] {
            let sheet = tiles(&pixmap, max_side);
            assert_eq!(sheet.size, [7, 5]);
            let mut seen = [0; 35];
            for ([left, top], image) in &sheet.tiles {
                assert!(image.size[0] <= max_side && image.size[1] <= max_side);
                for (k, pixel) in image.pixels.iter().enumerate() {
                    let (x, y) = (left + k % image.size[0], top + k / image.size[0]);
                    assert_eq!((usize::from(pixel.r()), usize::from(pixel.g())), (x, y));
                    seen[y * 7 + x] += 1;
                }
            }
            assert!(seen.iter().all(|&n| n == 1));
        }
    }

    #[test]
    fn the_painted_image_keeps_the_aspect_and_never_vanishes() {
        let size = painted_size(2.0);
        assert_eq!((size.width, size.height), (512, 256));
        let size = painted_size(0.5);
        assert_eq!((size.width, size.height), (256, 512));
        let size = painted_size(1e9);
        assert_eq!((size.width, size.height), (512, 1));
    }
}
