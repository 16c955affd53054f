//! Pictures into files: the same way as `camera-lab render`, so that the bytes are the same.

use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;

use eframe::egui;

use super::state::State;
use crate::appearance::Theme;
use crate::camera::Camera;
use crate::export::png;
use crate::figure::Figure;
use crate::figure::update;
use crate::files;
use crate::i18n::{Lang, messages, pictures};
use crate::picture::{Source, Studio};
use crate::views::{Size, Views, scene_of};

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
    /// All three pictures as on the screen, for paper.
    #[must_use]
    pub fn new(state: &State) -> Self {
        let mut export =
            Self { what: Views::All, width: 0, height: 0, times: Some(2), theme: Theme::Print, scale: 1.0 };
        export.fit_screen(state);
        export
    }

    /// Sets the size to that on the screen, `times` as large.
    pub fn fit_screen(&mut self, state: &State) {
        let Some(times) = self.times else { return };
        let sizes = state.picture_sizes;
        let [width, height] = match self.what {
            Views::One(view) => sizes[view.index()],
            Views::All => together(sizes),
        };
        let side = |pixels: u32| (pixels.max(1) * times).min(crate::limits::MAX_SIDE);
        (self.width, self.height) = (side(width), side(height));
        self.scale = times as f32 * state.screen_scale;
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

/// Paints and writes on a thread; sends the path, or a sentence that says what went wrong.
pub fn start(ctx: &egui::Context, state: &State, export: Export, path: PathBuf, done: Sender<Result<PathBuf, String>>) {
    let mut figure = state.document.figure().clone();
    figure.style.theme = export.theme;
    let source = state.document.source().to_owned();
    let folder = state.document.folder().map(Path::to_owned).unwrap_or_default();
    let lang = state.settings.lang;
    let ctx = ctx.clone();
    std::thread::spawn(move || {
        let result = picture(&figure, &source, &folder, export, lang).and_then(|bytes| {
            let name = path.display().to_string();
            files::save(&path, &bytes).map(|()| path).map_err(|error| messages::file(lang, &name, &error))
        });
        // Nobody waits any more when the window has been closed.
        let _ = done.send(result);
        ctx.request_repaint();
    });
}

/// The bytes of the PNG, with the figure file in it.
fn picture(figure: &Figure, source: &str, folder: &Path, export: Export, lang: Lang) -> Result<Vec<u8>, String> {
    let camera = Camera::new(&figure.camera).map_err(|error| messages::camera(lang, &error))?;
    let mut beside = |path: &str| files::read_for_scene(&folder.join(path));
    let scene = scene_of(figure, &mut beside).map_err(|error| messages::scene(lang, &error))?;
    let from =
        Source { figure, camera: &camera, scene: &scene, labels: pictures::labels(lang), force_all_stages: false };
    let size = Size { width: export.width, height: export.height, scale: export.scale };
    let mut studio = Studio::default();
    let pixmap = match export.what {
        Views::One(view) => studio.paint(from, view, size),
        Views::All => studio.paint_all(from, size),
    };
    let pixmap = pixmap.ok_or_else(|| crate::i18n::window::texts(lang).picture_too_large.to_owned())?;
    png::encode(&pixmap, &update(source, figure)).map_err(|error| messages::png(lang, &error))
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
