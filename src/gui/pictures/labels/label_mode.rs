//! The mode for the author's labels: the chosen label, and its typed text.

use crate::views::View;

/// The mode *Labels*.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LabelMode {
    /// The pointer chooses and drags labels.
    pub on: bool,
    /// The chosen label, and the picture in which it was chosen.
    pub chosen: Option<(View, String)>,
    /// The next click puts a note.
    pub adding: bool,
    /// The typed text of the chosen label. `None` for the figure's.
    pub typed: Option<String>,
    /// True if the text was put there just now. Its field gets the focus.
    pub is_new: bool,
    /// The field of the text has the focus.
    pub is_typing: bool,
}

impl LabelMode {
    /// Enters or leaves the mode.
    pub fn toggle(&mut self) {
        *self = Self { on: !self.on, ..Self::default() };
    }

    /// Chooses a label, or none.
    pub fn choose(&mut self, label: Option<(View, String)>) {
        if self.chosen != label {
            (self.chosen, self.typed) = (label, None);
        }
    }

    /// One thing after the other: stops adding a note, then leaves the mode.
    pub fn step_back(&mut self) {
        if self.adding {
            self.adding = false;
        } else {
            *self = Self::default();
        }
    }
}
