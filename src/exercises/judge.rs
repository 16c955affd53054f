//! Judging an answer: its right entries, and the known mistake that explains the wrong ones.

use std::sync::Arc;

use super::answer::{Answer, AnswerError, read_answer};
use super::exercise::{Ask, Exercise, Expected, Kind};
use super::mistake::{Mistake, Slip, Slips};
use super::own_texts::{ExpectedAnswer, OwnMistake};
use super::value::Table;
use crate::camera::Camera;
use crate::inspect::quantity::Quantity;

/// The verdict on an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The ask that it answers.
    pub name: String,
    /// Right in one of the readings.
    pub right: bool,
    /// From 0 to 1: the share of the question that is answered rightly.
    pub score: f64,
    /// Right entries, row by row; one for a choice; one for each condition of a camera.
    pub entries: Vec<Vec<bool>>,
    /// The name of the reading in which it is right, or as right as can be; empty for the one that the statement
    /// settles.
    pub reading: &'static str,
    /// The conditions that a camera has to fulfil, in the order of `entries`.
    pub conditions: Vec<&'static str>,
    /// The explanation of a wrong answer; `None` for a right one, and where no known mistake explains it.
    pub diagnosis: Option<Diagnosis>,
    /// The answer as understood.
    pub understood: Answer,
}

/// The known mistakes that give the numbers of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// One, or two that were made together; the first is the one that comes first on the way. None where `own` is not
    /// among the known ones.
    pub mistakes: Vec<Mistake>,
    /// The row and column of a single faulty number, from 0.
    pub entry: Option<[usize; 2]>,
    /// The wrong answer that a lecturer expected, with its message.
    pub own: Option<Arc<OwnMistake>>,
}

impl Diagnosis {
    fn of(mistake: Mistake) -> Self {
        Self { mistakes: vec![mistake], entry: None, own: None }
    }
}

/// Judges a text as an answer to an ask of an exercise.
///
/// # Errors
/// [`AnswerError`]: the text cannot be read as an answer; then nothing is judged.
pub fn judge(exercise: &Exercise, ask: &Ask, text: &str) -> Result<Judged, AnswerError> {
    let names: Vec<(&str, f64)> = exercise.free.clone();
    Ok(judge_answer(ask, read_answer(text, ask, &names)?))
}

/// Judges an answer that has been read.
#[must_use]
pub fn judge_answer(ask: &Ask, answer: Answer) -> Judged {
    let judged = judge_readings(ask, answer);
    // The message of its author comes before general knowledge.
    match ask.own_mistake(&judged.understood).filter(|_| !judged.right) {
        Some(own) => {
            let mistakes = own.mistake.into_iter().collect();
            Judged { diagnosis: Some(Diagnosis { mistakes, entry: None, own: Some(own) }), ..judged }
        }
        None => judged,
    }
}

fn judge_readings(ask: &Ask, answer: Answer) -> Judged {
    let in_readings = ask
        .readings
        .iter()
        .map(|reading| Judged { reading: reading.name, ..judge_in(ask, &reading.expected, &answer) });
    let mut best: Option<Judged> = None;
    for judged in in_readings {
        if judged.right {
            return judged;
        }
        // An explanation is worth more than entries that are right by chance.
        let rank = |judged: &Judged| (judged.diagnosis.is_some(), judged.score);
        if best.as_ref().is_none_or(|best| rank(&judged) > rank(best)) {
            best = Some(judged);
        }
    }
    best.unwrap_or_else(|| judged(ask, &answer, vec![vec![false]], None))
}

fn judged(ask: &Ask, answer: &Answer, entries: Vec<Vec<bool>>, diagnosis: Option<Diagnosis>) -> Judged {
    let (all, right) =
        entries.iter().flatten().fold((0_u32, 0_u32), |(all, right), is| (all + 1, right + u32::from(*is)));
    Judged {
        name: ask.name.clone(),
        right: all > 0 && all == right,
        score: if all == 0 { 0.0 } else { f64::from(right) / f64::from(all) },
        entries,
        reading: "",
        conditions: Vec::new(),
        diagnosis,
        understood: answer.clone(),
    }
}

fn judge_in(ask: &Ask, expected: &Expected, answer: &Answer) -> Judged {
    match (expected, answer) {
        (Expected::Choice(right, mistakes, _), Answer::Choice(chosen)) => {
            let known = mistakes.iter().find(|(choice, _)| choice == chosen);
            let diagnosis = known.filter(|_| chosen != right).map(|(_, mistake)| Diagnosis::of(*mistake));
            judged(ask, answer, vec![vec![chosen == right]], diagnosis)
        }
        (Expected::Camera(conditions, model, mistakes, _), Answer::Camera(parameters)) => match Camera::new(parameters)
        {
            Ok(camera) => {
                let found = conditions(&camera);
                let entries = found.iter().map(|(_, is)| vec![*is]).collect();
                let diagnosis = mistakes
                    .iter()
                    .filter(|(wrong, _)| wrong != &**model)
                    .find(|(wrong, _)| Camera::new(wrong).is_ok_and(|wrong| same_volume(&wrong, &camera)))
                    .map(|(_, mistake)| Diagnosis::of(*mistake));
                let verdict = judged(ask, answer, entries, None);
                let diagnosis = diagnosis.filter(|_| !verdict.right);
                Judged { conditions: found.into_iter().map(|(name, _)| name).collect(), diagnosis, ..verdict }
            }
            Err(_) => judged(ask, answer, vec![vec![false]], None),
        },
        (_, Answer::Numbers { rows, columns, entries }) => {
            let Some(right) = expected.table() else { return judged(ask, answer, vec![vec![false]], None) };
            if [*rows, *columns] != right.shape() {
                let none = vec![vec![false; right.columns]; right.rows];
                return judged(ask, answer, none, Some(Diagnosis::of(Mistake::WrongShape)));
            }
            let is_right: Vec<bool> =
                entries.iter().zip(&right.entries).map(|(given, right)| ask.accepts(*given, *right)).collect();
            let diagnosis = if is_right.iter().all(|is| *is) {
                None
            } else {
                // A table with gaps is judged by its entries, but not explained.
                let given: Option<Vec<f64>> = entries.iter().copied().collect();
                given.and_then(|given| diagnose(ask, expected, &right, &given))
            };
            let rows = is_right.chunks(right.columns.max(1)).map(<[bool]>::to_vec).collect();
            judged(ask, answer, rows, diagnosis)
        }
        _ => judged(ask, answer, vec![vec![false]], None),
    }
}

/// True for cameras whose view volumes have the same corners, in the same order.
fn same_volume(a: &Camera, b: &Camera) -> bool {
    let size = a.far() + a.distance();
    a.volume_corners().iter().zip(b.volume_corners()).all(|(a, b)| (*a - b).length() <= 1e-9 * size)
}

impl Ask {
    /// Whether a number is right where `right` is.
    #[must_use]
    pub fn accepts(&self, given: Option<f64>, right: f64) -> bool {
        let Some(given) = given else { return false };
        if self.whole {
            return (given - right).abs() <= 1e-9 * right.abs().max(1.0);
        }
        // The error of a decimal number in f64 relative to the intended one.
        let rest = 1e-12 * right.abs();
        (given - right).abs() <= self.tolerance + rest || is_rounded(given, right, rest)
    }

    /// The wrong answer that was expected, and is this one.
    fn own_mistake(&self, answer: &Answer) -> Option<Arc<OwnMistake>> {
        let is = |own: &&Arc<OwnMistake>| match (&own.answer, answer) {
            (ExpectedAnswer::Choice(wrong), Answer::Choice(chosen)) => wrong == chosen,
            (ExpectedAnswer::Numbers(wrong), Answer::Numbers { rows, columns, entries }) => {
                [*rows, *columns] == wrong.shape()
                    && entries.iter().zip(&wrong.entries).all(|(given, wrong)| self.accepts(*given, *wrong))
            }
            _ => false,
        };
        self.own_mistakes.iter().find(is).cloned()
    }

    fn accepts_all(&self, given: &[f64], right: &Table) -> bool {
        given.len() == right.entries.len()
            && given.iter().zip(&right.entries).all(|(given, right)| self.accepts(Some(*given), *right))
    }
}

/// Whether `given` is `right`, rounded to three or more significant digits.
fn is_rounded(given: f64, right: f64, rest: f64) -> bool {
    (3..=16).any(|digits| (given - rounded(right, digits)).abs() <= rest)
}

/// A number rounded to this many significant digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{:.*e}", digits.saturating_sub(1), value).parse().unwrap_or(value)
}

/// The known mistakes that give `given` where `right` is right: one of the slips; a slip of the pen; two together.
fn diagnose(ask: &Ask, expected: &Expected, right: &Table, given: &[f64]) -> Option<Diagnosis> {
    // A slip that gives the right result is not a mistake here.
    let differs = |table: &Table| table.shape() == right.shape() && !ask.accepts_all(&table.entries, right);
    let explains = |table: &Table| differs(table) && ask.accepts_all(given, table);
    let slipped: Vec<(Slip, Table)> = in_order_of_telling(expected)
        .into_iter()
        .filter_map(|slip| Some((slip, expected.slipped(Slips::one(slip))?)))
        .filter(|(_, table)| differs(table))
        .collect();
    if let Some((slip, _)) = slipped.iter().find(|(_, table)| explains(table)) {
        return Some(Diagnosis::of(slip.mistake()));
    }
    let reshaped = |table: &Table| {
        let transposed = (table.rows == table.columns && table.rows > 1).then(|| table.transposed());
        let inverse = if table.shape() == [1, 1] {
            // A ratio turned round; of a length or a count nobody takes the reciprocal.
            (ask.kind == Kind::Number && table.entries[0] != 0.0).then(|| table.map(|x| 1.0 / x))
        } else {
            table.inverse()
        };
        [(Mistake::Transposed, transposed), (Mistake::Inverse, inverse), (Mistake::Sign, Some(table.map(|x| -x)))]
    };
    let as_mistake = |table: &Table| {
        let mut found = reshaped(table).into_iter().filter_map(|(mistake, changed)| Some((mistake, changed?)));
        found.find(|(_, changed)| explains(changed)).map(|(mistake, _)| mistake)
    };
    if let Some(mistake) = as_mistake(right) {
        return Some(Diagnosis::of(mistake));
    }
    if has_signs_of(ask, given, right) {
        return Some(Diagnosis { entry: only_wrong(ask, given, right), ..Diagnosis::of(Mistake::Sign) });
    }
    if is_rounded_too_early(ask, given, right) {
        return Some(Diagnosis::of(Mistake::RoundedTooEarly));
    }
    if let Some(entry) = only_wrong(ask, given, right).filter(|_| given.len() > 1) {
        return Some(Diagnosis { entry: Some(entry), ..Diagnosis::of(Mistake::ArithmeticSlip) });
    }
    two_together(ask, expected, given, &slipped, explains, as_mistake)
}

/// The slips, in the order of preference where two explain the same numbers: of a point and after an operation the last
/// step first, of all else the axes.
fn in_order_of_telling(expected: &Expected) -> Vec<Slip> {
    let last_first = matches!(expected, Expected::Quantity(subject, path)
        if matches!(path.quantity, Quantity::Point(..)) || !subject.operations.is_empty());
    let (axes, others): (Vec<Slip>, Vec<Slip>) = Slip::ALL.iter().partition(|slip| slip.is_of_axes());
    if last_first { [others, axes].concat() } else { [axes, others].concat() }
}

/// Two slips, a slip in the wrong order, or a slip with one more number wrong.
fn two_together(
    ask: &Ask,
    expected: &Expected,
    given: &[f64],
    slipped: &[(Slip, Table)],
    explains: impl Fn(&Table) -> bool,
    as_mistake: impl Fn(&Table) -> Option<Mistake>,
) -> Option<Diagnosis> {
    for (k, (first, _)) in slipped.iter().enumerate() {
        for (second, _) in &slipped[k + 1..] {
            if first.mistake() == second.mistake() {
                continue;
            }
            if expected.slipped(Slips::one(*first).and(*second)).is_some_and(|table| explains(&table)) {
                return Some(Diagnosis { mistakes: vec![first.mistake(), second.mistake()], entry: None, own: None });
            }
        }
    }
    for (slip, table) in slipped {
        let second = as_mistake(table).filter(|second| *second != slip.mistake());
        if let Some(second) = second {
            return Some(Diagnosis { mistakes: vec![slip.mistake(), second], entry: None, own: None });
        }
    }
    // In few numbers one more that is wrong would explain anything.
    const ENOUGH: usize = 9;
    for (slip, table) in slipped.iter().filter(|_| given.len() >= ENOUGH) {
        if table.entries.len() != given.len() {
            continue;
        }
        let Some(entry) = only_wrong(ask, given, table) else { continue };
        return Some(Diagnosis {
            mistakes: vec![slip.mistake(), Mistake::ArithmeticSlip],
            entry: Some(entry),
            own: None,
        });
    }
    None
}

/// The row and column of the only entry that is wrong.
fn only_wrong(ask: &Ask, given: &[f64], right: &Table) -> Option<[usize; 2]> {
    let mut wrong = (0..given.len()).filter(|k| !ask.accepts(Some(given[*k]), right.entries[*k]));
    let first = wrong.next()?;
    wrong.next().is_none().then(|| [first / right.columns.max(1), first % right.columns.max(1)])
}

/// Only signs are wrong.
fn has_signs_of(ask: &Ask, given: &[f64], right: &Table) -> bool {
    given.iter().zip(&right.entries).all(|(given, right)| ask.accepts(Some(given.abs()), right.abs()))
}

/// Whether a wrong answer is close: rounded to fewer than three digits or decimals, or all of it within a hundredth.
/// Nobody rounds 0.23 to 0: whole numbers below 1 are a guess.
fn is_rounded_too_early(ask: &Ask, given: &[f64], right: &Table) -> bool {
    if ask.whole {
        return false;
    }
    let wrong = || given.iter().zip(&right.entries).filter(|(given, right)| !ask.accepts(Some(**given), **right));
    let several = wrong().count() > 1;
    let cut = |given: f64, right: f64| {
        let to_digits = (1..=2).any(|digits| (given - rounded(right, digits)).abs() <= 1e-9 * right.abs());
        let to_decimals = [10.0, 100.0].iter().any(|unit| ((right * unit).round() / unit - given).abs() <= 1e-9);
        // One number that is 0 may be anything; among others that are rounded it is rounded too.
        to_digits || (to_decimals && (given != 0.0 || several))
    };
    let near = |given: f64, right: f64| (given - right).abs() <= 0.01 * right.abs();
    wrong().all(|(given, right)| cut(*given, *right))
        || (wrong().all(|(given, right)| near(*given, *right)) && (given.len() == 1 || several))
}
