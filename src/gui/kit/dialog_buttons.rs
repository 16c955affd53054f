//! The buttons below a question.

use eframe::egui;

use crate::gui::app::focus::at_right;

/// The button pressed in a question.
pub(in crate::gui) enum Pressed {
    /// The button with this number.
    Action(usize),
    /// The one that changes nothing.
    Cancel,
    /// None yet.
    Nothing,
}

/// The number of the button that changes nothing.
pub(in crate::gui) const CANCEL: usize = usize::MAX;

/// Buttons at the lower right, the one that is most wanted last. `focus` is the one that Enter presses.
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
            let mut button = egui::Button::new(*action).min_size(size);
            if index + 1 == actions.len() {
                button = button.fill(ui.visuals().selection.bg_fill);
            }
            let response = ui.add(button);
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
