//! Exercises and lessons.

pub(super) mod exercise_cameras;
pub mod exercise_messages;
pub mod exercise_sheet;
pub(super) mod exercise_texts;
pub mod exercise_window;
pub mod exercises;
pub mod handouts;
pub mod lesson_tasks;
pub mod lessons;
