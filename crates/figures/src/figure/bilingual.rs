//! A text of a file in both languages.

/// A text in both languages.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Bilingual {
    /// In English.
    pub en: String,
    /// In Portuguese.
    pub pt_br: String,
}

impl From<[String; 2]> for Bilingual {
    fn from([en, pt_br]: [String; 2]) -> Self {
        Self { en, pt_br }
    }
}
