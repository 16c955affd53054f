//! The section about the inner work of the pipeline.

use eframe::egui;

use super::row;
use crate::figure::{Depth, Outside};
use crate::gui::panels::{choice, section};
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::window;

/// One control for each key of `[reveal]`.
pub(super) fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    let old = state.document.figure().reveal;
    let mut reveal = old;
    section(ui, t.reveal, "reveal", true, |ui| {
        let depths = [(Depth::Off, t.depth_off), (Depth::Stored, t.depth_stored), (Depth::Linear, t.depth_linear)];
        row(ui, "", t.depth_view, t.depth_view_hint, |ui| {
            choice(ui, t.depth_view, t.depth_view_hint, &mut reveal.depth, &depths)
        });
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
            (&mut reveal.culled, t.culled_view, t.culled_view_hint),
            (&mut reveal.divide_first, t.divide_first, t.divide_first_hint),
            (&mut reveal.vanishing, t.vanishing, t.vanishing_hint),
        ] {
            ui.checkbox(on, name).explained(hint);
        }
    });
    if reveal != old {
        state.document.edit(|figure| figure.reveal = reveal);
    }
}
