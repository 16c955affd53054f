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

/// A vector of length 1 along another.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
    v.try_normalize()
}
