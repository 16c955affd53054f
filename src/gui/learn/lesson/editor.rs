//! The texts of a step and of the lesson beside their preview, and the order of the steps. The user writes a lesson of
//! their own in the place in which it's played.

use eframe::egui::{Button, Id, RichText, Ui};

use super::quantity_menu::name_with_numbers;
use super::writing::{FIELDS_OF_STEP, Fields, Writing};
use crate::figure::{Figure, FigureError};
use crate::gui::kit::{Explained, TextField, number_field};
use crate::gui::learn::Learn;
use crate::gui::learn::lesson::writing::StepChange;
use crate::inspect::Report;
use crate::lessons::TaskKind;
use crate::limits::{MAX_TITLE, MAX_TYPED};
use camera_lab_desk::{Action, Intent, Model};
use camera_lab_words::learn::lesson_tasks;
use camera_lab_words::learn::lessons::Texts;
use camera_lab_words::{Lang, messages, told_mut};

/// Seconds without a key after which the text is written to the file.
const PAUSE: f64 = 1.0;

/// One line: changes of the steps.
pub(super) fn tools(ui: &mut Ui, t: &Texts, model: &mut Model, learn: &mut Learn) {
    let Some(playing) = learn.lesson.as_ref() else { return };
    let Some(writing) = &playing.writing else { return };
    let (step, count) = (playing.step, playing.lesson.steps.len());
    let (is_ahead, has_no_task) = (writing.is_ahead(), writing.typed.task.kind == TaskKind::None);
    let is_unfinished = writing.shows == Fields::Task && writing.typed.task.is_unfinished();
    let fault = writing.fault.as_ref().map(|fault| in_words(t, fault));
    let task = lesson_tasks::texts(t.lang);
    let (mut change, mut asks) = (None, false);
    ui.horizontal_wrapped(|ui| {
        use StepChange::{Another, Earlier, Later, Remove, Screen};
        for (name, hint, is_possible, what) in [
            (t.step_earlier, t.step_earlier_hint, step > 0, Earlier),
            (t.step_later, t.step_later_hint, step + 1 < count, Later),
            (t.step_screen, t.step_screen_hint, true, Screen),
            (t.step_another, t.step_another_hint, true, Another),
            (t.step_remove, t.step_remove_hint, count > 1, Remove),
        ] {
            if ui.add_enabled(is_possible, Button::new(name)).explained(hint).clicked() {
                change = Some(what);
            }
        }
        ui.separator();
        let button = ui.add_enabled(has_no_task, Button::new(task.new_question));
        asks = button.explained(task.new_question_hint).explained_disabled(task.has_task).clicked();
        ui.separator();
        if ui.button(t.read_again).explained(t.read_again_hint).clicked() {
            model.request(Action::Begin(Intent::ReadLesson));
        }
        ui.label(RichText::new(if is_ahead { t.not_kept } else { t.is_kept }).small().weak());
    });
    let mut forgets = false;
    // Above the fields, which scroll. Its room is there before it comes, so that no field moves under the pointer.
    ui.horizontal_wrapped(|ui| {
        ui.set_min_height(ui.spacing().interact_size.y);
        if let Some(fault) = fault {
            forgets = ui.button(t.forget_typed).explained(t.forget_typed_hint).clicked();
            let text = if is_unfinished { t.unfinished.to_owned() } else { format!("{}: {fault}", t.not_written) };
            let visuals = ui.visuals();
            let color = if is_unfinished { visuals.weak_text_color() } else { visuals.error_fg_color };
            ui.label(RichText::new(text).color(color));
        }
    });
    if forgets {
        return learn.forget_text();
    }
    if let Some(change) = change {
        learn.change_steps(model, change);
    }
    if asks {
        let now = ui.input(|input| input.time);
        let writing = learn.lesson.as_mut().and_then(|playing| playing.writing.as_mut());
        if let Some(writing) = writing {
            writing.shows = Fields::Task;
            writing.typed.task = std::mem::take(&mut writing.typed.task).with_kind(TaskKind::Choices);
            number_field::take_keyboard(ui.ctx(), task.question_field);
        }
        learn.text_edited(now);
    }
}

/// The reason why a text can't be written, with the name of its field in place of the key.
fn in_words(t: &Texts, fault: &FigureError) -> String {
    let field = match fault.key.as_str() {
        "[[step]] title" => t.step_title_field,
        "[[step]] text" => t.step_text_field,
        "[[step]] notes" => t.notes_command,
        "title" => t.lesson_title_field,
        "sentence" => t.lesson_sentence_field,
        "minutes" => t.lesson_minutes_field,
        _ => return messages::without_line(t.lang, fault),
    };
    // The name of a field, without what it explains.
    let key = format!("“{}”", field.split(" (").next().unwrap_or(field));
    messages::without_line(t.lang, &FigureError { key, ..fault.clone() })
}

/// The fields of the step, of its task, or of the whole lesson.
pub(super) fn fields(ui: &mut Ui, t: &Texts, model: &mut Model, learn: &mut Learn) {
    let (lang, now) = (model.settings.lang, ui.input(|input| input.time));
    let Some(playing) = learn.lesson.as_mut() else { return };
    // A task asks about the figure of its step, even while the author tries another camera.
    let figure = playing.now().map(|step| step.figure.clone());
    let Some(writing) = &mut playing.writing else { return };
    ui.horizontal_wrapped(|ui| {
        for of in Lang::ALL {
            ui.selectable_value(&mut writing.lang, of, of.name());
        }
        ui.separator();
        let task = lesson_tasks::texts(lang);
        for (fields, name, hint) in [
            (Fields::Step, t.of_step, t.of_step_hint),
            (Fields::Task, task.task, task.task_hint),
            (Fields::Lesson, t.of_lesson, t.of_lesson_hint),
        ] {
            ui.selectable_value(&mut writing.shows, fields, name).explained(hint);
        }
    });
    let before = writing.typed.clone();
    let report = figure.as_ref().and_then(|figure| crate::lessons::numbers_of(figure).ok());
    let subject = figure.as_deref().zip(report.as_ref());
    let is_left = if writing.shows == Fields::Task {
        super::task_fields::show(ui, &mut writing.typed.task, (lang, writing.lang), subject)
    } else {
        words(ui, t, writing, subject)
    };
    let is_typed = writing.typed != before;
    let waits = writing.has_valid_text() && now - writing.typed_at > PAUSE;
    if is_typed {
        learn.text_edited(now);
        ui.ctx().request_repaint_after(std::time::Duration::from_secs_f64(PAUSE + 0.1));
    } else if waits || is_left {
        learn.save_valid_text(model);
    }
}

/// Texts of the step or of the lesson. Returns true if one of the fields has lost the focus.
fn words(ui: &mut Ui, t: &Texts, writing: &mut Writing, subject: Option<(&Figure, &Report)>) -> bool {
    let (of, width) = (writing.lang, ui.available_width());
    // As many rows in both, so that the choice doesn't move under the pointer.
    let (first, names) = if writing.shows == Fields::Lesson {
        (FIELDS_OF_STEP, [(t.lesson_title_field, 1), (t.lesson_sentence_field, 6), (t.lesson_minutes_field, 1)])
    } else {
        (0, [(t.step_title_field, 1), (t.step_text_field, 5), (t.notes_command, 2)])
    };
    let mut is_left = false;
    for ((k, told), (name, rows)) in writing.typed.words.iter_mut().enumerate().skip(first).zip(names) {
        let text = told_mut(if name == t.lesson_minutes_field { Lang::En } else { of }, told);
        let id = Id::unique(("text of a step", k, of));
        let subject = subject.filter(|_| (1..FIELDS_OF_STEP).contains(&k));
        let label = name_with_numbers(ui, lesson_tasks::texts(t.lang), name, subject, (id, text));
        let field = if rows == 1 { TextField::line(text, MAX_TITLE) } else { TextField::lines(text, MAX_TYPED) };
        let response = field.with(|edit| edit.id(id).desired_width(width).desired_rows(rows)).show(ui, t.lang);
        is_left |= response.labelled_by(label.id).lost_focus();
    }
    is_left
}
