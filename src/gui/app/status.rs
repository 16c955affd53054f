//! The last message: news in the bar at the top, errors in full at the bottom until they are closed.

use eframe::egui::{self, Align, Align2, Button, Id, Label, Layout, Rect, RichText, TextStyle};

use crate::gui::app::file_flow;
use crate::gui::app::file_flow::questions::FileFlow;
use crate::gui::kit::{Explained, elide, form, with_room_before};
use camera_lab_desk::{Intent, Message, Model};
use camera_lab_words::window;

/// True in the data of a frame if its bar hasn't shown the whole message.
fn is_cut() -> Id {
    Id::unique("news that are cut")
}

/// The latest message, shortened to the available room.
pub fn news(ui: &mut egui::Ui, model: &Model) {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        if let Some(message) = model.message.as_ref().filter(|message| !message.is_error()) {
            let text = message.text(model.settings.lang);
            let (font, room) = (TextStyle::Body.resolve(ui.style()), ui.available_width());
            let said = elide::parts(&text, |text| elide::width(ui, &font, text) <= room);
            ui.data_mut(|data| data.insert_temp(is_cut(), said != text));
            let said = RichText::new(said);
            // A task for the user isn't news that can be missed.
            let said = if matches!(message, Message::TaskFirst) { said.strong() } else { said.weak() };
            let label = Label::new(said).truncate().show_tooltip_when_elided(false);
            form::announced(&ui.add(label).explained(text));
        }
    });
}

/// The latest message over the titles of the pictures in `room`, if no bar has shown it whole. There it covers no
/// label.
pub fn toast(ctx: &egui::Context, model: &Model, room: Rect) {
    let is_cut = ctx.data_mut(|data| data.remove_temp(is_cut()));
    let message = model.message.as_ref().filter(|message| !message.is_error());
    let Some(message) = message.filter(|_| is_cut.unwrap_or(model.settings.presentation)) else { return };
    let area = egui::Area::new(Id::unique("news")).order(egui::Order::Middle).interactable(false);
    area.fixed_pos(room.center_top()).pivot(Align2::CENTER_TOP).show(ctx, |ui| {
        egui::Frame::popup(ui.style()).inner_margin(egui::vec2(8.0, 2.0)).show(ui, |ui| {
            ui.set_max_width((room.width() - 30.0).max(100.0));
            ui.label(message.text(model.settings.lang));
        });
    });
}

/// The error, with a button that closes it.
pub fn error(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let Some(message) = model.message.as_ref().filter(|message| message.is_error()) else { return };
    let mut closed = false;
    egui::Panel::bottom("error").show(ui, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            closed = ui.add(Button::new("✕")).explained(t.close).accessible_name(t.close).clicked();
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                form::complaint(ui, &message.text(model.settings.lang));
            });
        });
    });
    if closed {
        model.message = None;
    }
}

/// The bar about a change of the figure's file by another program, until the user has decided. Returns
/// what the user wants.
pub fn changed_file(ui: &mut egui::Ui, model: &Model, file_flow: &mut FileFlow) -> Option<Intent> {
    let t = window::texts(model.settings.lang);
    let document = &model.desk.shown;
    let (theirs, name) = (file_flow.watch.theirs(document).cloned()?, document.name()?);
    let mut wanted = None;
    let changed = document.is_changed();
    egui::Panel::top("changed file").show(ui, |ui| {
        let text = if changed { t.file_changed_unsaved } else { t.file_changed };
        let text = format!("⚠ {} {text}", crate::sanitize::escaped(&name));
        let color = ui.visuals().warn_fg_color;
        let told = |ui: &mut egui::Ui| {
            ui.add(Label::new(RichText::new(&text).color(color)).truncate());
        };
        ui.horizontal(|ui| {
            with_room_before(ui, told, |ui| {
                if changed && ui.button(t.compare).explained(t.compare_hint).clicked() {
                    file_flow::ask_about(file_flow, theirs);
                } else if !changed && ui.button(t.reload).explained(t.reload_hint).clicked() {
                    wanted = Some(Intent::Reload);
                }
                if ui.button(t.keep_mine).explained(t.keep_mine_hint).clicked() {
                    file_flow.watch.keep_mine();
                }
            });
        });
    });
    wanted
}
