//! The wording of one error or warning in one language.

/// The wording of an error or a warning. Both forms come from one place, so that they agree.
pub(crate) struct Wording {
    /// For files and options, with the keys, the value found, and the values allowed.
    pub(crate) full: String,
    /// In the notes' symbols, as in the window's fields. The value found is in the field.
    pub(crate) in_symbols: String,
}

impl Wording {
    pub(crate) fn new(full: impl Into<String>, in_symbols: impl Into<String>) -> Self {
        Self { full: full.into(), in_symbols: in_symbols.into() }
    }
}
