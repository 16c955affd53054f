//! Lessons in files: one, or those of a lecturer's folder.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::carried::Carried;
use super::own_exercises::toml_files;
use super::{FileError, read_at_most, read_start};
use crate::lessons::{Lesson, parse_bytes};
use crate::limits::MAX_LESSON_BYTES;
use crate::share::{self, Held};

/// The first step of a lesson begins within these bytes. Before it are only its title, sentence and aims.
const HEAD: u64 = 64 << 10;

/// The lessons of a folder.
#[derive(Debug, Default)]
pub struct OwnLessons {
    /// The lessons with their files, sorted by file name.
    pub lessons: Vec<(PathBuf, Arc<Lesson>)>,
    /// The unusable files, in the same order.
    pub faults: Vec<(PathBuf, FileError)>,
}

/// Reads a lesson, and the text of its file or link.
///
/// # Errors
/// [`FileError`] if the file or link can't be read, or holds no lesson.
pub fn read_lesson(path: &Path) -> Result<(Lesson, String), FileError> {
    let bytes = match share::link_of(path).and_then(share::text_in) {
        // Behind the text of a link are the files that it carries.
        Some(text) => Carried::from_text(text?).0,
        None => read_at_most(path, MAX_LESSON_BYTES as u64)?,
    };
    let lesson = parse_bytes(&bytes)?;
    Ok((lesson, String::from_utf8_lossy(&bytes).into_owned()))
}

/// Reads the lessons of a folder: each file that ends with `.toml` and has a `[[step]]`. Doesn't look into subfolders.
///
/// # Errors
/// [`FileError`] if the folder can't be read, or has too many files. The fault of a single file is in `faults`, and the
/// others can be used.
pub fn read_lessons(folder: &Path) -> Result<OwnLessons, FileError> {
    let mut found = OwnLessons::default();
    for path in toml_files(folder)? {
        match read_at_most(&path, MAX_LESSON_BYTES as u64) {
            Ok(bytes) if is_lesson(&bytes) => match parse_bytes(&bytes) {
                Ok(lesson) => found.lessons.push((path, Arc::new(lesson))),
                Err(error) => found.faults.push((path, error.into())),
            },
            // A figure beside the lessons.
            Ok(_) => {}
            Err(error) => found.faults.push((path, error)),
        }
    }
    Ok(found)
}

/// True for an existing file, or a link, that is meant as a lesson.
pub fn is_lesson_file(path: &Path) -> bool {
    if let Some(link) = share::link_of(path) {
        return share::held_in(link) == Some(Held::Lesson);
    }
    let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    // A folder may have thousands of figures, and large ones.
    is_toml && read_start(path, HEAD).is_ok_and(|bytes| is_lesson(&bytes))
}

/// True if a file is meant as a lesson.
fn is_lesson(bytes: &[u8]) -> bool {
    String::from_utf8_lossy(bytes).lines().any(|line| line.trim_start().starts_with("[[step]]"))
}
