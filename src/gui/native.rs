//! The system's file dialogs, on a thread of their own, because they block.

use std::path::PathBuf;
use std::pin::Pin;
use std::time::Duration;

use eframe::egui;

use super::worker::{Done, Worker};
use crate::clock;

/// Where no portal and no zenity runs, the answer comes at once (10 ms, on a busy machine some hundreds) and looks like a
/// cancellation. Nobody reads a dialog and closes it this fast; if somebody does, the question for a path does no harm.
const TOO_FAST: Duration = Duration::from_millis(600);

/// What is to be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// A file that is there.
    File,
    /// A file that may not exist yet.
    NewFile,
    /// A folder.
    Folder,
}

/// What to ask for.
#[derive(Clone, Debug)]
pub struct FileQuestion {
    /// What is to be chosen.
    pub wanted: Wanted,
    /// The title of the dialog.
    pub title: &'static str,
    /// What the files are called, and what their names end in.
    pub filters: Vec<(String, &'static [&'static str])>,
    /// The name that is proposed.
    pub name: String,
    /// Where the dialog starts.
    pub folder: Option<PathBuf>,
}

/// What came back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileAnswer {
    /// A path.
    Chosen(PathBuf),
    /// The dialog was closed.
    Cancelled,
    /// There is no dialog on this system.
    Unavailable,
}

/// What is chosen in a dialog, once it has been closed.
type Chosen = Pin<Box<dyn Future<Output = Option<rfd::FileHandle>> + Send>>;

/// Shows a message in a box of the system, and waits until it is closed.
#[cfg(windows)]
pub fn message_box(message: &str) {
    rfd::MessageDialog::new()
        .set_title("Camera Lab")
        .set_level(rfd::MessageLevel::Error)
        .set_description(message)
        .show();
}

/// A dialog that is open. Each has a thread of its own: one that never answers does not keep the next from being opened.
#[derive(Debug)]
pub(super) struct OpenFileDialog {
    worker: Worker<Chosen, Option<PathBuf>>,
}

impl OpenFileDialog {
    /// Opens the dialog; `ctx` is woken when it is closed.
    pub(super) fn start(ctx: &egui::Context, question: FileQuestion) -> Self {
        let mut dialog = rfd::AsyncFileDialog::new().set_title(question.title).set_file_name(question.name);
        for (name, endings) in question.filters {
            dialog = dialog.add_filter(name, endings);
        }
        if let Some(folder) = question.folder {
            dialog = dialog.set_directory(folder);
        }
        // The future is made here: some systems insist on the main thread for that.
        let chosen: Chosen = match question.wanted {
            Wanted::File => Box::pin(dialog.pick_file()),
            Wanted::NewFile => Box::pin(dialog.save_file()),
            Wanted::Folder => Box::pin(dialog.pick_folder()),
        };
        let mut worker = Worker::new("dialog", clock::now, || {
            Box::new(|chosen: Chosen, _| pollster::block_on(chosen).map(|file| file.path().to_owned()))
        });
        worker.ask(ctx, 0, chosen);
        Self { worker }
    }

    /// The answer, once there is one.
    pub(super) fn poll(&mut self) -> Option<FileAnswer> {
        let [done] = self.worker.take(Duration::ZERO);
        Some(match done? {
            Done { outcome: Some(Some(path)), .. } => FileAnswer::Chosen(path),
            Done { outcome: Some(None), time } if time >= TOO_FAST => FileAnswer::Cancelled,
            Done { .. } => FileAnswer::Unavailable,
        })
    }
}
