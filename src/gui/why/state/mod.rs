//! The state of the explanations between frames.

pub(in crate::gui) mod conventions;
pub(in crate::gui) mod explain;
pub(in crate::gui) mod follow;
pub(in crate::gui) mod matrices;
pub(in crate::gui) mod notes;
pub(in crate::gui) mod numerics;
pub(in crate::gui) mod order;
pub(in crate::gui) mod steps;
pub(in crate::gui) mod triangle;
