//! **Clip**: cut the faces that cross a plane of the volume, before the divide.
//!
//! *Notes*: `[2]`, *Clipping em coordenadas homogêneas*: inside means −w ≤ x, y, z ≤ w. *Interseção de reta com plano*:
//! a cut lies at P = (d₁ P₂ + d₂ P₁)/(d₁ + d₂). `[3]` §1.1 step 5 and §1.7. It comes before the divide because a point
//! behind the eye has w < 0, and the divide would put it in front. *Textbook*: Sutherland and Hodgman, every polygon
//! against six planes. *Here*: the same for the few triangles that an outcode says cross a plane, and only against
//! those planes; leaving out the others changes no bit. A cut is computed from the end inside to the end outside and
//! set exactly onto its plane. So two triangles that share an edge get the same corner to the last bit, and no crack
//! opens. [`distances`] tells the side of a plane, [`cut`] the point where an edge crosses it.

use super::faces::{Crossing, Faces, to_u32};
use super::vertex::{divide, snap, viewport};
use super::vertices::Vertices;
use crate::pipeline::mesh::cut::{Edge, Origin, cut};
use crate::pipeline::mesh::resample::{OWN_WEIGHTS, VertexOrigin};
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{
    ALL_PLANES, ClipPoint, NOT_A_NUMBER, ORDER, PLANES, PlaneSet, Screen, distances, outcode,
};

/// Cuts the triangles that cross a plane and adds the rest of each, a convex polygon, as a fan of triangles. With
/// `all_planes`, also cuts them at the planes that they don't cross.
pub(crate) fn clip(faces: &mut Faces, vertices: &Vertices, screen: &Screen, want_source: bool, all_planes: bool) {
    let projector = vertices.projector;
    let Faces { image, triangles, source: sources, cuts, chunks, .. } = faces;
    let (mut clipper, mut fan) = (Clipper::default(), Vec::new());
    cuts.clear();
    for &Crossing { source, triangle, planes } in chunks.iter().flat_map(|chunk| &chunk.crossing) {
        let corners = triangle.map(|i| vertices.clip_point(i));
        let polygon = clipper.triangle(projector, corners, if all_planes { ALL_PLANES } else { planes });
        fan.clear();
        fan.extend(polygon.iter().map(|corner| match corner.origin(triangle) {
            VertexOrigin::Vertex(own) => own,
            new @ VertexOrigin::Between { .. } => {
                // A corner that clipping makes goes the rest of the way on its own: divide, viewport, snap.
                let index = to_u32(image.positions.len());
                image.positions.push(snap(screen, viewport(screen, divide(&projector.depths, corner.point))));
                if !image.inverse_w.is_empty() {
                    image.inverse_w.push(projector.depths.relative_inverse_w(corner.point.w));
                }
                cuts.push(new);
                index
            }
        }));
        let [first, rest @ ..] = &fan[..] else { continue };
        for side in rest.windows(2) {
            triangles.push([*first, side[0], side[1]]);
            sources.extend(want_source.then_some(source));
        }
    }
}

/// A corner of a polygon that is being clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClippedCorner {
    /// Its position.
    pub(crate) point: ClipPoint,
    /// Its share of each corner of the triangle (or of the two ends of the segment) that it came from. Every attribute
    /// of the corner is the sum of the triangle's attributes with these weights.
    pub(crate) weights: [f64; 3],
    /// The distance from each plane, positive inside, and 0 for planes that it was cut at.
    pub(crate) distances: [f64; PLANES],
}

impl ClippedCorner {
    /// The corners of a whole polygon: a triangle, or the two ends of a segment.
    pub(crate) fn whole<'a>(projector: &'a Projector, points: &'a [ClipPoint]) -> impl Iterator<Item = Self> + 'a {
        let own = points.iter().zip(OWN_WEIGHTS);
        own.map(|(&point, weights)| Self { point, weights, distances: distances(projector, point) })
    }

    /// The index in the triangle, if the corner is one of its own.
    pub(crate) fn original(&self) -> Option<usize> {
        OWN_WEIGHTS.iter().position(|own| *own == self.weights)
    }

    /// The origin of the corner, if it lies on the triangle with these vertices of a mesh.
    pub(crate) fn origin(&self, of: [u32; 3]) -> VertexOrigin {
        VertexOrigin::on(of, self.weights)
    }

    /// A corner of a part of `polygon`, which was cut at `plane`.
    #[inline(always)]
    pub(crate) fn of_part(polygon: &[Self], origin: Origin, plane: usize, projector: &Projector) -> Self {
        match origin {
            Origin::Corner(i) => polygon[i],
            Origin::Edge(edge) => Self::crossing(polygon, &edge, plane, projector),
        }
    }

    /// The point where an edge meets `plane`. A coordinate that the plane fixes is exact, the others are means.
    ///
    /// The rounding error of a mean is as large as that of the greater end. At the front plane w_r can be far smaller
    /// than that, so x_r can land outside −w_r … w_r although both distances say inside. The distances win, because
    /// triangles that share an edge compute them alike, and the point is moved to agree with them.
    fn crossing(polygon: &[Self], edge: &Edge, plane: usize, projector: &Projector) -> Self {
        let (inside, outside) = (&polygon[edge.inside], &polygon[edge.outside]);
        let (a, b) = (inside.point, outside.point);
        let mut distances: [f64; PLANES] =
            std::array::from_fn(|i| edge.mean(inside.distances[i], outside.distances[i]));
        distances[plane] = 0.0;
        let between = |value: f64, planes: [usize; 2], [least, most]: [f64; 2]| {
            let value = if distances[planes[0]] >= 0.0 { value.max(least) } else { value };
            if distances[planes[1]] >= 0.0 { value.min(most) } else { value }
        };
        // The planes are left, right, bottom, top, near, far.
        let distance = match plane {
            4 => projector.near,
            5 => projector.far,
            _ => between(edge.mean(a.distance, b.distance), [4, 5], [projector.near, projector.far]),
        };
        let w = if projector.projection.is_perspective() { distance } else { 1.0 };
        let x = match plane {
            0 => -w,
            1 => w,
            _ => between(edge.mean(a.x, b.x), [0, 1], [-w, w]),
        };
        let y = match plane {
            2 => -w,
            3 => w,
            _ => between(edge.mean(a.y, b.y), [2, 3], [-w, w]),
        };
        Self {
            point: ClipPoint { x, y, w, distance },
            weights: std::array::from_fn(|i| edge.mean(inside.weights[i], outside.weights[i])),
            distances,
        }
    }
}

/// Clips triangles and segments. Keeps its buffers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clipper {
    polygon: Vec<ClippedCorner>,
    next: Vec<ClippedCorner>,
}

impl Clipper {
    /// The part of a triangle inside `planes` (Sutherland and Hodgman, one plane after the other): a convex polygon in
    /// the order of the triangle's corners, or nothing.
    ///
    /// *Guarantees*: an edge that lies in a plane stays whole; a triangle that only touches a plane from outside is
    /// dropped; planes that the triangle doesn't cross may be left out of `planes` or put into it without changing a
    /// bit of the result; a corner on an edge has the same bits for every triangle that has the edge.
    pub(crate) fn triangle(
        &mut self,
        projector: &Projector,
        corners: [ClipPoint; 3],
        planes: PlaneSet,
    ) -> &[ClippedCorner] {
        self.watched(projector, &corners, planes, |_, _, _| {})
    }

    /// The part of a segment inside the volume: its two ends, each with `true` if it's a cut; `None` if no point
    /// is inside.
    pub(crate) fn segment(&mut self, projector: &Projector, ends: [ClipPoint; 2]) -> Option<[(ClipPoint, bool); 2]> {
        let codes = ends.map(|p| outcode(projector, p));
        let either = codes[0] | codes[1];
        if either == 0 {
            return Some(ends.map(|p| (p, false)));
        }
        if codes[0] & codes[1] != 0 || either & NOT_A_NUMBER != 0 {
            return None;
        }
        match self.watched(projector, &ends, either, |_, _, _| {}) {
            &[a, b] => Some([a, b].map(|end| (end.point, end.original().is_none()))),
            _ => None,
        }
    }

    /// The part of a triangle, or of a segment, inside `planes`. Calls `watch` for each corner that a plane leaves,
    /// with the plane, the polygon before it, and the origin of the corner.
    #[inline]
    pub(crate) fn watched(
        &mut self,
        projector: &Projector,
        points: &[ClipPoint],
        planes: PlaneSet,
        mut watch: impl FnMut(usize, &[ClippedCorner], Origin),
    ) -> &[ClippedCorner] {
        self.polygon.clear();
        self.polygon.extend(ClippedCorner::whole(projector, points));
        for plane in ORDER.into_iter().filter(|plane| planes >> plane & 1 == 1) {
            self.next.clear();
            let polygon = &self.polygon;
            let keep = |origin| {
                watch(plane, polygon, origin);
                self.next.push(ClippedCorner::of_part(polygon, origin, plane, projector));
            };
            cut(polygon.len(), |i| polygon[i].distances[plane], keep, |_| {});
            std::mem::swap(&mut self.polygon, &mut self.next);
            if self.polygon.len() < points.len() {
                self.polygon.clear();
                break;
            }
        }
        &self.polygon
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::super::vertex::clip_from_view;
    use super::*;
    use crate::camera::{Camera, Parameters, Projection, ViewWindow};
    use crate::pipeline::space::ViewPoint;
    use glam::DVec3;
    use proptest::prelude::*;

    /// At the origin, looking along −z. Window ±1 on F = 1, B = 9: the planes are |x| = d, |y| = d.
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
        let corners = points.map(|p| clip_from_view(&eye, ViewPoint(DVec3::from_array(p))));
        let mut clipper = Clipper::default();
        let out = clipper.triangle(&eye, corners, ALL_PLANES).to_vec();
        // Leaving out the planes that aren't crossed changes no bit.
        let crossed = corners.iter().fold(0, |codes, &c| codes | outcode(&eye, c));
        assert_eq!(clipper.triangle(&eye, corners, crossed), out);
        out.iter().map(|c| [c.point.x, c.point.y, -c.point.distance]).collect()
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

    /// Coordinates in and around the volume, on its planes, and far away.
    fn point() -> impl Strategy<Value = DVec3> {
        let across = || prop_oneof![4 => -12.0..12.0, 1 => Just(0.0), 1 => Just(4.0), 1 => -1e6..1e6];
        let along = prop_oneof![4 => -12.0..2.0, 1 => Just(-1.0), 1 => Just(-4.0), 1 => -1e6..1e3];
        (across(), across(), along).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    /// The bits of the corners that lie on the side 0–1, and of an attribute there.
    fn on_shared_side(eye: &Projector, points: &[DVec3; 4], triangle: [u32; 3]) -> Option<Vec<[u64; 7]>> {
        let mut clipper = Clipper::default();
        let polygon =
            clipper.triangle(eye, triangle.map(|i| clip_from_view(eye, ViewPoint(points[i as usize]))), ALL_PLANES);
        let third = triangle.iter().position(|i| *i > 1).unwrap();
        let mut bits: Vec<_> = polygon
            .iter()
            .filter(|corner| corner.weights[third] == 0.0)
            .map(|corner| {
                let ClipPoint { x, y, w, distance } = corner.point;
                let attribute = corner.origin(triangle).of(|i| points[i as usize]);
                [x, y, w, distance, attribute.x, attribute.y, attribute.z].map(|v| (v + 0.0).to_bits())
            })
            .collect();
        bits.sort_unstable();
        (!polygon.is_empty()).then_some(bits)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn triangles_that_share_a_side_get_the_same_bits_on_it(points in [point(), point(), point(), point()]) {
            let eye = eye();
            // Whichever corner comes first, and whichever way each of the two triangles runs.
            let orders = |third: u32| [[0, 1, third], [1, third, 0], [third, 0, 1], [1, 0, third], [0, third, 1], [third, 1, 0]];
            // A triangle that only touches the volume with a side may be dropped.
            let both: Vec<_> = orders(2).into_iter().chain(orders(3)).collect();
            let mut seen = both.into_iter().filter_map(|triangle| on_shared_side(&eye, &points, triangle));
            let first = seen.next();
            for bits in seen {
                prop_assert_eq!(Some(&bits), first.as_ref());
            }
        }
    }

    #[test]
    fn cuts_stay_accurate_when_the_ends_are_worlds_apart() {
        // From 1e6 units away to just before the near plane. The cut is one part in 1e6 from the near end.
        let polygon = clip([[0.25, 0.0, 0.0], [0.25, 0.0, -1e6], [0.25, 0.5, -1e6]]);
        for p in polygon.iter().filter(|p| p[2] == -1.0) {
            assert!((p[0] - 0.25).abs() < 1e-16, "{p:?}");
        }
        assert!(polygon.iter().any(|p| p[2] == -1.0) && polygon.iter().any(|p| p[2] == -9.0));
    }

    #[test]
    fn a_cut_lies_exactly_in_its_plane() {
        // Numbers whose means are never exact.
        for projection in [Projection::Perspective, Projection::Parallel] {
            let parameters = Parameters { near: 0.3, far: 7.7, projection, ..Parameters::default() };
            let eye = Projector::new(&Camera::new(&parameters).unwrap());
            let mut cut_at = 0;
            for k in 0..200 {
                let point = |k: f64| DVec3::new(9.1 * k.sin(), 8.3 * (1.7 * k).cos(), -3.7 + 7.3 * (2.3 * k).sin());
                let corners = [0.0, 0.9, 2.1].map(|step| clip_from_view(&eye, ViewPoint(point(f64::from(k) + step))));
                for corner in
                    Clipper::default().triangle(&eye, corners, ALL_PLANES).iter().filter(|c| c.original().is_none())
                {
                    let zero: Vec<usize> = (0..PLANES).filter(|&i| corner.distances[i] == 0.0).collect();
                    assert!(!zero.is_empty(), "{corner:?}");
                    let distances = distances(&eye, corner.point);
                    assert!(zero.iter().any(|&i| distances[i] == 0.0), "{corner:?}");
                    cut_at |= zero.iter().fold(0, |set, i| set | 1 << i);
                    let w = if eye.projection.is_perspective() { corner.point.distance } else { 1.0 };
                    assert!((corner.point.w - w).abs() < 1e-15 * w, "{corner:?}");
                }
            }
            assert_eq!(cut_at, ALL_PLANES);
        }
    }

    #[test]
    fn segments_are_cut_at_both_ends_and_say_so() {
        let eye = eye();
        let cut = |a: [f64; 3], b: [f64; 3]| {
            let ends = [a, b].map(|p| clip_from_view(&eye, ViewPoint(DVec3::from_array(p))));
            Clipper::default().segment(&eye, ends).map(|ends| ends.map(|(p, cut)| ([p.x, p.y, -p.distance], cut)))
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
        for large in [[1e308, 0.0, -2.0], [0.0, 1e308, -2.0], [0.0, 0.0, -1e308]] {
            assert_eq!(cut([0.0, 0.0, -2.0], large), None, "too large to be cut");
        }
        assert!(cut([0.0, 0.0, -2.0], [1e307, 0.0, -2.0]).is_some());
        let in_the_left_plane = ([-2.0, 0.0, -2.0], [-4.0, 0.0, -4.0]);
        let whole = [(in_the_left_plane.0, false), (in_the_left_plane.1, false)];
        assert_eq!(cut(in_the_left_plane.0, in_the_left_plane.1), Some(whole));
    }
}
