//! A file that several windows write, whole or not at all.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::files::disk::{self, Lock};
use crate::files::{self, FileError};
use crate::gui::session::aside;

/// How long is waited for what is being written before the window closes.
pub(super) const PATIENCE: Duration = Duration::from_secs(5);

/// The file as it is, empty where there is none; what cannot be understood is set aside under another name.
pub(super) fn read<T: Default>(
    file: &Path,
    understood: fn(&str) -> Option<T>,
) -> Result<(T, Option<PathBuf>), FileError> {
    let bytes = match files::read_file(file) {
        Err(FileError::Read(error)) if error.kind() == io::ErrorKind::NotFound => return Ok(Default::default()),
        bytes => bytes?,
    };
    if let Some(document) = String::from_utf8(bytes).ok().and_then(|text| understood(&text)) {
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
