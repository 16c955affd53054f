//! Polygons in space: their normal, and their triangles.

use glam::{DVec2, DVec3};

use crate::geometry::try_unit;

/// A polygon with more corners is cut as if it were convex: the search for ears takes the square of their number.
const MOST_EARS: usize = 1024;

/// The doubled vector area of a polygon, planar or nearly so, by Newell's method about its first corner: along the
/// normal, twice the area long.
pub(super) fn doubled_area(corners: impl IntoIterator<Item = DVec3>) -> DVec3 {
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

/// The unit normal of a polygon; `None` without area.
pub(super) fn normal(corners: impl IntoIterator<Item = DVec3>) -> Option<DVec3> {
    try_unit(doubled_area(corners))
}

/// Cuts a simple polygon, planar or nearly so, into triangles with its own orientation, by cutting off ears; appends
/// three indices into `corners` for each. Always n − 2 triangles; where the polygon crosses itself some of them
/// overlap.
pub(super) fn triangulate(corners: &[DVec3], triangles: &mut Vec<[usize; 3]>) {
    let n = corners.len();
    if n == 3 {
        triangles.push([0, 1, 2]);
        return;
    }
    let flat = flatten(corners);
    let convex = (0..n).all(|k| turn(flat[k], flat[(k + 1) % n], flat[(k + 2) % n]) >= 0.0);
    if convex || n > MOST_EARS {
        triangles.extend((1..n.saturating_sub(1)).map(|k| [0, k, k + 1]));
        return;
    }
    let mut left: Vec<usize> = (0..n).collect();
    while left.len() > 3 {
        let m = left.len();
        let ear = (0..m).find(|&k| is_ear(&flat, &left, k)).unwrap_or(0);
        triangles.push([left[(ear + m - 1) % m], left[ear], left[(ear + 1) % m]]);
        left.remove(ear);
    }
    triangles.push([left[0], left[1], left[2]]);
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

/// True when the corner sticks out and no other corner lies in the triangle with its neighbours.
fn is_ear(flat: &[DVec2], left: &[usize], k: usize) -> bool {
    let m = left.len();
    let ids = [left[(k + m - 1) % m], left[k], left[(k + 1) % m]];
    let [a, b, c] = ids.map(|i| flat[i]);
    turn(a, b, c) > 0.0
        && left.iter().filter(|i| !ids.contains(i)).all(|&i| {
            let p = flat[i];
            let inside = turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
            !inside || p == a || p == b || p == c
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(corners: &[DVec3]) -> Vec<[usize; 3]> {
        let mut triangles = Vec::new();
        triangulate(corners, &mut triangles);
        triangles
    }

    /// The triangles turn as the polygon does, and their areas add up to its area: so they do not overlap.
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
