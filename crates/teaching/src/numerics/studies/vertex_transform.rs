//! World points to view space, in worlds 1 … 10¹² from the origin.
//!
//! The points lie in a scene of size 1 around PF. The error is that of the view-space position, in scene units. If a
//! method has only clip coordinates, it's that of the position they represent, by the exact inverse of M_p.

use std::mem::size_of;

use glam::DVec3;

use super::{figure_of, random_camera};
use crate::camera::{Camera, ImageSize, Ndc, Parameters, Projection, Viewport};
use crate::chain::real::{Bf16, F16, Fixed16, Real};
use crate::chain::{Chain, Matrix, Vector};
use crate::geometry::double_double::{two_product, two_sum};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, Watch, mean_bits};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};
use crate::pipeline::canonical::view_of;

const DISTANCES: [f64; 5] = [1.0, 1e3, 1e6, 1e9, 1e12];
const CASES: [(&str, Projection); 2] = [("perspective", Projection::Perspective), ("parallel", Projection::Parallel)];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let (cameras, points) = (lab.many(8, 2), lab.many(128, 8));
    let watch = lab.watch(CASES.len() * DISTANCES.len() * METHODS.len(), cameras);
    let mut rows = Vec::new();
    for (case, projection) in CASES {
        for (i, &parameter) in DISTANCES.iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 100 + i as u64);
            let setups: Vec<Setup> =
                (0..cameras).filter_map(|_| Setup::new(&mut random, parameter, projection, points)).collect();
            let measure = |run: &Run, input, setup: &Setup, trial: &mut Trial| {
                let results = run(setup, trial, &watch);
                if trial.is_first() {
                    setup.judge(input, &results, trial);
                }
            };
            let methods = lab.methods(&METHODS, &setups, measure).await;
            let group = Group { case: case.to_owned(), parameter, unit: Unit::SceneUnits, methods };
            rows.extend(group.rows(Study::VertexTransform, |input| {
                setups.get(input).map(|setup| figure_of(&setup.parameters, 1.0))
            }));
        }
    }
    let working_set = points * 2 * size_of::<DVec3>();
    Findings { study: Study::VertexTransform, reference: "512 bits", working_set, rows }
}

/// A camera, points around its PF, and their true positions.
struct Setup {
    parameters: Parameters,
    camera: Camera,
    /// The notes' matrices, right to the last digit of an `f64`.
    view: Matrix<f64>,
    projection: Matrix<f64>,
    points: Vec<DVec3>,
    exact: Vec<Vector<Reference>>,
    /// Takes clip coordinates back to view space.
    view_from_clip: Matrix<Reference>,
}

impl Setup {
    /// `None` if the coordinates are so large that C and PF coincide, because such a camera doesn't exist.
    fn new(random: &mut Random, distance: f64, projection: Projection, count: usize) -> Option<Self> {
        let center = random.direction() * distance;
        let parameters = Parameters { projection, ..random_camera(random, center) };
        let camera = Camera::new(&parameters).ok()?;
        let chain = Chain::<Reference>::new(&parameters);
        let c = &chain.given.position;
        let points: Vec<DVec3> =
            (0..count).map(|_| parameters.focal_point + random.direction() * random.between(0.0, 0.5)).collect();
        let exact = points
            .iter()
            .map(|&p| {
                let d = Vector::<Reference>::of(p).minus(c);
                Vector(std::array::from_fn(|i| chain.basis[i].dot(&d)))
            })
            .collect();
        let notes = Ndc::default();
        let (view, projection) = (chain.view_matrix().rounded(), chain.projection_matrix(notes).rounded());
        let view_from_clip = chain.inverse_projection_matrix(notes);
        Some(Self { parameters, camera, view, projection, points, exact, view_from_clip })
    }

    fn judge(&self, input: usize, results: &[Outcome], trial: &mut Trial) {
        for (result, exact) in results.iter().zip(&self.exact) {
            if !result.is_finite() {
                // As far off as the world is away, and no digit is right.
                trial.note(input, Off { error: self.parameters.position.length(), bits: 64.0 });
                continue;
            }
            let computed = match result {
                Outcome::View(p) => Vector::<Reference>::of(*p),
                Outcome::Clip(p) => self.view_of_clip(p),
            };
            let error = computed.minus(exact).length().to_f64();
            let bits = mean_bits(computed.0.iter().zip(&exact.0).map(|(a, b)| (a.to_f64(), b.to_f64())));
            trial.note(input, Off { error, bits });
        }
    }

    /// The view-space position that clip coordinates represent.
    fn view_of_clip(&self, clip: &[f64; 4]) -> Vector<Reference> {
        let [x, y, z, _] = self.view_from_clip.transform(&clip.map(Reference::of));
        Vector([x, y, z])
    }
}

/// The result of a method for a point.
enum Outcome {
    View(DVec3),
    Clip([f64; 4]),
}

impl Outcome {
    fn is_finite(&self) -> bool {
        match self {
            Self::View(p) => p.is_finite(),
            Self::Clip(p) => p.iter().all(|x| x.is_finite()),
        }
    }
}

type Run = fn(&Setup, &mut Trial, &Watch) -> Vec<Outcome>;

const METHODS: [(&str, Run); 11] = [
    ("f16 matrix", one_matrix::<F16>),
    ("bf16 matrix", one_matrix::<Bf16>),
    ("fixed-16.16 matrix", one_matrix::<Fixed16>),
    ("f32 matrix", one_matrix::<f32>),
    ("f32 stages", f32_stages),
    ("f32 relative to eye", f32_relative_to_eye),
    ("f64 matrix", one_matrix::<f64>),
    ("f64 stages", f64_stages),
    ("f64 compensated", compensated),
    ("camera-lab pictures", pictures),
    (OWN, own),
];

fn column<R: Real>(p: DVec3) -> [R; 4] {
    [R::of(p.x), R::of(p.y), R::of(p.z), R::one()]
}

fn clip_outcomes<R: Real>(results: Vec<[R; 4]>) -> Vec<Outcome> {
    results.into_iter().map(|p| Outcome::Clip(p.map(|x| x.to_f64()))).collect()
}

fn view_outcomes(results: Vec<DVec3>) -> Vec<Outcome> {
    results.into_iter().map(Outcome::View).collect()
}

/// One matrix M_p M_v in the precision of `R`, made in `f64` and rounded, for points in the same precision. This is the
/// usual input of a graphics card.
fn one_matrix<R: Real>(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let matrix = setup.projection.product(&setup.view).rounded::<R>();
    let points: Vec<[R; 4]> = setup.points.iter().map(|&p| column(p)).collect();
    clip_outcomes(trial.time(watch, &points, |p| matrix.transform(p)))
}

/// M_v, then M_p, both in single precision.
fn f32_stages(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let (view, projection) = (setup.view.rounded::<f32>(), setup.projection.rounded::<f32>());
    let points: Vec<[f32; 4]> = setup.points.iter().map(|&p| column(p)).collect();
    clip_outcomes(trial.time(watch, &points, |p| projection.transform(&view.transform(p))))
}

/// p − C in `f64`, all else in single precision, as in engines with large worlds.
fn f32_relative_to_eye(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let c = setup.parameters.position;
    let [u, v, n] = axes::<f32>(setup);
    view_outcomes(trial.time(watch, &setup.points, |&p| {
        let d = Vector::<f32>::of(p - c);
        DVec3::new(u.dot(&d).into(), v.dot(&d).into(), n.dot(&d).into())
    }))
}

/// p − C first, then the rotation, in `f64`.
fn f64_stages(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let c = setup.parameters.position;
    let [u, v, n] = axes::<f64>(setup).map(|axis| axis.to_f64());
    view_outcomes(trial.time(watch, &setup.points, |&p| {
        let d = p - c;
        DVec3::new(u.dot(d), v.dot(d), n.dot(d))
    }))
}

/// p − C with its rounding error, and scalar products with theirs, by T. Ogita, S. M. Rump, S. Oishi, *Accurate sum and
/// dot product* (2005), `Dot2`.
fn compensated(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let c = setup.parameters.position;
    let axes = axes::<f64>(setup).map(|axis| axis.to_f64());
    view_outcomes(trial.time(watch, &setup.points, |&p| {
        let [x, y, z] = [two_sum(p.x, -c.x), two_sum(p.y, -c.y), two_sum(p.z, -c.z)];
        let rest = DVec3::new(x.1, y.1, z.1);
        DVec3::from_array(axes.map(|axis| {
            let (a, ae) = two_product(axis.x, x.0);
            let (b, be) = two_product(axis.y, y.0);
            let (s, se) = two_sum(a, b);
            let (d, de) = two_product(axis.z, z.0);
            let (s, te) = two_sum(s, d);
            s + (ae + be + de + se + te + axis.dot(rest))
        }))
    }))
}

/// The positions used for drawing pictures.
fn pictures(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let view = view_of(&setup.camera);
    view_outcomes(trial.time(watch, &setup.points, |&p| view(p)))
}

/// The printed numbers: every station of the point, not only its place in view space.
fn own(setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<Outcome> {
    let image = ImageSize::default();
    let viewport = Viewport::whole(image);
    view_outcomes(trial.time(watch, &setup.points, |&p| setup.camera.stations(p, image, &viewport).view))
}

/// **u**, **v**, **n**, right to the last digit of an `f64`, in the precision of `R`.
fn axes<R: Real>(setup: &Setup) -> [Vector<R>; 3] {
    let basis = setup.camera.basis();
    [basis.u, basis.v, basis.n].map(Vector::of)
}
