//! The section about the content of the world picture besides scene and camera.

use eframe::egui;

use super::row;
use crate::gui::panels::{choice, section};
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::window;
use crate::numbers::significant;

/// The steps of opacity that are offered, in percent.
const STEPS: [u8; 5] = [0, 25, 50, 75, 100];

/// One control for each key of `[world]`.
pub(super) fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    let old = state.document.figure().world;
    let mut world = old;
    section(ui, t.in_world, "world", true, |ui| {
        let mut steps: Vec<f64> = STEPS.map(|percent| f64::from(percent) / 100.0).to_vec();
        // A file may say anything between.
        steps.extend(old.window_opacity.filter(|opacity| !steps.contains(opacity)));
        let names: Vec<_> = steps.iter().map(|share| format!("{} %", significant(share * 100.0, 3))).collect();
        let mut all = vec![(None, t.opacity_automatic)];
        all.extend(steps.iter().zip(&names).map(|(share, name)| (Some(*share), name.as_str())));
        row(ui, "", t.window_opacity, t.window_opacity_hint, |ui| {
            choice(ui, t.window_opacity, t.window_opacity_hint, &mut world.window_opacity, &all)
        });
        ui.add_enabled(!world.section, egui::Checkbox::new(&mut world.dimensions, t.dimensions))
            .explained(t.dimensions_hint)
            .explained_disabled(t.dimensions_in_section);
        ui.checkbox(&mut world.section, t.section_view).explained(t.section_view_hint);
    });
    if world != old {
        state.document.edit(|figure| figure.world = world);
    }
}
