//! The list of lessons.

use eframe::egui::{Key, Label, Modifiers, RichText, ScrollArea, TextStyle, Ui};

use crate::gui::kit::{Explained, at_right, prose};
use crate::gui::learn::Learn;
use crate::lessons::{OpenLesson, shipped};
use camera_lab_desk::{Action, Intent, Model};
use camera_lab_words::learn::lessons as words;
use camera_lab_words::{told, window};

/// The width of the dialog.
pub(in crate::gui) const WIDTH: f32 = 620.0;

/// Shows the list. A chosen lesson is played. Returns false if the list is to be closed.
pub(in crate::gui) fn show(ui: &mut Ui, model: &mut Model, learn: &Learn, first: bool) -> bool {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    ui.heading(t.lessons);
    ui.add_space(4.0);
    let mut chosen = None;
    let most = (ui.ctx().content_rect().height() - 160.0).max(120.0);
    let next = learn.next_lesson();
    // At its full height from the first frame, because a list that grows moves under the pointer.
    let area = ScrollArea::vertical().max_height(most).min_scrolled_height(most).auto_shrink(false);
    area.show(ui, |ui| {
        if !learn.own.is_empty() {
            ui.label(RichText::new(t.my_lessons).strong());
        }
        for (path, lesson) in &learn.own {
            let link = ui.link(words::with_minutes(lang, lesson)).explained(crate::sanitize::path(path));
            if link.clicked() {
                chosen = Some(OpenLesson { lesson: lesson.clone(), path: Some(path.clone()), step: 0 });
            }
            if let Some(sentence) = &lesson.sentence {
                ui.scope(|ui| {
                    ui.style_mut().override_text_style = Some(TextStyle::Small);
                    prose::show(ui, told(lang, sentence).trim());
                });
            }
        }
        if !learn.own.is_empty() {
            ui.separator();
            ui.label(RichText::new(t.of_program).strong());
        }
        for (k, shipped) in shipped().iter().enumerate() {
            let lesson = &shipped.lesson;
            let is_taken = learn.taken.contains_key(&lesson.id);
            let (done, all) = learn.done_of(lesson);
            ui.horizontal_wrapped(|ui| {
                let title = format!("{}. {}", k + 1, words::with_minutes(lang, lesson));
                let link = ui.link(title);
                // Enter goes on.
                if first && next == Some(k) {
                    link.request_focus();
                }
                if link.clicked() {
                    // An unfinished lesson continues from its last step, and a finished one starts again.
                    let step = if learn.is_finished(lesson) { 0 } else { learn.step_to_go_on(lesson) };
                    chosen = Some(OpenLesson { lesson: lesson.clone(), path: None, step });
                }
                if is_taken && done == all {
                    ui.label(RichText::new(format!("✓ {}", t.finished)).weak());
                } else if is_taken {
                    let place = words::place(lang, learn.step_to_go_on(lesson) + 1, lesson.steps.len());
                    ui.label(RichText::new(format!("{place} · {}", words::answered(lang, done, all))).weak());
                }
                if next == Some(k) {
                    ui.label(RichText::new(format!("◀ {}", t.learn_next)).strong());
                }
            });
            // It would answer the questions of a lesson yet to come.
            let sentence = lesson.sentence.as_ref().filter(|_| learn.is_finished(lesson));
            if let Some(sentence) = sentence {
                prose::show(ui, told(lang, sentence).trim());
            } else if !lesson.aims.is_empty() {
                let aims: Vec<&str> = lesson.aims.iter().map(|aim| told(lang, aim).trim()).collect();
                ui.scope(|ui| {
                    ui.style_mut().override_text_style = Some(TextStyle::Small);
                    prose::show(ui, &format!("{}: {}.", t.aims, aims.join("; ")));
                });
            }
            let exercises = words::exercises_of(lang, lesson);
            if !exercises.is_empty() {
                let text = format!("{}: {}", t.leads_to, exercises.join(" · "));
                ui.add(Label::new(RichText::new(text).small().weak()).wrap());
            }
            ui.add_space(6.0);
        }
    });
    ui.separator();
    let close = ui.horizontal(|ui| at_right(ui, |ui| ui.button(window::texts(lang).close))).inner;
    let closes = close.clicked() || ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
    let stays = chosen.is_none() && !closes;
    if let Some(open) = chosen {
        model.request(Action::Begin(Intent::Lesson(open)));
    }
    stays
}
