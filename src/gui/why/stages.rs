//! Stages: each stage of the pipeline with its report. A click shows its input and output in the picture.

use eframe::egui::{self, RichText, Ui};

use crate::gui::kit::{Explained, help_topic};
use crate::gui::why::state::explain::Explain;
use crate::pipeline::Stage;
use camera_lab_desk::Model;
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::why::{notes, pipeline, stages};

/// Shows them.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let t = stages::texts(model.settings.lang);
    shown(ui, t, model);
    ui.separator();
    list(ui, t, model);
    ui.checkbox(&mut model.layout.strip, t.strip).explained(t.strip_hint);
}

/// The displayed stage: its name, its purpose, and its report, or the reason why it was left out.
fn shown(ui: &mut Ui, t: &stages::Texts, model: &Model) {
    let Some(stage) = model.shown_stage() else {
        ui.label(RichText::new(t.none_shown).weak());
        return;
    };
    let lang = model.settings.lang;
    ui.label(RichText::new(format!("{}: {}", t.shown, pipeline::stage(lang, stage))).strong());
    ui.label(with_titles(pipeline::purpose(lang, stage)));
    if let Some(report) = model.frame.reports.iter().find(|report| report.stage == stage) {
        ui.label(pipeline::line(lang, report));
        if report.ran {
            ui.label(RichText::new(stages::in_and_out(t, stage)).weak());
        }
    }
    source(ui, t, stage);
}

/// The source file of a stage, for readers who want to see how it works.
pub(super) fn source(ui: &mut Ui, t: &stages::Texts, stage: Stage) {
    let text = RichText::new(format!("{}: {}", t.in_the_code, stage.source())).small().weak();
    ui.label(text).explained(t.in_the_code_hint);
}

/// All stages. A click shows one in the picture of the strip.
fn list(ui: &mut Ui, t: &stages::Texts, model: &mut Model) {
    let lang = model.settings.lang;
    for (i, stage) in Stage::ALL.into_iter().enumerate() {
        let name = pipeline::stage(lang, stage);
        let report = model.frame.reports.iter().find(|report| report.stage == stage);
        let text = RichText::new(format!("{}. {name}", i + 1));
        let text = if report.is_some_and(|report| !report.ran) { text.strikethrough().weak() } else { text };
        let button = egui::Button::selectable(model.shown_stage() == Some(stage), text);
        let response = ui.add(button);
        help_topic(&response, notes::of_stage(stage));
        let said = report.map(|report| pipeline::line(lang, report)).unwrap_or_default();
        if response.explained(format!("{}\n{said}\n{}", pipeline::purpose(lang, stage), t.show)).clicked() {
            model.toggle_stage(stage);
        }
    }
}
