//! The list of sessions left by windows that didn't close, until the user has decided.

use std::time::{Duration, UNIX_EPOCH};

use eframe::egui::{self, Align, Label, Layout, RichText, ScrollArea};

use crate::gui::kit::{Explained, with_room_before};
use crate::{clock, sanitize};
use camera_lab_desk::LeftOver;
use camera_lab_words::window::sessions::ago;
use camera_lab_words::{Lang, window};

/// The user's decision about a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Continue it in this window.
    Restore(usize),
    /// Delete it.
    Discard(usize),
}

/// Rows that are seen at once.
const ROWS: f32 = 4.0;

/// Shows the list, if there is one.
pub fn list(ui: &mut egui::Ui, lang: Lang, left: &[LeftOver]) -> Option<Decision> {
    if left.is_empty() {
        return None;
    }
    let t = window::texts(lang);
    let mut decision = None;
    egui::Panel::top("recovery").show(ui, |ui| {
        ui.label(RichText::new(t.recovery_title).strong());
        let line = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let row = line.y + ui.spacing().item_spacing.y;
        let area = ScrollArea::vertical().max_height(ROWS * row).min_scrolled_height(ROWS * row);
        area.auto_shrink([false, true]).show(ui, |ui| {
            for left in left {
                ui.push_id(left.slot, |ui| {
                    ui.allocate_ui_with_layout(line, Layout::left_to_right(Align::Center), |ui| {
                        let which = |ui: &mut egui::Ui| {
                            ui.add(Label::new(described(lang, left)).truncate());
                        };
                        with_room_before(ui, which, |ui| {
                            if ui.button(t.restore).explained(t.restore_hint).clicked() {
                                decision = Some(Decision::Restore(left.slot));
                            }
                            if ui.button(t.discard).explained(t.discard_hint).clicked() {
                                decision = Some(Decision::Discard(left.slot));
                            }
                        });
                    });
                });
            }
        });
    });
    decision
}

/// The figure, its age, and a warning if it's dangerous.
fn described(lang: Lang, left: &LeftOver) -> String {
    let t = window::texts(lang);
    let name = left.path.as_deref().map_or_else(|| t.untitled.to_owned(), sanitize::path);
    let now = UNIX_EPOCH.checked_add(Duration::from_secs(clock::seconds_since_1970()));
    let age = now.zip(left.written).map(|(now, written)| now.duration_since(written).unwrap_or_default());
    let age = age.map(|age| format!(" · {}", ago(lang, age)));
    let fatal = if left.did_not_survive { format!(" · ⚠ {}", t.did_not_survive) } else { String::new() };
    format!("{name}{}{fatal}", age.unwrap_or_default())
}
