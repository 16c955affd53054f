//! The explanation of other vocabularies: the camera in the words of other sources, whose numbers are controls, and a
//! pasted matrix → its camera.

use eframe::egui::{self, RichText};
use glam::DMat4;

use crate::camera::{Camera, MatrixKind, Ndc, Parameters, RecoveryError, recover};
use crate::explain::Axis;
use crate::explain::vocabulary::{Argument, CameraNumber, Line, Vocabulary};
use crate::expression::{self, Dimension};
use crate::gui::context_help::{help_topic, help_topic_row};
use crate::gui::number_field::{NumberField, Step};
use crate::gui::panels::{choice, complaint, section};
use crate::gui::state::State;
use crate::gui::text_field::TextField;
use crate::gui::theme;
use crate::gui::tooltip::Explained;
use crate::i18n::{dialects, messages, window};
use crate::limits::MAX_ANSWER;
use crate::numbers::{is_rest, power_of_ten};

/// Shows the tab.
pub(super) fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = dialects::texts(state.settings.lang);
    for vocabulary in Vocabulary::ALL {
        let (title, id) = dialects::title(t.lang, vocabulary);
        let title = section(ui, title, id, true, |ui| words(ui, state, vocabulary));
        help_topic(&title, note_on_vocabulary(vocabulary));
    }
    let title = section(ui, t.pasted, "pasted matrix", true, |ui| pasted(ui, state));
    help_topic(&title, note_on_matrix(state.explain.pasted.kind));
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

const fn note_on_matrix(kind: MatrixKind) -> &'static str {
    match kind {
        MatrixKind::View => "M_v",
        MatrixKind::Projection => "M_p",
        MatrixKind::ViewProjection => "M_pM_v",
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
fn words(ui: &mut egui::Ui, state: &mut State, vocabulary: Vocabulary) {
    let lang = state.settings.lang;
    let (camera, image) = (state.document.camera().clone(), state.document.figure().image);
    let lines = match vocabulary.lines(&camera, image) {
        Ok(lines) => lines,
        Err(limitation) => {
            let said = dialects::limitation(lang, limitation);
            theme::wrapped(ui, said, &egui::TextStyle::Body, ui.visuals().weak_text_color());
            return;
        }
    };
    for line in &lines {
        if let Some((quantity, value)) = numbers(ui, state, vocabulary, line) {
            let parameters = vocabulary.set(&camera, image, quantity, value);
            state.explain.refused = match Camera::new(&parameters) {
                Ok(_) => {
                    take(state, parameters);
                    None
                }
                Err(error) => Some((vocabulary, quantity, value, error)),
            };
        }
    }
    if let Some((_, _, _, error)) = state.explain.refused.as_ref().filter(|refused| refused.0 == vocabulary) {
        complaint(ui, &messages::camera(lang, error));
    }
    for limitation in vocabulary.limitations() {
        let said = dialects::limitation(lang, *limitation);
        theme::wrapped(ui, said, &egui::TextStyle::Small, ui.visuals().weak_text_color());
    }
}

/// Takes parameters over. Where they have an aspect of their own, it no longer follows the image.
fn take(state: &mut State, parameters: Parameters) {
    let own = parameters.window.is_none() && parameters.aspect.to_bits() != state.document.draft().aspect.to_bits();
    state.settings.aspect_follows_image &= !own;
    state.document.set_parameters(parameters);
}

/// The room for a symbol, in points.
const SYMBOL: f32 = 56.0;
/// Numbers in a row: those of a vector, or of a row of a matrix.
const IN_A_ROW: usize = 3;

/// A line with a field for each number; returns the one that was set.
fn numbers(ui: &mut egui::Ui, state: &State, vocabulary: Vocabulary, line: &Line) -> Option<(CameraNumber, f64)> {
    let mut set = None;
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
                let shown = ui.scope(|ui| number(ui, state, vocabulary, line, argument, width));
                help_topic_row(ui, shown.response.rect, note_on(argument.quantity, vocabulary));
                if let Some(value) = shown.inner {
                    set = Some((argument.quantity, value));
                }
            }
        });
    }
    set
}

/// A number: a field, or a label where it cannot be set.
fn number(
    ui: &mut egui::Ui,
    state: &State,
    vocabulary: Vocabulary,
    line: &Line,
    argument: &Argument,
    width: f32,
) -> Option<f64> {
    let lang = state.settings.lang;
    let t = dialects::texts(lang);
    // A name before the line is not repeated.
    let prefix = if line.name == argument.name { "" } else { argument.name };
    let greatest = line.arguments.iter().fold(0.0_f64, |greatest, a| greatest.max(a.value.abs()));
    if matches!(argument.quantity, CameraNumber::Fixed | CameraNumber::Axis(..)) {
        let value = if is_rest(argument.value, greatest) { 0.0 } else { argument.value };
        let text = format!("{prefix} {}", lang.mark().number(value, state.settings.digits));
        let job = theme::lowered(ui, text.trim(), &egui::TextStyle::Body, ui.visuals().weak_text_color());
        let label = egui::Label::new(job).truncate();
        let label = ui.add_sized([width, ui.spacing().interact_size.y], label).explained(t.fixed_hint);
        let said = text.trim().replace(['{', '}'], "");
        label.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &said));
        return None;
    }
    let refused =
        state.explain.refused.as_ref().filter(|refused| (refused.0, refused.1) == (vocabulary, argument.quantity));
    let shown = refused.map_or(argument.value, |refused| refused.2);
    let mut value = shown;
    let step = power_of_ten(argument.value.abs().max(1e-6) / 5.0).unwrap_or(0.1).max(1e-9);
    let name = format!("{} {}", line.name, argument.name).replace(['{', '}'], "");
    let field = match argument.quantity {
        CameraNumber::ViewAngle => NumberField::angle(name, 5.0),
        CameraNumber::Aspect => NumberField::new(name, Step::Multiply(1.1)).fractions(),
        CameraNumber::Near | CameraNumber::Far | CameraNumber::HalfWidth | CameraNumber::HalfHeight => {
            NumberField::new(name, Step::Multiply(1.1))
        }
        _ => NumberField::new(name, Step::Add(step)),
    };
    let output = field
        .of(dialects::title(lang, vocabulary).1)
        .prefix(prefix)
        .hint(t.number_hint)
        .width(width)
        .beside(greatest)
        .marked(refused.is_some())
        .show(ui, window::texts(lang), &mut value);
    if let Some(error) = output.error {
        complaint(ui, &error.text(lang));
    }
    (value.to_bits() != shown.to_bits()).then_some(value)
}

/// A field for a matrix, and the camera that has it.
fn pasted(ui: &mut egui::Ui, state: &mut State) {
    let lang = state.settings.lang;
    let t = dialects::texts(lang);
    ui.label(RichText::new(t.pasted_hint).weak());
    let kinds = [MatrixKind::View, MatrixKind::Projection, MatrixKind::ViewProjection]
        .map(|kind| (kind, dialects::kind(lang, kind)));
    let pasted = &mut state.explain.pasted;
    ui.horizontal(|ui| {
        choice(ui, t.kind, t.kind_hint, &mut pasted.kind, &kinds);
        ui.checkbox(&mut pasted.transposed, t.transposed).explained(t.transposed_hint);
    });
    let hint = "1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1";
    let field = TextField::lines(&mut pasted.text, MAX_ANSWER).with(|edit| {
        let edit = edit.desired_rows(4).desired_width(f32::INFINITY);
        edit.hint_text(hint).font(egui::TextStyle::Monospace)
    });
    let field = field.show(ui, lang).accessible_name(t.pasted);
    help_topic(&field, note_on_matrix(pasted.kind));
    if pasted.text.trim().is_empty() {
        return;
    }
    let ndc = state.settings.conventions.ndc;
    let matrix = read(&pasted.text).map(|m| if pasted.transposed { m.transpose() } else { m });
    let matrix = match matrix {
        Ok(matrix) => matrix,
        Err(fault) => return complaint(ui, &dialects::unreadable(lang, &fault)),
    };
    match recover(pasted.kind, matrix, ndc, state.document.draft()) {
        Err(error) => {
            complaint(ui, &dialects::recovery_error(lang, &error));
            // The other way of writing matrices is the usual reason.
            let turned = recover(pasted.kind, matrix.transpose(), ndc, state.document.draft());
            if turned.is_ok() && !matches!(error, RecoveryError::Depths { .. }) {
                ui.label(t.try_transposed);
            }
        }
        Ok(found) => {
            if ndc != Ndc::default() {
                ui.label(RichText::new(format!("{} {}", t.read_as, ndc.name())).small());
            }
            for unknown in &found.unknown {
                ui.label(RichText::new(format!("• {}", dialects::unknown(lang, *unknown))).small());
            }
            if ui.button(t.take).explained(t.take_hint).clicked() {
                take(state, found.parameters);
            }
        }
    }
}

/// Sixteen numbers, in any brackets, apart by spaces, commas, semicolons or line ends, as Python, MATLAB, JSON and GLSL
/// write them; each may be an expression.
fn read(text: &str) -> Result<DMat4, dialects::Unreadable> {
    // Names of constructors such as np.array or mat4 are not numbers.
    let plain: String = text.chars().map(|c| if "[](){}|\n\t;&\\".contains(c) { ' ' } else { c }).collect();
    // A comma is a separator where there are fifteen of them or a space follows; else it is a decimal comma.
    let commas = plain.matches(',').count();
    let separated = if commas >= 12 || plain.contains(", ") { plain.replace(',', " ") } else { plain };
    let parts: Vec<&str> = separated.split_whitespace().collect();
    let mut numbers = Vec::new();
    for part in parts {
        match expression::evaluate(part, Dimension::Number) {
            Ok(number) => numbers.push(number),
            Err(_) if numbers.is_empty() && part.chars().any(char::is_alphabetic) => {}
            Err(_) => return Err(dialects::Unreadable::Part(part.to_owned())),
        }
    }
    let count = numbers.len();
    let rows: [f64; 16] = numbers.try_into().map_err(|_| dialects::Unreadable::Count(count))?;
    Ok(DMat4::from_cols_array(&rows).transpose())
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;

    #[test]
    fn matrices_are_read_as_programs_and_people_write_them() {
        let expected =
            DMat4::from_cols_array(&[1.0, 0.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5, 0.0, 3.0, 0.0, 0.25, 1.0]);
        for text in [
            "1 2 0 3\n0 1 0 0\n0 0 -1.5 0.25\n0 0 0 1",
            "[[1, 2, 0, 3], [0, 1, 0, 0], [0, 0, -1.5, 0.25], [0, 0, 0, 1]]",
            "np.array([[1., 2., 0., 3.],\n [0., 1., 0., 0.],\n [0., 0., -1.5, 0.25],\n [0., 0., 0., 1.]])",
            "[1 2 0 3; 0 1 0 0; 0 0 -3/2 1/4; 0 0 0 1]",
            "1 2 0 3\n0 1 0 0\n0 0 −1,5 0,25\n0 0 0 1",
            r"1 & 2 & 0 & 3 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & -1.5 & 0.25 \\ 0 & 0 & 0 & 1",
            "1,2,0,3,0,1,0,0,0,0,-1.5,0.25,0,0,0,1",
        ] {
            assert_eq!(read(text).unwrap(), expected, "{text}");
        }
        assert_eq!(read("1 2 3"), Err(dialects::Unreadable::Count(3)));
        assert_eq!(read("1 2 x 3"), Err(dialects::Unreadable::Part("x".to_owned())));
    }
}
