//! The state of the panels between frames.

pub(in crate::gui) mod cameras;
pub(in crate::gui) mod compare;
pub(in crate::gui) mod insert;
