//! What need not be drawn: objects outside the volume, and faces that turn their back.

use glam::DVec3;

use super::bounds::Bounds;
use super::planes::{ALL_PLANES, PLANES, PlaneSet, distances};
use super::projector::{Projector, ViewFromObject};
use crate::geometry::Aabb;

/// Where an object lies, as far as the box and the ball around it tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Containment {
    /// It has no vertices.
    Empty,
    /// No point of it is in the volume: all of it is outside each of these planes.
    Outside(PlaneSet),
    /// All of it is inside all planes but these, which it may cross.
    Crosses(PlaneSet),
}

/// Holds the box and the ball around an object against the six planes: what is true of the corners of a box is true of all of
/// it, because the distances are linear before the divide; of a ball, the middle and the radius tell.
///
/// "Inside" leaves a margin for rounding, so that an object that is not clipped would not have been changed by clipping.
pub(super) fn containment(projector: &Projector, view_from_object: &ViewFromObject, bounds: &Bounds) -> Containment {
    const MARGIN: f64 = 1e-13;
    let corners = bounds.aabb.corners();
    let reach = corners.iter().fold(0.0, |most, &corner| view_from_object.magnitude(corner).max(most));
    let slack = slack(projector, MARGIN, reach);
    if !bounds.finite || !slack.iter().all(|s| s.is_finite()) {
        return Containment::Crosses(ALL_PLANES);
    }
    let mut range = [(f64::INFINITY, f64::NEG_INFINITY); PLANES];
    for corner in corners {
        for (range, d) in range.iter_mut().zip(distances(projector, projector.clip(view_from_object.point(corner)))) {
            *range = (range.0.min(d), range.1.max(d));
        }
    }
    let middle = distances(projector, projector.clip(view_from_object.point(bounds.aabb.center())));
    let (mut outside, mut inside) = (0, 0);
    for (i, (least, most)) in range.into_iter().enumerate() {
        let across = bounds.radius * view_from_object.slope(projector.gradient(i));
        let (least, most) = (least.max(middle[i] - across), most.min(middle[i] + across));
        outside |= PlaneSet::from(most < -slack[i / 2]) << i;
        inside |= PlaneSet::from(least > slack[i / 2]) << i;
    }
    if outside != 0 { Containment::Outside(outside) } else { Containment::Crosses(ALL_PLANES & !inside) }
}

/// The planes that all of a box in the world is outside of. `magnitude` is the size of the numbers from which the coordinates
/// inside it are made; the margin is wide, since they may have come to view space on another way.
pub(super) fn outside(projector: &Projector, aabb: &Aabb, magnitude: f64) -> PlaneSet {
    const MARGIN: f64 = 1e-9;
    let slack = slack(projector, MARGIN, magnitude + projector.magnitude());
    let corners = aabb.corners().into_iter();
    corners.fold(ALL_PLANES, |outside, corner| {
        let distances = distances(projector, projector.clip(projector.view(corner)));
        (0..PLANES).fold(outside, |outside, i| outside & !(PlaneSet::from(distances[i] >= -slack[i / 2]) << i))
    })
}

/// How wrong the distances from the planes may be: of left and right, bottom and top, near and far.
fn slack(projector: &Projector, margin: f64, reach: f64) -> [f64; 3] {
    let w = if projector.perspective { reach } else { 1.0 };
    [
        margin * (projector.scale[0] * reach + (1.0 + projector.shift[0].abs()) * w),
        margin * (projector.scale[1] * reach + (1.0 + projector.shift[1].abs()) * w),
        margin * (reach + projector.far),
    ]
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
