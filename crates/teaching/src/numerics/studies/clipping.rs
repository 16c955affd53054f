//! Segments, some through the plane of the eye (w = 0), cut before the division or after it.
//!
//! The camera is at the origin and looks along −z, so world and view space are the same. The error is the greatest
//! distance between the ends found by a method and the true ones, in normalised device coordinates. If one of the two
//! is empty, it's the diagonal of the canonical volume.

use std::mem::size_of;

use glam::DVec3;

use super::figure_with;
use crate::camera::{Camera, Ndc, Parameters};
use crate::chain::real::Real;
use crate::chain::{Given, Matrix, Vector, projection_matrix};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, mean_bits};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};
use crate::pipeline::canonical::clipped_segment_of;
use crate::scene::{ObjectSpec, Shape};

/// Distance of the second end from the plane of the eye, behind it or, in the harmless case, in front of it.
const BEHIND: [f64; 6] = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6];
/// The diagonal of the canonical volume.
const WORST: f64 = 3.464_101_615_137_754_6;

type Ends = [DVec3; 2];
type Clipper<'a> = &'a dyn Fn(&Ends) -> Option<Ends>;

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(300, 20);
    let watch = lab.watch(2 * BEHIND.len() * 5, 1);
    let mut rows = Vec::new();
    let parameters = Parameters {
        position: DVec3::ZERO,
        focal_point: DVec3::NEG_Z,
        view_angle: 90.0,
        aspect: 1.0,
        near: 0.1,
        far: 100.0,
        ..Parameters::default()
    };
    let Ok(camera) = Camera::new(&parameters) else {
        return Findings { study: Study::Clipping, reference: "512 bits", working_set: 0, rows };
    };
    let matrix = projection_matrix(&Given::<Reference>::of(&parameters), Ndc::default());
    let (single, double) = (matrix.rounded::<f32>(), matrix.rounded::<f64>());
    let own = clipped_segment_of(&camera);
    let displayed = |ends: Ends| ends.map(|p| DVec3::new(p.x, p.y, -p.z));
    for (c, (case, sign)) in [("in front", -1.0), ("through w = 0", 1.0)].into_iter().enumerate() {
        for (b, behind) in BEHIND.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 500 + (c * BEHIND.len() + b) as u64);
            let segments: Vec<Ends> = (0..count).map(|_| segment(&mut random, sign * behind)).collect();
            let exact: Vec<Option<Ends>> = segments.iter().map(|ends| before_divide(&matrix, ends)).collect();
            let methods: [(&str, Clipper); 5] = [
                ("f32 after the divide", &|ends| after_divide(&single, ends)),
                ("f32 before the divide", &|ends| before_divide(&single, ends)),
                ("f64 after the divide", &|ends| after_divide(&double, ends)),
                ("f64 before the divide", &|ends| before_divide(&double, ends)),
                (OWN, &|&ends| own(ends).map(displayed)),
            ];
            let measure = |method: &Clipper, _, (): &(), trial: &mut Trial| {
                let results = trial.time(&watch, &segments, method);
                for (i, (result, exact)) in results.iter().zip(&exact).enumerate().take(trial.to_judge()) {
                    trial.note(i, off(result.as_ref(), exact.as_ref()));
                }
            };
            let methods = lab.methods(&methods, &[()], measure).await;
            let group = Group { case: case.to_owned(), parameter: behind, unit: Unit::Ndc, methods };
            rows.extend(group.rows(Study::Clipping, |i| segments.get(i).map(|ends| figure(&parameters, ends))));
        }
    }
    let working_set = count * size_of::<Ends>();
    Findings { study: Study::Clipping, reference: "512 bits", working_set, rows }
}

/// From a point in the volume to one with this z_c.
fn segment(random: &mut Random, z: f64) -> Ends {
    let depth = random.between(0.2, 50.0);
    let seen = DVec3::new(random.between(-0.9, 0.9) * depth, random.between(-0.9, 0.9) * depth, -depth);
    let size = z.abs().max(1.0);
    [seen, DVec3::new(random.between(-1.0, 1.0) * size, random.between(-1.0, 1.0) * size, z)]
}

/// The segment as the one object of a scene.
fn figure(camera: &Parameters, ends: &Ends) -> String {
    figure_with(camera, vec![ObjectSpec::new("segment", Shape::Segments(vec![*ends]))])
}

fn off(result: Option<&Ends>, exact: Option<&Ends>) -> Off {
    match (result, exact) {
        (None, None) => Off { error: 0.0, bits: 0.0 },
        (Some(ends), Some(exact)) => {
            let distances = ends.iter().zip(exact).map(|(a, b)| (*a - *b).length());
            let error = distances.map(|d| if d.is_finite() { d.min(WORST) } else { WORST }).fold(0.0, f64::max);
            let pairs = ends.iter().zip(exact).flat_map(|(a, b)| a.to_array().into_iter().zip(b.to_array()));
            Off { error, bits: mean_bits(pairs) }
        }
        _ => Off { error: WORST, bits: 64.0 },
    }
}

fn clip<R: Real>(matrix: &Matrix<R>, p: DVec3) -> [R; 4] {
    matrix.transform(&[R::of(p.x), R::of(p.y), R::of(p.z), R::one()])
}

fn divided<R: Real>(p: &[R; 4]) -> Vector<R> {
    Vector(std::array::from_fn(|i| p[i].clone() / p[3].clone()))
}

/// M. Cyrus, J. Beck (1978) in clip space: the part of the segment with −w ≤ x, y, z ≤ w, then the division.
fn before_divide<R: Real>(matrix: &Matrix<R>, ends: &Ends) -> Option<Ends> {
    let [a, b] = ends.map(|p| clip(matrix, p));
    let distance = |p: &[R; 4], plane: usize| {
        let (axis, w) = (p[plane / 2].clone(), p[3].clone());
        if plane.is_multiple_of(2) { w + axis } else { w - axis }
    };
    let inside = part(|plane| [distance(&a, plane), distance(&b, plane)])?;
    let at = |t: &R| divided(&std::array::from_fn(|i| a[i].clone() + (b[i].clone() - a[i].clone()) * t.clone()));
    Some([at(&inside[0]).to_f64(), at(&inside[1]).to_f64()])
}

/// The division first, for any w, then the cube −1 … 1. This is wrong if a segment passes through w = 0.
fn after_divide<R: Real>(matrix: &Matrix<R>, ends: &Ends) -> Option<Ends> {
    let [a, b] = ends.map(|p| divided(&clip(matrix, p)));
    let distance = |p: &Vector<R>, plane: usize| {
        let axis = p.0[plane / 2].clone();
        if plane.is_multiple_of(2) { R::one() + axis } else { R::one() - axis }
    };
    let inside = part(|plane| [distance(&a, plane), distance(&b, plane)])?;
    let at = |t: &R| a.plus(&b.minus(&a).times(t));
    Some([at(&inside[0]).to_f64(), at(&inside[1]).to_f64()])
}

/// The interval of a segment in which all six distances, given at its ends, are at least 0.
fn part<R: Real>(distances: impl Fn(usize) -> [R; 2]) -> Option<[R; 2]> {
    let (mut from, mut to) = (R::zero(), R::one());
    for plane in 0..6 {
        let [a, b] = distances(plane);
        let (a_out, b_out) = (a < R::zero(), b < R::zero());
        if a_out && b_out {
            return None;
        }
        if a_out || b_out {
            let t = a.clone() / (a - b);
            if a_out && t > from {
                from = t;
            } else if b_out && t < to {
                to = t;
            }
        }
    }
    (from <= to).then_some([from, to])
}
