//! Planes that separate faces.

use glam::DVec3;

use super::pieces::{Corner, Piece};
use crate::geometry::try_unit;
use crate::pipeline::space::projector::Projector;

/// A plane in view space. It's stored as a point and not as a distance from the eye, so that differences are taken
/// before products.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SplitPlane {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
}

impl SplitPlane {
    /// The plane of a face with these corners; `None` for one without area.
    pub(crate) fn of(corners: &[Corner]) -> Option<Self> {
        let &[a, b, c, ..] = corners else { return None };
        Some(Self { point: a.view, normal: try_unit((b.view - a.view).cross(c.view - a.view))? })
    }

    /// 0 for a point on it.
    pub(crate) fn distance(&self, p: DVec3, tolerance: f64) -> f64 {
        let distance = self.normal.dot(p - self.point);
        if distance.abs() <= tolerance { 0.0 } else { distance }
    }

    /// `true` if the eye is in front of the plane.
    pub(crate) fn faces_eye(&self, projector: &Projector) -> bool {
        if projector.projection.is_perspective() { self.normal.dot(self.point) <= 0.0 } else { self.normal.z >= 0.0 }
    }

    /// A pair: true if any corner is in front, and true if any is behind.
    pub(crate) fn sides(&self, piece: &Piece, tolerance: f64) -> (bool, bool) {
        let (mut most, mut least) = (0.0, 0.0);
        for corner in &piece.corners {
            let distance = self.normal.dot(corner.view - self.point);
            most = if distance > most { distance } else { most };
            least = if distance < least { distance } else { least };
        }
        (most > tolerance, least < -tolerance)
    }

    /// The disadvantage of dividing a set by this plane: pieces that it splits, and sides that are uneven. `None` if it
    /// leaves the whole set on one side, which would go on for ever.
    pub(crate) fn cost(&self, set: &[Piece], tolerance: f64) -> Option<usize> {
        let (mut before, mut behind, mut split) = (0_usize, 0_usize, 0_usize);
        for piece in set {
            let (is_before, is_behind) = self.sides(piece, tolerance);
            before += usize::from(is_before);
            behind += usize::from(is_behind);
            split += usize::from(is_before && is_behind);
        }
        (before < set.len() && behind < set.len()).then(|| 8 * split + before.abs_diff(behind))
    }
}
