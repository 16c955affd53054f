//! Numbers that a statement leaves to the student, found in the answers: F and B in M_p, F in the corner of a window.
//!
//! Estimates come from a few entries. Then the whole answer has to be right for them, so a wrong entry isn't taken for
//! another choice.

use super::acceptance::is_right;
use super::answer::Answer;
use super::beside::numbers;
use super::exercise::{Ask, Exercise};
use super::follows::{Holds, Named};
use super::mistakes::diagnose::{digits, is_known_mistake};
use super::{Entry, Free};

/// The greatest share by which an estimate from rounded entries is off.
const MOST_OFF: f64 = 0.005;
/// Denominators of numbers that people choose, the simplest first.
const DENOMINATORS: [f64; 9] = [1.0, 2.0, 3.0, 4.0, 5.0, 8.0, 9.0, 10.0, 100.0];

/// The numbers for which an answer was judged, if the statement leaves them open and an answer decided them.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnNumbers {
    /// Their values.
    pub values: Named,
    /// The name of the question whose answer decided them.
    pub ask: String,
    /// Other values for which the answer is right. Then it's wrong only because of the one that decided.
    pub instead: Option<Named>,
}

/// The numbers that the first answer decides which is right for some numbers: those of the exercise, if it's right for
/// them or a known mistake with them, else its own. With the exercise for them.
pub(super) fn decided(
    entry: &Entry,
    exercise: &Exercise,
    answers: &[(String, Answer)],
) -> Option<(OwnNumbers, Exercise)> {
    exercise.holds.iter().find_map(|holds| {
        let (ask, answer) = answered(exercise, holds, answers)?;
        let decide = |values: Named| OwnNumbers { values, ask: ask.name.clone(), instead: None };
        if is_right(ask, answer) || is_known(ask, answer) {
            return Some((decide(of_statement(exercise, holds)), exercise.clone()));
        }
        let (values, own) = own(entry, exercise, holds, answer)?;
        Some((decide(values), own))
    })
}

/// The other numbers for which an answer is right that's wrong for those decided: those of the statement, or its own.
pub(super) fn instead(entry: &Entry, exercise: &Exercise, (name, answer): &(String, Answer)) -> Option<Named> {
    let ask = exercise.asks.iter().find(|ask| ask.name == *name)?;
    let holds = exercise.holds.iter().find(|holds| holds.ask == name);
    if is_right(ask, answer) {
        return Some(of_statement(exercise, holds.or(exercise.holds.first())?));
    }
    own(entry, exercise, holds?, answer).map(|(values, _)| values)
}

/// True if the answer is exactly that of a known mistake.
pub(super) fn is_known(ask: &Ask, answer: &Answer) -> bool {
    numbers(answer, ask).is_some_and(|given| is_known_mistake(ask, &given.entries))
}

/// The question of a way to find numbers, with its answer.
fn answered<'a>(
    exercise: &'a Exercise,
    holds: &Holds,
    answers: &'a [(String, Answer)],
) -> Option<(&'a Ask, &'a Answer)> {
    let (_, answer) = answers.iter().find(|(name, _)| name == holds.ask)?;
    Some((exercise.asks.iter().find(|ask| ask.name == holds.ask)?, answer))
}

/// The numbers of the statement.
fn of_statement(exercise: &Exercise, holds: &Holds) -> Named {
    exercise.free.iter().copied().filter(|(name, _)| holds.names.contains(name)).collect()
}

/// The numbers in an answer, with the exercise for them, in which it's right.
fn own(entry: &Entry, exercise: &Exercise, holds: &Holds, answer: &Answer) -> Option<(Named, Exercise)> {
    let ask = exercise.asks.iter().find(|ask| ask.name == holds.ask)?;
    let given = numbers(answer, ask)?;
    let off = rounding(&given.entries);
    (holds.find)(&given.entries).into_iter().flat_map(|estimate| near(&estimate, off)).find_map(|values| {
        let mut free: Free = values.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
        // Numbers that the student gave beside the answers decide.
        free.extend(exercise.chosen.clone());
        let all: Free =
            exercise.free.iter().map(|(name, value)| ((*name).to_owned(), *value)).chain(free.clone()).collect();
        if !values.iter().all(|(name, value)| is_possible(name, *value, &all)) {
            return None;
        }
        let own = entry.exercise(exercise.seed, &free);
        let own_ask = own.asks.iter().find(|other| other.name == ask.name)?;
        is_right(own_ask, answer).then(|| (of_statement(&own, holds), own))
    })
}

/// True for a number that a student may choose.
fn is_possible(name: &str, value: f64, all: &Free) -> bool {
    let other = |name: &str| all.get(name).copied();
    match name {
        "B" => other("F").is_none_or(|near| value > near),
        "theta" => (10.0..=150.0).contains(&value),
        "A" => (0.25..=4.0).contains(&value),
        _ => value > 0.0 && value.is_finite(),
    }
}

/// The share by which an estimate may be off because the entries have only so many digits.
fn rounding(entries: &[f64]) -> f64 {
    /// An estimate comes from a few entries.
    const FEW: f64 = 5.0;
    let digits = entries.iter().filter(|entry| entry.fract() != 0.0).map(|entry| digits(*entry).0).min();
    let digits = digits.and_then(|digits| i32::try_from(digits).ok()).unwrap_or(i32::MAX).min(10);
    (FEW * 10.0_f64.powi(1 - digits)).min(MOST_OFF)
}

/// The numbers that a person may have meant by estimates: simple ones near them, then the estimates.
fn near(estimate: &Named, off: f64) -> Vec<Named> {
    estimate.iter().fold(vec![Vec::new()], |all, (name, value)| {
        let meant = meant(*value, off);
        let with = |before: &Named, value: f64| before.iter().copied().chain([(*name, value)]).collect();
        all.iter().flat_map(|before| meant.iter().map(|value| with(before, *value)).collect::<Vec<_>>()).collect()
    })
}

/// Simple numbers near an estimate, and the estimate.
fn meant(estimate: f64, off: f64) -> Vec<f64> {
    let mut meant: Vec<f64> = Vec::new();
    for simple in DENOMINATORS.into_iter().map(|below| (estimate * below).round() / below).chain([estimate]) {
        if (simple - estimate).abs() <= off * estimate.abs() && !meant.contains(&simple) {
            meant.push(simple);
        }
    }
    meant
}
