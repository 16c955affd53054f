//! The mode *Labels*, in which labels can be moved, renamed and hidden.

pub(super) mod label_drag;
pub(super) mod labels_card;
