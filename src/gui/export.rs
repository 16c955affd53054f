//! Pictures into files: the same way as `camera-lab render`, so that the bytes are the same.

use std::path::{Path, PathBuf};

use eframe::egui;

use super::document::Document;
use super::worker::Worker;
use crate::appearance::Theme;
use crate::camera::Camera;
use crate::clock;
use crate::figure::Figure;
use crate::figure::update;
use crate::files::{self, Overwrite};
use crate::i18n::{Lang, messages, pictures};
use crate::picture::{Renderer, requests};
use crate::views::{Request, SharedScene, Size, View, Views, scene_of};

/// Which picture, how large, in which theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Export {
    /// One picture, or all three side by side.
    pub what: Views,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// How many times as large as on the screen; `None`: the size was typed.
    pub times: Option<u32>,
    /// The theme of the picture.
    pub theme: Theme,
    /// Thick strokes and large type by this factor.
    pub scale: f32,
}

impl Export {
    /// All three pictures as on the screen, for paper. `sizes`: width and height of each picture on the screen, in the order
    /// of [`View::ALL`]; `scale`: pixels there for one unit of stroke width.
    #[must_use]
    pub fn new(sizes: [[u32; 2]; 3], scale: f32) -> Self {
        let mut export =
            Self { what: Views::All, width: 0, height: 0, times: Some(2), theme: Theme::Print, scale: 1.0 };
        export.fit_screen(sizes, scale);
        export
    }

    /// Sets the size to that on the screen, `times` as large; `sizes` and `scale` as in [`new`](Self::new).
    pub fn fit_screen(&mut self, sizes: [[u32; 2]; 3], scale: f32) {
        let Some(times) = self.times else { return };
        let [width, height] = match self.what {
            Views::One(view) => sizes[view.index()],
            Views::All => together(sizes),
        };
        let side = |pixels: u32| (pixels.max(1) * times).min(crate::limits::MAX_SIDE);
        (self.width, self.height) = (side(width), side(height));
        self.scale = times as f32 * scale;
    }
}

/// Room for three pictures side by side: as on the screen, or, where they are stacked there, as large as the largest, 4 by 3.
fn together(sizes: [[u32; 2]; 3]) -> [u32; 2] {
    if sizes.iter().all(|size| size[1] == sizes[0][1]) {
        return [sizes.iter().map(|size| size[0]).sum(), sizes[0][1]];
    }
    let area = sizes.iter().map(|[width, height]| f64::from(*width) * f64::from(*height)).fold(1.0, f64::max);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sides of a screen")]
    let side = |v: f64| v.round() as u32;
    [3 * side((area * 4.0 / 3.0).sqrt()), side((area * 0.75).sqrt())]
}

/// A picture that is being written.
pub(super) type Exporting = Worker<Task, Result<PathBuf, String>>;

/// Everything that a picture in a file depends on.
pub(super) struct Task {
    figure: Figure,
    source: String,
    folder: PathBuf,
    lang: Lang,
    export: Export,
    path: PathBuf,
}

/// Draws and writes beside the window's thread; what comes of it is the path, or a sentence that says what went wrong.
pub(super) fn start(ctx: &egui::Context, document: &Document, lang: Lang, export: Export, path: PathBuf) -> Exporting {
    let mut figure = document.figure().clone();
    figure.style.theme = export.theme;
    let source = document.source().to_owned();
    let folder = document.folder().map(Path::to_owned).unwrap_or_default();
    let mut exporting: Exporting = Worker::new("export", clock::now, || Box::new(Task::run));
    exporting.ask(ctx, 0, Task { figure, source, folder, lang, export, path });
    exporting
}

impl Task {
    fn run(self) -> Result<PathBuf, String> {
        let bytes = self.png()?;
        let Self { path, lang, .. } = self;
        let name = path.display().to_string();
        files::save(&path, &bytes, Overwrite::Writable)
            .map(|()| path)
            .map_err(|error| messages::file(lang, &name, &error))
    }

    /// The bytes of the PNG, with the figure file in it.
    fn png(&self) -> Result<Vec<u8>, String> {
        let Self { figure, source, folder, lang, export, .. } = self;
        let lang = *lang;
        let camera = Camera::new(&figure.camera).map_err(|error| messages::camera(lang, &error))?;
        let mut beside = |path: &str| files::read_for_scene(&folder.join(path));
        let scene = scene_of(figure, &mut beside).map_err(|error| messages::scene(lang, &error))?;
        let size = Size { width: export.width, height: export.height, scale: export.scale };
        let labels = pictures::labels(lang);
        let request = Request::of(figure, View::Image, &camera, &SharedScene::new(scene), labels, size);
        let picture = requests(export.what, &request, &figure.observers)
            .and_then(|requests| Renderer::default().sheet(&requests))
            .ok_or_else(|| crate::i18n::window::texts(lang).picture_too_large.to_owned())?;
        picture.into_png(&update(source, figure)).map_err(|error| messages::png(lang, &error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_pictures_have_room_side_by_side() {
        assert_eq!(together([[400, 600], [300, 600], [300, 600]]), [1000, 600]);
        assert_eq!(together([[800, 300], [395, 300], [395, 301]]), [3 * 566, 424]);
    }
}
