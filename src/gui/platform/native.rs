//! Questions of a file dialog, and their answers from the system, or from a browser.

#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(not(target_arch = "wasm32"))]
mod system;

use std::path::PathBuf;

#[cfg(target_arch = "wasm32")]
pub(in crate::gui) use page::{OpenFileDialog, read};
#[cfg(not(target_arch = "wasm32"))]
pub(in crate::gui) use system::OpenFileDialog;

/// The kind of file to choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// An existing file.
    File,
    /// A file that may not exist yet.
    NewFile,
    /// A folder.
    Folder,
}

/// A question for a file.
#[derive(Clone, Debug)]
pub struct FileQuestion {
    /// The kind of file to choose.
    pub wanted: Wanted,
    /// The title of the dialog.
    pub title: &'static str,
    /// The names of the kinds of files, and their extensions.
    pub filters: Vec<(String, &'static [&'static str])>,
    /// The proposed name.
    pub name: String,
    /// The initial folder of the dialog.
    pub folder: Option<PathBuf>,
}

/// The answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileAnswer {
    /// A path.
    Chosen(PathBuf),
    /// The dialog was closed.
    Cancelled,
    /// This system has no dialog.
    Unavailable,
}

/// Shows a message in a box of the system, and waits until it's closed.
#[cfg(windows)]
pub fn message_box(message: &str) {
    rfd::MessageDialog::new()
        .set_title("Camera Lab")
        .set_level(rfd::MessageLevel::Error)
        .set_description(message)
        .show();
}
