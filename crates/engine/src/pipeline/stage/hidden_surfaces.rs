//! **Hidden surfaces**, for an output without a depth buffer: the order in which faces are painted.
//!
//! *Notes*: `[3]` §1.1 step 8; `[2]`, *Modelo do Pintor* and z-buffer. *Textbook*: a depth for each pixel, in the
//! rasterizer, or the painter's algorithm: faces sorted by the depth of their centroids, which fails if they interlock.
//! *Here*: pixels have their depth buffer in [`raster`](crate::raster), and this function hands the surfaces on as they
//! are. Vectors have no pixels, so their faces are sorted by a tree of planes and split where they cross
//! ([`bsp`](crate::pipeline::order::bsp)). That's exact, but may make too many pieces. A depth buffer then has to
//! decide after all, and the frame says so. The painter is there to show how it fails.

use super::vertex::{clip_from_view, divide, snap, viewport};
use crate::appearance::Visibility;
use crate::drawing::Surface;
use crate::pipeline::budget::OverBudget;
use crate::pipeline::order::bsp::{self, TooManyPieces};
use crate::pipeline::order::painter;
use crate::pipeline::order::pieces::Layer;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{Screen, ViewPoint};
use crate::progress::Progress;
use crate::scene::Object;

/// The surfaces of a picture in the order of its objects.
#[derive(Default)]
pub(crate) struct Unordered<'a> {
    /// For a depth buffer.
    pub(crate) surfaces: Vec<Surface>,
    /// To be put in order.
    layers: Vec<Layer>,
    /// The object of each layer, with its place in the picture.
    of_object: Vec<(usize, &'a Object)>,
}

/// The surfaces of a picture as they are painted.
#[derive(Default)]
pub(crate) struct Ordered {
    pub(crate) surfaces: Vec<Surface>,
    /// The number of faces put in order, and of pieces they were split into.
    pub(crate) pieces: Option<(usize, usize)>,
    /// The number of pieces made when there were too many, so that a depth buffer decides, and the message if objects
    /// of the scene are among those that were split.
    pub(crate) given_up: Option<(usize, Option<OverBudget>)>,
}

/// The limit of splitting, and the objects that a message names if it's exceeded.
#[derive(Clone, Copy)]
pub(crate) struct PieceBudget {
    pub(crate) max_pieces: usize,
    /// Number of objects of the scene. Those that come after them are gear.
    pub(crate) own_objects: usize,
}

impl<'a> Unordered<'a> {
    pub(crate) fn add_layer(&mut self, index: usize, object: &'a Object, layer: Layer) {
        self.layers.push(layer);
        self.of_object.push((index, object));
    }
}

/// Puts the faces in order, from back to front, unless a depth buffer decides.
pub(crate) fn hidden_surfaces(
    unordered: Unordered,
    order: Visibility,
    (projector, screen): (&Projector, &Screen),
    budget: PieceBudget,
    progress: &Progress,
) -> Ordered {
    let Unordered { surfaces, layers, of_object } = unordered;
    let faces = layers.iter().map(|layer| layer.surface.triangles.len()).sum();
    // Corners that splitting makes go the way of all vertices.
    let depths = &projector.depths;
    let image = |p: ViewPoint| {
        let corner = snap(screen, viewport(screen, divide(depths, clip_from_view(projector, p))));
        (corner, depths.relative_inverse_w(-p.0.z))
    };
    let sorted = match order {
        Visibility::DepthBuffer => return Ordered { surfaces, ..Ordered::default() },
        Visibility::Bsp => bsp::by_splitting(&layers, projector, &image, budget.max_pieces, progress),
        Visibility::Painter => Ok(painter::by_centroid(&layers, &image)),
    };
    match sorted {
        Ok((surfaces, pieces)) => Ordered { surfaces, pieces: Some((faces, pieces)), given_up: None },
        Err(TooManyPieces { pieces, of_layer }) => {
            let shares = of_object.iter().zip(of_layer).filter(|((index, _), _)| *index < budget.own_objects);
            let over_budget = OverBudget::pieces(shares.map(|((_, object), share)| (object.name.as_str(), share)));
            let tested = |layer: Layer| Surface { depth_test: true, ..layer.surface };
            let surfaces = layers.into_iter().map(tested).collect();
            Ordered { surfaces, pieces: None, given_up: Some((pieces, over_budget)) }
        }
    }
}
