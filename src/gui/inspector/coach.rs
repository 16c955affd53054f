//! The dialog of the camera check, with all advice about the image and the camera, and with repairs.

use eframe::egui::{self, RichText, Ui};

use crate::gui::kit::{CANCEL, Explained, Pressed, buttons, theme};
use crate::numerics::diagnosis::{IN_A_WINDOW, Repair, changes};
use crate::numerics::health::Level;
use camera_lab_desk::{Action, Advice, Model};
use camera_lab_words::window::{Texts, coach as words};

/// The width of the dialog.
pub(in crate::gui) const WIDTH: f32 = 720.0;

/// An action to take.
enum Wish {
    Repair(Repair),
    Camera(crate::camera::Parameters),
    /// Go to the explanation of depths.
    Depth,
    /// Go to the study of the figure.
    Examine,
}

/// Shows the dialog with all the advice. Returns false once it's closed.
pub(in crate::gui) fn show(ui: &mut Ui, t: &Texts, model: &mut Model, first: bool) -> bool {
    let words = words::texts(model.settings.lang);
    ui.heading(words.coach);
    let height = (ui.ctx().content_rect().height() - 150.0).max(120.0);
    let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false, true]);
    let mut wish = None;
    area.show(ui, |ui| match model.coach.advice().cloned() {
        // Its sentences have numbers of the camera and of depths.
        _ if !model.frame.asked.is_empty() => drop(ui.label(t.asked_here).explained(t.asked_hint)),
        None => drop(ui.label(words.looking)),
        Some(advice) => {
            findings(ui, model, &advice, &mut wish);
            health(ui, model, &advice, &mut wish);
            if ui.link(words.about_depth).clicked() {
                wish = Some(Wish::Depth);
            }
            if ui.link(words.about_error).clicked() {
                wish = Some(Wish::Examine);
            }
        }
    });
    ui.add_space(8.0);
    let stays = matches!(buttons(ui, t.close, &[], first.then_some(CANCEL)), Pressed::Nothing);
    let Some(wish) = wish else { return stays };
    match wish {
        Wish::Repair(repair) => model.apply_repair(repair),
        Wish::Camera(camera) => model.apply_camera(camera),
        Wish::Examine => model.request(Action::Examine),
        Wish::Depth => model.show_explanation(crate::figure::Explanation::Depth),
    }
    ui.request_repaint();
    false
}

fn title(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(text).font(theme::bold(12.5)));
}

fn findings(ui: &mut Ui, model: &Model, advice: &Advice, wish: &mut Option<Wish>) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    title(ui, t.findings);
    let Some(diagnosis) = &advice.diagnosis else {
        ui.label(t.too_large);
        return;
    };
    if diagnosis.camera_error.is_none() {
        ui.label(words::seen(lang, diagnosis.visible, diagnosis.covered));
    }
    if let Some(placed) = words::placed(lang, diagnosis.placed_within) {
        ui.label(placed);
    }
    if diagnosis.findings.is_empty() {
        let crate::camera::ImageSize { width, height } = model.desk.shown.figure().image;
        let is_coarse = u64::from(width) * u64::from(height) > IN_A_WINDOW;
        ui.label(if is_coarse { t.no_problems_in_coarse } else { t.no_problems });
    }
    for finding in &diagnosis.findings {
        let button = finding.repair.map(|repair| (t.show_it, model.changes_of(&repair)));
        if line(ui, &words::finding(lang, finding, diagnosis, &model.desk.shown.figure().scene), button) {
            *wish = finding.repair.map(Wish::Repair);
        }
    }
}

fn health(ui: &mut Ui, model: &Model, advice: &Advice, wish: &mut Option<Wish>) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    if !advice.health.is_empty() {
        title(ui, t.health);
    }
    for health in &advice.health {
        let color = theme::level_color(ui, health.level);
        let sign = if health.level == Level::Good { "" } else { "⚠ " };
        let (name, level) = (words::quantity(lang, health.quantity), words::level(lang, health.level));
        ui.label(RichText::new(format!("{sign}{name}: {level}")).color(color));
        let figure = model.desk.shown.figure();
        let change = |camera| words::changes_in_symbols(lang, &changes(&figure.camera, camera));
        let button = health.repair.as_ref().map(|camera| (t.improve, change(camera)));
        if line(ui, &words::health(lang, health, &advice.camera, figure.style.depth_format), button) {
            *wish = health.repair.map(Wish::Camera);
        }
    }
}

/// A sentence, and the button that acts on it. Returns true if that was pressed.
fn line(ui: &mut Ui, text: &str, button: Option<(&str, String)>) -> bool {
    let mut pressed = false;
    ui.indent(text, |ui| {
        theme::sentence_label(ui, text);
        if let Some((name, change)) = button {
            ui.horizontal_wrapped(|ui| {
                pressed = ui.button(name).explained(&change).clicked();
                ui.label(RichText::new(change).small().weak());
            });
        }
    });
    pressed
}
