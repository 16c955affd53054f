//! The known mistakes, the questions in which they can occur, and the diagnosis of wrong answers.

pub(super) mod diagnose;
pub(super) mod mistake;
pub(super) mod nature;
pub(super) mod slip;
