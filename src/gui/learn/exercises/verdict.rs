//! The verdict on an answer: its right entries, the diagnosis, and the solution, opened one by one.

use eframe::egui::{self, RichText, Ui};

use super::{Sheet, solution};
use crate::exercises::{self, Ask, MANY_WRONG};
use crate::gui::kit::{form, prose, theme};
use crate::gui::learn::exercises::state::{Chosen, joined};
use crate::gui::learn::{Learn, lesson_link};
use crate::lessons::{Way, lesson_of};
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercise_messages as messages, exercises as said};
use camera_lab_words::told;

/// Shows the verdict on an answer, and the help. A verdict `just_said` is scrolled into sight.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, just_said: bool) {
    let Sheet { t, exercise, .. } = sheet;
    let top = ui.cursor().top();
    let checked = learn.exercises.checked.get(&ask.name).cloned();
    let mut hints = Vec::new();
    if let Some(checked) = &checked {
        let judged = &checked.judged;
        let is_old = *learn.exercises.fields(ask) != *checked.fields;
        // In the line of the verdict, because a line of its own would move the requested button.
        ui.horizontal_wrapped(|ui| {
            // As high as words, not as controls.
            ui.spacing_mut().interact_size.y = 0.0;
            ui.scope(|ui| {
                if is_old {
                    ui.set_opacity(0.6);
                }
                headline(ui, sheet, ask, judged);
            });
            if is_old {
                ui.label(RichText::new(t.changed_since).small().weak());
            }
        });
        ui.scope(|ui| {
            if is_old {
                ui.set_opacity(0.6);
            }
            let entries = judged.entries.iter().flatten();
            for (condition, right) in judged.conditions.iter().zip(entries) {
                let sign = if *right { '✓' } else { '✗' };
                let text = format!("{sign} {}", said::condition(t.lang, condition));
                ui.add(egui::Label::new(RichText::new(text).color(theme::verdict_color(ui, *right))).wrap());
            }
            if let Some(numbers) = said::own_numbers(t.lang, judged) {
                prose::show(ui, &numbers);
            }
            if let Some(carried) = said::carried(t.lang, judged) {
                prose::show(ui, &carried);
            }
            if let Some(diagnosis) =
                said::diagnosis(t.lang, ask, judged).filter(|_| !judged.right || ask.fault.is_some())
            {
                prose::show(ui, &diagnosis);
            }
            if let Some(off) = ask.off(&judged.understood) {
                prose::show(ui, &messages::off(t.lang, off));
            }
            if let Some(place) = place_of(ask).filter(|_| judged.right) {
                prose::show(ui, &messages::lands(t.lang, place));
            }
            if let Some(why) = why_guess_was_wrong(learn, sheet, ask).filter(|_| judged.right) {
                prose::show(ui, &why);
            }
            if let Some(because) = ask.because.as_ref().filter(|_| judged.right) {
                prose::show(ui, told(t.lang, because));
            }
        });
        hints = messages::hints(t.lang, exercise, ask, judged);
    }
    let opened = learn.exercises.opened.get(&ask.name).cloned().unwrap_or_default();
    for hint in hints.iter().take(opened.hints) {
        prose::show(ui, &format!("**{}:** {hint}", t.hint));
    }
    let newest = solution::steps(ui, model, learn, sheet, ask).map_or(top, |step| step.top());
    let id = ui.scope_id();
    ui.horizontal_wrapped(|ui| {
        if opened.hints < hints.len() {
            hint_button(ui, learn, sheet, ask, (id, opened.hints));
        } else {
            solution::step_button(ui, learn, sheet, ask, id);
        }
        solution::camera_button(ui, model, learn, sheet, ask, id);
    });
    if checked.is_some_and(|checked| !checked.judged.right) {
        offer(ui, model, learn, sheet);
    }
    if just_said {
        let said = egui::Rect::from_x_y_ranges(ui.max_rect().x_range(), newest..=ui.min_rect().bottom());
        let room = ui.clip_rect().height();
        // With the question above it, if both fit.
        let said = if ui.min_rect().height() <= room { ui.min_rect() } else { said };
        let too_high = said.height() > room;
        ui.scroll_to_rect(said, too_high.then_some(egui::Align::TOP));
    }
}

/// After several wrong answers in a row: the lesson, or other numbers.
fn offer(ui: &mut Ui, model: &mut Model, learn: &mut Learn, Sheet { t, entry, exercise }: Sheet<'_>) {
    let wrong = learn.exercises.progress.tried(&entry.id).map_or(0, |tried| tried.wrong);
    let way = lesson_of(&entry.id).filter(|_| entry.texts().is_none());
    if wrong < MANY_WRONG || way.is_none() && !entry.is_family {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.label(t.many_wrong);
        if let Some(Way { lesson, step }) = way {
            lesson_link(ui, model, &lesson, step);
        }
        if entry.is_family && ui.link(t.new_numbers).clicked() {
            learn.exercises.work_on(Chosen { id: exercise.id.clone(), seed: exercise.seed + 1 });
        }
    });
}

/// The pixel of a question for a place.
fn place_of(ask: &Ask) -> Option<[f64; 2]> {
    ask.expected().table().filter(|_| ask.places)?.entries.try_into().ok()
}

/// The reason why the guess was wrong, given once the right answer was visible. Without a picture it was given at once.
fn why_guess_was_wrong(learn: &Learn, sheet: Sheet<'_>, ask: &Ask) -> Option<String> {
    learn.lesson.as_ref().filter(|playing| !ask.places && playing.lesson.seen_after(playing.step).is_some())?;
    let guess = learn.exercises.guess_at(ask)?;
    let judged = exercises::check(sheet.entry, sheet.exercise, ask, &joined(ask, guess)).ok()?;
    said::diagnosis(sheet.t.lang, ask, &judged).filter(|_| !judged.right)
}

fn hint_button(ui: &mut Ui, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask, (id, open): (egui::Id, usize)) {
    let Sheet { t, exercise, .. } = sheet;
    let name = said::ask(t.lang, exercise, ask).replace("**", "");
    let label = if open == 0 { t.next_hint } else { t.stronger_hint };
    if solution::help_button(ui, id, (label, t.hint_hint, &name)).clicked() {
        learn.exercises.opened.entry(ask.name.clone()).or_default().hints += 1;
        learn.exercises.note_opened(exercise, ask);
        learn.exercises.say(ask);
    }
}

/// Right or wrong, how much of it, and in which reading.
fn headline(ui: &mut Ui, sheet: Sheet<'_>, ask: &Ask, judged: &exercises::Judged) {
    let t = sheet.t;
    let right = judged.entries.iter().flatten().filter(|right| **right).count();
    let all = judged.entries.iter().flatten().count();
    let text = match (judged.right, all) {
        (true, _) if judged.reading.is_empty() => format!("✓ {}", t.right),
        (true, _) => format!("✓ {}: {}", t.right_read_as, said::reading(t.lang, judged.reading)),
        _ if !judged.carried.is_empty() => format!("→ {}", t.follows),
        (false, 0 | 1) => format!("✗ {}", t.wrong),
        _ if ask.places => format!("✗ {}", t.wrong),
        (false, all) => format!("✗ {} ({})", t.wrong, messages::right_of(t.lang, right, all)),
    };
    let text = RichText::new(text).strong().color(theme::verdict_color(ui, judged.right));
    form::announced(&ui.add(egui::Label::new(text).wrap()));
}

/// Reports that all answers are right, once they are.
pub(super) fn all(ui: &mut Ui, learn: &Learn, sheet: Sheet<'_>) {
    let right = learn.exercises.right();
    if sheet.exercise.asks.iter().all(|ask| right.contains(ask.name.as_str())) {
        ui.separator();
        ui.label(RichText::new(format!("✓ {}", sheet.t.all_right)).strong().color(theme::verdict_color(ui, true)));
    }
}
