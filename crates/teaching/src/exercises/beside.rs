//! Judges an answer beside the others: if it follows from a student's own wrong value, it's right.

use super::acceptance::is_right;
use super::answer::Answer;
use super::exercise::{Ask, Exercise, Expected, Kind};
use super::follows::Follows;
use super::value::Table;

/// The other answers of a student to the questions of an exercise.
#[derive(Clone, Copy, Debug)]
pub struct Beside<'a> {
    /// The exercise that the answers belong to.
    pub exercise: &'a Exercise,
    /// The names of the questions, and the answers.
    pub answers: &'a [(String, Answer)],
}

impl<'a> Beside<'a> {
    fn ask(&self, name: &str) -> Option<&'a Ask> {
        self.exercise.asks.iter().find(|ask| ask.name == name)
    }

    /// The other questions that were answered.
    pub(super) fn answered(self, except: &'a str) -> impl Iterator<Item = (&'a Ask, &'a Answer)> {
        let others = self.answers.iter().filter(move |(name, _)| name != except);
        others.filter_map(move |(name, answer)| Some((self.ask(name)?, answer)))
    }

    /// The names of the first wrong answers from which an answer follows. Empty if it doesn't follow from any.
    pub(super) fn carried(&self, ask: &'a Ask, answer: &Answer) -> Vec<String> {
        let Some(given) = numbers(answer, ask) else { return Vec::new() };
        ask.follows.iter().find_map(|way| self.along(way, ask, &given)).unwrap_or_default()
    }

    fn along(&self, way: &Follows, ask: &'a Ask, given: &Table) -> Option<Vec<String>> {
        let asks: Vec<&Ask> = way.from.iter().filter_map(|name| self.ask(name)).collect();
        if asks.len() != way.from.len() {
            return None;
        }
        let rights: Vec<Table> = asks.iter().map(|ask| right(ask)).collect::<Option<_>>()?;
        let answers: Vec<Option<&Answer>> = asks
            .iter()
            .map(|ask| self.answers.iter().find(|(name, _)| *name == ask.name).map(|(_, answer)| answer))
            .collect();
        let is_wrong: Vec<bool> = asks
            .iter()
            .zip(&answers)
            .map(|(ask, answer)| answer.is_some_and(|answer| !is_right(ask, answer)))
            .collect();
        let wrong = |k: usize| answers[k].filter(|_| is_wrong[k]).and_then(|answer| numbers(answer, asks[k]));
        let tables: Vec<Table> = (0..asks.len()).map(|k| wrong(k).unwrap_or_else(|| rights[k].clone())).collect();
        // Everything follows from nothing.
        let is_nothing = |k: usize| !matches!(asks[k].kind, Kind::Choice(_)) && tables[k].size() == 0.0;
        if (0..asks.len()).any(|k| is_wrong[k] && is_nothing(k)) {
            return None;
        }
        // A 0 counts as none if it comes from rounded numbers, because a share of it is no measure.
        let follows =
            |given: f64, of: f64| ask.accepts(Some(given), of) || (!ask.whole && (given - of).abs() <= ask.tolerance);
        let gives = |tables: &[Table]| {
            let found = (way.compute)(tables).filter(|found| found.shape() == given.shape());
            found.is_some_and(|found| given.entries.iter().zip(&found.entries).all(|(given, of)| follows(*given, *of)))
        };
        if !is_wrong.contains(&true) || !gives(&tables) {
            return None;
        }
        // An answer that follows from the right value too isn't carried from the wrong one.
        let without = |k: usize| {
            let mut tables = tables.clone();
            tables[k].clone_from(&rights[k]);
            tables
        };
        let matters = (0..asks.len()).filter(|k| is_wrong[*k] && !gives(&without(*k)));
        let mut names = Vec::new();
        for k in matters {
            // The first cause, not each answer on the way.
            let earlier = answers[k].map(|answer| self.carried(asks[k], answer)).unwrap_or_default();
            let found = if earlier.is_empty() { vec![asks[k].name.clone()] } else { earlier };
            names.extend(found.into_iter().filter(|name| !names.contains(name)).collect::<Vec<_>>());
        }
        (!names.is_empty()).then_some(names)
    }
}

/// The right answer as a table; `None` for cameras.
fn right(ask: &Ask) -> Option<Table> {
    match ask.expected() {
        Expected::Choice(right, ..) => choice(*right),
        expected => expected.table(),
    }
}

fn choice(index: usize) -> Option<Table> {
    Some(Table::number(f64::from(u32::try_from(index).ok()?)))
}

/// An answer without gaps, in the shape of its question.
pub(super) fn numbers(answer: &Answer, ask: &Ask) -> Option<Table> {
    match answer {
        Answer::Numbers { rows, columns, entries } if [*rows, *columns] == ask.shape() => {
            let entries = entries.iter().copied().collect::<Option<Vec<f64>>>()?;
            Some(Table { rows: *rows, columns: *columns, entries })
        }
        Answer::Choice(index) => choice(*index),
        _ => None,
    }
}
