//! A lesson and its steps as values.

use std::path::PathBuf;
use std::sync::Arc;

use super::condition::Goal;
use crate::exercises::Entry;
use crate::figure::{Figure, Localized};

/// A lesson.
#[derive(Clone, Debug, Default)]
pub struct Lesson {
    /// Its identifier: a name that's valid in a command line.
    pub id: String,
    /// One line in each language.
    pub title: Localized,
    /// The sentence to keep, in Markdown.
    pub sentence: Option<Localized>,
    /// Duration in minutes.
    pub minutes: Option<f64>,
    /// The learning goals, in Markdown.
    pub aims: Vec<Localized>,
    /// The plan of a class of 50 minutes for its lecturer, in Markdown.
    pub plan: Option<Localized>,
    /// The questions before the lesson.
    pub pretest: Vec<Question>,
    /// The questions after it, with other numbers.
    pub posttest: Vec<Question>,
    /// The identifiers of the lessons that come before it.
    pub before: Vec<String>,
    /// Its steps: at least one.
    pub steps: Vec<Step>,
}

/// An exercise of the program with its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// Unique among all lessons, such as `camera`.
    pub id: String,
    /// The source of its numbers.
    pub seed: u64,
}

/// A lesson that's played from a step on.
#[derive(Clone, Debug)]
pub struct OpenLesson {
    /// Parsed and checked.
    pub lesson: Arc<Lesson>,
    /// Its file, in whose folder its steps look for meshes; `None` means one of the program.
    pub path: Option<PathBuf>,
    /// The step, from 0.
    pub step: usize,
}

impl Eq for OpenLesson {}

impl PartialEq for OpenLesson {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.lesson, &other.lesson) && (&self.path, self.step) == (&other.path, other.step)
    }
}

/// A step of a lesson.
#[derive(Clone, Debug)]
pub struct Step {
    /// One line in each language.
    pub title: Localized,
    /// Its text in Markdown, with `{quantity}` for the numbers of its figure, and `{sentence}` for that of its lesson.
    pub text: Localized,
    /// The sentence to keep of its lesson, in Markdown.
    pub sentence: Option<Localized>,
    /// The speaker's notes, in Markdown.
    pub notes: Option<Localized>,
    /// The whole figure.
    pub figure: Arc<Figure>,
    /// Seconds of the move from the step before; 0 means at once.
    pub seconds: f64,
    /// Its task, to be done before the next step.
    pub task: Option<Task>,
    /// The figure that shows the answer to its question, once it's guessed.
    pub see: See,
    /// Where to read or practise further.
    pub links: Vec<Link>,
}

/// The figure that shows the answer to a question.
#[derive(Clone, Debug, Default)]
pub enum See {
    /// None. The reason comes at once.
    #[default]
    Nothing,
    /// The figure of the next step.
    Next,
    /// The figure of the step, changed.
    Changed(Arc<Figure>),
}

impl Lesson {
    /// The figure that shows the answer to the question of a step, once it's guessed.
    pub fn seen_after(&self, step: usize) -> Option<&Arc<Figure>> {
        match &self.steps.get(step)?.see {
            See::Nothing => None,
            See::Next => self.steps.get(step + 1).map(|next| &next.figure),
            See::Changed(figure) => Some(figure),
        }
    }
}

/// Something to do in a step.
#[derive(Clone, Debug)]
pub enum Task {
    /// An exercise of the program.
    Exercise {
        /// Its identifier.
        id: String,
        /// The source of its numbers.
        seed: u64,
    },
    /// A question of the lesson's own: an exercise with one question.
    Question(Arc<Entry>),
    /// Something to reach with the controls.
    Try(Goal),
}

/// A way on from a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Link {
    /// A note, by its name.
    Note(String),
    /// An exercise with its seed.
    Exercise(String, u64),
    /// A step of another lesson, by its identifier. Steps count from 0.
    Lesson(String, usize),
}
