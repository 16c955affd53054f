//! What became of an answer: what is right, why it is wrong, and the way there, opened one by one.

use eframe::egui::{self, RichText, Ui};

use super::answers::color;
use super::{Sheet, solution};
use crate::exercises::Ask;
use crate::gui::prose;
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::{exercise_messages as messages, exercise_window as words, exercises as said};

/// Shows what was said of an answer, and what helps.
pub(super) fn ui(ui: &mut Ui, state: &mut State, sheet: Sheet<'_>, ask: &Ask) {
    let Sheet { t, exercise, .. } = sheet;
    let checked = state.exercises.checked.get(&ask.name).cloned();
    let mut hints = Vec::new();
    if let Some(checked) = &checked {
        let judged = &checked.judged;
        let is_old = *state.exercises.fields(ask) != *checked.fields;
        ui.scope(|ui| {
            if is_old {
                ui.set_opacity(0.6);
            }
            headline(ui, sheet, judged);
            let entries = judged.entries.iter().flatten();
            for (condition, right) in judged.conditions.iter().zip(entries) {
                let sign = if *right { '✓' } else { '✗' };
                let text = format!("{sign} {}", said::condition(t.lang, condition));
                ui.add(egui::Label::new(RichText::new(text).color(color(ui, *right))).wrap());
            }
            if let Some(diagnosis) = said::diagnosis(t.lang, ask, judged).filter(|_| !judged.right) {
                prose::show(ui, &diagnosis);
            }
        });
        if is_old {
            ui.label(RichText::new(t.changed_since).small().weak());
        }
        hints = messages::hints(t.lang, exercise, ask, judged);
    }
    let opened = state.exercises.opened.get(&ask.name).cloned().unwrap_or_default();
    for hint in hints.iter().take(opened.hints) {
        prose::show(ui, &format!("**{}:** {hint}", t.hint));
    }
    let name = said::ask(t.lang, exercise, ask).replace("**", "");
    ui.horizontal_wrapped(|ui| {
        if opened.hints < hints.len() {
            let label = if opened.hints == 0 { t.next_hint } else { t.stronger_hint };
            let button = ui.button(label).explained(t.hint_hint).accessible_name(words::of_ask(label, &name));
            if button.clicked() {
                state.exercises.opened.entry(ask.name.clone()).or_default().hints += 1;
                state.exercises.note_opened(exercise, ask);
            }
        }
        let helped = opened.hints >= hints.len();
        solution::buttons(ui, state, sheet, ask, helped);
    });
    solution::steps(ui, state, sheet, ask);
}

/// Right or wrong, how much of it, and in which reading.
fn headline(ui: &mut Ui, sheet: Sheet<'_>, judged: &crate::exercises::Judged) {
    let t = sheet.t;
    let right = judged.entries.iter().flatten().filter(|right| **right).count();
    let all = judged.entries.iter().flatten().count();
    let text = match (judged.right, all) {
        (true, _) if judged.reading.is_empty() => format!("✓ {}", t.right),
        (true, _) => format!("✓ {}: {}", t.right_read_as, said::reading(t.lang, judged.reading)),
        (false, 0 | 1) => format!("✗ {}", t.wrong),
        (false, all) => format!("✗ {} ({})", t.wrong, messages::score(t.lang, right, all)),
    };
    ui.add(egui::Label::new(RichText::new(text).strong().color(color(ui, judged.right))).wrap());
}

/// Says that all is right, once it is.
pub(super) fn all(ui: &mut Ui, state: &State, sheet: Sheet<'_>) {
    let right = state.exercises.right();
    if sheet.exercise.asks.iter().all(|ask| right.contains(ask.name.as_str())) {
        ui.separator();
        ui.label(RichText::new(format!("✓ {}", sheet.t.all_right)).strong().color(color(ui, true)));
    }
}
