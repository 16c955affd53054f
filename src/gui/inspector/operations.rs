//! The operations on the camera: by a step, or with a slider from the present camera.

use eframe::egui::{self, Align, Layout, RichText, Slider};

use super::{TEXT_LINE, complain, erratum, more, predict, section};
use crate::camera::{Amount, Convention, Descriptor, Freedom, OPERATIONS, Operation};
use crate::gui::kit::{Explained, NumberField, Step, help_topic_row, number_field, theme};
use crate::views::Ghost;
use camera_lab_desk::{Model, Scrub, arrow};
use camera_lab_words::why::notes;
use camera_lab_words::window::{self, Texts};

/// The operation of a slider pulled this far, in degrees, as a power of two, or in scene units. 0 changes nothing.
fn pulled(freedom: Freedom, pull: f64) -> Operation {
    match freedom.descriptor().amount {
        Amount::Angle | Amount::Length => freedom.by(pull),
        Amount::Factor => freedom.by(pull.exp2()),
    }
}

/// The operation of a button: one step forwards or backwards.
fn stepped(freedom: Freedom, step: f64, forwards: bool) -> Operation {
    freedom.by(if forwards { step } else { freedom.descriptor().amount.inverse(step) })
}

/// Name and effect of an operation.
pub(in crate::gui) fn words(freedom: Freedom, t: &Texts) -> [&'static str; 2] {
    match freedom {
        Freedom::Elevation => [t.elevation, t.elevation_effect],
        Freedom::Azimuth => [t.azimuth, t.azimuth_effect],
        Freedom::Roll => [t.roll, t.roll_effect],
        Freedom::Yaw => [t.yaw, t.yaw_effect],
        Freedom::Pitch => [t.pitch, t.pitch_effect],
        Freedom::Zoom => [t.zoom, t.zoom_effect],
        Freedom::Dolly => [t.dolly, t.dolly_effect],
        Freedom::PanU => [t.pan_u, t.pan_u_effect],
        Freedom::PanV => [t.pan_v, t.pan_v_effect],
    }
}

fn name(freedom: Freedom, t: &Texts) -> &'static str {
    words(freedom, t)[0]
}

fn effect(freedom: Freedom, t: &Texts) -> &'static str {
    words(freedom, t)[1]
}

/// The name of the field of an operation's step.
pub(in crate::gui) fn step_name(freedom: Freedom, t: &Texts) -> String {
    format!("{}: {}", name(freedom, t), t.step)
}

/// Shows the operations.
pub fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let possible = model.desk.shown.problem().is_none();
    section(ui, t.operations, "operations", true, |ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        ui.add_enabled_ui(possible, |ui| predict::ui(ui, t, model, written));
        ui.add_enabled_ui(possible, |ui| {
            for Descriptor { freedom, .. } in &OPERATIONS {
                ui.push_id(freedom, |ui| operation(ui, t, model, *freedom));
            }
        });
        kept(ui, t, model);
        more(ui, t, t.vtk, |ui| {
            let mut vtk = model.operations.convention == Convention::Vtk;
            ui.checkbox(&mut vtk, t.vtk).explained(t.vtk_hint);
            model.operations.convention = if vtk { Convention::Vtk } else { Convention::RightHand };
        });
    });
    if !ui.input(|input| input.pointer.any_down()) {
        model.operations.scrub = None;
    }
}

/// One row with its buttons. Below the open one are its effect and its slider.
fn operation(ui: &mut egui::Ui, t: &'static Texts, model: &mut Model, freedom: Freedom) {
    let row = ui.scope(|ui| {
        controls(ui, t, model, freedom);
        if model.operations.shows(freedom) {
            detail(ui, t, model, freedom);
        }
    });
    help_topic_row(ui, row.response.rect, notes::of_operation(freedom));
    let hovered = ui.rect_contains_pointer(row.response.rect) && ui.is_enabled();
    // If it's to be predicted, it isn't shown.
    if model.frame.hover.ghost.is_none()
        && hovered
        && !model.operations.predict.on
        && !ui.input(|input| input.pointer.any_down())
    {
        let before = model.desk.shown.camera().clone();
        let operation = stepped(freedom, model.operations.steps[freedom as usize], true);
        model.frame.hover.ghost = Some(Ghost { before, operation, convention: model.operations.convention });
    }
}

/// The effect of the open operation, or the position of its slider, and the slider.
fn detail(ui: &mut egui::Ui, t: &'static Texts, model: &mut Model, freedom: Freedom) {
    let amount = model.operations.scrub.as_ref().filter(|scrub| scrub.freedom == freedom).map(|scrub| scrub.amount);
    ui.scope(|ui| {
        ui.spacing_mut().interact_size.y = TEXT_LINE;
        let small = match amount {
            Some(amount) => RichText::new(describe(freedom, amount, t.lang.mark())).small().strong(),
            None => RichText::new(effect(freedom, t)).small().weak(),
        };
        ui.add(egui::Label::new(small).truncate());
    });
    ui.add_enabled_ui(!model.operations.predict.on, |ui| slider(ui, t, model, freedom));
    let is_last = model.operations.last.as_ref().is_some_and(|last| last.operation.name() == freedom.descriptor().word);
    let keeps = is_last && model.operations.led_to(model.desk.shown.camera()).is_some();
    let button = ui.add_enabled(keeps, egui::Button::new(t.keep_operation));
    if is_last {
        number_field::answer_call(ui, &button, t.keep_operation);
    }
    if button.explained(t.keep_operation_hint).explained_disabled(t.keep_operation_disabled).clicked() {
        let camera = model.desk.shown.camera().clone();
        model.operations.keep(&camera, &mut model.desk.shown.show_mut().operations);
    }
    ui.add_space(3.0);
}

/// The operations that the figure shows, and the button that removes them.
fn kept(ui: &mut egui::Ui, t: &'static Texts, model: &mut Model) {
    let shown = &model.desk.shown.figure().show.operations;
    if shown.is_empty() {
        return;
    }
    let names: Vec<String> = shown.iter().map(|operation| written(*operation, t)).collect();
    ui.horizontal(|ui| {
        let taken_out = ui.button("✕").explained(t.take_out).accessible_name(t.take_out).clicked();
        ui.add(egui::Label::new(format!("{} {}", t.kept_operations, names.join(" · "))).wrap());
        if taken_out {
            model.desk.shown.show_mut().operations.clear();
        }
    });
}

/// An operation with its value: Azimuth +30°.
fn written(operation: Operation, t: &Texts) -> String {
    let mark = t.lang.mark();
    let amount = match operation {
        Operation::Zoom(factor) | Operation::Dolly(factor) => format!("× {}", mark.number(factor, 4)),
        Operation::Pan { dx, dy } => mark.tuple(&[dx, dy], 4),
        _ => operation.angle().map(|angle| format!("{}°", mark.number(angle.degrees(), 5))).unwrap_or_default(),
    };
    let name = if matches!(operation, Operation::Pan { .. }) { "Pan" } else { name(operation.freedom(), t) };
    format!("{name} {amount}")
}

/// The amount of a slider.
fn describe(freedom: Freedom, amount: f64, mark: crate::numbers::DecimalMark) -> String {
    let sign = if amount > 0.0 { "+" } else { "" };
    match freedom.descriptor().amount {
        Amount::Factor => format!("× {}", mark.number(amount.exp2(), 4)),
        Amount::Length => format!("{sign}{}", mark.number(amount, 4)),
        Amount::Angle => format!("{sign}{}°", mark.number(amount, 5)),
    }
}

/// The name, which opens the operation, and − step +.
fn controls(ui: &mut egui::Ui, t: &'static Texts, model: &mut Model, freedom: Freedom) {
    let name = name(freedom, t);
    let output = ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let is_open = model.operations.shows(freedom);
        let explained = explained(freedom, t, model.operations.convention);
        let sign = if is_open { "▾" } else { "▸" };
        let title = egui::Button::new(format!("{sign} {name}")).frame(false).truncate();
        let rest = 2.0 * BUTTON + STEP + 3.0 * ui.spacing().item_spacing.x;
        let place = egui::vec2((ui.available_width() - rest).max(0.0), ui.spacing().interact_size.y);
        let left = Layout::left_to_right(Align::Center);
        let title = ui.allocate_ui_with_layout(place, left, |ui| {
            ui.set_min_size(place);
            let title = ui.add(title);
            let errata = [(Freedom::Yaw, t.erratum_yaw), (Freedom::Pitch, t.erratum_pitch)];
            errata.iter().filter(|(of, _)| *of == freedom).for_each(|(_, text)| erratum(ui, t, text));
            title
        });
        let title = title.inner.explained(explained).accessible_name(name);
        title.widget_info(|| egui::WidgetInfo::selected(egui::Role::DisclosureTriangle, true, is_open, name));
        if title.clicked() {
            model.operations.open(freedom);
            model.operations.close_others();
        }
        button(ui, t, model, freedom, false);
        let step = &mut model.operations.steps[freedom as usize];
        let title = step_name(freedom, t);
        let field = match freedom.descriptor().amount {
            Amount::Factor => NumberField::new(title, Step::Multiply(1.1)).prefix("×"),
            Amount::Length => NumberField::new(title, Step::Multiply(1.1)),
            Amount::Angle => NumberField::angle(title, 5.0),
        };
        let output = field.positive().width(STEP).hint(t.step_hint).show(ui, t, step);
        button(ui, t, model, freedom, true);
        output
    });
    complain(ui, t.lang, [&output.inner]);
}

/// The widths of a button and of the field of its step, in points.
const BUTTON: f32 = 38.0;
const STEP: f32 = 58.0;

fn button(ui: &mut egui::Ui, t: &Texts, model: &mut Model, freedom: Freedom, forwards: bool) {
    let sign = if forwards { "+" } else { "−" };
    let arrow = arrow(model.desk.shown.camera(), freedom, forwards, model.operations.convention);
    let text = arrow.map_or_else(|| sign.to_owned(), |arrow| format!("{sign} {arrow}"));
    let button = egui::Button::new(text).min_size(egui::vec2(BUTTON, 0.0));
    let name = format!("{} {sign}", name(freedom, t));
    if ui.add(button).accessible_name(name).explained(explained(freedom, t, model.operations.convention)).clicked() {
        let step = model.operations.steps[freedom as usize];
        let amount = if forwards { step } else { freedom.descriptor().amount.inverse(step) };
        model.operations.open(freedom);
        if !model.predict_first(freedom, amount) {
            model.begin_motion(freedom, amount);
        }
    }
}

/// The effect of an operation, and the direction of a positive angle.
fn explained(freedom: Freedom, t: &Texts, convention: Convention) -> String {
    let effect = match freedom {
        Freedom::Azimuth => format!("{}. {}", effect(freedom, t), t.azimuth_of_vtk),
        _ => effect(freedom, t).to_owned(),
    };
    match (freedom.descriptor().amount, convention) {
        (Amount::Factor | Amount::Length, _) => effect,
        (Amount::Angle, Convention::RightHand) => format!("{effect}. {}", t.sign_right_hand),
        (Amount::Angle, Convention::Vtk) => format!("{effect}. {}", t.sign_vtk),
    }
}

/// Sliders of angles stop at multiples of so many degrees.
const SNAP: f64 = 5.0;

/// Draws the springs that bring a knob back to the middle. `share` is its place, 0 … 1.
fn springs(ui: &egui::Ui, place: egui::Rect, share: f32) {
    let radius = place.height() / 3.0;
    let rail = place.shrink2(egui::vec2(radius, 0.0));
    let knob = egui::lerp(rail.left()..=rail.right(), share);
    let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
    let high = 0.22 * place.height();
    for (end, beside) in [(rail.left(), knob - radius), (rail.right(), knob + radius)] {
        let at = |k: u8| {
            let up = if k == 0 || k == COILS {
                0.0
            } else if k.is_multiple_of(2) {
                high
            } else {
                -high
            };
            egui::pos2(egui::lerp(end..=beside, f32::from(k) / f32::from(COILS)), place.center().y + up)
        };
        ui.painter().line((0..=COILS).map(at).collect(), stroke);
    }
}

/// Corners of a spring.
const COILS: u8 = 12;

/// Pulls the camera from its position when the slider was grabbed. Springs back when it's released.
fn slider(ui: &mut egui::Ui, t: &Texts, model: &mut Model, freedom: Freedom) {
    let free = ui.input(|input| input.modifiers.command);
    let (range, grain) = match freedom.descriptor().amount {
        Amount::Factor => (3.0, 0.05),
        Amount::Length => {
            let start = model.operations.scrub.as_ref().map_or(model.desk.shown.camera(), |s| &s.start);
            (start.distance(), 0.0)
        }
        Amount::Angle if free => (180.0, 0.0),
        Amount::Angle => (180.0, SNAP),
    };
    let mut amount = model.operations.scrub.as_ref().filter(|scrub| scrub.freedom == freedom).map_or(0.0, |s| s.amount);
    ui.spacing_mut().slider_width = ui.available_width().max(40.0);
    // Springs take the place of the rail.
    ui.spacing_mut().slider_rail_height = 0.0;
    theme::strengthen_rail(ui);
    // A pixel is several degrees wide and always contains a round number.
    let slider = Slider::new(&mut amount, -range..=range).show_value(false).step_by(grain).smart_aim(!free);
    let response = ui.add(slider).explained(t.scrub_hint);
    let response = response.accessible_name(format!("{}: {}", name(freedom, t), t.scrub));
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    springs(ui, response.rect, ((amount + range) / (2.0 * range)).clamp(0.0, 1.0) as f32);
    if response.drag_started() {
        model.operations.scrub = Some(Scrub { freedom, start: model.desk.shown.camera().clone(), amount: 0.0 });
    }
    // The position at the release counts too, because the pointer may have moved since the last frame.
    if response.dragged() || response.drag_stopped() {
        let convention = model.operations.convention;
        if let Some(scrub) = model.operations.scrub.as_mut().filter(|scrub| scrub.freedom == freedom) {
            model.frame.hover.ghost =
                Some(Ghost { before: scrub.start.clone(), operation: pulled(freedom, amount), convention });
            if scrub.amount != amount {
                scrub.amount = amount;
                let done = if amount == 0.0 {
                    model.desk.shown.set_camera(scrub.start.clone());
                    Ok(())
                } else {
                    model.desk.shown.operate_from(&scrub.start, pulled(freedom, amount), convention)
                };
                model.say_camera_error(done);
            }
        }
        if response.drag_stopped() && amount != 0.0 {
            model.operations.last = model.frame.hover.ghost.clone();
        }
    } else if response.changed() {
        let (before, operation) = (model.desk.shown.camera().clone(), pulled(freedom, amount));
        model.operations.last = Some(Ghost { before, operation, convention: model.operations.convention });
        model.operate(operation);
    }
}
