//! What there can be too much of, so that a drawing is not what was asked for.

use crate::foreign::shown;
use crate::limits::{MAX_PIECES, MAX_STROKE_STEPS};

/// What there is too much of.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TooMuch {
    /// Faces that cross one another make too many pieces: nothing was put in order, and a depth buffer has to decide.
    #[error(
        "the faces of {} cross too often to be split (more than {MAX_PIECES} pieces), and the depth buffer decides; allowed: fewer faces, or visibility = \"depth-buffer\"",
        names(objects, "and others")
    )]
    Pieces {
        /// The objects whose faces they are, the one with most of them first.
        objects: Vec<String>,
    },
    /// Strokes meet too many faces or one another too often: what is seen of them, and in which order, was not found.
    #[error(
        "strokes meet too many faces or one another too often to be drawn without a depth buffer (more than {MAX_STROKE_STEPS} steps); allowed: fewer edges and lines"
    )]
    Strokes,
}

impl TooMuch {
    /// `shares`: how many pieces each object has, by its name.
    pub(super) fn pieces<'a>(shares: impl Iterator<Item = (&'a str, usize)>) -> Self {
        let mut shares: Vec<(&str, usize)> = shares.collect();
        shares.sort_by_key(|(_, share)| std::cmp::Reverse(*share));
        Self::Pieces { objects: shares.into_iter().map(|(name, _)| name.to_owned()).collect() }
    }

    /// Names no others than those that `is_known`: a picture has objects of its own besides the scene's.
    pub fn name_only(&mut self, is_known: impl Fn(&str) -> bool) {
        match self {
            Self::Pieces { objects } => objects.retain(|name| is_known(name)),
            Self::Strokes => {}
        }
    }
}

/// More objects than these are not named.
const MOST_NAMES: usize = 3;

/// The names of a few objects, in quotes; `rest` stands for the others.
#[must_use]
pub fn names(objects: &[String], rest: &str) -> String {
    let mut named: Vec<String> = objects.iter().take(MOST_NAMES).map(|name| format!("{:?}", shown(name))).collect();
    if objects.len() > MOST_NAMES {
        named.push(rest.to_owned());
    }
    named.join(", ")
}
