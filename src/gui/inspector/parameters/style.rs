//! The section about the style of the drawing.

use eframe::egui;

use crate::appearance::{HiddenLines, Samples, Shading, SubpixelBits, Theme, Visibility};
use crate::figure::words::VERTEX_FORMATS;
use crate::gui::inspector::{choice_row, more, section};
use crate::gui::kit::Explained;

/// Shading, hidden surfaces and lines, samples, theme.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut camera_lab_desk::Model) {
    let t = camera_lab_words::window::texts(model.settings.lang);
    let mut style = model.desk.shown.figure().style;
    let mut opens = false;
    section(ui, t.style, "style", true, |ui| {
        let shadings = [
            (Shading::Wireframe, t.shading_wireframe),
            (Shading::Flat, t.shading_flat),
            (Shading::Gouraud, t.shading_gouraud),
            (Shading::Phong, t.shading_phong),
        ];
        choice_row(ui, t.shading, t.shading_hint, &mut style.shading, &shadings);
        super::row(ui, "", t.visibility, t.visibility_hint, |ui| {
            let by = match style.visibility {
                Visibility::DepthBuffer => t.visibility_depth_buffer,
                Visibility::Painter => t.visibility_painter,
                Visibility::Bsp => t.visibility_bsp,
            };
            opens = ui.link(format!("{by} →")).explained(t.visibility_hint).clicked();
        });
        let lines = [
            (HiddenLines::Dashed, t.hidden_dashed),
            (HiddenLines::Hidden, t.hidden_hidden),
            (HiddenLines::Shown, t.hidden_shown),
        ];
        choice_row(ui, t.hidden_lines, t.hidden_lines_hint, &mut style.hidden_lines, &lines);
        more(ui, t, &format!("{}, {}", t.antialias, t.vertex_format), |ui| {
            let samples = [(Samples::One, "1"), (Samples::Four, "4"), (Samples::Sixteen, "16")];
            choice_row(ui, t.antialias, t.antialias_hint, &mut style.antialias, &samples);
            let themes = [(Theme::Light, t.theme_light), (Theme::Dark, t.theme_dark), (Theme::Print, t.theme_print)];
            choice_row(ui, t.file_theme, t.file_theme_hint, &mut style.theme, &themes);
            choice_row(
                ui,
                t.vertex_format,
                t.vertex_format_hint,
                &mut style.vertex_format,
                &VERTEX_FORMATS.iter().map(|&(name, format)| (format, name)).collect::<Vec<_>>(),
            );
            let grids = [(SubpixelBits::Four, "4"), (SubpixelBits::Eight, "8"), (SubpixelBits::Twelve, "12")];
            choice_row(ui, t.subpixel_bits, t.subpixel_bits_hint, &mut style.subpixel_bits, &grids);
        });
    });
    model.desk.shown.set(|figure| &mut figure.style, style);
    if opens {
        model.show_explanation(crate::figure::Explanation::HiddenSurfaces);
    }
}
