//! The fields of a step's task: a question with choices, a number, a goal, or an exercise.

use eframe::egui::{Button, ComboBox, Id, RadioButton, Ui, vec2};

use super::quantity_menu::{name_with_numbers, quantity_menu};
use crate::exercises::entries;
use crate::figure::{Figure, Localized};
use crate::gui::kit::{Explained, TextField, number_field};
use crate::inspect::Report;
use crate::lessons::{ConditionKind, ConditionText, TaskKind, TaskText};
use crate::limits::{MAX_CONDITIONS, MAX_TITLE, MAX_TYPED};
use camera_lab_words::learn::exercises::title;
use camera_lab_words::learn::lesson_tasks::{Texts, texts};
use camera_lab_words::{Lang, told_mut};

/// Rows of the question. The answers need the rest of the panel.
const ROWS: usize = 2;
/// The width of a field for a number, in points.
const NUMBER: f32 = 64.0;
/// The greatest number of choices.
const MAX_CHOICES: usize = 8;
/// The greatest number of wrong numbers.
const MAX_WRONG: usize = 16;

/// The fields of a task. Returns true if one of them has lost the focus.
pub(super) fn show(
    ui: &mut Ui,
    task: &mut TaskText,
    (shown, lang): (Lang, Lang),
    subject: Option<(&Figure, &Report)>,
) -> bool {
    let t = texts(shown);
    let mut fields = TaskFields { t, lang, subject, is_left: false };
    fields.is_left |= kinds(ui, t, task);
    match task.kind {
        TaskKind::None => {}
        TaskKind::InFile => drop(ui.label(t.in_file)),
        TaskKind::Exercise => fields.exercise(ui, task),
        TaskKind::Choices => {
            fields.text(ui, t.question_field, &mut task.text);
            fields.choices(ui, task);
        }
        TaskKind::Number => {
            fields.text(ui, t.question_field, &mut task.text);
            fields.number(ui, task);
        }
        TaskKind::Goal => {
            fields.text(ui, t.goal_field, &mut task.text);
            fields.goal(ui, task);
        }
    }
    fields.is_left
}

/// The kinds of task. Returns true if another one was chosen.
fn kinds(ui: &mut Ui, t: &Texts, task: &mut TaskText) -> bool {
    let mut chosen = task.kind;
    ui.horizontal_wrapped(|ui| {
        for (kind, name, hint) in [
            (TaskKind::None, t.none, t.none_hint),
            (TaskKind::Choices, t.choices, t.choices_hint),
            (TaskKind::Number, t.number, t.number_hint),
            (TaskKind::Goal, t.goal, t.goal_hint),
            (TaskKind::Exercise, t.exercise, t.exercise_hint),
        ] {
            ui.radio_value(&mut chosen, kind, name).explained(hint);
        }
    });
    let is_new = chosen != task.kind;
    if is_new {
        *task = std::mem::take(task).with_kind(chosen);
        if chosen == TaskKind::Exercise && task.exercise.is_empty() {
            task.exercise = entries().next().map(|entry| entry.id.to_string()).unwrap_or_default();
        }
    }
    is_new
}

/// The fields, all in one language, for a step with this figure and its numbers.
struct TaskFields<'a> {
    t: &'static Texts,
    lang: Lang,
    subject: Option<(&'a Figure, &'a Report)>,
    is_left: bool,
}

impl TaskFields<'_> {
    /// A text over the whole width.
    fn text(&mut self, ui: &mut Ui, name: &str, text: &mut Localized) {
        let (id, width) = (Id::unique(("text of a task", self.lang)), ui.available_width());
        let text = told_mut(self.lang, text);
        let label = name_with_numbers(ui, self.t, name, self.subject, (id, text));
        let field = TextField::lines(text, MAX_TYPED);
        let field = field.with(|edit| edit.id(id).desired_width(width).desired_rows(ROWS));
        let response = field.show(ui, self.t.lang).labelled_by(label.id);
        number_field::answer_call(ui, &response, name);
        self.is_left |= response.lost_focus();
    }

    /// A line that names its content in itself.
    fn line(&mut self, ui: &mut Ui, width: f32, (name, place): (&'static str, usize), text: &mut String) {
        let id = Id::unique(("line of a task", name, place, self.lang));
        let field = TextField::line(text, MAX_TITLE);
        // A narrow field has its name before it.
        let hint = if width > NUMBER { name } else { "" };
        let field = field.with(|edit| edit.id(id).desired_width(width).hint_text(hint));
        let response = field.show(ui, self.t.lang).accessible_name(format!("{name} {}", place + 1));
        self.is_left |= response.lost_focus();
    }

    /// The choices, the right one marked, and a sentence for each wrong one.
    fn choices(&mut self, ui: &mut Ui, task: &mut TaskText) {
        let (t, mut gone) = (self.t, None);
        let can_go = task.choices.len() > 2;
        let mut marks = Vec::new();
        for (place, letter) in (0..task.choices.len()).zip('A'..) {
            ui.horizontal(|ui| {
                let size =
                    vec2(ui.spacing().icon_width + 1.5 * ui.spacing().interact_size.y, ui.spacing().interact_size.y);
                marks.push((letter, ui.allocate_space(size).1));
                let width = width_of_fields(ui);
                let choice = &mut task.choices[place];
                self.line(ui, 0.38 * width, (t.choice_field, place), told_mut(self.lang, &mut choice.text));
                if task.right == place {
                    let mut right = t.is_right;
                    let field = TextField::fixed_line(&mut right).with(|edit| edit.desired_width(0.62 * width));
                    ui.add_enabled_ui(false, |ui| field.show(ui, t.lang));
                } else {
                    self.line(ui, 0.62 * width, (t.message_field, place), told_mut(self.lang, &mut choice.message));
                }
                if can_go && remove(ui, t.remove_choice) {
                    gone = Some(place);
                }
            });
        }
        // After the fields, so that Tab goes from one text to the next.
        for (place, (letter, mark)) in marks.into_iter().enumerate() {
            let is_right = task.right == place;
            let chosen = ui.put(mark, RadioButton::new(is_right, letter.to_string())).explained(t.right_hint);
            if chosen.accessible_name(format!("{} {letter}", t.right_field)).clicked() {
                task.right = place;
            }
        }
        gone.into_iter().for_each(|place| task.remove_choice(place));
        if ui.add_enabled(task.choices.len() < MAX_CHOICES, Button::new(t.add_choice)).clicked() {
            task.add_choice();
        }
    }

    /// The right number, its tolerance, and wrong numbers with a sentence each.
    fn number(&mut self, ui: &mut Ui, task: &mut TaskText) {
        let t = self.t;
        ui.horizontal_wrapped(|ui| {
            ui.label(t.answer_field).explained(t.answer_hint);
            self.line(ui, 2.5 * NUMBER, (t.answer_field, 0), &mut task.number);
            if let Some(path) =
                self.subject.and_then(|subject| quantity_menu(ui, t, [t.quantity, t.quantity_hint], subject))
            {
                task.number = path;
            }
            ui.label(t.tolerance_field).explained(t.tolerance_hint);
            self.line(ui, NUMBER, (t.tolerance_field, 0), &mut task.tolerance);
        });
        let mut gone = None;
        for (place, (number, message)) in task.mistakes.iter_mut().enumerate() {
            ui.horizontal(|ui| {
                let width = width_of_fields(ui);
                self.line(ui, 0.25 * width, (t.wrong_field, place), number);
                self.line(ui, 0.75 * width, (t.wrong_message, place), told_mut(self.lang, message));
                if remove(ui, t.remove_wrong) {
                    gone = Some(place);
                }
            });
        }
        gone.into_iter().for_each(|place| drop(task.mistakes.remove(place)));
        if ui.add_enabled(task.mistakes.len() < MAX_WRONG, Button::new(t.add_wrong)).clicked() {
            task.mistakes.push((String::new(), Localized::default()));
        }
    }

    /// The conditions, and a way that meets them.
    fn goal(&mut self, ui: &mut Ui, task: &mut TaskText) {
        let (t, mut gone) = (self.t, None);
        let can_go = task.conditions.len() > 1;
        for (place, condition) in task.conditions.iter_mut().enumerate() {
            ui.horizontal_wrapped(|ui| {
                self.condition(ui, place, condition);
                if can_go && remove(ui, t.remove_condition) {
                    gone = Some(place);
                }
            });
        }
        gone.into_iter().for_each(|place| drop(task.conditions.remove(place)));
        if ui.add_enabled(task.conditions.len() < MAX_CONDITIONS, Button::new(t.add_condition)).clicked() {
            task.conditions.push(ConditionText::default());
        }
        ui.label(t.way_field).explained(t.way_hint);
        let width = ui.available_width();
        self.line(ui, width, (t.way_example, 0), &mut task.way);
    }

    fn condition(&mut self, ui: &mut Ui, place: usize, condition: &mut ConditionText) {
        let t = self.t;
        let name = |kind| match kind {
            ConditionKind::Quantity => t.of_quantity,
            ConditionKind::Seen => t.seen,
            ConditionKind::Hidden => t.hidden,
        };
        let kinds = [ConditionKind::Quantity, ConditionKind::Seen, ConditionKind::Hidden];
        let shown = ComboBox::from_id_salt(("condition", place)).selected_text(name(condition.kind));
        let shown = shown.show_ui(ui, |ui| {
            kinds.into_iter().for_each(|kind| drop(ui.selectable_value(&mut condition.kind, kind, name(kind))));
        });
        shown.response.accessible_name(t.condition);
        if condition.kind != ConditionKind::Quantity {
            return self.line(ui, 2.5 * NUMBER, (t.object_field, place), &mut condition.name);
        }
        self.line(ui, 2.0 * NUMBER, (t.of_quantity, place), &mut condition.name);
        if let Some(path) =
            self.subject.and_then(|subject| quantity_menu(ui, t, [t.quantity, t.quantity_hint], subject))
        {
            condition.name = path;
        }
        for (name, number) in [(t.at_least, &mut condition.least), (t.at_most, &mut condition.most)] {
            ui.label(name);
            self.line(ui, NUMBER, (name, place), number);
        }
    }

    /// One of the program's exercises.
    fn exercise(&mut self, ui: &mut Ui, task: &mut TaskText) {
        let t = self.t;
        let name = |id: &str| {
            crate::exercises::entry(id).map_or_else(|| id.to_owned(), |entry| title(t.lang, entry).to_owned())
        };
        ui.horizontal_wrapped(|ui| {
            let shown = ComboBox::from_id_salt("exercise of a step").selected_text(name(&task.exercise));
            let shown = shown.width(4.0 * NUMBER).show_ui(ui, |ui| {
                for entry in entries() {
                    ui.selectable_value(&mut task.exercise, entry.id.to_string(), title(t.lang, entry));
                }
            });
            shown.response.accessible_name(t.exercise);
            ui.label(t.seed_field).explained(t.seed_hint);
            self.line(ui, NUMBER, (t.seed_field, 0), &mut task.seed);
        });
    }
}

/// The width that the fields of a row share. The last place is for the sign that removes it.
fn width_of_fields(ui: &Ui) -> f32 {
    ui.available_width() - ui.spacing().interact_size.y - 4.0 * ui.spacing().item_spacing.x
}

fn remove(ui: &mut Ui, hint: &str) -> bool {
    ui.small_button("✕").explained(hint).clicked()
}
