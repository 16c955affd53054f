//! The scene and how it is drawn.

use eframe::egui;

use super::row;
use crate::appearance::{HiddenLines, Shading, Theme};
use crate::gui::panels::{choice, section};
use crate::gui::state::State;
use crate::i18n::window;
use crate::scene::Preset;

/// Scene preset and style.
pub(super) fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    let figure = state.document.figure();
    let (mut preset, mut style) = (figure.scene.preset, figure.style);
    section(ui, t.scene, "scene", true, |ui| {
        let presets = [
            (Preset::Empty, t.scene_empty),
            (Preset::Primitives, t.scene_primitives),
            (Preset::Cube, t.scene_cube),
            (Preset::House, t.scene_house),
            (Preset::Corridor, t.scene_corridor),
            (Preset::Pyramid, t.scene_pyramid),
            (Preset::NdcCube, t.scene_ndc_cube),
            (Preset::Exercise51, t.scene_exercise_51),
            (Preset::Exercise52, t.scene_exercise_52),
            (Preset::Exercise53, t.scene_exercise_53),
        ];
        row(ui, "", t.preset, t.preset_hint, |ui| choice(ui, t.preset, t.preset_hint, &mut preset, &presets));
    });
    section(ui, t.style, "style", false, |ui| {
        let shadings = [
            (Shading::Wireframe, t.shading_wireframe),
            (Shading::Flat, t.shading_flat),
            (Shading::Gouraud, t.shading_gouraud),
            (Shading::Phong, t.shading_phong),
        ];
        row(ui, "", t.shading, t.shading_hint, |ui| {
            choice(ui, t.shading, t.shading_hint, &mut style.shading, &shadings)
        });
        let lines = [
            (HiddenLines::Dashed, t.hidden_dashed),
            (HiddenLines::Hidden, t.hidden_hidden),
            (HiddenLines::Shown, t.hidden_shown),
        ];
        row(ui, "", t.hidden_lines, t.hidden_lines_hint, |ui| {
            choice(ui, t.hidden_lines, t.hidden_lines_hint, &mut style.hidden_lines, &lines)
        });
        let samples = [(1, "1"), (4, "4"), (16, "16")];
        row(ui, "", t.antialias, t.antialias_hint, |ui| {
            choice(ui, t.antialias, t.antialias_hint, &mut style.antialias, &samples)
        });
        let themes = [(Theme::Light, t.theme_light), (Theme::Dark, t.theme_dark), (Theme::Print, t.theme_print)];
        row(ui, "", t.theme_name, t.theme_name_hint, |ui| {
            choice(ui, t.theme_name, t.theme_name_hint, &mut style.theme, &themes)
        });
    });
    let other = preset != figure.scene.preset;
    if other || style != figure.style {
        state.document.edit(|figure| (figure.scene.preset, figure.style) = (preset, style));
    }
    if other {
        show_from_its_best_side(state, preset);
    }
}

/// A scene of another size would be out of sight: each preset comes with its camera, and with an image of the same aspect.
fn show_from_its_best_side(state: &mut State, preset: Preset) {
    let mut camera = preset.camera();
    if state.settings.aspect_follows_image {
        let n = state.document.figure().image.height;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to what fits")]
        let m = (f64::from(n) * camera.aspect).round().clamp(1.0, 16384.0) as u32;
        state.document.edit(|figure| figure.image.width = m);
        camera.aspect = f64::from(m) / f64::from(n);
    }
    state.document.set_parameters(camera);
    *state.document.observers_mut() = Default::default();
}
