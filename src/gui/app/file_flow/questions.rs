//! Questions about files, and pending work with them.

use std::mem::{Discriminant, discriminant};
use std::path::{Path, PathBuf};

use super::reading::Reading;
pub use super::saving::Agreed;
use super::saving::Saving;
use crate::figure::Localized;
use crate::gui::export::preview::Preview;
use crate::gui::export::{Export, Exported, Exporting};
use crate::gui::inspector::state::compare::CompareForm;
use crate::gui::learn::handout::form::HandoutForm;
use crate::gui::learn::handout::pages::PagesPreview;
use crate::gui::platform::native::{FileQuestion, OpenFileDialog};
use camera_lab_desk::{FileFor, LineComparison, Message, NewsList, Revision, Running, Theirs, Watch};
use camera_lab_words::class::ClassReport;
use camera_lab_words::window::{self, scenes};

/// The purpose of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Purpose {
    /// To open it.
    Open,
    /// To save the figure in it.
    Save,
    /// To save the figure in it, and the files of the figure beside it.
    SaveWithFiles,
    /// For the feature that requested it.
    For(FileFor),
    /// To write a picture.
    Export(Export),
    /// A folder, whose figures the gallery will show.
    Folder,
    /// To add a step to a lesson.
    Step,
    /// To add a step to a lesson, and to write the lesson.
    NewLesson,
    /// To copy a built-in lesson. The user continues writing in the copy.
    OwnLesson,
    /// To save the lesson with the text that can't be saved in its own file.
    LessonText,
    /// To write a lesson or exercises as pages to print.
    Handout(HandoutForm),
    /// The page in one file, for a file to hand out.
    Page(HandOut),
    /// To write a file to hand out, made of the page in this file.
    HandOut(HandOut, PathBuf),
}

/// A file to hand out, with the open lesson or figure in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandOut {
    /// The page for students.
    Page,
    /// The package for a course platform.
    Course,
}

impl Purpose {
    /// True if the state on the screen becomes a step of a lesson.
    pub(in crate::gui) const fn adds_step(&self) -> bool {
        matches!(self, Self::Step | Self::NewLesson)
    }

    /// True if the file is a lesson of the user's own.
    pub(in crate::gui) const fn writes_lesson(&self) -> bool {
        self.adds_step() || matches!(self, Self::OwnLesson | Self::LessonText)
    }

    /// True if the file is for the displayed figure.
    pub(in crate::gui) fn is_about_figure(&self) -> bool {
        !matches!(
            self,
            Self::Open
                | Self::Folder
                | Self::For(
                    FileFor::Progress
                        | FileFor::Exercises
                        | FileFor::Class
                        | FileFor::ClassReport(_)
                        | FileFor::Keys(_)
                )
                | Self::Handout(_)
        )
    }
}

/// The endings of the pictures that can be textures.
pub const TEXTURE_ENDINGS: &[&str] = &["png", "jpg", "jpeg", "webp"];

/// A change of the figure's file by another program, with the question that it raises.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// The content of the file.
    pub theirs: Theirs,
    /// The differing lines, once requested.
    pub comparison: Option<LineComparison>,
}

/// The typed words of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TitleForm {
    pub(in crate::gui) title: Localized,
    pub(in crate::gui) caption: Localized,
    /// The words of the gallery card that the figure was made from.
    pub(in crate::gui) of_card: Box<[Option<Localized>; 2]>,
    /// The save that goes with it.
    pub(in crate::gui) then: Option<Purpose>,
    /// The file, once its name differs from the one that the title gives it.
    pub(in crate::gui) path: Option<String>,
}

/// Tells one dialog from the next. Two that differ only in their content are one.
pub(in crate::gui) type DialogKind = (Discriminant<Dialog>, Option<Discriminant<Purpose>>);

/// A question in the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    /// Unsaved changes: save them?
    Unsaved,
    /// The text of the lesson can't be saved. Forget it? The reason is in `FileFlow::refused`.
    UnsavedText,
    /// The path of a file, as typed.
    Path(Purpose, String),
    /// The file is there already: replace it?
    Overwrite(Purpose, PathBuf),
    /// Another program has changed the figure's file. Write over it?
    Changed(Changed),
    /// The file is read-only. Replace it all the same?
    ReadOnly(Purpose, PathBuf, Agreed),
    /// The title and the caption of the figure.
    Title(TitleForm),
    /// The dialog that prints lessons and exercises.
    Handout(HandoutForm),
    /// The export dialog.
    Export(Export),
    /// Pictures are still being written. The window closes when they are done.
    Closing,
    /// Help on mouse and keyboard.
    Help,
    /// The program, its version and its components.
    About,
    /// The reasons why the picture is empty, and the health of the camera.
    Coach,
    /// The gallery of figures.
    Gallery,
    /// The figure in two ways.
    Compare(CompareForm),
    /// The search for anything in the window.
    Search,
    /// The treatment of the children of deleted objects.
    Delete {
        /// Their names.
        names: std::collections::BTreeSet<String>,
        /// Number of other objects below them.
        below: usize,
    },
    /// Deletion of the progress in exercises.
    DeleteProgress,
    /// The figure as a link.
    Link,
    /// The lessons.
    Lessons,
    /// The report on a class.
    Class(Box<ClassReport>),
    /// The link as a QR code.
    Qr,
}

/// The state of work with files.
#[derive(Debug, Default)]
pub struct FileFlow {
    /// The open question.
    pub dialog: Option<Dialog>,
    /// Forms that were closed: each as it opened, and as the user left it.
    forms: Vec<[Dialog; 2]>,
    /// The reason why the last typed file couldn't be opened or written, or a text not be saved. Shown in the dialog.
    pub(in crate::gui) refused: Option<Message>,
    /// If false, the user types paths in the window, because the system has no dialogs.
    pub native: bool,
    /// True from the moment when the window may close.
    pub may_close: bool,
    /// Messages about sessions, until the user has closed them.
    pub(in crate::gui) news: NewsList,
    /// The slot of the session to restore now.
    pub(in crate::gui) restore: Option<usize>,
    /// True if the figure's file is to be checked in the next frame.
    pub(in crate::gui) look: bool,
    /// The content of another program in the figure's file.
    pub watch: Watch,
    /// The file being read.
    pub reading: Reading,
    /// The file into which the figure is being written.
    pub saving: Saving,
    /// Files given to a page. The first of them opens in the next frame.
    pub(in crate::gui) given: Vec<PathBuf>,
    pub(in crate::gui) asking: Option<Asking>,
    /// The dialog of a document, covered by a question about closing the window.
    pub(in crate::gui) covered: Option<(Revision, Dialog)>,
    pub(in crate::gui) exporting: Vec<Exporting>,
    /// The gallery document whose title we have asked for before we ask for its file.
    pub(in crate::gui) titled: Option<Revision>,
    /// The content of the export dialog while it's open.
    pub preview: Option<Preview>,
    /// The pages in the print dialog, as long as it's open.
    pub pages: Option<PagesPreview>,
}

/// A request for a file to the system, until it's answered.
#[derive(Debug)]
pub(in crate::gui) struct Asking {
    /// The purpose of the file.
    pub(in crate::gui) purpose: Purpose,
    /// The document that was shown when the question came up.
    pub(in crate::gui) document: Revision,
    /// The question, until the dialog is open.
    pub(in crate::gui) question: Option<FileQuestion>,
    /// The dialog.
    pub(in crate::gui) dialog: Option<OpenFileDialog>,
}

impl FileFlow {
    /// A form as the user left it, if it would open as it did then. Otherwise its subject has changed, and it's new.
    pub(in crate::gui) fn reopened(&mut self, dialog: Dialog) -> Dialog {
        if !dialog.is_kept() {
            return dialog;
        }
        let left = self.forms.iter().position(|[opened, _]| *opened == dialog).map(|place| self.forms.remove(place));
        self.forms.retain(|[opened, _]| !opened.is_as(&dialog));
        let [opened, left] = left.unwrap_or_else(|| [dialog.clone(), dialog]);
        self.forms.push([opened, left.clone()]);
        left
    }

    /// Keeps the open form as it is now.
    pub(in crate::gui) fn keep_form(&mut self) {
        let Some(dialog) = &self.dialog else { return };
        // The one that opened last.
        let kept = self.forms.last_mut().filter(|[_, left]| left.kind() == dialog.kind());
        if let Some([_, left]) = kept.filter(|[_, left]| left != dialog) {
            left.clone_from(dialog);
        }
    }

    /// Forgets a form: its answer is given.
    pub(in crate::gui) fn forget_form(&mut self, dialog: &Dialog) {
        self.forms.retain(|[opened, _]| !opened.is_as(dialog));
    }
}

impl Dialog {
    /// True if the dialog opens again as the user left it. The export dialog has its last settings anyway.
    fn is_kept(&self) -> bool {
        matches!(self, Self::Title(_) | Self::Path(..) | Self::Handout(_))
    }

    /// True if the other one is the same form. Handouts of lessons and sheets of exercises are two.
    fn is_as(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Handout(form), Self::Handout(other)) => form.lesson.is_some() == other.lesson.is_some(),
            _ => self.kind() == other.kind(),
        }
    }

    /// Its kind. Paths for two purposes are two dialogs.
    pub(in crate::gui) fn kind(&self) -> DialogKind {
        let purpose = if let Self::Path(purpose, _) = self { Some(discriminant(purpose)) } else { None };
        (discriminant(self), purpose)
    }

    /// True if the dialog has fields or choices, so a click beside it doesn't close it.
    pub(in crate::gui) fn is_form(&self) -> bool {
        self.is_kept() || matches!(self, Self::Export(_) | Self::Link)
    }

    /// True if closing the dialog would lose a typed text or a decision.
    pub fn is_question(&self) -> bool {
        match self {
            Self::Unsaved
            | Self::UnsavedText
            | Self::Path(..)
            | Self::Overwrite(..)
            | Self::Changed(_)
            | Self::ReadOnly(..)
            | Self::Export(_)
            | Self::Handout(_)
            | Self::Title(_)
            | Self::Closing
            | Self::Delete { .. }
            | Self::DeleteProgress => true,
            Self::Help
            | Self::About
            | Self::Coach
            | Self::Gallery
            | Self::Compare(_)
            | Self::Search
            | Self::Link
            | Self::Lessons
            | Self::Class(_)
            | Self::Qr => false,
        }
    }
}

impl FileFlow {
    /// Opens a dialog.
    pub fn show(&mut self, dialog: Dialog) {
        self.dialog = Some(dialog);
    }

    /// Opens a file in the next frame, like a dropped one.
    pub fn give(&mut self, path: PathBuf) {
        self.given.push(path);
    }

    /// True while a dialog waits for an answer, in the window or of the system. The comparison stands beside the
    /// pictures and waits for none.
    pub fn is_asking(&self) -> bool {
        self.waits_for_system() || self.dialog.as_ref().is_some_and(|dialog| !matches!(dialog, Dialog::Compare(_)))
    }

    /// True while a dialog of the system is open. A browser blocks its page by itself, and some don't report when their
    /// dialog is closed.
    pub(in crate::gui) fn waits_for_system(&self) -> bool {
        self.asking.is_some() && !cfg!(target_arch = "wasm32")
    }

    /// True while an open dialog would lose something if another one took its place.
    pub(in crate::gui) fn has_question(&self) -> bool {
        // A covered dialog comes back.
        self.waits_for_system() || self.covered.is_some() || self.dialog.as_ref().is_some_and(Dialog::is_question)
    }

    /// Work with files, with nothing pending.
    pub fn new(native: bool) -> Self {
        Self { native, ..Self::default() }
    }

    /// True while a question, a dialog of the system or a file keeps the intent of the user waiting.
    pub(in crate::gui) fn serves_errand(&self) -> bool {
        let saves = |purpose: &Purpose| matches!(purpose, Purpose::Save | Purpose::LessonText);
        let asks = match &self.dialog {
            Some(Dialog::Unsaved | Dialog::UnsavedText | Dialog::Changed(_)) => true,
            Some(Dialog::Path(purpose, _) | Dialog::Overwrite(purpose, _) | Dialog::ReadOnly(purpose, ..)) => {
                saves(purpose)
            }
            Some(Dialog::Title(form)) => form.then.as_ref().is_some_and(saves),
            Some(_) | None => false,
        };
        asks || self.saving.serves_errand() || self.asking.as_ref().is_some_and(|asking| saves(&asking.purpose))
    }

    /// The files being written or read, each in a sentence, and their progress.
    pub(in crate::gui) fn running(&self, lang: camera_lab_words::Lang) -> Vec<(String, Running)> {
        let about = |words: &str, path: &Path| format!("{words} {}", crate::sanitize::path(path));
        let written = self.exporting.iter().filter_map(|exporting| {
            Some((about(window::texts(lang).exporting, exporting.path()), exporting.running()?))
        });
        let read = self.reading.running();
        let read = read.map(|(path, running)| (about(scenes::texts(lang).loading, path), running));
        let saved = self.saving.running();
        let saved = saved.map(|(path, running)| (about(window::texts(lang).saving, path), running));
        written.chain(read).chain(saved).collect()
    }

    /// Cancels the work with files for which `which` returns true.
    pub(in crate::gui) fn cancel(&mut self, which: impl Fn(Running) -> bool) {
        if self.reading.running().is_some_and(|(_, running)| which(running)) {
            self.reading.cancel();
        }
        self.exporting.iter().filter(|exporting| exporting.running().is_some_and(&which)).for_each(Exporting::cancel);
    }

    /// The exports that have come to an end.
    pub(in crate::gui) fn exported(&mut self) -> Vec<(PathBuf, Exported)> {
        let mut done = Vec::new();
        self.exporting.retain_mut(|exporting| {
            let before = done.len();
            done.extend(exporting.take());
            done.len() == before
        });
        done
    }
}
