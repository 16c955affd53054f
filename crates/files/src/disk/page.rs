//! The substitute for a file system in a page of a browser.
//!
//! The page stores files in [`KEPT`] from one visit to the next, as text. Any other file that is written goes to the
//! user as a download and can't be read again. Readable are the files that the user has given to the page, until the
//! user leaves it.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

use crate::{FileError, Overwrite};

/// The folder of stored files.
pub const KEPT: &str = "/camera-lab";

/// The functions of the page. Each name is the path in [`KEPT`].
#[derive(Clone, Copy, Debug)]
pub struct Page {
    /// Reads the text stored under a name.
    pub kept: fn(&str) -> Option<String>,
    /// Keeps a text under a name, or, with `None`, forgets it.
    pub keep: fn(&str, Option<&str>) -> io::Result<()>,
    /// Hands a file with this name to the user.
    pub download: fn(&str, &[u8]) -> io::Result<()>,
    /// True if another page of this origin holds the lock of this name.
    pub held_elsewhere: fn(&str) -> bool,
    /// Takes or releases the lock of this name.
    pub hold: fn(&str, bool),
    /// The seconds since the beginning of 1970.
    pub clock: fn() -> u64,
}

#[derive(Debug)]
struct Files {
    page: Option<Page>,
    /// The files given by the user to the page.
    given: BTreeMap<PathBuf, Vec<u8>>,
    /// The locks of this page.
    held: BTreeSet<String>,
}

static FILES: Mutex<Files> = Mutex::new(Files { page: None, given: BTreeMap::new(), held: BTreeSet::new() });

fn files() -> MutexGuard<'static, Files> {
    // A panic could leave at most one entry of a map half done.
    FILES.lock().unwrap_or_else(PoisonError::into_inner)
}

fn page() -> io::Result<Page> {
    files().page.ok_or_else(|| io::ErrorKind::Unsupported.into())
}

/// Sets the functions of the page. Nothing can be stored before that.
pub fn begin(page: Page) {
    files().page = Some(page);
}

/// Gives a file to the page. From now on it can be read under its name.
pub fn give(path: PathBuf, bytes: Vec<u8>) {
    files().given.insert(path, bytes);
}

/// The name under which a path is stored.
fn name(path: &Path) -> Option<&str> {
    path.strip_prefix(KEPT).ok()?.to_str()
}

/// The key of the time at which a text was stored.
fn time_of(name: &str) -> String {
    format!("{name}.time")
}

/// The bytes of a stored or given file of at most `most` bytes.
///
/// # Errors
/// [`FileError`] if there is no such file, or it's larger.
pub fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let bytes = match name(path) {
        Some(name) => {
            let kept = page().ok().and_then(|page| (page.kept)(name));
            kept.ok_or_else(|| FileError::Read(io::ErrorKind::NotFound.into()))?.into_bytes()
        }
        // Folders of the user aren't visible. For a file named in one, only the name counts.
        None => {
            crate::check_path(path)?;
            let files = files();
            let given = files.given.get(path).or_else(|| files.given.get(Path::new(path.file_name()?)));
            given.cloned().ok_or_else(|| FileError::Read(io::ErrorKind::Unsupported.into()))?
        }
    };
    if bytes.len() as u64 > most { Err(FileError::TooLarge(most)) } else { Ok(bytes) }
}

/// Keeps the bytes, or hands them to the user.
///
/// # Errors
/// [`FileError::Write`] if the page refuses.
pub fn save(path: &Path, bytes: &[u8], _: Overwrite) -> Result<(), FileError> {
    write(path, bytes).map_err(FileError::Write)
}

/// As [`save`].
///
/// # Errors
/// The refusal of the page. Stored files have to be text.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let page = page()?;
    let Some(name) = name(path) else {
        let name = path.file_name().and_then(|name| name.to_str()).ok_or(io::ErrorKind::InvalidFilename)?;
        return (page.download)(name, bytes);
    };
    let text = str::from_utf8(bytes).map_err(|_| io::ErrorKind::InvalidData)?;
    (page.keep)(name, Some(text))?;
    // If this fails, only the age of the file is unknown.
    let _ = (page.keep)(&time_of(name), Some(&(page.clock)().to_string()));
    Ok(())
}

/// True if a file is stored under this path. A download replaces nothing.
pub fn exists(path: &Path) -> bool {
    name(path).zip(page().ok()).is_some_and(|(name, page)| (page.kept)(name).is_some())
}

/// As [`exists`], because a page never waits.
pub fn may_exist(path: &Path) -> bool {
    exists(path)
}

/// The time at which the file under this path was stored.
pub fn written(path: &Path) -> Option<SystemTime> {
    let seconds = (page().ok()?.kept)(&time_of(name(path)?))?.parse().ok()?;
    SystemTime::UNIX_EPOCH.checked_add(Duration::from_secs(seconds))
}

/// Deletes the file stored under this path.
///
/// # Errors
/// The refusal of the page.
pub fn remove(path: &Path) -> io::Result<()> {
    let Some(name) = name(path) else { return Ok(()) };
    let page = page()?;
    (page.keep)(name, None)?;
    (page.keep)(&time_of(name), None)
}

/// Moves the file stored under this path to another one.
///
/// # Errors
/// The refusal of the page, or a path under which nothing is stored.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    let kept = name(from).zip(page().ok()).and_then(|(name, page)| (page.kept)(name));
    write(to, kept.ok_or(io::ErrorKind::NotFound)?.as_bytes())?;
    remove(from)
}

/// A page has no folders to create.
///
/// # Errors
/// None.
pub const fn create_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// A page has no links.
///
/// # Errors
/// None.
pub fn canonical(path: &Path) -> io::Result<PathBuf> {
    Ok(path.to_owned())
}

/// True for a path with a file name. There is one folder, so a name means the same from everywhere.
pub fn is_whole(path: &Path) -> bool {
    path.file_name().is_some()
}

/// A page never leaves half-written files behind.
pub const fn remove_left_over(_: &Path) {}

/// A download is never read-only.
pub const fn is_read_only(_: &Path) -> bool {
    false
}

/// A lock against other pages of this origin, for as long as this value lives. The browser releases it with the page.
#[derive(Debug)]
pub struct Lock(String);

/// The lock of this name, unless this or another page has it.
///
/// # Errors
/// If a page can't keep anything.
pub fn try_lock(path: &Path) -> io::Result<Option<Lock>> {
    let (Some(name), page) = (name(path), page()?) else { return Ok(None) };
    let mut files = files();
    if (page.held_elsewhere)(name) || !files.held.insert(name.to_owned()) {
        return Ok(None);
    }
    drop(files);
    (page.hold)(name, true);
    Ok(Some(Lock(name.to_owned())))
}

/// Does nothing, because no other code of a page runs while work under this lock is done.
///
/// # Errors
/// None.
pub const fn lock(_: &Path) -> io::Result<Lock> {
    Ok(Lock(String::new()))
}

impl Drop for Lock {
    fn drop(&mut self) {
        if files().held.remove(&self.0)
            && let Ok(page) = page()
        {
            (page.hold)(&self.0, false);
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    static STORE: Mutex<BTreeMap<String, String>> = Mutex::new(BTreeMap::new());
    static DOWNLOADS: Mutex<Vec<(String, Vec<u8>)>> = Mutex::new(Vec::new());

    /// A page that keeps texts of up to 20 bytes.
    fn keep(name: &str, text: Option<&str>) -> io::Result<()> {
        let mut store = STORE.lock().unwrap();
        match text {
            None => drop(store.remove(name)),
            Some(text) if text.len() <= 20 => drop(store.insert(name.to_owned(), text.to_owned())),
            Some(_) => return Err(io::ErrorKind::StorageFull.into()),
        }
        Ok(())
    }

    fn download(name: &str, bytes: &[u8]) -> io::Result<()> {
        DOWNLOADS.lock().unwrap().push((name.to_owned(), bytes.to_owned()));
        Ok(())
    }

    // One test, because files given to a page exist for the whole program.
    #[test]
    fn stored_files_come_back_and_saved_ones_go_to_the_user() {
        let kept = Path::new("/camera-lab/session-0.json");
        assert_eq!(write(kept, b"x").unwrap_err().kind(), io::ErrorKind::Unsupported);
        begin(Page {
            kept: |name| STORE.lock().unwrap().get(name).cloned(),
            keep,
            download,
            held_elsewhere: |name| name == "session-1.lock",
            hold: |_, _| {},
            clock: || 1000,
        });
        let read = |path: &Path| read_at_most(path, 100);
        assert!(matches!(read(kept), Err(FileError::Read(error)) if error.kind() == io::ErrorKind::NotFound));
        save(kept, "θ = 3".as_bytes(), Overwrite::Writable).unwrap();
        assert_eq!(read(kept).unwrap(), "θ = 3".as_bytes());
        assert_eq!(written(kept), SystemTime::UNIX_EPOCH.checked_add(Duration::from_secs(1000)));
        // If a file doesn't fit, the old one stays.
        assert_eq!(write(kept, &[b'a'; 21]).unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert!(matches!(save(kept, &[0xff], Overwrite::Writable), Err(FileError::Write(_))));
        assert!(matches!(read_at_most(kept, 3), Err(FileError::TooLarge(3))));
        let aside = Path::new("/camera-lab/session-0.damaged");
        rename(kept, aside).unwrap();
        assert!(!exists(kept) && exists(aside) && written(kept).is_none());
        assert_eq!(read(aside).unwrap(), "θ = 3".as_bytes());
        remove(aside).unwrap();
        assert!(STORE.lock().unwrap().is_empty());

        let figure = Path::new("cube.toml");
        assert!(matches!(read(figure), Err(FileError::Read(error)) if error.kind() == io::ErrorKind::Unsupported));
        save(figure, b"[camera]", Overwrite::Writable).unwrap();
        assert!(!exists(figure) && read(figure).is_err());
        assert_eq!(*DOWNLOADS.lock().unwrap(), [("cube.toml".to_owned(), b"[camera]".to_vec())]);
        give(figure.to_owned(), b"[camera]".to_vec());
        assert_eq!(read(figure).unwrap(), b"[camera]");
        assert_eq!(read(Path::new("../figures/cube.toml")).unwrap(), b"[camera]");

        let [free, taken] = ["session-0.lock", "session-1.lock"].map(|name| Path::new(KEPT).join(name));
        assert!(try_lock(&taken).unwrap().is_none());
        let held = try_lock(&free).unwrap();
        assert!(try_lock(&free).unwrap().is_none());
        drop(held);
        assert!(try_lock(&free).unwrap().is_some());
    }
}
