//! Clipping: the parts of the scene outside the view volume, the vertices that the planes make, and the division before
//! clipping.

use eframe::egui::{Button, Ui};

use crate::figure::{Explanation, Outside};
use crate::gui::kit::{Explained, choice_row};
use crate::gui::why::state::explain::Explain;
use crate::pipeline::divide_before_clip::divided_first;
use camera_lab_desk::{Action, Intent, Model};
use camera_lab_words::told;
use camera_lab_words::why::explain;
use camera_lab_words::window::{self, gallery};

/// Shows it.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = window::texts(model.settings.lang);
    let mut reveal = model.desk.shown.figure().reveal;
    let outsides = [
        (Outside::Usual, t.outside_usual),
        (Outside::Cut, t.outside_cut),
        (Outside::Tinted, t.outside_tinted),
        (Outside::Shown, t.outside_shown),
    ];
    choice_row(ui, t.outside_view, t.outside_view_hint, &mut reveal.outside, &outsides);
    for (on, name, hint) in [
        (&mut reveal.clipping, t.clipping_view, t.clipping_view_hint),
        (&mut reveal.divide_first, t.divide_first, t.divide_first_hint),
    ] {
        ui.checkbox(on, name).explained(hint);
        ui.label(eframe::egui::RichText::new(hint).small().weak());
    }
    model.desk.shown.set(|figure| &mut figure.reveal, reveal);
    dead_end(ui, model, explain);
    let words = explain::texts(model.settings.lang);
    if ui.link(words.one_triangle).explained(words.triangle_hint).clicked() {
        model.show_explanation(Explanation::Triangle);
    }
}

/// The built-in figure in which dividing before clipping goes wrong.
const SHOWS_IT: &str = "divide-first";

/// If dividing before clipping does no harm to the scene, offers a figure in which it does.
fn dead_end(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    if !model.desk.shown.figure().reveal.divide_first {
        return;
    }
    let camera = model.desk.shown.camera();
    let key = (model.scene_cache.scene().clone(), *camera.parameters());
    let is_right = *explain.divides_right.of(key, |(scene, _)| divided_first(scene, camera, 1.0).is_right());
    let Some(figure) = camera_lab_files::ShippedFigure::named(SHOWS_IT).filter(|_| is_right) else { return };
    let lang = model.settings.lang;
    let [title, caption] = figure.told();
    let text = format!("{} {}", gallery::texts(lang).shows, told(lang, &title));
    if ui.add(Button::new(text).wrap()).explained(told(lang, &caption)).clicked() {
        model.request(Action::Begin(Intent::Shipped(figure.name)));
    }
}
