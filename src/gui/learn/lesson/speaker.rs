//! The notes of the speaker, in a window of their own: the class sees the pictures, the speaker reads the notes.

use eframe::egui::{self, Button, Context, Key, Modifiers, RichText, ScrollArea, ViewportBuilder, ViewportId};

use crate::gui::app::command::Command;
use crate::gui::kit::prose;
use crate::gui::kit::tooltip::Explained;
use crate::gui::state::State;
use crate::i18n::learn::lessons as words;
use crate::i18n::told;
use crate::lessons;

/// The size of the window at first, in points.
const SIZE: [f32; 2] = [520.0, 460.0];

/// True where there can be a second window; in a page of a browser the notes are below the pictures.
pub(super) fn has_window(ctx: &Context) -> bool {
    !ctx.embed_viewports()
}

/// Shows the notes of the step, where they are wanted; gives a command that is to be done.
pub(in crate::gui) fn window(ctx: &Context, state: &mut State) -> Option<Command> {
    let is_wanted = state.lesson.as_ref().is_some_and(|playing| playing.shows_notes);
    if !is_wanted || !has_window(ctx) {
        return None;
    }
    let t = words::texts(state.settings.lang);
    let builder = ViewportBuilder::default().with_title(t.notes_command).with_inner_size(SIZE);
    let id = ViewportId::from_hash_of("notes of the speaker");
    ctx.show_viewport_immediate(id, builder, |ui, _| {
        let mut command = keys(ui.ctx());
        if ui.input(|input| input.viewport().close_requested()) {
            command = Some(Command::StepNotes);
        }
        egui::CentralPanel::default().show(ui, |ui| {
            command = shown(ui, t, state).or(command);
        });
        command
    })
}

/// The keys of a remote control turn the steps here too.
fn keys(ctx: &Context) -> Option<Command> {
    let pressed = |key| ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::PageDown) || pressed(Key::ArrowRight) {
        Some(Command::NextFigure)
    } else if pressed(Key::PageUp) || pressed(Key::ArrowLeft) {
        Some(Command::PreviousFigure)
    } else {
        None
    }
}

/// Number and title of the step, its notes, its text, and the title of the next one.
fn shown(ui: &mut egui::Ui, t: &words::Texts, state: &State) -> Option<Command> {
    let lang = t.lang;
    let playing = state.lesson.as_ref()?;
    let step = playing.now()?;
    // The numbers are those of what is on the screen.
    let report = lessons::numbers_of(state.document.figure()).or_else(|_| lessons::numbers_of(&step.figure)).ok();
    let filled =
        |text| report.as_ref().map_or_else(|| told(lang, text).to_owned(), |r| words::filled_from(lang, text, r));
    let mut command = None;
    ui.horizontal(|ui| {
        if ui.add_enabled(playing.step > 0, Button::new("◀")).explained(t.back_hint).accessible_name(t.back).clicked()
        {
            command = Some(Command::PreviousFigure);
        }
        if ui.add_enabled(!playing.is_last(), Button::new("▶")).explained(t.next_hint).accessible_name(t.next).clicked()
        {
            command = Some(Command::NextFigure);
        }
        let place = words::place(lang, playing.step + 1, playing.lesson.steps.len());
        ui.label(RichText::new(format!("{place}: {}", told(lang, &step.title))).strong());
    });
    ui.separator();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        match &step.notes {
            Some(notes) => prose::show(ui, filled(notes).trim()),
            None => drop(ui.weak(t.no_notes)),
        }
        ui.separator();
        ui.weak(t.text_command);
        prose::show(ui, filled(&step.text).trim());
        if let Some(next) = playing.lesson.steps.get(playing.step + 1) {
            ui.separator();
            ui.weak(format!("{}: {}", t.comes_next, told(lang, &next.title)));
        }
    });
    command
}
