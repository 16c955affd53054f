//! A file that several windows write, whole or not at all.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;

use crate::clock;
use crate::files::disk::{self, Lock};
use crate::files::{self, FileError};
use crate::gui::session::aside;
use crate::gui::worker::{Worker, one_by_one};
use crate::limits::MAX_KEPT_BYTES;
use crate::progress::Progress;

/// The longest wait for a running write before the window closes.
pub(super) const PATIENCE: Duration = Duration::from_secs(5);

/// Reads the file, empty where there is none; one that cannot be read, or is far too large, is set aside under another
/// name.
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

/// Locks the file against other windows as long as the returned lock lives. The folder is made where there is none.
pub(super) fn locked(file: &Path) -> Result<Lock, FileError> {
    disk::create_folder(file.parent().unwrap_or(Path::new(""))).map_err(FileError::Write)?;
    // Without locks, two windows that write at the same moment may lose a key.
    disk::lock(&file.with_extension("lock")).map_err(FileError::Write)
}

/// Changes of a window, to be merged into the present content of the file.
pub(super) trait Change: Clone + Send + 'static {
    /// The result of a write.
    type Written: Send + 'static;

    /// True where nothing is to be written.
    fn is_empty(&self) -> bool;

    /// Whether nothing was added since `other`.
    fn is_same(&self, other: &Self) -> bool;

    /// Writes it.
    fn write(&self) -> Result<Self::Written, FileError>;
}

/// Writes changes beside the window's thread, one after the other. What cannot be written is tried again with the next
/// change.
pub(super) struct Writing<C: Change> {
    worker: Worker<C, Result<C::Written, FileError>>,
    /// The changes being written, or not yet written.
    asked: Option<C>,
    /// The failure of the file has been reported.
    told: bool,
}

impl<C: Change> Writing<C> {
    /// `told`: the failure of the file has been reported already.
    pub(super) fn new(name: &'static str, told: bool) -> Self {
        let worker = Worker::new(name, clock::now, || one_by_one(async |change: C, _: &Progress| change.write()));
        Self { worker, asked: None, told }
    }

    /// True from when the file cannot be used until something is written to it.
    pub(super) fn is_failing(&self) -> bool {
        self.told
    }

    /// Whether a write is running: new changes wait until it ends.
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

    /// The changes written and the result, once there is one; the first failure with its reason.
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

    /// Drops the changes not yet written.
    pub(super) fn forget(&mut self) {
        self.asked = None;
    }
}
