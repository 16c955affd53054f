//! The search for anything in the window.

/// The words of the search, and its results.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// The typed words.
    pub wanted: String,
    /// The place of the result that Enter opens.
    pub chosen: usize,
}

impl Search {
    /// Starts again.
    pub(in crate::gui) fn begin(&mut self) {
        *self = Self::default();
    }
}
