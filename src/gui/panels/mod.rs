//! The panels at the sides, and the few shapes that all of them are made of.

pub mod operations;
pub mod parameters;
pub mod status;
pub mod values;

use eframe::egui::{self, Align, CollapsingHeader, Layout, RichText};

use super::theme;

/// A group of controls under a title that opens and closes it.
pub(super) fn section(ui: &mut egui::Ui, title: &str, id: &str, open: bool, body: impl FnOnce(&mut egui::Ui)) {
    let style = ui.style().clone();
    theme::tint_header(ui);
    let title = RichText::new(title).strong().size(13.0);
    CollapsingHeader::new(title).id_salt(id).default_open(open).show_unindented(ui, |ui| {
        ui.set_style(style.clone());
        ui.add_space(1.0);
        body(ui);
        ui.add_space(4.0);
    });
    ui.set_style(style);
}

/// Height of a line that has no control in it.
pub(super) const TEXT_LINE: f32 = 16.0;

/// A symbol of the notes and its name.
pub(super) fn caption(ui: &mut egui::Ui, symbol: &str, name: &str, hint: &str) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        if !symbol.is_empty() {
            ui.label(theme::symbol(ui, symbol)).on_hover_text(hint);
        }
        ui.label(RichText::new(name)).on_hover_text(hint);
    });
}

/// A row: what it is on the left, its controls on the right, from right to left.
pub(super) fn row<R>(
    ui: &mut egui::Ui,
    symbol: &str,
    name: &str,
    hint: &str,
    controls: impl FnOnce(&mut egui::Ui) -> R,
) -> R {
    ui.horizontal(|ui| {
        caption(ui, symbol, name, hint);
        ui.with_layout(Layout::right_to_left(Align::Center), controls).inner
    })
    .inner
}

/// A choice out of few, with the name that screen readers say.
pub(super) fn choice<T: PartialEq + Copy>(
    ui: &mut egui::Ui,
    name: &str,
    hint: &str,
    value: &mut T,
    options: &[(T, &str)],
) -> bool {
    let old = *value;
    let chosen = options.iter().find(|(option, _)| *option == old).map_or("", |(_, text)| *text);
    egui::ComboBox::from_id_salt(name)
        .selected_text(chosen)
        .width(116.0)
        .show_ui(ui, |ui| {
            for (option, text) in options {
                ui.selectable_value(value, *option, *text);
            }
        })
        .response
        .on_hover_text(hint)
        .accessible_name(name);
    *value != old
}

/// A line that says what is wrong, with a sign, so that the colour is not alone.
pub(super) fn complaint(ui: &mut egui::Ui, text: &str) {
    let color = ui.visuals().error_fg_color;
    ui.add(egui::Label::new(RichText::new(format!("⚠ {text}")).color(color)).wrap());
}
