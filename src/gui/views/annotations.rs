//! Annotations of a lecturer over the pictures, which aren't part of the figure. Strokes of the pen come back with
//! their figure.

use eframe::egui::Pos2;

use camera_lab_desk::Source;

/// The annotations over the pictures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotations {
    /// The pointer draws.
    pub pen: bool,
    /// The strokes of the pen, in points of the window.
    pub strokes: Vec<Vec<Pos2>>,
    /// The strokes over other figures of a lecture, by the sources of those.
    others: Vec<(Option<Source>, Vec<Vec<Pos2>>)>,
    /// True if a spot marks the pointer.
    pub spot: bool,
    /// True if the pictures stay the same during edits.
    pub frozen: bool,
    /// The screen is black.
    pub blank: bool,
    /// When the keys of a presentation were shown, in seconds. `None` if they aren't.
    pub keys_since: Option<f64>,
}

impl Annotations {
    /// True if [`clear`](Self::clear) has something to remove.
    pub fn any(&self) -> bool {
        self.pen || self.spot || self.frozen || self.blank || !self.strokes.is_empty()
    }

    /// Removes everything from this figure. Displayed keys stay.
    pub fn clear(&mut self) {
        *self = Self { keys_since: self.keys_since, others: std::mem::take(&mut self.others), ..Self::default() };
    }

    /// Goes from one figure to another. The strokes of each stay with it.
    pub(in crate::gui) fn turn_page(&mut self, from: Option<Source>, to: Option<&Source>) {
        let left = std::mem::take(&mut self.strokes);
        if !left.is_empty() {
            self.others.push((from, left));
        }
        if let Some(index) = self.others.iter().position(|(source, _)| source.as_ref() == to) {
            self.strokes = self.others.swap_remove(index).1;
        }
        self.blank = false;
    }
}
