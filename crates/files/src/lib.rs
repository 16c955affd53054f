//! The file system, for both shells: opens figures, and saves without losing data. [`share`] packs figures into links.

mod carried;
mod file_access;
mod file_change;
pub mod hand_out;
mod lesson_files;
mod named_files;
mod own_exercises;
mod patience;
#[cfg(not(target_arch = "wasm32"))]
mod save;
pub mod share;
mod shipped;
// Its own name, for a file that tests of the window use too.
#[cfg(test)]
extern crate self as camera_lab_files;
#[cfg(test)]
mod testing;
mod travel;
mod windows_names;

/// The one door to stored and chosen files: the file system of the machine, or, in a page of a browser, the files given
/// to the page and those it stores.
pub mod disk {
    #[cfg(any(test, target_arch = "wasm32"))]
    pub mod page;
    #[cfg(not(target_arch = "wasm32"))]
    mod system;

    #[cfg(target_arch = "wasm32")]
    pub use page::{
        Lock, canonical, create_folder, exists, is_read_only, is_whole, lock, may_exist, read_at_most, remove,
        remove_left_over, rename, save, try_lock, write, written,
    };
    #[cfg(not(target_arch = "wasm32"))]
    pub use system::{
        Lock, canonical, create_folder, exists, is_whole, lock, may_exist, remove, rename, try_lock, write, written,
    };
}

use std::borrow::Cow;
#[cfg(not(target_arch = "wasm32"))]
use std::fs::{self, File};
use std::io;
#[cfg(not(target_arch = "wasm32"))]
use std::io::Read as _;
use std::path::{Path, PathBuf};

use camera_lab_engine::{camera, limits, numbers, progress, sanitize, scene};
use camera_lab_figures::{export, figure};
use camera_lab_teaching::{exercises, lessons};

use crate::camera::CameraError;
use crate::export::format::PictureFormat;
use crate::export::png::{self, PngError};
use crate::export::vector;
use crate::figure::{Figure, FigureError, read};
use crate::limits::{MAX_CAMERA_FILE_BYTES, MAX_FIGURE_BYTES, MAX_FILE_BYTES, MAX_HANDED_OUT_BYTES, MAX_OWN_EXERCISES};
use crate::scene::import::MESH_ENDINGS;
use crate::scene::{ReadProblem, system_words};
pub use carried::Carried;
#[cfg(target_arch = "wasm32")]
pub use disk::{is_read_only, read_at_most, remove_left_over, save};
pub use file_access::{FigureFiles, FileAccess};
pub use file_change::{FileChange, Stamp, look};
use hand_out::PAGE_NAME;
pub use lesson_files::{OwnLessons, is_lesson_file as is_lesson, read_lesson, read_lessons};
pub use named_files::{Renamed, for_figure_file, for_folder, named_in_figure, rename};
pub use own_exercises::{BadExercise, OwnExercises, entries, read_exercises};
pub use patience::WINDOW_WAIT;
#[cfg(not(target_arch = "wasm32"))]
use patience::in_time;
#[cfg(not(target_arch = "wasm32"))]
pub use patience::{before_each_file, limit_waiting, reader_wait};
#[cfg(not(target_arch = "wasm32"))]
pub use save::{is_read_only, remove_left_over, save};
use share::ShareError;
pub use shipped::{SHIPPED, SHIPPED_FIGURES, ShippedFigure, Topic};
pub use travel::{LeftOut, beside_figure, carried_mesh, own_files, save_carried, text_in_picture, text_with_files};

/// A reason why a file is unusable. Displayed, it follows the name of the file.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The system refuses to read it.
    #[error("cannot be read: {}", system_words(.0.kind(), .0.raw_os_error()))]
    Read(io::Error),
    /// The system refuses to write it.
    #[error("cannot be written: {}", system_words(.0.kind(), .0.raw_os_error()))]
    Write(io::Error),
    /// A directory.
    #[error("{}", ReadProblem::Directory)]
    Directory,
    /// A device, a pipe or a socket, which may have no end.
    #[error("{}", ReadProblem::NotRegular)]
    NotRegular,
    /// Its path leads to another machine. Opening it could send the user's name and password there.
    #[error("{}", ReadProblem::Network)]
    Network,
    /// Windows keeps the name for a device or for something inside of a file.
    #[error(
        "has a name that Windows reserves; allowed: names without \":\" other than CON, PRN, AUX, NUL, COM0 to COM9 and LPT0 to LPT9, whatever the extension"
    )]
    ReservedName,
    /// An existing file that may not be written.
    #[error("is read-only and was left as it is; allowed: another name, or a file that may be written")]
    ReadOnly,
    /// A file larger than any file meant for this use.
    #[error("is too large; allowed: at most {}", size_words(*.0))]
    TooLarge(u64),
    /// A folder with more exercises than a lecture has.
    #[error("has too many exercises; allowed: at most {MAX_OWN_EXERCISES}")]
    TooManyExercises,
    /// A picture that holds no figure.
    #[error(transparent)]
    Png(#[from] PngError),
    /// A picture in a format that can't hold its figure.
    #[error("is a {0}, which can't hold its figure. {names} can", names = PictureFormat::names_with_figure("and"))]
    OtherPicture(&'static str),
    /// A file of LaTeX, whose figure is in the PDF beside it.
    #[error("is a LaTeX file, which can't hold its figure. The PDF beside it does")]
    Latex,
    /// A mesh, where a figure is needed.
    #[error(
        "is a mesh, not a figure. In the window, add it with Scene ▸ + Add ▸ mesh file…; in a figure file, write [[scene.objects]] with shape = \"mesh\" and path"
    )]
    Mesh,
    /// A page that isn't that of this version in one file.
    #[error("isn't the page of this version; allowed: {PAGE_NAME} of Camera Lab {}", env!("CARGO_PKG_VERSION"))]
    OtherPage,
    /// A page or package of something that names a file of the user's own.
    #[error(
        "can't hold {0}, a file of yours; allowed: files that can be read and have at most {limit} KiB together when packed", limit = MAX_HANDED_OUT_BYTES >> 10
    )]
    OwnFile(String),
    /// A figure file with a fault.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// A link that holds no figure.
    #[error(transparent)]
    Link(#[from] ShareError),
}

/// Permission to replace files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overwrite {
    /// A file that may be written. For other files, saving returns [`FileError::ReadOnly`].
    Writable,
    /// Also a read-only file, because the user has agreed. It stays read-only.
    ReadOnlyToo,
}

/// A figure and its source text, for [`update`](crate::figure::update).
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The figure.
    pub figure: Figure,
    /// The text of the figure file.
    pub text: String,
    /// True if the text came from a picture or a link. Saving must not replace the picture by it.
    pub from_picture: bool,
    /// The files that came with it.
    pub carried: Carried,
}

/// The file that a figure came from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SourceFile {
    /// Its [`whole`] path.
    pub path: PathBuf,
    /// The text of the figure file, so that saving keeps the comments.
    pub text: String,
    /// True if it's a picture that holds this text. Saving must not replace the picture by the text.
    pub is_picture: bool,
    /// The files that the picture carries.
    pub carried: Carried,
}

impl Opened {
    /// The figure, and the file that it came from, with this path.
    pub fn at(self, path: &Path) -> (Figure, SourceFile) {
        // A link has no folder, so relative names in its figure lead nowhere.
        let path = if share::link_of(path).is_some() { PathBuf::new() } else { whole(path) };
        (self.figure, SourceFile { path, text: self.text, is_picture: self.from_picture, carried: self.carried })
    }
}

/// Opens a figure file, a picture that carries its figure, or a link that does.
///
/// # Errors
/// [`FileError`], which names the line of a fault in a figure file.
pub fn open_figure(path: &Path) -> Result<Opened, FileError> {
    let (bytes, is_link) = figure_bytes(path)?;
    figure_of(&bytes, is_link).map_err(|error| other_kind(path, &bytes).unwrap_or(error))
}

/// The kind of a file that holds no figure, if it's one that people take for a figure.
fn other_kind(path: &Path, bytes: &[u8]) -> Option<FileError> {
    let is_latex = PictureFormat::of(path) == Some(PictureFormat::Tex);
    let other = match bytes {
        [0xff, 0xd8, 0xff, ..] => PictureFormat::Jpeg.name(),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => PictureFormat::WebP.name(),
        [b'G', b'I', b'F', b'8', ..] => "GIF",
        _ if is_latex => return Some(FileError::Latex),
        _ if has_ending(path, MESH_ENDINGS) => return Some(FileError::Mesh),
        _ => return None,
    };
    Some(FileError::OtherPicture(other))
}

/// True if the name of a file has one of these extensions, in any case.
pub fn has_ending(path: &Path, endings: &[&str]) -> bool {
    path.extension().is_some_and(|ending| endings.iter().any(|own| ending.eq_ignore_ascii_case(own)))
}

/// As [`open_figure`], but accepts a figure whose camera is impossible. It comes with the error of its camera.
///
/// # Errors
/// As for [`open_figure`], except for an impossible camera.
pub fn open_figure_with_any_camera(path: &Path) -> Result<(Opened, Option<CameraError>), FileError> {
    let (bytes, is_link) = figure_bytes(path)?;
    let or_other = |error| other_kind(path, &bytes).unwrap_or(error);
    let (text, from_picture, carried) = figure_text(&bytes, is_link).map_err(or_other)?;
    let read = |text| read::parse_with_any_camera(read::text_of(text, MAX_FIGURE_BYTES)?);
    let (figure, error) = read(&text).map_err(|error| or_other(error.into()))?;
    let text = String::from_utf8_lossy(&text).into_owned();
    Ok((Opened { figure, text, from_picture, carried }, error))
}

/// The bytes that tell a format.
const HEAD_OF_KIND: u64 = 16;

/// The bytes behind a path, and true if they come from a link.
fn figure_bytes(path: &Path) -> Result<(Vec<u8>, bool), FileError> {
    match share::link_of(path).and_then(share::text_in) {
        Some(text) => Ok((text?, true)),
        None => match read_figure_file(path) {
            Ok(bytes) => Ok((bytes, false)),
            // A photograph or a mesh of any size gets its kind, and not the limit of figures.
            Err(error) => {
                let head = read_start(path, HEAD_OF_KIND).unwrap_or_default();
                let is_too_large = matches!(error, FileError::TooLarge(..));
                Err(other_kind(path, &head).filter(|_| is_too_large).unwrap_or(error))
            }
        },
    }
}

/// True for a file that doesn't answer within the time that this thread waits.
pub fn stalls(path: &Path) -> bool {
    matches!(read_start(path, 1), Err(FileError::Read(error)) if error.kind() == io::ErrorKind::TimedOut)
}

/// The bytes of a figure file, or of a picture, which may be larger.
///
/// # Errors
/// As for [`read_file`], also for a figure file that's longer than any.
pub fn read_figure_file(path: &Path) -> Result<Vec<u8>, FileError> {
    /// Enough to tell pictures from texts.
    const HEAD: u64 = 4096;
    match read_at_most(path, MAX_FIGURE_BYTES as u64) {
        Err(FileError::TooLarge(_)) if is_picture(&read_start(path, HEAD)?) => read_file(path),
        read => read,
    }
}

/// True for bytes that begin like a picture that may hold a figure.
fn is_picture(bytes: &[u8]) -> bool {
    png::is_png(bytes) || vector::figure_in(bytes).is_some()
}

/// The figure in the bytes of a figure file, or of a PNG that holds one.
///
/// # Errors
/// [`FileError`], which names the line of a fault in a figure file.
pub fn figure_from(bytes: &[u8]) -> Result<Opened, FileError> {
    figure_of(bytes, false)
}

fn figure_of(bytes: &[u8], is_link: bool) -> Result<Opened, FileError> {
    let (bytes, from_picture, carried) = figure_text(bytes, is_link)?;
    let figure = read::parse_bytes(&bytes)?;
    Ok(Opened { figure, text: String::from_utf8_lossy(&bytes).into_owned(), from_picture, carried })
}

/// The text of the figure in the bytes of a file or a link, true for a picture or a link, and the files that it
/// carries.
fn figure_text(bytes: &[u8], is_link: bool) -> Result<(Cow<'_, [u8]>, bool, Carried), FileError> {
    let from_vectors = vector::figure_in(bytes);
    let from_picture = is_link || png::is_png(bytes) || from_vectors.is_some();
    let text = match from_vectors {
        Some(found) => found.filter(|text| text.len() <= MAX_FIGURE_BYTES).ok_or(PngError::NoFigure)?.into(),
        None => png::figure_bytes(bytes, MAX_FIGURE_BYTES)?,
    };
    if !from_picture {
        return Ok((text, false, Carried::default()));
    }
    let (text, carried) = Carried::from_text(text.into_owned());
    Ok((text.into(), true, carried))
}

/// The bytes of a regular file of this machine.
///
/// # Errors
/// [`FileError`] if the system refuses, if the file isn't regular or is too large, and for network paths.
pub fn read_file(path: &Path) -> Result<Vec<u8>, FileError> {
    read_at_most(path, MAX_FILE_BYTES)
}

/// As [`read_file`], of at most `most` bytes.
///
/// # Errors
/// As for [`read_file`].
#[cfg(not(target_arch = "wasm32"))]
pub fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let read = move |path: &Path| {
        let (file, length) = open_regular(path)?;
        // A file that reports too large a size isn't read at all. One that grows meanwhile isn't trusted either.
        if length > most {
            return Err(FileError::TooLarge(most));
        }
        let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or_default());
        file.take(most + 1).read_to_end(&mut bytes).map_err(FileError::Read)?;
        if bytes.len() as u64 > most { Err(FileError::TooLarge(most)) } else { Ok(bytes) }
    };
    in_time(path, read).map_err(FileError::Read)?
}

/// The bytes of a file with cameras of another program. Of a GLB file only its JSON, the meshes behind it aren't read.
///
/// # Errors
/// As for [`read_file`], of at most [`MAX_CAMERA_FILE_BYTES`].
pub fn read_camera_file(path: &Path) -> Result<Vec<u8>, FileError> {
    /// Magic, version, length, length of the first chunk, its kind.
    const HEAD: u64 = 20;
    let head = read_start(path, HEAD)?;
    match head.get(12..16).and_then(|length| length.try_into().ok()).map(u32::from_le_bytes) {
        Some(length) if head.starts_with(b"glTF") => {
            let whole = HEAD + u64::from(length);
            if u64::from(length) > MAX_CAMERA_FILE_BYTES {
                return Err(FileError::TooLarge(MAX_CAMERA_FILE_BYTES));
            }
            read_start(path, whole)
        }
        _ => read_at_most(path, MAX_CAMERA_FILE_BYTES),
    }
}

/// The first bytes of a file, at most `most`.
///
/// # Errors
/// As for [`read_file`].
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn read_start(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let read = move |path: &Path| {
        let mut bytes = Vec::new();
        open_regular(path)?.0.take(most).read_to_end(&mut bytes).map_err(FileError::Read)?;
        Ok(bytes)
    };
    in_time(path, read).map_err(FileError::Read)?
}

/// As in a folder, because a page has its files in memory.
///
/// # Errors
/// As for [`read_file`].
#[cfg(target_arch = "wasm32")]
pub(crate) fn read_start(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let mut bytes = read_at_most(path, MAX_FILE_BYTES)?;
    bytes.truncate(usize::try_from(most).unwrap_or(usize::MAX));
    Ok(bytes)
}

/// Opens a regular file. Returns its length too.
#[cfg(not(target_arch = "wasm32"))]
fn open_regular(path: &Path) -> Result<(File, u64), FileError> {
    check_path(path)?;
    // Check before opening it, because opening a pipe waits until another process writes to it.
    let kind = fs::metadata(path).map_err(FileError::Read)?.file_type();
    if kind.is_dir() {
        return Err(FileError::Directory);
    }
    if !kind.is_file() {
        return Err(FileError::NotRegular);
    }
    let file = File::open(path).map_err(FileError::Read)?;
    // Checked again on the open file, because another one may have taken its place.
    let now = file.metadata().map_err(FileError::Read)?;
    if !now.is_file() {
        return Err(FileError::NotRegular);
    }
    Ok((file, now.len()))
}

/// A size in bytes, as messages give it.
pub fn size_words(bytes: u64) -> String {
    let unit = |shift: u32, name: &str| (bytes >> shift > 0).then(|| format!("{} {name}", bytes >> shift));
    unit(30, "GiB").or_else(|| unit(20, "MiB")).unwrap_or_else(|| format!("{bytes} bytes"))
}

/// Refuses a path that no file of this machine can have.
fn check_path(path: &Path) -> Result<(), FileError> {
    if is_network(path) {
        return Err(FileError::Network);
    }
    if windows_names::is_reserved(path) { Err(FileError::ReservedName) } else { Ok(()) }
}

/// A path that means the same file from every folder. Links in it stay.
pub fn whole(path: &Path) -> PathBuf {
    // An error is an empty path, or a current folder that is gone. Then the path as given is the best we have.
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// True for paths that begin with two slashes or backslashes, as Windows names other machines (`\\\\host\\share`). Its
/// long names of local disks (`\\\\?\\C:\\`) begin like that too, but are local.
pub fn is_network(path: &Path) -> bool {
    let text = path.as_os_str().as_encoded_bytes();
    let separators = text.iter().take_while(|byte| matches!(byte, b'/' | b'\\')).count();
    let long_name_of_a_disk = text.starts_with(br"\\?\") && text.get(5) == Some(&b':');
    separators >= 2 && !long_name_of_a_disk
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use std::time::{Duration, Instant};

    use super::testing::{Directory, Stall};
    use super::*;
    use crate::progress::{Progress, at_once};

    #[test]
    fn figures_are_opened_from_text_and_from_pictures() {
        let text = "[camera]\nnear = 0.5 # perto\n";
        let pixmap = tiny_skia::Pixmap::new(2, 2).unwrap();
        let picture = at_once(png::encode(pixmap, text, None, None, &Progress::default())).unwrap();
        let from_text = figure_from(text.as_bytes()).unwrap();
        assert_eq!(from_text.figure.camera.near, 0.5);
        assert_eq!(figure_from(&picture).unwrap(), Opened { from_picture: true, ..from_text });
        assert!(matches!(figure_from(&picture[..30]), Err(FileError::Png(_))));
        assert!(matches!(open_figure(Path::new("/")), Err(FileError::Directory | FileError::Read(_))));
        assert!(matches!(open_figure(Path::new("no such file")), Err(FileError::Read(_))));
    }

    #[test]
    fn paths_to_other_machines_are_refused_unread() {
        for path in [r"\\host\share\x.obj", "//host/share/x.obj", r"\/host", r"\\?\UNC\host\share", r"\\.\pipe\x"] {
            assert!(is_network(Path::new(path)), "{path}");
            assert!(matches!(read_file(Path::new(path)), Err(FileError::Network)));
        }
        for path in [r"\\?\C:\lecture\x.obj", r"C:\x.obj", "/tmp/x.obj", r"\x", "x", "", "a//b"] {
            assert!(!is_network(Path::new(path)), "{path}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn devices_and_pipes_are_refused_before_anything_is_read() {
        assert!(matches!(read_file(Path::new("/dev/zero")), Err(FileError::NotRegular)));
        assert!(matches!(read_file(Path::new("/dev/null")), Err(FileError::NotRegular)));
        let directory = Directory::new("pipe");
        let pipe = directory.path().join("pipe.toml");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.is_ok_and(|status| status.success()));
        // Would wait for ever if it was opened.
        assert!(matches!(open_figure(&pipe), Err(FileError::NotRegular)));
    }

    /// True if the file took too long.
    fn is_late<T>(result: Result<T, FileError>) -> bool {
        matches!(result, Err(FileError::Read(error) | FileError::Write(error)) if error.kind() == io::ErrorKind::TimedOut)
    }

    #[test]
    fn no_access_to_a_stalled_file_takes_longer_than_the_limit() {
        let directory = Directory::new("stalled");
        let [slow, quick] = ["slow.toml", "quick.toml"].map(|name| directory.path().join(name));
        for path in [&slow, &quick] {
            fs::write(path, "[camera]\n").unwrap();
        }
        // A thread of its own, since the limit stays with the thread.
        let (slow, quick) = (slow.clone(), quick.clone());
        std::thread::spawn(move || {
            limit_waiting(Duration::from_millis(300));
            let stall = Stall::of(&slow);
            let begin = Instant::now();
            assert!(is_late(open_figure(&slow)));
            assert!(begin.elapsed() >= Duration::from_millis(300));
            // Each way to read and to write. Not even the limit is waited for again.
            assert!(is_late(read_lesson(&slow)));
            assert!(is_late(save(&slow, b"new", Overwrite::Writable)));
            assert!(is_late(read_camera_file(&slow).map(drop)));
            assert!(!is_lesson(&slow) && !is_read_only(&slow));
            assert_eq!(look(&slow, b"", None), FileChange::Other(None));
            let late = |result: io::Result<()>| result.is_err_and(|error| error.kind() == io::ErrorKind::TimedOut);
            assert!(late(disk::write(&slow, b"")) && late(disk::remove(&slow)) && late(disk::rename(&slow, &quick)));
            assert!(late(disk::lock(&slow).map(drop)) && late(disk::try_lock(&slow).map(drop)));
            assert!(late(disk::create_folder(&slow)) && late(disk::canonical(&slow).map(drop)));
            assert!(!disk::exists(&slow) && disk::may_exist(&slow) && disk::written(&slow).is_none());
            assert!(begin.elapsed() < Duration::from_millis(600), "{:?}", begin.elapsed());
            // Other files are as usual.
            assert!(open_figure(&quick).is_ok());
            drop(stall);
            while is_late(open_figure(&slow)) {
                assert!(begin.elapsed() < Duration::from_secs(60));
                std::thread::sleep(Duration::from_millis(5));
            }
            assert!(open_figure(&slow).is_ok(), "it is as it was");
        })
        .join()
        .unwrap();
    }
}
