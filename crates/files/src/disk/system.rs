//! The file system of the machine. Reading and saving are in the [root](crate) of the crate.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

use crate::patience::in_time;

/// The longest wait for the lock of another window. They hold it for some milliseconds.
const LOCK_WAIT: Duration = Duration::from_millis(1500);

/// A lock against other windows, for as long as this value lives. The system releases it when the program ends, however
/// it ends.
#[derive(Debug)]
pub struct Lock(#[expect(dead_code, reason = "it is what it keeps open")] File);

/// The lock in this file, unless another window has it.
///
/// # Errors
/// If the file can't be created, or the system can't lock it.
pub fn try_lock(path: &Path) -> io::Result<Option<Lock>> {
    in_time(path, |path| {
        let file = open(path)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Lock(file))),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(error),
        }
    })?
}

/// The lock in this file. Waits while another window has it, but not for ever, since that window may have been stopped.
/// If there are no locks, it keeps no window away.
///
/// # Errors
/// If the file can't be created, or another window keeps the lock.
pub fn lock(path: &Path) -> io::Result<Lock> {
    in_time(path, |path| {
        let (file, begin) = (open(path)?, Instant::now());
        while let Err(TryLockError::WouldBlock) = file.try_lock() {
            if begin.elapsed() > LOCK_WAIT {
                return Err(io::ErrorKind::ResourceBusy.into());
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        Ok(Lock(file))
    })?
}

fn open(path: &Path) -> io::Result<File> {
    OpenOptions::new().create(true).truncate(false).write(true).open(path)
}

/// True if this name exists, as far as the system says so in time.
pub fn exists(path: &Path) -> bool {
    in_time(path, Path::exists).unwrap_or(false)
}

/// True unless the system says that this name doesn't exist.
pub fn may_exist(path: &Path) -> bool {
    in_time(path, Path::exists).unwrap_or(true)
}

/// The time when a file was written last, if the system knows it.
pub fn written(path: &Path) -> Option<SystemTime> {
    in_time(path, |path| fs::metadata(path).and_then(|meta| meta.modified()).ok()).ok()?
}

/// Gives a file another name.
///
/// # Errors
/// If the system refuses.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    let to = to.to_owned();
    in_time(from, |from| fs::rename(from, to))?
}

/// Removes a file. If it doesn't exist, that's no error.
///
/// # Errors
/// If the system refuses.
pub fn remove(path: &Path) -> io::Result<()> {
    match in_time(path, |path| fs::remove_file(path))? {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Writes a file of the program's own.
///
/// # Errors
/// If the system refuses.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let bytes = bytes.to_owned();
    in_time(path, |path| fs::write(path, bytes))?
}

/// Creates a folder, and the folders that it lies in.
///
/// # Errors
/// If the system refuses.
pub fn create_folder(path: &Path) -> io::Result<()> {
    // A file in the place of the last folder is reported like a file in the place of any other.
    in_time(path, |path| fs::create_dir_all(path))?.map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => io::ErrorKind::NotADirectory.into(),
        _ => error,
    })
}

/// The path without links and `..`.
///
/// # Errors
/// If the system doesn't find it.
pub fn canonical(path: &Path) -> io::Result<PathBuf> {
    in_time(path, |path| fs::canonicalize(path))?
}

/// True for a path that means the same file from every folder.
pub fn is_whole(path: &Path) -> bool {
    path.is_absolute()
}
