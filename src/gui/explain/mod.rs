//! The side of explanations, in the place of operations and numbers: every number with its formula.
//!
//! A tab is a variant of [`ExplainTab`], its row in `TABS` and a file here with `fn ui`. Only the tab that is shown
//! computes anything.
//!
//! | file | purpose |
//! | --- | --- |
//! | `answer` | the explanation of an entry: its formula, its numbers, its value, and the definitions of its symbols |
//! | `arithmetic` | a point's way, step by step, with each product written out: forward and back |
//! | `code` | the tab of code: the camera for other libraries |
//! | `dialects` | the tab of other vocabularies, and a pasted matrix → its camera |
//! | `digits` | numbers whose changed digits glow |
//! | `entries` | the entries of a matrix as a grid, each a control of its own |
//! | `homogeneous` | the tab of w: points in (x_r, w_r), where a middle goes, and a floor with and without w |
//! | `matrices` | the tab of matrices: each entry of each matrix with its formula, its numbers and its value |
//! | `measures` | the measures of symbols in the world |
//! | `notes` | the tab of notes, found by words or by F1 |
//! | `order` | the tab of order: a list of transforms, in both readings |
//! | `order_list` | the list of the tab of order: calls with their numbers, moved by dragging their dots and by keyboard |
//! | `point` | the tab of a point: its coordinates in every space, and its trace |
//! | `stages` | the tab of stages: the image painted so far, triangle by triangle, by each hidden-surface algorithm |
//! | `steps` | the tab of steps: the factors on the way to the canonical volume |
//! | `subject` | the subject of the explanations: the figure's camera, and the selected object |
//! | `triangle` | one triangle step by step: its corners in each space, the cuts |

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
mod triangle;

use eframe::egui;

pub(in crate::gui) use subject::object_transform;

use super::exercises;
use super::focus::keep_in_sight;
use super::state::{ExplainTab, State};
use super::tooltip::Explained;
use crate::i18n::explain::{self, Texts};
pub(super) use triangle::clicked;

/// A tab: its name, its purpose, and its content.
struct TabRow {
    tab: ExplainTab,
    name: fn(&Texts) -> &'static str,
    hint: fn(&Texts) -> &'static str,
    /// The part that stays in sight while the tab is scrolled.
    head: Option<fn(&mut egui::Ui, &mut State)>,
    ui: fn(&mut egui::Ui, &mut State),
}

impl TabRow {
    /// A tab of which everything scrolls.
    const fn new(
        tab: ExplainTab,
        name: fn(&Texts) -> &'static str,
        hint: fn(&Texts) -> &'static str,
        ui: fn(&mut egui::Ui, &mut State),
    ) -> Self {
        Self { tab, name, hint, head: None, ui }
    }
}

/// The tabs, in the order in which they are read.
const TABS: &[TabRow] = &[
    TabRow::new(ExplainTab::Matrices, |t| t.matrices, |t| t.matrices_hint, matrices::ui),
    TabRow::new(ExplainTab::Point, |t| t.point, |t| t.point_hint, point::ui),
    TabRow::new(ExplainTab::Steps, |t| t.steps, |t| t.steps_hint, steps::ui),
    TabRow::new(ExplainTab::Homogeneous, |t| t.homogeneous, |t| t.homogeneous_hint, homogeneous::ui),
    TabRow::new(ExplainTab::Stages, |t| t.stages, |t| t.stages_hint, stages::ui),
    TabRow::new(ExplainTab::Dialects, |t| t.dialects, |t| t.dialects_hint, dialects::ui),
    TabRow { head: Some(order::head), ..TabRow::new(ExplainTab::Order, |t| t.order, |t| t.order_hint, order::ui) },
    TabRow::new(ExplainTab::Code, |t| t.code, |t| t.code_hint, code::ui),
    TabRow::new(ExplainTab::Notes, |t| t.notes, |t| t.notes_hint, notes::ui),
    TabRow {
        head: Some(exercises::head),
        ..TabRow::new(ExplainTab::Exercises, |t| t.exercises, |t| t.exercises_hint, exercises::ui)
    },
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
    if let Some(head) = row.head {
        head(ui, state);
        ui.separator();
    }
    egui::ScrollArea::vertical().id_salt(("explain", row.tab)).auto_shrink(false).show(ui, |ui| {
        (row.ui)(ui, state);
        keep_in_sight(ui);
    });
}
