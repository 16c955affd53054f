//! Exercises and lessons, with what they remember.

pub(super) mod exercises;
pub(super) mod lesson;
