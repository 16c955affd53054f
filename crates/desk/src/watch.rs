//! Checks beside the window's thread if another program has changed the figure's file.

use std::path::PathBuf;

use crate::background::worker::Worker;
use crate::document::Document;
use crate::history::Revision;
use crate::{Wake, clock};
use camera_lab_files::{FileChange, Stamp, look};

/// The content that another program has written into the figure's file. `None` if it's unreadable.
pub type Theirs = Option<Vec<u8>>;

/// A watched file.
struct Watched {
    path: PathBuf,
    source: String,
    stamp: Option<Stamp>,
}

/// Checks the figure's file on request.
#[derive(Debug)]
pub struct Watch {
    worker: Worker<Watched, (PathBuf, String, FileChange)>,
    /// The file when it last held the text read or saved by the window.
    same: Option<(PathBuf, String, Stamp)>,
    /// The document that the rest is about.
    of: Option<Revision>,
    /// The content of another program, while it has to be shown.
    theirs: Option<Theirs>,
    /// The content that the user has decided about, which isn't shown again.
    decided: Option<Theirs>,
}

impl Default for Watch {
    fn default() -> Self {
        let worker = Worker::new("watch", clock::now, || {
            async |Watched { path, source, stamp }, _: &crate::progress::Progress| {
                let found = look(&path, source.as_bytes(), stamp);
                (path, source, found)
            }
        });
        Self { worker, same: None, of: None, theirs: None, decided: None }
    }
}

impl Watch {
    /// Looks at the file of the document, if it has one. Wakes `window` when that's done.
    pub fn begin(&mut self, window: &dyn Wake, document: &Document) {
        let Some(path) = document.path().cloned() else { return };
        let source = document.source().to_owned();
        let same = self.same.as_ref().filter(|(was, text, _)| *was == path && *text == source);
        let stamp = same.map(|(_, _, stamp)| *stamp);
        self.worker.ask(window, 0, Watched { path, source, stamp });
    }

    /// Takes the result, if the document is still the same as when the file was checked.
    pub fn poll(&mut self, document: &Document) {
        if self.of.replace(document.id()) != Some(document.id()) {
            self.forget();
        }
        let [done] = self.worker.take(std::time::Duration::ZERO);
        let Some((path, source, found)) = done.and_then(|done| done.outcome) else { return };
        if document.path() != Some(&path) || document.source() != source {
            return;
        }
        match found {
            FileChange::Other(theirs) if self.decided.as_ref() != Some(&theirs) => self.theirs = Some(theirs),
            FileChange::Other(_) | FileChange::Gone => {}
            FileChange::Same(stamp) => {
                self.forget();
                self.same = Some((path, source, stamp));
            }
        }
    }

    /// The content of another program in the file of the document, until the user has decided about it.
    pub fn theirs(&self, document: &Document) -> Option<&Theirs> {
        self.theirs.as_ref().filter(|_| self.of == Some(document.id()))
    }

    /// Continues with the window's figure. The same content isn't shown again.
    pub fn keep_mine(&mut self) {
        self.decided = self.theirs.take();
    }

    /// Forgets the content of another program, because the file is the window's again.
    pub fn forget(&mut self) {
        (self.theirs, self.decided) = (None, None);
    }
}
