//! Exercises and lessons, with the state that they remember.

pub mod exercises;
/// Lessons and exercises as pages to print: the choices, the pages, and the dialog.
pub mod handout {
    pub(in crate::gui) mod dialog;
    pub mod form;
    pub mod pages;
}
pub(super) mod lesson;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;
use exercises::state::Exercises;
use lesson::state::Playing;

use crate::lessons::{Lesson, Task};
use camera_lab_desk::{Action, Document, Mark, Model, Placing};
use camera_lab_words::learn::{exercise_window, lessons};

/// False in a page of a browser. It has no files, so nothing writes a lesson there, and it needn't carry the code.
pub(in crate::gui) const CAN_WRITE: bool = !cfg!(target_arch = "wasm32");

/// The exercises, the lesson being played, and the progress in them.
#[derive(Debug, Default)]
pub struct Learn {
    /// The corner of another screen, in points, for the speaker's notes. `None` if not looked for yet, and inside if
    /// there is none.
    pub(in crate::gui) other_screen: Option<Option<egui::Pos2>>,
    /// The exercises.
    pub exercises: Exercises,
    /// The lesson being played.
    pub lesson: Option<Playing>,
    /// The lessons of a lecturer's folder, as they were when the list was opened.
    pub own: Vec<(PathBuf, Arc<Lesson>)>,
    /// The lesson of the user's own to which steps are added.
    pub file: Option<PathBuf>,
    /// The ticks of the dialog that prints, and those of the last run of the program, with which it begins.
    pub ticks: Vec<String>,
    pub(in crate::gui) ticks_before: Vec<String>,
    /// The furthest step reached of each lesson, from 0, by the lesson's identifier.
    pub taken: BTreeMap<String, usize>,
    /// The steps of each lesson whose task was done, from 0, by an answer of the user's own, and not by a way that was
    /// shown.
    pub done: BTreeMap<String, BTreeSet<usize>>,
    /// The lesson of the program that was played last, and its step, from 0.
    pub stopped: Option<(String, usize)>,
    /// True if one line offers to continue from the last time.
    pub goes_on: bool,
    /// True if one line offers the first lesson and the gallery.
    pub welcome: bool,
}

/// A link to a step of a built-in lesson.
fn lesson_link(ui: &mut egui::Ui, model: &mut Model, lesson: &Arc<Lesson>, step: usize) {
    if ui.link(lessons::lesson_link(model.settings.lang, lesson, step)).clicked() {
        model.request(Action::lesson(Arc::clone(lesson), step));
    }
}

impl Learn {
    /// Ends the offer of the first lesson, or of the way on.
    pub(in crate::gui) const fn take_offer(&mut self, model: &mut Model) {
        (self.welcome, self.goes_on, model.settings.welcomed) = (false, false, true);
    }

    /// Goes on with another document, out of a lesson. See [`Model::take_over`].
    pub(in crate::gui) fn take_over(&mut self, model: &mut Model, document: Document) {
        model.desk.keep_behind();
        self.close_lesson(model);
        model.take_over(document);
    }

    /// Undoes a step, or redoes it. The figure on the screen comes first, then the lesson.
    pub fn undo(&mut self, model: &mut Model, back: bool) {
        if !model.can_undo(back) && self.can_undo_lesson(model, back) {
            return self.undo_lesson(model, back);
        }
        model.undo(back);
    }

    /// True if there is a step to undo (`back`), or to redo.
    pub(in crate::gui) fn can_undo(&self, model: &Model, back: bool) -> bool {
        model.can_undo(back) || self.can_undo_lesson(model, back)
    }

    /// The present question for a place in the image.
    pub fn placing(&mut self, model: &Model) -> Option<Placing> {
        self.placing_of_question(model).or_else(|| model.placing_of_operation())
    }

    /// Puts the mark of a question for a place there.
    pub(in crate::gui) fn put_mark(&mut self, model: &mut Model, of: &Mark, [x, y]: [f64; 2]) {
        match of {
            Mark::Operation => model.operations.predict.put_mark([x, y]),
            Mark::Ask(ask) => self.exercises.type_into(ask, vec![format!("{x}"), format!("{y}")]),
        }
    }

    /// True if the exercise of the lesson's step is open.
    pub(in crate::gui) fn works_on_step(&self) -> bool {
        let step = self.lesson.as_ref().and_then(|playing| playing.now());
        let task = step.and_then(|step| step.task.as_ref());
        let open = self.exercises.open.as_ref();
        matches!(task, Some(Task::Exercise { id, seed }) if open.is_some_and(|open| open.id == *id && open.seed == *seed))
    }

    fn placing_of_question(&mut self, model: &Model) -> Option<Placing> {
        let asks = self.lesson.as_ref().is_some_and(|playing| playing.asks_question());
        if !(asks || model.shows_exercises()) || self.moves_to_step() {
            return None;
        }
        self.exercises.placing(exercise_window::texts(model.settings.lang).place_in_image)
    }
}
