//! What there is to say about windows that did not close and about what is kept of this one: each line stays until the user has
//! closed it, or until it is no longer so.

use eframe::egui::{self, Align, Label, Layout, RichText};

use crate::gui::session::News;
use crate::gui::state::{State, about_session};
use crate::i18n::window;

/// Shows the lines, where there are any.
pub fn bar(ui: &mut egui::Ui, state: &mut State) {
    if state.file_flow.news.is_empty() {
        return;
    }
    let lang = state.settings.lang;
    let t = window::texts(lang);
    let mut closed = None;
    egui::Panel::top("session news").show(ui, |ui| {
        for (index, news) in state.file_flow.news.iter().enumerate() {
            ui.push_id(index, |ui| {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if ui.button(t.close).clicked() {
                        closed = Some(index);
                    }
                    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                        let text = about_session(lang, news);
                        let text = match news {
                            News::Restored => RichText::new(text),
                            News::RestoredInPart(..)
                            | News::Damaged(_)
                            | News::Unreadable(..)
                            | News::Taken
                            | News::NotWritten(..)
                            | News::NoSlot
                            | News::PreferencesSetAside(_)
                            | News::PreferencesNotWritten(..)
                            | News::ProgressSetAside(_)
                            | News::ProgressNotWritten(..) => {
                                RichText::new(format!("⚠ {text}")).color(ui.visuals().warn_fg_color)
                            }
                        };
                        ui.add(Label::new(text).truncate());
                    });
                });
            });
        }
    });
    if let Some(index) = closed {
        state.file_flow.news.remove(index);
    }
}
