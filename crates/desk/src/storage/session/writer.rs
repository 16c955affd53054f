//! Stores a window's figure, beside the window's thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::session_file::SessionFile;
use crate::background::worker::Worker;
use crate::document::{Document, Seen};
use crate::figure::Figure;
use crate::history::Revision;
use crate::storage::session::UnsavedText;
use crate::{Wake, clock};
use camera_lab_files::disk::{self, Lock};
use camera_lab_files::{self as files, Carried, FileError, Overwrite};

/// The longest wait for a running write before the window closes.
const MAX_WAIT: Duration = Duration::from_secs(2);

/// The content of a session file.
#[derive(Debug)]
struct Note {
    /// The figure's file, and without one the folder of the picture that it came from.
    place: [Option<PathBuf>; 2],
    source: String,
    carried: Carried,
    figure: Figure,
    text: Option<Arc<UnsavedText>>,
    restoring: bool,
}

/// Something that a crash must not lose.
#[derive(Clone, Copy)]
pub struct Kept<'a> {
    /// The document.
    pub document: &'a Document,
    /// Its display in the pictures.
    pub seen: &'a Seen,
    /// True if the document has changes that closing the window asks about.
    pub is_work: bool,
    /// The text of a lesson that isn't in its file.
    pub text: Option<&'a Arc<UnsavedText>>,
}

impl Kept<'_> {
    /// True if something would be lost: work, and in a browser, which can't reopen files by itself, also an opened
    /// figure.
    pub(super) fn is_worth_keeping(&self) -> bool {
        let document = self.document;
        self.is_work
            || self.text.is_some()
            || (cfg!(target_arch = "wasm32") && (document.name().is_some() || !document.source().is_empty()))
    }
}

fn place(document: &Document) -> [Option<PathBuf>; 2] {
    let path = document.path().cloned();
    let folder = document.folder().filter(|_| path.is_none()).map(Path::to_owned);
    [path, folder]
}

impl Note {
    fn is_of(&self, document: &Document) -> bool {
        let figure = document.figure();
        self.place == place(document)
            && self.source == document.source()
            && self.figure.without_scene() == figure.without_scene()
            && self.figure.scene == figure.scene
    }

    /// True if it has these observers and explanations.
    fn is_seen_as(&self, seen: &Seen) -> bool {
        let Figure { observers, show, screen, .. } = &self.figure;
        (*observers, show, *screen) == (seen.observers, &seen.show, seen.screen)
    }
}

/// The new content of the slot. `None` empties it.
struct WriteJob {
    file: PathBuf,
    note: Option<Arc<Note>>,
    /// The slot belongs to this window until the job is done, even if the window is gone before.
    _lock: Arc<Lock>,
}

impl WriteJob {
    fn run(self) -> Result<(), FileError> {
        let Some(note) = self.note else {
            return disk::remove(&self.file).map_err(FileError::Write);
        };
        let kept = SessionFile::new(&note.place, (&note.source, &note.carried), &note.figure, note.restoring);
        let kept = kept.with_text(note.text.as_deref());
        let text = serde_json::to_vec(&kept).map_err(|error| FileError::Write(error.into()))?;
        files::save(&self.file, &text, Overwrite::Writable)
    }
}

/// The slot of this window, and its content.
#[derive(Debug)]
pub(super) struct Writer {
    file: PathBuf,
    lock: Arc<Lock>,
    worker: Worker<WriteJob, Result<(), FileError>>,
    /// The last request. `None` before the first.
    asked: Option<Option<Arc<Note>>>,
    /// The number of that document.
    version: Option<Revision>,
}

impl Writer {
    pub(super) fn new(file: PathBuf, lock: Lock) -> Self {
        let worker =
            Worker::new("session", clock::now, || async |job: WriteJob, _: &crate::progress::Progress| job.run());
        Self { file, lock: Arc::new(lock), worker, asked: None, version: None }
    }

    /// True if the last request is still wanted.
    pub(super) fn is_up_to_date(&mut self, kept: Kept<'_>, restoring: bool) -> bool {
        let Kept { document, seen, text, .. } = kept;
        match &self.asked {
            Some(Some(note)) => {
                let version = Some(document.version());
                let is_same = kept.is_worth_keeping()
                    && note.restoring == restoring
                    && note.is_seen_as(seen)
                    && note.text.as_ref().map(Arc::as_ptr) == text.map(Arc::as_ptr)
                    && (self.version == version || note.is_of(document));
                if is_same {
                    // Another number may have come to the same document.
                    self.version = version;
                }
                is_same
            }
            Some(None) => !kept.is_worth_keeping(),
            None => false,
        }
    }

    /// True if the last request was made for this document in its present state, regardless of its observers then.
    pub(super) fn has(&self, document: &Document) -> bool {
        self.version == Some(document.version()) && matches!(self.asked, Some(Some(_)))
    }

    /// Makes the next check find that the document isn't stored.
    pub(super) fn ask_again(&mut self) {
        (self.asked, self.version) = (None, None);
    }

    /// Saves the document. If nothing would be lost with it, deletes the stored one.
    pub(super) fn ask(&mut self, window: &dyn Wake, kept: Kept<'_>, restoring: bool) {
        let Kept { document, seen, text, .. } = kept;
        let note = kept.is_worth_keeping().then(|| {
            let Seen { observers, show, screen } = seen.clone();
            Arc::new(Note {
                place: place(document),
                source: document.source().to_owned(),
                carried: document.carried().clone(),
                figure: Figure { observers, show, screen, ..document.figure().clone() },
                text: text.cloned(),
                restoring,
            })
        });
        (self.asked, self.version) = (Some(note.clone()), Some(document.version()));
        self.worker.ask(window, 0, WriteJob { file: self.file.clone(), note, _lock: Arc::clone(&self.lock) });
    }

    /// The result, once.
    pub(super) fn take(&mut self) -> Option<Result<(), FileError>> {
        let [done] = self.worker.take(Duration::ZERO);
        Some(done?.outcome.unwrap_or_else(|| Err(FileError::Write(std::io::Error::other("a bug in this program")))))
    }

    /// Waits until the last write is done.
    #[cfg(test)]
    pub(super) fn wait(&self) {
        while self.worker.is_pending(0) {
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Waits for a running write, and deletes the session, because it has been saved, or discarded.
    pub(super) fn forget(mut self) {
        self.worker.take(MAX_WAIT);
        // The window closes, or continues with another slot, so there is nothing left to do.
        let _ = disk::remove(&self.file);
    }
}
