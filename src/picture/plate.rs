//! Plates: the drawings that a picture is painted from. Pixels and vectors are made from the same ones.

use std::ops::Range;

use super::Renderer;
use crate::drawing::{Drawing, Surface};
use crate::pipeline::{Frame, OverBudget};
use crate::views::Request;

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
    pub(super) too_much: Option<OverBudget>,
}

impl From<Frame> for Plates {
    /// The display of a stage paints the faces that the stage drops over the others.
    fn from(mut frame: Frame) -> Self {
        frame.drawing.surfaces.append(&mut frame.dropped_faces);
        let width = frame.drawing.width;
        let whole = Plate { drawing: frame.drawing, columns: 0..width };
        let before = frame.before.map(|drawing| Plate { drawing, columns: 0..width / 2 });
        Self { plates: std::iter::once(whole).chain(before).collect(), too_much: frame.too_much }
    }
}

impl Renderer {
    /// The plates of a picture in which nothing is compared, for a page of vectors. `None` without enough memory for the
    /// image on the window.
    pub(super) fn plates(&mut self, request: &Request) -> Option<Plates> {
        let mut plates = Plates::from(self.drawing(request)?);
        // A forced stage asks a texture of one colour for the colour of each pixel. A page has areas of that colour.
        for plate in &mut plates.plates {
            plate.drawing.surfaces.iter_mut().for_each(Surface::simplify);
        }
        Some(plates)
    }
}
