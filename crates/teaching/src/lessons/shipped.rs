//! The lessons built into the program. They're always there, even if it isn't installed.

use std::sync::{Arc, LazyLock};

use super::lesson::Lesson;
use super::read::parse;

/// A lesson built into the program.
#[derive(Clone, Debug)]
pub struct ShippedLesson {
    /// Parsed and checked.
    pub lesson: Arc<Lesson>,
    /// The content of its TOML file.
    pub text: &'static str,
}

macro_rules! lessons {
    ($($name:literal),* $(,)?) => {
        [$(include_str!(concat!("../../../../assets/lessons/", $name, ".toml")),)*]
    };
}

/// Their files, in the order of the course.
const TEXTS: [&str; 18] = lessons![
    "01-camera",
    "02-basis",
    "03-window",
    "04-view",
    "05-triangles",
    "06-cube",
    "07-depth",
    "08-parallel",
    "09-w",
    "10-clip",
    "11-pixel",
    "12-moves",
    "13-hidden",
    "14-light",
    "15-limits",
    "16-eyes",
    "17-photograph",
    "18-sheet"
];

/// All of them, in the order of the course.
pub fn shipped() -> &'static [ShippedLesson] {
    // Read on the first request. A test reads every one.
    static LESSONS: LazyLock<Vec<ShippedLesson>> = LazyLock::new(|| {
        let lesson = |text: &'static str| Some(ShippedLesson { lesson: Arc::new(parse(text).ok()?), text });
        TEXTS.into_iter().filter_map(lesson).collect()
    });
    &LESSONS
}
