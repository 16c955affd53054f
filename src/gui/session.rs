//! What is left of a window that did not close: the figure is written down after every change, and taken up again at the next
//! start.
//!
//! Each window has a slot of its own, marked by a lock on a file, which the system takes away when the program ends, however
//! it ends.

use std::fs::{self, File, OpenOptions};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::document::Document;
use crate::figure::update;
use crate::files::{self, Overwrite, SourceFile};

/// More windows than anybody opens at once.
const SLOTS: usize = 16;

/// The slot of this window.
#[derive(Debug)]
pub struct Session {
    file: PathBuf,
    written: Option<SessionRecord>,
    _lock: File,
}

/// What is written down.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct SessionRecord {
    /// The figure's file, if it has one.
    path: Option<PathBuf>,
    /// The text of that file as it was read or saved last.
    source: String,
    /// The figure with its changes.
    figure: String,
}

impl Session {
    /// Takes a slot in `folder`. With `restore`, what a window left that did not close comes back with it; without, such a
    /// slot stays for another time. `None` where the folder cannot be used: then nothing is kept.
    #[must_use]
    pub fn begin(folder: &Path, restore: bool) -> Option<(Self, Option<Document>)> {
        fs::create_dir_all(folder).ok()?;
        for slot in 0..SLOTS {
            let lock = folder.join(format!("session-{slot}.lock"));
            let file = folder.join(format!("session-{slot}.json"));
            let Ok(lock) = OpenOptions::new().create(true).truncate(false).write(true).open(lock) else { continue };
            if lock.try_lock().is_err() || (file.exists() && !restore) {
                continue;
            }
            let left = read(&file);
            return Some((Self { file, written: None, _lock: lock }, left));
        }
        None
    }

    /// Writes down what has changed; nothing where nothing would be lost.
    pub fn keep(&mut self, document: &Document) {
        if !document.is_changed() {
            self.forget();
            return;
        }
        let kept = SessionRecord {
            path: document.path().cloned(),
            source: document.source().to_owned(),
            figure: update(document.source(), document.figure()),
        };
        if self.written.as_ref() == Some(&kept) {
            return;
        }
        // A session that cannot be written must not disturb the work; the figure itself is saved on demand.
        if let Ok(text) = serde_json::to_vec(&kept) {
            let _ = files::save(&self.file, &text, Overwrite::Writable);
        }
        self.written = Some(kept);
    }

    /// Removes what was written down: it has been saved, or is not wanted.
    pub fn forget(&mut self) {
        if self.written.take().is_some() || self.file.exists() {
            let _ = fs::remove_file(&self.file);
        }
    }
}

fn read(file: &Path) -> Option<Document> {
    let kept: SessionRecord = serde_json::from_slice(&files::read_file(file).ok()?).ok()?;
    let changed = files::figure_from(kept.figure.as_bytes()).ok()?.figure;
    // Without a file, the window had begun with its own first figure, not with that of an empty file.
    let saved = match &kept.path {
        Some(_) => files::figure_from(kept.source.as_bytes()).ok()?.figure,
        None => super::fresh(),
    };
    // A figure out of a picture has no path here: it has not been saved anywhere.
    let file = kept.path.map(|path| SourceFile { path, text: kept.source, is_picture: false });
    let mut document = Document::new(saved, file).ok()?;
    document.replace(changed).ok()?;
    Some(document)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::figure::Figure;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("camera-lab-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        folder
    }

    fn changed() -> Document {
        let mut document = Document::new(crate::gui::fresh(), None).unwrap();
        document.set_parameters(crate::camera::Parameters { far: 42.0, ..*document.draft() });
        document
    }

    #[test]
    fn a_crash_loses_nothing() {
        let folder = folder("crash");
        let (mut session, left) = Session::begin(&folder, true).unwrap();
        assert!(left.is_none());
        session.keep(&changed());
        // The lock goes with the program; the file stays.
        drop(session);
        let (_session, left) = Session::begin(&folder, true).unwrap();
        let left = left.unwrap();
        assert_eq!(left.figure().camera.far, 42.0);
        assert!(left.is_changed());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_second_window_has_its_own_slot_and_a_saved_one_leaves_nothing() {
        let folder = folder("slots");
        let (mut first, _) = Session::begin(&folder, true).unwrap();
        first.keep(&changed());
        let (mut second, left) = Session::begin(&folder, true).unwrap();
        assert!(left.is_none());
        assert_ne!(first.file, second.file);
        first.forget();
        second.keep(&Document::new(Figure::default(), None).unwrap());
        assert!(!first.file.exists() && !second.file.exists());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_figure_on_the_command_line_leaves_an_old_session_alone() {
        let folder = folder("argument");
        let (mut crashed, _) = Session::begin(&folder, true).unwrap();
        crashed.keep(&changed());
        drop(crashed);
        let (mut other, left) = Session::begin(&folder, false).unwrap();
        assert!(left.is_none());
        other.forget();
        drop(other);
        assert!(Session::begin(&folder, true).unwrap().1.is_some());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn damaged_notes_are_no_session() {
        let folder = folder("damaged");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("session-0.json"), b"{\"path\":").unwrap();
        assert!(Session::begin(&folder, true).unwrap().1.is_none());
        fs::remove_dir_all(folder).unwrap();
    }
}
