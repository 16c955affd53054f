//! The program: its version, its licence, and those of its components. They're built in, so a single copied file has
//! them too. Only in a browser they stand beside the program, in its page.

use eframe::egui::{RichText, ScrollArea, TextStyle, TextWrapMode, Ui};

#[cfg(target_arch = "wasm32")]
use crate::gui::app::web::third_party;
use crate::gui::kit::{CANCEL, Pressed, buttons};
use camera_lab_words::window::Texts;

/// Names and licences of all libraries, and the texts of the licences, written by `.ci/third-party`.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::unnecessary_wraps, reason = "in a page the text arrives later")]
fn third_party(_: &eframe::egui::Context) -> Option<&'static str> {
    Some(include_str!("../../../THIRD-PARTY.md"))
}

/// Shows the dialog. `first` is true when it has just been opened. False once it's closed.
pub(in crate::gui) fn show(ui: &mut Ui, t: &Texts, first: bool) -> bool {
    ui.heading(format!("Camera Lab {}", env!("CARGO_PKG_VERSION")));
    ui.add_space(6.0);
    ui.label(t.about_text);
    ui.label(t.about_licence);
    ui.add_space(6.0);
    let height = (ui.ctx().content_rect().height() - 220.0).max(80.0);
    let lines: Vec<&str> = third_party(ui.ctx()).unwrap_or("…").lines().collect();
    let row = ui.text_style_height(&TextStyle::Small);
    // At its full height from the first frame, or the dialog would grow for some frames.
    let area = ScrollArea::both().max_height(height).min_scrolled_height(height).auto_shrink(false);
    area.show_rows(ui, row, lines.len(), |ui, range| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for line in &lines[range] {
            ui.label(RichText::new(*line).small());
        }
    });
    ui.add_space(8.0);
    matches!(buttons(ui, t.close, &[], first.then_some(CANCEL)), Pressed::Nothing)
}
