//! The display of a figure in a window: the `[screen]` section of a figure. The explanations that a window can show
//! beside the pictures, by name.

use super::View;

/// The `[screen]` section: the display of the figure in a window. No picture depends on it. Settings that it doesn't
/// give stay as they are in the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Screen {
    /// The visible pictures, in the order of [`View::ALL`]; at least one is true.
    pub pictures: Option<[bool; View::COUNT]>,
    /// The arrangement of several pictures; `Some(None)` is automatic.
    pub arrangement: Option<Option<Arrangement>>,
    /// The explanation at the side; `Some(None)` is none.
    pub panel: Option<Option<Explanation>>,
    /// The entry that the explanation of matrices shows.
    pub entry: Option<ScreenEntry>,
}

/// An entry of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScreenEntry {
    /// The open matrix, such as `M_p`.
    pub matrix: ScreenMatrix,
    /// True for an entry of the inverse.
    pub inverse: bool,
    /// Row and column, from 1.
    pub place: [u8; 2],
}

crate::worded! {
    /// A matrix of the camera, or of the selected object.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum ScreenMatrix {
        /// M_m, of an object.
        Model = "model",
        /// M_v.
        View = "view",
        /// M_p.
        Projection = "projection",
        /// M_p M_v.
        ViewProjection = "view-projection",
        /// `M_vp`.
        Viewport = "viewport",
    }
    /// Its name in a figure file.
    pub fn name
}

/// An arrangement of several pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arrangement {
    /// Side by side.
    Row,
    /// One above the other.
    Column,
    /// The first above the others.
    Above,
    /// The first to the left of the others.
    Beside,
}

impl Arrangement {
    /// All.
    pub const ALL: [Self; 4] = [Self::Row, Self::Column, Self::Above, Self::Beside];
}

crate::worded! {
    /// An explanation at the side of the window.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Explanation {
        /// Each entry of each matrix, as formula and as number.
        #[default]
        Matrices = "matrices",
        /// A point through every space, forward and back.
        Point = "point",
        /// The effects of w.
        Homogeneous = "w",
        /// The order of transforms.
        Order = "order",
        /// The view volume becomes the canonical one, step by step.
        Steps = "steps",
        /// The stages of the pipeline, and their input and output.
        Stages = "stages",
        /// One triangle through the stages.
        Triangle = "triangle",
        /// The image as far as it's painted, by each hidden-surface algorithm.
        HiddenSurfaces = "hidden-surfaces",
        /// The parts outside the view volume, and the division before clipping.
        Clipping = "clipping",
        /// Depths along the view volume, and formats of depth buffers.
        Depth = "depth",
        /// The camera in other vocabularies, and a pasted matrix.
        Dialects = "dialects",
        /// The camera as code.
        Code = "code",
        /// The chosen NDC, compared with another, and the notation of matrices.
        Conventions = "conventions",
        /// Exercises with checked answers.
        Exercises = "exercises",
        /// A short text for each symbol, operation, equation, step and stage.
        Notes = "notes",
    }
    /// Its name in a figure file.
    pub fn name
}
