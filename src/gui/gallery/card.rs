//! A figure in the gallery, with its source and its display. It's read and drawn beside the window's thread.

use std::collections::hash_map::DefaultHasher;
use std::collections::{HashMap, HashSet};
use std::hash::{Hash as _, Hasher as _};
use std::path::{Path, PathBuf};

use crate::appearance::Theme;
use crate::export::format::{FIGURE_ENDINGS, PictureFormat};
use crate::export::png::figure_bytes;
use crate::figure::{Figure, Localized};
use crate::picture::{Pixels, Renderer};
use crate::progress::Progress;
use crate::scene::import::MESH_ENDINGS;
use crate::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_desk::{Document, Source};
use camera_lab_files::{self as files, FigureFiles, FileAccess, FileError, Opened, ShippedFigure, figure_from};
use camera_lab_words::learn::lessons;
use camera_lab_words::{Lang, messages, pictures, told, window};

/// The size of a small picture in pixels.
pub(super) const SIZE: Size = Size { width: 192, height: 144, scale: 1.0 };

/// Number of displayed files of a folder.
pub(super) const MOST_FILES: usize = 500;

/// Number of cached thumbnails, by their content.
const MOST_KEPT: usize = MOST_FILES + 100;

/// A request to the worker.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum CardJob {
    /// The files of a folder that can be opened.
    List(PathBuf),
    /// Which of these files exist.
    Sort(Vec<PathBuf>),
    /// The titles and sentences of these figures, which are ready long before their pictures.
    Read(Vec<Source>, Lang),
    /// A small picture of a figure.
    Draw { source: Source, theme: Theme, lang: Lang },
}

/// The result of a request.
pub(super) enum CardOutcome {
    /// The files of this folder that can be opened, the newest first, and the number of older ones that weren't looked
    /// into, or the reason why it can't be read.
    Listed(PathBuf, Result<(Vec<PathBuf>, usize), FileError>),
    /// These files, existing ones first, and the missing ones.
    Sorted(Vec<PathBuf>, HashSet<PathBuf>),
    /// The titles and captions of figures. Empty if there is none, or if the figure can't be read.
    Read(Vec<(Source, CardText)>),
    /// A small picture of a figure, or the reason why there is none.
    Drawn(Source, Drawn),
}

/// The words of a figure about itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct CardText {
    pub(super) title: String,
    pub(super) sentence: String,
}

/// A small picture, or the reason why there is none.
pub(super) type Drawn = Result<Pixels, String>;

/// The work that draws thumbnails, and caches them by their content.
pub(super) fn work() -> impl AsyncFnMut(CardJob, &Progress) -> CardOutcome {
    // A file that stalls mustn't keep the others from being shown.
    #[cfg(not(target_arch = "wasm32"))]
    files::limit_waiting(files::WINDOW_WAIT);
    let mut renderer = Renderer::default();
    let mut kept: HashMap<u64, Drawn> = HashMap::new();
    async move |job, progress: &Progress| match job {
        CardJob::List(folder) => {
            let list = files_in(&folder, progress);
            CardOutcome::Listed(folder, list)
        }
        CardJob::Sort(paths) => {
            let is_there = |path: &PathBuf| !files::is_network(path) && files::disk::may_exist(path);
            let (mut there, gone): (Vec<PathBuf>, Vec<PathBuf>) = paths.into_iter().partition(is_there);
            there.extend(gone.iter().cloned());
            CardOutcome::Sorted(there, gone.into_iter().collect())
        }
        CardJob::Read(sources, lang) => {
            let of = |source: Source| {
                let told = if progress.is_cancelled() { CardText::default() } else { said_by(&source, lang) };
                (source, told)
            };
            CardOutcome::Read(sources.into_iter().map(of).collect())
        }
        CardJob::Draw { source, theme, lang } => {
            let text = read(&source);
            let mut hasher = DefaultHasher::new();
            (text.as_ref().ok(), theme as u8, lang, source.folder()).hash(&mut hasher);
            if let Some(path) = mesh(&source) {
                // It's read once, when it's drawn.
                (path, files::disk::written(path)).hash(&mut hasher);
            }
            let key = hasher.finish();
            if let (Some(drawn), Ok(_)) = (kept.get(&key), &text) {
                return CardOutcome::Drawn(source, drawn.clone());
            }
            renderer.watch(progress);
            let drawn = match text.and_then(|bytes| figure_of(&source, &bytes)) {
                Ok(opened) => draw(&mut renderer, &source, opened, (theme, lang), progress),
                Err(error) => Err(messages::file(lang, &source.name(), &error)),
            };
            if kept.len() >= MOST_KEPT {
                kept.clear();
            }
            if drawn.is_ok() {
                kept.insert(key, drawn.clone());
            }
            CardOutcome::Drawn(source, drawn)
        }
    }
}

/// The file of a mesh, which opens as a scene.
fn mesh(source: &Source) -> Option<&Path> {
    match source {
        Source::File(path) if files::has_ending(path, MESH_ENDINGS) => Some(path),
        _ => None,
    }
}

/// The bytes of a figure. None for a mesh.
fn read(source: &Source) -> Result<Vec<u8>, FileError> {
    match source {
        _ if mesh(source).is_some() => Ok(Vec::new()),
        Source::Shipped(name) => {
            Ok(ShippedFigure::named(name).map(|figure| figure.text().as_bytes().to_vec()).unwrap_or_default())
        }
        Source::File(path) => files::read_figure_file(path),
    }
}

/// The figure of a card: that of its file, the scene of a mesh, or the first step of a lesson, with title and sentence
/// of the lesson.
fn figure_of(source: &Source, bytes: &[u8]) -> Result<Opened, FileError> {
    if let Some(path) = mesh(source) {
        // Numbers that are too large for any camera.
        let document = Document::of_mesh(path).map_err(|_| FileError::Read(std::io::ErrorKind::InvalidData.into()))?;
        let figure = document.figure().clone();
        return Ok(Opened { figure, text: String::new(), from_picture: true, carried: Default::default() });
    }
    match source {
        Source::File(path) if files::is_lesson(path) => {
            let lesson = crate::lessons::parse_bytes(bytes)?;
            let first = lesson.steps.first().map(|step| (*step.figure).clone()).unwrap_or_default();
            let figure = Figure { title: Some(lesson.title), caption: lesson.sentence, ..first };
            Ok(Opened { figure, text: String::new(), from_picture: false, carried: Default::default() })
        }
        _ => figure_from(bytes),
    }
}

fn draw(
    renderer: &mut Renderer,
    source: &Source,
    opened: Opened,
    (theme, lang): (Theme, Lang),
    progress: &Progress,
) -> Drawn {
    let mut figure = opened.figure;
    figure.style.theme = theme;
    let camera = crate::camera::Camera::new(&figure.camera).map_err(|error| messages::camera(lang, &error))?;
    let reach = match source {
        Source::Shipped(_) => FileAccess::Figure,
        Source::File(path) => FileAccess::of(path, opened.from_picture, false),
    };
    let mut files = FigureFiles::new(source.folder().unwrap_or(Path::new("")), reach).with(&opened.carried);
    let scene = scene_of(&figure, &mut |wanted| files.read(wanted), progress);
    let scene = SharedScene::new(scene.map_err(|error| messages::scene(lang, &error))?);
    let shown = figure.screen.pictures.unwrap_or([true; View::COUNT]);
    // The image, or the last picture of a figure that hides it.
    let view = View::ALL.into_iter().rev().find(|view| shown[view.index()]).unwrap_or(View::Image);
    let request = Request::of(&figure, view, &camera, &scene, pictures::labels(lang), SIZE);
    renderer.pixels(&request).ok_or_else(|| window::texts(lang).picture_too_large.to_owned())
}

/// Reads the title and caption of a figure, even if it can't be drawn. A file without a title has its name, which
/// stands before the caption otherwise. A file without a caption has its first comment.
fn said_by(source: &Source, lang: Lang) -> CardText {
    let in_lang = |text: &Localized| told(lang, text).to_owned();
    match source {
        Source::Shipped(name) => {
            let texts = ShippedFigure::named(name).map(ShippedFigure::told).unwrap_or_default();
            let [title, sentence] = texts.map(|text| in_lang(&text));
            CardText { title, sentence }
        }
        // Only its picture needs the mesh itself.
        Source::File(_) if mesh(source).is_some() => {
            CardText { title: source.name().into_owned(), sentence: String::new() }
        }
        Source::File(path) => {
            let bytes = read(source).unwrap_or_default();
            let figure = figure_of(source, &bytes).map(|opened| opened.figure).unwrap_or_default();
            let text = figure_bytes(&bytes, crate::limits::MAX_FIGURE_BYTES).unwrap_or_default();
            let title = figure.title.as_ref().map_or_else(|| source.name().into_owned(), in_lang);
            let is_lesson = files::is_lesson(path);
            let title = if is_lesson { format!("{}: {title}", lessons::texts(lang).see_lesson) } else { title };
            let comment = || first_comment(&String::from_utf8_lossy(&text));
            let sentence = figure.caption.as_ref().map_or_else(comment, in_lang);
            // A text, a PDF and a PNG of one figure differ in their names.
            let is_named = figure.title.is_none() || sentence.is_empty();
            let name = crate::sanitize::escaped(&source.name());
            let sentence = if is_named { sentence } else { format!("{name} · {sentence}") };
            CardText { title, sentence }
        }
    }
}

/// The first comment of a figure file, on one line.
fn first_comment(text: &str) -> String {
    let lines = text.lines().skip_while(|line| line.trim().is_empty());
    let comment = lines.map_while(|line| line.trim().strip_prefix('#')).map(str::trim);
    comment.collect::<Vec<_>>().join(" ").trim().to_owned()
}

/// The files of a folder that can be opened, the newest first: figures, pictures that hold one, lessons and meshes.
/// Also the number of older files that weren't looked into.
fn files_in(folder: &Path, progress: &Progress) -> Result<(Vec<PathBuf>, usize), FileError> {
    let mut paths = entries(folder)?;
    let is_candidate =
        |path: &PathBuf| files::has_ending(path, &FIGURE_ENDINGS) || files::has_ending(path, MESH_ENDINGS);
    paths.retain(is_candidate);
    natural(&mut paths);
    paths.sort_by_cached_key(|path| std::cmp::Reverse(files::disk::written(path)));
    let older = paths.split_off(paths.len().min(MOST_FILES)).len();
    let is_picture = |path: &Path| PictureFormat::of(path).is_some();
    let holds_figure = |path: &Path| {
        let bytes = if progress.is_cancelled() { None } else { files::read_figure_file(path).ok() };
        bytes.is_some_and(|bytes| figure_from(&bytes).is_ok())
    };
    paths.retain(|path| !is_picture(path) || holds_figure(path));
    Ok((paths, older))
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    if files::is_network(folder) { Err(FileError::Network) } else { files::entries(folder) }
}

/// Sorts in natural order (2 before 10).
fn natural(paths: &mut [PathBuf]) {
    paths.sort_by(|a, b| crate::numbers::natural_order(&a.to_string_lossy(), &b.to_string_lossy()));
}

/// The figure files in a folder, in natural order (2 before 10).
///
/// # Errors
/// [`FileError`] if the folder can't be read.
pub fn figures_in(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let mut paths = entries(folder)?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")));
    // Lessons are among the lessons.
    paths.retain(|path| !files::is_lesson(path));
    natural(&mut paths);
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::at_once;
    use crate::testing::{Directory, Stall};

    #[test]
    fn a_lesson_has_the_card_of_its_first_step() {
        let folder = std::env::temp_dir().join(format!("camera-lab-card-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        let shipped = &crate::lessons::shipped()[0];
        let path = folder.join("mine.toml");
        std::fs::write(&path, shipped.text).expect("a file is written");
        let source = Source::File(path);
        let card = said_by(&source, Lang::En);
        assert_eq!(card.title, format!("Lesson: {}", shipped.lesson.title.en));
        let sentence = shipped.lesson.sentence.as_ref().map(|text| format!("mine.toml · {}", text.en));
        assert_eq!(Some(card.sentence), sentence);
        let figure = figure_of(&source, shipped.text.as_bytes()).expect("a figure").figure;
        assert!(figure.camera == shipped.lesson.steps[0].figure.camera);
        std::fs::remove_dir_all(&folder).expect("the folder is removed");
    }

    #[test]
    fn the_first_comment_of_a_figure_file_describes_it() {
        assert_eq!(first_comment("\n# A house\n#  by the sea.\n\n# Not this.\n[camera]\n"), "A house by the sea.");
        assert_eq!(first_comment("[camera]\n# late\n"), "");
    }

    #[test]
    fn every_figure_of_the_program_has_a_small_picture_and_a_broken_file_says_why() {
        let (mut work, progress) = (work(), Progress::default());
        for figure in files::SHIPPED_FIGURES {
            let source = Source::Shipped(figure.name);
            let job = CardJob::Draw { source: source.clone(), theme: Theme::Light, lang: Lang::PtBr };
            let CardOutcome::Drawn(of, drawn) = at_once(work(job, &progress)) else { panic!("{}", figure.name) };
            let picture = drawn.map(|picture| [picture.width(), picture.height()]);
            assert_eq!((of, picture), (source, Ok([SIZE.width, SIZE.height])), "{}", figure.name);
        }
        let source = Source::File(PathBuf::from("/no/such/file.toml"));
        let job = CardJob::Draw { source, theme: Theme::Light, lang: Lang::En };
        let CardOutcome::Drawn(_, drawn) = at_once(work(job, &progress)) else { panic!("a file") };
        assert!(drawn.is_err_and(|why| why.contains("no such file")));
    }

    #[test]
    fn a_stalled_file_keeps_no_other_from_being_shown() {
        let directory = Directory::new("gallery");
        let [slow, quick] = ["a-slow.toml", "b-quick.toml"].map(|name| directory.path().join(name));
        for path in [&slow, &quick] {
            std::fs::write(path, "# A figure.\n[scene]\npreset = \"cube\"\n").expect("written");
        }
        let folder = directory.path().to_owned();
        let stall = Stall::of(&slow);
        // On a thread of its own, as in the window.
        let done = std::thread::spawn(move || {
            let (mut work, progress) = (work(), Progress::default());
            let CardOutcome::Listed(_, files) = at_once(work(CardJob::List(folder), &progress)) else {
                panic!("a list")
            };
            let mut files = files.expect("readable").0;
            // The newest is the first, if the clock of the disk can tell.
            natural(&mut files);
            let sources: Vec<Source> = files.into_iter().map(Source::File).collect();
            assert_eq!(sources.len(), 2);
            let CardOutcome::Read(told) = at_once(work(CardJob::Read(sources.clone(), Lang::En), &progress)) else {
                panic!("words")
            };
            let drawn = sources.into_iter().map(|source| {
                let job = CardJob::Draw { source, theme: Theme::Light, lang: Lang::En };
                let CardOutcome::Drawn(_, drawn) = at_once(work(job, &progress)) else { panic!("a picture") };
                drawn.map(|_| ())
            });
            (told, drawn.collect::<Vec<_>>())
        });
        let (told, drawn) = done.join().expect("no panic");
        assert_eq!(told[1].1.sentence, "A figure.");
        assert!(drawn[0].as_ref().is_err_and(|why| why.contains("too long")) && drawn[1].is_ok(), "{drawn:?}");
        drop(stall);
    }
}
