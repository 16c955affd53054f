//! Named sizes of pictures for paper and slides.

crate::listed! {
    /// An intended place for a picture.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum PaperPreset {
        /// A column of a two-column page, as in the journals of the IEEE: 8.8 cm.
        Column = "ieee",
        /// The text of an A4 page with margins of 2.5 cm: 16 cm.
        A4 = "a4",
        /// A slide of 16 by 9, in the size of presentation programs: 33.867 cm by 19.05 cm.
        Slide = "slide",
        /// A square as wide as a column.
        Square = "square",
    }
    /// Its name on the command line and in preferences.
    pub fn name
}

impl PaperPreset {
    /// Width in centimetres, and height if it doesn't follow from the picture.
    pub const fn size(self) -> (f64, Option<f64>) {
        match self {
            Self::Column => (8.8, None),
            Self::A4 => (16.0, None),
            Self::Slide => (33.867, Some(19.05)),
            Self::Square => (8.8, Some(8.8)),
        }
    }

    /// The height of letters to match its text, in points.
    pub const fn letters(self) -> f64 {
        match self {
            Self::Column | Self::Square => 8.0,
            Self::A4 => 9.0,
            Self::Slide => 18.0,
        }
    }
}
