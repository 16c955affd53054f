//! The folder of a lecturer's own exercises: open, read again, close, and the faults of its files.

use eframe::egui::{CollapsingHeader, RichText, Ui};

use crate::gui::kit::{Explained, complaint};
use crate::gui::learn::Learn;
use crate::sanitize;
use camera_lab_desk::{Action, FileFor, Model};
use camera_lab_words::learn::exercise_window::Texts;
use camera_lab_words::messages;

/// The part below the list.
pub(super) fn ui(ui: &mut Ui, t: &'static Texts, model: &mut Model, learn: &mut Learn) {
    if cfg!(target_arch = "wasm32") || model.in_browser {
        return;
    }
    ui.add_space(6.0);
    if let Some(own) = learn.exercises.own.clone() {
        match &own.found {
            Ok(found) if found.entries.is_empty() && found.faults.is_empty() => {
                ui.label(format!("{}: {}", sanitize::path(&own.folder), t.own_none));
            }
            Ok(found) if found.faults.is_empty() => {}
            // A folder may hold many other files, so they are one line until the user opens it.
            Ok(found) => {
                let text = format!("{}: {}", t.own_passed_over, found.faults.len());
                let heading = CollapsingHeader::new(RichText::new(text).weak()).id_salt("files that are no exercises");
                heading.show(ui, |ui| {
                    for camera_lab_files::BadExercise { path, error, .. } in &found.faults {
                        complaint(ui, &sanitize::printable(&messages::file(t.lang, &sanitize::path(path), error)));
                    }
                });
            }
            Err(error) => {
                complaint(ui, &sanitize::printable(&messages::file(t.lang, &sanitize::path(&own.folder), error)));
            }
        }
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button(t.own_open).explained(t.own_open_hint).clicked() {
            model.request(Action::File(FileFor::Exercises));
        }
        let Some(own) = learn.exercises.own.clone() else { return };
        if ui.button(t.own_again).explained(t.own_again_hint).clicked() {
            learn.exercises.look_into(Some(own.folder.clone()));
        }
        if ui.button(t.own_close).explained(t.own_close_hint).clicked() {
            learn.exercises.look_into(None);
        }
    });
}
