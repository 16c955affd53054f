//! Cuts a polygon, or a segment, by a plane: where the corners of its two parts come from.
//!
//! A new corner lies at the mean of the two ends of an edge, weighted by their distances from the plane, `P = (d₁ P₂ +
//! d₂ P₁) / (d₁ + d₂)` as `[2]` has it, which is accurate however far apart the ends lie. It is always reckoned from
//! the end inside to the end outside, whichever comes first in the polygon, so two polygons that share an edge get the
//! same corner to the last bit.

/// A corner of a part of a polygon: where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// The corner of the polygon with this index.
    Corner(usize),
    /// A new one, at the point where an edge crosses the plane.
    Edge(Edge),
}

/// An edge that crosses the plane, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    /// The corner at which the edge begins in the order of the polygon: one of the next two.
    pub(crate) first: usize,
    /// The corner inside.
    pub(crate) inside: usize,
    /// The corner outside.
    pub(crate) outside: usize,
    /// The shares of the corner inside and of the one outside. They add up to 1.
    pub(crate) shares: [f64; 2],
}

impl Edge {
    /// A linear attribute of the new corner, from those of the ends.
    #[inline(always)]
    pub(crate) fn mean(&self, inside: f64, outside: f64) -> f64 {
        self.shares[0] * inside + self.shares[1] * outside
    }
}

/// Returns the corners of the part inside a plane, and of the part outside, in the order of the polygon.
///
/// `corners` is their number, two for a segment. `distance` gives that of each corner from the plane, positive inside.
/// A corner in the plane belongs to both parts, and is its own cut. A part that only touches the plane may have too few
/// corners to be anything.
#[inline(always)]
pub(crate) fn cut(
    corners: usize,
    distance: impl Fn(usize) -> f64,
    mut inside: impl FnMut(Origin),
    mut outside: impl FnMut(Origin),
) {
    // A segment has one edge, a polygon as many as corners.
    let edges = if corners == 2 { 1 } else { corners };
    for first in 0..corners {
        let here = distance(first);
        if here >= 0.0 {
            inside(Origin::Corner(first));
        }
        if here <= 0.0 {
            outside(Origin::Corner(first));
        }
        if first >= edges {
            break;
        }
        let next = (first + 1) % corners;
        let there = distance(next);
        // The sign of the product doesn't tell: it's 0 if both are tiny.
        let (inner, outer, d1, d2) = if here > 0.0 && there < 0.0 {
            (first, next, here, -there)
        } else if here < 0.0 && there > 0.0 {
            (next, first, there, -here)
        } else {
            continue;
        };
        let shares = [d2 / (d1 + d2), d1 / (d1 + d2)];
        let edge = Origin::Edge(Edge { first, inside: inner, outside: outer, shares });
        inside(edge);
        outside(edge);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(distances: &[f64]) -> [Vec<Origin>; 2] {
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        cut(distances.len(), |i| distances[i], |o| inside.push(o), |o| outside.push(o));
        [inside, outside]
    }

    #[test]
    fn a_polygon_falls_into_two_and_new_corners_lie_where_the_distance_is_zero() {
        let edge = |first, inside, outside, shares| Origin::Edge(Edge { first, inside, outside, shares });
        let (there, back) = (edge(0, 0, 1, [0.75, 0.25]), edge(2, 0, 2, [0.5, 0.5]));
        let [inside, outside] = parts(&[1.0, -3.0, -1.0]);
        assert_eq!(inside, [Origin::Corner(0), there, back]);
        assert_eq!(outside, [there, Origin::Corner(1), Origin::Corner(2), back]);
    }

    #[test]
    fn a_corner_in_the_plane_belongs_to_both_parts() {
        let [inside, outside] = parts(&[0.0, 2.0, -2.0]);
        assert_eq!((inside.len(), outside.len()), (3, 3));
        assert_eq!((inside[0], outside[0]), (Origin::Corner(0), Origin::Corner(0)));
        let [inside, outside] = parts(&[0.0, 0.0, -2.0]);
        assert_eq!((inside.len(), outside.len()), (2, 3));
    }

    #[test]
    fn a_segment_has_one_edge() {
        let [inside, outside] = parts(&[-1.0, 1.0]);
        assert_eq!((inside.len(), outside.len()), (2, 2));
        assert!(matches!(inside[0], Origin::Edge(Edge { first: 0, inside: 1, outside: 0, .. })), "in its own order");
        assert_eq!(inside[1], Origin::Corner(1));
    }

    #[test]
    fn distances_too_small_to_be_multiplied_cut_all_the_same() {
        let [inside, _] = parts(&[1e-300, -1e-300, -1e-300]);
        assert_eq!(inside.len(), 3);
    }

    #[test]
    fn what_is_not_a_number_is_on_neither_side() {
        assert_eq!(parts(&[f64::NAN; 3]), [vec![], vec![]]);
    }
}
