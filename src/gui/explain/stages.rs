//! The tab of stages: the image painted so far, triangle by triangle, by each hidden-surface algorithm.

use eframe::egui::{self, RichText, Slider, Ui};

use super::triangle;
use crate::appearance::Visibility;
use crate::figure::{Depth, Reveal};
use crate::gui::context_help::help_topic;
use crate::gui::state::State;
use crate::gui::theme;
use crate::gui::tooltip::Explained;
use crate::i18n::sources::with_titles;
use crate::i18n::{notes, pipeline, stages};
use crate::pipeline::Stage;
use crate::views::View;

/// Shows the tab.
pub(super) fn ui(ui: &mut Ui, state: &mut State) {
    let t = stages::texts(state.settings.lang);
    ui.label(RichText::new(t.hint).weak());
    if !state.layout.is_shown(View::Image) {
        ui.label(t.hidden);
    }
    let figure = state.document.figure();
    let (mut style, mut reveal) = (figure.style, figure.reveal);
    ui.horizontal_wrapped(|ui| {
        for (visibility, name, hint) in [
            (Visibility::Painter, t.painter, t.painter_hint),
            (Visibility::Bsp, t.bsp, t.bsp_hint),
            (Visibility::DepthBuffer, t.depth_buffer, t.depth_buffer_hint),
        ] {
            let button = egui::Button::selectable(style.visibility == visibility, name).frame_when_inactive(true);
            if ui.add(button).explained(hint).clicked() {
                style.visibility = visibility;
            }
        }
    });
    let mut depth = reveal.depth == Depth::Stored;
    if ui.checkbox(&mut depth, t.depth).explained(t.depth_hint).changed() {
        reveal = Reveal { depth: if depth { Depth::Stored } else { Depth::Off }, ..reveal };
    }
    if (style, reveal) != (figure.style, figure.reveal) {
        state.document.edit(|figure| (figure.style, figure.reveal) = (style, reveal));
    }
    scrubber(ui, t, state);
    let said = match state.document.figure().style.visibility {
        Visibility::Painter => t.painter_said,
        Visibility::Bsp => t.bsp_said,
        Visibility::DepthBuffer => t.depth_buffer_said,
    };
    ui.label(said);
    ui.separator();
    triangle::ui(ui, state);
    ui.separator();
    shown(ui, t, state);
    ui.label(RichText::new(t.order).strong());
    list(ui, t, state);
}

/// The stage that is shown: its name, its purpose, and its report, or the reason why it was left out.
fn shown(ui: &mut Ui, t: &stages::Texts, state: &State) {
    let Some(stage) = state.shown_stage() else {
        ui.label(RichText::new(t.none_shown).weak());
        return;
    };
    let lang = state.settings.lang;
    ui.label(RichText::new(format!("{}: {}", t.shown, pipeline::stage(lang, stage))).strong());
    ui.label(with_titles(pipeline::purpose(lang, stage)));
    if let Some(report) = state.explain.reports.iter().find(|report| report.stage == stage) {
        ui.label(pipeline::line(lang, report));
        if report.ran {
            ui.label(RichText::new(stages::in_and_out(t, stage)).weak());
        }
    }
}

/// All stages; a click shows one in the picture of the strip.
fn list(ui: &mut Ui, t: &stages::Texts, state: &mut State) {
    let lang = state.settings.lang;
    for (i, stage) in Stage::ALL.into_iter().enumerate() {
        let name = pipeline::stage(lang, stage);
        let report = state.explain.reports.iter().find(|report| report.stage == stage);
        let text = RichText::new(format!("{}. {name}", i + 1));
        let text = if report.is_some_and(|report| !report.ran) { text.strikethrough().weak() } else { text };
        let button = egui::Button::selectable(state.shown_stage() == Some(stage), text);
        let response = ui.add(button);
        help_topic(&response, notes::of_stage(stage));
        let said = report.map(|report| pipeline::line(lang, report)).unwrap_or_default();
        if response.explained(format!("{}\n{said}\n{}", pipeline::purpose(lang, stage), t.show)).clicked() {
            state.toggle_stage(stage);
        }
    }
}

/// From nothing to the whole image; the arrow keys move the slider.
fn scrubber(ui: &mut Ui, t: &stages::Texts, state: &mut State) {
    let old = state.painted_share().unwrap_or(1.0);
    let mut share = old;
    ui.horizontal(|ui| {
        for (sign, name, to) in
            [("|◀", t.nothing, 0.0), ("◀", t.fewer, share - STEP), ("▶", t.more, share + STEP), ("▶|", t.all, 1.0)]
        {
            if ui.button(sign).explained(name).accessible_name(name).clicked() {
                share = to;
            }
        }
    });
    ui.scope(|ui| {
        theme::strengthen_rail(ui);
        ui.spacing_mut().slider_width = (ui.available_width() - 16.0).max(80.0);
        let slider = Slider::new(&mut share, 0.0..=1.0).show_value(false).smart_aim(false);
        ui.add(slider).explained(t.scrubber).accessible_name(t.scrubber);
    });
    if old.to_bits() != share.to_bits() {
        state.paint_share(share);
        ui.ctx().request_repaint();
    }
}

/// The share of the triangles that a button adds or removes.
const STEP: f64 = 1.0 / 24.0;
