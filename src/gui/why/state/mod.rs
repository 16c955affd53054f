//! The state of the explanations between frames.

pub(in crate::gui) mod explain;
pub(in crate::gui) mod notes;
pub(in crate::gui) mod order;
pub(in crate::gui) mod triangle;
