//! Clipping in homogeneous coordinates, before the divide `[2]`: what lies behind the eye never reaches it.
//!
//! Each plane of the volume is a linear function of the clip point, positive inside. A cut lies at the mean of the two ends of
//! an edge, weighted by their distances, `P = (d₁ P₂ + d₂ P₁) / (d₁ + d₂)` as `[2]` has it: symmetrical in the ends, so two
//! triangles that share an edge get the same cut to the last bit, and accurate however far apart the ends lie.

use super::transform::{ClipPoint, Projector};

/// The planes of the volume, in the order of the distances: left, right, bottom, top, near, far.
pub(super) const PLANES: usize = 6;

/// A set of planes: bit `i` stands for plane `i` of left, right, bottom, top, near, far.
pub type PlaneSet = u8;

/// All six planes.
pub(super) const ALL_PLANES: PlaneSet = 0b11_1111;

/// The near plane.
pub(super) const NEAR: PlaneSet = 1 << 4;

/// The bit of an outcode that stands for "no number": such a point is drawn nowhere.
pub(super) const NOT_A_NUMBER: PlaneSet = 0b100_0000;

/// Near and far first: then w is positive for all that follows.
const ORDER: [usize; PLANES] = [4, 5, 0, 1, 2, 3];

/// The six homogeneous distances, positive inside: w + x, w − x, w + y, w − y, and, up to a positive factor, w + z and w − z.
///
/// w + z = 2B(d − F)/(B − F) and w − z = 2F(B − d)/(B − F) with the distance d from the eye, so d − F and B − d decide, without
/// the cancellation of clip z.
#[inline(always)]
pub(super) fn distances(projector: &Projector, p: ClipPoint) -> [f64; PLANES] {
    [p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.depth - projector.near, projector.far - p.depth]
}

/// Bit `i` is set where the point is outside plane `i`; [`NOT_A_NUMBER`] where a coordinate is none or too large to be cut.
#[inline(always)]
pub(super) fn outcode(projector: &Projector, p: ClipPoint) -> PlaneSet {
    let size = p.x.abs() + p.y.abs() + p.depth.abs();
    let mut code = 0;
    for (i, distance) in distances(projector, p).into_iter().enumerate() {
        code |= PlaneSet::from(distance < 0.0) << i;
    }
    // False for what is no number.
    if size <= f64::MAX / 4.0 { code } else { NOT_A_NUMBER }
}

/// A corner of a polygon that is being clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    /// Where it is.
    pub(super) point: ClipPoint,
    /// Its share of each corner of the triangle that it came from: every attribute of the corner is the sum of the
    /// triangle's attributes with these weights.
    pub(super) weights: [f64; 3],
    distances: [f64; PLANES],
}

impl Corner {
    fn new(projector: &Projector, point: ClipPoint, weights: [f64; 3]) -> Self {
        Self { point, weights, distances: distances(projector, point) }
    }

    /// The index in the triangle, where the corner is one of its own.
    pub(super) fn original(&self) -> Option<usize> {
        OWN_WEIGHTS.iter().position(|own| *own == self.weights)
    }

    /// Where the edge from a corner inside `plane` to one outside meets it.
    fn cut(inside: &Self, outside: &Self, plane: usize, projector: &Projector) -> Self {
        let (d1, d2) = (inside.distances[plane], -outside.distances[plane]);
        let (w1, w2) = (d2 / (d1 + d2), d1 / (d1 + d2));
        let mean = |a: f64, b: f64| w1 * a + w2 * b;
        let (a, b) = (inside.point, outside.point);
        let depth = match plane {
            4 => projector.near,
            5 => projector.far,
            _ => mean(a.depth, b.depth),
        };
        let w = if projector.perspective { depth } else { 1.0 };
        let x = match plane {
            0 => -w,
            1 => w,
            _ => mean(a.x, b.x),
        };
        let y = match plane {
            2 => -w,
            3 => w,
            _ => mean(a.y, b.y),
        };
        let mut distances: [f64; PLANES] = std::array::from_fn(|i| mean(inside.distances[i], outside.distances[i]));
        distances[plane] = 0.0;
        Self {
            point: ClipPoint { x, y, w, depth },
            weights: std::array::from_fn(|i| mean(inside.weights[i], outside.weights[i])),
            distances,
        }
    }
}

/// The weights of the three corners of a triangle that has not been cut.
const OWN_WEIGHTS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Clips triangles; keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(super) struct Clipper {
    polygon: Vec<Corner>,
    next: Vec<Corner>,
}

impl Clipper {
    /// The part of a triangle inside `planes` (Sutherland and Hodgman, one plane after the other): a convex polygon in the
    /// order of the triangle's corners, or nothing.
    ///
    /// *Guarantees*: an edge that lies in a plane stays whole; what only touches a plane from outside is dropped; planes that
    /// the triangle does not cross may be left out of `planes` or put into it without changing a bit of the result.
    pub(super) fn triangle(&mut self, projector: &Projector, corners: [ClipPoint; 3], planes: PlaneSet) -> &[Corner] {
        self.polygon.clear();
        self.polygon.extend((0..3).map(|i| Corner::new(projector, corners[i], OWN_WEIGHTS[i])));
        for plane in ORDER.into_iter().filter(|plane| planes >> plane & 1 == 1) {
            self.next.clear();
            for (i, current) in self.polygon.iter().enumerate() {
                let following = &self.polygon[(i + 1) % self.polygon.len()];
                let (d1, d2) = (current.distances[plane], following.distances[plane]);
                if d1 >= 0.0 {
                    self.next.push(*current);
                }
                // A corner in the plane is its own cut.
                if d1 > 0.0 && d2 < 0.0 {
                    self.next.push(Corner::cut(current, following, plane, projector));
                } else if d1 < 0.0 && d2 > 0.0 {
                    self.next.push(Corner::cut(following, current, plane, projector));
                }
            }
            std::mem::swap(&mut self.polygon, &mut self.next);
            if self.polygon.len() < 3 {
                self.polygon.clear();
                break;
            }
        }
        &self.polygon
    }
}

/// The part of a segment inside the volume: its two ends, each with `true` where it is a cut; nothing where no point is inside.
pub(super) fn segment(projector: &Projector, ends: [ClipPoint; 2]) -> Option<[(ClipPoint, bool); 2]> {
    let codes = ends.map(|p| outcode(projector, p));
    let either = codes[0] | codes[1];
    if either == 0 {
        return Some(ends.map(|p| (p, false)));
    }
    if codes[0] & codes[1] != 0 || either & NOT_A_NUMBER != 0 {
        return None;
    }
    let mut a = Corner::new(projector, ends[0], OWN_WEIGHTS[0]);
    let mut b = Corner::new(projector, ends[1], OWN_WEIGHTS[1]);
    for plane in ORDER.into_iter().filter(|plane| either >> plane & 1 == 1) {
        let (d1, d2) = (a.distances[plane], b.distances[plane]);
        if d1.min(d2) < 0.0 && d1.max(d2) <= 0.0 {
            return None;
        }
        if d2 < 0.0 {
            b = Corner::cut(&a, &b, plane, projector);
        } else if d1 < 0.0 {
            a = Corner::cut(&b, &a, plane, projector);
        }
    }
    Some([(a.point, a.original().is_none()), (b.point, b.original().is_none())])
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::{Camera, Parameters, ViewWindow};
    use glam::DVec3;

    /// At the origin, looking along −z; window ±1 on F = 1, B = 9: the planes are |x| = d, |y| = d.
    fn eye() -> Projector {
        Projector::new(
            &Camera::new(&Parameters {
                position: DVec3::ZERO,
                focal_point: DVec3::NEG_Z,
                near: 1.0,
                far: 9.0,
                window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
                ..Parameters::default()
            })
            .unwrap(),
        )
    }

    fn clip(points: [[f64; 3]; 3]) -> Vec<[f64; 3]> {
        let eye = eye();
        let corners = points.map(|p| eye.clip(DVec3::from_array(p)));
        let mut clipper = Clipper::default();
        let out = clipper.triangle(&eye, corners, ALL_PLANES).to_vec();
        // Leaving out the planes that are not crossed changes no bit.
        let crossed = corners.iter().fold(0, |codes, &c| codes | outcode(&eye, c));
        assert_eq!(clipper.triangle(&eye, corners, crossed), out);
        out.iter().map(|c| [c.point.x, c.point.y, -c.point.depth]).collect()
    }

    #[test]
    fn a_corner_behind_the_eye_is_cut_off_at_the_near_plane() {
        // Independent: the edges meet z = −1 at y = 0 and x = ∓½ (half way from z = −2 to z = 0).
        let polygon = clip([[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.0, 0.0, 0.0]]);
        assert_eq!(polygon, [[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.5, 0.0, -1.0], [-0.5, 0.0, -1.0]]);
        // The same with the corner behind the eye, two thirds of the way: x = ∓2/3.
        let polygon = clip([[-1.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.0, 0.0, 1.0]]);
        assert!((polygon[2][0] - 2.0 / 3.0).abs() < 1e-15 && polygon[2][2] == -1.0, "{polygon:?}");
    }

    #[test]
    fn a_triangle_around_the_whole_window_becomes_the_window() {
        let polygon = clip([[-100.0, -50.0, -4.0], [100.0, -50.0, -4.0], [0.0, 100.0, -4.0]]);
        let mut corners: Vec<_> = polygon.iter().map(|p| p.map(|c| c.round())).collect();
        corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(corners, [[-4.0, -4.0, -4.0], [-4.0, 4.0, -4.0], [4.0, -4.0, -4.0], [4.0, 4.0, -4.0]]);
        for p in &polygon {
            assert!((p[0].abs() - 4.0).abs() < 1e-13 && (p[1].abs() - 4.0).abs() < 1e-13 && p[2] == -4.0);
        }
    }

    #[test]
    fn what_lies_in_a_plane_stays_and_what_only_touches_it_goes() {
        let on_the_near_plane = [[-0.5, 0.0, -1.0], [0.5, 0.0, -1.0], [0.0, 0.5, -1.0]];
        assert_eq!(clip(on_the_near_plane), on_the_near_plane);
        let an_edge_inside_the_left_plane = [[-2.0, 0.0, -2.0], [-4.0, 0.0, -4.0], [0.0, 0.0, -3.0]];
        assert_eq!(clip(an_edge_inside_the_left_plane), an_edge_inside_the_left_plane);
        assert!(clip([[-2.0, 0.0, -2.0], [-4.0, 0.0, -4.0], [-9.0, 0.0, -3.0]]).is_empty());
        assert!(clip([[0.0, 0.0, -1.0], [0.5, 0.0, 0.0], [-0.5, 0.0, 0.0]]).is_empty());
    }

    #[test]
    fn neighbours_get_the_same_cut_to_the_last_bit() {
        let eye = eye();
        let shared = [[0.1, 0.2, -3.0], [7.0, 5.0, -1.3]].map(|p| eye.clip(DVec3::from_array(p)));
        let mut clipper = Clipper::default();
        let mut cuts = |third: [f64; 3], flip: bool| {
            let third = eye.clip(DVec3::from_array(third));
            let corners = if flip { [shared[1], third, shared[0]] } else { [third, shared[0], shared[1]] };
            let polygon = clipper.triangle(&eye, corners, ALL_PLANES);
            let on_edge = |c: &&Corner| c.weights[if flip { 1 } else { 0 }] == 0.0;
            let mut points: Vec<_> = polygon.iter().filter(on_edge).map(|c| c.point).collect();
            points.sort_by(|a, b| a.x.total_cmp(&b.x));
            points
        };
        let (above, below) = (cuts([0.0, 3.0, -4.0], false), cuts([0.3, -3.1, -2.0], true));
        assert_eq!(above.len(), 2);
        assert_eq!(above, below);
    }

    #[test]
    fn cuts_stay_accurate_when_the_ends_are_worlds_apart() {
        // From 1e6 units away to just before the near plane: the cut is one part in 1e6 from the near end.
        let polygon = clip([[0.25, 0.0, 0.0], [0.25, 0.0, -1e6], [0.25, 0.5, -1e6]]);
        for p in polygon.iter().filter(|p| p[2] == -1.0) {
            assert!((p[0] - 0.25).abs() < 1e-16, "{p:?}");
        }
        assert!(polygon.iter().any(|p| p[2] == -1.0) && polygon.iter().any(|p| p[2] == -9.0));
    }

    #[test]
    fn segments_are_cut_at_both_ends_and_say_so() {
        let eye = eye();
        let cut = |a: [f64; 3], b: [f64; 3]| {
            let ends = [a, b].map(|p| eye.clip(DVec3::from_array(p)));
            segment(&eye, ends).map(|ends| ends.map(|(p, cut)| ([p.x, p.y, -p.depth], cut)))
        };
        let through = cut([-8.0, 0.0, -4.0], [8.0, 0.0, -4.0]).unwrap();
        assert_eq!(through, [([-4.0, 0.0, -4.0], true), ([4.0, 0.0, -4.0], true)]);
        let inside = cut([0.0, 0.0, -2.0], [0.0, 0.0, -18.0]).unwrap();
        assert_eq!(inside, [([0.0, 0.0, -2.0], false), ([0.0, 0.0, -9.0], true)]);
        assert_eq!(cut([-8.0, 0.0, -4.0], [-5.0, 1.0, -4.0]), None);
        // Across the corner of the window: either end alone is outside one plane, no point is inside both.
        assert_eq!(cut([-9.0, 0.0, -4.0], [0.0, 8.5, -4.0]), None);
        assert_eq!(cut([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]), None, "touches the near plane from outside");
        assert_eq!(cut([0.0, f64::NAN, -2.0], [0.0, 0.0, -3.0]), None);
    }
}
