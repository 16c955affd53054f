//! Plates: the drawings from which a picture is painted. Pixels and vectors come from the same ones.

use std::ops::Range;

use crate::drawing::Drawing;
use crate::pipeline::{Frame, OverBudget};

/// A drawing as large as its picture, and the columns of the picture that show it. A later plate covers an earlier one.
#[derive(Debug)]
pub(super) struct Plate {
    pub(super) drawing: Drawing,
    pub(super) columns: Range<u32>,
}

/// The plates of one picture.
#[derive(Debug)]
pub(super) struct Plates {
    /// The whole picture, then the half before a stage, if one is shown.
    pub(super) plates: Vec<Plate>,
    /// The shortfall of the picture.
    pub(super) over_budget: Option<OverBudget>,
}

impl From<Frame> for Plates {
    /// To display a stage, the faces that the stage drops are painted over the others.
    fn from(mut frame: Frame) -> Self {
        frame.drawing.surfaces.append(&mut frame.dropped_faces);
        let width = frame.drawing.width;
        let whole = Plate { drawing: frame.drawing, columns: 0..width };
        let before = frame.before.map(|drawing| Plate { drawing, columns: 0..width / 2 });
        Self { plates: std::iter::once(whole).chain(before).collect(), over_budget: frame.over_budget }
    }
}
