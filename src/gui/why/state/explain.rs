//! The content of the explanations.

use super::matrices::Matrices;
use super::notes::Notes;
use super::order::Order;
use super::steps::Steps;
use super::triangle::TriangleNumbers;
use crate::camera::{Axes, CameraError, ImageSize, MatrixKind, Parameters};
use crate::explain::code::CodeTarget;
use crate::explain::vocabulary::{CameraNumber, Vocabulary};
use crate::figure::{Explanation, TransformPreview};
use crate::gui::background::memo::Memo;
use crate::pipeline::StageReport;
use crate::views::SharedScene;

/// A question that the side of explanations answers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Question {
    /// The origin of each number.
    #[default]
    Where,
    /// The work of the pipeline, in its order.
    Happens,
    /// The names in other sources.
    Called,
    /// Exercises and reading.
    Able,
}

impl Question {
    /// All.
    pub const ALL: [Self; 4] = [Self::Where, Self::Happens, Self::Called, Self::Able];

    /// The question that an explanation answers.
    #[must_use]
    pub const fn of(explanation: Explanation) -> Self {
        match explanation {
            Explanation::Matrices | Explanation::Point | Explanation::Homogeneous | Explanation::Order => Self::Where,
            Explanation::Steps
            | Explanation::Stages
            | Explanation::Triangle
            | Explanation::HiddenSurfaces
            | Explanation::Clipping
            | Explanation::Depth => Self::Happens,
            Explanation::Dialects | Explanation::Code | Explanation::Conventions => Self::Called,
            Explanation::Exercises | Explanation::Notes => Self::Able,
        }
    }
}

/// The explanations. Their visibility is in [`Panels`](crate::gui::state::Panels).
#[derive(Debug)]
pub struct Explain {
    question: Question,
    /// The explanation that each question showed last, in the order of [`Question::ALL`].
    last: [Explanation; 4],
    /// Objects where the explanation of order puts them in this frame.
    pub placed: Vec<TransformPreview>,
    /// The explanation of matrices.
    pub matrices: Matrices,
    /// The explanation of steps.
    pub steps: Steps,
    /// The explanation of order.
    pub order: Order,
    /// The notes.
    pub notes: Notes,
    /// The position of a point along a segment whose image is shown, 0 … 1.
    pub share: f64,
    /// The numbers of the triangle that is followed step by step.
    pub triangle: TriangleNumbers,
    /// The report of the strip's picture, stage by stage. Written by the pictures while the stages are explained.
    pub reports: Vec<StageReport>,
    /// The target of the code.
    pub code: CodeTarget,
    /// A number of another vocabulary that would not give a camera, and why.
    pub refused: Option<(Vocabulary, CameraNumber, f64, CameraError)>,
    /// A pasted matrix.
    pub pasted: Pasted,
    /// Whether dividing before clipping does no harm to a scene.
    pub(in crate::gui) divides_right: Memo<(SharedScene, Parameters), bool>,
}

/// A matrix as text, and how it is read.
#[derive(Clone, Debug, Default)]
pub struct Pasted {
    /// As it was typed.
    pub text: String,
    /// The camera of a text with several, from 0.
    pub camera: usize,
    /// Its kind; `None` means it is recognised.
    pub kind: Option<MatrixKind>,
    /// Whose axes it is written in; `None` means they are recognised.
    pub axes: Option<Axes>,
    /// It acts on row vectors.
    pub transposed: bool,
    /// The image of the pixels of K; `None` means that of the figure.
    pub image: Option<ImageSize>,
}

impl Explain {
    /// The question that is open.
    #[must_use]
    pub fn question(&self) -> Question {
        self.question
    }

    /// The explanation that is shown.
    #[must_use]
    pub fn shown(&self) -> Explanation {
        self.last[self.question as usize]
    }

    /// The explanations that the questions showed last.
    pub(in crate::gui) fn last(&self) -> [Explanation; 4] {
        self.last
    }

    /// Opens a question where it was left.
    pub fn ask(&mut self, question: Question) {
        self.question = question;
    }

    /// Shows an explanation, under its question.
    pub fn show(&mut self, explanation: Explanation) {
        self.question = Question::of(explanation);
        self.last[self.question as usize] = explanation;
    }
}

impl Default for Explain {
    fn default() -> Self {
        Self {
            question: Question::default(),
            last: [Explanation::Matrices, Explanation::Steps, Explanation::Dialects, Explanation::Exercises],
            placed: Vec::new(),
            matrices: Matrices::default(),
            steps: Steps::default(),
            order: Order::default(),
            notes: Notes::default(),
            share: 0.5,
            triangle: TriangleNumbers::default(),
            reports: Vec::new(),
            code: CodeTarget::default(),
            refused: None,
            pasted: Pasted::default(),
            divides_right: Memo::default(),
        }
    }
}
