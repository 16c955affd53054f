//! The cameras of the figure: the current one, the others, and ready-made pairs.

use eframe::egui::{self, Popup, PopupCloseBehavior};

use super::{complaint, row};
use crate::camera::{Convergence, Projection};
use crate::gui::inspector::section;
use crate::gui::kit::{Explained, KeptLine, NumberField, Step, number_field};
use crate::limits::{MAX_CAMERA_NAME, MAX_CAMERAS};
use crate::sanitize::escaped;
use crate::views::{OtherCamera, Palette};
use camera_lab_desk::Model;
use camera_lab_words::window;
use camera_lab_words::window::cameras::{self, Texts};

/// Shows the list, and the buttons that add to it.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = cameras::texts(model.settings.lang);
    let count = model.desk.shown.figure().cameras.len();
    // It opens when the first camera comes, or when the search leads to one of its buttons.
    let (id, opens) = match (count > 0, model.cameras.was_called) {
        (true, _) => ("cameras", true),
        (false, true) => ("called cameras", true),
        (false, false) => ("no other cameras", false),
    };
    section(ui, t.cameras, id, opens, |ui| {
        if count > 0 {
            name_row(ui, model, t, None, |ui| drop(ui.weak(t.current)));
        }
        for index in 0..count {
            // If a camera is removed, the list is shorter in the same frame.
            if index < model.desk.shown.figure().cameras.len() {
                other(ui, model, t, index);
            }
        }
        add(ui, model, t, count < MAX_CAMERAS);
    });
}

/// One of the other cameras: its color, its name, and the buttons that look through it and remove it.
fn other(ui: &mut egui::Ui, model: &mut Model, t: &Texts, index: usize) {
    let mut asked = (false, false);
    let mut is_beside = model.camera_beside() == Some(index);
    let own = model.desk.shown.figure().cameras[index].name.clone();
    name_row(ui, model, t, Some(index), |ui| {
        let of = |what: &str| format!("{what}: {}", escaped(&own));
        let look = ui.button(t.look).explained(t.look_hint).accessible_name(of(t.look));
        let remove = ui.button("✖").explained(t.remove_hint).accessible_name(of(t.remove));
        asked = (look.clicked(), remove.clicked());
    });
    ui.horizontal(|ui| {
        // Below the name, not the colour.
        ui.add_space(24.0);
        let beside = ui.checkbox(&mut is_beside, t.beside).explained(t.beside_hint);
        if beside.accessible_name(format!("{}: {}", t.beside, escaped(&own))).changed() {
            model.show_beside(is_beside.then_some(index));
        }
    });
    match asked {
        (true, _) => model.look_through(index),
        (_, true) => {
            model.desk.shown.edit_cameras(|figure| figure.remove_camera(index));
        }
        _ => {}
    }
}

/// Color, name, and the controls at the right.
fn name_row(
    ui: &mut egui::Ui,
    model: &mut Model,
    t: &Texts,
    index: Option<usize>,
    at_right: impl FnOnce(&mut egui::Ui),
) {
    let mut is_refused = false;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().interact_size.x = 20.0;
        color(ui, model, t, index);
        is_refused = name_field(ui, model, t, index);
        crate::gui::kit::focus::at_right(ui, at_right);
    });
    if is_refused {
        complaint(ui, t.name_bad);
    }
}

fn is_free(model: &Model, name: &str, index: Option<usize>) -> bool {
    let figure = model.desk.shown.figure();
    let is_own = index.is_none() && figure.tag.name.as_deref() == Some(name);
    is_own || figure.may_name_camera(name, index)
}

fn color(ui: &mut egui::Ui, model: &mut Model, t: &Texts, index: Option<usize>) {
    let palette = Palette::of(model.settings.theme);
    let figure = model.desk.shown.figure();
    let given = index.map_or(figure.tag.color, |i| figure.cameras[i].color);
    let now = match index {
        Some(i) => OtherCamera::color_at(given, i, palette),
        None => given.unwrap_or(palette.body),
    };
    let mut chosen = [now.r, now.g, now.b];
    let name = index.map_or(t.current, |i| &figure.cameras[i].name);
    let name = format!("{}: {}", t.color, escaped(name));
    let picker = ui.color_edit_button_srgb(&mut chosen).explained(t.color_hint).accessible_name(name);
    if picker.changed() {
        let [r, g, b] = chosen;
        let chosen = Some(crate::appearance::Rgba::rgb(r, g, b));
        model.desk.shown.edit_cameras(|figure| match index.and_then(|i| figure.cameras.get_mut(i)) {
            Some(crate::figure::NamedCamera { color, .. }) => *color = chosen,
            None => figure.tag.color = chosen,
        });
    }
}

/// The field of a name. Returns true if it's refused.
fn name_field(ui: &mut egui::Ui, model: &mut Model, t: &Texts, index: Option<usize>) -> bool {
    let figure = model.desk.shown.figure();
    let old = index.map_or_else(|| figure.tag.name.clone(), |i| Some(figure.cameras[i].name.clone()));
    let old = old.unwrap_or_default();
    let id = egui::Id::unique(("camera name", model.desk.shown.id(), index));
    let line = KeptLine { id, old: &old, most: MAX_CAMERA_NAME, width: 98.0 };
    let (response, typed) =
        line.show(
            ui,
            model.settings.lang,
            |wanted| {
                if is_free(model, wanted, index) { Ok(wanted.to_owned()) } else { Err(()) }
            },
        );
    response.explained(t.name_hint).accessible_name(format!("{}: {}", t.name, escaped(&old)));
    if let Some(Ok(wanted)) = &typed {
        model.desk.shown.edit_cameras(|figure| figure.rename_camera(index, wanted));
    }
    typed.is_some_and(|typed| typed.is_err())
}

/// The buttons that add cameras.
fn add(ui: &mut egui::Ui, model: &mut Model, t: &Texts, has_room: bool) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let button = |ui: &mut egui::Ui, text: &str, hint: &str| {
            let button = ui.add_enabled(has_room, egui::Button::new(text));
            number_field::answer_call(ui, &button, text);
            button.explained(hint).explained_disabled(t.full)
        };
        if button(ui, t.add, t.add_hint).clicked() {
            model.keep_camera();
        }
        let is_perspective = model.desk.shown.camera().projection() == Projection::Perspective;
        let pair = ui.add_enabled(has_room && is_perspective, egui::Button::new(format!("{} ▾", t.pair)));
        let pair = pair.explained(t.pair_hint).accessible_name(t.pair);
        number_field::answer_call(ui, &pair, t.pair);
        let popup = Popup::from_toggle_button_response(&pair).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.show(|ui| {
            ui.set_width(240.0);
            stereo(ui, model, t);
        });
    });
}

/// The menu of the stereo pair: its baseline and its two kinds.
fn stereo(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let words = window::texts(model.settings.lang);
    let mut baseline = model.cameras.baseline.unwrap_or(model.desk.shown.camera().distance() / 30.0);
    row(ui, "", t.baseline, t.baseline_hint, |ui| {
        let field = NumberField::new(t.baseline, Step::Multiply(1.1)).positive().hint(t.baseline_hint).width(92.0);
        let before = baseline;
        field.show(ui, words, &mut baseline);
        if baseline != before {
            model.cameras.baseline = Some(baseline);
        }
    });
    for (convergence, text, hint) in
        [(Convergence::ShiftedWindows, t.shifted, t.shifted_hint), (Convergence::ToeIn, t.toe_in, t.toe_in_hint)]
    {
        if ui.button(text).explained(hint).clicked() {
            model.make_stereo(baseline, convergence);
            ui.close();
        }
    }
}
