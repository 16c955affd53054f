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

use eframe::egui::{self, Button, RichText, TextStyle, Ui, vec2};
pub(super) use triangle::clicked;

use crate::explain::{Placement, Setting};
use crate::figure::Explanation;
use crate::gui::kit::{Explained, elide, keep_in_sight, toggle};
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
    content: Option<Content>,
}

/// Shows an explanation, or its head.
type Content = fn(&mut Ui, &mut Model, &mut Explain);

/// A part of another feature, shown among the explanations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// The part of the exercises that stays in sight.
    Exercise,
    /// The part of them that scrolls.
    Exercises,
    /// The matrices, in the chosen conventions.
    Matrices,
}

impl ExplanationRow {
    /// An explanation that scrolls as a whole.
    const fn new(explanation: Explanation, words: Words, content: Content) -> Self {
        Self { explanation, words, head: None, content: Some(content) }
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
            ExplanationRow {
                explanation: Explanation::Exercises,
                words: |t| (t.exercises, t.exercises_hint),
                head: None,
                content: None,
            },
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

/// Shows the questions, the explanations of the open one, and the chosen explanation.
pub(super) fn ui(
    ui: &mut Ui,
    model: &mut Model,
    explain: &mut Explain,
    other: &mut dyn FnMut(&mut Ui, &mut Model, Part),
) {
    let t = explain::texts(model.settings.lang);
    ui.add_space(2.0);
    questions(ui, t, model);
    let Some(question) = QUESTIONS.iter().find(|row| row.question == model.explained.question()) else { return };
    ui.horizontal_wrapped(|ui| {
        for row in question.answers {
            let (name, hint) = (row.words)(t);
            let is_shown = model.explained.shown() == row.explanation;
            if toggle(ui, is_shown, name).explained(hint).clicked() {
                model.show_explanation(row.explanation);
            }
        }
    });
    ui.add_space(2.0);
    let Some(row) = question.answers.iter().find(|row| row.explanation == model.explained.shown()) else {
        return;
    };
    match row.head {
        Some(head) => head(ui, model, explain),
        None if row.content.is_none() => other(ui, model, Part::Exercise),
        None => {}
    }
    if row.head.is_some() || row.content.is_none() {
        ui.separator();
    }
    egui::ScrollArea::vertical().id_salt(("explain", row.explanation)).auto_shrink(false).show(ui, |ui| {
        match row.content {
            Some(content) => content(ui, model, explain),
            None => other(ui, model, Part::Exercises),
        }
        if row.explanation == Explanation::Conventions {
            other(ui, model, Part::Matrices);
        }
        keep_in_sight(ui);
    });
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
