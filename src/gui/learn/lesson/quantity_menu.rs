//! The menu of the quantities of a figure, each with its path in the output of `inspect`.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Id, Response, TextEdit, Ui};

use crate::camera::{ParameterKey, Parameters, Projection};
use crate::figure::{Figure, Localized};
use crate::gui::kit::{Explained, TEXT_LINE};
use crate::inspect::Report;
use crate::inspect::quantity::{BasisAxis, PointNumber, Quantity, QuantityPath, ReportMatrix, WindowNumber};
use crate::limits::MAX_TYPED;
use camera_lab_words::Lang;
use camera_lab_words::learn::lesson_tasks::Texts;
use camera_lab_words::learn::lessons::filled_from;
use camera_lab_words::why::explain;
use camera_lab_words::window::parameter;

/// The name of a text, and beside it the menu. A chosen quantity goes to the caret of the field `id`, in braces, if the
/// text has room for it. Returns the name.
pub(super) fn name_with_numbers(
    ui: &mut Ui,
    t: &Texts,
    name: &str,
    subject: Option<(&Figure, &Report)>,
    (id, text): (Id, &mut String),
) -> Response {
    let wanted = id.with("keyboard");
    if ui.data_mut(|data| data.remove_temp::<()>(wanted)).is_some() {
        ui.memory_mut(|memory| memory.request_focus(id));
    }
    ui.horizontal(|ui| {
        // As high as a line without the menu, because the fields need the room.
        (ui.spacing_mut().interact_size.y, ui.spacing_mut().button_padding.y) = (TEXT_LINE, 0.0);
        let label = ui.label(name);
        let chosen = subject.and_then(|subject| quantity_menu(ui, t, [t.insert_number, t.insert_number_hint], subject));
        if let Some(number) = chosen.map(|path| format!("{{{path}}}"))
            && text.chars().count() + number.chars().count() <= MAX_TYPED
        {
            let mut edit = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
            let caret = edit.cursor.char_range().map(|range| usize::from(range.primary.index));
            let at = caret.and_then(|at| Some(text.char_indices().nth(at)?.0)).unwrap_or(text.len());
            text.insert_str(at, &number);
            let after = CCursor::new(text[..at].chars().count() + number.chars().count());
            edit.cursor.set_char_range(Some(CCursorRange::one(after)));
            edit.store(ui.ctx(), id);
            // In the frame of a click elsewhere, a field loses the keyboard. It gets it in the next one.
            ui.data_mut(|data| data.insert_temp(wanted, ()));
            ui.request_repaint();
        }
        label
    })
    .inner
}

/// A button with this name and hint that opens the menu. Returns the path of the chosen quantity.
pub(super) fn quantity_menu(
    ui: &mut Ui,
    t: &Texts,
    [name, hint]: [&str; 2],
    (figure, report): (&Figure, &Report),
) -> Option<String> {
    let mut chosen = None;
    let button = ui.menu_button(format!("{name} ▾"), |ui| {
        // θ of a parallel camera and H of a perspective one are kept for the other projection and say nothing here.
        let Parameters { projection, window: sides, .. } = &figure.camera;
        let says = |key: &ParameterKey| match key {
            ParameterKey::ViewAngle => sides.is_none() && *projection == Projection::Perspective,
            ParameterKey::Height => sides.is_none() && *projection == Projection::Parallel,
            ParameterKey::Aspect => sides.is_none(),
            _ => true,
        };
        let camera = ParameterKey::ALL.into_iter().filter(says).map(Quantity::Camera);
        let camera = camera.chain([Quantity::Distance, Quantity::Direction]);
        let window = WindowNumber::ALL.iter().copied().map(Quantity::Window);
        let axes = BasisAxis::ALL.iter().copied().map(Quantity::Axis);
        let matrices = ReportMatrix::ALL.iter().copied().map(Quantity::Matrix);
        let groups: [(&str, Vec<Quantity>); 4] = [
            (t.camera_group, camera.collect()),
            (t.window_group, window.collect()),
            (t.axes_group, axes.collect()),
            (t.matrices_group, matrices.collect()),
        ];
        let points = figure.points.iter().enumerate().map(|(place, point)| {
            (point.name.clone(), PointNumber::ALL.iter().map(|number| Quantity::Point(place, *number)).collect())
        });
        for (name, quantities) in
            groups.map(|(name, quantities)| (name.to_owned(), quantities)).into_iter().chain(points)
        {
            ui.menu_button(name, |ui| {
                for quantity in quantities {
                    chosen = group(ui, t, report, quantity).or(chosen.take());
                }
            });
        }
    });
    button.response.explained(hint);
    chosen
}

/// A quantity of one number with its value, or a menu of the entries of a larger one.
fn group(ui: &mut Ui, t: &Texts, report: &Report, quantity: Quantity) -> Option<String> {
    let path = quantity.to_string();
    let numbers = quantity.of(report)?;
    if numbers.entries.len() == 1 {
        let value = filled_from(t.lang, &Localized::same(&format!("{{{path}}}")), report);
        return chosen(ui, &format!("{} = {value}", name(t.lang, quantity)), path);
    }
    let mut found = None;
    ui.menu_button(name(t.lang, quantity), |ui| {
        found = chosen(ui, t.all_entries, path.clone());
        for place in 0..numbers.entries.len() {
            let entry = match numbers.columns {
                1 => [Some(place), None],
                columns => [Some(place / columns), Some(place % columns)],
            };
            let entry = QuantityPath { quantity, entry }.to_string();
            found = chosen(ui, &entry, entry.clone()).or(found.take());
        }
    });
    found
}

/// The name of a quantity: that of its field, its symbol, or its key in the output of `inspect`.
fn name(lang: Lang, quantity: Quantity) -> String {
    match quantity {
        Quantity::Camera(key) => parameter(lang, key),
        Quantity::Distance => "D".to_owned(),
        Quantity::Direction => "DOP".to_owned(),
        Quantity::Axis(axis) => axis.name().to_owned(),
        Quantity::Window(number) => match number {
            WindowNumber::Left => "l",
            WindowNumber::Right => "r",
            WindowNumber::Bottom => "b",
            WindowNumber::Top => "t",
            WindowNumber::Width => "W",
            WindowNumber::Height => "H",
            WindowNumber::Aspect => "A",
        }
        .to_owned(),
        Quantity::Matrix(matrix) => explain::matrix(lang, matrix.into()).to_owned(),
        other => other.to_string(),
    }
}

fn chosen(ui: &mut Ui, name: &str, path: String) -> Option<String> {
    let is_chosen = ui.button(name).clicked();
    if is_chosen {
        ui.close();
    }
    is_chosen.then_some(path)
}
