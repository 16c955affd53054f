//! The quantities that open questions ask for, which the window doesn't print until they are answered or given up.

use std::sync::Arc;

use crate::exercises::{Exercise, Expected};
use crate::figure::Figure;
use crate::gui::learn::Learn;
use crate::inspect::Asked;
use crate::lessons::{self, Task};
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercises as said, lessons as words};

impl Learn {
    /// The quantities that open questions about the figure in the window ask for.
    pub(in crate::gui) fn asked(&mut self, model: &Model) -> Asked {
        let mut asked = Asked::default();
        let Some((_, exercise)) = self.exercises.exercise() else { return asked };
        let (lang, figure) = (model.settings.lang, model.desk.shown.figure());
        let playing = self.lesson.as_ref().filter(|playing| playing.writing.is_none());
        let step = playing.and_then(|playing| playing.now());
        let is_of_step =
            step.is_some_and(|step| matches!(&step.task, Some(Task::Question(entry)) if *entry.id == *exercise.id));
        if !is_of_step && !is_about(&exercise, figure, model.shows_exercises()) {
            return asked;
        }
        // The class has answered.
        let hands = playing.is_some_and(|playing| playing.hands.have_answered(playing.step));
        if is_of_step && hands {
            return asked;
        }
        let mut statement = said::statement(lang, &exercise);
        statement.extend(said::assumptions(lang, &exercise));
        if let (true, Some(step), Ok(report)) = (is_of_step, step, lessons::numbers_of(figure)) {
            statement.push(words::filled_from(lang, &step.text, &report));
        }
        statement.extend(exercise.asks.iter().map(|ask| said::ask(lang, &exercise, ask)));
        let statement = statement.join("\n");
        let shows = playing.is_some_and(|playing| playing.lesson.seen_after(playing.step).is_some());
        for ask in &exercise.asks {
            let is_right = self.exercises.is_right(ask);
            let is_given_up = self.exercises.opened.get(&ask.name).is_some_and(|opened| opened.is_at_end());
            // After the guess, the picture that answers is there to be read.
            let is_seen = is_of_step && shows && !ask.places && self.exercises.guess_at(ask).is_some();
            if !(is_right || is_given_up || is_seen) {
                ask.add_to(&mut asked, &statement);
            }
        }
        asked
    }
}

/// True if a figure is that of an exercise: its scene while the exercise is in sight, or one of its cameras.
fn is_about(exercise: &Arc<Exercise>, figure: &Figure, is_in_sight: bool) -> bool {
    let own = exercise.asks.iter().filter_map(|ask| match ask.expected() {
        Expected::Quantity(subject, _) => Some(&**subject),
        Expected::Computed(..) | Expected::Choice(..) | Expected::Camera(..) => None,
    });
    let mut subjects = own.chain([&exercise.subject]);
    is_in_sight && figure.scene == exercise.subject.figure.scene
        || subjects.any(|subject| {
            subject.figure.camera == figure.camera
                || subject.camera().is_ok_and(|camera| *camera.parameters() == figure.camera)
        })
}
