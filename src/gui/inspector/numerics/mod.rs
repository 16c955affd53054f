//! The panel of studies: the choice of studies, the chart of errors, and the methods with their numbers. Each method
//! opens the camera with its largest error.

mod plot;
pub(in crate::gui) mod state;
pub(in crate::gui) mod this_figure;

use std::time::Duration;

use eframe::egui::{self, ComboBox, Grid, ProgressBar, RichText, ScrollArea, Ui};

use crate::gui::inspector::numerics::state::Numerics;
use crate::gui::kit::{Explained, choice, color_of, export_button, keep_in_sight, theme};
use crate::numerics::three_ways::ThreeWays;
use crate::numerics::{Findings, Row, Study};
use camera_lab_desk::{Action, Intent, Model};
use camera_lab_words::why::numerics as words;

/// Interval between looks at the progress.
const GLANCE: Duration = Duration::from_millis(100);
/// Width of the list of studies, in points.
const LIST: f32 = 210.0;
/// Width of the table of methods.
const TABLE: f32 = 380.0;

/// Shows the panel's content.
pub fn ui(ui: &mut Ui, model: &mut Model, numerics: &mut Numerics) {
    numerics.take(Duration::ZERO);
    if !numerics.of_figure {
        numerics.begin(ui.ctx());
    }
    if numerics.measuring().is_some() {
        ui.ctx().request_repaint_after(GLANCE);
    }
    let is_asked = !model.frame.asked.is_empty();
    if numerics.of_figure && !is_asked {
        let (lang, ways) = (model.settings.lang, ThreeWays::new(model.desk.shown.camera().parameters()));
        theme::sentence_label(ui, &words::three_ways(lang, ways)).explained(words::texts(lang).three_ways_hint);
    }
    let height = ui.available_height();
    let mut opened = None;
    ui.horizontal_top(|ui| {
        ui.allocate_ui(egui::vec2(LIST, height), |ui| {
            ScrollArea::vertical().id_salt("studies").auto_shrink(false).show(ui, |ui| {
                studies(ui, model, numerics);
                keep_in_sight(ui);
            });
        });
        ui.separator();
        if numerics.of_figure && is_asked {
            let t = camera_lab_words::window::texts(model.settings.lang);
            return drop(ui.label(t.asked_here).explained(t.asked_hint));
        }
        if numerics.of_figure {
            return this_figure::ui(ui, model, &mut numerics.this_figure);
        }
        let Some(findings) = numerics.found(numerics.study).cloned() else {
            nothing_yet(ui, model, numerics);
            return;
        };
        let table = TABLE.min(ui.available_width() * 0.5);
        let room = egui::vec2((ui.available_width() - table - 24.0).max(120.0), height);
        ui.allocate_ui(room, |ui| opened = chart(ui, model, numerics, &findings));
        ui.separator();
        ui.allocate_ui(egui::vec2(table, height), |ui| {
            ScrollArea::both().id_salt("methods").auto_shrink(false).show(ui, |ui| {
                ui.vertical(|ui| {
                    if let Some(row) = methods(ui, model, numerics, &findings) {
                        opened = Some(row);
                    }
                    keep_in_sight(ui);
                });
            });
        });
    });
    if let Some(text) = opened.and_then(|row: Row| row.figure) {
        model.request(Action::Begin(Intent::Text(text)));
    }
}

/// The studies, each with a mark if it has been measured, and the button that measures.
fn studies(ui: &mut Ui, model: &Model, numerics_state: &mut Numerics) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    ui.vertical(|ui| {
        ui.set_width(LIST - 12.0);
        let measuring = numerics_state.measuring();
        match measuring {
            _ if numerics_state.of_figure && !model.frame.asked.is_empty() => {}
            _ if numerics_state.of_figure => this_figure::button(ui, model, &mut numerics_state.this_figure),
            None => {
                if ui.button(t.measure).explained(t.measure_hint).clicked() {
                    numerics_state.measure(ui.ctx());
                }
            }
            Some((study, share)) => {
                ui.horizontal(|ui| {
                    if ui.button(t.cancel).explained(words::short_title(lang, study)).clicked() {
                        numerics_state.cancel();
                    }
                    ui.add(ProgressBar::new(share.unwrap_or(0.0)).desired_width(100.0).show_percentage());
                });
            }
        }
        ui.add_space(2.0);
        let this = camera_lab_words::why::this_figure::texts(lang);
        if ui.selectable_label(numerics_state.of_figure, this.tab).explained(this.tab_hint).clicked() {
            numerics_state.of_figure = true;
        }
        ui.separator();
        for study in Study::ALL {
            let mark = if numerics_state.found(study).is_some() { "✔ " } else { "" };
            let chosen = numerics_state.study == study && !numerics_state.of_figure;
            let label = ui.selectable_label(chosen, format!("{mark}{}", words::short_title(lang, study)));
            if label.explained(words::title(lang, study)).clicked() && !chosen {
                let numerics = &mut *numerics_state;
                (numerics.study, numerics.case, numerics.parameter) = (study, 0, None);
                numerics.of_figure = false;
            }
        }
    });
}

/// The question of a study that hasn't been measured yet.
fn nothing_yet(ui: &mut Ui, model: &Model, numerics: &Numerics) {
    let lang = model.settings.lang;
    ui.vertical(|ui| {
        ui.add_space(8.0);
        ui.label(RichText::new(words::title(lang, numerics.study)).strong());
        let t = words::texts(lang);
        match numerics.measuring() {
            Some((study, _)) => ui.label(format!("{} {}", t.measuring, words::title(lang, study))),
            None => ui.label(t.nothing_yet),
        };
    });
}

/// The chart of one case. Returns the row whose point was clicked.
fn chart(ui: &mut Ui, model: &mut Model, numerics: &mut Numerics, findings: &Findings) -> Option<Row> {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let cases = findings.cases();
    let case = cases.get(numerics.case).copied().unwrap_or_default();
    ui.vertical(|ui| {
        ui.horizontal(|ui| {
            let names: Vec<_> = cases.iter().enumerate().map(|(i, name)| (i, words::name(lang, name))).collect();
            if choice(ui, t.case, "", &mut numerics.case, &names) {
                numerics.parameter = None;
            }
            ui.selectable_value(&mut numerics.over_time, false, t.over_parameter);
            ui.selectable_value(&mut numerics.over_time, true, t.over_time);
            let over_time = numerics.over_time;
            if export_button(ui, lang) {
                let pair = words::with_words(lang, findings.study, |words| findings.charts(case, words));
                let chart = if over_time { pair.by_time } else { pair.by_parameter };
                model.request(Action::chart(words::title(lang, findings.study), chart));
            }
        });
        let over_time = numerics.over_time;
        let pair = words::with_words(lang, findings.study, |words| findings.charts(case, words));
        plot::show(ui, lang, findings, case, &pair, over_time)
    })
    .inner
}

/// The methods at one parameter. Returns the row whose camera is to be opened.
fn methods(ui: &mut Ui, model: &Model, numerics: &mut Numerics, findings: &Findings) -> Option<Row> {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let case = findings.cases().get(numerics.case).copied().unwrap_or_default().to_owned();
    let rows: Vec<&Row> = findings.rows.iter().filter(|row| row.case == case).collect();
    let mut parameters: Vec<f64> = rows.iter().map(|row| row.parameter).collect();
    parameters.dedup();
    let at = numerics.parameter.unwrap_or(parameters.len().saturating_sub(1));
    let number = |x: f64| lang.mark().printed(&crate::numbers::significant(x, 3));
    let value = |x: f64| lang.mark().printed(&words::value(x));
    let parameter = parameters.get(at).copied().unwrap_or_default();
    ui.horizontal(|ui| {
        let name = words::parameter(lang, findings.study);
        let list = ComboBox::from_id_salt("parameter").width(70.0).selected_text(value(parameter));
        let list = list.show_ui(ui, |ui| {
            for (i, parameter) in parameters.iter().enumerate() {
                if ui.selectable_label(i == at, value(*parameter)).clicked() {
                    numerics.parameter = Some(i);
                }
            }
        });
        list.response.accessible_name(name);
        ui.add(egui::Label::new(name).truncate());
    });
    let mut opened = None;
    let colors = findings.methods();
    Grid::new("methods").num_columns(5).striped(true).show(ui, |ui| {
        for (head, hint) in [(t.method, ""), (t.error, ""), (t.nanos, ""), (t.bits, t.bits_hint), ("", "")] {
            ui.label(RichText::new(head).strong()).explained(hint);
        }
        ui.end_row();
        for row in rows.into_iter().filter(|row| row.parameter == parameter) {
            let name = words::name(lang, row.method);
            ui.horizontal(|ui| {
                let color = colors.iter().position(|method| *method == row.method);
                ui.colored_label(color_of(color, ui.visuals().dark_mode), "●");
                ui.label(if row.pareto { RichText::new(format!("{name} *")).strong() } else { RichText::new(name) });
            });
            ui.monospace(lang.mark().printed(&words::short(row.error)));
            ui.monospace(number(row.nanos));
            ui.monospace(lang.mark().printed(&format!("{:.1}", row.bits)));
            if row.figure.is_some() && ui.small_button(t.open).explained(t.open_hint).clicked() {
                opened = Some(row.clone());
            }
            ui.end_row();
        }
    });
    ui.label(RichText::new(t.star).small());
    opened
}
