//! The section about the content of the world picture besides scene and camera.

use eframe::egui;

use crate::figure::{WorldPart, WorldParts};
use crate::gui::inspector::{choice_row, section};
use crate::gui::kit::Explained;
use crate::numbers::significant;
use camera_lab_words::pictures::labels;
use camera_lab_words::{Lang, window};

/// The steps of opacity on offer, in percent.
const STEPS: [u8; 5] = [0, 25, 50, 75, 100];

/// The lengths of the camera's axes on offer, as multiples of the usual one.
const LENGTHS: [f64; 4] = [0.5, 1.5, 2.0, 3.0];

/// A switch for each part, in two columns.
fn parts(ui: &mut egui::Ui, lang: Lang, parts: &mut WorldParts) {
    let all: Vec<_> = WorldPart::ALL.into_iter().zip(labels(lang).world_parts).collect();
    let half = all.len().div_ceil(2);
    ui.columns_const(|columns: &mut [egui::Ui; 2]| {
        for (ui, column) in columns.iter_mut().zip(all.chunks(half)) {
            for ((part, _), name) in column {
                let mut drawn = parts.has(*part);
                if ui.checkbox(&mut drawn, *name).changed() {
                    parts.set(*part, drawn);
                }
            }
        }
    });
}

/// One control for each key of `[world]`.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut camera_lab_desk::Model) {
    let t = window::texts(model.settings.lang);
    let old = model.desk.shown.figure().world;
    let mut world = old;
    section(ui, t.in_world, "world", true, |ui| {
        let mut steps: Vec<f64> = STEPS.map(|percent| f64::from(percent) / 100.0).to_vec();
        // A file may say anything between.
        steps.extend(old.window_opacity.filter(|opacity| !steps.contains(opacity)));
        let names: Vec<_> = steps.iter().map(|share| format!("{} %", significant(share * 100.0, 3))).collect();
        let mut all = vec![(None, t.opacity_automatic)];
        all.extend(steps.iter().zip(&names).map(|(share, name)| (Some(*share), name.as_str())));
        choice_row(ui, t.window_opacity, t.window_opacity_hint, &mut world.window_opacity, &all);
        let mut lengths = LENGTHS.to_vec();
        lengths.extend(old.axes_length.filter(|length| !lengths.contains(length)));
        let names: Vec<_> = lengths.iter().map(|length| format!("× {}", significant(*length, 3))).collect();
        let mut all = vec![(None, t.axes_usual)];
        all.extend(lengths.iter().zip(&names).map(|(length, name)| (Some(*length), name.as_str())));
        choice_row(ui, t.axes_length, t.axes_length_hint, &mut world.axes_length, &all);
        ui.add_enabled(!world.section, egui::Checkbox::new(&mut world.dimensions, t.dimensions))
            .explained(t.dimensions_hint)
            .explained_disabled(t.dimensions_in_section);
        ui.checkbox(&mut world.section, t.section_view).explained(t.section_view_hint);
        ui.label(t.world_parts).explained(t.world_parts_hint);
        parts(ui, model.settings.lang, &mut world.parts);
    });
    model.desk.shown.set(|figure| &mut figure.world, world);
}
