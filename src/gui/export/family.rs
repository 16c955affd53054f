//! A family in the export dialog: the same figure at several values of a key or an operation, on one sheet.

use eframe::egui;

use super::family_choice::{FamilyChoice, Subject};
use crate::gui::inspector::{choice, row};
use crate::gui::kit::text_field::TextField;
use crate::gui::kit::tooltip::Explained;
use crate::i18n::families;
use crate::i18n::window::Texts;
use crate::limits::MAX_TYPED_NAME;

/// The rows of the dialog: those of the values once something varies.
pub(in crate::gui) fn rows(ui: &mut egui::Ui, t: &'static Texts, family: &mut FamilyChoice) {
    let words = families::texts(t.lang);
    let mut subject = family.first.subject;
    row(ui, "", words.family, words.family_hint, |ui| {
        choice(ui, words.family, words.family_hint, &mut subject, &subjects(t, words.none));
    });
    if subject != family.first.subject {
        family.choose(subject);
    }
    if subject != Subject::Nothing {
        row(ui, "", words.values, words.values_hint, |ui| {
            line(ui, t, &mut family.first.values, (words.values, words.values_hint));
        });
        let mut second = family.second.subject;
        row(ui, "", words.second, words.second_hint, |ui| {
            choice(ui, words.second, words.second_hint, &mut second, &subjects(t, words.nothing));
            if second != Subject::Nothing {
                line(ui, t, &mut family.second.values, (words.second_values, words.values_hint));
            }
        });
        if second != family.second.subject {
            family.second.choose(second);
        }
        row(ui, "", words.columns, words.columns_hint, |ui| {
            let columns: Vec<(Option<usize>, String)> = [None]
                .into_iter()
                .chain((1..=8).map(Some))
                .map(|n| (n, n.map_or_else(|| words.automatic.to_owned(), |n: usize| n.to_string())))
                .collect();
            let columns: Vec<(Option<usize>, &str)> = columns.iter().map(|(n, text)| (*n, &**text)).collect();
            choice(ui, words.columns, words.columns_hint, &mut family.columns, &columns);
            ui.checkbox(&mut family.parts, words.parts).explained(words.parts_hint);
        });
        row(ui, "", words.captions, words.captions_hint, |ui| {
            line(ui, t, &mut family.captions, (words.captions, words.captions_hint));
        });
    }
}

/// The keys and operations that may vary.
fn subjects(t: &'static Texts, nothing: &'static str) -> Vec<(Subject, &'static str)> {
    let words = families::texts(t.lang);
    let names = [
        words.view_angle,
        t.azimuth,
        t.elevation,
        t.zoom,
        t.dolly,
        words.projection,
        words.visibility,
        words.shading,
        words.samples,
    ];
    let ready = (0..).zip(names).map(|(place, name)| (Subject::Ready(place), name));
    [(Subject::Nothing, nothing)].into_iter().chain(ready).chain([(Subject::Typed, words.typed)]).collect()
}

/// A field for typed values or captions.
fn line(ui: &mut egui::Ui, t: &'static Texts, text: &mut String, (name, hint): (&str, &str)) {
    let width = ui.available_width().min(200.0);
    let field = TextField::line(text, MAX_TYPED_NAME).with(|edit| edit.desired_width(width));
    field.show(ui, t.lang).explained(hint).accessible_name(name);
}
