//! Exercises: those of the notes, families with numbers from a seed, and a lecturer's own; answers are judged, and wrong ones explained.
//!
//! What is right is what [`Subject::value`] (the numbers of `inspect`) or a family computes; what a known [`Mistake`] gives comes from the same
//! place with a [`Slip`] built in. An answer that is neither right nor explained is told which of its numbers are wrong.

mod answer;
mod exercise;
pub mod families;
mod given;
mod judge;
mod mistake;
pub mod notes;
mod progress;
mod subject;
mod textbook;
mod value;
mod worked;

pub use answer::{Answer, AnswerError, read_answer, uses_names};
pub use exercise::{Ask, Compute, Conditions, Exercise, Expected, Fact, Kind, Reading, TOLERANCE, Unit};
pub use judge::{Diagnosis, Judged, judge, judge_answer};
pub use mistake::{Mistake, Slip, Slips};
pub use progress::{Made, Next, Progress, ProgressError, Stage, Tried, Why};
pub use subject::Subject;
pub use value::Table;
pub use worked::Worked;

/// An exercise, or a family of them.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its identifier.
    pub id: &'static str,
    /// Where the notes have it, or what it practises: `[0] 5.1`.
    pub source: &'static str,
    /// Its numbers come from a seed.
    pub is_family: bool,
    /// Makes it from a seed, with numbers that the notes leave open.
    make: fn(u64, &Free) -> Exercise,
}

/// Numbers that the notes leave open, where an answer chooses them: F, B, D, M.
pub type Free = std::collections::BTreeMap<String, f64>;

impl Entry {
    /// The exercise with the numbers of a seed; `free` chooses those that the notes leave open.
    #[must_use]
    pub fn exercise(&self, seed: u64, free: &Free) -> Exercise {
        Exercise { id: self.id.to_owned(), seed, ..(self.make)(seed, free) }
    }
}

/// Judges a text as an answer. A formula in a number that the notes leave open has to be right for other numbers too.
///
/// # Errors
/// [`AnswerError`]: the text cannot be read as an answer; then nothing is judged.
pub fn check(entry: &Entry, exercise: &Exercise, ask: &Ask, text: &str) -> Result<Judged, AnswerError> {
    let judged = judge(exercise, ask, text)?;
    if !judged.right || !uses_names(text, ask, &exercise.free) {
        return Ok(judged);
    }
    for factor in [1.375, 0.625] {
        let free = exercise.free.iter().map(|(name, value)| ((*name).to_owned(), value * factor)).collect();
        let other = entry.exercise(exercise.seed, &free);
        if let Some(ask) = other.asks.iter().find(|other| other.name == ask.name) {
            let elsewhere = judge(&other, ask, text)?;
            if !elsewhere.right {
                return Ok(elsewhere);
            }
        }
    }
    Ok(judged)
}

/// All of them: the notes' own first.
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    notes::ENTRIES.iter().chain(families::ENTRIES)
}

/// The exercise or family with an identifier.
#[must_use]
pub fn entry(id: &str) -> Option<&'static Entry> {
    entries().find(|entry| entry.id == id)
}
