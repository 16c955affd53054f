//! Notices about windows that didn't close and about the storage of this one. Each line stays until the user closes it,
//! or until it no longer holds.

use eframe::egui::{self, Label, RichText};

use crate::gui::kit::with_room_before;
use crate::sanitize;
use camera_lab_desk::{Keeping, News, NewsList};
use camera_lab_words::window::{self, sessions, sharing};
use camera_lab_words::{Lang, messages};

/// Shows the lines, if there are any.
pub fn bar(ui: &mut egui::Ui, lang: Lang, list: &mut NewsList) {
    if list.is_empty() {
        return;
    }
    let t = window::texts(lang);
    let mut closed = None;
    egui::Panel::top("session news").show(ui, |ui| {
        for (index, news) in list.iter().enumerate() {
            ui.push_id(index, |ui| {
                // A row has its own height, because taking all the panel's former height would make it grow with each
                // frame.
                ui.horizontal(|ui| {
                    let line = |ui: &mut egui::Ui| {
                        ui.add(Label::new(text(ui, sentence(lang, news), news)).truncate());
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
        list.close(index);
    }
}

/// A line, marked if it reports a failure.
fn text(ui: &egui::Ui, text: String, news: &News) -> RichText {
    if matches!(news, News::Restored) {
        RichText::new(text)
    } else {
        RichText::new(format!("⚠ {text}")).color(ui.visuals().warn_fg_color)
    }
}

/// The sentence.
fn sentence(lang: Lang, news: &News) -> String {
    let t = window::texts(lang);
    match news {
        // Leaving a page isn't a failure.
        News::Restored if cfg!(target_arch = "wasm32") => sharing::texts(lang).restored.to_owned(),
        News::Restored => t.restored.to_owned(),
        News::RestoredInPart(keys, path) => {
            let keys: Vec<String> = keys.iter().map(|key| sanitize::escaped(key)).collect();
            sessions::in_part(lang, &sanitize::within(&keys.join(", "), 200), &sanitize::path(path))
        }
        News::Damaged(path) => sessions::damaged(lang, &sanitize::path(path)),
        News::Unusable(path, error) => messages::file(lang, &sanitize::path(path), error),
        News::Taken => t.taken.to_owned(),
        News::NoSlot => sessions::no_slot(lang, crate::limits::MAX_SESSIONS),
        News::PreferencesSetAside(path) => sessions::preferences_set_aside(lang, &sanitize::path(path)),
        News::ProgressSetAside(path) => sessions::progress_set_aside(lang, &sanitize::path(path)),
        News::NotKept(not_kept) => {
            let what = [Keeping::Session, Keeping::Preferences, Keeping::Progress].map(|what| not_kept.is_about(what));
            sessions::not_kept(lang, what, &messages::file(lang, &sanitize::path(&not_kept.path), &not_kept.error))
        }
        News::NoHome => sessions::no_home(lang).to_owned(),
    }
}
