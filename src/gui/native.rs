//! What a dialog for files is asked, and what it answers: that of the system, or that of a browser.

#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(not(target_arch = "wasm32"))]
mod system;

use std::path::PathBuf;

#[cfg(target_arch = "wasm32")]
pub(super) use page::{OpenFileDialog, read};
#[cfg(not(target_arch = "wasm32"))]
pub(super) use system::OpenFileDialog;

/// What is to be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// A file that is there.
    File,
    /// A file that may not exist yet.
    NewFile,
    /// A folder.
    Folder,
}

/// What to ask for.
#[derive(Clone, Debug)]
pub struct FileQuestion {
    /// What is to be chosen.
    pub wanted: Wanted,
    /// The title of the dialog.
    pub title: &'static str,
    /// What the files are called, and what their names end in.
    pub filters: Vec<(String, &'static [&'static str])>,
    /// The name that is proposed.
    pub name: String,
    /// Where the dialog starts.
    pub folder: Option<PathBuf>,
}

/// What came back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileAnswer {
    /// A path.
    Chosen(PathBuf),
    /// The dialog was closed.
    Cancelled,
    /// There is no dialog on this system.
    Unavailable,
}

/// Shows a message in a box of the system, and waits until it is closed.
#[cfg(windows)]
pub fn message_box(message: &str) {
    rfd::MessageDialog::new()
        .set_title("Camera Lab")
        .set_level(rfd::MessageLevel::Error)
        .set_description(message)
        .show();
}
