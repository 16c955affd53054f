//! Exercises and lessons, with what they remember.

pub mod exercises;
pub(super) mod lesson;
