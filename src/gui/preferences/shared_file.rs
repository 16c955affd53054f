//! A file that several windows write, whole or not at all.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;

use crate::clock;
use crate::files::disk::{self, Lock};
use crate::files::{self, FileError};
use crate::gui::session::aside;
use crate::gui::worker::Worker;
use crate::limits::MAX_KEPT_BYTES;
use crate::progress::Progress;

/// How long is waited for what is being written before the window closes.
pub(super) const PATIENCE: Duration = Duration::from_secs(5);

/// The file as it is, empty where there is none; what cannot be understood, or is far too large, is set aside under
/// another name.
pub(super) fn read<T: Default>(
    file: &Path,
    understood: fn(&str) -> Option<T>,
) -> Result<(T, Option<PathBuf>), FileError> {
    let bytes = match files::read_at_most(file, MAX_KEPT_BYTES) {
        Err(FileError::Read(error)) if error.kind() == io::ErrorKind::NotFound => return Ok(Default::default()),
        Err(FileError::TooLarge) => None,
        bytes => Some(bytes?),
    };
    let text = bytes.and_then(|bytes| String::from_utf8(bytes).ok());
    if let Some(document) = text.and_then(|text| understood(&text)) {
        return Ok((document, None));
    }
    let aside = aside(file);
    disk::rename(file, &aside).map_err(FileError::Write)?;
    Ok((T::default(), Some(aside)))
}

/// Keeps other windows from writing the file as long as what it gives lives. The folder is made where there is none.
pub(super) fn locked(file: &Path) -> Result<Lock, FileError> {
    disk::create_folder(file.parent().unwrap_or(Path::new(""))).map_err(FileError::Write)?;
    // Where there are no locks, two windows that write in the same moment may lose a key.
    disk::lock(&file.with_extension("lock")).map_err(FileError::Write)
}

/// What a window has changed, to be written into what the file holds by then.
pub(super) trait Change: Clone + Send + 'static {
    /// What came of it.
    type Written: Send + 'static;

    /// True where nothing is to be written.
    fn is_empty(&self) -> bool;

    /// True where nothing was added since `other` was asked for.
    fn is_same(&self, other: &Self) -> bool;

    /// Writes it.
    fn write(&self) -> Result<Self::Written, FileError>;
}

/// Writes changes beside the window's thread, one after the other. What cannot be written is tried again with the next
/// change.
pub(super) struct Writing<C: Change> {
    worker: Worker<C, Result<C::Written, FileError>>,
    /// What is being written, or could not be.
    asked: Option<C>,
    /// It has been said that the file cannot be used.
    told: bool,
}

impl<C: Change> Writing<C> {
    /// `told`: it has been said already that the file cannot be used.
    pub(super) fn new(name: &'static str, told: bool) -> Self {
        let worker = Worker::new(name, clock::now, || async |change: C, _: &Progress| change.write());
        Self { worker, asked: None, told }
    }

    /// True from when the file cannot be used until something is written to it.
    pub(super) fn is_failing(&self) -> bool {
        self.told
    }

    /// True while something is being written: what is asked for waits until then.
    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_pending(0)
    }

    /// Has a change written, unless there is nothing new in it.
    pub(super) fn ask(&mut self, ctx: &egui::Context, change: C) {
        if !change.is_empty() && self.asked.as_ref().is_none_or(|asked| !asked.is_same(&change)) {
            self.worker.ask(ctx, 0, change.clone());
            self.asked = Some(change);
        }
    }

    /// What was written, and what came of it, once there is any; the first time that it cannot be, why.
    pub(super) fn take(&mut self, patience: Duration) -> Option<Result<(C, C::Written), FileError>> {
        let [Some(done)] = self.worker.take(patience) else { return None };
        match done.outcome? {
            Ok(written) => {
                self.told = false;
                Some(Ok((self.asked.take()?, written)))
            }
            Err(error) => (!std::mem::replace(&mut self.told, true)).then_some(Err(error)),
        }
    }

    /// What was asked for does not count any more.
    pub(super) fn forget(&mut self) {
        self.asked = None;
    }
}
