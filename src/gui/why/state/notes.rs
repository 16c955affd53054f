//! The notes in the window.

/// The search text, and the displayed note.
#[derive(Clone, Debug, Default)]
pub struct Notes {
    /// The search text.
    pub wanted: String,
    /// The identifier of the displayed note. Empty for the first one.
    pub chosen: &'static str,
    /// The notes displayed before it, the last one at the end.
    pub(in crate::gui) before: Vec<&'static str>,
    /// True if the displayed note takes the keyboard in its list, and is scrolled into sight there.
    pub(in crate::gui) wants_focus: bool,
}

/// The longest way back.
const LONGEST_WAY: usize = 32;

impl Notes {
    /// Reads a note.
    pub(in crate::gui) fn read(&mut self, id: &'static str) {
        if id == self.chosen {
            return;
        }
        if !self.chosen.is_empty() {
            if self.before.len() == LONGEST_WAY {
                self.before.remove(0);
            }
            self.before.push(self.chosen);
        }
        self.chosen = id;
    }

    /// Opens a note requested elsewhere. It takes the focus in a list of all notes.
    pub(in crate::gui) fn go_to(&mut self, id: &'static str) {
        self.read(id);
        self.wanted.clear();
        self.wants_focus = true;
    }

    /// Reads the note before this one again.
    pub(in crate::gui) fn go_back(&mut self) {
        if let Some(id) = self.before.pop() {
            self.chosen = id;
            self.wanted.clear();
            self.wants_focus = true;
        }
    }
}
