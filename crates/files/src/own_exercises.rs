//! A folder of a lecturer's own exercises.

use std::fs;
use std::path::{Path, PathBuf};

use super::patience::in_time;
use super::{FileError, read_at_most};
use crate::exercises::{self, Entry, own};
use crate::limits::{MAX_FIGURE_BYTES, MAX_OWN_EXERCISES};
use crate::numbers::natural_order;

/// The exercises of a folder.
#[derive(Debug, Default)]
pub struct OwnExercises {
    /// The exercises, sorted by file name.
    pub entries: Vec<Entry>,
    /// The unusable files, in the same order.
    pub faults: Vec<BadExercise>,
}

/// A file in a folder of exercises that holds no usable one.
#[derive(Debug)]
pub struct BadExercise {
    /// The path of the file.
    pub path: PathBuf,
    /// The reason why it's unusable.
    pub error: FileError,
    /// The probable identifier of the exercise.
    pub id: Option<String>,
}

/// Reads the exercises of a folder, one from each file that ends with `.toml`. Doesn't look into subfolders.
///
/// # Errors
/// [`FileError`] if the folder can't be read, or has too many of them. The fault of a single file is in `faults`, and
/// the others can be used.
pub fn read_exercises(folder: &Path) -> Result<OwnExercises, FileError> {
    let mut found = OwnExercises::default();
    for path in toml_files(folder)? {
        match read_exercise(&path, &found.entries) {
            Ok(entry) => found.entries.push(entry),
            Err(bad) => found.faults.push(*bad),
        }
    }
    Ok(found)
}

/// The paths in a folder, in no order.
///
/// # Errors
/// [`FileError::Read`].
pub fn entries(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    // An entry that the system can't describe has no name to report.
    let read = |folder: &Path| Ok(fs::read_dir(folder)?.flatten().map(|entry| entry.path()).collect());
    in_time(folder, read).and_then(|read| read).map_err(FileError::Read)
}

/// The files of a folder that end with `.toml`, in natural order.
///
/// # Errors
/// [`FileError`] if the folder can't be read, or has too many of them.
pub(super) fn toml_files(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    if super::is_network(folder) {
        return Err(FileError::Network);
    }
    let mut files = Vec::new();
    for path in entries(folder)? {
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
            files.push(path);
        }
        if files.len() > MAX_OWN_EXERCISES {
            return Err(FileError::TooManyExercises);
        }
    }
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    files.sort_by(|a, b| natural_order(&name(a), &name(b)).then_with(|| a.cmp(b)));
    Ok(files)
}

/// The exercise in a file.
fn read_exercise(path: &Path, before: &[Entry]) -> Result<Entry, Box<BadExercise>> {
    let bad = |error, id| Box::new(BadExercise { path: path.to_owned(), error, id });
    let bytes = read_at_most(path, MAX_FIGURE_BYTES as u64).map_err(|error| bad(error, None))?;
    let entry = own::parse_bytes(&bytes).map_err(|error| bad(error.into(), own::id_in(&bytes)))?;
    if exercises::with_own(before).any(|other| other.id == entry.id) {
        return Err(bad(own::taken(&String::from_utf8_lossy(&bytes), &entry.id).into(), None));
    }
    Ok(entry)
}
