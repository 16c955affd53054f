//! Judging an answer: its right entries, the known mistake that explains the wrong ones, and the answers from which it
//! follows.

use std::sync::Arc;

use super::acceptance::{in_order, is_right};
use super::answer::Answer;
use super::beside::Beside;
use super::exercise::{Ask, Expected, TOLERANCE};
use super::own_numbers::OwnNumbers;
use super::own_texts::{ExpectedAnswer, OwnMistake};
use super::value::Table;
use crate::camera::Camera;
use crate::exercises::mistakes::diagnose::{Diagnosis, diagnose};
use crate::exercises::mistakes::mistake::Mistake;
use crate::exercises::mistakes::slip::Cause;

/// The verdict on an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The ask that it answers.
    pub name: String,
    /// Right in one of the readings.
    pub right: bool,
    /// From 0 to 1: the correct share of the question. It's 1 if the answer follows correctly from other answers.
    pub score: f64,
    /// Right entries, row by row. There's one for a choice, and one for each condition of a camera.
    pub entries: Vec<Vec<bool>>,
    /// The name of the reading in which it's right, or most nearly right. Empty for the one that the statement settles.
    pub reading: &'static str,
    /// The conditions on a camera, in the order of `entries`.
    pub conditions: Vec<&'static str>,
    /// The explanation of a wrong answer; `None` for a right one, or if no known mistake explains it.
    pub diagnosis: Option<Diagnosis>,
    /// The names of other answers, if this one is right for their wrong values.
    pub carried: Vec<String>,
    /// The numbers for which it was judged, if they aren't those of the statement, or if it's right for others.
    pub numbers: Option<OwnNumbers>,
    /// The number of the first worked step that the right answers beside it don't prove done.
    pub first_step: usize,
    /// The parsed answer.
    pub understood: Answer,
}

/// Judges a parsed answer by itself.
pub fn judge_answer(ask: &Ask, answer: Answer) -> Judged {
    judge_in_context(ask, answer, None)
}

/// Judges an answer beside those to the other questions of its exercise.
pub(super) fn judge_beside(ask: &Ask, answer: Answer, beside: Beside<'_>) -> Judged {
    let judged = judge_in_context(ask, answer, Some(beside));
    if judged.right {
        return judged;
    }
    let carried = beside.carried(ask, &judged.understood);
    if carried.is_empty() {
        let first_step = first_step(ask, beside);
        return Judged { first_step, ..judged };
    }
    Judged { score: 1.0, diagnosis: None, carried, ..judged }
}

/// The first step that no right answer beside it proves done.
fn first_step(ask: &Ask, beside: Beside<'_>) -> usize {
    let right = beside.answered(&ask.name).filter(|(other, answer)| is_right(other, answer));
    let done: Vec<_> = right.flat_map(|(other, _)| other.steps()).map(|step| step.said()).collect();
    let steps = ask.steps();
    let open = steps.iter().position(|step| !done.contains(&step.said()));
    open.unwrap_or(steps.len().saturating_sub(1))
}

fn judge_in_context(ask: &Ask, answer: Answer, beside: Option<Beside<'_>>) -> Judged {
    let judged = judge_readings(ask, answer, beside);
    // The message of its author comes before general knowledge.
    match ask.own_mistake(&judged.understood).filter(|_| !judged.right) {
        Some(own) => {
            let causes = own.mistake.into_iter().map(Cause::of).collect();
            Judged { diagnosis: Some(Diagnosis { own: Some(own), ..Diagnosis::together(causes) }), ..judged }
        }
        None => judged,
    }
}

fn judge_readings(ask: &Ask, answer: Answer, beside: Option<Beside<'_>>) -> Judged {
    let in_readings = ask
        .readings
        .iter()
        .map(|reading| Judged { reading: reading.name, ..judge_in(ask, &reading.expected, &answer, beside) });
    let mut best: Option<Judged> = None;
    for judged in in_readings {
        if judged.right {
            return judged;
        }
        // An explanation is worth more than entries that happen to be right.
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
        carried: Vec::new(),
        numbers: None,
        first_step: 0,
        understood: answer.clone(),
    }
}

fn judge_in(ask: &Ask, expected: &Expected, answer: &Answer, beside: Option<Beside<'_>>) -> Judged {
    match (expected, answer) {
        (Expected::Choice(right, mistakes, _), Answer::Choice(chosen)) => {
            let known = mistakes.iter().find(|(choice, _)| choice == chosen);
            let diagnosis = known.filter(|_| chosen != right).map(|(_, mistake)| Diagnosis::of(Cause::of(*mistake)));
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
                    .map(|(_, mistake)| Diagnosis::of(Cause::of(*mistake)));
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
                let given = entries.iter().copied().collect::<Option<Vec<f64>>>();
                let given = given.map(|entries| Table { rows: *rows, columns: *columns, entries }.transposed());
                let is_turned = *rows > 1
                    && given
                        .is_some_and(|given| given.shape() == right.shape() && ask.accepts_all(&given.entries, &right));
                let table = Cause { mistake: Mistake::Transposed, variant: "table" };
                let cause = if is_turned { table } else { Cause::of(Mistake::WrongShape) };
                return judged(ask, answer, none, Some(Diagnosis::of(cause)));
            }
            let order = ask.order(entries, &right);
            let entries = in_order(entries, &order);
            let is_right: Vec<bool> =
                entries.iter().zip(&right.entries).map(|(given, right)| ask.accepts(*given, *right)).collect();
            let diagnosis = if is_right.iter().all(|is| *is) {
                None
            } else {
                // A table with gaps is judged by its entries, but gets no explanation.
                let given: Option<Vec<f64>> = entries.iter().copied().collect();
                given.and_then(|given| diagnose(ask, expected, &right, &given, beside))
            };
            // In the order of the answer.
            let diagnosis = diagnosis.map(|diagnosis| Diagnosis {
                entry: diagnosis.entry.map(|[row, column]| [row, order[column]]),
                ..diagnosis
            });
            let back: Vec<usize> = (0..order.len()).filter_map(|k| order.iter().position(|at| *at == k)).collect();
            let rows = is_right.chunks(right.columns.max(1)).map(|row| in_order(row, &back)).collect();
            judged(ask, answer, rows, diagnosis)
        }
        _ => judged(ask, answer, vec![vec![false]], None),
    }
}

/// True for cameras whose view volumes have the same corners, in the same order, to the digits given.
fn same_volume(a: &Camera, b: &Camera) -> bool {
    let size = a.far() + a.distance();
    a.volume_corners().iter().zip(b.volume_corners()).all(|(a, b)| (*a - b).length() <= TOLERANCE * size)
}

impl Ask {
    /// The expected wrong answer that this one equals. Of marks, the nearest, if it's nearer than the right place.
    fn own_mistake(&self, answer: &Answer) -> Option<Arc<OwnMistake>> {
        let away = |entries: &[Option<f64>], from: &Table| -> f64 {
            entries.iter().zip(&from.entries).map(|(given, of)| (given.unwrap_or(f64::NAN) - of).powi(2)).sum()
        };
        let off = |own: &Arc<OwnMistake>| match (&own.answer, answer) {
            (ExpectedAnswer::Choice(wrong), Answer::Choice(chosen)) => (wrong == chosen).then_some(0.0),
            (ExpectedAnswer::Numbers(wrong), Answer::Numbers { rows, columns, entries }) => {
                let is_it = [*rows, *columns] == wrong.shape()
                    && entries.iter().zip(&wrong.entries).all(|(given, wrong)| self.accepts(*given, *wrong));
                let right = self.expected().table().filter(|_| self.places);
                let off = is_it.then(|| if self.places { away(entries, wrong) } else { 0.0 })?;
                right.is_none_or(|right| off < away(entries, &right)).then_some(off)
            }
            _ => None,
        };
        let found = self.own_mistakes.iter().filter_map(|own| Some((off(own)?, own)));
        found.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, own)| Arc::clone(own))
    }
}
