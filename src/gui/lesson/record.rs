//! Adding a step to a lesson of the user's own.

use std::path::Path;

use eframe::egui::Context;

use crate::figure::{Figure, Screen};
use crate::files::{self, FileError};
use crate::gui::file_flow;
use crate::gui::state::{Agreed, Message, Purpose, State};
use crate::i18n::lessons as words;
use crate::lessons::with_step;
use crate::views::View;

/// Adds what is on the screen to the lesson to which steps were added last; without one, asks for a file.
pub(in crate::gui) fn record(state: &mut State, ctx: &Context) {
    match state.lesson_file.clone() {
        Some(path) => add_step(state, &path, &Agreed::default()),
        None => file_flow::ask(ctx, state, Purpose::Step),
    }
}

/// Adds what is on the screen to the lesson in a file, which is made where it is missing.
pub(in crate::gui) fn add_step(state: &mut State, path: &Path, agreed: &Agreed) {
    match added(state, path, agreed) {
        Ok(number) => {
            state.lesson_file = Some(path.to_owned());
            state.say(Message::StepAdded(path.to_owned(), number));
        }
        Err(error) => state.say(Message::File(path.to_owned(), error)),
    }
}

fn added(state: &mut State, path: &Path, agreed: &Agreed) -> Result<usize, FileError> {
    let (text, number) = if files::disk::exists(path) {
        let (lesson, text) = files::read_lesson(path)?;
        (text, lesson.steps.len() + 1)
    } else {
        (String::new(), 1)
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let figure = as_shown(state);
    let (text, _) = with_step(&text, &stem, &words::draft(number), &figure)?;
    files::save(path, text.as_bytes(), agreed.overwrite())?;
    Ok(number)
}

/// The figure with all that the window shows of it, and how it shows it.
fn as_shown(state: &mut State) -> Figure {
    let seen = state.as_seen();
    let panel = state.settings.panels().is_shown(crate::gui::state::Side::Explain).then(|| state.explain.shown());
    let pictures = View::ALL.map(|view| state.layout.is_shown(view));
    let figure = state.document.figure();
    let screen = Screen {
        pictures: Some(pictures),
        panel: Some(panel),
        arrangement: Some(state.layout.arrangement),
        ..figure.screen
    };
    Figure { observers: seen.observers, show: seen.show, screen, ..figure.clone() }
}
