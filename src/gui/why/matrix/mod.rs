//! The explanations of matrices: entries, conventions, other vocabularies, code.

pub(super) mod code;
pub(super) mod conventions;
pub(super) mod dialects;
pub(super) mod digits;
pub(super) mod entries;
pub(super) mod matrices;
pub(super) mod pasted_matrix;
