//! Annotations of a lecturer over the pictures: they belong to the moment, not to the figure.

use eframe::egui::Pos2;

/// The annotations over the pictures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotations {
    /// The pointer draws.
    pub pen: bool,
    /// The strokes of the pen, in points of the window.
    pub strokes: Vec<Vec<Pos2>>,
    /// A spot shows where the pointer is.
    pub spot: bool,
    /// The pictures stay as they are while one edits.
    pub frozen: bool,
    /// The screen is black.
    pub blank: bool,
    /// When the keys of a presentation were shown, in seconds; `None`: they are not.
    pub keys_since: Option<f64>,
}

impl Annotations {
    /// True where there is something that [`clear`](Self::clear) takes away.
    #[must_use]
    pub fn any(&self) -> bool {
        self.pen || self.spot || self.frozen || self.blank || !self.strokes.is_empty()
    }

    /// Takes everything away; the keys that are shown stay.
    pub fn clear(&mut self) {
        *self = Self { keys_since: self.keys_since, ..Self::default() };
    }
}
