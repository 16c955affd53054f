//! The solution of a student with a known mistake in it. The first wrong line and its cause are to be found.
//!
//! A formula of the worked steps is miswritten, and all lines after it follow from that. Of these solutions, those are
//! taken whose answer the judge explains by one known mistake. So a cause is never claimed that the judge wouldn't
//! name.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::answer::Answer;
use super::exercise::{Ask, Exercise, Fault, Kind};
use super::judge::judge_answer;
use super::value::Table;
use super::worked::Worked;
use super::worked::miswritten::{self, Miswritten, following, is_same};
use crate::exercises::mistakes::diagnose::{Diagnosis, possible};
use crate::exercises::mistakes::mistake::Mistake;
use crate::exercises::mistakes::nature::Nature;
use crate::exercises::mistakes::slip::{Cause, Slip, Slips};
use crate::numbers::random::Random;

/// The numbers of a seed for choices among mistakes.
const STREAM: u64 = 0xfa17;
/// Other causes to choose from: at least, and at most.
const OTHERS: [usize; 2] = [2, 3];

/// True for an exercise in whose lines a known mistake shows. It doesn't if the answer is a choice or a camera.
pub(super) fn is_possible(exercise: &Exercise) -> bool {
    asks(exercise).is_some()
}

/// The exercise that asks for the mistake in a solution of another one. It asks nothing if no known mistake shows.
pub(super) fn of_exercise(exercise: Exercise) -> Exercise {
    Exercise { asks: asks(&exercise).unwrap_or_default(), holds: Vec::new(), answered: None, ..exercise }
}

/// The worked steps of a question, and the lines that hold its answer.
struct Way<'a> {
    ask: &'a Ask,
    right: Table,
    steps: Vec<Worked>,
    /// For each entry of the answer. `None` for a 0 or 1 that's the same for every camera.
    lines: Vec<Option<usize>>,
}

impl<'a> Way<'a> {
    /// `None` if the answer isn't in the lines.
    fn new(ask: &'a Ask) -> Option<Self> {
        let (right, steps) = (ask.expected().table()?, ask.steps());
        let lines = if ask.nature == Nature::Outcode {
            (0..values(&steps).count()).map(Some).collect()
        } else {
            lines_of(&right.entries, &values(&steps).collect::<Vec<_>>())
        };
        let is_found = lines.iter().zip(&right.entries).all(|(line, entry)| line.is_some() || is_given(*entry));
        let is_found = is_found && lines.len() == right.entries.len() && lines.iter().any(Option::is_some);
        is_found.then_some(Self { ask, right, steps, lines })
    }

    /// The answer of a student with these steps.
    fn answer(&self, steps: &[Worked]) -> Table {
        let values: Vec<f64> = values(steps).collect();
        let entry = |(line, right): (&Option<usize>, &f64)| match line {
            // An outcode consists of the signs of its lines.
            Some(line) if self.ask.nature == Nature::Outcode => f64::from(u8::from(values[*line] < 0.0)),
            Some(line) => values[*line],
            None => *right,
        };
        Table { entries: self.lines.iter().zip(&self.right.entries).map(entry).collect(), ..self.right }
    }

    /// The slips that change the answer, with their results.
    fn known(&self) -> Vec<(Slip, Table)> {
        possible(self.ask, self.ask.expected(), &self.right)
    }

    /// The ways to miswrite it whose answer the judge explains by one mistake, with the answer and the explanation.
    fn explained(&self) -> Vec<(Miswritten, Table, Diagnosis)> {
        let known = self.known();
        let explained = |miswritten: Miswritten| {
            let steps = following(&self.steps, &miswritten);
            let value = |steps: &[Worked]| values(steps).nth(miswritten[0].0);
            let answer = self.answer(&steps);
            // Nobody could mark a line with the right number.
            let is_hidden = value(&steps).zip(value(&self.steps)).is_none_or(|(wrong, right)| is_same(wrong, right));
            if is_hidden || !known.iter().any(|(_, table)| are_same(&answer, table)) {
                return None;
            }
            let entries = answer.entries.iter().copied().map(Some).collect();
            let given = Answer::Numbers { rows: answer.rows, columns: answer.columns, entries };
            let judged = judge_answer(self.ask, given);
            let diagnosis = judged.diagnosis.filter(|found| !judged.right && found.causes.len() == 1)?;
            Some((miswritten, answer, diagnosis))
        };
        let mut found: Vec<_> = miswritten::all(&self.steps).into_iter().filter_map(explained).collect();
        let is_at_its_place = |(miswritten, _, diagnosis): &(Miswritten, Table, Diagnosis)| {
            !is_of_axes(diagnosis.causes[0].mistake) || self.is_of_axes(miswritten[0].0)
        };
        if found.iter().any(is_at_its_place) {
            found.retain(is_at_its_place);
        }
        // One cause is better than one of several.
        if found.iter().any(|(.., diagnosis)| diagnosis.others.is_empty()) {
            found.retain(|(.., diagnosis)| diagnosis.others.is_empty());
        }
        found
    }

    /// True for a line that computes an axis, or what an axis comes from.
    fn is_of_axes(&self, line: usize) -> bool {
        let name = miswritten::names(&self.steps).nth(line).flatten().unwrap_or_default();
        let is_long = name.starts_with('D') || name.starts_with('‖');
        is_long
            || name
                .split_once('_')
                .is_some_and(|(vector, _)| matches!(vector.trim_end_matches('\''), "u" | "v" | "n" | "a"))
    }

    /// Causes that don't explain an answer: those of this question before those of `all`.
    fn others(&self, answer: &Table, found: &Diagnosis, all: &[Cause], random: &mut Random) -> Vec<Cause> {
        let (ask, known) = (self.ask, self.known().into_iter().map(|(slip, _)| slip.cause()).collect());
        let slipped = |slip: &Slip| ask.expected().slipped(Slips::one(*slip));
        let same = |slip: &&Slip| slipped(slip).is_some_and(|table| ask.accepts_all(&answer.entries, &table));
        let sign = are_same(&answer.map(f64::abs), &self.right.map(f64::abs)).then_some(Mistake::Sign);
        let same = Slip::ALL.iter().filter(same).map(|slip| slip.mistake());
        let mut told: Vec<Mistake> = found.mistakes().chain(sign).chain(same).collect();
        let mut others = Vec::new();
        for mut causes in [known, all.to_vec()] {
            while let Some(cause) = taken(&mut causes, random).filter(|_| others.len() < OTHERS[1]) {
                if !told.contains(&cause.mistake) {
                    told.push(cause.mistake);
                    others.push(cause);
                }
            }
        }
        others
    }
}

/// True for mistakes in a line that computes an axis. Elsewhere they only happen to give the same numbers.
const fn is_of_axes(mistake: Mistake) -> bool {
    matches!(mistake, Mistake::NReversed | Mistake::UReversed | Mistake::VReversed | Mistake::VupAsV)
}

/// True for a number that may be the same for every camera, and then has no line.
fn is_given(entry: f64) -> bool {
    entry == 0.0 || entry.abs() == 1.0
}

fn values(steps: &[Worked]) -> impl Iterator<Item = f64> + '_ {
    steps.iter().flat_map(Worked::values)
}

fn are_same(a: &Table, b: &Table) -> bool {
    a.shape() == b.shape() && a.entries.iter().zip(&b.entries).all(|(a, b)| is_same(*a, *b))
}

/// One of a list, which loses it.
fn taken<T>(from: &mut Vec<T>, random: &mut Random) -> Option<T> {
    let at = usize::try_from(random.bits() % from.len().max(1) as u64).unwrap_or_default();
    (at < from.len()).then(|| from.swap_remove(at))
}

/// The lines that hold the entries of an answer: the last ones in the order of the entries, or else in any order, as l,
/// r, b, t after t, b, r, l.
fn lines_of(entries: &[f64], values: &[f64]) -> Vec<Option<usize>> {
    let mut end = values.len();
    let line = |entry: &f64| {
        let last = |values: &[f64]| values.iter().rposition(|value| is_same(*entry, *value));
        let before = last(&values[..end]);
        let line = if is_given(*entry) && entries.len() > 1 {
            before.filter(|line| line + 1 == end)
        } else {
            before.or_else(|| last(values))
        };
        end = line.unwrap_or(end);
        line
    };
    let mut lines: Vec<Option<usize>> = entries.iter().rev().map(line).collect();
    lines.reverse();
    lines
}

/// The questions for the mistake in a solution. Of the mistakes that apply with these numbers, the seed picks one.
fn asks(exercise: &Exercise) -> Option<Vec<Ask>> {
    const NAMES: [&str; 4] = ["a", "b", "c", "d"];
    let mut random = Random::new(exercise.seed, STREAM);
    let mut ways: Vec<Way<'_>> = exercise.asks.iter().filter_map(Way::new).collect();
    let known = |ask: &Ask| Some(possible(ask, ask.expected(), &ask.expected().table()?));
    let all: Vec<Cause> = exercise.asks.iter().filter_map(known).flatten().map(|(slip, _)| slip.cause()).collect();
    while let Some(way) = taken(&mut ways, &mut random) {
        let mut found = way.explained();
        let mistakes: BTreeSet<Mistake> = found.iter().map(|(.., found)| found.causes[0].mistake).collect();
        let Some(mistake) = taken(&mut mistakes.into_iter().collect(), &mut random) else { continue };
        found.retain(|(.., found)| found.causes[0].mistake == mistake);
        let (miswritten, answer, diagnosis) = taken(&mut found, &mut random)?;
        let mut causes = way.others(&answer, &diagnosis, &all, &mut random);
        if causes.len() < OTHERS[0] {
            continue;
        }
        let cause = diagnosis.causes[0];
        let place = usize::try_from(random.bits() % (causes.len() as u64 + 1)).unwrap_or_default();
        causes.insert(place, cause);
        let first = miswritten[0].0;
        let number = u32::try_from(first + 1).ok()?;
        let right = way.steps.iter().flat_map(Worked::by_rows).nth(first)?;
        let line = Ask::computed("line", Kind::Number, vec![right], move |_| Some(f64::from(number).into())).whole();
        let why = Ask::choice("cause", &NAMES[..causes.len().min(NAMES.len())], place, &[], Vec::new());
        let steps = following(&way.steps, &miswritten);
        let fault = Arc::new(Fault { ask: way.ask.clone(), steps, line: number, cause, causes });
        let about = |ask: Ask| Ask { fault: Some(Arc::clone(&fault)), ..ask };
        return Some(vec![about(line.of_nature(Nature::Parameter)), about(why)]);
    }
    None
}

#[cfg(test)]
mod tests;
