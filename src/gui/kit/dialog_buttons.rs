//! The buttons below a question.

use eframe::egui;

use crate::gui::kit::focus::at_right;

/// The button pressed in a question.
pub(in crate::gui) enum Pressed {
    /// The button with this number.
    Action(usize),
    /// The button that changes nothing.
    Cancel,
    /// None yet.
    Nothing,
}

/// The number of the button that changes nothing.
pub(in crate::gui) const CANCEL: usize = usize::MAX;

/// Buttons at the lower right, the most likely one last. Enter presses the one at `focus`.
pub(in crate::gui) fn buttons(ui: &mut egui::Ui, cancel: &str, actions: &[&str], focus: Option<usize>) -> Pressed {
    let mut pressed = Pressed::Nothing;
    let size = egui::vec2(80.0, 26.0);
    let show = |ui: &mut egui::Ui| {
        let response = ui.add(egui::Button::new(cancel).min_size(size));
        if focus == Some(CANCEL) {
            response.request_focus();
        }
        if response.clicked() {
            pressed = Pressed::Cancel;
        }
        for (index, action) in actions.iter().enumerate() {
            // Full colour, because pale means only switched on.
            let button = if index + 1 == actions.len() {
                let text = egui::RichText::new(*action).color(ui.visuals().panel_fill);
                egui::Button::new(text).fill(ui.visuals().hyperlink_color)
            } else {
                egui::Button::new(*action)
            };
            let response = ui.add(button.min_size(size));
            if focus == Some(index) {
                response.request_focus();
            }
            if response.clicked() {
                pressed = Pressed::Action(index);
            }
        }
    };
    ui.horizontal(|ui| at_right(ui, show));
    pressed
}
