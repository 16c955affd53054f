//! The source of a figure.

use std::path::PathBuf;

use crate::gui::model::document::Document;

/// The source of a figure.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// Built into the program.
    Shipped(&'static str),
    /// A file.
    File(PathBuf),
}

impl Source {
    /// The source of a document. `None` for a new one.
    pub(in crate::gui) fn of(document: &Document) -> Option<Self> {
        match (document.path(), document.shipped_name()) {
            (Some(path), _) => Some(Self::File(path.clone())),
            (None, name) => name.map(Self::Shipped),
        }
    }
}
