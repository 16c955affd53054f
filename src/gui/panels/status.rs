//! The line at the bottom: what was said last, and how many warnings there are.

use eframe::egui::{self, Align, Layout, RichText};

use crate::gui::state::State;
use crate::i18n::window;

/// Shows the line.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    let warnings = state.warnings();
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if !warnings.is_empty() {
                let text =
                    RichText::new(format!("⚠ {}: {}", t.warnings, warnings.len())).color(ui.visuals().warn_fg_color);
                ui.label(text).on_hover_text(warnings.join("\n"));
                ui.separator();
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let text = match &state.message {
                    Some(message) if message.is_error => {
                        RichText::new(format!("⚠ {}", message.text)).color(ui.visuals().error_fg_color)
                    }
                    Some(message) => RichText::new(&message.text),
                    None => RichText::new(t.welcome).weak(),
                };
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}
