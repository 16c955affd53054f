//! Polygons in space: their normal, and their triangles.

use glam::{DVec2, DVec3};

use crate::geometry::try_unit;
use crate::limits::MAX_EAR_STEPS;
use crate::scene::MeshNotice;

/// The doubled vector area of a polygon, planar or nearly so, by Newell's method about its first corner: along the
/// normal, twice the area long.
pub(crate) fn doubled_area(corners: impl IntoIterator<Item = DVec3>) -> DVec3 {
    let mut corners = corners.into_iter();
    let mut sum = DVec3::ZERO;
    let (Some(origin), Some(second)) = (corners.next(), corners.next()) else { return sum };
    let mut previous = second - origin;
    for p in corners {
        let next = p - origin;
        sum += previous.cross(next);
        previous = next;
    }
    sum
}

/// The unit normal of a polygon. `None` without area.
pub(crate) fn normal(corners: impl IntoIterator<Item = DVec3>) -> Option<DVec3> {
    try_unit(doubled_area(corners))
}

/// Cuts the polygons of a mesh file into triangles.
#[derive(Debug)]
pub(crate) struct Triangulator {
    /// Corners that may still be compared with ears.
    steps: usize,
    /// Number of concave polygons that were cut as if they were convex, because no steps were left.
    cut_as_convex: usize,
}

impl Default for Triangulator {
    fn default() -> Self {
        Self { steps: MAX_EAR_STEPS, cut_as_convex: 0 }
    }
}

impl Triangulator {
    /// The notice of the polygons that were cut wrong.
    pub(crate) fn notice(&self) -> Option<MeshNotice> {
        (self.cut_as_convex > 0).then_some(MeshNotice::CutAsConvex { count: self.cut_as_convex })
    }

    /// Cuts a simple polygon, planar or nearly so, into triangles with its own orientation, by cutting off ears.
    /// Appends three indices into `corners` for each. Always n − 2 triangles; if the polygon crosses itself some of
    /// them overlap.
    pub(crate) fn triangulate(&mut self, corners: &[DVec3], triangles: &mut Vec<[usize; 3]>) {
        let n = corners.len();
        if n == 3 {
            triangles.push([0, 1, 2]);
            return;
        }
        let flat = flatten(corners);
        let mut left: Vec<usize> = (0..n).collect();
        let convex = (0..n).all(|k| turn(flat[k], flat[(k + 1) % n], flat[(k + 2) % n]) >= 0.0);
        while !convex && left.len() > 3 {
            let m = left.len();
            let ear = (0..m).find(|&k| self.is_ear(&flat, &left, k)).unwrap_or(0);
            if self.steps == 0 {
                self.cut_as_convex += 1;
                break;
            }
            triangles.push([left[(ear + m - 1) % m], left[ear], left[(ear + 1) % m]]);
            left.remove(ear);
        }
        triangles.extend((2..left.len()).map(|k| [left[0], left[k - 1], left[k]]));
    }

    /// True if the corner sticks out and no other corner lies in the triangle with its neighbours. False without steps.
    fn is_ear(&mut self, flat: &[DVec2], left: &[usize], k: usize) -> bool {
        let m = left.len();
        let ids = [left[(k + m - 1) % m], left[k], left[(k + 1) % m]];
        let [a, b, c] = ids.map(|i| flat[i]);
        if self.steps == 0 {
            return false;
        }
        // Corners that are no ears take time too, though less.
        self.steps -= 1;
        if turn(a, b, c) <= 0.0 {
            return false;
        }
        let is_inside = |i: usize| {
            let p = flat[i];
            let inside = turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
            inside && p != a && p != b && p != c && !ids.contains(&i)
        };
        let first = left.iter().position(|&i| is_inside(i));
        self.steps = self.steps.saturating_sub(first.unwrap_or(m));
        first.is_none()
    }
}

/// The polygon seen against its normal: counter-clockwise in the plane. The coordinate along which the normal is
/// longest is left out.
fn flatten(corners: &[DVec3]) -> Vec<DVec2> {
    let n = doubled_area(corners.iter().copied());
    let a = n.abs();
    let project = |p: DVec3| {
        let q = p - corners[0];
        if a.z >= a.x && a.z >= a.y {
            DVec2::new(q.x * n.z.signum(), q.y)
        } else if a.y >= a.x {
            DVec2::new(q.z * n.y.signum(), q.x)
        } else {
            DVec2::new(q.y * n.x.signum(), q.z)
        }
    };
    corners.iter().map(|&p| project(p)).collect()
}

/// Positive for a turn to the left at b.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(corners: &[DVec3]) -> Vec<[usize; 3]> {
        let mut triangles = Vec::new();
        Triangulator::default().triangulate(corners, &mut triangles);
        triangles
    }

    /// The triangles turn as the polygon does, and their areas add up to its area, so they don't overlap.
    fn assert_exact_cover(corners: &[DVec3]) {
        let whole = doubled_area(corners.iter().copied());
        let mut sum = 0.0;
        let triangles = cut(corners);
        assert_eq!(triangles.len(), corners.len() - 2);
        for t in triangles {
            let part = doubled_area(t.map(|i| corners[i]));
            assert!(part.dot(whole) > 0.0, "{t:?} is turned round or empty");
            sum += part.length();
        }
        assert!((sum - whole.length()).abs() < 1e-12 * whole.length(), "{sum} {}", whole.length());
    }

    #[test]
    fn concave_polygons_are_covered_once_in_any_plane_from_any_first_corner() {
        let comb = [(0, 0), (6, 0), (6, 4), (5, 4), (5, 1), (4, 1), (4, 4), (3, 4), (3, 1), (2, 1), (2, 4), (0, 4)];
        let arrow = [(0, 0), (4, 0), (1, 1), (0, 4)];
        for outline in [&comb[..], &arrow[..]] {
            for axes in [[DVec3::X, DVec3::Y], [DVec3::Y, DVec3::Z], [DVec3::Z, DVec3::X], [DVec3::Y, DVec3::X]] {
                let axes = [axes[0] + axes[1] * 0.3, axes[1] - axes[0] * 0.1];
                for first in 0..outline.len() {
                    let mut corners: Vec<DVec3> =
                        outline.iter().map(|&(x, y)| axes[0] * f64::from(x) + axes[1] * f64::from(y)).collect();
                    corners.rotate_left(first);
                    assert_exact_cover(&corners);
                }
            }
        }
    }

    /// A ring that is open on one side: `count` corners on its outer and as many on its inner arc.
    fn ring(count: u32) -> Vec<DVec3> {
        let at = |k: u32, radius: f64| {
            let angle = 6.0 * f64::from(k) / f64::from(count - 1);
            DVec3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
        };
        (0..count).map(|k| at(k, 1.0)).chain((0..count).rev().map(|k| at(k, 0.8))).collect()
    }

    #[test]
    fn concave_polygons_of_thousands_of_corners_are_covered_once() {
        for count in [512, 513, 4000] {
            assert_exact_cover(&ring(count));
        }
    }

    #[test]
    fn polygons_beyond_the_budget_are_counted_and_have_as_many_triangles() {
        let mut triangulator = Triangulator { steps: 1000, ..Triangulator::default() };
        let mut triangles = Vec::new();
        triangulator.triangulate(&ring(100), &mut triangles);
        triangulator.triangulate(&ring(4), &mut triangles);
        assert_eq!((triangles.len(), triangulator.cut_as_convex), (198 + 6, 2));
        // Convex ones need no steps.
        triangulator.triangulate(&[DVec3::ZERO, DVec3::X, DVec3::ONE - DVec3::Z, DVec3::Y], &mut triangles);
        assert_eq!(triangulator.cut_as_convex, 2);
    }

    #[test]
    fn convex_polygons_are_fans_and_degenerate_ones_do_no_harm() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::ONE - DVec3::Z, DVec3::Y];
        assert_eq!(cut(&square), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(cut(&[DVec3::ONE; 5]).len(), 3);
        assert!(cut(&[DVec3::ONE; 2]).is_empty() && cut(&[]).is_empty());
        assert_eq!(normal([DVec3::ZERO, DVec3::X, DVec3::X * 2.0]), None);
        assert_eq!(normal(square), Some(DVec3::Z));
    }
}
