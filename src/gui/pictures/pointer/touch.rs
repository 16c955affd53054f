//! Two fingers on a picture. It moves with them, and grows with their distance. One finger is a pointer.

use eframe::egui::Ui;

use crate::gui::pictures::arrange::orbit;
use crate::gui::pictures::{Canvas, Pane};
use crate::views::View;
use camera_lab_desk::Model;

impl Canvas {
    /// Lets two fingers move and zoom a three-dimensional picture. True while they are on it. Takes back the action
    /// that the first finger had begun before the second came, because it wasn't meant.
    pub(in crate::gui::pictures) fn fingers(&mut self, ui: &Ui, model: &mut Model, pane: &Pane) -> bool {
        let touch = ui.input(|input| input.multi_touch());
        let Some(touch) = touch.filter(|touch| pane.rect.rect.contains(touch.start_pos)) else { return false };
        if self.drag.is_some() {
            self.give_up(model);
        }
        let moved = pane.rect.pixel(touch.center_pos) - pane.rect.pixel(touch.center_pos - touch.translation_delta);
        if pane.view != View::Image
            && let Some(seen) = self.seen(pane.picture)
        {
            let at = pane.rect.pixel(touch.center_pos);
            let moved = seen.pan(moved.x, moved.y, pane.rect.size.smaller_side());
            let observer = orbit::zoomed_at(moved, f64::from(touch.zoom_delta), at, pane.rect.size);
            if observer != seen {
                self.turn(model, pane.picture, observer);
            }
        }
        true
    }
}
