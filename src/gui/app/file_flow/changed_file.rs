//! The bar about a change of the figure's file by another program, until the user has decided.

use eframe::egui::{self, Label, RichText};

use crate::gui::app::file_flow;
use crate::gui::app::state::State;
use crate::gui::kit::{Explained, with_room_before};
use crate::sanitize;
use camera_lab_desk::Intent;
use camera_lab_words::window;

/// Shows the bar, if there is something to report.
pub(crate) fn bar(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.model.settings.lang);
    let document = &state.model.desk.shown;
    let (Some(theirs), Some(name)) = (state.file_flow.watch.theirs(document).cloned(), document.name()) else { return };
    let changed = document.is_changed();
    egui::Panel::top("changed file").show(ui, |ui| {
        let text = if changed { t.file_changed_unsaved } else { t.file_changed };
        let text = format!("⚠ {} {text}", sanitize::escaped(&name));
        let color = ui.visuals().warn_fg_color;
        let told = |ui: &mut egui::Ui| {
            ui.add(Label::new(RichText::new(&text).color(color)).truncate());
        };
        ui.horizontal(|ui| {
            with_room_before(ui, told, |ui| {
                if changed && ui.button(t.compare).explained(t.compare_hint).clicked() {
                    file_flow::ask_about(&mut state.file_flow, theirs);
                } else if !changed && ui.button(t.reload).explained(t.reload_hint).clicked() {
                    file_flow::begin(ui.ctx(), state, Intent::Reload);
                }
                if ui.button(t.keep_mine).explained(t.keep_mine_hint).clicked() {
                    state.file_flow.watch.keep_mine();
                }
            });
        });
    });
}
