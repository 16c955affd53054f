//! The statement, its assumptions, and the figure.

use eframe::egui::{self, Align2, Button, CollapsingHeader, Image, RichText, Ui, vec2};

use super::{Sheet, figure, solution};
use crate::gui::kit::{Explained, TextField, complaint, prose};
use crate::gui::learn::{Learn, lesson_link};
use crate::lessons::{Way, lesson_of};
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercise_messages as messages, exercises as said};

/// The height of a window in which the assumptions are open from the start, in points.
const TALL: f32 = 900.0;

/// Shows the statement.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>) {
    let Sheet { t, entry, exercise } = sheet;
    ui.add(egui::Label::new(RichText::new(said::title(t.lang, entry)).heading().strong()).wrap());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        ui.label(RichText::new(entry.source).small().weak())
            .explained(camera_lab_words::why::sources::with_titles(entry.source));
        if entry.is_family {
            let seed = format!("{} {}", messages::texts(t.lang).seed, exercise.seed);
            ui.label(RichText::new(seed).small().weak()).explained(t.seed_hint);
        }
    });
    lesson(ui, model, learn, sheet);
    ui.add_space(2.0);
    prose::show(ui, &said::given(t.lang, exercise).join("\n\n"));
    solution::faulty(ui, model, learn, sheet);
    target(ui, model, sheet);
    let assumptions = said::assumptions(t.lang, exercise);
    if !assumptions.is_empty() {
        // In a low window the questions come first.
        let has_room = ui.ctx().content_rect().height() >= TALL;
        CollapsingHeader::new(t.how_it_is_read).id_salt("how it is read").default_open(has_room).show(ui, |ui| {
            // In a list, the renderer would begin a long item below its bullet.
            assumptions.iter().for_each(|text| prose::show(ui, &format!("• {text}")));
        });
    }
    free(ui, learn, sheet);
    figures(ui, model, learn, sheet);
}

/// The way to the lesson of the exercise, unless it's being played.
fn lesson(ui: &mut Ui, model: &mut Model, learn_state: &Learn, Sheet { entry, .. }: Sheet<'_>) {
    let way = lesson_of(&entry.id).filter(|_| entry.texts().is_none());
    let plays = |way: &Way| learn_state.lesson.as_ref().is_some_and(|playing| playing.lesson.id == way.lesson.id);
    if let Some(Way { lesson, step }) = way.filter(|way| !plays(way)) {
        lesson_link(ui, model, &lesson, step);
    }
}

/// The picture to match.
fn target(ui: &mut Ui, model: &Model, sheet: Sheet<'_>) {
    let Sheet { t, exercise, .. } = sheet;
    let Some(wanted) = exercise.figure_to_match() else { return };
    if let Some(texture) = figure::target(ui, wanted, (model.settings.theme, t.lang)) {
        ui.add_space(4.0);
        let name = messages::texts(t.lang).target;
        ui.label(RichText::new(name).small().weak());
        let width = ui.available_width().min(320.0);
        ui.add(Image::new(&texture).fit_to_exact_size(vec2(width, width * 0.75)).alt_text(name));
    }
}

/// Numbers that the source leaves open.
fn free(ui: &mut Ui, learn: &mut Learn, sheet: Sheet<'_>) {
    let Sheet { t, exercise, .. } = sheet;
    if exercise.free.is_empty() {
        return;
    }
    let typed = learn.exercises.typed_now();
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(t.free_numbers).small().strong());
        for (name, value) in &exercise.free {
            ui.label(*name);
            let text = typed.free.entry((*name).to_owned()).or_default();
            let field = TextField::line(text, crate::limits::MAX_EXPRESSION.0).refused_beyond().with(|edit| {
                let edit = edit.hint_text(said::number(t.lang.mark(), *value)).desired_width(56.0);
                edit.align(Align2::LEFT_CENTER).id_salt(("free", *name))
            });
            field.show(ui, t.lang).explained(t.free_hint).accessible_name(*name);
        }
    });
    let chosen = typed.chosen_numbers();
    for (name, text) in &typed.free {
        if !text.trim().is_empty() && !chosen.contains_key(name) {
            complaint(ui, &format!("{name}: {}", t.free_wrong));
        }
    }
}

/// The buttons that put figures into the pictures. Once the user has tried all of them, the answer appears too.
fn figures(ui: &mut Ui, model: &mut Model, learn: &Learn, sheet: Sheet<'_>) {
    let Sheet { t, exercise, .. } = sheet;
    let is_tried = exercise.asks.iter().all(|ask| learn.exercises.checked.contains_key(&ask.name));
    if exercise.is_told_by_figure() && !is_tried {
        ui.label(RichText::new(t.figure_later).weak());
        return;
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button(t.show_figure).explained(t.show_figure_hint).clicked() {
            model.show_figure_of_exercise(figure::given(exercise, is_tried));
        }
        if exercise.subject.operations.is_empty() {
            return;
        }
        let done = ui.add_enabled(is_tried, Button::new(t.do_operations)).explained(t.do_operations_hint);
        let done = done.explained_disabled(t.operations_later);
        if done.clicked()
            && let Ok(camera) = exercise.subject.camera()
        {
            model.show_figure_of_exercise(figure::with_camera(exercise, *camera.parameters()));
        }
    });
}
