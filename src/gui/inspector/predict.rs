//! *Predict first*: the switch, the question of an operation, and its outcome.

use eframe::egui::{self, Button, RichText};

use crate::gui::kit::{Explained, number_field, prose, theme};
use camera_lab_desk::operations::predict::Change;
use camera_lab_desk::{About, Model, Prediction};
use camera_lab_words::learn::exercise_messages;
use camera_lab_words::window::predict::Texts;
use camera_lab_words::window::{Texts as WindowTexts, predict as words};

/// Writes an operation with its value.
type Written = fn(crate::camera::Operation, &WindowTexts) -> String;

/// Shows the switch, and the operation that asks.
pub(super) fn ui(ui: &mut egui::Ui, window: &'static WindowTexts, model: &mut Model, written: Written) {
    let t = words::texts(window.lang);
    let predict = &mut model.operations.predict;
    let switch = ui.checkbox(&mut predict.on, t.switch).explained(t.switch_hint);
    number_field::answer_call(ui, &switch, t.switch);
    if switch.changed() && !predict.on {
        predict.asked = None;
    }
    let asked = predict.asked.take().filter(|asked| asked.document == model.desk.shown.id());
    let Some(mut asked) = asked else { return };
    let mut goes_on = true;
    ui.group(|ui| {
        let name = written(asked.freedom.by(asked.amount), window);
        question(ui, t, &name, &mut asked);
        if asked.is_done {
            verdict(ui, t, &asked);
            goes_on = !ui.button(window.close).clicked();
            return;
        }
        ui.horizontal(|ui| {
            let button = ui.add_enabled(asked.about.is_said(), Button::new(t.do_it)).explained(t.do_it_hint);
            if button.explained_disabled(t.do_it_hint).clicked() {
                model.begin_motion(asked.freedom, asked.amount);
                asked.is_done = true;
            }
            goes_on = !ui.button(window.cancel).clicked();
        });
    });
    model.operations.predict.asked = Some(asked).filter(|_| goes_on);
}

/// The question of the operation, and the choices.
fn question(ui: &mut egui::Ui, t: &Texts, name: &str, asked: &mut Prediction) {
    match &mut asked.about {
        About::Place { .. } => {
            prose::show(ui, &words::where_to(t.lang, name));
            if !asked.is_done {
                prose::show(ui, t.click);
            }
        }
        About::Size { said, .. } => {
            prose::show(ui, &words::how_large(t.lang, name));
            ui.add_enabled_ui(!asked.is_done, |ui| {
                ui.horizontal_wrapped(|ui| {
                    for change in Change::ALL {
                        if ui.radio(*said == Some(change), word(t, change)).clicked() {
                            *said = Some(change);
                        }
                    }
                });
            });
        }
    }
}

/// The answer beside the outcome.
fn verdict(ui: &mut egui::Ui, t: &Texts, asked: &Prediction) {
    let is_right = asked.about.is_right();
    let text = match (&asked.about, asked.about.off()) {
        (About::Size { times, said }, _) => {
            let said = said.map_or("", |said| word(t, said));
            words::sizes(t.lang, said, word(t, Change::of(*times)), *times)
        }
        (About::Place { to, .. }, Some(off)) => words::landed(t.lang, *to, &exercise_messages::off(t.lang, off)),
        (About::Place { .. }, None) => return,
    };
    let sign = if is_right { format!("✓ {}", t.as_said) } else { format!("✗ {}", t.otherwise) };
    ui.label(RichText::new(sign).strong().color(theme::verdict_color(ui, is_right)));
    prose::show(ui, &text);
}

fn word(t: &Texts, change: Change) -> &'static str {
    match change {
        Change::Larger => t.larger,
        Change::Smaller => t.smaller,
        Change::Same => t.same,
    }
}
