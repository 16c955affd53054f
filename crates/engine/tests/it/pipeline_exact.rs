//! Clipped triangles against a clipper that works in whole numbers of any length, without rounding.

#![expect(clippy::unwrap_used, reason = "tests")]
#![expect(clippy::cast_precision_loss, reason = "the numbers are made so that they fit")]

use camera_lab_engine::appearance::Shading;
use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use camera_lab_engine::pipeline::canonical::clipped_scene;
use camera_lab_engine::scene::Mesh;
use glam::{DMat4, DVec3};
use num_bigint::{BigInt, Sign};
use proptest::prelude::*;

use crate::common::any_scene::reproducible;
use crate::common::scenes::{object, only};

/// Lengths are whole numbers of this.
const UNIT: f64 = 1.0 / 1024.0;

/// At the origin, looking along −z, in units.
#[derive(Clone, Copy, Debug)]
struct Eye {
    near: i64,
    far: i64,
    perspective: bool,
    /// The window is F or 1 to the right and to the top, and as far to the left and the bottom, or three times as far.
    oblique: bool,
}

impl Eye {
    fn camera(self) -> Camera {
        let near = self.near as f64 * UNIT;
        let right = if self.perspective { near } else { 1.0 };
        let left = if self.oblique { -3.0 * right } else { -right };
        Camera::new(&Parameters {
            position: DVec3::ZERO,
            focal_point: DVec3::NEG_Z,
            near,
            far: self.far as f64 * UNIT,
            projection: if self.perspective { Projection::Perspective } else { Projection::Parallel },
            window: Some(ViewWindow { left, right, bottom: left, top: right }),
            ..Parameters::default()
        })
        .unwrap()
    }

    /// 2x, 2y, 2w of clip space, 2d, and 2: all with the same denominator, which the last one tells.
    fn clip(self, p: [i64; 3]) -> Exact {
        let [x, y, d] = [p[0], p[1], -p[2]].map(BigInt::from);
        let w = if self.perspective { d.clone() } else { BigInt::from(1024) };
        // Symmetric: scale 1, shift 0; oblique: scale ½, shift (r + l)/(r − l) = −½.
        let across = |c: BigInt| if self.oblique { c + &w } else { c * 2 };
        Exact { x: across(x), y: across(y), w: &w * 2, d: d * 2, one: BigInt::from(2) }
    }
}

/// A point of clip space, every number over the same positive denominator `one`.
#[derive(Clone, Debug)]
struct Exact {
    x: BigInt,
    y: BigInt,
    w: BigInt,
    d: BigInt,
    one: BigInt,
}

impl Exact {
    fn distances(&self, eye: Eye) -> [BigInt; 6] {
        [
            &self.d - &self.one * eye.near,
            &self.one * eye.far - &self.d,
            &self.w + &self.x,
            &self.w - &self.x,
            &self.w + &self.y,
            &self.w - &self.y,
        ]
    }

    /// a · self + b · other, with a, b > 0.
    fn mean(&self, a: &BigInt, other: &Self, b: &BigInt) -> Self {
        Self {
            x: &self.x * a + &other.x * b,
            y: &self.y * a + &other.y * b,
            w: &self.w * a + &other.w * b,
            d: &self.d * a + &other.d * b,
            one: &self.one * a + &other.one * b,
        }
    }

    /// x_n, y_n, and twice the depth of the picture less one.
    fn displayed(&self, eye: Eye) -> DVec3 {
        let share = &self.one * eye.far - &self.d;
        let range = BigInt::from(eye.far - eye.near);
        let depth = if eye.perspective {
            ratio(&(share * eye.near), &(&self.d * range))
        } else {
            ratio(&share, &(&self.one * range))
        };
        DVec3::new(ratio(&self.x, &self.w), ratio(&self.y, &self.w), 2.0 * depth - 1.0)
    }
}

/// a/b for b > 0, right to the last digit or so.
fn ratio(a: &BigInt, b: &BigInt) -> f64 {
    assert!(b.sign() == Sign::Plus);
    let shift = i64::try_from(b.bits()).unwrap() - i64::try_from(a.bits()).unwrap() + 80;
    let quotient = if shift >= 0 { (a << shift) / b } else { a / (b << -shift) };
    i128::try_from(quotient).unwrap() as f64 * 2.0_f64.powi(-i32::try_from(shift).unwrap())
}

/// The part of a triangle in the closed volume: Sutherland and Hodgman without rounding. If a triangle only touches the
/// volume, the result has no area, or only two corners.
fn exact_polygon(eye: Eye, triangle: [[i64; 3]; 3]) -> Vec<DVec3> {
    let mut polygon = triangle.map(|p| eye.clip(p)).to_vec();
    for plane in 0..6 {
        let mut next = Vec::new();
        for (i, a) in polygon.iter().enumerate() {
            let b = &polygon[(i + 1) % polygon.len()];
            let (da, db) = (&a.distances(eye)[plane], &b.distances(eye)[plane]);
            if da.sign() != Sign::Minus {
                next.push(a.clone());
            }
            if da.sign() != Sign::NoSign && db.sign() != Sign::NoSign && da.sign() != db.sign() {
                next.push(a.mean(&BigInt::from(db.magnitude().clone()), b, &BigInt::from(da.magnitude().clone())));
            }
        }
        polygon = next;
    }
    polygon.iter().map(|p| p.displayed(eye)).collect()
}

/// The triangle after the pipeline.
fn polygon(eye: Eye, triangle: [[i64; 3]; 3]) -> Vec<[DVec3; 3]> {
    let positions = triangle.map(|p| DVec3::from_array(p.map(|c| c as f64 * UNIT))).to_vec();
    let mesh = Mesh { positions, triangles: vec![[0, 1, 2]], ..Mesh::default() };
    let clipped = clipped_scene(&only(object(mesh, DMat4::IDENTITY)), &eye.camera(), Shading::Flat);
    let meshes = clipped.objects.iter().map(|object| &object.mesh);
    meshes.flat_map(|mesh| mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize]))).collect()
}

fn fan(corners: &[DVec3]) -> Vec<[DVec3; 3]> {
    match corners {
        [] => Vec::new(),
        [a] => vec![[*a; 3]],
        [a, b] => vec![[*a, *b, *b]],
        [a, rest @ ..] => rest.windows(2).map(|pair| [*a, pair[0], pair[1]]).collect(),
    }
}

fn area(triangles: &[[DVec3; 3]]) -> f64 {
    triangles.iter().map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}

/// The distance of a point from the nearest of some triangles.
fn distance(p: DVec3, triangles: &[[DVec3; 3]]) -> f64 {
    triangles.iter().map(|t| distance_to_one(p, t)).fold(f64::INFINITY, f64::min)
}

fn distance_to_one(p: DVec3, &[a, b, c]: &[DVec3; 3]) -> f64 {
    let to_segment = |from: DVec3, to: DVec3| {
        let along = to - from;
        let t =
            if along == DVec3::ZERO { 0.0 } else { ((p - from).dot(along) / along.length_squared()).clamp(0.0, 1.0) };
        p.distance(from + along * t)
    };
    let sides = to_segment(a, b).min(to_segment(b, c)).min(to_segment(c, a));
    let n = (b - a).cross(c - a);
    let before = |from: DVec3, to: DVec3| n.dot((to - from).cross(p - from)) >= 0.0;
    let over = n != DVec3::ZERO && before(a, b) && before(b, c) && before(c, a);
    if over { (n.dot(p - a) / n.length()).abs().min(sides) } else { sides }
}

fn check(eye: Eye, triangle: [[i64; 3]; 3]) -> Result<(), TestCaseError> {
    let exact = exact_polygon(eye, triangle);
    let (exact, found) = (fan(&exact), polygon(eye, triangle));
    // As exact as the corners of the triangle are in double precision: a few units in the last place of the largest of
    // its coordinates, seen from the nearest point that is left.
    let size = triangle.iter().flatten().map(|c| (c.abs() as f64) * UNIT).fold(0.0, f64::max);
    let far = exact.iter().chain(&found).flatten().fold(-1.0_f64, |nearest, p| nearest.max(p.z));
    let (near_plane, far_plane) = (eye.near as f64 * UNIT, eye.far as f64 * UNIT);
    let nearest = if eye.perspective {
        let share = (far + 1.0) / 2.0;
        near_plane * far_plane / (near_plane + share * (far_plane - near_plane))
    } else {
        1.0
    };
    let bound = 64.0 * f64::EPSILON * (1.0 + size / nearest);
    if exact.is_empty() || found.is_empty() {
        let left = area(&exact) + area(&found);
        prop_assert!(left <= 8.0 * bound, "one is empty, the other one has {left} for {bound}: {exact:?} {found:?}");
        return Ok(());
    }
    for p in found.iter().flatten() {
        prop_assert!(p.abs().max_element() <= 1.0 + bound, "{p} is outside");
        prop_assert!(distance(*p, &exact) <= bound, "{p} is {} off for {bound}", distance(*p, &exact));
    }
    for p in exact.iter().flatten() {
        let missed = distance(*p, &found);
        prop_assert!(missed <= bound || area(&exact) <= 8.0 * bound, "{p} is missed by {missed} for {bound}");
    }
    Ok(())
}

/// A few digits anywhere between 1e-3 and 1e15.
fn any_length() -> impl Strategy<Value = i64> {
    prop_oneof![
        4 => -4096_i64..4096,
        2 => (-8_i64..8).prop_map(|n| n * 1024),
        1 => (-30000_i64..30000, 0_u32..44).prop_map(|(n, shift)| n << shift),
    ]
}

fn any_corner() -> impl Strategy<Value = [i64; 3]> {
    let anywhere = [any_length(), any_length(), any_length()];
    // On the planes of a symmetric window: x or y = ±d, before and behind the eye.
    let on_planes = (any_length(), prop_oneof![Just(1_i64), Just(-1), Just(0)], any_length(), any::<bool>());
    let on_planes =
        on_planes.prop_map(|(d, side, other, flip)| if flip { [side * d, other, -d] } else { [other, side * d, -d] });
    prop_oneof![2 => anywhere, 1 => on_planes]
}

fn any_triangle() -> impl Strategy<Value = [[i64; 3]; 3]> {
    let free = [any_corner(), any_corner(), any_corner()];
    // The third corner next to the line through the others.
    let sliver = (any_corner(), any_corner(), -2_i64..3, [-1_i64..2, -1_i64..2, -1_i64..2]).prop_map(|(a, b, k, e)| {
        let at = |i: usize| a[i] / 2 + k * (b[i] / 2 - a[i] / 2) + e[i];
        [a, b, [at(0), at(1), at(2)]]
    });
    prop_oneof![3 => free, 1 => sliver]
}

fn any_eye() -> impl Strategy<Value = Eye> {
    let far = prop_oneof![3 => 1_i64..64, 1 => Just(1_i64 << 20), 1 => Just(1_i64 << 49)];
    (prop_oneof![Just(1024_i64), Just(1), Just(3000)], far, any::<bool>(), any::<bool>())
        .prop_map(|(near, times, perspective, oblique)| Eye { near, far: near * (times + 1), perspective, oblique })
}

proptest! {
    #![proptest_config(reproducible(16))]

    #[test]
    fn clipped_triangles_are_those_of_exact_arithmetic(eye in any_eye(), triangle in any_triangle()) {
        check(eye, triangle)?;
    }
}

#[test]
fn the_exact_clipper_is_right_in_a_case_worked_out_by_hand() {
    let eye = Eye { near: 1024, far: 9 * 1024, perspective: true, oblique: false };
    // (−1, 0, −2), (1, 0, −2) and a corner behind the eye at (0, 0, 1): cut at z = −1, x = ∓⅔.
    let polygon = exact_polygon(eye, [[-1024, 0, -2048], [1024, 0, -2048], [0, 0, 1024]]);
    // Depth at d = 2: (9 − 2)/(2 · 8) = 7/16, shown at −1/8.
    let expected = [[-0.5, 0.0, -0.125], [0.5, 0.0, -0.125], [2.0 / 3.0, 0.0, 1.0], [-2.0 / 3.0, 0.0, 1.0]];
    assert_eq!(polygon, expected.map(DVec3::from_array));
}
