//! Notices about windows that did not close and about the storage of this one. Each line stays until the user closes
//! it, or until it no longer holds.

use eframe::egui::{self, Label, RichText};

use crate::gui::files::questions::FileFlow;
use crate::gui::kit::focus::with_room_before;
use crate::gui::model::Model;
use crate::gui::model::message::about_session;
use crate::gui::storage::session::News;
use crate::i18n::window;

/// Shows the lines, where there are any.
pub fn bar(ui: &mut egui::Ui, model: &mut Model, file_flow: &mut FileFlow) {
    if file_flow.news.is_empty() {
        return;
    }
    let lang = model.settings.lang;
    let t = window::texts(lang);
    let mut closed = None;
    egui::Panel::top("session news").show(ui, |ui| {
        for (index, news) in file_flow.news.iter().enumerate() {
            ui.push_id(index, |ui| {
                // A row has its own height: all that the panel had before would make it grow with each frame.
                ui.horizontal(|ui| {
                    let line = |ui: &mut egui::Ui| {
                        ui.add(Label::new(text(ui, about_session(lang, news), news)).truncate());
                    };
                    with_room_before(ui, line, |ui| {
                        if ui.button(t.close).clicked() {
                            closed = Some(index);
                        }
                    });
                });
            });
        }
    });
    if let Some(index) = closed {
        file_flow.news.close(index);
    }
}

/// A line, marked where something has gone wrong.
fn text(ui: &egui::Ui, text: String, news: &News) -> RichText {
    match news {
        News::Restored => RichText::new(text),
        News::RestoredInPart(..)
        | News::Damaged(_)
        | News::Unusable(..)
        | News::Taken
        | News::NoSlot
        | News::PreferencesSetAside(_)
        | News::ProgressSetAside(_)
        | News::NotKept(_)
        | News::NoHome => RichText::new(format!("⚠ {text}")).color(ui.visuals().warn_fg_color),
    }
}
