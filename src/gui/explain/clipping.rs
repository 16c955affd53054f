//! Clipping: the parts of the scene outside the view volume, the vertices that the planes make, and the division before
//! clipping.

use eframe::egui::Ui;

use crate::figure::{Explanation, Outside};
use crate::gui::panels::{choice, row};
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::{explain, window};

/// Shows it.
pub(super) fn ui(ui: &mut Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    let old = state.document.figure().reveal;
    let mut reveal = old;
    let outsides = [
        (Outside::Usual, t.outside_usual),
        (Outside::Cut, t.outside_cut),
        (Outside::Tinted, t.outside_tinted),
        (Outside::Shown, t.outside_shown),
    ];
    row(ui, "", t.outside_view, t.outside_view_hint, |ui| {
        choice(ui, t.outside_view, t.outside_view_hint, &mut reveal.outside, &outsides)
    });
    for (on, name, hint) in [
        (&mut reveal.clipping, t.clipping_view, t.clipping_view_hint),
        (&mut reveal.divide_first, t.divide_first, t.divide_first_hint),
    ] {
        ui.checkbox(on, name).explained(hint);
        ui.label(eframe::egui::RichText::new(hint).small().weak());
    }
    if reveal != old {
        state.document.edit(|figure| figure.reveal = reveal);
    }
    let words = explain::texts(state.settings.lang);
    if ui.link(words.one_triangle).explained(words.triangle_hint).clicked() {
        state.show_explanation(Explanation::Triangle);
    }
}
