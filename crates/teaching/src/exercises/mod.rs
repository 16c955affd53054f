//! Exercises from the notes, families with numbers from a seed, and a lecturer's own, with the judging of answers and
//! explanations of wrong ones.
//!
//! The right answer is the value of [`Subject::value`] (the numbers of `inspect`) or of a family. The result of a known
//! [`Mistake`] comes from the same place with a [`Slip`] built in. For an answer that's neither right nor explained,
//! the report names the wrong numbers.

mod acceptance;
mod answer;
mod beside;
mod exercise;
pub mod families;
mod fault;
mod follows;
mod judge;
pub mod notes;
mod operated;
pub mod own;
mod own_numbers;
mod own_texts;
pub(crate) mod place;
mod placing;
mod products;
mod progress;
mod statement_facts;
mod subject;
mod textbook;
mod value;
mod worked;

/// The known mistakes, the questions in which they can occur, and the diagnosis of wrong answers.
mod mistakes {
    pub(super) mod diagnose;
    pub(super) mod mistake;
    pub(super) mod nature;
    pub(super) mod slip;
}

use std::borrow::Cow;
use std::sync::{Arc, LazyLock, OnceLock};

pub use answer::{Answer, AnswerError, read_answer, uses_names};
pub use beside::Beside;
pub use exercise::{Ask, Compute, Conditions, Exercise, Expected, Fact, Fault, Kind, Reading, TOLERANCE, Unit};
pub use follows::Holds;
pub use judge::{Judged, judge_answer};
pub use mistakes::diagnose::Diagnosis;
pub use mistakes::mistake::Mistake;
pub use mistakes::nature::Nature;
pub use mistakes::slip::{Cause, Slip, Slips};
pub use own_numbers::OwnNumbers;
pub use own_texts::{ExpectedAnswer, OwnMistake, OwnTexts};
pub use progress::class;
pub use progress::{Guess, MANY_WRONG, Made, Next, Progress, ProgressError, Stage, Tried, Why};
pub use subject::{Subject, place_of};
pub use value::Table;
pub use worked::Worked;

use crate::numbers::random::Random;

/// An exercise, or a family of them.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Unique among all exercises, such as `view-matrix`.
    pub id: Cow<'static, str>,
    /// Its place in the notes, or the topic it practises, such as `[0] 5.1`; empty for a lecturer's own.
    pub source: &'static str,
    /// The minutes that a student needs for it, about. A lecturer's own doesn't say.
    pub minutes: Option<u16>,
    /// Its numbers come from a seed.
    pub is_family: bool,
    make: Make,
}

/// The way to make the exercise of an entry.
#[derive(Clone, Debug)]
enum Make {
    /// From a seed, with numbers that the notes leave open.
    Shipped(fn(u64, &Free) -> Exercise),
    /// From the numbers of a family for a seed.
    Family(fn(&mut Random) -> Exercise),
    /// Read from a file.
    Own(Arc<Exercise>),
    /// The mistake in a solution of another one.
    Fault(&'static Entry),
}

/// The end of an identifier for the exercise that asks for the mistake in a solution: `basis/fault`.
pub const FAULT: &str = "/fault";

/// Those exercises, and whether a mistake can be shown, once it's known.
static FAULTS: LazyLock<Vec<(Entry, OnceLock<bool>)>> =
    LazyLock::new(|| entries().map(|of| (of.fault(), OnceLock::new())).collect());

/// The name of the second place of a question for a mark.
pub const SECOND: &str = "second";

/// Numbers that the notes leave open and an answer chooses: F, B, D, M.
pub type Free = std::collections::BTreeMap<String, f64>;

impl Entry {
    const fn of_notes(id: &'static str, source: &'static str, minutes: u16, make: fn(u64, &Free) -> Exercise) -> Self {
        Self { id: Cow::Borrowed(id), source, minutes: Some(minutes), is_family: false, make: Make::Shipped(make) }
    }

    const fn family(id: &'static str, source: &'static str, minutes: u16, make: fn(&mut Random) -> Exercise) -> Self {
        Self { id: Cow::Borrowed(id), source, minutes: Some(minutes), is_family: true, make: Make::Family(make) }
    }

    fn fault(&'static self) -> Self {
        let (id, make) = (Cow::Owned(format!("{}{FAULT}", self.id)), Make::Fault(self));
        Self { id, source: self.source, is_family: true, minutes: self.minutes, make }
    }

    /// Its texts, if it's a lecturer's own exercise.
    pub fn texts(&self) -> Option<&OwnTexts> {
        match &self.make {
            Make::Shipped(_) | Make::Family(_) | Make::Fault(_) => None,
            Make::Own(exercise) => exercise.texts.as_deref(),
        }
    }

    /// The exercise with the numbers of a seed. `free` chooses those that the notes leave open.
    pub fn exercise(&self, seed: u64, free: &Free) -> Exercise {
        let exercise = match &self.make {
            Make::Shipped(make) => make(seed, free),
            Make::Family(make) => families::without_coincidences(&self.id, seed, *make),
            Make::Own(exercise) => Exercise::clone(exercise),
            Make::Fault(of) => fault::of_exercise(of.exercise(seed, free)),
        };
        Exercise { id: self.id.clone().into_owned(), seed, chosen: free.clone(), ..exercise }
    }
}

/// Judges a text as an answer by itself.
///
/// # Errors
/// As for [`check_beside`].
pub fn check(entry: &Entry, exercise: &Exercise, ask: &Ask, text: &str) -> Result<Judged, AnswerError> {
    check_beside(entry, exercise, ask, text, &[])
}

/// Judges a text as an answer, beside the answers to other questions of the exercise, by their names. Numbers that the
/// notes leave open are those of the answers, unless the exercise was made with others. A formula in such a number has
/// to be right for other numbers too.
///
/// # Errors
/// [`AnswerError`] if the text can't be read as an answer. Then nothing is judged.
pub fn check_beside(
    entry: &Entry,
    exercise: &Exercise,
    ask: &Ask,
    text: &str,
    answers: &[(String, Answer)],
) -> Result<Judged, AnswerError> {
    if exercise.holds.is_empty() {
        return check_for_numbers(entry, exercise, ask, text, answers);
    }
    let answer = (ask.name.clone(), read_answer(text, ask, &exercise.free)?);
    let others = answers.iter().filter(|(name, _)| *name != ask.name).cloned();
    let all: Vec<(String, Answer)> = others.chain([answer.clone()]).collect();
    let Some((decided, own)) = own_numbers::decided(entry, exercise, &all) else {
        return check_for_numbers(entry, exercise, ask, text, &all);
    };
    let own_ask = own.asks.iter().find(|other| other.name == ask.name).unwrap_or(ask);
    let judged = check_for_numbers(entry, &own, own_ask, text, &all)?;
    let is_of_statement = decided.values.iter().all(|value| exercise.free.contains(value));
    let is_explained = judged.right || decided.ask == ask.name || own_numbers::is_known(own_ask, &judged.understood);
    let instead = if is_explained { None } else { own_numbers::instead(entry, exercise, &answer) };
    Ok(match instead {
        Some(_) => {
            Judged { diagnosis: None, carried: Vec::new(), numbers: Some(OwnNumbers { instead, ..decided }), ..judged }
        }
        None => Judged { numbers: Some(decided).filter(|_| !is_of_statement), ..judged },
    })
}

/// Judges an answer for the numbers of an exercise.
fn check_for_numbers(
    entry: &Entry,
    exercise: &Exercise,
    ask: &Ask,
    text: &str,
    answers: &[(String, Answer)],
) -> Result<Judged, AnswerError> {
    let judge = |exercise: &Exercise, ask: &Ask, answers| {
        let answer = read_answer(text, ask, &exercise.free)?;
        Ok(judge::judge_beside(ask, answer, Beside { exercise, answers }))
    };
    let judged: Judged = judge(exercise, ask, answers)?;
    if !judged.right || !uses_names(text, ask, &exercise.free) {
        return Ok(judged);
    }
    for factor in [1.375, 0.625] {
        let free = exercise.free.iter().map(|(name, value)| ((*name).to_owned(), value * factor)).collect();
        let other = entry.exercise(exercise.seed, &free);
        if let Some(ask) = other.asks.iter().find(|other| other.name == ask.name) {
            let elsewhere = judge(&other, ask, &[])?;
            if !elsewhere.right {
                return Ok(elsewhere);
            }
        }
    }
    Ok(judged)
}

/// All entries, the notes' own first.
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    notes::ENTRIES.iter().chain(families::ENTRIES)
}

/// All entries, and after them those of a folder.
pub fn with_own(own: &[Entry]) -> impl Iterator<Item = &Entry> {
    notes::ENTRIES.iter().chain(families::ENTRIES).chain(own)
}

/// The exercise or family with an identifier, or the one about a mistake in a solution of it, which `entries` leaves
/// out.
pub fn entry(id: &str) -> Option<&'static Entry> {
    let Some(of) = id.strip_suffix(FAULT) else { return entries().find(|entry| entry.id == id) };
    let (entry, can_be) = FAULTS.iter().find(|(entry, _)| entry.id == id)?;
    let is_possible = || self::entry(of).is_some_and(|of| fault::is_possible(&of.exercise(0, &Free::new())));
    can_be.get_or_init(is_possible).then_some(entry)
}
