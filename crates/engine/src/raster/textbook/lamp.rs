//! Points as a lamp sees them, for the shadows of the textbook's rasterizer.

use glam::Vec3;

use super::{Triangle, mix};
use crate::drawing::{Rays, Shadow};

/// Places farther than this from a map, in texels, have no shadow.
const FAR: f32 = 1e6;

/// A point on a shadow map.
pub(super) struct MapPoint<'a> {
    /// The depths that the lamp sees, row by row.
    pub(super) depths: &'a [f32],
    /// Texels to the right and down.
    pub(super) x: f32,
    pub(super) y: f32,
    /// The depth of the point, and its change from texel to texel on the triangle.
    pub(super) z: f32,
    pub(super) slope: [f32; 2],
    /// The difference in depth that is as long as a texel.
    pub(super) step: f32,
}

impl<'a> MapPoint<'a> {
    /// Returns `None` if the lamp doesn't look there.
    pub(super) fn new(triangle: &Triangle, shadow: &'a Shadow, shares: [f32; 3]) -> Option<Self> {
        let views = shadow.map.depths()?;
        let place = Vec3::from(mix(shares, triangle.of(&shadow.places)?));
        let plane = Vec3::from(*shadow.planes.get(triangle.number)?);
        let point = match &shadow.map.rays {
            Rays::Parallel { step } => {
                let Vec3 { x, y, z } = place;
                Self { depths: views.first()?, x, y, z, slope: [plane.x, plane.y], step: *step }
            }
            Rays::FromLamp { axes, reach, unit } => {
                // Six views look along the sides of a cube: the point is farthest along the axis of its own.
                let axes = axes.map(|axes| axes.map(Vec3::from));
                let ahead = |view: usize| axes[view][2].dot(place);
                let view = (1..axes.len()).fold(0, |best, view| if ahead(view) > ahead(best) { view } else { best });
                let ([right, up, _], distance) = (axes[view], ahead(view));
                if distance <= 0.0 {
                    return None;
                }
                let size = shadow.map.size as f32;
                let (texels, steep) = (0.5 * size / (distance * reach), 2.0 * reach * unit / size);
                Self {
                    depths: views.get(view)?,
                    x: right.dot(place) * texels + 0.5 * size,
                    y: 0.5 * size - up.dot(place) * texels,
                    z: unit / distance - unit,
                    slope: [right.dot(plane) * steep, up.dot(plane) * -steep],
                    step: unit / distance * (2.0 * reach / size),
                }
            }
        };
        (point.x.abs() < FAR && point.y.abs() < FAR).then_some(point)
    }
}

/// The part of a texel under the soft edge around `middle`, along one axis.
pub(super) fn under(texel: f32, middle: f32, softness: f32) -> f32 {
    let half = 0.5 * softness;
    if softness > 0.0 { ((middle + half).min(texel + 1.0) - (middle - half).max(texel)).max(0.0) } else { 1.0 }
}
