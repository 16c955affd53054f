//! How the files are read that a scene names, and what keeps them from being read.

use std::io;

/// Gives the bytes of the file with this path (as the figure names it).
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, ReadError> + 'a;

/// Why a file that a scene names cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {problem}")]
pub struct ReadError {
    /// The file, as it was looked for.
    pub file: String,
    /// Why.
    pub problem: ReadProblem,
}

/// What keeps a file from being read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadProblem {
    /// The system refuses.
    #[error("{detail}")]
    System {
        /// The kind of refusal.
        kind: io::ErrorKind,
        /// The system's words.
        detail: String,
    },
    /// It is a directory.
    #[error("is a directory")]
    Directory,
    /// It is larger than any file that is meant for this program.
    #[error("is too large")]
    TooLarge,
    /// It is a device, a pipe or a socket, which may have no end.
    #[error("is not a regular file")]
    NotRegular,
    /// Its path leads to another machine.
    #[error("is on the network")]
    Network,
}

/// For scenes without files: a [`ReadFile`] that finds none.
///
/// # Errors
/// Always: the file does not exist.
pub fn no_files(file: &str) -> Result<Vec<u8>, ReadError> {
    let kind = io::ErrorKind::NotFound;
    Err(ReadError { file: file.to_owned(), problem: ReadProblem::System { kind, detail: kind.to_string() } })
}
