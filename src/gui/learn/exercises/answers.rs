//! Fields for answers, and their interpretation before they are judged.

use eframe::egui::{self, Align2, Key, Margin, RichText, ScrollArea, Stroke, StrokeKind, TextStyle, Ui, vec2};

use super::{Sheet, check};
use crate::exercises::{self, Answer, Ask, Kind, Unit, read_answer};
use crate::expression::{Dimension, evaluate_with};
use crate::gui::kit::{Explained, TextField, complaint, mathematics, prose, text_field, theme, toggle};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{is_whole, joined};
use crate::limits::MAX_ANSWER;
use camera_lab_desk::Model;
use camera_lab_words::learn::{exercise_window as words, exercises as said};
use camera_lab_words::{Lang, messages};

/// The type size of the interpretation, in points.
const SIZE: f32 = 13.0;

/// An unreadable answer: the field, if there is one, and the fault.
pub(super) struct Unreadable {
    field: Option<usize>,
    why: String,
}

/// The interpretation of an answer. `None` if its fields are empty.
pub(super) fn understood(sheet: Sheet<'_>, ask: &Ask, fields: &[String]) -> Result<Option<Answer>, Unreadable> {
    let text = joined(ask, fields);
    if text.is_empty() {
        return Ok(None);
    }
    let lang = sheet.t.lang;
    let names = &sheet.exercise.free;
    let is_list = matches!(ask.kind, Kind::Vector(_) | Kind::Matrix(..)) && !is_whole(ask, fields);
    if is_list {
        let dimension = if ask.unit == Unit::Degrees { Dimension::Angle } else { Dimension::Number };
        for (k, field) in fields.iter().enumerate().filter(|(_, field)| !matches!(field.trim(), "" | "?" | "_")) {
            if let Err(error) = evaluate_with(field.trim(), dimension, names) {
                let marked = crate::expression::marked(field.trim(), &error.span);
                let why = format!("{marked}: {}", messages::expression(lang, &error.problem));
                return Err(Unreadable { field: Some(k), why });
            }
        }
    }
    let unreadable = |error| Unreadable { field: Some(0), why: said::answer_error(lang, &error) };
    read_answer(&text, ask, names).map(Some).map_err(unreadable)
}

/// Shows the question, its fields and the interpretation. Returns whether one of the fields has the focus.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask) -> bool {
    let Sheet { t, exercise, .. } = sheet;
    prose::show(ui, &format!("**{}**", said::ask(t.lang, exercise, ask).replace("**", "")));
    let tolerance = said::tolerance(t.lang, ask);
    if !tolerance.is_empty() {
        ui.add(egui::Label::new(RichText::new(tolerance).small().weak()).wrap());
    }
    let guesses = learn.exercises.asks_for_guess(ask);
    let guess = learn.exercises.guess_at(ask).cloned();
    if let Some(guess) = guess.as_ref().filter(|_| guesses) {
        say_guess(ui, learn, sheet, ask, guess);
    }
    if ask.places {
        ui.scope(|ui| {
            ui.style_mut().override_text_style = Some(TextStyle::Small);
            prose::show(ui, t.place_hint);
        });
    }
    let mut fields = learn.exercises.fields(ask).to_vec();
    let reading = understood(sheet, ask, &fields);
    let broken = reading.as_ref().err().and_then(|unreadable| unreadable.field);
    let marks = marks(learn, ask, &fields);
    let name = said::ask(t.lang, exercise, ask).replace("**", "");
    let mut typing = match &ask.kind {
        Kind::Choice(choices) => choice(ui, t.lang, ask, choices, &mut fields[0]),
        Kind::Camera => camera(ui, model, sheet, ask, &mut fields[0]),
        Kind::Number | Kind::Vector(_) | Kind::Matrix(..) => {
            numbers(ui, sheet, ask, (&name, broken), &marks, &mut fields)
        }
    };
    learn.exercises.type_into(ask, fields);
    if let Some(first) = &typing.first {
        learn.exercises.give_focus(&ask.name, first);
    }
    let can = matches!(reading, Ok(Some(_)));
    let is_guess = guesses && guess.is_none();
    let [label, hint] = if is_guess { [t.guess, t.guess_hint] } else { [t.check, t.check_hint] };
    let button = ui.horizontal_wrapped(|ui| {
        let button = ui.add_enabled(can, egui::Button::new(label)).explained(hint);
        let button = button.explained_disabled(hint).accessible_name(words::of_ask(label, &name));
        for (is_sure, label) in [(true, t.sure), (false, t.unsure)].into_iter().filter(|_| is_guess) {
            let is_chosen = learn.exercises.sure == Some(is_sure);
            if toggle(ui, is_chosen, label).explained(t.sure_hint).clicked() {
                learn.exercises.sure = Some(is_sure).filter(|_| !is_chosen);
            }
        }
        button
    });
    let button = button.inner;
    in_kept_room(ui, ask, |ui| match &reading {
        Err(unreadable) => complaint(ui, &unreadable.why),
        Ok(Some(answer)) if !ask.places => show_understood(ui, t.lang, ask, answer),
        Ok(_) => {}
    });
    typing.in_focus |= button.has_focus();
    if button.clicked() || (can && typing.is_done) {
        if is_guess {
            take_guess(model, learn, sheet, ask);
        } else {
            let is_first = !learn.exercises.checked.contains_key(&ask.name);
            check(learn, sheet, ask);
            if is_first && ask.name == exercises::SECOND {
                learn.show_seen(model);
            }
        }
    }
    typing.in_focus
}

/// Shows the guess, and asks what the picture shows until the answer to that is right.
fn say_guess(ui: &mut Ui, learn: &Learn, sheet: Sheet<'_>, ask: &Ask, guess: &[String]) {
    let t = sheet.t;
    let is_right = learn.exercises.checked.get(&ask.name).is_some_and(|checked| checked.judged.right);
    let playing = learn.lesson.as_ref();
    let shows = playing.is_some_and(|playing| playing.lesson.seen_after(playing.step).is_some());
    let question = match (is_right, ask.places, shows) {
        (true, ..) => "",
        (_, true, _) => t.where_seen,
        (_, _, true) => t.what_seen,
        (..) => t.and_now,
    };
    let text = joined(ask, guess);
    let text = if matches!(ask.kind, Kind::Choice(_)) { said::choice_of(t.lang, ask, &text) } else { &text };
    prose::show(ui, words::you_said(t.lang, text, question).trim());
}

/// Keeps the answer as the guess, and shows the picture that answers the question. The next question is what the
/// picture shows. A place, and a guess without a picture, are judged at once.
fn take_guess(model: &mut Model, learn: &mut Learn, sheet: Sheet<'_>, ask: &Ask) {
    let text = joined(ask, learn.exercises.fields(ask));
    let Ok(judged) = exercises::check(sheet.entry, sheet.exercise, ask, &text) else { return };
    learn.exercises.guess(ask, judged.right, crate::clock::seconds_since_1970());
    // The image that answers comes after the second place.
    if !judged.right && ask.second.is_some() {
        return check(learn, sheet, ask);
    }
    let shows = learn.show_seen(model);
    if shows && !ask.places {
        let fields = vec![String::new(); learn.exercises.fields(ask).len()];
        learn.exercises.type_into(ask, fields);
    } else {
        check(learn, sheet, ask);
    }
}

/// The interaction with the fields of an answer.
#[derive(Default)]
struct Typing {
    /// The first of them.
    first: Option<egui::Response>,
    /// One of them has the keyboard.
    in_focus: bool,
    /// Enter was pressed, and none is empty.
    is_done: bool,
}

/// The height of a row of a typeset matrix, in lines of text.
const ROW_OF_TABLE: f32 = 1.55;

/// Shows feedback on an answer while the user types, in the greatest space that earlier feedback needed, so that the
/// content below doesn't jump with every key.
fn in_kept_room(ui: &mut Ui, ask: &Ask, say: impl FnOnce(&mut Ui)) {
    let id = ui.scope_id().with("room for what is said");
    let line = ui.text_style_height(&TextStyle::Body);
    let least = match ask.kind {
        Kind::Choice(_) | Kind::Camera => 0.0,
        // The cross in the picture shows it.
        _ if ask.places => 0.0,
        // Before the first key there is room for the interpretation, but not for several rows.
        Kind::Number => ROW_OF_TABLE * line,
        Kind::Vector(_) | Kind::Matrix(..) => 0.0,
    };
    let kept = ui.data(|data| data.get_temp(id)).unwrap_or(least);
    let needed = ui.scope(say).response.rect.height();
    if needed < kept {
        ui.add_space(kept - needed);
    } else {
        ui.data_mut(|data| data.insert_temp(id, needed));
    }
}

/// Right and wrong fields, if they haven't changed since they were judged.
fn marks(learn: &Learn, ask: &Ask, fields: &[String]) -> Vec<Option<bool>> {
    let [rows, columns] = ask.shape();
    let none = vec![None; rows * columns];
    let Some(checked) = learn.exercises.checked.get(&ask.name) else { return none };
    let entries = &checked.judged.entries;
    let fits = entries.len() == rows && entries.iter().all(|row| row.len() == columns);
    let is_same = |k: usize| fields.get(k) == checked.fields.get(k);
    // Not wrong by itself.
    if !checked.judged.carried.is_empty() {
        return none;
    }
    if is_whole(ask, fields) && is_same(0) {
        // One field holds all of it.
        return [vec![Some(checked.judged.right)], none].concat();
    }
    if !fits || is_whole(ask, fields) || is_whole(ask, &checked.fields) {
        return none;
    }
    let typed = |k: usize| fields.get(k).is_some_and(|field| !field.trim().is_empty());
    entries.iter().flatten().enumerate().map(|(k, right)| Some(*right).filter(|_| is_same(k) && typed(k))).collect()
}

/// A field for each number.
fn numbers(
    ui: &mut Ui,
    sheet: Sheet<'_>,
    ask: &Ask,
    (name, broken): (&str, Option<usize>),
    marks: &[Option<bool>],
    fields: &mut [String],
) -> Typing {
    /// Between fields, in points.
    const GAP: f32 = 4.0;
    /// Room for the sign of a wide field, in points.
    const SIGN: i8 = 12;
    let t = sheet.t;
    let shape @ [rows, columns] = ask.shape();
    // A vector is a row, because there is little height.
    let per_line = if columns == 1 { rows } else { columns };
    let whole = is_whole(ask, fields);
    #[expect(clippy::cast_precision_loss, reason = "a handful of columns")]
    let share = (ui.available_width() - GAP * (per_line - 1) as f32) / per_line as f32;
    let width = share.floor().clamp(44.0, if per_line == 1 { 200.0 } else { 120.0 });
    let mut typing = Typing::default();
    let mut shown = Vec::new();
    let lines = fields.chunks_mut(per_line.max(1)).enumerate();
    for (i, line) in lines {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            for (j, text) in line.iter_mut().enumerate() {
                let k = i * per_line + j;
                let place = [k / columns.max(1), k % columns.max(1)];
                let first = k == 0 && fields_are_many(shape);
                let wide = if whole && k == 0 { ui.available_width() } else { width };
                if whole && k > 0 {
                    continue;
                }
                let mark = marks.get(k).copied().flatten();
                // A long answer ends before the sign of its field.
                let room = if whole || per_line == 1 { SIGN } else { 0 };
                let wide = wide - f32::from(room);
                let field = TextField::line(text, MAX_ANSWER).refused_beyond().with(|edit| {
                    let margin = Margin { right: 4 + room, ..Margin::symmetric(4, 2) };
                    let edit = edit.id_salt(k).desired_width(wide).margin(margin);
                    edit.align(Align2::LEFT_CENTER).return_key(None)
                });
                let response = field.show(ui, t.lang);
                select_on_arrival(ui, &response, text);
                let hint = if first { t.first_field_hint } else { t.answer_hint };
                let sign = match mark {
                    Some(true) => format!("✓ {}. ", t.right),
                    Some(false) => format!("✗ {}. ", t.wrong),
                    None => String::new(),
                };
                let response = response.explained(format!("{sign}{hint}"));
                let response = response.accessible_name(words::field(t.lang, name, shape, place));
                let wrong = if broken == Some(k) { Some(false) } else { mark };
                if let Some(right) = wrong {
                    sign_field(ui, response.rect, right, broken == Some(k));
                }
                typing.in_focus |= response.has_focus();
                shown.push(response);
            }
        });
    }
    let goes_on = typing.in_focus && ui.input(|input| input.key_pressed(Key::Enter) && input.modifiers.is_none());
    match fields.iter().position(|field| !whole && field.trim().is_empty()).and_then(|empty| shown.get(empty)) {
        Some(empty) if goes_on => empty.request_focus(),
        Some(_) => {}
        None => typing.is_done = goes_on,
    }
    typing.first = shown.into_iter().next();
    typing
}

/// A field reached with Tab is selected, so that typing replaces it, as in the fields of parameters.
fn select_on_arrival(ui: &Ui, response: &egui::Response, text: &str) {
    let came_by_key =
        response.gained_focus() && !ui.input(|input| input.pointer.any_down() || input.pointer.any_released());
    if came_by_key {
        text_field::select(ui.ctx(), response.id, 0..text.chars().count());
    }
}

const fn fields_are_many([rows, columns]: [usize; 2]) -> bool {
    rows * columns > 1
}

/// Marks a field by colour and sign.
fn sign_field(ui: &Ui, rect: egui::Rect, right: bool, broken: bool) {
    let color = theme::verdict_color(ui, right);
    ui.painter().rect_stroke(rect, 2.0, Stroke::new(1.5, color), StrokeKind::Inside);
    let sign = match (broken, right) {
        (true, _) => "⚠",
        (false, true) => "✓",
        (false, false) => "✗",
    };
    let font = TextStyle::Small.resolve(ui.style());
    let corner = rect.right_center() - vec2(3.0, 0.0);
    let galley = ui.painter().layout_no_wrap(sign.to_owned(), font, color);
    let place = Align2::RIGHT_CENTER.anchor_size(corner, galley.size());
    ui.painter().rect_filled(place, 0.0, ui.visuals().text_edit_bg_color());
    ui.painter().galley(place.min, galley, color);
}

/// One of several. Chosen by name, so that it's the same in every language. Sentences stand below one another.
fn choice(ui: &mut Ui, lang: Lang, ask: &Ask, choices: &[String], text: &mut String) -> Typing {
    const SHORT: usize = 40;
    let mut typing = Typing::default();
    let words: Vec<&str> = choices.iter().map(|name| said::choice_of(lang, ask, name)).collect();
    let are_short = words.iter().all(|word| word.chars().count() <= SHORT);
    let list = |ui: &mut Ui| {
        for (name, word) in choices.iter().zip(words) {
            let response = prose::radio(ui, text == name, word);
            typing.in_focus |= response.has_focus();
            if response.clicked() {
                text.clone_from(name);
            }
            typing.first.get_or_insert(response);
        }
    };
    if are_short {
        ui.horizontal_wrapped(list)
    } else {
        ui.vertical(list)
    };
    typing
}

/// A camera as text, and the button that takes the window's camera.
fn camera(ui: &mut Ui, model: &Model, sheet: Sheet<'_>, ask: &Ask, text: &mut String) -> Typing {
    let t = sheet.t;
    if model.desk.shown.figure().scene != sheet.exercise.subject.figure.scene {
        ui.add(egui::Label::new(RichText::new(t.other_figure).weak()).wrap());
    }
    if ui.button(t.take_camera).explained(t.take_camera_hint).clicked() {
        let set = Answer::Camera(Box::new(*model.desk.shown.camera().parameters()));
        *text = said::understood(t.lang, ask, &set);
    }
    let field = TextField::lines(text, MAX_ANSWER).refused_beyond().with(|edit| {
        let edit = edit.id_salt("camera").desired_rows(2).desired_width(f32::INFINITY);
        edit.font(TextStyle::Monospace).hint_text(t.camera_hint)
    });
    let response = field.show(ui, t.lang).accessible_name(t.your_answer);
    Typing { in_focus: response.has_focus(), is_done: false, first: Some(response) }
}

/// The interpretation, set as mathematics.
fn show_understood(ui: &mut Ui, lang: Lang, ask: &Ask, answer: &Answer) {
    let Answer::Numbers { columns, entries, .. } = answer else { return };
    let t = words::texts(lang);
    let text = said::understood(lang, ask, answer);
    let latex = said::table_latex(lang.mark(), ask.unit, *columns, entries);
    ScrollArea::horizontal().id_salt("understood").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.label(RichText::new(t.understood).small().weak());
            mathematics::show(ui, &latex, &text, SIZE);
        });
    });
}
