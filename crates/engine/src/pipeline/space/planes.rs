//! The six planes of the view volume. Each is a linear function of the clip point, positive inside `[2]`.

use super::point::ClipPoint;
use super::projector::Projector;

/// The planes of the volume, in the order of the distances: left, right, bottom, top, near, far.
pub(crate) const PLANES: usize = 6;

/// A set of planes: bit `i` is plane `i` of left, right, bottom, top, near, far.
pub type PlaneSet = u8;

/// All six planes.
pub(crate) const ALL_PLANES: PlaneSet = 0b11_1111;

/// The near plane.
pub const NEAR: PlaneSet = 1 << 4;

/// The bit of an outcode for "not a number": such a point is drawn nowhere.
pub(crate) const NOT_A_NUMBER: PlaneSet = 0b100_0000;

/// Near and far first, so that w is positive for all planes that follow.
pub(crate) const ORDER: [usize; PLANES] = [4, 5, 0, 1, 2, 3];

/// The six homogeneous distances, positive inside: w + x, w − x, w + y, w − y, and, up to a positive factor, w + z and
/// w − z.
///
/// w + z = 2B(d − F)/(B − F) and w − z = 2F(B − d)/(B − F) with the distance d from the eye, so d − F and B − d decide,
/// without the cancellation of clip z.
#[inline(always)]
pub(crate) fn distances(projector: &Projector, p: ClipPoint) -> [f64; PLANES] {
    [p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.distance - projector.near, projector.far - p.distance]
}

/// Bit `i` is set if the point is outside plane `i`; [`NOT_A_NUMBER`] if a coordinate isn't a number, or is too large
/// to be cut.
#[inline(always)]
pub(crate) fn outcode(projector: &Projector, p: ClipPoint) -> PlaneSet {
    let size = p.x.abs() + p.y.abs() + p.distance.abs();
    let mut code = 0;
    for (i, distance) in distances(projector, p).into_iter().enumerate() {
        code |= PlaneSet::from(distance < 0.0) << i;
    }
    // False if it isn't a number.
    if size <= f64::MAX / 4.0 { code } else { NOT_A_NUMBER }
}
