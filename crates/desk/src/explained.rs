//! The part of the explanations that views and figure files share: the displayed one, its matrix entry and its steps.

pub mod matrices;
pub mod steps;

use crate::camera::Ndc;
use crate::explained::matrices::Matrices;
use crate::explained::steps::Steps;
use crate::figure::Explanation;

/// A question answered by the side of explanations.
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

/// The displayed explanation. Its visibility is in [`Panels`](super::layout::Panels).
#[derive(Debug)]
pub struct Explained {
    question: Question,
    /// The last explanation of each question, in the order of [`Question::ALL`].
    last: [Explanation; 4],
    /// The explanation of matrices.
    pub matrices: Matrices,
    /// The explanation of steps.
    pub steps: Steps,
}

impl Explained {
    /// The open question.
    pub fn question(&self) -> Question {
        self.question
    }

    /// The displayed explanation.
    pub fn shown(&self) -> Explanation {
        self.last[self.question as usize]
    }

    /// The last explanations of the questions.
    pub fn last(&self) -> [Explanation; 4] {
        self.last
    }

    /// Opens a question at its last explanation.
    pub fn ask(&mut self, question: Question) {
        self.question = question;
    }

    /// Shows an explanation, under its question.
    pub fn show(&mut self, explanation: Explanation) {
        self.question = Question::of(explanation);
        self.last[self.question as usize] = explanation;
    }
}

impl Default for Explained {
    fn default() -> Self {
        Self {
            question: Question::default(),
            last: [Explanation::Matrices, Explanation::Steps, Explanation::Dialects, Explanation::Exercises],
            matrices: Matrices::default(),
            steps: Steps::default(),
        }
    }
}

/// The convention of NDC, and the notation of matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Conventions {
    /// The NDC of the numbers, the probe and the canonical volume.
    pub ndc: Ndc,
    /// The convention compared with.
    pub compared: Option<Ndc>,
    /// Points are rows: matrices are transposed.
    pub row_vectors: bool,
    /// True if z_c is shown growing along DOP.
    pub left_handed: bool,
}
