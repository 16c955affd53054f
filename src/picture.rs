//! A figure → the pixels of one of its pictures: what the command line writes and the window exports.

use std::sync::Arc;

use tiny_skia::Pixmap;

use crate::appearance::Texture;
use crate::camera::Camera;
use crate::export::sheet;
use crate::figure::Figure;
use crate::raster::Rasterizer;
use crate::scene::Scene;
use crate::views::observer::Preset;
use crate::views::{self, Extras, Labels, Palette, Setup, Size, image::frame};

/// One of the three pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum View {
    /// The world, with the camera in it.
    World,
    /// The canonical volume.
    Canonical,
    /// The projected image.
    Image,
}

impl View {
    /// All three, from left to right.
    pub const ALL: [Self; 3] = [Self::World, Self::Canonical, Self::Image];
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

/// Paints one picture. `None` where a side is 0 or there is no memory for so many pixels.
///
/// *Guarantees*: equal sources and sizes give equal pixels.
#[must_use]
pub fn paint(rasterizer: &mut Rasterizer, source: Source<'_>, view: View, size: Size) -> Option<Pixmap> {
    let extras = match view {
        View::World => Extras { painted_image: Some(painted_image(rasterizer, source, size)?), ..plain(source) },
        View::Canonical | View::Image => plain(source),
    };
    let setup = setup(source, size, &extras);
    let observers = source.figure.observers;
    let drawing = match view {
        View::World => {
            let observer = observers.world.unwrap_or_else(|| views::world::observer(&setup, Preset::Iso));
            views::world::draw(&setup, &observer)
        }
        View::Canonical => {
            let observer = observers.canonical.unwrap_or_else(|| views::canonical::observer(&setup, Preset::Iso));
            views::canonical::draw(&setup, &observer)
        }
        View::Image => views::image::draw(&setup),
    };
    rasterizer.paint(&drawing)
}

/// Paints all three side by side, together of this size. `None` as for [`paint`].
#[must_use]
pub fn paint_all(rasterizer: &mut Rasterizer, source: Source<'_>, size: Size) -> Option<Pixmap> {
    let gap = gap(size.scale);
    let room = size.width.checked_sub(2 * gap)?;
    // What does not divide by three goes to the first ones, a pixel each.
    let widths = [room.div_ceil(3), (room + 1) / 3, room / 3];
    let mut pictures = Vec::new();
    for (view, width) in View::ALL.into_iter().zip(widths) {
        pictures.push(paint(rasterizer, source, view, Size { width, ..size })?);
    }
    sheet::side_by_side(&pictures, gap, Palette::of(source.figure.style.theme).surround)
}

/// Room between two pictures on a sheet, in pixels.
#[must_use]
pub fn gap(scale: f32) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let gap = (GAP * scale).round().clamp(1.0, 100.0) as u32;
    gap
}

/// The image, without margins, for the view window in the world: half as large as the picture, within reason.
fn painted_image(rasterizer: &mut Rasterizer, source: Source<'_>, size: Size) -> Option<Arc<Texture>> {
    let side = (size.width.max(size.height) / 2).clamp(256, 1024);
    let rect = frame(Size { width: side, height: side, scale: 1.0 }, source.camera.window());
    let extras = plain(source);
    let size = Size { width: rect.width, height: rect.height, scale: 1.0 };
    let pixmap = rasterizer.paint(&views::image::draw(&setup(source, size, &extras)))?;
    let (width, height) = (pixmap.width(), pixmap.height());
    Some(Arc::new(Texture { width, height, rgba: pixmap.take() }))
}

/// Nothing is pointed at.
fn plain(source: Source<'_>) -> Extras {
    Extras { force_all_stages: source.force_all_stages, ..Extras::default() }
}

fn setup<'a>(source: Source<'a>, size: Size, extras: &'a Extras) -> Setup<'a> {
    let Source { figure, camera, scene, labels, .. } = source;
    Setup { figure, camera, scene, labels, size, extras }
}
