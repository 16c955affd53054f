//! What is asked about files, and what is going on with them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::Message;
use crate::camera::Decomposition;
use crate::files::Overwrite;
use crate::gui::comparison::Comparison;
use crate::gui::export::{Export, Exported, Exporting};
use crate::gui::native::OpenFileDialog;
use crate::gui::preview::Preview;
use crate::gui::session::NewsList;
use crate::gui::watch::Watch;
use crate::gui::worker::Running;

/// What is to be done once nothing can be lost any more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AfterSave {
    /// The default figure.
    New,
    /// Ask for a file and open it.
    Open,
    /// Open this file.
    OpenPath(PathBuf),
    /// Open the figure of the program with this name.
    Shipped(&'static str),
    /// Go on with what a window left in this slot.
    Restore(usize),
    /// Close the window.
    Quit,
}

/// What a file is asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Purpose {
    /// To open it.
    Open,
    /// To save the figure in it, and then to go on.
    Save(Option<AfterSave>),
    /// To write a picture.
    Export(Export),
    /// To write the way to the canonical volume, by these steps: an animation or a strip, as the name's ending says.
    Animation(Decomposition),
    /// To put a mesh into the scene.
    Mesh(MeshFor),
    /// A folder, whose figures the gallery is to show.
    Folder,
    /// To write what is kept of exercises, as a table for spreadsheets.
    Progress,
    /// A folder of a lecturer's own exercises.
    Exercises,
}

/// What a mesh file is for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeshFor {
    /// A new object.
    New,
    /// This object, by name.
    Object(String),
}

/// The endings of mesh files.
pub const MESH_ENDINGS: &[&str] = &["obj", "gltf", "glb"];

/// What another program has written into the figure's file; `None`: what cannot be read.
pub type Theirs = Option<Vec<u8>>;

/// What the user has agreed to write over.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Agreed {
    /// This, which another program has written into the figure's file.
    pub theirs: Option<Theirs>,
    /// A read-only file.
    pub read_only: bool,
}

impl Agreed {
    /// What saving may replace.
    #[must_use]
    pub fn overwrite(&self) -> Overwrite {
        if self.read_only { Overwrite::ReadOnlyToo } else { Overwrite::Writable }
    }
}

/// The figure's file holds something else than what was read from it or saved in it: what then?
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// What it holds.
    pub theirs: Theirs,
    /// What was to come after saving.
    pub then: Option<AfterSave>,
    /// The lines that differ, once they are wanted.
    pub comparison: Option<Comparison>,
}

/// What is asked in the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    /// There are changes: save them?
    Unsaved(AfterSave),
    /// Which file? The text of the field.
    Path(Purpose, String),
    /// The file is there already: replace it?
    Overwrite(Purpose, PathBuf),
    /// Another program has changed the figure's file: write over it?
    Changed(Changed),
    /// The file is read-only: replace it all the same?
    ReadOnly(Purpose, PathBuf, Agreed),
    /// What to export.
    Export(Export),
    /// Pictures are still being written: the window closes when they are there.
    Closing,
    /// What the pointer and the keys do.
    Help,
    /// What the program is, and what it is made of.
    About,
    /// Why the picture is empty, and how near the camera is to trouble.
    Coach,
    /// Which figure to begin with.
    Gallery,
    /// What becomes of what hangs on these objects, which are to be deleted?
    Delete {
        /// Their names.
        names: BTreeSet<String>,
        /// How many other objects hang on them.
        below: usize,
    },
    /// Forget what is kept of exercises?
    DeleteProgress,
    /// The figure as a link.
    Link,
}

/// What is going on with files.
#[derive(Debug, Default)]
pub struct FileFlow {
    /// What is asked in the window now.
    pub dialog: Option<Dialog>,
    /// Why the file that was typed last could not be opened or written; said in the dialog.
    pub(in crate::gui) refused: Option<Message>,
    /// False: files are asked for with a field in the window, as where the system has no dialogs.
    pub native: bool,
    /// True from the moment when the window may close.
    pub may_close: bool,
    /// What another program has written into the figure's file, as long as that has to be said.
    pub theirs: Option<Theirs>,
    /// What there is to say about sessions, until the user has closed it.
    pub(in crate::gui) news: NewsList,
    /// What has been said about the file, and is not said again.
    pub(in crate::gui) decided: Option<Theirs>,
    /// What a window left in this slot is wanted now.
    pub(in crate::gui) restore: Option<usize>,
    /// The figure's file is to be looked at in the next frame.
    pub(in crate::gui) look: bool,
    pub(in crate::gui) watch: Watch,
    /// Files that were given to a page, to be opened: the first of them in the next frame.
    pub(in crate::gui) given: Vec<PathBuf>,
    pub(in crate::gui) asking: Option<(Purpose, OpenFileDialog)>,
    pub(in crate::gui) exporting: Vec<Exporting>,
    /// What the export dialog shows while it is open.
    pub preview: Option<Preview>,
}

impl FileFlow {
    /// Nothing is going on.
    #[must_use]
    pub fn new(native: bool) -> Self {
        Self { native, ..Self::default() }
    }

    /// True from the first question that is asked because the window is to close, until one is answered by *Cancel*.
    pub(in crate::gui) fn is_closing(&self) -> bool {
        let closes = |next: &AfterSave| *next == AfterSave::Quit;
        let saves = |purpose: &Purpose| matches!(purpose, Purpose::Save(Some(next)) if closes(next));
        let asked = match &self.dialog {
            Some(Dialog::Closing) => true,
            Some(Dialog::Unsaved(next)) => closes(next),
            Some(Dialog::Path(purpose, _) | Dialog::Overwrite(purpose, _) | Dialog::ReadOnly(purpose, ..)) => {
                saves(purpose)
            }
            Some(Dialog::Changed(changed)) => changed.then.as_ref().is_some_and(closes),
            // Nothing comes after the answer to any other question.
            Some(_) | None => false,
        };
        asked || self.may_close || self.asking.as_ref().is_some_and(|(purpose, _)| saves(purpose))
    }

    /// The pictures that are being written, and how far that has come.
    pub(in crate::gui) fn running(&self) -> impl Iterator<Item = (&Path, Running)> {
        self.exporting.iter().filter_map(|exporting| Some((exporting.path(), exporting.running()?)))
    }

    /// Gives up those of the pictures that are being written of which `which` says so.
    pub(in crate::gui) fn cancel(&self, which: impl Fn(Running) -> bool) {
        self.exporting.iter().filter(|exporting| exporting.running().is_some_and(&which)).for_each(Exporting::cancel);
    }

    /// The exports that have come to an end.
    pub(in crate::gui) fn exported(&mut self) -> Vec<(PathBuf, Exported)> {
        let mut done = Vec::new();
        self.exporting.retain_mut(|exporting| {
            let before = done.len();
            done.extend(exporting.take());
            done.len() == before
        });
        done
    }
}
