//! Which face is in front: left to a depth buffer, or to the order in which faces are painted.

use super::bsp::{self, TooManyPieces};
use super::budget::OverBudget;
use super::pieces::Layer;
use super::projector::Projector;
use super::transform::Screen;
use super::visibility;
use crate::appearance::Visibility;
use crate::drawing::Surface;
use crate::progress::Progress;
use crate::scene::Object;

/// The surfaces of a picture in the order of its objects.
#[derive(Default)]
pub(super) struct Unordered<'a> {
    /// For a depth buffer.
    pub(super) surfaces: Vec<Surface>,
    /// To be put in order.
    layers: Vec<Layer>,
    /// The object of each layer.
    of_object: Vec<&'a Object>,
}

/// The surfaces of a picture as they are painted.
#[derive(Default)]
pub(super) struct Ordered {
    pub(super) surfaces: Vec<Surface>,
    /// How many faces were put in order, and into how many pieces they were split.
    pub(super) pieces: Option<(usize, usize)>,
    /// How many pieces had been made when there were too many: a depth buffer decides.
    pub(super) given_up: Option<(usize, OverBudget)>,
}

impl<'a> Unordered<'a> {
    pub(super) fn add_layer(&mut self, object: &'a Object, layer: Layer) {
        self.layers.push(layer);
        self.of_object.push(object);
    }

    /// Puts the faces in order, from back to front, where no depth buffer decides.
    pub(super) fn ordered(
        self,
        order: Visibility,
        (projector, screen): (&Projector, &Screen),
        max_pieces: usize,
        progress: &Progress,
    ) -> Ordered {
        let faces = self.layers.iter().map(|layer| layer.surface.triangles.len()).sum();
        let sorted = match order {
            Visibility::DepthBuffer => return Ordered { surfaces: self.surfaces, ..Ordered::default() },
            Visibility::Bsp => bsp::by_splitting(&self.layers, projector, screen, max_pieces, progress),
            Visibility::Painter => Ok(visibility::by_centroid(&self.layers, projector, screen)),
        };
        match sorted {
            Ok((surfaces, pieces)) => Ordered { surfaces, pieces: Some((faces, pieces)), given_up: None },
            Err(TooManyPieces { pieces, of_layer }) => {
                let names = self.of_object.iter().map(|object| object.name.as_str());
                let over_budget = OverBudget::pieces(names.zip(of_layer));
                let tested = |layer: Layer| Surface { depth_test: true, ..layer.surface };
                let surfaces = self.layers.into_iter().map(tested).collect();
                Ordered { surfaces, pieces: None, given_up: Some((pieces, over_budget)) }
            }
        }
    }
}
