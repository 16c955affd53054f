//! The system's file dialogs, on a thread of their own, because they block.

use std::path::PathBuf;
use std::pin::Pin;
use std::time::Duration;

use eframe::egui;

use super::{FileAnswer, FileQuestion, Wanted};
use crate::clock;
use crate::gui::worker::{Done, Worker};
use crate::progress::Progress;

/// Without a portal or zenity, the answer comes at once (10 ms, on a busy machine some hundreds) and looks like a
/// cancellation. Nobody reads a dialog and closes it this fast; if somebody does, the question for a path does no harm.
const TOO_FAST: Duration = Duration::from_millis(600);

/// The choice in a dialog, once it has been closed.
type Chosen = Pin<Box<dyn Future<Output = Option<rfd::FileHandle>> + Send>>;

/// A dialog that is open. Each has a thread of its own: one that never answers does not keep the next from being
/// opened.
#[derive(Debug)]
pub(in crate::gui) struct OpenFileDialog {
    worker: Worker<Chosen, Option<PathBuf>>,
}

impl OpenFileDialog {
    /// Opens the dialog; `ctx` is woken when it is closed.
    pub(in crate::gui) fn start(ctx: &egui::Context, question: FileQuestion) -> Self {
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
            async |chosen: Chosen, _: &Progress| pollster::block_on(chosen).map(|file| file.path().to_owned())
        });
        worker.ask(ctx, 0, chosen);
        Self { worker }
    }

    /// The answer, once there is one.
    pub(in crate::gui) fn poll(&mut self) -> Option<FileAnswer> {
        let [done] = self.worker.take(Duration::ZERO);
        Some(match done? {
            Done { outcome: Some(Some(path)), .. } => FileAnswer::Chosen(path),
            Done { outcome: Some(None), time } if time >= TOO_FAST => FileAnswer::Cancelled,
            Done { .. } => FileAnswer::Unavailable,
        })
    }
}
