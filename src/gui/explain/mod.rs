//! The side of explanations, in the place of operations and numbers: every number with its formula.
//!
//! A tab is a variant of [`ExplainTab`], its row in `TABS` and a file here with `fn ui`. Only the tab that is shown computes anything.

mod answer;
mod arithmetic;
mod code;
mod dialects;
mod digits;
mod entries;
mod homogeneous;
mod matrices;
mod measures;
mod notes;
mod order;
mod order_list;
mod point;
mod stages;
mod steps;
mod subject;

use eframe::egui;

use super::focus::keep_in_sight;
use super::state::{ExplainTab, State};
use super::tooltip::Explained;
use crate::i18n::explain::{self, Texts};

/// A tab: its name, what it is for, and what it shows.
struct Row {
    tab: ExplainTab,
    name: fn(&Texts) -> &'static str,
    hint: fn(&Texts) -> &'static str,
    ui: fn(&mut egui::Ui, &mut State),
}

/// The tabs, in the order in which they are read.
const TABS: &[Row] = &[
    Row { tab: ExplainTab::Matrices, name: |t| t.matrices, hint: |t| t.matrices_hint, ui: matrices::ui },
    Row { tab: ExplainTab::Point, name: |t| t.point, hint: |t| t.point_hint, ui: point::ui },
    Row { tab: ExplainTab::Steps, name: |t| t.steps, hint: |t| t.steps_hint, ui: steps::ui },
    Row { tab: ExplainTab::Homogeneous, name: |t| t.homogeneous, hint: |t| t.homogeneous_hint, ui: homogeneous::ui },
    Row { tab: ExplainTab::Stages, name: |t| t.stages, hint: |t| t.stages_hint, ui: stages::ui },
    Row { tab: ExplainTab::Dialects, name: |t| t.dialects, hint: |t| t.dialects_hint, ui: dialects::ui },
    Row { tab: ExplainTab::Order, name: |t| t.order, hint: |t| t.order_hint, ui: order::ui },
    Row { tab: ExplainTab::Code, name: |t| t.code, hint: |t| t.code_hint, ui: code::ui },
    Row { tab: ExplainTab::Notes, name: |t| t.notes, hint: |t| t.notes_hint, ui: notes::ui },
];

/// Shows the heads of the tabs, and the tab that is chosen.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = explain::texts(state.settings.lang);
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        for row in TABS {
            let chosen = state.explain.tab == row.tab;
            let button = egui::Button::selectable(chosen, (row.name)(t)).frame_when_inactive(true);
            if ui.add(button).explained((row.hint)(t)).clicked() {
                state.explain.tab = row.tab;
            }
        }
    });
    ui.add_space(2.0);
    let Some(row) = TABS.iter().find(|row| row.tab == state.explain.tab) else { return };
    egui::ScrollArea::vertical().id_salt(("explain", row.tab)).auto_shrink(false).show(ui, |ui| {
        (row.ui)(ui, state);
        keep_in_sight(ui);
    });
}
