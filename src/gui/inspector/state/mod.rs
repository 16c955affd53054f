//! The state of the panels between frames.

pub(in crate::gui) mod compare;
