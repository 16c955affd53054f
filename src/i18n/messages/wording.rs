//! The wording of one error or warning in one language.

/// The wording of an error or a warning. Both forms come from one place, so that they agree.
pub(in crate::i18n) struct Wording {
    /// For files and options, with the keys, the value found, and the values allowed.
    pub(in crate::i18n) full: String,
    /// In the notes' symbols, as in the window's fields. The value found is in the field.
    pub(in crate::i18n) in_symbols: String,
}

impl Wording {
    pub(in crate::i18n) fn new(full: impl Into<String>, in_symbols: impl Into<String>) -> Self {
        Self { full: full.into(), in_symbols: in_symbols.into() }
    }
}
