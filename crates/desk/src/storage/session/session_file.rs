//! The stored session of a window: its figure with the changes, and its file.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::document::{Document, fresh};
use crate::figure::{Figure, Localized, read, update};
use crate::lessons::{TaskKind, TaskText, text_of_step};
use crate::storage::session::UnsavedText;
use camera_lab_files::{Carried, SourceFile, disk};

/// A path that comes back unchanged, as text if it's text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
enum KeptPath {
    Text(String),
    // A browser knows only names that are text.
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
    /// The path. A relative one has no meaning, because its folder is unknown.
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
    /// For a figure without a file of its own, the folder of the picture that it came from.
    folder: Option<KeptPath>,
    /// The text that was read or saved last.
    source: String,
    /// The figure with its changes.
    figure: String,
    /// True while the figure is being restored, and the window hasn't lived long with it yet.
    #[serde(default)]
    pub(super) restoring: bool,
    /// The text of a lesson that isn't in its file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lesson: Option<KeptText>,
}

/// The text of a lesson that isn't in its file. See [`UnsavedText`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct KeptText {
    path: KeptPath,
    step: usize,
    text: String,
    /// Each in English and in Portuguese.
    /// In English and in Portuguese, then tag and text of each other language.
    typed: Vec<Vec<String>>,
    /// The task in the form of a lesson file. `None` from an earlier version, which couldn't change it.
    #[serde(default)]
    task: Option<String>,
}

/// The key of [`SessionFile::restoring`].
const RESTORING: &str = "restoring";

/// A restored window.
pub struct Restored {
    /// The document.
    pub document: Document,
    /// Keys of the figure that are unknown here, and were skipped.
    pub unknown: Vec<String>,
    /// The text of a lesson that wasn't in its file.
    pub text: Option<UnsavedText>,
}

impl SessionFile {
    /// The session of a figure from `place`: its file, or the folder of the picture that it came from. `carried` are
    /// the files in that picture.
    pub(super) fn new(
        place: &[Option<PathBuf>; 2],
        (source, carried): (&str, &Carried),
        figure: &Figure,
        restoring: bool,
    ) -> Self {
        let (source, figure) = (carried.join(source), update(source, figure));
        let [path, folder] = place.each_ref().map(|path| path.as_deref().map(KeptPath::from));
        Self { path, folder, source, figure, restoring, lesson: None }
    }

    /// The same with the text of a lesson.
    pub(super) fn with_text(self, text: Option<&UnsavedText>) -> Self {
        let lesson = text.map(|UnsavedText { path, step, text, words, task }| KeptText {
            path: KeptPath::from(&**path),
            step: *step,
            text: text.clone(),
            typed: words.iter().map(typed).collect(),
            task: (task.kind != TaskKind::InFile).then(|| task.to_toml()),
        });
        Self { lesson, ..self }
    }

    /// The text of a lesson. `None` if it lacks a part of an [`UnsavedText`].
    fn text(&self) -> Option<UnsavedText> {
        let KeptText { path, step, text, typed, task } = self.lesson.as_ref()?;
        let words: Vec<Localized> = typed.iter().map(|texts| of_typed(texts)).collect::<Option<_>>()?;
        let task = task.as_deref().or_else(|| text_of_step(text, *step)).map(TaskText::of_step).unwrap_or_default();
        let (path, text, words) = (path.whole()?, text.clone(), words.try_into().ok()?);
        Some(UnsavedText { path, step: *step, text, words, task })
    }

    /// Reads these bytes. `None` if they are unreadable.
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

    /// The file named in a list: that of the figure, or of the lesson with the text.
    pub(super) fn named(&self) -> Option<PathBuf> {
        let of_lesson = || self.lesson.as_ref()?.path.whole();
        self.path().or_else(of_lesson)
    }

    /// The former window. If the figure has keys that are unknown here, saving asks for another file, because a later
    /// version may have written the old one too.
    pub(super) fn restore(&self) -> Option<Restored> {
        let (changed, unknown) = read::parse_known(&self.figure).ok()?;
        let (path, folder) = (self.path(), self.folder.as_ref().and_then(KeptPath::whole));
        let (source, carried) = if path.is_none() {
            let (text, carried) = Carried::from_text(self.source.clone().into());
            (String::from_utf8(text).ok()?, carried)
        } else {
            (self.source.clone(), Carried::default())
        };
        // Without a text, the window had begun with its own first figure, not with that of an empty file.
        let saved = match &source {
            source if source.is_empty() && path.is_none() => fresh(),
            source => read::parse_known(source).map_or_else(|_| fresh(), |(saved, _)| saved),
        };
        let text = source;
        let file = match (path, folder) {
            (Some(path), _) => Some(SourceFile { path, text, is_picture: false, carried }),
            // Only the folder of the picture counts, because nothing is written there.
            (None, Some(folder)) => {
                Some(SourceFile { path: folder.join("picture.png"), text, is_picture: true, carried })
            }
            (None, None) if text.is_empty() => None,
            // An empty path has no folder either.
            (None, None) => Some(SourceFile { path: PathBuf::new(), text, is_picture: false, carried }),
        };
        let mut document = Document::new(saved, file).ok()?;
        if !unknown.is_empty() || self.path().is_none() {
            document.forget_file();
        }
        document.replace(changed).ok()?;
        // A text that can't be shown must not be thrown away with the file.
        let text = self.text();
        if self.lesson.is_some() && text.as_ref().is_none_or(|text| crate::lessons::parse(&text.text).is_err()) {
            return None;
        }
        Some(Restored { document, unknown, text })
    }
}

fn typed(Localized { en, pt_br, others }: &Localized) -> Vec<String> {
    [en, pt_br].into_iter().chain(others.iter().flat_map(|(tag, text)| [tag, text])).cloned().collect()
}

/// The text that [`typed`] has stored.
fn of_typed(texts: &[String]) -> Option<Localized> {
    let [en, pt_br, others @ ..] = texts else { return None };
    let others = others.chunks_exact(2).map(|pair| (pair[0].clone(), pair[1].clone()));
    Some(Localized { en: en.clone(), pt_br: pt_br.clone(), others: others.collect() })
}
