//! A family in the export dialog: the same figure at several values of a key or an operation, on one sheet.

use eframe::egui;

use super::family_choice::{FamilyChoice, Subject};
use super::panels::{choice, row};
use super::text_field::TextField;
use super::tooltip::Explained;
use crate::i18n::families;
use crate::i18n::window::Texts;
use crate::limits::MAX_TYPED_NAME;

/// The rows of the dialog; they are always there, so that nothing moves under the pointer.
pub(super) fn rows(ui: &mut egui::Ui, t: &'static Texts, family: &mut FamilyChoice) {
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
    let choices: Vec<(Subject, &str)> =
        [(Subject::Nothing, words.none)].into_iter().chain(ready).chain([(Subject::Typed, words.typed)]).collect();
    let mut subject = family.subject;
    row(ui, "", words.family, words.family_hint, |ui| {
        choice(ui, words.family, words.family_hint, &mut subject, &choices);
    });
    if subject != family.subject {
        family.choose(subject);
    }
    ui.add_enabled_ui(subject != Subject::Nothing, |ui| {
        row(ui, "", words.values, words.values_hint, |ui| {
            let field = TextField::line(&mut family.values, MAX_TYPED_NAME).with(|edit| edit.desired_width(200.0));
            field.show(ui, t.lang).explained(words.values_hint).accessible_name(words.values);
        });
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
    });
}
