//! The system's file dialogs, on a thread of their own, because they block.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;

use super::{FileAnswer, FileQuestion, Wanted};
use crate::gui::kit::frames;
use camera_lab_desk::{Done, Worker};

/// A user can't read and close a dialog this fast, so there was none.
const IMPOSSIBLE: Duration = Duration::from_millis(100);

/// The choice in a dialog, once it has been closed.
type Chosen = std::pin::Pin<Box<dyn Future<Output = Option<rfd::FileHandle>> + Send>>;

/// An open dialog. Each has a thread of its own, so that one that never answers doesn't keep the next from opening.
#[derive(Debug)]
pub(in crate::gui) struct OpenFileDialog {
    worker: Worker<Chosen, Option<PathBuf>>,
}

impl OpenFileDialog {
    /// Opens the dialog in front of the window of `frame`. Wakes `ctx` when it's closed.
    pub(in crate::gui) fn start(ctx: &egui::Context, question: FileQuestion, frame: &eframe::Frame) -> Self {
        let dialog = rfd::AsyncFileDialog::new().set_title(question.title).set_file_name(question.name);
        let mut dialog = dialog.set_parent(frame);
        for (name, endings) in question.filters {
            dialog = dialog.add_filter(name, endings);
        }
        if let Some(folder) = question.folder {
            dialog = dialog.set_directory(folder);
        }
        // The future is created here, because some systems insist on the main thread for that.
        let chosen: Chosen = match question.wanted {
            Wanted::File => Box::pin(dialog.pick_file()),
            Wanted::NewFile => Box::pin(dialog.save_file()),
            Wanted::Folder => Box::pin(dialog.pick_folder()),
        };
        let mut worker = Worker::new("dialog", crate::clock::now, || {
            async |chosen: Chosen, _: &crate::progress::Progress| {
                pollster::block_on(chosen).map(|file| file.path().to_owned())
            }
        });
        worker.ask(&frames(ctx), 0, chosen);
        Self { worker }
    }

    /// The answer, once there is one.
    pub(in crate::gui) fn poll(&mut self) -> Option<FileAnswer> {
        let [done] = self.worker.take(Duration::ZERO);
        Some(match done? {
            Done { outcome: Some(Some(path)), .. } => FileAnswer::Chosen(path),
            Done { outcome: Some(None), time } if time >= IMPOSSIBLE && has_dialogs() => FileAnswer::Cancelled,
            Done { .. } => FileAnswer::Unavailable,
        })
    }
}

/// True if the system has file dialogs. rfd gives the same answer for a closed dialog and for one that never existed.
/// It asks the desktop's portal, then zenity, and reports their lack only in a log.
fn has_dialogs() -> bool {
    let is_unix_desktop = cfg!(all(unix, not(target_os = "macos")));
    !is_unix_desktop || has_program("zenity", std::env::var_os("PATH")) || has_portal()
}

/// True if a folder of this `PATH` has the program.
fn has_program(name: &str, path: Option<impl AsRef<OsStr>>) -> bool {
    path.is_some_and(|path| std::env::split_paths(&path).any(|folder| folder.join(name).is_file()))
}

/// True if the bus of the session knows the portal, judged by the folders for services.
fn has_portal() -> bool {
    const SERVICE: &str = "dbus-1/services/org.freedesktop.portal.Desktop.service";
    const USUAL: &str = "/usr/local/share:/usr/share";
    let folders = std::env::var_os("XDG_DATA_DIRS").filter(|folders| !folders.is_empty());
    let folders = folders.unwrap_or_else(|| USUAL.into());
    std::env::split_paths(&folders).any(|folder| Path::new(&folder).join(SERVICE).is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_looked_for_in_the_folders_of_the_path() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let path = std::env::join_paths([Path::new("/no/such/folder"), folder]).unwrap_or_default();
        assert!(has_program("Cargo.toml", Some(&path)));
        assert!(!has_program("zenity", Some(&path)));
        assert!(!has_program("zenity", None::<&OsStr>));
    }
}
