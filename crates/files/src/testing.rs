//! Files that stall, and a folder for a test. The unit tests of the window use this file too.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Condvar, Mutex};

use camera_lab_files::before_each_file;

/// The files and folders that stall at present.
static STALLS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static ENDED: Condvar = Condvar::new();

/// A file that stalls, or a folder with all its files, for as long as this value lives: whatever is done with it
/// waits, as on a network disk that has gone away.
pub(crate) struct Stall(PathBuf);

impl Stall {
    pub(crate) fn of(path: &Path) -> Self {
        before_each_file(wait_while_stalled);
        STALLS.lock().unwrap().push(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Stall {
    fn drop(&mut self) {
        STALLS.lock().unwrap().retain(|path| *path != self.0);
        ENDED.notify_all();
    }
}

/// Waits while a file stalls.
fn wait_while_stalled(path: &Path) {
    let stalls = STALLS.lock().unwrap();
    drop(ENDED.wait_while(stalls, |stalls| stalls.iter().any(|stalled| path.starts_with(stalled))));
}

/// An empty directory of a test's own, gone at the end.
pub(crate) struct Directory(PathBuf);

impl Directory {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("camera-lab-files-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
