//! The notes of the speaker, in a window of their own. The class sees the pictures, and the speaker reads the notes.

use eframe::egui::{
    self, Button, CollapsingHeader, Context, Key, Modifiers, RichText, ScrollArea, ViewportBuilder, ViewportId, vec2,
};

use crate::gui::kit::{Command, Explained, at_right, prose};
use crate::gui::learn::Learn;
use crate::gui::learn::lesson::state::Playing;
use crate::lessons::{self, Task};
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercise_sheet, exercises, lessons as words};
use camera_lab_words::told;

/// The initial size of the window, in points.
const SIZE: [f32; 2] = [520.0, 460.0];

/// True if the notes are below the views. In a page of a browser that's their only place. In a presentation the class
/// sees them there, so they come only if the lecturer asks for them, and their window stays as it is.
pub(super) fn are_below(ctx: &Context, model: &Model, playing: &Playing) -> bool {
    let presents = model.settings.presentation;
    playing.has_notes(presents) && (presents || ctx.embed_viewports())
}

/// Shows the window of the notes, if wanted. Returns a command to perform.
pub(in crate::gui) fn window(ctx: &Context, model: &Model, learn: &mut Learn) -> Option<Command> {
    let is_wanted = learn.lesson.as_ref().is_some_and(|playing| playing.shows_notes);
    if !is_wanted || ctx.embed_viewports() {
        return None;
    }
    let t = words::texts(model.settings.lang);
    let mut builder = ViewportBuilder::default().with_title(t.notes_command).with_inner_size(SIZE);
    if let Some(Some(corner)) = learn.other_screen {
        builder = builder.with_position(corner + vec2(60.0, 60.0));
    }
    let id = ViewportId::from_hash_of("notes of the speaker");
    let (command, is_closed) = ctx.show_viewport_immediate(id, builder, |ui, _| {
        let mut command = keys(ui.ctx());
        egui::CentralPanel::default().show(ui, |ui| {
            command = shown(ui, t, model, learn).or(command);
        });
        (command, ui.input(|input| input.viewport().close_requested()))
    });
    if let Some(playing) = learn.lesson.as_mut().filter(|_| is_closed) {
        playing.shows_notes = false;
    }
    command
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

/// Number and title of the step, a clock, its notes, its question with the answer, its text, the plan of the lesson,
/// and the title of the next step.
fn shown(ui: &mut egui::Ui, t: &words::Texts, model: &Model, learn: &Learn) -> Option<Command> {
    let lang = t.lang;
    let playing = learn.lesson.as_ref()?;
    let step = playing.now()?;
    // The numbers of the figure on the screen.
    let report = lessons::numbers_of(model.desk.shown.figure()).or_else(|_| lessons::numbers_of(&step.figure)).ok();
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
        at_right(ui, |ui| clock(ui, t));
    });
    ui.separator();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        match &step.notes {
            Some(notes) => prose::show(ui, filled(notes).trim()),
            None => drop(ui.weak(t.no_notes)),
        }
        if let Some(Task::Question(entry)) = &step.task {
            ui.separator();
            ui.weak(t.question_command);
            let exercise = entry.exercise(0, &Default::default());
            for ask in &exercise.asks {
                prose::show(ui, &exercises::ask(lang, &exercise, ask));
                ui.label(format!("→ {}", exercise_sheet::answer(lang, ask)));
            }
        }
        ui.separator();
        ui.weak(t.text_command);
        prose::show(ui, filled(&step.text).trim());
        if let Some(plan) = &playing.lesson.plan {
            ui.separator();
            // Before the first step it's read whole, and looked up later.
            CollapsingHeader::new(t.plan).default_open(playing.step == 0).show(ui, |ui| {
                prose::show(ui, told(lang, plan).trim());
            });
        }
        if let Some(next) = playing.lesson.steps.get(playing.step + 1) {
            ui.separator();
            ui.weak(format!("{}: {}", t.comes_next, told(lang, &next.title)));
        }
    });
    command
}

/// The minutes and seconds since the notes were opened.
fn clock(ui: &mut egui::Ui, t: &words::Texts) {
    let (now, id) = (ui.input(|input| input.time), egui::Id::unique("clock of the speaker"));
    let since = ui.data_mut(|data| *data.get_temp_mut_or_insert_with(id, || now));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "seconds of a lecture")]
    let seconds = (now - since).max(0.0) as u64;
    ui.monospace(format!("{}:{:02}", seconds / 60, seconds % 60)).explained(t.clock_hint);
    ui.ctx().request_repaint_after_secs(1.0);
}
