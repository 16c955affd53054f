//! Planes that separate faces: where faces lie, for one plane or for several at once.

use glam::DVec3;

use super::pieces::{Corners, Piece};
use super::projector::Projector;
use crate::geometry::try_unit;
use crate::simd::prelude::*;
use crate::simd::{Simd, f64x4, with_vectors};

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
        let (mut most, mut least) = (0.0, 0.0);
        for &corner in corners {
            let distance = self.normal.dot(corner - self.point);
            most = if distance > most { distance } else { most };
            least = if distance < least { distance } else { least };
        }
        (most > tolerance, least < -tolerance)
    }
}

/// The best of some planes for a set of pieces: the one that splits least and divides most evenly, and of equals the
/// first; `None` where each leaves the whole set on one side, which would go on for ever.
pub(super) fn best(planes: &[SplitPlane], set: &[Piece], corners: &Corners, tolerance: f64) -> Option<SplitPlane> {
    let counts = match planes.len() {
        0 => return None,
        1..=4 => with_vectors!(simd => count::<_, 1>(simd, planes, set, corners, tolerance)),
        5..=8 => with_vectors!(simd => count::<_, 2>(simd, planes, set, corners, tolerance)),
        _ => with_vectors!(simd => count::<_, 3>(simd, planes, set, corners, tolerance)),
    };
    let useful = |of: &Counts| of.before < set.len() && of.behind < set.len();
    let cost = |of: &Counts| 8 * of.split + (of.before - of.split).abs_diff(of.behind - of.split);
    let best = planes.iter().zip(counts).filter(|(_, of)| useful(of)).min_by_key(|(_, of)| cost(of));
    best.map(|(plane, _)| *plane)
}

/// The most planes that are compared.
const MOST: usize = 12;

/// The pieces of a set that reach before a plane, behind it, and both.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    before: usize,
    behind: usize,
    split: usize,
}

/// Holds each piece against four times `N` planes while its corners are at hand. The numbers are those of
/// [`SplitPlane::sides`].
#[inline(always)]
fn count<S: Simd, const N: usize>(
    simd: S,
    planes: &[SplitPlane],
    set: &[Piece],
    corners: &Corners,
    tolerance: f64,
) -> [Counts; MOST] {
    // A plane that is missing has no normal, and all is in it.
    let lanes = |of: fn(&SplitPlane) -> DVec3, axis: usize| -> [f64x4<S>; N] {
        std::array::from_fn(|group| {
            let lane = |l: usize| planes.get(4 * group + l).map_or(0.0, |plane| of(plane)[axis]);
            f64x4::from_slice(simd, &[lane(0), lane(1), lane(2), lane(3)])
        })
    };
    let normal = [0, 1, 2].map(|axis| lanes(|plane| plane.normal, axis));
    let point = [0, 1, 2].map(|axis| lanes(|plane| plane.point, axis));
    let (zero, one) = (f64x4::splat(simd, 0.0), f64x4::splat(simd, 1.0));
    let (before_from, behind_from) = (f64x4::splat(simd, tolerance), f64x4::splat(simd, -tolerance));
    let (mut all_before, mut all_behind, mut all_split) = ([zero; N], [zero; N], [zero; N]);
    for piece in set {
        let (mut most, mut least) = ([zero; N], [zero; N]);
        for corner in corners.of(piece) {
            let [x, y, z] = corner.to_array().map(|v| f64x4::splat(simd, v));
            for k in 0..N {
                let distance = normal[0][k] * (x - point[0][k])
                    + normal[1][k] * (y - point[1][k])
                    + normal[2][k] * (z - point[2][k]);
                most[k] = distance.simd_gt(most[k]).select(distance, most[k]);
                least[k] = distance.simd_lt(least[k]).select(distance, least[k]);
            }
        }
        for k in 0..N {
            let before = most[k].simd_gt(before_from).select(one, zero);
            let behind = least[k].simd_lt(behind_from).select(one, zero);
            all_before[k] += before;
            all_behind[k] += behind;
            all_split[k] += before * behind;
        }
    }
    let mut counts = [Counts::default(); MOST];
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sums of ones")]
    let number = |sums: &[f64x4<S>; N], k: usize| sums[k / 4][k % 4] as usize;
    for (k, of) in counts.iter_mut().take(4 * N).enumerate() {
        *of = Counts { before: number(&all_before, k), behind: number(&all_behind, k), split: number(&all_split, k) };
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline::pieces::Corner;

    #[test]
    fn planes_are_counted_together_as_one_by_one() {
        // Coordinates with few digits lie in planes, too.
        let mut state = 7_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 61).unwrap_or(0)) - 3.5
        };
        let mut corners = Corners::default();
        let corner = Corner { weights: [0.0; 3], original: true, side: 0 };
        let whole = Piece { first: 0, count: 0, layer: 0, triangle: 0, plane: u32::MAX };
        let mut polygon = |n: usize| -> Vec<(DVec3, Corner)> {
            (0..n).map(|_| (DVec3::new(number(), number(), number()), corner)).collect()
        };
        let mut set: Vec<Piece> = (0..300).map(|k| corners.add(&whole, &polygon(3 + k % 3))).collect();
        set.push(corners.add(&whole, &[(DVec3::splat(f64::NAN), corner); 3]));
        for tolerance in [0.0, 1e-10, 0.4] {
            for of in [1, 4, 5, 8, 9, 12] {
                let planes: Vec<SplitPlane> =
                    set.iter().filter_map(|piece| SplitPlane::of(corners.of(piece))).take(of).collect();
                let cost = |plane: &&SplitPlane| {
                    let sides = || set.iter().map(|piece| plane.sides(corners.of(piece), tolerance));
                    let only = |side| sides().filter(|of| *of == side).count();
                    let split = only((true, true));
                    8 * split + only((true, false)).abs_diff(only((false, true)))
                };
                let right = planes.iter().min_by_key(cost);
                let found = best(&planes, &set, &corners, tolerance);
                assert_eq!(found.map(|p| (p.point, p.normal)), right.map(|p| (p.point, p.normal)), "{of} {tolerance}");
            }
        }
    }
}
