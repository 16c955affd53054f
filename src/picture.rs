//! A figure → the pixels of one of its pictures: what the command line writes and the window exports.

use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use tiny_skia::Pixmap;

use crate::appearance::Texture;
use crate::camera::Camera;
use crate::drawing::{Drawing, Paint, Surface};
use crate::export::sheet;
use crate::figure::Figure;
use crate::pipeline::{Frame, ObjectReport, Stage, StageReport};
use crate::raster::{Rasterizer, Work};
use crate::scene::Scene;
use crate::views::observer::Preset;
use crate::views::{self, Engine, Extras, Labels, Palette, Setup, Size, View, image::frame};

/// The time since the first call: what stages are timed by.
#[must_use]
pub fn clock() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}

/// What pictures are made from.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Style, image size and observers.
    pub figure: &'a Figure,
    /// The camera that the pictures are about.
    pub camera: &'a Camera,
    /// What it looks at.
    pub scene: &'a Scene,
    /// The words in the pictures.
    pub labels: &'a Labels,
    /// Run every stage of the pipeline, needed or not. The picture is the same.
    pub force_all_stages: bool,
}

/// Room between two pictures on a sheet, in pixels at scale 1.
const GAP: f32 = 4.0;

/// Paints pictures; keeps its buffers from one to the next.
#[derive(Clone, Debug, Default)]
pub struct Studio {
    /// One for each picture, and one for the image on the view window in the world: each finds its own buffers again.
    engines: [Engine; 4],
    rasterizer: Rasterizer,
    /// What [`redraw`](Studio::redraw) paints on, one for each picture.
    kept: [Option<Pixmap>; 3],
}

/// How a picture came about; empty without a clock.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Account {
    /// Every stage, in order. Their times add up to the total.
    pub stages: Vec<StageReport>,
    /// What was done with each object that went through the pipeline: those of the scene first, in its order.
    pub objects: Vec<ObjectReport>,
    /// From the scene to the last pixel.
    pub total: Duration,
}

impl Studio {
    /// Times every stage from now on. The clock gives the time since any moment that stays the same.
    #[must_use]
    pub fn with_clock(mut self, clock: fn() -> Duration) -> Self {
        self.engines.iter_mut().for_each(|engine| engine.clock = Some(clock));
        self.rasterizer.measure(Some(clock));
        self
    }

    /// Paints one picture. `None` where a side is 0 or there is no memory for so many pixels.
    ///
    /// *Guarantees*: equal sources and sizes give equal pixels.
    pub fn paint(&mut self, source: Source<'_>, view: View, size: Size) -> Option<Pixmap> {
        let mut pixmap = Pixmap::new(1, 1)?;
        self.paint_into(source, view, size, &mut pixmap).map(|_| pixmap)
    }

    /// Paints one picture as [`paint`](Self::paint) does, over the last one, and tells how it came about.
    pub fn redraw(&mut self, source: Source<'_>, view: View, size: Size) -> Option<Account> {
        let mut pixmap = self.kept[view.index()].take().or_else(|| Pixmap::new(1, 1))?;
        let account = self.paint_into(source, view, size, &mut pixmap);
        self.kept[view.index()] = Some(pixmap);
        account
    }

    /// On pixels that are there already if they have the picture's size.
    fn paint_into(&mut self, source: Source<'_>, view: View, size: Size, pixmap: &mut Pixmap) -> Option<Account> {
        let clock = self.engines[view.index()].clock;
        let now = || clock.map_or(Duration::ZERO, |now| now());
        let start = now();
        let extras = match view {
            View::World => Extras { painted_image: Some(self.painted_image(source, size)?), ..plain(source) },
            View::Canonical | View::Image => plain(source),
        };
        let painted = now().saturating_sub(start);
        let setup = setup(source, size, &extras);
        let observers = source.figure.observers;
        let engine = &mut self.engines[view.index()];
        let frame = match view {
            View::World => {
                let observer = observers.world.unwrap_or_else(|| views::world::observer(&setup, Preset::Iso));
                views::world::frame_of(&setup, &observer, engine)
            }
            View::Canonical => {
                let observer = observers.canonical.unwrap_or_else(|| views::canonical::observer(&setup, Preset::Iso));
                views::canonical::frame_of(&setup, &observer, engine)
            }
            View::Image => views::image::frame_of(&setup, engine),
        };
        if !self.rasterizer.paint_into(&frame.drawing, pixmap) {
            return None;
        }
        let total = now().saturating_sub(start);
        let account =
            clock.map_or_else(Account::default, |_| Account::of(&frame, self.rasterizer.work(), painted, total));
        engine.pipeline.recycle(frame.drawing);
        Some(account)
    }

    /// Paints all three side by side, together of this size. `None` as for [`paint`](Self::paint).
    pub fn paint_all(&mut self, source: Source<'_>, size: Size) -> Option<Pixmap> {
        let mut pictures = Vec::new();
        for (view, width) in View::ALL.into_iter().zip(widths(size)?) {
            pictures.push(self.paint(source, view, Size { width, ..size })?);
        }
        sheet::side_by_side(&pictures, gap(size.scale), Palette::of(source.figure.style.theme).surround)
    }

    /// The image, without margins, for the view window in the world: half as large as the picture, within reason.
    fn painted_image(&mut self, source: Source<'_>, size: Size) -> Option<Arc<Texture>> {
        let side = (size.width.max(size.height) / 2).clamp(256, 1024);
        let rect = frame(Size { width: side, height: side, scale: 1.0 }, source.camera.window());
        let extras = Extras { bare: true, ..plain(source) };
        let size = Size { width: rect.width, height: rect.height, scale: 1.0 };
        let drawn = views::image::frame_of(&setup(source, size, &extras), &mut self.engines[3]);
        let pixmap = self.rasterizer.paint(&drawn.drawing)?;
        self.engines[3].pipeline.recycle(drawn.drawing);
        let (width, height) = (pixmap.width(), pixmap.height());
        Some(Arc::new(Texture { width, height, rgba: pixmap.take() }))
    }
}

/// The widths of three pictures side by side; `None` where there is no room for them. What does not divide by three goes to the
/// first ones, a pixel each.
#[must_use]
pub fn widths(sheet: Size) -> Option<[u32; 3]> {
    let room = sheet.width.checked_sub(2 * gap(sheet.scale))?;
    Some([room.div_ceil(3), (room + 1) / 3, room / 3])
}

impl Account {
    /// The report of the pipeline, completed with what was done to pixels; `painted` is the time that the image on the view
    /// window took before. What is neither the pipeline's nor the rasterizer's work went into the scene that the picture shows:
    /// the canonical volume's is clipped and projected, the world's has the camera's gear in it. It counts as traversal.
    #[must_use]
    pub fn of(frame: &Frame, work: Work, painted: Duration, total: Duration) -> Self {
        let mut stages = frame.report.clone();
        for report in stages.iter_mut().filter(|report| report.ran) {
            complete(report, &frame.drawing, work, painted);
        }
        let known = stages.iter().filter_map(|report| report.time).sum();
        if let Some(traversal) = stages.iter_mut().find(|report| report.stage == Stage::Traverse) {
            traversal.time = Some(traversal.time.unwrap_or_default() + total.saturating_sub(known));
        }
        Self { stages, objects: frame.objects.clone(), total }
    }
}

/// Adds what was done to pixels.
fn complete(report: &mut StageReport, drawing: &Drawing, work: Work, painted: Duration) {
    let count = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
    let triangles = |which: &dyn Fn(&Surface) -> bool| {
        let n = drawing.surfaces.iter().filter(|s| which(s)).map(|s| s.triangles.len()).sum();
        Some((n, n))
    };
    let pixels = drawing.width as usize * drawing.height as usize;
    let own = |time: Duration| Some(report.time.unwrap_or_default() + time);
    match report.stage {
        Stage::Fill => {
            report.time = own(work.surfaces);
            report.counts = Some((work.triangles, count(work.covered)));
        }
        // Painted in order, the picture's triangles decide among themselves.
        Stage::HiddenSurfaces if !drawing.painted_in_order => {
            report.counts = Some((count(work.covered), count(work.written)));
        }
        Stage::Interpolate => report.counts = triangles(&|s| !matches!(s.paint, Paint::Solid(_) | Paint::Faces(_))),
        Stage::Texture => {
            report.counts = triangles(&|s| matches!(s.paint, Paint::Texture { .. }));
            report.time = (painted > Duration::ZERO).then_some(painted);
        }
        Stage::Blend => report.counts = triangles(&|s| s.translucent),
        Stage::Antialias => report.counts = Some((pixels * usize::from(drawing.antialias), pixels)),
        Stage::Write => report.counts = Some((pixels, pixels)),
        Stage::Lines => report.time = own(work.strokes),
        _ => {}
    }
}

/// Room between two pictures on a sheet, in pixels.
#[must_use]
pub fn gap(scale: f32) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let gap = (GAP * scale).round().clamp(1.0, 100.0) as u32;
    gap
}

/// Nothing is pointed at.
fn plain(source: Source<'_>) -> Extras {
    Extras { force_all_stages: source.force_all_stages, ..Extras::default() }
}

fn setup<'a>(source: Source<'a>, size: Size, extras: &'a Extras) -> Setup<'a> {
    let Source { figure, camera, scene, labels, .. } = source;
    Setup { figure, camera, scene, labels, size, extras }
}
