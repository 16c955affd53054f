//! The known mistakes: which there are, in what they can be made, and which one explains a wrong answer.

pub(super) mod diagnose;
pub(super) mod mistake;
pub(super) mod nature;
pub(super) mod slip;
