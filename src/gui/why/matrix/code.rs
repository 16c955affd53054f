//! The explanation as code: the camera for other libraries.

use eframe::egui::{self, FontId, TextStyle};

use crate::explain::code::CodeTarget;
use crate::gui::kit::{Explained, TextField, choice};
use crate::gui::why::state::explain::Explain;
use camera_lab_desk::Model;
use camera_lab_words::why::{code, dialects, explain};

/// Shows the tab.
pub(in crate::gui::why) fn ui(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain) {
    let lang = model.settings.lang;
    let t = explain::texts(lang);
    let targets = CodeTarget::ALL.map(|target| (target, target.name()));
    let text = written(model, explain);
    ui.horizontal(|ui| {
        choice(ui, t.code_for, t.code_hint, &mut explain.code, &targets);
        if ui.button(t.copy).explained(t.copy_code_hint).clicked() {
            ui.ctx().copy_text(text.clone());
        }
    });
    ui.add_space(4.0);
    let font = FontId::monospace(TextStyle::Small.resolve(ui.style()).size);
    // It can be read, selected and copied, but not edited, because the other tabs edit the camera.
    let mut shown = text.as_str();
    let field = TextField::fixed_lines(&mut shown);
    let field = field.with(|edit| edit.font(font).desired_width(f32::INFINITY).code_editor());
    field.show(ui, lang).accessible_name(t.code);
}

/// The code for the present camera, in the language of the window.
fn written(model: &Model, explain: &Explain) -> String {
    let camera = model.desk.shown.camera();
    let figure = model.desk.shown.figure();
    let target = explain.code;
    if let Some(limitation) = target.limitation(camera, figure.image) {
        return dialects::limitation(model.settings.lang, limitation);
    }
    let setting = crate::explain::Setting::new(camera.notes_clip_space(), figure.image, figure.viewport);
    target.code(&setting, &code::comments(model.settings.lang, target, &target.conventions(camera)))
}
