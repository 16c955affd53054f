//! Exercises and lessons, with what they remember.

pub mod exercises;
pub(super) mod lesson;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;

use crate::gui::model::Model;
use crate::lessons::Lesson;
use exercises::state::Exercises;
use lesson::state::Playing;

/// The exercises, the lesson that is played, and what was done of them.
#[derive(Debug, Default)]
pub struct Learn {
    /// The corner of another screen, in points, for the speaker's notes; `None` means not looked for yet, inside: none.
    pub(in crate::gui) other_screen: Option<Option<egui::Pos2>>,
    /// The exercises.
    pub exercises: Exercises,
    /// The lesson that is played.
    pub lesson: Option<Playing>,
    /// The lessons of a lecturer's folder, as they were when the list was opened.
    pub own: Vec<(PathBuf, Arc<Lesson>)>,
    /// The lesson of the user's own to which steps are added.
    pub file: Option<PathBuf>,
    /// The furthest step of each lesson that was taken, from 0, by the lesson's identifier.
    pub taken: BTreeMap<String, usize>,
    /// The steps of each lesson whose task was done, from 0: an answer of one's own, and not a way that was shown.
    pub done: BTreeMap<String, BTreeSet<usize>>,
    /// The way on from the last time is offered, in one line.
    pub goes_on: bool,
    /// The first lesson and the gallery are offered, in one line.
    pub welcome: bool,
}

impl Learn {
    /// Ends the offer of the first lesson, or of the way on.
    pub(in crate::gui) const fn take_offer(&mut self, model: &mut Model) {
        (self.welcome, self.goes_on, model.settings.welcomed) = (false, false, true);
    }
}
