//! The side of explanations, in the place of operations and numbers: four questions, and their answers.
//!
//! An explanation is a variant of [`Explanation`], its row in `QUESTIONS` and a file here with `fn ui`. Only the
//! displayed one computes anything.

mod answer;
mod arithmetic;
mod clipping;
mod depth;
mod hidden_surfaces;
mod homogeneous;
/// The explanations of matrices: entries, conventions, other vocabularies, code.
pub(super) mod matrix {
    pub(super) mod code;
    pub(super) mod conventions;
    pub(super) mod dialects;
    pub(super) mod digits;
    pub(super) mod entries;
    pub(super) mod matrices;
    pub(super) mod pasted_matrix;
}
mod measures;
mod notes;
mod order;
mod order_list;
mod point;
mod stages;
/// The state of the explanations between frames.
pub(super) mod state {
    pub(in crate::gui) mod explain;
    pub(in crate::gui) mod notes;
    pub(in crate::gui) mod order;
    pub(in crate::gui) mod triangle;
}
mod steps;
mod triangle;

use eframe::egui::{Button, RichText, TextStyle, Ui, vec2};
pub(super) use triangle::clicked;

use crate::explain::{Placement, Setting};
use crate::figure::Explanation;
use crate::gui::kit::{Explained, elide, toggle};
use crate::gui::why::state::explain::Explain;
use camera_lab_desk::{Action, Model, Question};
use camera_lab_words::why::explain::{self, Texts};
use camera_lab_words::window::compare as words;

/// A name and a hint.
type Words = fn(&Texts) -> (&'static str, &'static str);

/// A question, and the explanations that answer it.
struct QuestionRow {
    question: Question,
    words: Words,
    answers: &'static [ExplanationRow],
}

/// An explanation: its name, its purpose, and its content.
struct ExplanationRow {
    explanation: Explanation,
    words: Words,
    /// The part that stays in sight while the rest is scrolled.
    head: Option<Content>,
    content: Content,
}

/// Shows an explanation, or its head.
type Content = fn(&mut Ui, &mut Model, &mut Explain);

impl ExplanationRow {
    /// An explanation that scrolls as a whole.
    const fn new(explanation: Explanation, words: Words, content: Content) -> Self {
        Self { explanation, words, head: None, content }
    }
}

/// The questions and their explanations, in reading order.
const QUESTIONS: &[QuestionRow] = &[
    QuestionRow {
        question: Question::Where,
        words: |t| (t.question_where, t.question_where_hint),
        answers: &[
            ExplanationRow::new(Explanation::Matrices, |t| (t.matrices, t.matrices_hint), matrix::matrices::ui),
            ExplanationRow::new(Explanation::Point, |t| (t.point, t.point_hint), point::ui),
            ExplanationRow::new(Explanation::Homogeneous, |t| (t.homogeneous, t.homogeneous_hint), homogeneous::ui),
            ExplanationRow {
                head: Some(order::head),
                ..ExplanationRow::new(Explanation::Order, |t| (t.order, t.order_hint), order::ui)
            },
        ],
    },
    QuestionRow {
        question: Question::Happens,
        words: |t| (t.question_happens, t.question_happens_hint),
        answers: &[
            ExplanationRow::new(Explanation::Steps, |t| (t.steps, t.steps_hint), steps::ui),
            ExplanationRow::new(Explanation::Stages, |t| (t.stages, t.stages_hint), stages::ui),
            ExplanationRow::new(Explanation::Triangle, |t| (t.triangle, t.triangle_hint), triangle::ui),
            ExplanationRow::new(
                Explanation::HiddenSurfaces,
                |t| (t.hidden_surfaces, t.hidden_surfaces_hint),
                hidden_surfaces::ui,
            ),
            ExplanationRow::new(Explanation::Clipping, |t| (t.clipping, t.clipping_hint), clipping::ui),
            ExplanationRow::new(Explanation::Depth, |t| (t.depth, t.depth_hint), depth::ui),
        ],
    },
    QuestionRow {
        question: Question::Called,
        words: |t| (t.question_called, t.question_called_hint),
        answers: &[
            ExplanationRow::new(Explanation::Dialects, |t| (t.dialects, t.dialects_hint), matrix::dialects::ui),
            ExplanationRow::new(Explanation::Code, |t| (t.code, t.code_hint), matrix::code::ui),
            ExplanationRow::new(
                Explanation::Conventions,
                |t| (t.conventions, t.conventions_hint),
                matrix::conventions::ui,
            ),
        ],
    },
    QuestionRow {
        question: Question::Able,
        words: |t| (t.question_able, t.question_able_hint),
        answers: &[
            // Their own feature shows them.
            ExplanationRow::new(Explanation::Exercises, |t| (t.exercises, t.exercises_hint), |_, _, _| {}),
            ExplanationRow::new(Explanation::Notes, |t| (t.notes, t.notes_hint), notes::ui),
        ],
    },
];

/// Name and purpose of each explanation, with its question.
pub(super) fn all(t: &Texts) -> impl Iterator<Item = (Explanation, &'static str, (&'static str, &'static str))> {
    QUESTIONS.iter().flat_map(move |row| {
        let question = (row.words)(t).0;
        row.answers.iter().map(move |answer| (answer.explanation, question, (answer.words)(t)))
    })
}

/// The row of the chosen explanation.
fn row(model: &Model) -> Option<&'static ExplanationRow> {
    QUESTIONS.iter().flat_map(|row| row.answers).find(|row| row.explanation == model.explained.shown())
}

/// Shows the questions, the explanations of the open one, and the part of the chosen explanation that stays in sight.
pub(super) fn head(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = explain::texts(model.settings.lang);
    ui.add_space(2.0);
    questions(ui, t, model);
    let open = QUESTIONS.iter().find(|row| row.question == model.explained.question());
    ui.horizontal_wrapped(|ui| {
        for row in open.iter().flat_map(|row| row.answers) {
            let (name, hint) = (row.words)(t);
            let is_shown = model.explained.shown() == row.explanation;
            if toggle(ui, is_shown, name).explained(hint).clicked() {
                model.show_explanation(row.explanation);
            }
        }
    });
    ui.add_space(2.0);
    if let Some(head) = row(model).and_then(|row| row.head).filter(|_| model.frame.asked.is_empty()) {
        head(ui, model, explain);
        ui.separator();
    }
}

/// Shows the rest of the chosen explanation.
pub(super) fn content(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    if let Some(row) = row(model) {
        (row.content)(ui, model, explain);
    }
}

/// In place of an explanation whose numbers an open question asks for.
pub(super) fn asked(ui: &mut Ui, model: &Model) {
    let t = camera_lab_words::window::texts(model.settings.lang);
    ui.label(RichText::new(t.asked_here).strong());
    ui.label(t.asked_hint);
}

/// Beside the name of a question on its button, in points.
const PADDING: f32 = 3.0;

/// The four questions, two in a row. Each opens at its last explanation.
fn questions(ui: &mut Ui, t: &Texts, model: &mut Model) {
    let gap = 4.0;
    let (room, height) = (ui.available_width() - gap, ui.spacing().interact_size.y);
    let font = TextStyle::Small;
    let names = |column: usize| QUESTIONS.iter().skip(column).step_by(2).map(|row| (row.words)(t).0);
    let widest = [0, 1].map(|column| {
        let widths = names(column).map(|name| elide::width(ui, &font.resolve(ui.style()), name) + 2.0 * PADDING);
        widths.fold(1.0, f32::max)
    });
    // A column is as wide as its longest name asks for.
    let shares = widest.map(|width| width / (widest[0] + widest[1]));
    let wraps = widest[0] + widest[1] > room;
    // If one name needs two lines, all buttons are as high.
    let height = if wraps { 2.0 * ui.text_style_height(&font) + 2.0 * ui.spacing().button_padding.y } else { height };
    for two in QUESTIONS.chunks(2) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            ui.spacing_mut().button_padding.x = PADDING;
            for (row, share) in two.iter().zip(shares) {
                let size = vec2((room * share).floor(), height);
                let (name, hint) = (row.words)(t);
                let open = model.explained.question() == row.question;
                let text = RichText::new(name).text_style(font.clone());
                let text = if open { text.strong() } else { text };
                let button = Button::selectable(open, text).frame_when_inactive(true).wrap().min_size(size);
                if ui.add_sized(size, button).explained(hint).clicked() {
                    model.explained.ask(row.question);
                }
            }
        });
    }
    ui.separator();
}

/// A button that opens the comparison.
fn compare_button(ui: &mut Ui, model: &mut Model) {
    let words = words::texts(model.settings.lang);
    if ui.button(words.command).explained(words.command_hint).clicked() {
        model.request(Action::Compare);
    }
}

/// The numbers of the symbols, without the rest of the window.
struct ExplainedSetting {
    camera: crate::camera::Camera,
    /// The selected object, by its name.
    object: Option<(String, Placement)>,
}

impl ExplainedSetting {
    /// The camera of the figure, and the selected object, if there is one.
    fn of(model: &Model) -> Self {
        Self { camera: model.desk.shown.camera().clone(), object: model.selected_placement() }
    }

    /// The setting in the convention, image and viewport of the window.
    fn setting(&self, model: &Model) -> Setting<'_> {
        let figure = model.desk.shown.figure();
        let space = self.camera.possible_clip_space(model.settings.conventions.ndc);
        let setting = Setting::new(space, figure.image, figure.viewport);
        match &self.object {
            Some((_, placement)) => setting.with_placement(*placement),
            None => setting,
        }
    }
}
