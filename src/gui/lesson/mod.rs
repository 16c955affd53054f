//! The lesson that is played: the bar and the text under the pictures, its task, and the list of lessons.
//!
//! | file | purpose |
//! | --- | --- |
//! | `list` | the list of lessons |
//! | `task` | what there is to do in a step: a question, an exercise, a goal |

mod list;
mod task;

use std::time::Duration;

use eframe::egui::{self, Button, Key, Modifiers, RichText, ScrollArea, Ui};

use super::command::Command;
use super::focus::{self, Region};
use super::prose;
use super::state::{Chosen, State};
use super::tooltip::Explained;
use crate::figure::{Bilingual, Explanation};
use crate::i18n::lessons::{self as words, Texts};
use crate::i18n::{exercises, notes, told};
use crate::lessons::{self, Link};
pub(super) use list::{WIDTH as LIST_WIDTH, show as list};

/// The share of the window that text and task may take; what is longer is scrolled.
const SHARE: f32 = 0.42;
/// Lines of text are not longer than this, in ems.
const LINE: f32 = 64.0;
/// Seconds after which a typed number is one.
const TYPED: f64 = 0.9;

/// Goes on with the move to a step, and with what is typed; at the begin of a frame.
pub(super) fn advance(ctx: &egui::Context, state: &mut State) {
    let now = ctx.input(|input| input.time);
    if state.go_on_moving(now) {
        ctx.request_repaint();
    }
    typed_step(ctx, state, now);
    state.look_at_goal();
}

/// In a presentation, digits are the number of a step: it is gone to after a moment, or at Enter.
fn typed_step(ctx: &egui::Context, state: &mut State, now: f64) {
    let listens = state.settings.presentation && !ctx.text_edit_focused() && !state.file_flow.is_asking();
    let Some(playing) = state.lesson.as_mut().filter(|_| listens) else { return };
    for (digit, key) in (0_usize..).zip(DIGITS) {
        if ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
            let before = playing.typed.map_or(0, |(number, _)| number % 100);
            playing.typed = Some((10 * before + digit, now));
        }
    }
    let Some((number, since)) = playing.typed else { return };
    let is_whole = now - since > TYPED || ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    if is_whole {
        playing.typed = None;
        if let Some(step) = number.checked_sub(1) {
            state.go_to_step(step);
        }
    } else {
        ctx.request_repaint_after(Duration::from_secs_f64(TYPED - (now - since)));
    }
}

const DIGITS: [Key; 10] =
    [Key::Num0, Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// The bar of the lesson, and the text and the task of its step, below the pictures; gives a command that is to be
/// done.
pub(super) fn panel(ui: &mut Ui, state: &mut State) -> Option<Command> {
    let playing = state.lesson.as_ref()?;
    let (key, step) = (playing.lesson.id.clone(), playing.step);
    let t = words::texts(state.settings.lang);
    let most = SHARE * ui.ctx().content_rect().height();
    let panel = egui::Panel::bottom("lesson").resizable(false).show(ui, |ui| {
        focus::region(ui, ui.max_rect(), Region::Lesson, t.region);
        let command = bar(ui, t, state);
        let shows = state.lesson.as_ref().is_some_and(|playing| {
            playing.shows_text || playing.shows_notes || playing.shows_question && !playing.is_done()
        });
        if shows {
            ui.separator();
            ScrollArea::vertical().id_salt((key, step)).max_height(most).auto_shrink([false, true]).show(ui, |ui| {
                content(ui, t, state);
            });
        }
        command
    });
    panel.inner
}

/// One line: title, number of the step, the ways on.
fn bar(ui: &mut Ui, t: &Texts, state: &mut State) -> Option<Command> {
    let lang = t.lang;
    let playing = state.lesson.as_ref()?;
    let lesson = playing.lesson.clone();
    let (step, count, is_done, moved) =
        (playing.step, lesson.steps.len(), playing.is_done(), state.document.is_changed() && playing.moving.is_none());
    let mut command = None;
    let mut go_to = None;
    ui.horizontal(|ui| {
        if ui.add_enabled(step > 0, Button::new(format!("◀ {}", t.back))).explained(t.back_hint).clicked() {
            command = Some(Command::PreviousFigure);
        }
        let (label, hint) = if is_done { (t.next, t.next_hint) } else { (t.pass, t.pass_hint) };
        let next = Button::new(RichText::new(format!("{label} ▶")).strong());
        if ui.add_enabled(step + 1 < count, next).explained(hint).clicked() {
            state.pass_over();
            command = Some(Command::NextFigure);
        }
        let place = words::place(lang, step + 1, count);
        ui.menu_button(format!("{place} ▾"), |ui| {
            for (k, other) in lesson.steps.iter().enumerate() {
                let name = format!("{}. {}", k + 1, told(lang, &other.title));
                if ui.selectable_label(k == step, name).clicked() {
                    go_to = Some(k);
                    ui.close();
                }
            }
        })
        .response
        .explained(t.all_steps);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button("✕").explained(t.leave).accessible_name(t.leave).clicked() {
                command = Some(Command::LeaveLesson);
            }
            if ui.add_enabled(moved, Button::new(t.again)).explained(t.again_hint).clicked() {
                command = Some(Command::StepAgain);
            }
            let title = RichText::new(told(lang, &lesson.title)).weak();
            ui.add(egui::Label::new(title).truncate().selectable(false));
        });
    });
    if let Some(step) = go_to {
        state.go_to_step(step);
    }
    command
}

/// Text, task, links and notes of the step.
fn content(ui: &mut Ui, t: &'static Texts, state: &mut State) {
    let Some(playing) = state.lesson.as_ref() else { return };
    let Some(step) = playing.now().cloned() else { return };
    let (shows_text, shows_notes) = (playing.shows_text, playing.shows_notes);
    let width = ui.available_width().min(LINE * ui.text_style_height(&egui::TextStyle::Body));
    ui.set_max_width(width);
    // The numbers are those of what is on the screen.
    let report = lessons::numbers_of(state.document.figure()).or_else(|_| lessons::numbers_of(&step.figure)).ok();
    let text = |text: &Bilingual| match &report {
        Some(report) => words::filled_from(t.lang, text, report),
        None => told(t.lang, text).to_owned(),
    };
    if shows_text {
        if !state.settings.presentation {
            ui.add(egui::Label::new(RichText::new(told(t.lang, &step.title)).strong()).wrap());
        }
        prose::show(ui, text(&step.text).trim());
    }
    task::show(ui, t, state, &step, &text);
    links(ui, t, state, &step.links);
    if let Some(notes) = step.notes.as_ref().filter(|_| shows_notes) {
        ui.separator();
        ui.weak(t.notes_command);
        prose::show(ui, text(notes).trim());
    }
    ui.add_space(2.0);
}

/// Buttons that lead from the step to notes, exercises and lessons.
fn links(ui: &mut Ui, t: &Texts, state: &mut State, links: &[Link]) {
    if links.is_empty() || state.settings.presentation {
        return;
    }
    let lang = t.lang;
    ui.horizontal_wrapped(|ui| {
        for link in links {
            match link {
                Link::Note(id) => {
                    let Some(note) = notes::note(lang, id) else { continue };
                    if ui.link(format!("{}: {}", t.read_more, notes::plain(note.title))).clicked() {
                        state.explain_by_note(note.id);
                    }
                }
                Link::Exercise(id, seed) => {
                    let Some(entry) = crate::exercises::entry(id) else { continue };
                    if ui.link(format!("{}: {}", t.practise, exercises::title(lang, entry))).clicked() {
                        state.exercises.work_on(Chosen { id: id.clone(), seed: *seed });
                        state.show_explanation(Explanation::Exercises);
                    }
                }
                Link::Lesson(id) => {
                    let Some(other) = lessons::shipped().iter().find(|other| other.lesson.id == *id) else { continue };
                    if ui.link(format!("{}: {}", t.go_on_with, told(lang, &other.lesson.title))).clicked() {
                        state.play(lessons::OpenLesson { lesson: other.lesson.clone(), path: None, step: 0 });
                    }
                }
            }
        }
    });
}
