//! The range of distances resolved by the depths of a picture: F … B, or, if everything in view would get the same
//! depth then, the distances in view.

use crate::camera::Projection;
use crate::drawing::order::same_depth;
use crate::drawing::single;

/// Threshold of resolution: depths that differ by less than the tolerance of the display list are the same. If that
/// is more than this share of the depths in view, the depths are spread over those alone.
const ENOUGH: f64 = 0.01;

/// Relative thickness below which a scene isn't resolved further. Anything thinner would be rounding of the numbers
/// from which it is computed.
const THINNEST: f64 = 1e-13;

/// The unit of depth in perspective is no smaller than this share of the farthest distance in view: small differences
/// in the scale of the depths count as the same, whatever is nearer.
const UNIT: f64 = 0.01;

/// Fits in single precision with all that is made of it.
const GREATEST: f64 = 1e15;

/// From a distance to the depth of the display list, and back. Depths are affine in the picture, and greater if nearer.
///
/// The depth is (far − d)/(far − near) in parallel projection, and the same times unit/d in perspective. With F, B and
/// the unit F this is 1 at F and 0 at B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthScale {
    projection: Projection,
    /// The nearest distance from the plane of the eye that is resolved, in scene units.
    pub near: f64,
    /// The farthest. Points beyond have the depth 0.
    pub far: f64,
    unit: f64,
}

/// The distances from the plane of the eye between which anything is visible, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InView {
    /// The distance of the nearest point.
    pub nearest: f64,
    /// The distance of the farthest point. Less than `nearest` if nothing is in view.
    pub farthest: f64,
    /// The size of the numbers from which they are computed.
    pub magnitude: f64,
}

impl InView {
    /// An empty view.
    pub const NOTHING: Self = Self { nearest: f64::INFINITY, farthest: f64::NEG_INFINITY, magnitude: 0.0 };

    /// The range of depths from `nearest` to `farthest`.
    pub const fn between(nearest: f64, farthest: f64) -> Self {
        // In parallel projection depths may be negative, and then the nearest is the larger number.
        Self { nearest, farthest, magnitude: nearest.abs().max(farthest.abs()) }
    }

    /// The range that holds both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            nearest: self.nearest.min(other.nearest),
            farthest: self.farthest.max(other.farthest),
            magnitude: self.magnitude.max(other.magnitude),
        }
    }

    /// The part of it between F and B.
    #[must_use]
    pub fn clipped(self, near: f64, far: f64) -> Self {
        Self { nearest: self.nearest.max(near), farthest: self.farthest.min(far), ..self }
    }
}

impl DepthScale {
    /// 1 at F and 0 at B.
    pub const fn of_volume(projection: Projection, near: f64, far: f64) -> Self {
        Self { projection, near, far, unit: near }
    }

    /// This scale if it resolves the depths in view, else one that does.
    #[must_use]
    pub fn resolving(self, in_view: InView) -> Self {
        let InView { nearest, farthest, magnitude } = in_view;
        // No more than the distance itself, because nothing is known beyond that.
        let thinnest = (THINNEST * magnitude).min(farthest.abs());
        let depth = farthest - nearest;
        if !(depth >= 0.0 && depth.is_finite() && thinnest.is_finite()) {
            return self;
        }
        let same = self.same(nearest).max(self.same(farthest));
        // Faces in one plane parallel to the view plane don't hide each other.
        if (same <= ENOUGH * depth || depth <= thinnest) && self.far - self.near >= thinnest {
            return self;
        }
        let depth = depth.max(thinnest);
        let aside = 0.5 * (depth - (farthest - nearest));
        let (near, far) = (nearest - aside, farthest + aside);
        if self.projection.is_perspective() {
            // The eye stays before it.
            let near = near.max(0.5 * nearest);
            Self { near, far, unit: near.max(UNIT * far), ..self }
        } else {
            Self { near, far, ..self }
        }
    }

    /// The depth of a distance from the plane of the eye, without a difference of nearly equal numbers.
    #[inline(always)]
    pub fn depth(&self, distance: f64) -> f64 {
        let share = (self.far - distance) / (self.far - self.near);
        if self.projection.is_perspective() { share * (self.unit / distance) } else { share }
    }

    /// [`depth`](Self::depth), faster, from a known 1/w: nearly as accurate.
    #[inline(always)]
    pub(crate) fn depth_by(&self, distance: f64, inverse_w: f64) -> f64 {
        let share = (self.far - distance) / (self.far - self.near);
        if self.projection.is_perspective() { share * (self.unit * inverse_w) } else { share }
    }

    /// unit/w rather than 1/w, so that it fits in single precision in worlds of any size.
    #[inline(always)]
    pub(crate) fn relative_inverse_w(&self, w: f64) -> f32 {
        single((self.unit * (1.0 / w)).min(GREATEST))
    }

    /// The depth of the nearest.
    pub fn greatest(&self) -> f64 {
        if self.projection.is_perspective() { (self.unit / self.near).min(GREATEST) } else { 1.0 }
    }

    /// The distance that has a depth.
    pub fn distance(&self, depth: f64) -> f64 {
        let across = self.far - self.near;
        if self.projection.is_perspective() {
            self.far / (1.0 + depth * across / self.unit)
        } else {
            self.far - depth * across
        }
    }

    /// Converts a depth of this scale to another scale.
    pub fn in_scale(&self, other: &Self, depth: f64) -> f64 {
        if self == other { depth } else { other.depth(self.distance(depth)) }
    }

    /// The greatest difference of a distance from this one that still counts as the same, in scene units.
    pub fn same(&self, distance: f64) -> f64 {
        let across = self.far - self.near;
        let by_depth = if self.projection.is_perspective() {
            distance * distance * across / (self.far * self.unit)
        } else {
            across
        };
        f64::from(same_depth(single(self.depth(distance)))) * by_depth
    }
}

/// A scene that is thin along z_n, as the canonical volume shows it. The distance d is shown at behind + slope ·
/// (farthest − d)/w.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheet {
    pub(crate) farthest: f64,
    pub(crate) slope: f64,
    pub(crate) behind: f64,
}

impl Sheet {
    /// The least thickness at which a scene is shown, in units of NDC.
    const THICKNESS: f64 = 0.01;

    /// `None` if a scene is thicker, or has no thickness in the world either. `volume`: 1 at F, 0 at B.
    pub(crate) fn of(volume: &DepthScale, in_view: InView) -> Option<Self> {
        let InView { nearest, farthest, .. } = in_view;
        let depth = farthest - nearest;
        let [front, behind] = [nearest, farthest].map(|d| 2.0 * volume.depth(d) - 1.0);
        if !(depth > THINNEST * farthest && front - behind < Self::THICKNESS) {
            return None;
        }
        let w = if volume.projection.is_perspective() { nearest } else { 1.0 };
        Some(Self { farthest, slope: Self::THICKNESS * w / depth, behind: behind.clamp(-1.0, 1.0 - Self::THICKNESS) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Projection; 2] = [Projection::Perspective, Projection::Parallel];

    #[test]
    fn a_scale_that_tells_apart_what_is_in_view_stays() {
        for projection in BOTH {
            let volume = DepthScale::of_volume(projection, 0.1, 100.0);
            assert_eq!((volume.depth(0.1), volume.depth(100.0), volume.greatest()), (1.0, 0.0, 1.0));
            assert_eq!(volume.resolving(InView::between(5.0, 11.0)), volume);
            assert_eq!(volume.resolving(InView::NOTHING), volume);
            assert_eq!(volume.resolving(InView::between(f64::NAN, 11.0)), volume);
            assert_eq!(volume.resolving(InView::between(5.0, f64::INFINITY)), volume);
        }
    }

    #[test]
    fn what_is_in_view_is_told_apart_whatever_f_and_b_are() {
        let volumes = [(1e-12, 100.0), (0.1, 1e12), (1e-9, 1e6), (4.0, 1e15), (1e-30, 1e30), (5.0, 11.0)];
        for (projection, (near, far)) in BOTH.into_iter().flat_map(|p| volumes.map(|v| (p, v))) {
            let scale = DepthScale::of_volume(projection, near, far).resolving(InView::between(5.0, 11.0));
            for distance in [5.0, 6.0, 8.5, 10.999] {
                assert!(scale.same(distance) < 0.01 * 6.0, "{scale:?}: {}", scale.same(distance));
                let back = scale.distance(scale.depth(distance));
                assert!((back - distance).abs() < 1e-13 * distance, "{scale:?}: {back}");
                assert!((0.0..=scale.greatest()).contains(&scale.depth(distance)));
            }
        }
    }

    #[test]
    fn a_thing_that_is_thin_and_far_away_is_told_apart_and_one_that_is_rounding_is_not() {
        for projection in BOTH {
            let volume = DepthScale::of_volume(projection, 1.0, 1e13);
            let thin = volume.resolving(InView::between(1e12, 1e12 + 20.0));
            assert!(thin.same(1e12) < 0.2 && thin.same(1e12 + 19.0) < 0.2, "{thin:?}");
            assert_eq!(volume.resolving(InView::between(1e12, 1e12 + 0.05)), volume);
        }
        let slab = DepthScale::of_volume(Projection::Perspective, 5.0, 5.0 + 1e-14)
            .resolving(InView::between(5.0, 5.0 + 1e-14));
        assert!(slab.far - slab.near > 4e-13, "{slab:?}");
    }

    #[test]
    fn what_is_next_to_the_eye_does_not_take_the_depths_of_all_else() {
        let scale = DepthScale::of_volume(Projection::Perspective, 1e-12, 1e3).resolving(InView::between(1e-12, 40.0));
        for distance in [1e-9, 1e-3, 0.5, 10.0, 39.0] {
            assert!(scale.same(distance) < 2e-3 * distance, "{distance}: {}", scale.same(distance));
        }
    }

    #[test]
    fn a_depth_goes_from_scale_to_scale() {
        for projection in BOTH {
            let volume = DepthScale::of_volume(projection, 1e-6, 1e6);
            let scale = volume.resolving(InView::between(5.0, 11.0));
            assert_ne!(scale, volume);
            for distance in [5.0, 8.0, 10.5] {
                let z = scale.in_scale(&volume, scale.depth(distance));
                assert!((z - volume.depth(distance)).abs() < 1e-9 * z, "{z}");
            }
            assert_eq!(volume.in_scale(&volume, 0.123), 0.123);
        }
    }
}
