//! The tab of matrices.

use eframe::egui;

use crate::gui::state::State;
use crate::i18n::explain;

/// Shows the tab.
pub(super) fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = explain::texts(state.settings.lang);
    ui.label(t.matrices_hint);
}
