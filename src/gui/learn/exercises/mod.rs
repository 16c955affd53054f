//! The exercises in the window: the list, and the open exercise with its statement, answers, verdicts and solutions.

mod answers;
mod asked;
mod figure;
pub(in crate::gui) mod list;
mod own;
mod progress;
mod solution;
pub mod state;
mod statement;
mod verdict;

use eframe::egui::{self, Key, Modifiers, Ui};

use crate::exercises::{self, Ask, Entry, Exercise};
use crate::gui::kit::{Explained, prose};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{Checked, Chosen, Done, joined};
use camera_lab_desk::Model;
use camera_lab_words::learn::exercise_window::Texts;
use camera_lab_words::learn::{exercise_messages as messages, exercise_window as words};

/// The open exercise, and the words of the window.
#[derive(Clone, Copy)]
struct Sheet<'a> {
    t: &'static Texts,
    entry: &'a Entry,
    exercise: &'a Exercise,
}

/// The part that stays visible above the list, and above an exercise.
pub(in crate::gui) fn head(ui: &mut Ui, model: &Model, learn_state: &mut Learn) {
    let t = words::texts(model.settings.lang);
    let open = learn_state.exercises.open.clone();
    if open.is_none() {
        list::search(ui, t, &mut learn_state.exercises);
    }
    ui.horizontal_wrapped(|ui| {
        let is_family =
            open.as_ref().and_then(|chosen| learn_state.exercises.entry(&chosen.id)).is_some_and(|e| e.is_family);
        if open.is_some() {
            let back = ui.button(format!("◀ {}", t.back)).accessible_name(t.back);
            learn_state.exercises.answer_call(&back);
            if back.clicked() {
                learn_state.exercises.leave();
            }
        }
        if ui.button(t.practise_next).explained(t.practise_next_hint).clicked() {
            learn_state.exercises.practise();
        }
        if let Some(chosen) = &open
            && is_family
            && ui.button(t.new_numbers).explained(t.new_numbers_hint).clicked()
        {
            learn_state.exercises.work_on(Chosen { seed: chosen.seed + 1, ..chosen.clone() });
        }
        if let Some(Chosen { id, seed }) = open {
            let (id, label) = match id.strip_suffix(exercises::FAULT) {
                Some(of) => (of.to_owned(), t.solve_yourself),
                None => (format!("{id}{}", exercises::FAULT), t.find_fault),
            };
            if exercises::entry(&id).is_some() && ui.button(label).explained(t.find_fault_hint).clicked() {
                // With other numbers, because the lines of one tell answers of the other.
                learn_state.exercises.work_on(Chosen { id, seed: if is_family { seed ^ 1 } else { seed } });
            }
        }
        if learn_state.exercises.open.is_none() {
            list::count(ui, &learn_state.exercises, t.lang);
        }
    });
    let why =
        learn_state.exercises.why.as_ref().filter(|(chosen, _)| learn_state.exercises.open.as_ref() == Some(chosen));
    if let Some((_, why)) = why {
        prose::show(ui, &messages::why(t.lang, *why));
    }
}

/// Shows the list, or the open exercise.
pub(in crate::gui) fn ui(ui: &mut Ui, model: &mut Model, learn: &mut Learn) {
    let t = words::texts(model.settings.lang);
    let Some((entry, exercise)) = learn.exercises.exercise() else {
        list::ui(ui, t, &mut learn.exercises);
        own::ui(ui, t, model, learn);
        return progress::ui(ui, t, model, learn);
    };
    let sheet = Sheet { t, entry: &entry, exercise: &exercise };
    // One thing after the other: the next Esc releases the probe pinned in the pictures.
    if learn.exercises.described.is_some() && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
        learn.exercises.described = None;
    }
    let all_wanted = ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Enter));
    let top = ui.cursor().min;
    if std::mem::take(&mut learn.exercises.just_opened) {
        ui.scroll_to_rect(egui::Rect::from_min_size(top, egui::Vec2::ZERO), Some(egui::Align::TOP));
    }
    let chosen = learn.exercises.open.clone();
    let just_said = learn.exercises.take_said(ui.ctx());
    ui.push_id(chosen, |ui| {
        statement::ui(ui, model, learn, sheet);
        let mut in_focus = None;
        for (k, ask) in exercise.asks.iter().enumerate() {
            // The causes to choose from would give the line away.
            if k > 0 && ask.fault.is_some() && !learn.exercises.is_right(&exercise.asks[0]) {
                break;
            }
            ui.separator();
            if question(ui, model, learn, sheet, ask, just_said.as_ref() == Some(&ask.name)) {
                in_focus = Some(ask);
            }
        }
        if all_wanted {
            let wanted = in_focus.map_or_else(|| exercise.asks.iter().collect(), |ask| vec![ask]);
            // The first one is scrolled into sight.
            wanted.into_iter().rev().for_each(|ask| check(learn, sheet, ask));
        }
        verdict::all(ui, learn, sheet);
        ui.add_space(12.0);
    });
}

/// Shows a question with its fields and the verdict. Returns whether one of the fields has the focus.
fn question(ui: &mut Ui, model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, just_said: bool) -> bool {
    ui.push_id(&ask.name, |ui| {
        // After a wrong first mark, the second place is what's left to answer.
        let second = learn.exercises.second_of(ask);
        let in_focus = second.is_none() && answers::ui(ui, model, learn, sheet, ask);
        verdict::ui(ui, model, learn, sheet, ask, just_said);
        second.is_some_and(|second| question(ui, model, learn, sheet, second, just_said)) || in_focus
    })
    .inner
}

/// Shows the questions of the open exercise, without its statement, because a step of a lesson asks them.
pub(in crate::gui) fn questions(ui: &mut Ui, model: &mut Model, learn: &mut Learn) {
    let t = words::texts(model.settings.lang);
    let Some((entry, exercise)) = learn.exercises.exercise() else { return };
    let sheet = Sheet { t, entry: &entry, exercise: &exercise };
    let just_said = learn.exercises.take_said(ui.ctx());
    for ask in &exercise.asks {
        question(ui, model, learn, sheet, ask, just_said.as_ref() == Some(&ask.name));
    }
}

/// Judges the typed answer, if it's readable.
fn check(learn_state: &mut Learn, sheet: Sheet<'_>, ask: &Ask) {
    let fields = learn_state.exercises.fields(ask).to_vec();
    if answers::understood(sheet, ask, &fields).is_err() {
        return;
    }
    let judge = |learn: &Learn, ask: &Ask, fields: &[String]| {
        let beside = learn.exercises.answers_beside(ask);
        exercises::check_beside(sheet.entry, sheet.exercise, ask, &joined(ask, fields), &beside)
    };
    let Ok(judged) = judge(learn_state, ask, &fields) else { return };
    if learn_state.exercises.described.as_ref().is_some_and(|described| described.ask == ask.name) {
        learn_state.exercises.described = None;
    }
    let said_before = learn_state.exercises.checked.get(&ask.name).map(|checked| checked.judged.diagnosis.clone());
    if said_before.is_some_and(|before| before != judged.diagnosis) {
        // Hints on another mistake.
        learn_state.exercises.opened.entry(ask.name.clone()).or_default().hints = 0;
    }
    let done = Done::Judged(
        std::sync::Arc::new(sheet.exercise.clone()),
        Box::new(judged.clone()),
        crate::clock::seconds_since_1970(),
    );
    learn_state.exercises.note(done);
    learn_state.exercises.took(ask, Checked { fields, judged });
    // A mistake elsewhere may follow from this one, or may do so no more. This one may also decide the numbers that the
    // statement leaves open.
    for other in sheet.exercise.asks.iter().filter(|other| other.name != ask.name) {
        let checked = learn_state.exercises.checked.get(&other.name);
        let Some(fields) = checked.map(|checked| checked.fields.clone()) else { continue };
        if let Ok(judged) = judge(learn_state, other, &fields) {
            learn_state.exercises.checked.insert(other.name.clone(), Checked { fields, judged });
        }
    }
    learn_state.exercises.say(ask);
}
