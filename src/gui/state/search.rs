//! The search for anything in the window.

use crate::gui::command::Command;

/// The words of the search, and what was found by them.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// The words, as typed.
    pub wanted: String,
    /// The place of the result that Enter goes to.
    pub chosen: usize,
    /// The command that was found and is to be done after the frame.
    pub(in crate::gui) command: Option<Command>,
}

impl Search {
    /// Begins anew.
    pub(in crate::gui) fn begin(&mut self) {
        *self = Self::default();
    }
}
