//! The button below a chart that writes it in a format of pictures.

use eframe::egui::Ui;

use crate::chart::Chart;
use crate::export::plot::Block;
use crate::gui::kit::tooltip::Explained;
use crate::gui::model::Model;
use crate::gui::model::action::Action;
use crate::i18n::window;

/// A button that asks for a file and writes a chart into it.
pub(in crate::gui) fn button(ui: &mut Ui, model: &mut Model, title: &str, chart: impl FnOnce() -> Chart) {
    let t = window::texts(model.settings.lang);
    if ui.button(t.export_chart).explained(t.export_chart_hint).clicked() {
        let block = Block { title: title.to_owned(), rows: vec![vec![chart()]] };
        model.actions.push(Action::Chart(Box::new(block)));
    }
}
