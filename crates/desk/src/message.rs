//! Messages at the bottom of the window, as values. Their words are chosen when they are shown, in the language of that
//! moment.

use std::path::{Path, PathBuf};

use crate::camera::CameraError;
use crate::export::png::PngError;
use crate::export_error::ExportError;
use crate::pipeline::OverBudget;
use crate::sanitize;
use crate::scene::{MeshNotice, Preset, SceneError};
use camera_lab_files::{FileError, LeftOut};
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_messages, lessons};
use camera_lab_words::messages::{self, faults};
use camera_lab_words::why::explain_point;
use camera_lab_words::window::{self, cameras, canvas, compare, photograph, scenes, sessions, sharing};

/// A message at the bottom of the window.
#[derive(Debug)]
pub enum Message {
    /// The numbers are in the clipboard.
    NumbersCopied,
    /// The position in a sequence of figures.
    Step {
        /// From 1.
        number: usize,
        /// Number of figures.
        of: usize,
        /// True if the figure before it has changes that aren't saved. It waits in its place.
        leaves_work: bool,
    },
    /// The kept operations don't lead to the camera any more, so they've left the figure.
    OperationsGone,
    /// The reason why a file was skipped, and the number of other skipped files.
    AndMore(Box<Self>, usize),
    /// No figure before this one.
    FirstFigure,
    /// No figure after this one.
    LastFigure,
    /// A step was added to the lesson in a file. Holds its number, and the files of the figure that it can't show.
    StepAdded(PathBuf, usize, Option<LeftOut>),
    /// A step was replaced by the state on the screen. Holds its lesson, and the files that it can't show.
    OutOfReach(PathBuf, LeftOut),
    /// The files of a link that aren't beside the copy of its lesson.
    NotBeside(PathBuf, LeftOut),
    /// A step was replaced by the state on the screen. Holds the keys that changed.
    StepTook(Vec<String>),
    /// The texts of a step can't be written into the file of its lesson.
    StepNotKept(PathBuf, FileError),
    /// Another program changed the file of the lesson.
    LessonChanged(PathBuf),
    /// A QR code needs the address of a page.
    AddressFirst,
    /// The camera is in the list now, under this name.
    CameraKept(String),
    /// There are no sides to swap.
    NothingToSwap,
    /// The figure in this file, whose camera this one is compared with, has another scene.
    OtherScene(PathBuf),
    /// No step of the lesson before this one.
    FirstStep,
    /// No step of the lesson after this one.
    LastStep,
    /// A step of the lesson has an open task.
    TaskFirst,
    /// The observer of a picture went back to keep everything in it.
    WentBack(crate::views::View),
    /// A file has been opened.
    Opened(PathBuf),
    /// Several files were dropped at once, and this one was opened.
    FirstOfDropped(PathBuf, usize),
    /// A file has been written.
    Saved(PathBuf),
    /// The figure is being written to a file.
    Saving(PathBuf),
    /// A file was handed to the browser.
    Downloaded(PathBuf),
    /// A file was chosen for a figure that the window no longer shows. It wasn't used.
    OtherFigure(PathBuf),
    /// A link with this number of characters is in the clipboard.
    LinkCopied(usize),
    /// The figure of a link is shown.
    LinkOpened,
    /// A text has this link, which leads neither to a page nor to mail.
    LinkRefused(String),
    /// A file can't be read or written.
    File(PathBuf, FileError),
    /// The camera of the figure in this file is impossible.
    NotOpened(PathBuf, CameraError),
    /// The mesh in this file makes no scene.
    NoScene(PathBuf, SceneError),
    /// A figure can't be saved before its impossible camera is repaired.
    NotSaved(CameraError),
    /// The opened file has an impossible camera. Its numbers are in the fields.
    Impossible(PathBuf, CameraError),
    /// An operation leads to no camera.
    Camera(CameraError),
    /// The scene can't be built.
    Scene(SceneError),
    /// The photograph under the image can't be used.
    NoPhotograph(MeshNotice),
    /// A picture has a shortfall.
    OverBudget(OverBudget),
    /// A picture is being written.
    Exporting,
    /// The picture in this file is written, with shortfalls.
    SavedOtherwise(PathBuf, Vec<Shortfall>),
    /// No picture was written to this file.
    NotExported(PathBuf, NotExported),
    /// A named scene is a list of objects now.
    WrittenOut(Preset),
    /// An object with a new parent is sheared now, and didn't stay in place.
    Shear,
    /// An object is deleted.
    Deleted {
        /// Its name.
        name: String,
        /// Number of others removed with it.
        others: usize,
        /// True if a child is sheared, and didn't stay in place.
        shear: bool,
    },
    /// The light with this place in the list, from 0, is deleted.
    LightDeleted(usize),
    /// Objects that can't be selected together.
    SelectedAlone,
    /// No more points can be followed.
    TooManyPoints,
    /// The progress in exercises is deleted, and still in this file.
    ProgressDeleted(PathBuf),
}

/// The shortfall of a written picture.
#[derive(Debug)]
pub enum Shortfall {
    /// It's drawn otherwise.
    OverBudget(OverBudget),
    /// It doesn't carry the files of its figure.
    LeftOut(LeftOut),
}

/// The reason why no picture was written.
#[derive(Debug)]
pub struct NotExported(pub ExportError);

impl Message {
    /// Something went wrong.
    pub fn is_error(&self) -> bool {
        self.row(Lang::En).0 == Tone::Error
    }

    /// True if the message disappears by itself. Errors, and lasting states, stay.
    pub fn passes(&self) -> bool {
        self.row(Lang::En).0 == Tone::News
    }

    /// The sentence.
    pub fn text(&self, lang: Lang) -> String {
        sanitize::printable(self.row(lang).1.trim())
    }

    /// Tone and sentence.
    fn row(&self, lang: Lang) -> (Tone, String) {
        use Tone::{Error, Lasting, News};
        let (t, scene, sharing) = (window::texts(lang), scenes::texts(lang), sharing::texts(lang));
        let about = |words: &str, path: &Path| format!("{words} {}", sanitize::path(path));
        match self {
            Self::NumbersCopied => (News, t.copied.to_owned()),
            Self::Step { number, of, leaves_work: false } => (News, format!("{number} / {of}")),
            Self::Step { number, of, .. } => (News, format!("{number} / {of} · {}", t.work_waits)),
            Self::OperationsGone => (News, t.operations_gone.to_owned()),
            Self::AndMore(first, more) => (Error, exercise_messages::and_more(lang, &first.text(lang), *more)),
            Self::StepAdded(path, number, None) => (News, lessons::step_added(lang, &sanitize::path(path), *number)),
            Self::StepAdded(path, number, Some(left_out)) => {
                let added = lessons::step_added(lang, &sanitize::path(path), *number);
                (Error, format!("{added}; {}", messages::out_of_reach(lang, left_out)))
            }
            Self::OutOfReach(path, left_out) => {
                (Error, format!("{}: {}", sanitize::path(path), messages::out_of_reach(lang, left_out)))
            }
            Self::NotBeside(path, left_out) => {
                (Error, format!("{}: {}", sanitize::path(path), messages::not_beside(lang, left_out)))
            }
            Self::StepTook(keys) if keys.is_empty() => (News, lessons::texts(lang).took_nothing.to_owned()),
            Self::StepTook(keys) => {
                let mut words: Vec<String> = Vec::new();
                for word in keys.iter().map(|key| window::key_in_words(lang, key)) {
                    if !words.contains(&word) {
                        words.push(word);
                    }
                }
                (News, format!("{} {}", lessons::texts(lang).took, words.join(", ")))
            }
            Self::StepNotKept(path, error) => {
                let why = messages::file(lang, &sanitize::path(path), error);
                (Error, format!("{}: {why}", lessons::texts(lang).not_written))
            }
            Self::LessonChanged(path) => (Error, lessons::changed_elsewhere(lang, &sanitize::path(path))),
            Self::CameraKept(name) => (News, cameras::kept(lang, &sanitize::escaped(name))),
            Self::NothingToSwap => (News, compare::texts(lang).no_sides.to_owned()),
            Self::OtherScene(path) => (News, compare::other_scene(lang, &sanitize::path(path))),
            Self::AddressFirst => (News, sharing::texts(lang).address_first.to_owned()),
            Self::FirstStep => (News, lessons::texts(lang).first_step.to_owned()),
            Self::LastStep => (News, lessons::texts(lang).last_step.to_owned()),
            Self::TaskFirst => (News, lessons::texts(lang).task_first.to_owned()),
            Self::FirstFigure => (News, t.first_figure.to_owned()),
            Self::LastFigure => (News, t.last_figure.to_owned()),
            Self::WentBack(view) => (News, canvas::went_back(lang, *view)),
            Self::Opened(path) => (News, about(t.opened, path)),
            Self::FirstOfDropped(path, count) => {
                (News, sessions::first_of_dropped(lang, &sanitize::path(path), *count))
            }
            Self::Saved(path) => (News, about(t.saved, path)),
            Self::Saving(path) => (Lasting, about(t.saving, path)),
            Self::Downloaded(path) => (News, about(sharing.downloaded, path)),
            Self::OtherFigure(path) => (Error, about(t.other_figure, path)),
            Self::LinkCopied(length) => (News, format!("{} {length} {}", sharing.copied, sharing.characters)),
            Self::LinkRefused(link) => (Error, format!("{} {}", t.link_refused, sanitize::within(link, 120))),
            Self::LinkOpened => (News, sharing.opened.to_owned()),
            // A picture without a figure may be meant as a photograph.
            Self::File(path, error @ (FileError::Png(PngError::NoFigure) | FileError::OtherPicture(_))) => {
                let why = messages::file(lang, &messages::opened(lang, path), error);
                (Error, format!("{why}. {}", photograph::texts(lang).not_a_figure))
            }
            Self::File(path, error) => (Error, messages::file(lang, &messages::opened(lang, path), error)),
            Self::NotOpened(path, error) => {
                (Error, format!("{}: {}", messages::opened(lang, path), messages::camera(lang, error)))
            }
            Self::NoScene(path, error) => (Error, messages::opened_mesh(lang, &messages::opened(lang, path), error)),
            Self::NotSaved(error) => (Error, format!("{} {}", t.not_saved, faults::camera_error(lang, error))),
            Self::Impossible(path, error) => (
                Error,
                format!("{}: {}. {}", messages::opened(lang, path), messages::camera(lang, error), t.numbers_in_fields),
            ),
            Self::Camera(error) => (Error, faults::camera_error(lang, error)),
            Self::Scene(error) => (Error, messages::scene_in_window(lang, error)),
            Self::NoPhotograph(notice) => (Error, messages::mesh_notice(lang, notice)),
            Self::OverBudget(over_budget) => (Error, messages::over_budget(lang, over_budget)),
            Self::Exporting => (Lasting, t.exporting.to_owned()),
            Self::SavedOtherwise(path, shortfalls) => {
                let words = |shortfall: &Shortfall| match shortfall {
                    Shortfall::OverBudget(over_budget) => messages::over_budget(lang, over_budget),
                    Shortfall::LeftOut(left_out) => {
                        format!("{} ({})", messages::left_out(lang, left_out), t.save_with_files)
                    }
                };
                let parts = std::iter::once(about(t.saved, path)).chain(shortfalls.iter().map(words));
                (Error, parts.collect::<Vec<_>>().join("; "))
            }
            Self::NotExported(path, NotExported(error)) => {
                let tone = if matches!(error, ExportError::Cancelled) { News } else { Error };
                (tone, error.text(lang, &sanitize::path(path)))
            }
            Self::WrittenOut(preset) => (News, format!("{} {}", scene.copied, scenes::lost(lang, *preset))),
            Self::Shear => (News, scene.shear.to_owned()),
            Self::Deleted { name, others, shear } => {
                let others = if *others > 0 { format!(" (+ {others})") } else { String::new() };
                let shear = if *shear { scene.shear } else { "" };
                (News, format!("{} {}{others}. {shear}", scene.deleted, sanitize::escaped(name)))
            }
            Self::LightDeleted(index) => (News, format!("{} {} {}", scene.deleted, scene.light, index + 1)),
            Self::SelectedAlone => (News, scene.selected_alone.to_owned()),
            Self::ProgressDeleted(path) => (News, exercise_messages::progress_deleted(lang, &sanitize::path(path))),
            Self::TooManyPoints => (News, explain_point::texts(lang).too_many.to_owned()),
        }
    }
}

/// The tone of a message.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tone {
    /// Short news, which disappear by themselves soon.
    News,
    /// Shown as long as it holds.
    Lasting,
    /// Something went wrong.
    Error,
}
