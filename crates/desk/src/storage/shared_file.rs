//! A file that several windows write, whole or not at all. Each window merges its changes into the file's present
//! content.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::background::worker::Worker;
use crate::storage::session::{Keeping, News, aside};
use crate::{Wake, clock};
use camera_lab_files::disk::{self, Lock};
use camera_lab_files::{self as files, FileError, Overwrite};

/// The longest wait for a running write before the window closes.
pub const MAX_WAIT: Duration = Duration::from_secs(2);

/// A change of a window, to merge into the present content of the file.
pub trait Change: Clone + Send + 'static {
    /// The content of a file.
    type Content: Default;
    /// The part of the content that the window takes over once the change is in it.
    type Merged: Send + 'static;

    /// Reads a file. `None` if it can't be parsed.
    fn understood(text: &str) -> Option<Self::Content>;

    /// True if there is nothing to write.
    fn is_empty(&self) -> bool;

    /// True if nothing was added since `other`.
    fn is_same(&self, other: &Self) -> bool;

    /// The text of the file with the change in it.
    fn merge(&self, content: Self::Content) -> (String, Self::Merged);
}

/// The content of a file, as text and parsed, and the new place of one that couldn't be parsed.
type Held<T> = (String, T, Option<PathBuf>);

/// The present file, empty if it doesn't exist. Content that can't be parsed, or is far too large, is set aside under
/// another name.
fn read<C: Change>(file: &Path) -> Result<Held<C::Content>, FileError> {
    let bytes = match files::read_at_most(file, crate::limits::MAX_KEPT_BYTES) {
        Err(FileError::Read(error)) if error.kind() == io::ErrorKind::NotFound => return Ok(Held::default()),
        Err(FileError::TooLarge(_)) => None,
        bytes => Some(bytes?),
    };
    let text = bytes.and_then(|bytes| String::from_utf8(bytes).ok());
    if let Some((text, content)) = text.and_then(|text| C::understood(&text).map(|content| (text, content))) {
        return Ok((text, content, None));
    }
    let aside = aside(file);
    disk::rename(file, &aside).map_err(FileError::Write)?;
    Ok((String::new(), C::Content::default(), Some(aside)))
}

/// Merges a change into a file. Returns where an unparsable one went too.
fn write<C: Change>(file: &Path, change: &C) -> Result<(C::Merged, Option<PathBuf>), FileError> {
    let _lock = locked(file)?;
    let (before, content, set_aside) = read::<C>(file)?;
    let (text, merged) = change.merge(content);
    if text != before {
        files::save(file, text.as_bytes(), Overwrite::Writable)?;
    }
    Ok((merged, set_aside))
}

/// Keeps other windows from writing the file as long as the returned lock lives. Creates the folder if it doesn't
/// exist.
fn locked(file: &Path) -> Result<Lock, FileError> {
    disk::create_folder(file.parent().unwrap_or(Path::new(""))).map_err(FileError::Write)?;
    // Without locks, two windows that write in the same moment may lose a key.
    disk::lock(&file.with_extension("lock")).map_err(FileError::Write)
}

type Written<C> = Result<(<C as Change>::Merged, Option<PathBuf>), FileError>;

/// A file to which changes are written beside the window's thread, one after the other. A change that can't be written
/// is tried again with the next.
pub struct SharedFile<C: Change> {
    /// Its path.
    pub path: PathBuf,
    what: Keeping,
    /// The message about a file that was set aside.
    set_aside: fn(PathBuf) -> News,
    worker: Worker<(PathBuf, C), Written<C>>,
    /// The change of the running write, or of one that failed.
    asked: Option<C>,
    /// True if the failure of the file has been reported.
    told: bool,
    news: Vec<News>,
}

impl<C: Change> SharedFile<C> {
    /// Reads the file, if possible.
    pub fn open(
        path: PathBuf,
        name: &'static str,
        (what, set_aside): (Keeping, fn(PathBuf) -> News),
    ) -> (Self, Option<C::Content>) {
        let worker = Worker::new(name, clock::now, || {
            async |(path, change): (PathBuf, C), _: &crate::progress::Progress| write(&path, &change)
        });
        let mut file = Self { path, what, set_aside, worker, asked: None, told: false, news: Vec::new() };
        let content = match read::<C>(&file.path) {
            Ok((_, content, set_aside)) => {
                file.news.extend(set_aside.map(file.set_aside));
                Some(content)
            }
            Err(error) => {
                file.say_not_kept(error);
                None
            }
        };
        (file, content)
    }

    /// Reports why the file can't be used, the first time.
    fn say_not_kept(&mut self, error: FileError) {
        if !std::mem::replace(&mut self.told, true) {
            self.news.push(News::not_kept(self.what, self.path.clone(), error));
        }
    }

    /// True from when the file becomes unusable until a write succeeds.
    pub fn is_failing(&self) -> bool {
        self.told
    }

    /// New messages about it, each once.
    pub fn news(&mut self) -> Vec<News> {
        std::mem::take(&mut self.news)
    }

    /// Writes a change, unless there is nothing new in it. If a write is running, it waits for its end.
    pub fn ask(&mut self, window: &dyn Wake, change: C) {
        let is_asked = self.asked.as_ref().is_some_and(|asked| asked.is_same(&change));
        if !(change.is_empty() || is_asked || self.worker.is_pending(0)) {
            self.worker.ask(window, 0, (self.path.clone(), change.clone()));
            self.asked = Some(change);
        }
    }

    /// The last written change, if any, and the content that the window takes over.
    pub fn take(&mut self, patience: Duration) -> Option<(C, C::Merged)> {
        let [done] = self.worker.take(patience);
        match done?.outcome? {
            Ok((merged, set_aside)) => {
                self.told = false;
                self.news.extend(set_aside.map(self.set_aside));
                Some((self.asked.take()?, merged))
            }
            Err(error) => {
                self.say_not_kept(error);
                None
            }
        }
    }

    /// Writes pending changes before the window closes, when no message can be shown any more.
    pub fn finish(&self, change: &C) -> Option<C::Merged> {
        let written = (!change.is_empty()).then(|| write(&self.path, change).ok());
        written.flatten().map(|(merged, _)| merged)
    }

    /// Puts the file under another name, and drops pending requests. Returns false if there is none.
    ///
    /// # Errors
    /// The lock or the file system refuses.
    pub fn put_aside(&mut self, aside: &Path) -> Result<bool, FileError> {
        let moved = locked(&self.path).and_then(|_lock| disk::rename(&self.path, aside).map_err(FileError::Write));
        let was_there = match moved {
            Err(FileError::Write(error)) if error.kind() == io::ErrorKind::NotFound => false,
            moved => moved.map(|()| true)?,
        };
        self.asked = None;
        Ok(was_there)
    }
}
