//! Checks beside the window's thread if another program has changed the figure's file.

use crate::Wake;
use std::path::PathBuf;
use std::time::Duration;

use crate::background::worker::Worker;
use crate::clock;
use crate::document::Document;
use crate::progress::Progress;
use camera_lab_files::{FileChange, Stamp, look};

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
}

impl Default for Watch {
    fn default() -> Self {
        let worker = Worker::new("watch", clock::now, || {
            async |Watched { path, source, stamp }, _: &Progress| {
                let found = look(&path, source.as_bytes(), stamp);
                (path, source, found)
            }
        });
        Self { worker, same: None }
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

    /// The result, once, if the document is still the same as when the file was checked.
    pub fn take(&mut self, document: &Document) -> Option<FileChange> {
        let [done] = self.worker.take(Duration::ZERO);
        let (path, source, found) = done?.outcome?;
        if document.path() != Some(&path) || document.source() != source {
            return None;
        }
        if let FileChange::Same(stamp) = found {
            self.same = Some((path, source, stamp));
        }
        Some(found)
    }
}
