//! A question for a place in the image.

use crate::exercises::Ask;

/// A question for a place in the image. Places are pixels from its left edge and from its upper one.
#[derive(Clone, Debug)]
pub struct Placing {
    /// The question.
    pub of: Mark,
    /// The present place of the followed point.
    pub from: Option<[f64; 2]>,
    /// The chosen place.
    pub mark: Option<[f64; 2]>,
    /// The guess that can't be changed any more.
    pub guess: Option<[f64; 2]>,
    /// The right place, once it may be seen.
    pub right: Option<[f64; 2]>,
    /// The mark may be put elsewhere.
    pub is_open: bool,
    /// The words in the empty picture.
    pub hint: &'static str,
}

/// The owner of a mark in the image.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A question of an exercise or a lesson.
    Ask(Box<Ask>),
    /// An operation that asks where a point will go.
    Operation,
}
