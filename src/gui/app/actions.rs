//! Performs, after the panels of a frame, the actions that features requested from each other.

use eframe::egui::Context;

use super::state::State;
use crate::gui::app::file_flow::questions::{Dialog, Purpose};
use crate::gui::app::file_flow::{ask, begin};
use crate::gui::inspector::state::compare::CompareForm;
use camera_lab_desk::{Action, CameraList, Intent, PhotographTool};

/// Performs the actions requested since the last call.
pub(super) fn perform(ctx: &Context, state: &mut State) {
    // One may bring others.
    while !state.model.actions.is_empty() {
        let action = state.model.actions.remove(0);
        ctx.request_repaint();
        let open = |state: &mut State, dialog| state.file_flow.dialog = Some(dialog);
        match action {
            Action::File(file) => ask(ctx, state, Purpose::For(file)),
            Action::Begin(next) => begin(ctx, state, next),
            Action::ForgetFigure => {
                (state.file_flow.theirs, state.file_flow.decided) = (None, None);
                state.cameras = CameraList::default();
                state.photograph = PhotographTool::default();
            }
            Action::Offered(open) => {
                begin(ctx, state, Intent::Lesson(open));
                // It stays if the question about changes is open.
                if state.learn.lesson.is_some() {
                    state.learn.take_offer(&mut state.model);
                }
            }
            Action::Lessons => open(state, Dialog::Lessons),
            Action::Note(note) => state.explain.explain_by_note(&mut state.model, note),
            Action::Delete { names, below } => open(state, Dialog::Delete { names, below }),
            Action::DeleteProgress => open(state, Dialog::DeleteProgress),
            Action::LookThrough(index) => state.cameras.look_through(&mut state.model, index),
            Action::PutMark(of, place) => state.learn.put_mark(&mut state.model, &of, place),
            Action::Coach => open(state, Dialog::Coach),
            Action::Compare => {
                let form = CompareForm::of(state.model.desk.shown.figure());
                open(state, Dialog::Compare(form));
            }
        }
    }
}
