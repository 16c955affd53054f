//! A folder of a lecturer's own exercises.

use std::fs;
use std::path::{Path, PathBuf};

use super::{FileError, read_at_most};
use crate::exercises::{self, Entry, own};
use crate::limits::{MAX_FIGURE_BYTES, MAX_OWN_EXERCISES};
use crate::numbers::natural_order;

/// What a folder of exercises holds.
#[derive(Debug, Default)]
pub struct OwnExercises {
    /// The exercises, in the order of the names of their files.
    pub entries: Vec<Entry>,
    /// The files that cannot be used, and why.
    pub faults: Vec<(PathBuf, FileError)>,
}

/// Reads the exercises of a folder: each file that ends with `.toml`, one each. Folders in it are not looked into.
///
/// # Errors
/// [`FileError`]: the folder cannot be read, or holds more of them than there may be. What is wrong with one file is in `faults`, and the others
/// can be used.
pub fn read_exercises(folder: &Path) -> Result<OwnExercises, FileError> {
    if super::is_network(folder) {
        return Err(FileError::Network);
    }
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(FileError::Read)? {
        let path = entry.map_err(FileError::Read)?.path();
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
            files.push(path);
        }
        if files.len() > MAX_OWN_EXERCISES {
            return Err(FileError::TooManyExercises);
        }
    }
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    files.sort_by(|a, b| natural_order(&name(a), &name(b)).then_with(|| a.cmp(b)));
    let mut found = OwnExercises::default();
    for path in files {
        match read_exercise(&path, &found.entries) {
            Ok(entry) => found.entries.push(entry),
            Err(error) => found.faults.push((path, error)),
        }
    }
    Ok(found)
}

fn read_exercise(path: &Path, before: &[Entry]) -> Result<Entry, FileError> {
    let bytes = read_at_most(path, MAX_FIGURE_BYTES as u64)?;
    let entry = own::parse_bytes(&bytes)?;
    if exercises::with_own(before).any(|other| other.id == entry.id) {
        return Err(own::taken(&String::from_utf8_lossy(&bytes), &entry.id).into());
    }
    Ok(entry)
}
