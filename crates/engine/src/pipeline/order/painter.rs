//! The order of faces if no depth buffer decides: the painter's algorithm by centroids. The tree of planes is in
//! [`bsp`](super::bsp).
//!
//! Both take the surfaces as they were shaded, and give them back in the order in which they are to be painted, one
//! over the other, and how many pieces these are. Translucent faces blend as they come.

use super::pieces::{Corner, Layer, Piece, pieces};
use crate::drawing::Surface;
use crate::pipeline::mesh::resample::{VertexOrigin, append, can_append, empty_like};
use crate::pipeline::space::ViewPoint;

/// Sorts by the distance of the centroid, the farthest first. Wrong if faces interlock or differ much in size, and here
/// to show this failure.
pub(crate) fn by_centroid(layers: &[Layer], image: &ToImage) -> (Vec<Surface>, usize) {
    let (all, _) = pieces(layers);
    let distance = |piece: &Piece| piece.corners.iter().map(|corner| -corner.view.z).sum::<f64>();
    let mut pieces: Vec<(f64, Piece)> = all.into_iter().map(|piece| (distance(&piece), piece)).collect();
    // If distances are equal, the first listed is painted last and stays, as in a depth buffer.
    pieces.reverse();
    pieces.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut painter = Painter::new(layers, image);
    pieces.iter().for_each(|(_, piece)| painter.paint(piece, &piece.corners));
    (painter.surfaces, pieces.len())
}

/// Takes a new corner, in view space, to the image: pixels with depth, and 1/w in the unit of the depths.
pub(crate) type ToImage<'a> = dyn Fn(ViewPoint) -> ([f32; 3], f32) + 'a;

/// Puts pieces one after the other into as few surfaces as their paints allow.
pub(crate) struct Painter<'a> {
    layers: &'a [Layer],
    image: &'a ToImage<'a>,
    pub(crate) surfaces: Vec<Surface>,
    last_layer: Option<usize>,
}

impl<'a> Painter<'a> {
    /// Creates a painter without surfaces.
    pub(crate) fn new(layers: &'a [Layer], image: &'a ToImage<'a>) -> Self {
        Self { layers, image, surfaces: Vec::new(), last_layer: None }
    }

    /// Paints a piece, whose border has these corners.
    pub(crate) fn paint(&mut self, piece: &Piece, corners: &[Corner]) {
        let old = &self.layers[piece.layer].surface;
        let of = old.triangles[piece.triangle as usize];
        let same_layer = self.last_layer.replace(piece.layer) == Some(piece.layer);
        if !self.surfaces.last().is_some_and(|last| same_layer || can_append(last, old)) {
            self.surfaces.push(empty_like(old));
        }
        let Some(surface) = self.surfaces.last_mut() else { return };
        let first = u32::try_from(surface.positions.len()).unwrap_or(u32::MAX);
        let origins: Vec<VertexOrigin> = corners.iter().map(|corner| corner.origin(of)).collect();
        for (corner, origin) in corners.iter().zip(&origins) {
            let (position, inverse_w) = match origin {
                VertexOrigin::Vertex(i) => {
                    let i = *i as usize;
                    (old.positions[i], old.inverse_w.get(i).copied().unwrap_or_default())
                }
                VertexOrigin::Between { .. } => (self.image)(ViewPoint(corner.view)),
            };
            surface.positions.push(position);
            if !old.inverse_w.is_empty() {
                surface.inverse_w.push(inverse_w);
            }
        }
        let last = first + u32::try_from(corners.len()).unwrap_or(0);
        let before = surface.triangles.len();
        surface.triangles.extend((first + 1..last.saturating_sub(1)).map(|k| [first, k, k + 1]));
        let pieces = surface.triangles.len() - before;
        append(surface, old, &origins, piece.triangle, pieces);
    }
}
