//! Pictures into files, in the same way as `camera-lab render`, so that the bytes are the same.

pub(super) mod export_dialog;
pub(super) mod family;
pub mod family_choice;
pub mod preview;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use eframe::egui;

use crate::appearance::Theme;
use crate::camera::{Camera, Convention, Decomposition};
use crate::export::animation::AnimationFormat;
use crate::export::format::PictureFormat;
use crate::export::plot::encode;
use crate::export::vector::Letters;
use crate::figure::variation::{Variation, VariationError, variants};
use crate::figure::{Figure, update};
use crate::gui::export::family_choice::FamilyChoice;
use crate::gui::kit::frames;
use crate::limits::{MAX_FAMILY, PAPER_LINES};
use crate::picture::{
    self, Animation, Beside, Composite, ExportSpec, Faces, Family, FileOptions, FilmFormat, Metadata, OnPaper,
    PictureError, PictureFile, SheetSize,
};
use crate::progress::Progress;
use crate::views::{Request, SharedScene, Shot, Size, View, Views, scene_of};
use camera_lab_desk::{ChartFile, ExportError, Job, Model, Running, Shortfall, Worker};
use camera_lab_files::{self as files, FigureFiles, FileError, LeftOut, Overwrite};
use camera_lab_words::learn::handouts;
use camera_lab_words::{Lang, pictures};

/// The export settings: pictures, size, theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Export {
    /// One picture, or all three on a sheet.
    pub what: Views,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Multiple of the size on screen. `None` if the size was typed.
    pub times: Option<u32>,
    /// True if the size is that on paper, below. Then `times` doesn't count.
    pub on_paper: bool,
    /// The settings for paper.
    pub paper: Paper,
    /// The proposed format. The name of the file decides.
    pub format: PictureFormat,
    /// Without ground, if the format has transparency.
    pub transparent: bool,
    /// Crop the empty background around each picture.
    pub crop: bool,
    /// The representation of faces in vectors.
    pub faces: Faces,
    /// True if the letters of vectors are outlines, and not text.
    pub outlines: bool,
    /// The theme of the picture.
    pub theme: Theme,
    /// Thick strokes and large type by this factor.
    pub scale: f32,
}

/// The width of lines in proportion to letters of a height, both in points, to two decimals.
pub(super) fn as_letters(letters: f64) -> f64 {
    crate::numbers::round_to(letters * Size::EDGES_TO_LETTERS, 0.01).max(*PAPER_LINES.start())
}

/// A size on paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// Width and height in centimetres.
    pub size: [f64; 2],
    /// Pixels per inch.
    pub dpi: f64,
    /// Height of the letters of names in points.
    pub letters: f64,
    /// Width of the edges of solids in points. `None` if they are in proportion to the letters.
    pub lines: Option<f64>,
}

impl Paper {
    /// The request for a picture on paper.
    fn asked(self) -> OnPaper {
        let Self { dpi, letters, lines, .. } = self;
        OnPaper { dpi, letters: Some(letters), lines, arranged: true }
    }
}

impl Default for Paper {
    /// A picture in a column of a page.
    fn default() -> Self {
        Self { size: [8.0, 6.0], dpi: 300.0, letters: 9.0, lines: None }
    }
}

impl Export {
    /// The requested file. Of a `family` in multiples of the screen, each picture is as large as there.
    pub(super) fn spec(&self, family: bool) -> ExportSpec {
        let letters = if self.outlines { Letters::Outlines } else { Letters::Text };
        let dpi = self.on_paper.then_some(self.paper.dpi);
        let options = FileOptions { format: self.format, crop: self.crop, dpi, faces: self.faces, letters };
        let size = if !family || self.on_paper || self.times.is_none() {
            SheetSize::Whole([self.width, self.height])
        } else {
            let side_by_side = u32::try_from(self.what.views().count()).unwrap_or(1).max(1);
            SheetSize::Pictures([(self.width / side_by_side).max(1), self.height])
        };
        ExportSpec {
            views: self.what,
            size,
            scale: Some(self.scale),
            transparent: self.is_without_ground(),
            paper: self.on_paper.then(|| self.paper.asked()),
            keeps_width: self.on_paper,
            options,
        }
    }

    /// All three pictures as on the screen, for paper. `sizes` are the width and height of each picture on the screen,
    /// in the order of [`View::ALL`], and `scale` is in pixels there for one unit of stroke width.
    pub fn new(sizes: [[u32; 2]; View::COUNT], scale: f32) -> Self {
        let mut export = Self {
            what: Views::All,
            width: 0,
            height: 0,
            times: Some(2),
            on_paper: false,
            paper: Paper::default(),
            format: PictureFormat::ALL[0],
            transparent: false,
            crop: false,
            faces: Faces::default(),
            outlines: false,
            theme: Theme::Print,
            scale: 1.0,
        };
        export.fit_screen(sizes, scale);
        export
    }

    /// Sets the size to that on paper, or to `times` that on the screen, which may be more than a picture can have.
    /// `sizes` and `scale` are as in [`new`](Self::new).
    pub fn fit_screen(&mut self, sizes: [[u32; 2]; View::COUNT], scale: f32) {
        if self.on_paper {
            let paper = self.paper.asked();
            let [width, height] = self.paper.size.map(|cm| pixels(paper.pixels_across(cm)));
            #[expect(clippy::cast_possible_truncation, reason = "the height of letters")]
            let letters = paper.pixels(self.paper.letters) as f32;
            (self.width, self.height) = (width, height);
            self.scale = Size::with_letters(width, height, letters).scale;
            return;
        }
        let Some(times) = self.times else { return };
        let [width, height] = match self.what {
            Views::One(view) => sizes[view.index()],
            Views::All => together(sizes),
            Views::Without(other) => {
                let all = together(sizes);
                [(all[0] - sizes[other.index()][0].min(all[0] / 3)).max(1), all[1]]
            }
        };
        let side = |pixels: u32| pixels.max(1).saturating_mul(times);
        (self.width, self.height) = (side(width), side(height));
        self.scale = times as f32 * scale;
    }
}

impl Export {
    /// True if the picture will have no ground.
    pub fn is_without_ground(&self) -> bool {
        self.transparent && self.format.has_transparency()
    }
}

/// Whole pixels.
fn pixels(side: f64) -> u32 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "what is too large or too small is told"
    )]
    let side = side.round() as u32;
    side
}

/// Room for three pictures side by side: as on the screen, or, if they are stacked there, as large as the largest, 4 by
/// 3.
fn together(sizes: [[u32; 2]; View::COUNT]) -> [u32; 2] {
    if sizes.iter().all(|size| size[1] == sizes[0][1]) {
        return [sizes.iter().map(|size| size[0]).sum(), sizes[0][1]];
    }
    let area = sizes.iter().map(|[width, height]| f64::from(*width) * f64::from(*height)).fold(1.0, f64::max);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sides of a screen")]
    let side = |v: f64| v.round() as u32;
    [3 * side((area * 4.0 / 3.0).sqrt()), side((area * 0.75).sqrt())]
}

/// Width and height of each picture of a film.
const FILM: Size = Size { width: 640, height: 480, scale: 1.0 };
/// Duration of a step in it.
const STEP_SECONDS: f64 = 2.0;

/// The result of an export: a shortfall, or the reason why no file was written.
pub(super) type Exported = Result<Vec<Shortfall>, ExportError>;

/// A picture being written.
#[derive(Debug)]
pub(super) struct Exporting {
    path: PathBuf,
    worker: Worker<Task, Exported>,
}

/// The source of exported pictures.
pub(super) struct ExportSource {
    figure: Figure,
    shot: Shot,
    files: FigureFiles,
    lang: Lang,
    family: FamilyChoice,
    convention: Convention,
    /// The views whose observer the user has turned.
    turned: [bool; View::ALL.len()],
}

impl ExportSource {
    /// The present screen as a family, in a theme.
    pub(super) fn of(model: &Model, family: &FamilyChoice, theme: Theme) -> Self {
        let mut figure = model.figure_as_shown();
        figure.style.theme = theme;
        let observers = model.desk.shown.figure().observers;
        let mut turned = [true; View::ALL.len()];
        (turned[View::World.index()], turned[View::Canonical.index()]) =
            (observers.world.is_some(), observers.canonical.is_some());
        if family.variations().is_some() {
            // The observer as seen is that of one larger picture. A family has one that holds the subject of each.
            figure.observers = observers;
        }
        // As on the screen: labels don't answer an open question.
        let shot = Shot { asked: model.frame.asked.clone(), ..Shot::of(&figure) };
        let files = model.desk.shown.files();
        let (lang, convention) = (model.settings.lang, model.operations.convention);
        Self { figure, shot, files, lang, family: family.clone(), convention, turned }
    }

    /// The sheet of a family.
    fn family(
        &self,
        (export, request): (&Export, &Request),
        variations: &[Variation],
        camera: &Camera,
        progress: &Progress,
    ) -> Result<Composite, ExportError> {
        let mut files = self.files.clone();
        let figures = variants(&self.figure, camera, variations, self.convention, MAX_FAMILY)?;
        let members = picture::members(figures, |figure| {
            Ok::<_, ExportError>(SharedScene::new(scene_of(figure, &mut |wanted| files.read(wanted), progress)?))
        })?;
        let count = members.len() * export.what.views().count();
        if count > MAX_FAMILY {
            return Err(VariationError::TooMany { count, limit: MAX_FAMILY }.into());
        }
        let FamilyChoice { columns, parts, .. } = self.family;
        // Two keys are a table.
        let columns = columns.or_else(|| variations.get(1).map(|second| second.values.len()));
        let captions = self.family.captions();
        let family = Family { members, views: export.what, columns, parts, captions, observer_of: None };
        Ok(export.spec(true).family(&family, request).map_err(PictureError::from)?)
    }

    /// The text of the figure for a picture at `path`, made from the text of its file, and the files of the figure that
    /// have no room in the picture.
    fn text(&self, source: &str, path: &Path) -> (String, Option<LeftOut>) {
        files::text_in_picture(|figure| update(source, figure), &self.figure, self.files.clone(), path)
    }

    /// The words that go with its pictures into their file.
    pub(super) fn told(&self, sheet: &Composite, figure: String) -> Metadata {
        pictures::told_of(self.lang, &self.figure, sheet, figure)
    }

    /// The camera, and a picture of it.
    fn request(&self, view: View, size: Size, progress: &Progress) -> Result<(Camera, Request), ExportError> {
        let Self { figure, shot, files, lang, .. } = self;
        let camera = Camera::new(&figure.camera)?;
        let mut files = files.clone();
        let scene = SharedScene::new(scene_of(figure, &mut |wanted| files.read(wanted), progress)?);
        let request = Request::new(shot, view, &camera, &scene, pictures::labels(*lang), size);
        Ok((camera, request))
    }

    /// The drawn pictures.
    pub(super) async fn sheet(&self, export: &Export, progress: &Progress) -> Result<Composite, ExportError> {
        let size = Size { width: export.width, height: export.height, scale: export.scale };
        let (camera, request) = self.request(View::Image, size, progress)?;
        if let Some(variations) = self.family.variations() {
            return self.family((export, &request), &variations?, &camera, progress);
        }
        let sheet = export.spec(false).sheet(&request, &self.shot, None, progress).await?;
        // An observer that the user hasn't turned was framed for the window. In a picture of another shape it's framed
        // again if it would leave something out.
        let is_cut = |own: &&Request| {
            !self.turned[own.view.index()] && own.observer.is_some_and(|observer| !own.holds(&observer))
        };
        let mut shot = self.shot.clone();
        for cut in sheet.requests.iter().filter(is_cut) {
            let framed = cut.seen_from().and_then(|observer| cut.fitted(&observer));
            shot.pictures.iter_mut().filter(|own| own.kind == cut.view).for_each(|own| own.observer = framed);
        }
        if shot == self.shot {
            return Ok(sheet);
        }
        Ok(export.spec(false).sheet(&request, &shot, None, progress).await?)
    }
}

/// All inputs of a picture in a file.
pub(super) struct Task {
    subject: ExportSource,
    source: String,
    what: ExportKind,
    path: PathBuf,
    overwrite: Overwrite,
}

/// The kind of the file.
#[derive(Clone)]
pub(super) enum ExportKind {
    Pictures(Export),
    /// Pages to print.
    Handout(Box<Job>),
    /// The way to the canonical volume by these steps, in a theme.
    Animation(Decomposition, Theme),
}

impl Exporting {
    /// Draws and writes beside the window's thread.
    pub(super) fn start(ctx: &egui::Context, task: Task) -> Self {
        Self::with(ctx, task, || async |task: Task, progress: &Progress| task.run(progress).await)
    }

    /// As [`start`](Self::start), with other functions that draw and write.
    pub(super) fn with<W: AsyncFnMut(Task, &Progress) -> Exported + 'static>(
        ctx: &egui::Context,
        task: Task,
        make: impl Fn() -> W + Send + Sync + 'static,
    ) -> Self {
        let path = task.path.clone();
        let mut worker = Worker::new("export", crate::clock::now, make);
        worker.ask(&frames(ctx), 0, task);
        Self { path, worker }
    }

    /// The path of the file.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The running work.
    pub(super) fn running(&self) -> Option<Running> {
        self.worker.running()
    }

    /// Gives it up. It still ends, but soon.
    pub(super) fn cancel(&self) {
        self.worker.cancel();
    }

    /// The result and its path, once it's done.
    pub(super) fn take(&mut self) -> Option<(PathBuf, Exported)> {
        let [done] = self.worker.take(std::time::Duration::ZERO);
        Some((self.path.clone(), done?.outcome.unwrap_or(Err(ExportError::Panic))))
    }
}

impl Task {
    pub(super) fn new(
        model: &Model,
        family: &FamilyChoice,
        what: ExportKind,
        (path, overwrite): (PathBuf, Overwrite),
    ) -> Self {
        let theme = match what {
            ExportKind::Pictures(export) => export.theme,
            ExportKind::Animation(_, theme) => theme,
            ExportKind::Handout(_) => Theme::Light,
        };
        let subject = ExportSource::of(model, family, theme);
        Self { subject, source: model.desk.shown.source().to_owned(), what, path, overwrite }
    }

    async fn run(self, progress: &Progress) -> Exported {
        let (PictureFile { bytes, beside, over_budget, .. }, left_out) =
            self.file(progress).await.map_err(|error| match error {
                _ if progress.is_cancelled() => ExportError::Cancelled,
                error => error,
            })?;
        save_both(&self.path, &bytes, beside, self.overwrite)?;
        Ok(over_budget.map(Shortfall::OverBudget).into_iter().chain(left_out.map(Shortfall::LeftOut)).collect())
    }

    /// The file, with the figure file in it, and the files of the figure that have no room in it.
    async fn file(&self, progress: &Progress) -> Result<(PictureFile, Option<LeftOut>), ExportError> {
        let Self { subject, source, what, path, .. } = self;
        let export = match what {
            ExportKind::Pictures(export) => export,
            ExportKind::Handout(job) => {
                let (bytes, solutions) = job.pdfs(progress).await?;
                let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                let name = handouts::solutions_file(&stem, job.options.lang);
                let beside = solutions.map(|bytes| Beside { name, bytes });
                return Ok((PictureFile { bytes, beside, over_budget: None, no_areas: None }, None));
            }
            ExportKind::Animation(decomposition, _) => {
                let film = Animation {
                    request: subject.request(View::Canonical, FILM, progress)?.1,
                    decomposition: *decomposition,
                };
                let format = FilmFormat::of(path).unwrap_or(FilmFormat::Animation(AnimationFormat::Gif));
                let (text, left_out) = subject.text(source, path);
                let told = subject.told(&film.stills(), text).for_file(path);
                return Ok((film.file(format, STEP_SECONDS, &told, progress).await?, left_out));
            }
        };
        let sheet = subject.sheet(export, progress).await?;
        let (text, left_out) = subject.text(source, path);
        let told = subject.told(&sheet, text).for_file(path);
        Ok((picture::file(&sheet, export.spec(false).options, &told, progress).await?, left_out))
    }
}

/// Writes charts, in the format given by the ending of the file.
pub(super) fn save_chart(chart: &ChartFile, lang: Lang, path: &Path, overwrite: Overwrite) -> Result<(), FileError> {
    let ChartFile { block, csv, json } = chart;
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    for (table, own) in [(csv, "csv"), (json, "json")] {
        if !table.is_empty() && ending.as_deref() == Some(OsStr::new(own)) {
            return files::save(path, table.as_bytes(), overwrite);
        }
    }
    let format = PictureFormat::of(path).unwrap_or(PictureFormat::Svg);
    let (bytes, beside) = encode(std::slice::from_ref(block), lang.tag(), format, path)
        .map_err(|error| FileError::Write(std::io::Error::other(error)))?;
    save_both(path, &bytes, beside, overwrite)
}

fn save_both(path: &Path, bytes: &[u8], beside: Option<Beside>, overwrite: Overwrite) -> Result<(), FileError> {
    if let Some(Beside { name, bytes }) = beside {
        files::save(&path.with_file_name(name), &bytes, overwrite)?;
    }
    files::save(path, bytes, overwrite)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_another_shape_is_framed_again_unless_the_user_has_turned_it() {
        let mut state = crate::gui::app::state::State::new(crate::gui::Start::default()).expect("a camera");
        state.model.frame.picture_sizes = [[1200, 300]; 3];
        let narrow = Export { what: Views::One(View::World), ..Export::new([[300, 400]; 3], 1.0) };
        let sheet = |state: &crate::gui::app::state::State| {
            let source = ExportSource::of(&state.model, &FamilyChoice::default(), Theme::Light);
            let mut sheet = crate::progress::at_once(source.sheet(&narrow, &Progress::default())).expect("a sheet");
            sheet.requests.remove(0)
        };
        // The window keeps its observer while the camera moves, and that one may be too near for a narrow picture.
        let fitted = sheet(&state).seen_from().expect("a world");
        let near = crate::figure::Observer { distance: 0.5 * fitted.distance, ..fitted };
        state.model.frame.seen.world = Some(near);
        let own = sheet(&state);
        assert!(own.observer.is_some_and(|observer| observer != near && own.holds(&observer)));
        state.model.desk.shown.observers_mut().world = Some(near);
        assert_eq!(sheet(&state).seen_from(), Some(near), "a close look stays");
    }

    #[test]
    fn a_family_holds_its_subjects_in_small_pictures_too() {
        let mut state = crate::gui::app::state::State::new(crate::gui::Start::default()).expect("a camera");
        // As in a wide window, whose observer is too near for narrow pictures.
        state.model.frame.picture_sizes = [[1200, 300]; 3];
        state.family.choose(family_choice::Subject::Ready(1));
        let source = ExportSource::of(&state.model, &state.family, Theme::Light);
        let size = Size { width: 800, height: 600, scale: 1.0 };
        let (camera, request) = source.request(View::Image, size, &Progress::default()).expect("a picture");
        let export = Export { what: Views::One(View::World), ..Export::new([[400, 300]; 3], 1.0) };
        let variations = source.family.variations().expect("a family").expect("values");
        let sheet = source.family((&export, &request), &variations, &camera, &Progress::default()).expect("a sheet");
        assert_eq!(sheet.requests.len(), 4);
        for own in &sheet.requests {
            assert!(own.holds(&own.seen_from().expect("a world")), "{:?}", own.size);
        }
    }

    #[test]
    fn a_size_on_paper_has_pixels_and_letters() {
        let mut export = Export { on_paper: true, ..Export::new([[400, 300]; 3], 1.0) };
        export.fit_screen([[400, 300]; 3], 1.0);
        assert_eq!((export.width, export.height), (945, 709));
        let size = Size { width: 945, height: 709, scale: export.scale };
        assert!((size.letters() - 37.5).abs() < 0.1, "9 pt at 300 dpi: {}", size.letters());
    }

    #[test]
    fn three_pictures_have_room_side_by_side() {
        assert_eq!(together([[400, 600], [300, 600], [300, 600]]), [1000, 600]);
        assert_eq!(together([[800, 300], [395, 300], [395, 301]]), [3 * 566, 424]);
    }
}
