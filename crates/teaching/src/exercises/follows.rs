//! The ways from some answers of an exercise to another one.

use std::fmt;
use std::sync::Arc;

use glam::DVec3;

use super::value::Table;

/// Computes an answer from others.
pub(super) type FromAnswers = Arc<dyn Fn(&[Table]) -> Option<Table> + Send + Sync>;

/// A way to an answer from other answers of the same exercise. A choice is its number, from 0.
#[derive(Clone)]
pub struct Follows {
    /// The names of the questions that it starts from.
    pub from: &'static [&'static str],
    /// Computes the answer from theirs, in the same order.
    pub compute: FromAnswers,
}

impl fmt::Debug for Follows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Follows({:?})", self.from)
    }
}

/// Numbers by their names.
pub(super) type Named = Vec<(&'static str, f64)>;
/// Estimates from the entries of an answer, one list for each way to find them.
type Find = Arc<dyn Fn(&[f64]) -> Vec<Named> + Send + Sync>;

/// An answer from which numbers that are left open follow.
#[derive(Clone)]
pub struct Holds {
    /// The name of its question.
    pub ask: &'static str,
    /// The names of the numbers.
    pub names: &'static [&'static str],
    pub(super) find: Find,
}

impl fmt::Debug for Holds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Holds({} in {})", self.names.join(", "), self.ask)
    }
}

impl Holds {
    /// `find` estimates the numbers from the entries, row by row. It may give anything, even nothing.
    pub(super) fn new(
        ask: &'static str,
        names: &'static [&'static str],
        find: impl Fn(&[f64]) -> Vec<Named> + Send + Sync + 'static,
    ) -> Self {
        Self { ask, names, find: Arc::new(find) }
    }
}

/// A vector of length 1 along another.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
    v.try_normalize()
}
