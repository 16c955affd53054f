//! The explanation of other vocabularies: the camera in the words of other sources, whose numbers are controls.

use eframe::egui::{self, RichText};

use super::pasted_matrix::{self, note_on_matrix, take};
use crate::camera::{Camera, Parameters, Projection};
use crate::explain::vocabulary::{Argument, CameraNumber, Limitation, Line, Vocabulary};
use crate::explain::{Axis, Component, Symbol};
use crate::gui::kit::{
    Explained, FieldOutput, NumberField, Step, complaint, has_focus, help_topic, help_topic_row, section, theme,
};
use crate::gui::why::measures::of_symbol;
use crate::gui::why::state::explain::Explain;
use crate::numbers::{is_rest, power_of_ten};
use camera_lab_desk::Model;
use camera_lab_words::why::dialects;
use camera_lab_words::{messages, window};

/// Shows the tab.
pub(in crate::gui::why) fn ui(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain) {
    let t = dialects::texts(model.settings.lang);
    for vocabulary in Vocabulary::ALL {
        let (title, id) = dialects::title(t.lang, vocabulary);
        let title = section(ui, title, id, true, |ui| words(ui, model, explain, vocabulary));
        help_topic(&title, note_on_vocabulary(vocabulary));
    }
    let title = section(ui, t.pasted, "pasted matrix", true, |ui| pasted_matrix::ui(ui, model, explain));
    help_topic(&title, note_on_matrix(explain.pasted.kind));
}

/// The note on a vocabulary.
const fn note_on_vocabulary(vocabulary: Vocabulary) -> &'static str {
    match vocabulary {
        Vocabulary::OpenGl => "M_p",
        Vocabulary::Vrc => "handedness",
        Vocabulary::ReferencePoint => "view-volume",
        Vocabulary::Pinhole => "K",
    }
}

/// The note on a number in the notes' words.
const fn note_on(quantity: CameraNumber, vocabulary: Vocabulary) -> &'static str {
    match quantity {
        CameraNumber::Position(_) => "C",
        CameraNumber::FocalPoint(_) => "PF",
        CameraNumber::ViewUp(_) => "VUP",
        CameraNumber::Direction(_) => "DOP",
        CameraNumber::ViewAngle => "theta",
        CameraNumber::Aspect => "A",
        CameraNumber::Left | CameraNumber::Right | CameraNumber::Bottom | CameraNumber::Top => "window",
        CameraNumber::HalfWidth => "W",
        CameraNumber::HalfHeight => "H",
        CameraNumber::Near | CameraNumber::NearCoordinate => "F",
        CameraNumber::Far | CameraNumber::FarCoordinate => "B",
        CameraNumber::FocalLength(_) | CameraNumber::PrincipalPoint(_) => "K",
        CameraNumber::Translation(_) => "step-to-eye",
        CameraNumber::Axis(Axis::U, _) => "u",
        CameraNumber::Axis(Axis::V, _) => "v",
        CameraNumber::Axis(Axis::N, _) => "n",
        CameraNumber::Fixed => note_on_vocabulary(vocabulary),
    }
}

/// The lines of a vocabulary.
fn words(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain, vocabulary: Vocabulary) {
    let lang = model.settings.lang;
    let (camera, image) = (model.desk.shown.camera().clone(), model.desk.shown.figure().image);
    let lines = match vocabulary.lines(&camera, image) {
        Ok(lines) => lines,
        Err(limitation) => {
            let said = dialects::limitation(lang, limitation);
            theme::wrapped(ui, &said, &egui::TextStyle::Body, ui.visuals().weak_text_color());
            if limitation == Limitation::PerspectiveOnly {
                to_perspective(ui, model, &camera);
            }
            return;
        }
    };
    for line in &lines {
        let set = numbers(ui, model, explain, vocabulary, line);
        let of_line = |quantity| line.arguments.iter().any(|argument| argument.quantity == quantity);
        if let Some((of, quantity, _, error)) = &explain.refused
            && *of == vocabulary
            && of_line(*quantity)
        {
            complaint(ui, &messages::camera(lang, error));
        }
        if let Some((quantity, value)) = set {
            let parameters = vocabulary.set(&camera, image, quantity, value);
            explain.refused = match Camera::new(&parameters) {
                Ok(_) => {
                    take(model, parameters);
                    None
                }
                Err(error) => Some((vocabulary, quantity, value, error)),
            };
        }
    }
    for limitation in vocabulary.limitations() {
        let said = dialects::limitation(lang, *limitation);
        theme::wrapped(ui, &said, &egui::TextStyle::Small, ui.visuals().weak_text_color());
    }
}

/// A button that makes the camera a perspective one.
fn to_perspective(ui: &mut egui::Ui, model: &mut Model, camera: &Camera) {
    let t = dialects::texts(model.settings.lang);
    if ui.button(t.to_perspective).explained(t.to_perspective_hint).clicked() {
        match camera.with_projection(Projection::Perspective) {
            Ok(camera) => model.desk.shown.set_camera(camera),
            // Impossible parameters stay in the draft, with the reason beside its fields.
            Err(_) => take(model, Parameters { projection: Projection::Perspective, ..*camera.parameters() }),
        }
    }
}

/// The room for a symbol, in points.
const SYMBOL: f32 = 56.0;
/// Numbers in a row: those of a vector, or of a row of a matrix.
const IN_A_ROW: usize = 3;

/// A line with a field for each number. Returns the changed one.
fn numbers(
    ui: &mut egui::Ui,
    model: &mut Model,
    explain: &Explain,
    vocabulary: Vocabulary,
    line: &Line,
) -> Option<(CameraNumber, f64)> {
    let (mut set, mut error) = (None, None);
    let is_call = line.name.starts_with("gl");
    if is_call {
        ui.label(RichText::new(line.name).monospace().strong());
    }
    let gap = 4.0;
    #[expect(clippy::cast_precision_loss, reason = "three")]
    let in_a_row = IN_A_ROW as f32;
    let indent = if is_call { 12.0 } else { SYMBOL };
    let width = ((ui.available_width() - indent - in_a_row * gap) / in_a_row).floor().clamp(60.0, 130.0);
    for (i, row) in line.arguments.chunks(IN_A_ROW).enumerate() {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            let (place, _) = ui.allocate_exact_size(egui::vec2(indent - gap, 1.0), egui::Sense::hover());
            if i == 0 && !is_call {
                let galley = ui.painter().layout_job(theme::symbol(ui, line.name));
                let at = egui::pos2(place.left(), ui.max_rect().center().y - galley.size().y / 2.0);
                ui.painter().galley(at, galley, ui.visuals().text_color());
            }
            for argument in row {
                let shown = ui.scope(|ui| number(ui, model, explain, vocabulary, line, argument, width));
                let rect = shown.response.rect;
                help_topic_row(ui, rect, note_on(argument.quantity, vocabulary));
                let (value, output) = shown.inner;
                // Another window can change the lines above, so a dragged field may leave the pointer.
                if ui.rect_contains_pointer(rect) || has_focus(ui, rect) || output.held {
                    light(model, argument.quantity);
                }
                set = value.map(|value| (argument.quantity, value)).or(set);
                error = output.error.or(error.take());
            }
        });
        if let Some(error) = error.take() {
            complaint(ui, &error.text(model.settings.lang));
        }
    }
    set
}

/// Highlights the effects of a number: lengths and axes in the world, and entries of matrices that depend on them.
fn light(model: &mut Model, quantity: CameraNumber) {
    let symbols: &[Symbol] = match quantity {
        CameraNumber::Position(c) => &[Symbol::Position(c)],
        CameraNumber::FocalPoint(c) => &[Symbol::FocalPoint(c)],
        CameraNumber::ViewUp(c) => &[Symbol::ViewUp(c)],
        CameraNumber::Axis(axis, c) => &[Symbol::Axis(axis, c)],
        CameraNumber::ViewAngle => &[Symbol::ViewAngle],
        CameraNumber::Left => &[Symbol::Left],
        CameraNumber::Right => &[Symbol::Right],
        CameraNumber::Bottom => &[Symbol::Bottom],
        CameraNumber::Top => &[Symbol::Top],
        CameraNumber::Aspect | CameraNumber::HalfWidth | CameraNumber::FocalLength(Component::X) => &[Symbol::Width],
        CameraNumber::HalfHeight | CameraNumber::FocalLength(_) => &[Symbol::Height],
        CameraNumber::Near | CameraNumber::NearCoordinate => &[Symbol::Near],
        CameraNumber::Far | CameraNumber::FarCoordinate => &[Symbol::Far],
        CameraNumber::PrincipalPoint(Component::X) => &[Symbol::Left, Symbol::Right],
        CameraNumber::PrincipalPoint(_) => &[Symbol::Bottom, Symbol::Top],
        CameraNumber::Translation(c) => {
            // u · C, v · C and n · C, but for their signs.
            model.frame.hover.measured.push(crate::figure::Measured::OriginAlong(c.index()));
            &[]
        }
        CameraNumber::Direction(_) | CameraNumber::Fixed => &[],
    };
    model.frame.hover.measured.extend(symbols.iter().filter_map(|symbol| of_symbol(*symbol)));
    model.frame.hover.pointed.extend_from_slice(symbols);
}

/// A number: a field, or a label if it can't be set.
fn number(
    ui: &mut egui::Ui,
    model: &Model,
    explain: &Explain,
    vocabulary: Vocabulary,
    line: &Line,
    argument: &Argument,
    width: f32,
) -> (Option<f64>, FieldOutput) {
    let lang = model.settings.lang;
    let t = dialects::texts(lang);
    // A name before the line isn't repeated.
    let prefix = if line.name == argument.name { "" } else { argument.name };
    let greatest = line.arguments.iter().fold(0.0_f64, |greatest, a| greatest.max(a.value.abs()));
    if argument.quantity == CameraNumber::Fixed {
        let value = if is_rest(argument.value, greatest) { 0.0 } else { argument.value };
        let text = format!("{prefix} {}", lang.mark().number(value, model.settings.digits));
        let job = theme::lowered(ui, text.trim(), &egui::TextStyle::Body, ui.visuals().weak_text_color());
        let label = egui::Label::new(job).truncate();
        let label = ui.add_sized([width, ui.spacing().interact_size.y], label).explained(t.fixed_hint);
        let said = text.trim().replace(['{', '}'], "");
        label.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &said));
        return (None, FieldOutput::default());
    }
    let refused = explain.refused.as_ref().filter(|refused| (refused.0, refused.1) == (vocabulary, argument.quantity));
    let shown = refused.map_or(argument.value, |refused| refused.2);
    let mut value = shown;
    let step = power_of_ten(argument.value.abs().max(1e-6) / 5.0).unwrap_or(0.1).max(1e-9);
    let name = format!("{} {}", line.name, argument.name).replace(['{', '}'], "");
    let field = match argument.quantity {
        CameraNumber::ViewAngle => NumberField::angle(name, 5.0),
        CameraNumber::Axis(..) => NumberField::new(name, Step::Add(0.02)).within(-1.0..=1.0),
        CameraNumber::FocalLength(_) => NumberField::new(name, Step::Multiply(1.02)).positive(),
        CameraNumber::Aspect => NumberField::new(name, Step::Multiply(1.1)).fractions(),
        CameraNumber::Near | CameraNumber::Far | CameraNumber::HalfWidth | CameraNumber::HalfHeight => {
            NumberField::new(name, Step::Multiply(1.1))
        }
        _ => NumberField::new(name, Step::Add(step)),
    };
    let output = field
        .of(dialects::title(lang, vocabulary).1)
        .prefix(prefix)
        .hint(dialects::number_hint(lang, argument.quantity))
        .width(width)
        .beside(greatest)
        .marked(refused.is_some())
        .show(ui, window::texts(lang), &mut value);
    ((value.to_bits() != shown.to_bits()).then_some(value), output)
}
