//! The list of lessons.

use eframe::egui::{Key, Modifiers, RichText, ScrollArea, Ui};

use crate::gui::file_flow;
use crate::gui::prose;
use crate::gui::state::{AfterSave, Dialog, State};
use crate::i18n::{gallery, lessons as words, told};
use crate::lessons::{OpenLesson, shipped};
use crate::numbers::significant;

/// The width of the dialog.
pub(in crate::gui) const WIDTH: f32 = 620.0;

/// Shows the list; a lesson that is chosen is played.
pub(in crate::gui) fn show(ui: &mut Ui, state: &mut State) {
    let lang = state.settings.lang;
    let t = words::texts(lang);
    ui.heading(t.lessons);
    ui.add_space(4.0);
    let mut chosen = None;
    let most = (ui.ctx().content_rect().height() - 160.0).max(120.0);
    ScrollArea::vertical().max_height(most).auto_shrink([false, true]).show(ui, |ui| {
        for (k, shipped) in shipped().iter().enumerate() {
            let lesson = &shipped.lesson;
            let minutes =
                lesson.minutes.map_or_else(String::new, |minutes| format!("  ·  {} min", significant(minutes, 3)));
            let title = format!("{}. {}{minutes}", k + 1, told(lang, &lesson.title));
            if ui.link(RichText::new(title).strong()).clicked() {
                chosen = Some(lesson.clone());
            }
            if let Some(sentence) = &lesson.sentence {
                prose::show(ui, told(lang, sentence).trim());
            }
            ui.add_space(6.0);
        }
    });
    ui.separator();
    let closes = ui.button(gallery::texts(lang).close).clicked()
        || ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
    match chosen {
        Some(lesson) => {
            file_flow::begin(ui.ctx(), state, AfterSave::Lesson(OpenLesson { lesson, path: None, step: 0 }));
        }
        None if closes => {}
        None => state.file_flow.dialog = Some(Dialog::Lessons),
    }
}
