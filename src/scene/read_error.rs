//! How the files are read that a scene names, and what keeps them from being read.

use std::io;

use crate::limits::MAX_FILE_BYTES;

/// Gives the bytes of the file with this path (as the figure names it).
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, ReadError> + 'a;

/// Why a file that a scene names cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file} {problem}")]
pub struct ReadError {
    /// The file, as it was looked for.
    pub file: String,
    /// Why.
    pub problem: ReadProblem,
}

/// What keeps a file from being read. Displayed, it stands after the name of the file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadProblem {
    /// The system refuses.
    #[error("cannot be read: {}", system_words(*kind, detail))]
    System {
        /// The kind of refusal.
        kind: io::ErrorKind,
        /// The system's words.
        detail: String,
    },
    /// It is a directory.
    #[error("is a directory; allowed: a file")]
    Directory,
    /// It is larger than any file that is meant for this program.
    #[error("is larger than any figure or picture; allowed: at most {} GiB", MAX_FILE_BYTES >> 30)]
    TooLarge,
    /// It is a device, a pipe or a socket, which may have no end.
    #[error("is a device, a pipe or a socket; allowed: a regular file")]
    NotRegular,
    /// Its path leads to another machine.
    #[error("is on another machine; allowed: files of this one")]
    Network,
}

/// What a system says, in plain English where the case is common.
#[must_use]
pub fn system_words(kind: io::ErrorKind, detail: &str) -> &str {
    match kind {
        io::ErrorKind::NotFound => "there is no such file or directory",
        io::ErrorKind::PermissionDenied => "permission denied",
        io::ErrorKind::IsADirectory => "it is a directory",
        io::ErrorKind::NotADirectory => "a part of the path is not a directory",
        io::ErrorKind::StorageFull => "the disk is full",
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        _ => detail,
    }
}

/// For scenes without files: a [`ReadFile`] that finds none.
///
/// # Errors
/// Always: the file does not exist.
pub fn no_files(file: &str) -> Result<Vec<u8>, ReadError> {
    let kind = io::ErrorKind::NotFound;
    Err(ReadError { file: file.to_owned(), problem: ReadProblem::System { kind, detail: kind.to_string() } })
}
