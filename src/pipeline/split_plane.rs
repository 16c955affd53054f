//! Planes that separate faces: where faces lie, for one plane or for several at once.

use glam::DVec3;

use super::pieces::{Corners, Piece};
use super::projector::Projector;
use crate::geometry::try_unit;
use crate::simd::with_vectors;

/// A plane in view space. It stores a point of it, and not its distance from the eye, so that differences are taken
/// before products.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitPlane {
    pub(super) point: DVec3,
    pub(super) normal: DVec3,
}

impl SplitPlane {
    /// The plane of a face with these corners; `None` for one without area.
    pub(super) fn of(corners: &[DVec3]) -> Option<Self> {
        let &[a, b, c, ..] = corners else { return None };
        Some(Self { point: a, normal: try_unit((b - a).cross(c - a))? })
    }

    /// 0 for a point on it.
    #[inline(always)]
    pub(super) fn distance(&self, p: DVec3, tolerance: f64) -> f64 {
        let distance = self.normal.dot(p - self.point);
        if distance.abs() <= tolerance { 0.0 } else { distance }
    }

    /// True where the eye is in front of the plane.
    pub(super) fn faces_eye(&self, projector: &Projector) -> bool {
        if projector.perspective { self.normal.dot(self.point) <= 0.0 } else { self.normal.z >= 0.0 }
    }

    /// Whether any corner is in front, and whether any is behind.
    #[inline(always)]
    pub(super) fn sides(&self, corners: &[DVec3], tolerance: f64) -> (bool, bool) {
        corners.iter().fold((false, false), |(before, behind), &corner| {
            let distance = self.distance(corner, tolerance);
            (before || distance > 0.0, behind || distance < 0.0)
        })
    }
}

/// The best of some planes for a set of pieces: the one that splits least and divides most evenly, and of equals the
/// first; `None` where each leaves the whole set on one side, which would go on for ever.
pub(super) fn best(planes: &[SplitPlane], set: &[Piece], corners: &Corners, tolerance: f64) -> Option<SplitPlane> {
    let counts = match planes.len() {
        0 => return None,
        1..=4 => with_vectors!(_simd => count::<4>(planes, set, corners, tolerance)),
        5..=8 => with_vectors!(_simd => count::<8>(planes, set, corners, tolerance)),
        _ => with_vectors!(_simd => count::<MOST>(planes, set, corners, tolerance)),
    };
    let useful = |of: &Counts| of.before < set.len() && of.behind < set.len();
    let cost = |of: &Counts| 8 * of.split + (of.before - of.split).abs_diff(of.behind - of.split);
    let best = planes.iter().zip(counts).filter(|(_, of)| useful(of)).min_by_key(|(_, of)| cost(of));
    best.map(|(plane, _)| *plane)
}

/// The most planes that are compared.
pub(super) const MOST: usize = 12;

/// The pieces of a set that reach before a plane, behind it, and both.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    before: usize,
    behind: usize,
    split: usize,
}

/// Holds each piece against all planes while its corners are at hand, several planes in one vector. The numbers are
/// those of [`SplitPlane::sides`].
#[inline(always)]
fn count<const N: usize>(planes: &[SplitPlane], set: &[Piece], corners: &Corners, tolerance: f64) -> [Counts; MOST] {
    let mut normal = [[0.0; N]; 3];
    let mut point = [[0.0; N]; 3];
    for (k, plane) in planes.iter().take(N).enumerate() {
        for axis in 0..3 {
            (normal[axis][k], point[axis][k]) = (plane.normal[axis], plane.point[axis]);
        }
    }
    let (mut all_before, mut all_behind, mut all_split) = ([0_u64; N], [0_u64; N], [0_u64; N]);
    for piece in set {
        let (mut before, mut behind) = ([0_u64; N], [0_u64; N]);
        for corner in corners.of(piece) {
            for k in 0..N {
                let distance = normal[0][k] * (corner.x - point[0][k])
                    + normal[1][k] * (corner.y - point[1][k])
                    + normal[2][k] * (corner.z - point[2][k]);
                before[k] |= u64::from(distance > tolerance);
                behind[k] |= u64::from(distance < -tolerance);
            }
        }
        for k in 0..N {
            all_before[k] += before[k];
            all_behind[k] += behind[k];
            all_split[k] += before[k] & behind[k];
        }
    }
    let mut counts = [Counts::default(); MOST];
    let number = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
    for (k, of) in counts.iter_mut().take(N).enumerate() {
        *of = Counts { before: number(all_before[k]), behind: number(all_behind[k]), split: number(all_split[k]) };
    }
    counts
}
