//! The three pictures in the middle of the window.

use eframe::egui;

use super::state::State;

/// Draws the pictures and keeps their textures.
#[derive(Default)]
pub struct Canvas {}

impl Canvas {
    /// Fills the room that is left in `ui` with the pictures, and lets the pointer and the keys act on them.
    pub fn ui(&mut self, ui: &mut egui::Ui, _state: &mut State) {
        ui.take_available_space();
    }
}
