//! A stage of the pipeline in full: its purpose, its report, its source. The strip under the views has all of them.

use eframe::egui::{RichText, Ui};

use crate::gui::kit::Explained;
use crate::gui::why::state::explain::Explain;
use camera_lab_desk::Model;
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::why::{pipeline, stages};

/// Shows the stage that the strip has put into the view.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let t = stages::texts(model.settings.lang);
    shown(ui, t, model);
    ui.separator();
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
pub(super) fn source(ui: &mut Ui, t: &stages::Texts, stage: crate::pipeline::Stage) {
    let text = RichText::new(format!("{}: {}", t.in_the_code, stage.source())).small().weak();
    ui.label(text).explained(t.in_the_code_hint);
}
