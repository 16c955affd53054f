//! The content of the explanations.

use super::matrices::Matrices;
use super::notes::Notes;
use super::order::Order;
use super::steps::Steps;
use super::triangle::TriangleNumbers;
use crate::camera::{CameraError, MatrixKind};
use crate::explain::code::CodeTarget;
use crate::explain::vocabulary::{CameraNumber, Vocabulary};
use crate::figure::TransformPreview;
use crate::pipeline::StageReport;

/// A tab of the side of explanations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ExplainTab {
    /// Each entry of each matrix, as formula and as number.
    #[default]
    Matrices,
    /// A point through every space, forward and back.
    Point,
    /// The view volume becomes the canonical one, step by step.
    Steps,
    /// The effects of w.
    Homogeneous,
    /// The image as far as it is painted.
    Stages,
    /// The camera in other vocabularies, and a pasted matrix.
    Dialects,
    /// The order of transforms.
    Order,
    /// The camera as code.
    Code,
    /// A short text for each symbol, operation, equation, step and stage.
    Notes,
    /// Exercises whose answers are checked.
    Exercises,
}

/// The explanations. Their visibility is in [`Panels`](super::Panels).
#[derive(Debug)]
pub struct Explain {
    /// The tab that is shown.
    pub tab: ExplainTab,
    /// Objects where the tab of order puts them in this frame.
    pub placed: Vec<TransformPreview>,
    /// The tab of matrices.
    pub matrices: Matrices,
    /// The tab of steps.
    pub steps: Steps,
    /// The tab of order.
    pub order: Order,
    /// The tab of notes.
    pub notes: Notes,
    /// The position of a point along a segment whose image is shown, 0 … 1.
    pub share: f64,
    /// The numbers of the triangle that is followed step by step.
    pub triangle: TriangleNumbers,
    /// The report of the strip's picture, stage by stage; written by the pictures while the tab of stages is shown.
    pub reports: Vec<StageReport>,
    /// The target of the code.
    pub code: CodeTarget,
    /// A number of another vocabulary that would not give a camera, and why.
    pub refused: Option<(Vocabulary, CameraNumber, f64, CameraError)>,
    /// A pasted matrix.
    pub pasted: Pasted,
}

/// A matrix as text, and its kind.
#[derive(Clone, Debug)]
pub struct Pasted {
    /// As it was typed.
    pub text: String,
    /// Its kind.
    pub kind: MatrixKind,
    /// It acts on row vectors.
    pub transposed: bool,
}

impl Default for Pasted {
    fn default() -> Self {
        Self { text: String::new(), kind: MatrixKind::ViewProjection, transposed: false }
    }
}

impl Default for Explain {
    fn default() -> Self {
        Self {
            tab: ExplainTab::default(),
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
        }
    }
}
