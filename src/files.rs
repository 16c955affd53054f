//! The file system, for both shells: opening a figure, saving so that nothing is lost.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use crate::export::png::{self, PngError};
use crate::figure::{Figure, FigureError, read};
use crate::limits::MAX_FILE_BYTES;
use crate::scene::{ReadError, ReadProblem};

/// Why a file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The system does not let it be read.
    #[error("cannot be read: {0}")]
    Read(io::Error),
    /// The system does not let it be written.
    #[error("cannot be written: {0}")]
    Write(io::Error),
    /// It is not a file but a directory.
    #[error("is a directory")]
    Directory,
    /// It is larger than any file that is meant for this program.
    #[error("has more than {MAX_FILE_BYTES} bytes")]
    TooLarge,
    /// A picture that holds no figure.
    #[error(transparent)]
    Png(#[from] PngError),
    /// A figure file with a fault.
    #[error(transparent)]
    Figure(#[from] FigureError),
}

/// A figure and the text that it was read from, which [`update`](crate::figure::update) wants.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The figure.
    pub figure: Figure,
    /// The text of the figure file.
    pub text: String,
}

/// Opens a figure file, or a PNG that holds one.
///
/// # Errors
/// [`FileError`]; for a figure file with a fault it names the line.
pub fn open_figure(path: &Path) -> Result<Opened, FileError> {
    figure_from(&read_file(path)?)
}

/// The figure in the bytes of a figure file, or of a PNG that holds one.
///
/// # Errors
/// [`FileError`]; for a figure file with a fault it names the line.
pub fn figure_from(bytes: &[u8]) -> Result<Opened, FileError> {
    let bytes = png::figure_bytes(bytes)?;
    let figure = read::parse_bytes(&bytes)?;
    Ok(Opened { figure, text: String::from_utf8_lossy(&bytes).into_owned() })
}

/// The bytes of a file.
///
/// # Errors
/// [`FileError`] where the system refuses, and for what is not a file or has no end.
pub fn read_file(path: &Path) -> Result<Vec<u8>, FileError> {
    let file = File::open(path).map_err(FileError::Read)?;
    if file.metadata().is_ok_and(|meta| meta.is_dir()) {
        return Err(FileError::Directory);
    }
    let mut bytes = Vec::new();
    file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes).map_err(FileError::Read)?;
    if bytes.len() as u64 > MAX_FILE_BYTES { Err(FileError::TooLarge) } else { Ok(bytes) }
}

/// The bytes of a file that a scene names, such as a mesh.
///
/// # Errors
/// As [`read_file`], as a value that can be kept.
pub fn read_for_scene(path: &Path) -> Result<Vec<u8>, ReadError> {
    read_file(path).map_err(|error| {
        let problem = match error {
            FileError::Directory => ReadProblem::Directory,
            FileError::TooLarge => ReadProblem::TooLarge,
            FileError::Read(error) | FileError::Write(error) => {
                ReadProblem::System { kind: error.kind(), detail: error.to_string() }
            }
            error @ (FileError::Png(_) | FileError::Figure(_)) => {
                ReadProblem::System { kind: io::ErrorKind::InvalidData, detail: error.to_string() }
            }
        };
        ReadError { file: path.display().to_string(), problem }
    })
}

/// Saves `bytes`: the file is there afterwards as a whole, or, after an error, as it was before.
///
/// # Errors
/// [`FileError::Write`] where the system refuses, [`FileError::Directory`] for a directory.
pub fn save(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    // A link stays a link: the file that it leads to is the one that is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let before = fs::metadata(&target).ok();
    if before.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(FileError::Directory);
    }
    if before.as_ref().is_some_and(|meta| !meta.is_file()) {
        // A device or a pipe cannot be replaced.
        return OpenOptions::new()
            .write(true)
            .open(&target)
            .and_then(|mut f| f.write_all(bytes))
            .map_err(FileError::Write);
    }
    let (temporary, file) = temporary_beside(&target).map_err(FileError::Write)?;
    let written = write_whole(file, bytes, before.as_ref()).and_then(|()| fs::rename(&temporary, &target));
    written.map_err(|error| {
        // Nothing more can be done for a temporary file that cannot be removed.
        let _ = fs::remove_file(&temporary);
        FileError::Write(error)
    })
}

fn write_whole(mut file: File, bytes: &[u8], before: Option<&fs::Metadata>) -> io::Result<()> {
    file.write_all(bytes)?;
    if let Some(before) = before {
        file.set_permissions(before.permissions())?;
    }
    file.sync_all()
}

/// A new file in the same directory, so that it can be renamed in one step.
fn temporary_beside(target: &Path) -> io::Result<(PathBuf, File)> {
    let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let mut attempt = 0_u32;
    loop {
        let mut temporary = std::ffi::OsString::from(".");
        temporary.push(name);
        temporary.push(format!(".{}-{attempt}.tmp", std::process::id()));
        let path = target.with_file_name(temporary);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
            Err(error) => return Err(error),
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    /// An empty directory of this test's own, gone at the end.
    struct Directory(PathBuf);

    impl Directory {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("camera-lab-files-{name}-{}", std::process::id()));
            let _ = fs::remove_dir_all(&path);
            fs::create_dir_all(&path).unwrap();
            Self(path)
        }

        fn names(&self) -> Vec<String> {
            fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
        }
    }

    impl Drop for Directory {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn saving_replaces_the_whole_file_and_leaves_nothing_else() {
        let directory = Directory::new("replace");
        let path = directory.0.join("figura ção.toml");
        save(&path, b"a long first text").unwrap();
        save(&path, b"short").unwrap();
        assert_eq!(read_file(&path).unwrap(), b"short");
        assert_eq!(directory.names().len(), 1);
    }

    #[test]
    fn what_cannot_be_saved_leaves_nothing_behind() {
        let directory = Directory::new("refused");
        assert!(matches!(save(&directory.0, b"x"), Err(FileError::Directory)));
        assert!(matches!(save(&directory.0.join("no/such/place.toml"), b"x"), Err(FileError::Write(_))));
        assert!(matches!(save(Path::new(""), b"x"), Err(FileError::Write(_))));
        assert!(directory.names().is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn links_and_permissions_stay() {
        use std::os::unix::fs::PermissionsExt as _;
        let directory = Directory::new("link");
        let (file, link) = (directory.0.join("file.toml"), directory.0.join("link.toml"));
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        save(&link, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[test]
    fn figures_are_opened_from_text_and_from_pictures() {
        let text = "[camera]\nnear = 0.5 # perto\n";
        let pixmap = tiny_skia::Pixmap::new(2, 2).unwrap();
        let picture = png::encode(pixmap, text).unwrap();
        let from_text = figure_from(text.as_bytes()).unwrap();
        assert_eq!(from_text.figure.camera.near, 0.5);
        assert_eq!(figure_from(&picture).unwrap(), from_text);
        assert!(matches!(figure_from(&picture[..30]), Err(FileError::Png(_))));
        assert!(matches!(open_figure(Path::new("/")), Err(FileError::Directory | FileError::Read(_))));
        assert!(matches!(open_figure(Path::new("no such file")), Err(FileError::Read(_))));
    }
}
