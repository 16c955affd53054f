//! The menu of the quantities of a figure, each with its path in the output of `inspect`.

use eframe::egui::Ui;

use crate::figure::{Figure, Localized};
use crate::gui::kit::Explained;
use crate::inspect::Report;
use crate::inspect::quantity::{BasisAxis, PointNumber, Quantity, QuantityPath, ReportMatrix, WindowNumber};
use camera_lab_words::learn::lesson_tasks::Texts;
use camera_lab_words::learn::lessons::filled_from;

/// A button that opens the menu. Returns the path of the chosen quantity.
pub(super) fn quantity_menu(ui: &mut Ui, t: &Texts, (figure, report): (&Figure, &Report)) -> Option<String> {
    let mut chosen = None;
    let button = ui.menu_button(format!("{} ▾", t.quantity), |ui| {
        let camera = crate::camera::ParameterKey::ALL
            .map(Quantity::Camera)
            .into_iter()
            .chain([Quantity::Distance, Quantity::Direction]);
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
    button.response.explained(t.quantity_hint);
    chosen
}

/// A quantity of one number with its value, or a menu of the entries of a larger one.
fn group(ui: &mut Ui, t: &Texts, report: &Report, quantity: Quantity) -> Option<String> {
    let path = quantity.to_string();
    let numbers = quantity.of(report)?;
    if numbers.entries.len() == 1 {
        let value = filled_from(t.lang, &Localized::same(&format!("{{{path}}}")), report);
        return chosen(ui, &format!("{path} = {value}"), path);
    }
    let mut found = None;
    ui.menu_button(path.clone(), |ui| {
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

fn chosen(ui: &mut Ui, name: &str, path: String) -> Option<String> {
    let is_chosen = ui.button(name).clicked();
    if is_chosen {
        ui.close();
    }
    is_chosen.then_some(path)
}
