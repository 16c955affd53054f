//! The content of the explanations.

use super::notes::Notes;
use super::order::Order;
use super::triangle::TriangleNumbers;
use crate::camera::{Axes, CameraError, ImageSize, MatrixKind, Ndc, Parameters};
use crate::explain::code::CodeTarget;
use crate::explain::vocabulary::{CameraNumber, Vocabulary};
use camera_lab_desk::{Memo, Model};

/// The explanations. Their visibility is in [`Panels`](camera_lab_desk::layout::Panels).
#[derive(Debug)]
pub struct Explain {
    /// The explanation of order.
    pub order: Order,
    /// The notes.
    pub notes: Notes,
    /// The position of a point along a segment whose image is shown, 0 … 1.
    pub share: f64,
    /// The gap between two surfaces, in scene units, for the test if they can be told apart.
    pub gap: f64,
    /// The resolutions of the formats of depth buffers, by the camera, its NDC, a depth and a gap.
    pub(in crate::gui) resolutions: Memo<(Parameters, Ndc, [f64; 2]), Vec<crate::numerics::Resolution>>,
    /// The numbers of the triangle followed step by step.
    pub triangle: TriangleNumbers,
    /// The target of the code.
    pub code: CodeTarget,
    /// A number of another vocabulary that wouldn't give a camera, and the reason.
    pub refused: Option<(Vocabulary, CameraNumber, f64, CameraError)>,
    /// A pasted matrix.
    pub pasted: Pasted,
    /// True if dividing before clipping does no harm to a scene.
    pub(in crate::gui) divides_right: Memo<(crate::views::SharedScene, Parameters), bool>,
}

/// A matrix as text, and the way to read it.
#[derive(Clone, Debug, Default)]
pub struct Pasted {
    /// The typed text.
    pub text: String,
    /// The camera of a text with several, from 0.
    pub camera: usize,
    /// Its kind. `None` to recognise it.
    pub kind: Option<MatrixKind>,
    /// The owner of its axes. `None` to recognise them.
    pub axes: Option<Axes>,
    /// It acts on row vectors.
    pub transposed: bool,
    /// The image of the pixels of K. `None` for that of the figure.
    pub image: Option<ImageSize>,
}

impl Default for Explain {
    fn default() -> Self {
        Self {
            order: Order::default(),
            notes: Notes::default(),
            share: 0.5,
            gap: 0.01,
            resolutions: Memo::default(),
            triangle: TriangleNumbers::default(),
            code: CodeTarget::default(),
            refused: None,
            pasted: Pasted::default(),
            divides_right: Memo::default(),
        }
    }
}

impl Explain {
    /// Shows a note, which takes the keyboard in the list of notes.
    pub(in crate::gui) fn explain_by_note(&mut self, model: &mut Model, id: &'static str) {
        self.notes.go_to(id);
        model.show_explanation(crate::figure::Explanation::Notes);
    }
}
