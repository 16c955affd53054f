//! Progress in exercises: its file, the frequency of mistakes, export as a table for spreadsheets, and deletion.

use eframe::egui::{self, RichText, Ui};

use crate::exercises::{Made, Mistake};
use crate::gui::kit::{Explained, KeptLine, prose, theme};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::Done;
use camera_lab_desk::{Action, FileFor, Model};
use camera_lab_words::learn::exercise_window::Texts;
use camera_lab_words::learn::{exercise_messages, exercises as said};

/// The foot of the list.
pub(super) fn ui(ui: &mut Ui, t: &'static Texts, model: &mut Model, learn: &mut Learn) {
    ui.add_space(6.0);
    ui.separator();
    egui::CollapsingHeader::new(t.progress).id_salt("progress").show(ui, |ui| {
        match &learn.exercises.file {
            Some(file) => {
                ui.label(RichText::new(t.progress_kept_in).weak());
                ui.add(
                    egui::Label::new(RichText::new(crate::sanitize::path(file)).monospace()).wrap().selectable(true),
                );
            }
            None => drop(ui.label(RichText::new(t.progress_not_kept).weak())),
        }
        ui.add_space(4.0);
        due(ui, t, learn);
        mistakes(ui, t, learn);
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            let label = ui.label(t.student);
            let old = learn.exercises.progress.student.clone().unwrap_or_default();
            let (id, most, width) =
                (ui.scope_id().with("student"), crate::limits::MAX_TYPED_NAME, ui.available_width() - 12.0);
            let field = KeptLine { id, old: &old, most, width };
            let (response, name) = field.show(ui, t.lang, |name| Ok::<_, std::convert::Infallible>(name.to_owned()));
            response.labelled_by(label.id).explained(t.student_hint);
            if let Some(Ok(name)) = name {
                learn.exercises.note(Done::Named(name));
            }
        });
        ui.horizontal_wrapped(|ui| {
            let has_some = !learn.exercises.progress.is_empty();
            let export = ui.add_enabled(has_some, egui::Button::new(t.export_progress));
            if export.explained(t.export_progress_hint).clicked() {
                model.request(Action::File(FileFor::Progress));
            }
            let has_typed = learn.exercises.typed.values().any(|typed| !typed.is_empty());
            let delete = ui.add_enabled(has_some || has_typed, egui::Button::new(format!("{}…", t.delete_progress)));
            if delete.explained(t.delete_progress_hint).clicked() {
                model.request(Action::DeleteProgress);
            }
        });
    });
}

/// The exercises that are due to come back, and how long they take.
fn due(ui: &mut Ui, t: &Texts, learn: &Learn) {
    let due = learn.exercises.progress.due(learn.exercises.entries(), crate::clock::seconds_since_1970());
    if due.is_empty() {
        ui.label(t.none_due);
        return;
    }
    let minutes: u16 = due.iter().filter_map(|entry| entry.minutes).sum();
    let titles: Vec<&str> = due.iter().map(|entry| said::title(t.lang, entry)).collect();
    theme::sentence_label(ui, &exercise_messages::due(t.lang, minutes, &titles.join(", ")));
}

/// The known mistakes, the most frequent first.
fn mistakes(ui: &mut Ui, t: &Texts, learn: &Learn) {
    let mut made: Vec<(Mistake, &Made)> = learn.exercises.progress.mistakes().collect();
    if made.is_empty() {
        ui.label(t.no_mistakes);
        return;
    }
    made.sort_by_key(|(_, made)| std::cmp::Reverse(made.times));
    ui.label(RichText::new(t.mistakes).strong());
    for (mistake, made) in made {
        ui.push_id(mistake.code(), |ui| {
            let mended = if made.is_open { String::new() } else { format!(" (✓ {})", t.mended) };
            prose::show(ui, &format!("**{} ×** {}{mended}", made.times, said::mistake(t.lang, mistake)[0]));
        });
    }
}
