//! Studies of rounding and cost, the diagnosis of cameras and answers, exercises and lessons.
//!
//! [`numerics`] measures the cost of accuracy and diagnoses cameras. [`exercises`] states the exercises of the notes,
//! judges answers and finds the step that went wrong. [`lessons`] reads lessons and checks their tasks.

use camera_lab_engine::{
    appearance, camera, chain, drawing, expression, geometry, limits, listed, numbers, pipeline, progress, raster,
    scene, worded,
};
use camera_lab_figures::{chart, explain, figure, formula, inspect, picture, views};

pub mod clock;
pub mod exercises;
pub mod numerics;

/// Lessons: figures one after the other, each with a text, a question or something to do. A lesson is a file, and each
/// of its steps is a whole figure.
pub mod lessons {
    mod condition;
    mod edit;
    mod items;
    mod leads;
    mod lesson;
    mod numbers_in_texts;
    mod passage;
    mod place;
    mod read;
    mod record;
    mod shipped;
    mod task_text;

    pub use condition::{Condition, Goal, Range, Seen, Subject, objects_named};
    pub use edit::{Edit, LessonText, StepText, Words, edited, reworded, text_of_step, words_in_file};
    pub use leads::{Way, exercise_minutes, exercises_of, families_of, family_after, in_order_of_lessons, lesson_of};
    pub use lesson::{Lesson, Link, OpenLesson, Question, See, Step, Task};
    pub use numbers_in_texts::{filled, numbers_of, with_sentence};
    pub use passage::Passage;
    pub use place::{Part, place};
    pub use read::{parse, parse_bytes};
    pub use record::{Draft, with_step};
    pub use shipped::{ShippedLesson, shipped};
    pub use task_text::{ChoiceText, ConditionKind, ConditionText, TaskKind, TaskText};
}
