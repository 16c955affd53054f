//! Which face is in front: left to a depth buffer, or to the order in which faces are painted.

use super::vertices::Screen;
use crate::appearance::Visibility;
use crate::drawing::Surface;
use crate::pipeline::budget::OverBudget;
use crate::pipeline::order::bsp::{self, TooManyPieces};
use crate::pipeline::order::painter;
use crate::pipeline::order::pieces::Layer;
use crate::pipeline::space::projector::Projector;
use crate::progress::Progress;
use crate::scene::Object;

/// The surfaces of a picture in the order of its objects.
#[derive(Default)]
pub(crate) struct Unordered<'a> {
    /// For a depth buffer.
    pub(crate) surfaces: Vec<Surface>,
    /// To be put in order.
    layers: Vec<Layer>,
    /// The object of each layer.
    of_object: Vec<&'a Object>,
}

/// The surfaces of a picture as they are painted.
#[derive(Default)]
pub(crate) struct Ordered {
    pub(crate) surfaces: Vec<Surface>,
    /// How many faces were put in order, and into how many pieces they were split.
    pub(crate) pieces: Option<(usize, usize)>,
    /// How many pieces had been made when there were too many: a depth buffer decides.
    pub(crate) given_up: Option<(usize, OverBudget)>,
}

impl<'a> Unordered<'a> {
    pub(crate) fn add_layer(&mut self, object: &'a Object, layer: Layer) {
        self.layers.push(layer);
        self.of_object.push(object);
    }

    /// Puts the faces in order, from back to front, where no depth buffer decides.
    pub(crate) fn ordered(
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
            Visibility::Painter => Ok(painter::by_centroid(&self.layers, projector, screen)),
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
