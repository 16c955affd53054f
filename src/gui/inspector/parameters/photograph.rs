//! The photograph under the image: its file, its opacity, and the way to its camera.

use eframe::egui::{self, Label, RichText};

use super::row;
use crate::figure::Photograph;
use crate::gui::inspector::scene;
use crate::gui::kit::{Explained, NumberField, Step, number_field};
use crate::sanitize;
use crate::views::View;
use camera_lab_desk::{Action, FileFor, Model};
use camera_lab_words::window::photograph::{self as words, Texts};
use camera_lab_words::{messages, window};

/// The rows of the photograph, in the section of the image.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = words::texts(model.settings.lang);
    let photograph = model.desk.shown.figure().photograph.clone();
    row(ui, "", t.photograph, t.hint, |ui| {
        if photograph.is_some() && ui.button("✖").explained(t.remove).accessible_name(t.remove).clicked() {
            model.desk.shown.edit(|figure| figure.photograph = None);
            model.photograph.on = false;
        }
        let name = photograph.as_ref().map_or_else(|| t.choose.to_owned(), |photograph| file_name(&photograph.file));
        let button = egui::Button::new(name).truncate();
        let hint = photograph.as_ref().map_or_else(|| t.hint.to_owned(), |of| sanitize::path_text(&of.file));
        let response = ui.add(button).explained(hint).accessible_name(t.choose_title);
        number_field::answer_call(ui, &response, t.choose_title);
        if response.clicked() {
            model.request(Action::File(FileFor::Photograph));
        }
    });
    if let Some(photograph) = &photograph {
        opacity(ui, model, t, photograph);
        notice(ui, model);
        size(ui, model, t);
    }
    let find = ui.add_enabled(photograph.is_some(), egui::Button::new(t.find).selected(model.photograph.on));
    if find.explained(t.find_hint).explained_disabled(t.find_first).clicked() {
        model.photograph.toggle();
        model.layout.shown[View::Image.index()] = true;
    }
}

/// The last part of a path.
fn file_name(path: &str) -> String {
    sanitize::escaped(path.rsplit(['/', '\\']).next().unwrap_or(path))
}

fn opacity(ui: &mut egui::Ui, model: &mut Model, t: &Texts, photograph: &Photograph) {
    let mut opacity = photograph.opacity;
    row(ui, "", t.opacity, t.opacity_hint, |ui| {
        let field = NumberField::new(t.opacity, Step::Add(0.1)).within(0.0..=1.0).hint(t.opacity_hint).width(62.0);
        field.show(ui, window::texts(model.settings.lang), &mut opacity)
    });
    if opacity != photograph.opacity {
        model.desk.shown.edit(|figure| {
            if let Some(photograph) = &mut figure.photograph {
                photograph.opacity = opacity;
            }
        });
    }
}

/// The reason why the photograph can't be shown, and the buttons that mend it.
fn notice(ui: &mut egui::Ui, model: &mut Model) {
    let notices = &model.scene_cache.scene().notices;
    let found = notices.iter().find_map(|(_, notice)| match notice {
        crate::scene::MeshNotice::Photograph(error) => {
            Some((messages::mesh_notice(model.settings.lang, notice), error.is_outside()))
        }
        _ => None,
    });
    if let Some((text, is_outside)) = found {
        ui.add(Label::new(RichText::new(format!("⚠ {text}")).weak()).wrap());
        scene::mend(ui, model, [is_outside, true]);
    }
}

/// The button that gives the image the size of a photograph with another aspect.
fn size(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let Some([width, height]) =
        model.scene_cache.scene().photograph.as_ref().map(|photograph| [photograph.width(), photograph.height()])
    else {
        return;
    };
    let image = model.desk.shown.figure().image;
    if u64::from(width) * u64::from(image.height) == u64::from(height) * u64::from(image.width) {
        return;
    }
    let text = words::size(model.settings.lang, [width, height]);
    ui.add(Label::new(RichText::new(format!("⚠ {text}")).weak()).wrap());
    if ui.button(t.size).explained(t.size_hint).clicked() {
        model.desk.shown.edit(|figure| figure.image = crate::camera::ImageSize { width, height });
    }
}
