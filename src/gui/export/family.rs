//! A family in the export dialog: the same figure at several values of a key or an operation, on one sheet.

use eframe::egui::{self, Key};

use super::family_choice::{FamilyChoice, Subject, Varied};
use crate::gui::kit::{Explained, TextField, choice, choice_row, number_field, row, text_field};
use camera_lab_words::families;
use camera_lab_words::window::Texts;

/// The rows of the dialog, with those of the values once something varies. `enter` becomes true if Enter is pressed in
/// the values.
pub(in crate::gui) fn rows(ui: &mut egui::Ui, t: &'static Texts, family: &mut FamilyChoice, enter: &mut bool) {
    let words = families::texts(t.lang);
    let mut subject = family.first.subject;
    if subject == Subject::Nothing {
        choice_row(ui, words.family, words.family_hint, &mut subject, &subjects(t, words.none));
    } else {
        // Side by side, so that each is one click away.
        ui.label(words.family).explained(words.family_hint);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(2.0, 2.0);
            for (option, name) in subjects(t, words.none) {
                ui.selectable_value(&mut subject, option, name).explained(words.family_hint);
            }
        });
    }
    if subject != family.first.subject {
        family.choose(subject);
        take_keyboard(ui.ctx(), t, family);
    }
    if subject != Subject::Nothing {
        row(ui, "", words.values, words.values_hint, |ui| {
            *enter |= values(ui, t, &mut family.first, words.values);
        });
        let mut second = family.second.subject;
        choice_row(ui, words.second, words.second_hint, &mut second, &subjects(t, words.nothing));
        if second != family.second.subject {
            family.second.choose(second);
        }
        if second != Subject::Nothing {
            row(ui, "", words.second_values, words.values_hint, |ui| {
                *enter |= values(ui, t, &mut family.second, words.second_values);
            });
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
            *enter |= line(ui, t, &mut family.captions, (words.captions, words.captions_hint));
        });
    }
}

/// Gives the keyboard to the values, if they are typed.
pub(in crate::gui) fn take_keyboard(ctx: &egui::Context, t: &Texts, family: &FamilyChoice) {
    if family.first.subject != Subject::Nothing && words_of(family.first.subject, t).is_empty() {
        number_field::take_keyboard(ctx, families::texts(t.lang).values);
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
        t.visibility,
        t.shading,
        words.samples,
    ];
    let ready = (0..).zip(names).map(|(place, name)| (Subject::Ready(place), name));
    [(Subject::Nothing, nothing)].into_iter().chain(ready).chain([(Subject::Typed, words.typed)]).collect()
}

/// The values of a key. Those that have words are switched, and the others typed. Returns true if Enter is pressed in
/// them.
fn values(ui: &mut egui::Ui, t: &'static Texts, varied: &mut Varied, name: &str) -> bool {
    let hint = families::texts(t.lang).values_hint;
    let words = words_of(varied.subject, t);
    if words.is_empty() {
        return line(ui, t, &mut varied.values, (name, hint));
    }
    let chosen: Vec<&str> = varied.values.split(',').map(str::trim).collect();
    let mut on = words.iter().map(|(word, _)| chosen.contains(word)).collect::<Vec<bool>>();
    let mut is_changed = false;
    ui.vertical(|ui| {
        for ((_, text), on) in words.iter().zip(&mut on) {
            is_changed |= ui.checkbox(on, *text).changed();
        }
    });
    if is_changed {
        let kept = words.iter().zip(on).filter(|(_, on)| *on).map(|((word, _), _)| *word);
        varied.values = kept.collect::<Vec<_>>().join(", ");
    }
    false
}

/// The values of a key as files have them, with the words of the window. Empty for numbers.
fn words_of(subject: Subject, t: &Texts) -> Vec<(&'static str, &'static str)> {
    match subject.word() {
        "camera.projection" => vec![("perspective", t.perspective), ("parallel", t.parallel)],
        "style.visibility" => vec![
            ("painter", t.visibility_painter),
            ("depth-buffer", t.visibility_depth_buffer),
            ("bsp", t.visibility_bsp),
        ],
        "style.shading" => vec![
            ("wireframe", t.shading_wireframe),
            ("flat", t.shading_flat),
            ("gouraud", t.shading_gouraud),
            ("phong", t.shading_phong),
        ],
        _ => Vec::new(),
    }
}

/// A field for typed values or captions. True if Enter is pressed in it.
fn line(ui: &mut egui::Ui, t: &'static Texts, text: &mut String, (name, hint): (&str, &str)) -> bool {
    // At the right end of a row, the room follows the width of the field.
    let width = 200.0;
    let end = text.chars().count();
    let field = TextField::line(text, crate::limits::MAX_TYPED_NAME).with(|edit| edit.desired_width(width));
    let response = field.show(ui, t.lang).explained(hint).accessible_name(name);
    if number_field::answer_call(ui, &response, name) {
        text_field::select(ui.ctx(), response.id, 0..end);
    }
    response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}
