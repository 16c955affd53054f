//! Right answers: the accepted numbers, choices and cameras.

use super::answer::Answer;
use super::exercise::{Ask, Expected, TOLERANCE};
use super::value::Table;
use super::worked::Worked;
use crate::camera::Camera;
use crate::exercises::mistakes::slip::{Slip, Slips};

/// True if an answer is right in one of the readings.
pub(super) fn is_right(ask: &Ask, answer: &Answer) -> bool {
    ask.readings.iter().any(|reading| match (&reading.expected, answer) {
        (Expected::Choice(right, ..), Answer::Choice(chosen)) => right == chosen,
        (Expected::Camera(conditions, ..), Answer::Camera(parameters)) => {
            Camera::new(parameters).is_ok_and(|camera| conditions(&camera).iter().all(|(_, is)| *is))
        }
        (expected, Answer::Numbers { rows, columns, entries }) => expected.table().is_some_and(|right| {
            [*rows, *columns] == right.shape() && {
                let entries = in_order(entries, &ask.order(entries, &right));
                entries.iter().zip(&right.entries).all(|(given, right)| ask.accepts(*given, *right))
            }
        }),
        _ => false,
    })
}

/// The entries of a table with its columns in this order.
pub(super) fn in_order<T: Copy>(entries: &[T], order: &[usize]) -> Vec<T> {
    let rows = entries.chunks_exact(order.len().max(1));
    rows.flat_map(|row| order.iter().filter_map(|column| row.get(*column)).copied().collect::<Vec<_>>()).collect()
}

impl Ask {
    /// The given column that belongs to each of the right ones: the same, or if the columns are points in any order,
    /// one that equals it. Those that equal none keep their order.
    pub(super) fn order(&self, given: &[Option<f64>], right: &Table) -> Vec<usize> {
        let columns = right.columns.max(1);
        if !self.any_order || given.len() != right.entries.len() {
            return (0..columns).collect();
        }
        let equals = |k: usize, of: usize| {
            let mut rows = given.chunks_exact(columns).zip(right.rows());
            rows.all(|(given, right)| self.accepts(given[k], right[of]))
        };
        let mut free: Vec<usize> = (0..columns).collect();
        let matched: Vec<Option<usize>> = (0..columns)
            .map(|of| {
                let place = free.iter().position(|k| equals(*k, of))?;
                Some(free.remove(place))
            })
            .collect();
        let mut rest = free.into_iter();
        matched.into_iter().filter_map(|found| found.or_else(|| rest.next())).collect()
    }

    /// The distance of an answer from the right place in the image, in pixels to the right and down. `None` for other
    /// answers.
    pub fn off(&self, answer: &Answer) -> Option<[f64; 2]> {
        let Answer::Numbers { entries, .. } = answer else { return None };
        let right = self.expected().table().filter(|_| self.places)?;
        match (&right.entries[..], &entries[..]) {
            ([x, y], [Some(at), Some(below)]) => Some([at - x, below - y]),
            _ => None,
        }
    }

    /// True if a number is right when `right` is.
    pub fn accepts(&self, given: Option<f64>, right: f64) -> bool {
        let Some(given) = given else { return false };
        if self.whole {
            return (given - right).abs() <= 1e-9 * right.abs().max(1.0);
        }
        // The error of a decimal number in f64 relative to the intended one.
        let rest = 1e-12 * right.abs();
        // A number that's 0 apart from its error has no size to take a share of.
        let share = if right.abs() <= 1e-9 * self.tolerance { f64::INFINITY } else { self.share * right.abs() };
        (given - right).abs() <= self.tolerance.min(share) + rest || is_rounded(given, right, rest)
    }

    /// True if the right answer shows that a slip wasn't made.
    pub(super) fn tells(&self, slip: Slip) -> bool {
        let tables = self.expected().table().zip(self.expected().slipped(Slips::one(slip)));
        tables.is_some_and(|(right, wrong)| wrong.shape() == right.shape() && !self.accepts_all(&wrong.entries, &right))
    }

    pub(super) fn accepts_all(&self, given: &[f64], right: &Table) -> bool {
        given.len() == right.entries.len()
            && given.iter().zip(&right.entries).all(|(given, right)| self.accepts(Some(*given), *right))
    }
}

impl Worked {
    /// True if a number is the value of its last row, or that value rounded to three digits or more.
    pub fn ends_with(&self, number: f64) -> bool {
        let is_it = |value: f64| {
            let rest = 1e-9 * value.abs().max(1.0);
            (number - value).abs() <= TOLERANCE * value.abs().max(1e-6) || is_rounded(number, value, rest)
        };
        self.last_value().is_some_and(is_it)
    }
}

/// True if `given` is `right` rounded to three or more significant digits.
fn is_rounded(given: f64, right: f64, rest: f64) -> bool {
    (3..=16).any(|digits| (given - rounded(right, digits)).abs() <= rest)
}

/// Rounds a number to this many significant digits.
pub(super) fn rounded(value: f64, digits: usize) -> f64 {
    format!("{:.*e}", digits.saturating_sub(1), value).parse().unwrap_or(value)
}
