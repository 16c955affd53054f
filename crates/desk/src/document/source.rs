//! The source of a figure.

use std::path::{Path, PathBuf};

use crate::document::Document;

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
    pub fn of(document: &Document) -> Option<Self> {
        match (document.path(), document.shipped_name()) {
            (Some(path), _) => Some(Self::File(path.clone())),
            (None, name) => name.map(Self::Shipped),
        }
    }

    /// Its name: that of the built-in figure, or of its file, whose ending tells a PDF of a figure from its text.
    pub fn name(&self) -> std::borrow::Cow<'_, str> {
        match self {
            Self::Shipped(name) => (*name).into(),
            Self::File(path) => path.file_name().unwrap_or_default().to_string_lossy(),
        }
    }

    /// The folder of its file.
    pub fn folder(&self) -> Option<&Path> {
        match self {
            Self::Shipped(_) => None,
            Self::File(path) => path.parent(),
        }
    }
}
