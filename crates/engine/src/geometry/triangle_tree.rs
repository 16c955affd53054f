//! A tree of boxes over triangles, in `f64`, for rays: the reference for quicker methods.
//!
//! Nothing is rounded to single precision and no triangle is left out, so a ray meets the same one as if all triangles
//! were tried one by one.

use std::ops::Range;

use glam::DVec3;

use super::Aabb;

/// Triangles of a leaf.
const LEAF: usize = 4;

/// Triangles, ready for rays.
#[derive(Clone, Debug, Default)]
pub struct TriangleTree {
    triangles: Vec<[DVec3; 3]>,
    /// Indices of triangles, in the order of the leaves.
    order: Vec<u32>,
    /// Each before the two below it.
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    aabb: Aabb,
    /// The triangles below it: a range of `order`.
    range: Range<usize>,
    /// The place of its second child, the first being the next node; `None` means a leaf.
    second: Option<usize>,
}

/// A place where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The index of the triangle.
    pub triangle: usize,
    /// The place on the ray: origin + t · ray.
    pub t: f64,
}

impl TriangleTree {
    /// Puts triangles into a tree. Rays meet only finite ones.
    pub fn new(triangles: Vec<[DVec3; 3]>) -> Self {
        let indices = 0..u32::try_from(triangles.len()).unwrap_or(u32::MAX);
        let order: Vec<u32> = indices
            .filter(|&k| triangles.get(k as usize).is_some_and(|corners| corners.iter().all(|p| p.is_finite())))
            .collect();
        let mut tree = Self { triangles, order, nodes: Vec::new() };
        if !tree.order.is_empty() {
            tree.split(0..tree.order.len());
        }
        tree
    }

    /// The triangles, in the order in which they were given.
    pub fn triangles(&self) -> &[[DVec3; 3]] {
        &self.triangles
    }

    /// Adds the node of a range, and those below it. Halves of equal size. The depth is the logarithm of the number.
    fn split(&mut self, range: Range<usize>) {
        let corners = self.order[range.clone()].iter().flat_map(|&k| self.triangles[k as usize]);
        // All corners in the tree are finite, and there are some.
        let aabb = Aabb::around(corners).unwrap_or(Aabb { min: DVec3::ZERO, max: DVec3::ZERO });
        let place = self.nodes.len();
        self.nodes.push(Node { aabb, range: range.clone(), second: None });
        if range.len() <= LEAF {
            return;
        }
        let size = aabb.max - aabb.min;
        let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
        let middle = |k: &u32| self.triangles[*k as usize].iter().map(|p| p[axis] / 3.0).sum::<f64>();
        let half = range.len() / 2;
        self.order[range.clone()].select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
        self.split(range.start..range.start + half);
        self.nodes[place].second = Some(self.nodes.len());
        self.split(range.start + half..range.end);
    }

    /// The first `wanted` triangle that a ray meets within a range of t. `wanted` takes its index, and true if the ray
    /// comes from the side from which its corners run counter-clockwise.
    pub fn first_hit(
        &self,
        origin: DVec3,
        ray: DVec3,
        within: Range<f64>,
        wanted: impl Fn(usize, bool) -> bool,
    ) -> Option<TriangleHit> {
        self.hit(origin, ray, within, wanted, false)
    }

    /// True if a ray meets any `wanted` triangle within a range of t, as in [`first_hit`](Self::first_hit).
    pub fn is_hit(&self, origin: DVec3, ray: DVec3, within: Range<f64>, wanted: impl Fn(usize, bool) -> bool) -> bool {
        self.hit(origin, ray, within, wanted, true).is_some()
    }

    fn hit(
        &self,
        origin: DVec3,
        ray: DVec3,
        within: Range<f64>,
        wanted: impl Fn(usize, bool) -> bool,
        any: bool,
    ) -> Option<TriangleHit> {
        let mut best: Option<TriangleHit> = None;
        let inverse = ray.recip();
        let mut waiting = vec![0];
        while let Some(place) = waiting.pop() {
            let Some(node) = self.nodes.get(place) else { continue };
            let until = best.map_or(within.end, |hit| hit.t);
            if !touches(&node.aabb, origin, inverse, within.start..until) {
                continue;
            }
            if let Some(second) = node.second {
                waiting.extend([second, place + 1]);
                continue;
            }
            for &k in &self.order[node.range.clone()] {
                let triangle = k as usize;
                let Some((t, is_front)) = ray_meets_triangle(origin, ray, self.triangles[triangle]) else { continue };
                if within.contains(&t) && best.is_none_or(|old| t < old.t) && wanted(triangle, is_front) {
                    best = Some(TriangleHit { triangle, t });
                    if any {
                        return best;
                    }
                }
            }
        }
        best
    }
}

/// True if a ray may touch a box. The box is a little larger, for the roundings here and in [`ray_meets_triangle`].
fn touches(aabb: &Aabb, origin: DVec3, inverse: DVec3, within: Range<f64>) -> bool {
    let room = 1e-12 * (aabb.min.abs().max(aabb.max.abs()) + origin.abs());
    let (mut from, mut to) = (within.start, within.end);
    for axis in 0..3 {
        let [a, b] = [aabb.min[axis] - room[axis], aabb.max[axis] + room[axis]].map(|side| side - origin[axis]);
        if inverse[axis].is_infinite() {
            // The ray runs along these sides, within them or not.
            if a > 0.0 || b < 0.0 {
                return false;
            }
            continue;
        }
        let [a, b] = [a * inverse[axis], b * inverse[axis]];
        (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
    }
    let tolerance = 1e-12 * (from.abs() + if to.is_finite() { to.abs() } else { 0.0 });
    from <= to + tolerance
}

/// The place where a ray meets a triangle, and true if it comes from the side from which the corners run
/// counter-clockwise. Möller and Trumbore (1997).
pub fn ray_meets_triangle(origin: DVec3, ray: DVec3, [a, b, c]: [DVec3; 3]) -> Option<(f64, bool)> {
    let (ab, ac) = (b - a, c - a);
    let p = ray.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let s = (origin - a) / determinant;
    let u = s.dot(p);
    let q = s.cross(ab);
    let v = ray.dot(q);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| (ac.dot(q), determinant > 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of a fixed order that looks like none, −1 … 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 1_u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 33).unwrap_or(0)) / f64::from(1_u32 << 30) - 1.0
        }
    }

    #[test]
    fn a_ray_meets_what_it_meets_where_all_triangles_are_tried() {
        let mut next = numbers();
        let mut point = || DVec3::new(next(), next(), next());
        let mut triangles: Vec<[DVec3; 3]> = (0..500)
            .map(|_| {
                let middle = 5.0 * point();
                [middle + point(), middle + point(), middle + point()]
            })
            .collect();
        triangles.push([DVec3::NAN; 3]);
        let tree = TriangleTree::new(triangles.clone());
        let mut hits = 0;
        for k in 0..2000 {
            let (origin, mut ray) = (6.0 * point(), point());
            if k % 5 == 0 {
                ray = DVec3::X;
            }
            let within = 0.0..if k % 3 == 0 { f64::INFINITY } else { 4.0 };
            let all = triangles.iter().enumerate().filter_map(|(triangle, &corners)| {
                let (t, is_front) = ray_meets_triangle(origin, ray, corners)?;
                (within.contains(&t) && is_front && triangle != 7).then_some(TriangleHit { triangle, t })
            });
            let expected = all.min_by(|a, b| a.t.total_cmp(&b.t));
            let wanted = |triangle, is_front| is_front && triangle != 7;
            assert_eq!(tree.first_hit(origin, ray, within.clone(), wanted), expected);
            assert_eq!(tree.is_hit(origin, ray, within, wanted), expected.is_some());
            hits += usize::from(expected.is_some());
        }
        assert!(hits > 300, "{hits}");
        assert!(!TriangleTree::default().is_hit(DVec3::ZERO, DVec3::X, 0.0..1.0, |_, _| true));
    }
}
