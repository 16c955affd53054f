//! The window of egui, for work that wakes it.

use std::time::Duration;

use camera_lab_desk::Wake;
use eframe::egui;

/// A window that can be asked for another frame.
#[derive(Clone, Debug)]
pub struct Frames(egui::Context);

/// The window of a context.
pub fn frames(ctx: &egui::Context) -> Frames {
    Frames(ctx.clone())
}

impl Wake for Frames {
    fn wake_after(&self, time: Duration) {
        self.0.request_repaint_after(time);
    }

    fn handle(&self) -> Box<dyn Wake> {
        Box::new(self.clone())
    }
}
