//! What happens in a frame, in order.

use eframe::egui;

use super::canvas::Canvas;
use super::state::State;

/// The window's program.
pub struct App {
    /// What the panels and the pictures share.
    pub state: State,
    canvas: Canvas,
}

impl App {
    /// Starts from a state.
    #[must_use]
    pub fn new(state: State) -> Self {
        Self { state, canvas: Canvas::default() }
    }

    /// One frame; `ui` is the whole window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        egui::CentralPanel::no_frame().show(ui, |ui| self.canvas.ui(ui, &mut self.state));
        if ui.input(|i| !i.pointer.any_down() && i.keys_down.is_empty()) {
            self.state.document.commit();
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }
}
