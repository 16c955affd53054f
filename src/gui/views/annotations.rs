//! Annotations of a lecturer over the pictures, which aren't part of the figure. Strokes of the pen come back with
//! their figure.

use eframe::egui::Pos2;

use camera_lab_desk::Source;

/// A figure of a lecture by its source, or a step of a lesson.
type Page = (Option<Source>, Option<(String, usize)>);

/// The annotations over the pictures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotations {
    /// The pointer draws.
    pub pen: bool,
    /// The strokes of the pen, in points of the window.
    pub strokes: Vec<Vec<Pos2>>,
    /// The strokes over other figures of a lecture and other steps of lessons.
    others: Vec<(Page, Vec<Vec<Pos2>>)>,
    /// The step of a lesson that the strokes are over: the lesson's name and the step's place.
    step: Option<(String, usize)>,
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
        let (others, step) = (std::mem::take(&mut self.others), self.step.take());
        *self = Self { keys_since: self.keys_since, others, step, ..Self::default() };
    }

    /// Goes from one figure to another. The strokes of each stay with it.
    pub(in crate::gui) fn turn_page(&mut self, from: Option<Source>, to: Option<&Source>) {
        self.turn((from, None), &(to.cloned(), None));
    }

    /// Follows the steps of a lesson. The strokes of each stay with it.
    pub(in crate::gui) fn follow_step(&mut self, step: Option<(&str, usize)>) {
        if self.step.as_ref().map(|(lesson, step)| (lesson.as_str(), *step)) != step {
            let step = step.map(|(lesson, step)| (lesson.to_owned(), step));
            let from = std::mem::replace(&mut self.step, step.clone());
            // The figure behind the lesson is no other page of a lecture.
            let behind = || Some((String::new(), 0));
            self.turn((None, from.or_else(behind)), &(None, step.or_else(behind)));
            if self.step.is_none() {
                // The next class begins without them.
                self.others.retain(|((_, step), _)| step.is_none());
            }
        }
    }

    fn turn(&mut self, from: Page, to: &Page) {
        let left = std::mem::take(&mut self.strokes);
        if !left.is_empty() {
            self.others.push((from, left));
        }
        if let Some(index) = self.others.iter().position(|(page, _)| page == to) {
            self.strokes = self.others.swap_remove(index).1;
        }
        self.blank = false;
    }
}
