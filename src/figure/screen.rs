//! The explanations that a window can show beside the pictures, by name.

/// An explanation at the side of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Explanation {
    /// Each entry of each matrix, as formula and as number.
    #[default]
    Matrices,
    /// A point through every space, forward and back.
    Point,
    /// The effects of w.
    Homogeneous,
    /// The order of transforms.
    Order,
    /// The view volume becomes the canonical one, step by step.
    Steps,
    /// The stages of the pipeline, and their input and output.
    Stages,
    /// One triangle through the stages.
    Triangle,
    /// The image as far as it is painted, by each hidden-surface algorithm.
    HiddenSurfaces,
    /// The parts outside the view volume, and the division before clipping.
    Clipping,
    /// Depths along the view volume, and formats of depth buffers.
    Depth,
    /// The camera in other vocabularies, and a pasted matrix.
    Dialects,
    /// The camera as code.
    Code,
    /// Whose NDC, compared with whose, and how matrices are written.
    Conventions,
    /// Exercises whose answers are checked.
    Exercises,
    /// A short text for each symbol, operation, equation, step and stage.
    Notes,
}
