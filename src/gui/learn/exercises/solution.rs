//! The way to an answer, step by step, and the camera that a wrong answer describes.

use eframe::egui::{Button, Id, Key, Rect, Response, Ui, UiBuilder};
use glam::{DMat4, DVec3};

use super::{Sheet, figure};
use crate::camera::{Camera, MatrixKind, Parameters, Reading, RecoveryError, recover};
use crate::exercises::{Answer, Ask, Exercise, Expected, Judged, Worked};
use crate::explain::{Notation, Style};
use crate::expression::{Dimension, evaluate_with};
use crate::gui::kit::{Both, Explained, Links, TextField, chain, complaint, prose, toggle};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{Described, NotCamera};
use crate::inspect::quantity::{BasisAxis, Quantity, QuantityPath, ReportMatrix};
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercise_window as words, exercises as said};
use camera_lab_words::why::dialects;

/// The button of the next help. It keeps the focus, whatever appears above it, because `id` identifies it, and not its
/// place.
pub(super) fn help_button(ui: &mut Ui, id: Id, (label, hint, name): (&str, &'static str, &str)) -> Response {
    let own = UiBuilder::new().scope_id(id.with("help"));
    let button = ui.scope_builder(own, |ui| ui.button(label)).inner;
    button.explained(hint).accessible_name(words::of_ask(label, name))
}

/// The button of the next step.
pub(super) fn step_button(ui: &mut Ui, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, id: Id) {
    let Sheet { t, exercise, .. } = sheet;
    let name = said::ask(t.lang, exercise, ask).replace("**", "");
    let opened = learn.exercises.opened.get(&ask.name).cloned().unwrap_or_default();
    let rest = opened.way.as_ref().is_none_or(|way| opened.steps < way.len());
    let has_none = match ask.expected() {
        Expected::Choice(_, _, steps) | Expected::Computed(_, steps) => steps.is_empty(),
        Expected::Quantity(..) | Expected::Camera(..) => false,
    };
    let waits = opened.steps.checked_sub(1).is_some_and(|last| opened.is_to_do(last));
    if has_none || !(rest || waits) {
        return;
    }
    let label = if opened.steps == 0 { t.first_step } else { t.next_step };
    let next = (!waits).then(|| help_button(ui, id, (label, t.step_hint, &name)));
    let all = ui.button(t.all_steps).explained(t.all_steps_hint).accessible_name(words::of_ask(t.all_steps, &name));
    let (all, is_next) = (all.clicked(), next.as_ref().is_some_and(Response::clicked));
    if all || is_next {
        let progress = &learn.exercises.progress;
        let opened = learn.exercises.opened.entry(ask.name.clone()).or_default();
        if opened.way.is_none() {
            // A later solution takes no step away from this one.
            opened.given = progress.given_steps(&exercise.id, ask.steps().len());
        }
        let count = opened.way.get_or_insert_with(|| ask.steps().into()).len();
        opened.steps = if all { count } else { opened.steps + 1 };
        if next.is_some_and(|next| next.has_focus()) && opened.steps >= count {
            // There is no next one, so the focus returns to the answer.
            learn.exercises.wants_focus = Some(ask.name.clone());
        }
        if all && (0..count).any(|step| opened.is_to_do(step)) {
            opened.filled.extend(0..count);
            learn.exercises.note_stepped(exercise, ask, false);
        }
        learn.exercises.note_opened(exercise, ask);
        learn.exercises.say(ask);
    }
}

/// Shows the camera that a wrong answer describes, beside the right one, or hides it.
pub(super) fn camera_button(ui: &mut Ui, model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, id: Id) {
    let Sheet { t, exercise, .. } = sheet;
    let name = said::ask(t.lang, exercise, ask).replace("**", "");
    let shows = |ui: &mut Ui, label: &str| {
        let own = UiBuilder::new().scope_id(id.with("camera"));
        ui.scope_builder(own, |ui| ui.button(label)).inner.accessible_name(words::of_ask(label, &name))
    };
    if learn.exercises.described.as_ref().is_some_and(|described| described.ask == ask.name) {
        if shows(ui, t.hide_camera).clicked() {
            learn.exercises.described = None;
        }
        return;
    }
    let Some(judged) = learn.exercises.checked.get(&ask.name).map(|checked| &checked.judged) else { return };
    if judged.right || !describes_camera(ask, judged) {
        return;
    }
    if !shows(ui, t.show_camera).explained(t.show_camera_hint).clicked() {
        return;
    }
    let Some((right, camera)) = described(exercise, ask, &judged.understood) else { return };
    let camera = camera.map(Box::new);
    if camera.is_ok() && *model.desk.shown.figure() != figure::with_camera(exercise, right) {
        model.show_figure_of_exercise(figure::with_camera(exercise, right));
    }
    learn.exercises.described = Some(Described { ask: ask.name.clone(), camera });
}

/// The quantity of `inspect` that the question asks for as a whole, if there is one.
fn quantity(ask: &Ask) -> Option<Quantity> {
    let path = match ask.expected() {
        Expected::Quantity(_, path) => Some(*path),
        Expected::Computed(..) | Expected::Choice(..) | Expected::Camera(..) => ask.quantity,
    };
    path.filter(|QuantityPath { entry, .. }| entry[0].is_none()).map(|path| path.quantity)
}

/// True for complete answers that describe a camera.
fn describes_camera(ask: &Ask, judged: &Judged) -> bool {
    match &judged.understood {
        Answer::Camera(_) => true,
        Answer::Choice(_) => false,
        Answer::Numbers { rows, columns, entries } => {
            [*rows, *columns] == ask.shape() && entries.iter().all(Option::is_some) && matrix_kind(ask).is_some()
                || matches!(quantity(ask), Some(Quantity::Axis(_)))
                    && entries.len() == 3
                    && entries.iter().all(Option::is_some)
        }
    }
}

/// The kind of a matrix, and true if it's the inverse.
fn matrix_kind(ask: &Ask) -> Option<(MatrixKind, bool)> {
    let Some(Quantity::Matrix(matrix)) = quantity(ask) else { return None };
    Some(match matrix {
        ReportMatrix::View => (MatrixKind::View, false),
        ReportMatrix::InverseView => (MatrixKind::View, true),
        ReportMatrix::Projection => (MatrixKind::Projection, false),
        ReportMatrix::InverseProjection => (MatrixKind::Projection, true),
        ReportMatrix::ViewProjection => (MatrixKind::ViewProjection, false),
    })
}

/// The right camera, and the one that an answer describes.
fn described(exercise: &Exercise, ask: &Ask, answer: &Answer) -> Option<(Parameters, Result<Camera, NotCamera>)> {
    let camera = |parameters: &Parameters| {
        Camera::new(parameters).map_err(|error| NotCamera::Matrix(RecoveryError::from(error)))
    };
    if let (Answer::Camera(parameters), Expected::Camera(_, model, ..)) = (answer, ask.expected()) {
        return Some((**model, camera(parameters)));
    }
    let right = figure::subject_of(exercise, ask).camera().ok()?;
    let Answer::Numbers { entries, .. } = answer else { return None };
    let numbers: Vec<f64> = entries.iter().copied().collect::<Option<_>>()?;
    let found = match matrix_kind(ask) {
        Some((kind, is_inverse)) => {
            let matrix = DMat4::from_cols_array(&numbers.try_into().ok()?).transpose();
            let matrix = if is_inverse { matrix.inverse() } else { matrix };
            let found = recover(&Reading::of(kind), matrix, right.parameters()).map_err(NotCamera::Matrix);
            found.map(|found| found.parameters)
        }
        None => {
            let Some(Quantity::Axis(of)) = quantity(ask) else { return None };
            with_axis(&right, of, DVec3::from_array(numbers.try_into().ok()?))
        }
    };
    Some((*right.parameters(), found.and_then(|found| camera(&found))))
}

/// The camera at the same place that has an axis of an answer, and as much of the other axes as is compatible.
fn with_axis(right: &Camera, of: BasisAxis, axis: DVec3) -> Result<Parameters, NotCamera> {
    /// The tolerance of lengths and cosines, for answers of three digits.
    const TOLERANCE: f64 = 2e-3;
    let (parameters, n) = (*right.parameters(), right.basis().n);
    if (axis.length() - 1.0).abs() > TOLERANCE {
        return Err(NotCamera::Length(axis.length()));
    }
    if of == BasisAxis::N {
        let distance = parameters.position.distance(parameters.focal_point);
        return Ok(Parameters { focal_point: parameters.position - distance * axis, ..parameters });
    }
    if axis.dot(n).abs() > TOLERANCE {
        return Err(NotCamera::Oblique(axis.dot(n)));
    }
    let view_up = if of == BasisAxis::U { n.cross(axis) } else { axis };
    Ok(Parameters { view_up, ..parameters })
}

/// The reason why an answer describes no camera.
fn not_camera(lang: camera_lab_words::Lang, why: &NotCamera) -> String {
    match why {
        NotCamera::Matrix(error) => dialects::recovery_error(lang, error),
        NotCamera::Length(length) => words::axis_length(lang, *length),
        NotCamera::Oblique(product) => words::axis_oblique(lang, *product),
    }
}

/// The open steps, set as mathematics, and the reason why there is no camera. Returns the place of the last step.
pub(super) fn steps(ui: &mut Ui, model: &Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask) -> Option<Rect> {
    let Sheet { t, exercise, .. } = sheet;
    let described = learn.exercises.described.as_ref().filter(|described| described.ask == ask.name);
    if let Some(Err(error)) = described.map(|described| &described.camera) {
        complaint(ui, &format!("{}: {}", t.no_camera, not_camera(t.lang, error)));
    }
    let opened = learn.exercises.opened.get(&ask.name)?.clone();
    let way: Option<std::sync::Arc<[Worked]>> = opened.way.clone();
    let mut last = None;
    for (k, step) in way.iter().flat_map(|way| way.iter()).take(opened.steps).enumerate() {
        let shown = ui.push_id(("step", k), |ui| {
            let is_to_do = opened.is_to_do(k);
            self::step(ui, model, sheet, exercise, (step, is_to_do));
            if is_to_do {
                to_do(ui, learn, sheet, ask, (k, step));
            }
        });
        last = Some(shown.response.rect);
    }
    last
}

/// The field of a step to be done: the number of its last row.
fn to_do(ui: &mut Ui, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, (k, step): (usize, &Worked)) {
    let (t, name) = (sheet.t, said::ask(sheet.t.lang, sheet.exercise, ask).replace("**", ""));
    let Some(opened) = learn.exercises.opened.get_mut(&ask.name) else { return };
    let (mut is_right, mut is_shown) = (None, false);
    ui.horizontal_wrapped(|ui| {
        ui.label(t.your_step);
        let text = opened.typed.entry(k).or_default();
        let field = TextField::line(text, crate::limits::MAX_ANSWER)
            .with(|edit| edit.id_salt("step to do").desired_width(110.0));
        let response = field.show(ui, t.lang).explained(t.your_step_hint);
        let response = response.accessible_name(words::of_ask(t.your_step, &name));
        let enters = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let numbers = &sheet.exercise.free;
        let number = [Dimension::Number, Dimension::Angle].map(|of| evaluate_with(text.trim(), of, numbers).ok());
        let is_number = number.iter().any(Option::is_some);
        let checks = ui.add_enabled(is_number, Button::new(t.check));
        if checks.accessible_name(words::of_ask(t.check_step, &name)).clicked() || enters && is_number {
            let number = number.into_iter().flatten().any(|number| step.ends_with(number));
            (is_right, opened.missed) = (Some(number), Some(k).filter(|_| !number));
        }
        is_shown = ui.button(t.show_step).explained(t.step_hint).clicked();
        if opened.missed == Some(k) {
            ui.colored_label(ui.visuals().error_fg_color, format!("✗ {}", t.wrong));
        }
    });
    if is_right == Some(true) || is_shown {
        opened.missed = None;
        opened.filled.insert(k);
    }
    let (has_failed, is_at_end) = (is_shown || is_right == Some(false), opened.is_at_end());
    if has_failed || is_right == Some(true) && is_at_end {
        learn.exercises.note_stepped(sheet.exercise, ask, !has_failed);
    }
    if is_right == Some(true) || is_shown {
        learn.exercises.say(ask);
    }
}

/// A step: its heading, its equation, and its rows.
fn step(ui: &mut Ui, model: &Model, sheet: Sheet<'_>, exercise: &Exercise, (step, is_to_do): (&Worked, bool)) {
    ui.add_space(2.0);
    prose::show(ui, &said::step_heading(sheet.t.lang, exercise, step));
    rows(ui, model, sheet, (step, is_to_do));
}

/// Each row of a step as symbol = formula = numbers = value. If the step is to be done, its last row ends with the
/// formula.
fn rows(ui: &mut Ui, model: &Model, sheet: Sheet<'_>, (step, is_to_do): (&Worked, bool)) {
    let mark = sheet.t.lang.mark();
    let style = |notation| Style { notation, mark, digits: model.settings.digits };
    let lines = step.lines(style(Notation::Latex), true);
    let last = lines.len().saturating_sub(1);
    for (k, (latex, text)) in lines.into_iter().zip(step.lines(style(Notation::Text), true)).enumerate() {
        let both = |latex: String, text: String| Both { latex, text };
        let said =
            [both(latex.formula, text.formula), both(latex.numbers, text.numbers), both(latex.value, text.value)];
        let shown = if is_to_do && k == last { &said[..1] } else { &said };
        chain(ui, &both(latex.symbol, text.symbol), shown, Links::Dense);
    }
}

/// The solution of a student, if the exercise is about one. A click on the number of a line answers the question for
/// it.
pub(super) fn faulty(ui: &mut Ui, model: &Model, learn: &mut Learn, sheet: Sheet<'_>) {
    let Some((fault, ask)) = sheet.exercise.fault().zip(sheet.exercise.asks.first()) else { return };
    let mut number = 0;
    for step in &fault.steps {
        prose::show(ui, &said::step_heading(sheet.t.lang, sheet.exercise, step));
        for row in step.by_rows() {
            number += 1;
            let name = format!("{number}");
            ui.horizontal_top(|ui| {
                let is_marked = learn.exercises.fields(ask).first() == Some(&name);
                if toggle(ui, is_marked, &name).explained(sheet.t.mark_line).clicked() {
                    learn.exercises.type_into(ask, vec![name]);
                }
                ui.vertical(|ui| rows(ui, model, sheet, (&row, false)));
            });
        }
    }
}
