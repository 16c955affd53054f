//! Widgets without state of the application: fields, formulas, text, tooltips, plots, the theme.

/// A font of the window. A page downloads the same outlines with fewer characters, and without instructions for
/// hinting (`dist/web/fonts.sh`).
macro_rules! font {
    ($name:literal) => {{
        #[cfg(not(target_arch = "wasm32"))]
        let bytes = include_bytes!(concat!("../../../assets/fonts/", $name));
        #[cfg(target_arch = "wasm32")]
        let bytes = include_bytes!(concat!("../../../assets/fonts/page/", $name));
        bytes
    }};
}

pub(super) mod context_help;
pub(super) mod dialog_buttons;
pub(super) mod elide;
pub(super) mod focus;
pub(super) mod form;
pub(in crate::gui) mod handheld;
pub mod keys;
pub(super) mod mathematics;
pub mod number_field;
pub(super) mod plotting;
pub(super) mod prose;
pub(super) mod text_field;
pub mod theme;
pub(super) mod tooltip;

pub(in crate::gui) use context_help::{has_focus, help_topic, help_topic_row};
pub(in crate::gui) use dialog_buttons::{CANCEL, Pressed, buttons};
use eframe::egui;
pub(in crate::gui) use focus::{Focus, Region, at_right, keep_in_sight, with_room_before};
pub(in crate::gui) use form::{
    TEXT_LINE, VectorField, alternatives, choice, choice_row, complain, complaint, erratum, kept_section, more, row,
    section, toggle,
};
pub(in crate::gui) use handheld::is_handheld;
pub(in crate::gui) use keys::{Command, written};
pub(in crate::gui) use mathematics::{Both, Formula, Links, brackets, chain};
pub(in crate::gui) use number_field::{FieldError, FieldOutput, NumberField, Step, whole};
pub(in crate::gui) use plotting::{color_of, export_button, linear_x, logarithmic_x, logarithmic_y, still};
pub(in crate::gui) use text_field::{KeptLine, TextField};
pub(in crate::gui) use tooltip::Explained;

use camera_lab_desk::Wake;

/// A window that can be asked for another frame.
#[derive(Clone, Debug)]
pub struct Frames(egui::Context);

/// The window of a context.
pub fn frames(ctx: &egui::Context) -> Frames {
    Frames(ctx.clone())
}

impl Wake for Frames {
    fn wake_after(&self, time: std::time::Duration) {
        self.0.request_repaint_after(time);
    }

    fn handle(&self) -> Box<dyn Wake> {
        Box::new(self.clone())
    }
}
