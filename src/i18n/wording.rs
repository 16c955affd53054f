//! What is said of one error or warning in one language.

/// What is said of an error or a warning. Both forms are made in one place, so that they say the same.
pub(super) struct Wording {
    /// Where files and options are written: with the keys, what was found, and what is allowed.
    pub(super) full: String,
    /// In the notes' symbols, which the window's fields have: what was found stands in the field.
    pub(super) in_symbols: String,
}

impl Wording {
    pub(super) fn new(full: impl Into<String>, in_symbols: impl Into<String>) -> Self {
        Self { full: full.into(), in_symbols: in_symbols.into() }
    }
}
