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
const TEXTS: [&str; 20] = lessons![
    "01-camera",
    "02-basis",
    "03-window",
    "04-object",
    "05-view",
    "06-triangles",
    "07-cube",
    "08-depth",
    "09-parallel",
    "10-w",
    "11-clip",
    "12-pixel",
    "13-buffer",
    "14-moves",
    "15-hidden",
    "16-light",
    "17-limits",
    "18-eyes",
    "19-photograph",
    "20-sheet"
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
