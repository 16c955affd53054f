//! The stored session of a window: its figure with the changes, and its file.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::figure::{Figure, read, update};
use crate::files::{SourceFile, disk};
use crate::gui::document::Document;
use crate::gui::fresh;

/// A path that comes back as it was: as a text where it is one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
enum KeptPath {
    Text(String),
    // A browser knows no other names than texts.
    #[cfg(not(target_arch = "wasm32"))]
    Other(std::ffi::OsString),
}

impl From<&Path> for KeptPath {
    fn from(path: &Path) -> Self {
        match path.to_str() {
            #[cfg(not(target_arch = "wasm32"))]
            None => Self::Other(path.as_os_str().to_owned()),
            text => Self::Text(text.unwrap_or_default().to_owned()),
        }
    }
}

impl KeptPath {
    /// The path; a relative one says nothing: nobody knows of which folder.
    fn whole(&self) -> Option<PathBuf> {
        let path = match self {
            Self::Text(text) => PathBuf::from(text),
            #[cfg(not(target_arch = "wasm32"))]
            Self::Other(text) => PathBuf::from(text),
        };
        Some(path).filter(|path| disk::is_whole(path))
    }
}

/// The stored session. Unknown keys, from a later version, are ignored.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct SessionFile {
    /// The figure's file, if it has one.
    path: Option<KeptPath>,
    /// Of a figure without a file of its own: the folder of the picture that it came from.
    folder: Option<KeptPath>,
    /// The text that was read or saved last.
    source: String,
    /// The figure with its changes.
    figure: String,
    /// The figure is being restored, and the window has not lived long with it yet.
    #[serde(default)]
    pub(super) restoring: bool,
}

/// The key of [`SessionFile::restoring`].
const RESTORING: &str = "restoring";

/// A window that has come back.
pub(super) struct Restored {
    pub(super) document: Document,
    /// Keys of the figure that are not known here, and were passed over.
    pub(super) unknown: Vec<String>,
}

impl SessionFile {
    pub(super) fn new(place: &SessionPlace, source: String, figure: &Figure, restoring: bool) -> Self {
        let figure = update(&source, figure);
        let kept = |path: &Option<PathBuf>| path.as_deref().map(KeptPath::from);
        Self { path: kept(&place.path), folder: kept(&place.folder), source, figure, restoring }
    }

    /// Reads these bytes; `None` where they are unreadable.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        serde_json::from_slice(bytes).ok()
    }

    /// The same bytes, with the record that the figure is being restored. Unknown keys stay.
    pub(super) fn noted(bytes: &[u8]) -> Option<Vec<u8>> {
        let mut kept: serde_json::Value = serde_json::from_slice(bytes).ok()?;
        kept.as_object_mut()?.insert(RESTORING.to_owned(), true.into());
        serde_json::to_vec(&kept).ok()
    }

    /// The figure's file, if it has one.
    pub(super) fn path(&self) -> Option<PathBuf> {
        self.path.as_ref()?.whole()
    }

    /// The window as it was. Where the figure has keys that are not known here, saving asks for another file: the old
    /// one may have been written by a later version too.
    pub(super) fn restore(&self) -> Option<Restored> {
        let (changed, unknown) = read::parse_known(&self.figure).ok()?;
        let (path, folder) = (self.path(), self.folder.as_ref().and_then(KeptPath::whole));
        // Without a text, the window had begun with its own first figure, not with that of an empty file.
        let saved = match &self.source {
            source if source.is_empty() && path.is_none() => fresh(),
            source => read::parse_known(source).map_or_else(|_| fresh(), |(saved, _)| saved),
        };
        let text = self.source.clone();
        let file = match (path, folder) {
            (Some(path), _) => Some(SourceFile { path, text, is_picture: false }),
            // Only the folder of the picture counts: nothing is written there.
            (None, Some(folder)) => Some(SourceFile { path: folder.join("picture.png"), text, is_picture: true }),
            (None, None) if text.is_empty() => None,
            // An empty path has no folder either.
            (None, None) => Some(SourceFile { path: PathBuf::new(), text, is_picture: false }),
        };
        let mut document = Document::new(saved, file).ok()?;
        if !unknown.is_empty() || self.path().is_none() {
            document.forget_file();
        }
        document.replace(changed).ok()?;
        Some(Restored { document, unknown })
    }
}

/// The source of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SessionPlace {
    pub(super) path: Option<PathBuf>,
    pub(super) folder: Option<PathBuf>,
}

impl SessionPlace {
    pub(super) fn of(document: &Document) -> Self {
        let path = document.path().cloned();
        let folder = document.folder().filter(|_| path.is_none()).map(Path::to_owned);
        Self { path, folder }
    }
}
