//! The explanation of order: the list of transforms, and the way to read it.

use glam::DVec3;

use crate::explain::order::{Call, Reading, calls_of, exchanged, product, same};
use crate::scene::transform::Trs;

/// A call of the list, identified by a number that it keeps when it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ListedCall {
    pub(in crate::gui) key: usize,
    /// The call.
    pub call: Call,
}

/// The owner of a list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Own {
    /// The name of the object. `None` for an example.
    pub object: Option<String>,
    /// Its own transform, as the figure has it.
    pub trs: Trs,
}

/// The explanation of order.
#[derive(Clone, Debug, Default)]
pub struct Order {
    /// The list, from left to right.
    pub list: Vec<ListedCall>,
    /// The reading of the list.
    pub reading: Reading,
    /// Number of calls applied. `None` for all.
    pub done: Option<usize>,
    /// The places of the two calls exchanged in the other order.
    pub exchange: [usize; 2],
    /// The call that has the keyboard, by its number.
    pub(in crate::gui) focused: Option<usize>,
    /// The owner at the start of the list.
    own: Option<Own>,
    next_key: usize,
}

impl Order {
    /// Starts with the calls of the object, or with an example, if it's another one, or has moved, since the start of
    /// the list.
    pub(in crate::gui) fn follow(&mut self, own: Own) {
        if self.own.as_ref() != Some(&own) {
            self.own = Some(own);
            self.begin_again();
        }
    }

    /// The calls that it began with.
    pub(in crate::gui) fn begin_again(&mut self) {
        let Some(own) = &self.own else { return };
        let calls = match own.object {
            Some(_) => calls_of(&own.trs),
            None => vec![
                Call::Translate(DVec3::new(3.0, 0.0, 0.0)),
                Call::RotateY(40.0),
                Call::Scale(DVec3::new(1.5, 1.0, 1.0)),
            ],
        };
        self.list.clear();
        calls.iter().for_each(|call| self.add(*call));
        self.done = None;
        self.exchange = telling(&calls);
    }

    /// The calls, from left to right.
    pub fn calls(&self) -> Vec<Call> {
        self.list.iter().map(|listed| listed.call).collect()
    }

    /// Adds a call at the end.
    pub(in crate::gui) fn add(&mut self, call: Call) {
        self.list.push(ListedCall { key: self.next_key, call });
        self.next_key += 1;
    }

    /// Moves a call before the one now at `to`, or to the end if there is none.
    pub(in crate::gui) fn put(&mut self, from: usize, to: usize) {
        if from < self.list.len() {
            let listed = self.list.remove(from);
            let to = if from < to { to - 1 } else { to };
            self.list.insert(to.min(self.list.len()), listed);
        }
    }

    /// Moves a call one place to the left or to the right, if there is one.
    pub(in crate::gui) fn step(&mut self, key: usize, forward: bool) {
        let Some(from) = self.list.iter().position(|listed| listed.key == key) else { return };
        let to = if forward { from + 1 } else { from.wrapping_sub(1) };
        if to < self.list.len() {
            self.list.swap(from, to);
        }
    }
}

/// The first two calls of a list whose exchange changes the result, else its first two.
fn telling(calls: &[Call]) -> [usize; 2] {
    let other = |pair: [usize; 2]| match (product(calls), product(&exchanged(calls, pair))) {
        (Ok(a), Ok(b)) => !same(&a, &b),
        _ => false,
    };
    let pairs = (0..calls.len()).flat_map(|a| (a + 1..calls.len()).map(move |b| [a, b]));
    pairs.into_iter().find(|pair| other(*pair)).unwrap_or([0, 1])
}
