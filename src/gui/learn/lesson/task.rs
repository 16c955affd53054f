//! The task of a step: a question, an exercise, a goal.

use eframe::egui::{RichText, Ui};

use crate::figure::{Explanation, Localized};
use crate::gui::kit::{Explained, prose, theme};
use crate::gui::learn::exercises::state::Chosen;
use crate::gui::learn::{Learn, exercises};
use crate::lessons::{Step, Task};
use camera_lab_words::learn::exercises::title;
use camera_lab_words::learn::lessons::Texts;

/// Shows the task of a step. In a presentation a key shows the question.
pub(super) fn show(
    ui: &mut Ui,
    t: &Texts,
    model: &mut camera_lab_desk::Model,
    learn: &mut Learn,
    step: &Step,
    text: &dyn Fn(&Localized) -> String,
) {
    let Some(playing) = learn.lesson.as_ref() else { return };
    let (is_done, shows) = (playing.is_done(), playing.shows_question);
    let Some(task) = &step.task else { return };
    if !shows {
        ui.label(RichText::new(t.hidden_question).small().weak());
        return;
    }
    ui.add_space(4.0);
    match task {
        Task::Question(_) if model.settings.presentation && super::hands::show(ui, t, learn, step) => {}
        Task::Question(entry) => {
            let chosen = Chosen { id: entry.id.clone().into_owned(), seed: 0 };
            // Another exercise may have been opened meanwhile.
            if learn.exercises.open.as_ref() == Some(&chosen) {
                exercises::questions(ui, model, learn);
            } else if ui.button(t.question_command).clicked() {
                learn.exercises.work_on(chosen);
            }
        }
        Task::Exercise { id, seed } => {
            let chosen = Chosen { id: id.clone(), seed: *seed };
            let is_open = learn.exercises.open.as_ref() == Some(&chosen) && model.shows_exercises();
            let name = crate::exercises::entry(id).map_or("", |entry| title(t.lang, entry));
            ui.horizontal_wrapped(|ui| {
                let is_said = is_open && !is_done;
                ui.label(RichText::new(if is_said { format!("{name}:") } else { name.to_owned() }).strong());
                if is_said {
                    ui.label(t.exercise_at_side);
                } else if !is_open && ui.button(t.open_exercise).clicked() {
                    learn.exercises.work_on(chosen);
                    model.show_explanation(Explanation::Exercises);
                }
                said(ui, t, is_done);
            });
        }
        Task::Try(goal) => {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().interact_size.y = 0.0;
                prose::show(ui, &format!("**{}:** {}", t.to_try, text(&goal.text).trim()));
            });
            ui.horizontal_wrapped(|ui| {
                if !is_done {
                    ui.label(RichText::new(t.not_yet).weak());
                    if !goal.way.is_empty() && ui.button(t.show_way).explained(t.show_way_hint).clicked() {
                        learn.show_solution(model, goal);
                    }
                }
                said(ui, t, is_done);
            });
        }
    }
}

/// Reports that the task is done, once it is.
fn said(ui: &mut Ui, t: &Texts, is_done: bool) {
    if is_done {
        ui.label(RichText::new(format!("✓ {}", t.done)).strong().color(theme::verdict_color(ui, true)));
    }
}
