//! Reading of the files that a scene names, and its failures.

use std::borrow::Cow;
use std::io;

use crate::limits::MAX_SCENE_BYTES;
use crate::sanitize;

/// Gives the bytes of a file.
pub type ReadFile<'a> = dyn FnMut(Wanted<'_>) -> Result<Vec<u8>, ReadError> + 'a;

/// Gives the bytes of a file that a mesh names, as it names it.
pub(super) type Beside<'a> = dyn FnMut(&str) -> Result<Vec<u8>, ReadError> + 'a;

/// A file that a scene names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wanted<'a> {
    /// Its path, relative to the folder of the figure.
    pub path: &'a str,
    /// The path of the mesh that names it; `None` if the figure itself does.
    pub named_by: Option<&'a str>,
}

/// The reason why a file that a scene names can't be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file} {problem}")]
pub struct ReadError {
    /// The path of the file that was looked for.
    pub file: String,
    /// Why.
    pub problem: ReadProblem,
}

/// A reason why a file can't be read. Displayed, it follows the name of the file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadProblem {
    /// The system refuses.
    #[error("cannot be read: {}", system_words(*kind, *code))]
    System {
        /// The kind of refusal.
        kind: io::ErrorKind,
        /// The system's number for it, if it has one.
        code: Option<i32>,
    },
    /// A directory.
    #[error("is a directory; allowed: a file")]
    Directory,
    /// A device, a pipe or a socket, which may have no end.
    #[error("is a device, a pipe or a socket; allowed: a regular file")]
    NotRegular,
    /// The file lies outside the only folder that may be read.
    #[error(
        "was not read, because {named_by} names it and it lies elsewhere; allowed: files in {folder} and below, or any with --allow-files (in the window: the button beside the path)"
    )]
    Outside {
        /// The folder, as displayed.
        folder: String,
        /// The kind of file that names it.
        named_by: NamedBy,
    },
    /// With it, the figure would make the program read more than any figure needs.
    #[error("was not read, because with it the files of this figure exceed {} MiB; allowed: less than that for all of them together", MAX_SCENE_BYTES >> 20)]
    Budget,
    /// A figure names it that came without a folder.
    #[error(
        "was not read, because a figure without a folder, as in a link, names it; allowed: meshes of the program, or any file with --allow-files (in the window: the button beside the path)"
    )]
    NoFolder,
    /// Its path leads to another machine.
    #[error("is on another machine; allowed: files of this one")]
    Network,
}

impl ReadError {
    /// True if the file lies outside the folder that the figure may read from. The user can allow it.
    pub const fn is_outside(&self) -> bool {
        matches!(self.problem, ReadProblem::Outside { .. } | ReadProblem::NoFolder)
    }
}

impl ReadProblem {
    /// The error of the system.
    pub fn system(error: &io::Error) -> Self {
        Self::System { kind: error.kind(), code: error.raw_os_error() }
    }
}

/// The kind of file that names another one, which isn't read because it lies elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NamedBy {
    /// A mesh.
    #[error("a mesh")]
    Mesh,
    /// A figure that came inside a picture.
    #[error("a figure inside an image")]
    Picture,
    /// A lesson.
    #[error("a lesson")]
    Lesson,
}

/// An error of the system in plain English. An unusual one by its number. Its own sentence may be in any language.
pub fn system_words(kind: io::ErrorKind, code: Option<i32>) -> Cow<'static, str> {
    let words = match system_kind(kind, code) {
        io::ErrorKind::NotFound => "there is no such file or directory",
        io::ErrorKind::PermissionDenied => "permission denied",
        io::ErrorKind::IsADirectory => "it is a directory",
        io::ErrorKind::NotADirectory => "a part of the path is not a directory",
        io::ErrorKind::AlreadyExists => "something of this name exists already",
        io::ErrorKind::InvalidInput | io::ErrorKind::InvalidFilename => "no file can have this name",
        io::ErrorKind::StorageFull => "the disk is full",
        io::ErrorKind::QuotaExceeded => "your disk quota is used up",
        io::ErrorKind::FileTooLarge => "the disk does not accept a file this large",
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        io::ErrorKind::ResourceBusy | io::ErrorKind::ExecutableFileBusy => "another program is using it",
        io::ErrorKind::CrossesDevices => "it is on another disk",
        io::ErrorKind::OutOfMemory => "there is not enough memory",
        io::ErrorKind::BrokenPipe => "the reader has closed it",
        io::ErrorKind::TimedOut => "it took too long",
        io::ErrorKind::UnexpectedEof | io::ErrorKind::WriteZero => "it ended early",
        io::ErrorKind::InvalidData => "it holds invalid data",
        // Only a page of a browser has no files at all.
        io::ErrorKind::Unsupported => {
            "a page in a browser cannot read folders; choose the file there, or drop it on the page"
        }
        _ if is_loop(code) => "its links form a cycle",
        _ => match code {
            Some(code) => return format!("the system refuses, with its error {code}").into(),
            None => "the system refuses",
        },
    };
    words.into()
}

/// The kind of an error of the system, even if the standard library knows none: Windows' files that another program
/// keeps to itself (its errors 32 and 33).
pub fn system_kind(kind: io::ErrorKind, code: Option<i32>) -> io::ErrorKind {
    if cfg!(windows) && matches!(code, Some(32 | 33)) { io::ErrorKind::ResourceBusy } else { kind }
}

/// True for links that lead to one another, for which the standard library has no kind.
pub fn is_loop(code: Option<i32>) -> bool {
    const LOOP: i32 = if cfg!(any(target_os = "linux", target_os = "android")) { 40 } else { 62 };
    cfg!(unix) && code == Some(LOOP)
}

/// For scenes without files: a [`ReadFile`] that finds none.
///
/// # Errors
/// Always, because the file doesn't exist.
pub fn no_files(wanted: Wanted<'_>) -> Result<Vec<u8>, ReadError> {
    let problem = ReadProblem::System { kind: io::ErrorKind::NotFound, code: None };
    Err(ReadError { file: sanitize::path_text(wanted.path), problem })
}
