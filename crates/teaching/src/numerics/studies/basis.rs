//! **u** **v** **n** with VUP almost along DOP, and for vectors whose squares leave the range of numbers.
//!
//! The error is the angle between an axis and the true one, the greatest of the three. NaN counts as the opposite
//! direction, π.

use std::f64::consts::PI;
use std::mem::size_of;

use glam::DVec3;

use super::figure_of;
use crate::camera::{Camera, Parameters};
use crate::chain::real::{Bf16, F16, Fixed16, Real};
use crate::chain::{self, Vector};
use crate::geometry::double_double::{Dd, two_product};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, mean_bits};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};

/// The angles between VUP and DOP, in radians.
const ANGLES: [f64; 8] = [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-11, 1e-13, 1e-15];
/// Factors of the vectors.
const SIZES: [(&str, f64); 3] = [("size 1", 1.0), ("size 1e150", 1e150), ("size 1e-150", 1e-150)];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(200, 12);
    let watch = lab.watch(SIZES.len() * ANGLES.len() * METHODS.len(), 1);
    let mut rows = Vec::new();
    for (s, (case, size)) in SIZES.into_iter().enumerate() {
        for (a, angle) in ANGLES.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 200 + (s * ANGLES.len() + a) as u64);
            let inputs: Vec<Parameters> = (0..count).map(|_| input(&mut random, angle, size)).collect();
            let exact: Vec<_> = inputs.iter().map(reference).collect();
            let measure = |method: &Basis, _, (): &(), trial: &mut Trial| {
                let results = trial.time(&watch, &inputs, method);
                for (i, (axes, exact)) in results.iter().zip(&exact).enumerate().take(trial.to_judge()) {
                    trial.note(i, off(axes, exact));
                }
            };
            let methods = lab.methods(&METHODS, &[()], measure).await;
            let group = Group { case: case.to_owned(), parameter: angle, unit: Unit::Radians, methods };
            rows.extend(group.rows(Study::Basis, |i| inputs.get(i).map(|p| figure_of(p, size))));
        }
    }
    let working_set = count * size_of::<Parameters>();
    Findings { study: Study::Basis, reference: "512 bits", working_set, rows }
}

/// C, PF and VUP with this angle between VUP and DOP, all of them times `size`. If [`Camera::new`] takes them for
/// collinear, because the components' own rounding could have made them so, they're drawn again.
fn input(random: &mut Random, angle: f64, size: f64) -> Parameters {
    loop {
        let towards_viewer = random.direction();
        let across = towards_viewer.cross(random.direction()).normalize_or(DVec3::X);
        let focal_point = random.direction() * random.between(0.5, 2.0);
        let position = focal_point + towards_viewer * random.between(1.0, 3.0);
        // From the rounded difference, so that the angle is exact.
        let along = (position - focal_point).normalize();
        let view_up = along * angle.cos() + across * angle.sin();
        let [position, focal_point, view_up] = [position, focal_point, view_up].map(|v| v * size);
        let (near, far) = (0.1 * size, 10.0 * size);
        let parameters = Parameters { position, focal_point, view_up, near, far, ..Parameters::default() };
        if Camera::new(&parameters).is_ok() {
            return parameters;
        }
    }
}

fn reference(p: &Parameters) -> [Vector<Reference>; 3] {
    chain::basis(&chain::pose(p))
}

fn off(axes: &[DVec3; 3], exact: &[Vector<Reference>; 3]) -> Off {
    let error = axes.iter().zip(exact).map(|(axis, exact)| angle_between(*axis, exact)).fold(0.0, f64::max);
    let pairs =
        axes.iter().zip(exact).flat_map(|(axis, exact)| axis.to_array().into_iter().zip(exact.to_f64().to_array()));
    Off { error, bits: mean_bits(pairs) }
}

fn angle_between(axis: DVec3, exact: &Vector<Reference>) -> f64 {
    if !axis.is_finite() || axis == DVec3::ZERO {
        return PI;
    }
    let axis = Vector::<Reference>::of(axis);
    axis.cross(exact).length().to_f64().atan2(axis.dot(exact).to_f64())
}

type Basis = fn(&Parameters) -> [DVec3; 3];

const METHODS: [(&str, Basis); 9] = [
    ("f16 naive", naive::<F16>),
    ("bf16 naive", naive::<Bf16>),
    ("fixed-16.16 naive", naive::<Fixed16>),
    ("f32 naive", naive::<f32>),
    ("f64 naive", naive::<f64>),
    ("f64 scaled", scaled::<f64>),
    ("f64 compensated", compensated),
    ("double-double", scaled::<Dd>),
    (OWN, own),
];

fn naive<R: Real>(p: &Parameters) -> [DVec3; 3] {
    chain::basis::<R>(&chain::pose(p)).map(|axis| axis.to_f64())
}

fn scaled<R: Real>(p: &Parameters) -> [DVec3; 3] {
    chain::scaled_basis::<R>(&chain::pose(p)).map(|axis| axis.to_f64())
}

/// Scaled, and each difference of products with the error of its products, by W. Kahan's algorithm with a fused
/// multiply-add. See C.-P. Jeannerod, N. Louvet, J.-M. Muller, *Further analysis of Kahan's algorithm for the accurate
/// computation of 2×2 determinants* (2013).
fn compensated(p: &Parameters) -> [DVec3; 3] {
    let scaled = |v: DVec3| v / v.abs().max_element();
    let n = scaled(p.position - p.focal_point);
    let u = scaled(cross(scaled(p.view_up), n)).normalize();
    let n = n.normalize();
    [u, cross(n, u), n]
}

fn cross(a: DVec3, b: DVec3) -> DVec3 {
    let difference = |a: f64, b: f64, c: f64, d: f64| {
        let (product, error) = two_product(c, d);
        a.mul_add(b, -product) - error
    };
    DVec3::new(difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z), difference(a.x, b.y, a.y, b.x))
}

fn own(p: &Parameters) -> [DVec3; 3] {
    // Every input was a valid camera before.
    Camera::new(p).map_or([DVec3::NAN; 3], |camera| {
        let basis = camera.basis();
        [basis.u, basis.v, basis.n]
    })
}
