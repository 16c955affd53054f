//! A question to the class. Keys or clicks count hands, and the bars come with the answer.

use eframe::egui::{self, Align, Context, Key, Layout, Modifiers, RichText, Sense, Ui, vec2};

use crate::exercises::{Ask, Exercise, Expected, ExpectedAnswer, Kind};
use crate::gui::kit::{Explained, TEXT_LINE, prose, theme};
use crate::gui::learn::Learn;
use crate::lessons::{Step, Task};
use camera_lab_words::learn::exercises as said;
use camera_lab_words::learn::lessons::Texts;
use camera_lab_words::{Lang, told};

/// The keys of the choices.
const KEYS: [Key; 8] = [Key::A, Key::B, Key::C, Key::D, Key::E, Key::F, Key::G, Key::H];
/// The width of the longest bar, in heights of a line.
const BAR: f32 = 10.0;

/// The hands raised in a lesson, by step, and for each choice.
#[derive(Debug, Default)]
pub(in crate::gui) struct Hands {
    raised: std::collections::BTreeMap<usize, Vec<u32>>,
    /// The step whose answer is shown.
    pub(super) answered: Option<usize>,
}

impl Hands {
    fn of(&self, step: usize, choices: usize) -> Vec<u32> {
        let mut counts = self.raised.get(&step).cloned().unwrap_or_default();
        counts.resize(choices, 0);
        counts
    }

    /// True if the answer of a step is shown.
    pub(in crate::gui) fn have_answered(&self, step: usize) -> bool {
        self.answered == Some(step)
    }

    fn raise(&mut self, step: usize, (choice, choices): (usize, usize), is_more: bool) {
        let mut counts = self.of(step, choices);
        counts[choice] = if is_more { counts[choice].saturating_add(1) } else { counts[choice].saturating_sub(1) };
        self.raised.insert(step, counts);
    }
}

/// The question of a step and the number of its choices, if it has any.
pub(super) fn question_with_choices(step: &Step) -> Option<(Exercise, usize)> {
    let Some(Task::Question(entry)) = &step.task else { return None };
    let exercise = entry.exercise(0, &Default::default());
    match exercise.asks.first().map(|ask| &ask.kind) {
        Some(Kind::Choice(choices)) => {
            let count = choices.len().min(KEYS.len());
            Some((exercise, count))
        }
        _ => None,
    }
}

/// Counts hands by keys: a letter raises one for its choice, Shift and the letter lower one.
pub(super) fn count(ctx: &Context, model: &camera_lab_desk::Model, learn: &mut Learn, is_asking: bool) {
    let listens = model.settings.presentation && !ctx.text_edit_focused() && !is_asking;
    let Some(playing) = learn.lesson.as_mut().filter(|playing| listens && playing.shows_question) else { return };
    let Some((_, choices)) = playing.now().and_then(question_with_choices) else { return };
    let step = playing.step;
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let egui::Event::Key { key, pressed: true, repeat: false, modifiers, .. } = event else { return true };
            let is_more = modifiers.is_none();
            let choice = KEYS.iter().take(choices).position(|of| of == key);
            match choice.filter(|_| is_more || *modifiers == Modifiers::SHIFT) {
                Some(choice) => playing.hands.raise(step, (choice, choices), is_more),
                None => return true,
            }
            false
        });
    });
}

/// Shows the question with its choices to the class. Returns false if the step has no choices.
pub(super) fn show(ui: &mut Ui, t: &Texts, learn: &mut Learn, step: &Step) -> bool {
    let Some((exercise, choices)) = question_with_choices(step) else { return false };
    let Some(playing) = &mut learn.lesson else { return false };
    let (Some(ask), number) = (exercise.asks.first(), playing.step) else { return false };
    let counts = playing.hands.of(number, choices);
    let is_answered = playing.hands.answered == Some(number);
    // Every choice is to be seen below the pictures.
    (ui.spacing_mut().item_spacing.y, ui.spacing_mut().interact_size.y) = (1.0, TEXT_LINE);
    prose::show(ui, &format!("**{}**", said::ask(t.lang, &exercise, ask).replace("**", "")));
    for (choice, count) in counts.iter().enumerate() {
        let place = Place { choice, count: *count, most: counts.iter().copied().max().unwrap_or_default() };
        if row(ui, t, ask, place, is_answered) {
            playing.hands.raise(number, (choice, choices), true);
        }
    }
    ui.horizontal_wrapped(|ui| {
        let all: u32 = counts.iter().fold(0, |all, count| all.saturating_add(*count));
        if !is_answered && ui.button(format!("{} (Q)", t.show_answer)).explained(t.show_answer_hint).clicked() {
            playing.go_on_asking(true);
        }
        let hint = if all == 0 { t.count_hands.to_owned() } else { format!("{}: {all}", t.hands) };
        ui.label(RichText::new(hint).small().weak());
    });
    true
}

/// A choice, and the hands for it.
struct Place {
    choice: usize,
    count: u32,
    most: u32,
}

/// A choice with its letter, and with the answer its bar. Returns true if a click adds a hand.
fn row(ui: &mut Ui, t: &Texts, ask: &Ask, place: Place, is_answered: bool) -> bool {
    let Kind::Choice(names) = &ask.kind else { return false };
    let Place { choice, count, most } = place;
    let name = names.get(choice).map_or("", |name| said::choice_of(t.lang, ask, name));
    let is_right = matches!(ask.expected(), Expected::Choice(right, ..) if *right == choice);
    let letter = KEYS[choice].name();
    let mut is_clicked = false;
    ui.horizontal_wrapped(|ui| {
        let hint = format!("{letter}: {}", t.raise_hint);
        is_clicked = !is_answered && ui.button(letter).explained(hint).clicked();
        if !is_answered {
            prose::in_row(ui, name);
            return;
        }
        let line = ui.text_style_height(&egui::TextStyle::Body);
        let sign = if is_right { "✓" } else { "✗" };
        ui.label(RichText::new(format!("{letter} {sign}")).strong().color(theme::verdict_color(ui, is_right)));
        prose::in_row(ui, name);
        if most > 0 {
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                #[expect(clippy::cast_precision_loss, reason = "hands of a class")]
                let width = (BAR * line * count as f32 / most as f32).max(1.0);
                let (rect, _) = ui.allocate_exact_size(vec2(width, 0.7 * line), Sense::hover());
                ui.painter().rect_filled(rect, 2.0, theme::verdict_color(ui, is_right));
                ui.label(RichText::new(count.to_string()).strong());
            });
        }
    });
    if let Some(message) = message(t.lang, ask, choice).filter(|_| is_answered && count > 0) {
        prose::show(ui, message);
    }
    is_clicked
}

/// The sentence for those who chose wrongly.
fn message(lang: Lang, ask: &Ask, choice: usize) -> Option<&str> {
    let is_it = |answer: &ExpectedAnswer| matches!(answer, ExpectedAnswer::Choice(of) if *of == choice);
    ask.own_mistakes.iter().find(|mistake| is_it(&mistake.answer)).map(|mistake| told(lang, &mistake.message))
}
