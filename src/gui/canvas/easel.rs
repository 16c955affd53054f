//! One picture from what makes it: the drawing of the view, rasterised, in tiles that a texture can hold.

use std::sync::Arc;

use eframe::egui::ColorImage;
use tiny_skia::Pixmap;

use crate::appearance::Texture;
use crate::camera::Camera;
use crate::figure::{Figure, Observer};
use crate::picture::{Account, clock};
use crate::raster::Rasterizer;
use crate::scene::Scene;
use crate::views::View;
use crate::views::{self, Engine, Extras, Labels, Setup, Size};

/// Width of the image that is painted on the view window in the world, in texels.
const PAINTED_WIDTH: u32 = 512;

/// Everything that makes a picture. Two equal jobs make the same pixels.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) picture: View,
    /// Of the figure only what no other field holds: image size, viewport, style and what is revealed; the rest is as in a new figure.
    pub(super) figure: Figure,
    pub(super) camera: Camera,
    pub(super) scene: Arc<Scene>,
    pub(super) labels: &'static Labels,
    pub(super) size: Size,
    /// From where a three-dimensional picture is seen.
    pub(super) observer: Option<Observer>,
    /// One sample per pixel, whatever the style says.
    pub(super) draft: bool,
    /// Without the painted image, which the drawing of the world makes.
    pub(super) extras: Extras,
    /// The greatest side of a texture, pixels.
    pub(super) max_side: usize,
    /// Every stage is timed and counted.
    pub(super) accounted: bool,
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
            && self.draft == other.draft
            && self.max_side == other.max_side
            && self.accounted == other.accounted
    }
}

/// A picture as it came from the rasterizer, in tiles no larger than a texture may be.
pub(super) struct Sheet {
    /// Width and height in pixels.
    pub(super) size: [usize; 2],
    /// The place of each tile (left, top, in pixels) and its pixels.
    pub(super) tiles: Vec<([usize; 2], ColorImage)>,
    /// How it came about, where that was asked for.
    pub(super) account: Option<Account>,
}

/// Buffers that are kept from one picture to the next, and the image that is painted in the world.
#[derive(Default)]
pub(super) struct Easel {
    /// One for each picture, and one for the image that is painted in the world: each finds its own buffers again.
    engines: [Engine; 4],
    rasterizer: Rasterizer,
    painted: Option<(Job, Arc<Texture>)>,
}

impl Easel {
    /// `None`: the picture has no size, or no memory is left for it.
    pub(super) fn draw(&mut self, job: &Job) -> Option<Sheet> {
        let start = clock();
        let mut extras = job.extras.clone();
        if job.picture == View::World {
            extras.painted_image = self.painted(job);
        }
        let painted = clock().saturating_sub(start);
        let mut figure = job.figure.clone();
        if job.draft {
            figure.style.antialias = 1;
        }
        let setup = Setup {
            figure: &figure,
            camera: &job.camera,
            scene: &job.scene,
            labels: job.labels,
            size: job.size,
            extras: &extras,
        };
        let engine = &mut self.engines[job.picture.index()];
        engine.clock = job.accounted.then_some(clock);
        self.rasterizer.measure(engine.clock);
        let frame = match (job.picture, &job.observer) {
            (View::World, Some(observer)) => views::world::frame_of(&setup, observer, engine),
            (View::Canonical, Some(observer)) => views::canonical::frame_of(&setup, observer, engine),
            _ => views::image::frame_of(&setup, engine),
        };
        let pixmap = self.rasterizer.paint(&frame.drawing)?;
        let total = clock().saturating_sub(start);
        let account = job.accounted.then(|| Account::of(&frame, self.rasterizer.work(), painted, total));
        engine.pipeline.recycle(frame.drawing);
        Some(Sheet { account, ..tiles(&pixmap, job.max_side) })
    }

    /// The image, small, as it is painted on the view window; drawn again only when the camera or the scene has changed.
    fn painted(&mut self, job: &Job) -> Option<Arc<Texture>> {
        let image = Job {
            picture: View::Image,
            size: painted_size(job.camera.window().aspect()),
            observer: None,
            draft: false,
            accounted: false,
            extras: Extras { bare: true, ..Extras::default() },
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
        self.rasterizer.measure(None);
        let frame = views::image::frame_of(&setup, &mut self.engines[3]);
        let pixmap = self.rasterizer.paint(&frame.drawing)?;
        self.engines[3].pipeline.recycle(frame.drawing);
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
    Sheet { size: [width, height], tiles, account: None }
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
