//! What need not be drawn: objects outside the volume, and faces that turn their back.

use glam::DVec3;

use super::clip::{ALL_PLANES, PlaneSet, distances};
use super::transform::{Projector, ViewFromObject};
use crate::geometry::Aabb;

/// Where an object lies, as far as its bounding box tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// It has no vertices.
    Empty,
    /// No point of the box is in the volume: all of it is outside one of these planes.
    Outside(PlaneSet),
    /// Every point of the box is inside all planes but these, which it may cross.
    Crosses(PlaneSet),
}

/// Holds the eight corners of a bounding box against the six planes: what is true of all corners is true of all the box,
/// because the distances are linear before the divide.
///
/// "Inside" leaves a margin for rounding, so that an object that is not clipped would not have been changed by clipping.
pub(super) fn place(projector: &Projector, view_from_object: &ViewFromObject, bounds: &Aabb) -> Place {
    const MARGIN: f64 = 1e-13;
    let corners = bounds.corners().map(|corner| projector.clip(view_from_object.point(corner)));
    let reach = bounds.corners().iter().fold(0.0, |most, &corner| view_from_object.magnitude(corner).max(most));
    let w = if projector.perspective { reach } else { 1.0 };
    let slack = [
        MARGIN * (projector.scale[0] * reach + (1.0 + projector.shift[0].abs()) * w),
        MARGIN * (projector.scale[1] * reach + (1.0 + projector.shift[1].abs()) * w),
        MARGIN * (reach + projector.far),
    ];
    if !slack.iter().all(|s| s.is_finite()) {
        return Place::Crosses(ALL_PLANES);
    }
    let (mut outside, mut inside) = (ALL_PLANES, ALL_PLANES);
    for corner in corners {
        for (i, distance) in distances(projector, corner).into_iter().enumerate() {
            if distance >= -slack[i / 2] {
                outside &= !(1 << i);
            }
            if distance <= slack[i / 2] {
                inside &= !(1 << i);
            }
        }
    }
    if outside != 0 { Place::Outside(outside) } else { Place::Crosses(ALL_PLANES & !inside) }
}

/// Twice the area of a triangle on the image, positive where its corners run counter-clockwise as they are seen (y is down).
///
/// Exact: corners on the grid of subpixels have few enough digits for every product and sum. So neighbours agree on which side
/// of a silhouette they lie, and a closed mesh shows no holes.
#[inline(always)]
pub(super) fn area_on_image(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> f64 {
    let edge = |p: [f32; 3]| [f64::from(p[0]) - f64::from(a[0]), f64::from(p[1]) - f64::from(a[1])];
    let (e1, e2) = (edge(b), edge(c));
    e1[1] * e2[0] - e1[0] * e2[1]
}

/// The same sign for a triangle that is still to be clipped: is the eye on the outer side of its plane? Differences are taken
/// before products, so that thin triangles far away keep their sign.
pub(super) fn facing(projector: &Projector, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    if projector.perspective { -normal.dot(a) } else { normal.z }
}
