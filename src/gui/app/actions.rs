//! Performs the actions that features request from each other.

use eframe::egui::Context;

use super::state::State;
use crate::gui::app::file_flow::questions::{Dialog, Purpose};
use crate::gui::app::file_flow::{ask, begin};
use crate::gui::inspector::state::compare::CompareForm;
use camera_lab_desk::{Action, Intent};

/// Performs the action that was requested in this frame, if any.
pub(super) fn perform(ctx: &Context, state: &mut State) {
    let Some(action) = state.model.frame.request.take() else { return };
    ctx.request_repaint();
    let dialog = match action {
        Action::File(file) => return ask(ctx, state, Purpose::For(file)),
        Action::Begin(next) => return begin(ctx, state, next),
        Action::Offered(open) => {
            begin(ctx, state, Intent::Lesson(open));
            // It stays if the question about changes is open.
            if state.learn.lesson.is_some() {
                state.learn.take_offer(&mut state.model);
            }
            return;
        }
        Action::Note(note) => return state.explain.explain_by_note(&mut state.model, note),
        Action::Lessons => Dialog::Lessons,
        Action::Delete { names, below } => Dialog::Delete { names, below },
        Action::DeleteProgress => Dialog::DeleteProgress,
        Action::Coach => Dialog::Coach,
        Action::Compare => Dialog::Compare(CompareForm::of(state.model.desk.shown.figure())),
    };
    state.file_flow.dialog = Some(dialog);
}
