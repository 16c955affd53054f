//! 10, 10³, 10⁶ small azimuths, one after the other, with the errors of the basis, of D, and of C.
//!
//! The reference is one rotation by the sum of the angles, which is exact. Each angle has few enough digits for it.

use std::hint::black_box;
use std::mem::size_of;
use std::pin::Pin;
use std::time::Duration;

use glam::DVec3;

use super::{figure_of, random_camera};
use crate::camera::{Camera, Convention, Operation, Parameters};
use crate::chain::real::Real;
use crate::chain::{Chain, Vector};
use crate::geometry::Angle;
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, Watch, bits_off, mean_bits};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, Method, OWN, Study, Unit};
use crate::progress::{Progress, at_once, pause};

const STEPS: [u32; 3] = [10, 1_000, 1_000_000];
/// Number of steps without a pause.
const STRETCH: u32 = 4_000;

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let steps = &STEPS[..lab.many(3, 2)];
    // Each run is timed once in each turn, however much time there is.
    let watch = Watch { slice: Duration::ZERO, ..lab.watch(steps.len() * METHODS.len(), 1) };
    let mut rows = Vec::new();
    for (i, &count) in steps.iter().enumerate() {
        let inputs = if count > 1_000 { 1 } else { lab.many(16, 2) };
        let mut random = Random::new(lab.effort.seed, 300 + i as u64);
        let starts: Vec<CameraCase> = (0..inputs).filter_map(|_| CameraCase::new(&mut random, count)).collect();
        if lab.progress.is_cancelled() {
            break;
        }
        let run = async |k: usize, of_method: &mut [Trial; 3]| {
            let turned = METHODS[k].1;
            for (input, start) in starts.iter().enumerate() {
                let timed = &mut of_method[0];
                let end = if count > STRETCH {
                    timed.time_slices(count as usize, turned(start, count, &lab.progress)).await
                } else {
                    let mut end = End::of(&start.camera);
                    timed.time_whole(&watch, count as usize, || {
                        end = at_once(turned(black_box(start), count, &lab.progress));
                    });
                    end
                };
                if of_method[0].is_first() {
                    for (trial, off) in of_method.iter_mut().zip(start.judge(&end)) {
                        trial.note(input, off);
                    }
                }
            }
        };
        let trials = lab.in_turns(METHODS.len(), run).await;
        for (k, (case, unit)) in CASES.into_iter().enumerate() {
            let methods =
                METHODS.iter().zip(&trials).map(|((name, _), trials)| Method::new(name, trials[k].clone())).collect();
            let group = Group { case: case.to_owned(), parameter: f64::from(count), unit, methods };
            rows.extend(group.rows(Study::RepeatedOperations, |input| {
                starts.get(input).map(|start| figure_of(&start.parameters, 1.0))
            }));
        }
    }
    // Each case by itself, as in the other studies.
    rows.sort_by_key(|row| CASES.iter().position(|(case, _)| *case == row.case));
    let working_set = size_of::<Camera>();
    Findings { study: Study::RepeatedOperations, reference: "512 bits", working_set, rows }
}

const CASES: [(&str, Unit); 3] = [
    // The greatest entry of BᵀB − I, with B the basis.
    ("orthonormality", Unit::Relative),
    ("distance", Unit::Relative),
    ("position", Unit::SceneUnits),
];

/// A camera, and its final position.
struct CameraCase {
    parameters: Parameters,
    camera: Camera,
    /// In degrees, of one step.
    angle: f64,
    exact_distance: f64,
    exact_position: Vector<Reference>,
}

/// The final camera of a method.
struct End {
    axes: [DVec3; 3],
    position: DVec3,
}

impl End {
    fn of(camera: &Camera) -> Self {
        let basis = camera.basis();
        Self { axes: [basis.u, basis.v, basis.n], position: camera.position() }
    }
}

impl CameraCase {
    fn new(random: &mut Random, steps: u32) -> Option<Self> {
        const GRID: f64 = (1u64 << 24) as f64;
        let parameters = random_camera(random, DVec3::new(1.0, -2.0, 3.0));
        let camera = Camera::new(&parameters).ok()?;
        // 24 bits after the point, 10 before. A million of them are still exact.
        let angle = (random.between(0.01, 1.0) * GRID).round() / GRID;
        let once = Operation::Azimuth(Angle::from_degrees(angle * f64::from(steps)));
        let Chain { given, distance, .. } = Chain::<Reference>::new(&parameters).after(&once, Convention::RightHand);
        Some(Self { parameters, camera, angle, exact_distance: distance.to_f64(), exact_position: given.position })
    }

    /// Drift of orthonormality, of D, and of C.
    fn judge(&self, end: &End) -> [Off; 3] {
        let axes = end.axes.map(Vector::<Reference>::of);
        let mut worst = 0.0;
        let mut pairs = Vec::new();
        for i in 0..3 {
            for j in i..3 {
                let expected = if i == j { 1.0 } else { 0.0 };
                let product = axes[i].dot(&axes[j]);
                worst = f64::max(worst, (product.clone() - Reference::of(expected)).to_f64().abs());
                if i == j {
                    pairs.push((product.to_f64(), 1.0));
                }
            }
        }
        let orthonormality = Off { error: worst, bits: mean_bits(pairs) };
        let position = Vector::<Reference>::of(end.position);
        let distance = position.minus(&Vector::of(self.parameters.focal_point)).length().to_f64();
        let distance = Off {
            error: (distance - self.exact_distance).abs() / self.exact_distance,
            bits: bits_off(distance, self.exact_distance),
        };
        let exact = self.exact_position.to_f64().to_array();
        let bits = mean_bits(end.position.to_array().into_iter().zip(exact));
        let position = Off { error: position.minus(&self.exact_position).length().to_f64(), bits };
        [orthonormality, distance, position]
    }
}

/// A method that gives the final camera after a number of steps. It pauses after each [`STRETCH`] of them, and ends
/// there if it was cancelled.
type Turned = for<'a> fn(&'a CameraCase, u32, &'a Progress) -> Pin<Box<dyn Future<Output = End> + 'a>>;

const METHODS: [(&str, Turned); 7] = [
    ("f32 matrix", |start, steps, progress| Box::pin(matrix::<f32, false>(start, steps, progress))),
    ("f32 orthonormalised", |start, steps, progress| Box::pin(matrix::<f32, true>(start, steps, progress))),
    ("f32 quaternion", |start, steps, progress| Box::pin(quaternion::<f32>(start, steps, progress))),
    ("f64 matrix", |start, steps, progress| Box::pin(matrix::<f64, false>(start, steps, progress))),
    ("f64 orthonormalised", |start, steps, progress| Box::pin(matrix::<f64, true>(start, steps, progress))),
    ("f64 quaternion", |start, steps, progress| Box::pin(quaternion::<f64>(start, steps, progress))),
    (OWN, |start, steps, progress| Box::pin(own(start, steps, progress))),
];

/// The state after this number of steps.
async fn repeated<S>(mut state: S, steps: u32, progress: &Progress, step: impl Fn(S) -> S) -> S {
    let mut left = steps;
    while left > STRETCH {
        state = stretch(state, STRETCH, &step);
        left -= STRETCH;
        pause().await;
        if progress.is_cancelled() {
            return state;
        }
    }
    stretch(state, left, &step)
}

/// Steps without a pause. In its own function, the compiler keeps the state in registers. Inside a function that
/// pauses, the state went through memory at each step, which took six times as long as the arithmetic of a matrix.
#[inline(never)]
fn stretch<S>(mut state: S, steps: u32, step: &impl Fn(S) -> S) -> S {
    for _ in 0..steps {
        state = step(state);
    }
    state
}

/// The basis and C − PF of a start, in the precision of `R`.
fn frame<R: Real>(start: &CameraCase) -> ([Vector<R>; 3], Vector<R>) {
    let basis = start.camera.basis();
    let to_viewer = start.parameters.position - start.parameters.focal_point;
    ([basis.u, basis.v, basis.n].map(Vector::of), Vector::of(to_viewer))
}

/// PF + the turned C − PF, in the precision of `R`.
fn end<R: Real>(start: &CameraCase, axes: &[Vector<R>; 3], to_viewer: &Vector<R>) -> End {
    let position = Vector::<R>::of(start.parameters.focal_point).plus(to_viewer).to_f64();
    End { axes: [axes[0].to_f64(), axes[1].to_f64(), axes[2].to_f64()], position }
}

/// The product of all rotation matrices, the last first, then applied once; Gram and Schmidt after every step if
/// `CLEAN`.
async fn matrix<R: Real, const CLEAN: bool>(start: &CameraCase, steps: u32, progress: &Progress) -> End {
    let (axes, to_viewer) = frame::<R>(start);
    let step = rotation(&axes[1], start.angle);
    let zero = R::zero;
    let one = R::one;
    // Columns.
    let identity = [Vector([one(), zero(), zero()]), Vector([zero(), one(), zero()]), Vector([zero(), zero(), one()])];
    let total = repeated(identity, steps, progress, |total| {
        let total = total.map(|column| apply(&step, &column));
        if !CLEAN {
            return total;
        }
        let [x, y, _] = &total;
        let x = x.unit();
        let y = y.minus(&x.times(&x.dot(y))).unit();
        let z = x.cross(&y);
        [x, y, z]
    })
    .await;
    let turned = |v: &Vector<R>| {
        let [x, y, z] = &v.0;
        total[0].times(x).plus(&total[1].times(y)).plus(&total[2].times(z))
    };
    end(start, &[turned(&axes[0]), turned(&axes[1]), turned(&axes[2])], &turned(&to_viewer))
}

/// Rows of the matrix that rotates about the unit vector `k`, O. Rodrigues (1840).
fn rotation<R: Real>(k: &Vector<R>, degrees: f64) -> [Vector<R>; 3] {
    let (sine, cosine) = R::sin_cos_degrees(degrees);
    let versine = R::one() - cosine.clone();
    let [x, y, z] = k.0.clone();
    let entry = |a: &R, b: &R, rest: R| a.clone() * b.clone() * versine.clone() + rest;
    let s = |a: &R| a.clone() * sine.clone();
    [
        Vector([entry(&x, &x, cosine.clone()), entry(&x, &y, -s(&z)), entry(&x, &z, s(&y))]),
        Vector([entry(&y, &x, s(&z)), entry(&y, &y, cosine.clone()), entry(&y, &z, -s(&x))]),
        Vector([entry(&z, &x, -s(&y)), entry(&z, &y, s(&x)), entry(&z, &z, cosine.clone())]),
    ]
}

fn apply<R: Real>(rows: &[Vector<R>; 3], v: &Vector<R>) -> Vector<R> {
    Vector([rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)])
}

/// The product of all quaternions, made a unit quaternion after every step, then applied once.
async fn quaternion<R: Real>(start: &CameraCase, steps: u32, progress: &Progress) -> End {
    let (axes, to_viewer) = frame::<R>(start);
    let (sine, cosine) = R::sin_cos_degrees(start.angle / 2.0);
    let step = (cosine, axes[1].times(&sine));
    let identity = (R::one(), Vector([R::zero(), R::zero(), R::zero()]));
    let total = repeated(identity, steps, progress, |total| {
        let (a, b) = (&step, &total);
        let scalar = a.0.clone() * b.0.clone() - a.1.dot(&b.1);
        let vector = b.1.times(&a.0).plus(&a.1.times(&b.0)).plus(&a.1.cross(&b.1));
        let over = R::one() / (scalar.clone() * scalar.clone() + vector.dot(&vector)).sqrt();
        (scalar * over.clone(), vector.times(&over))
    })
    .await;
    // v + 2 q × (q × v + w v).
    let turned = |v: &Vector<R>| {
        let (w, q) = &total;
        v.plus(&q.cross(&q.cross(v).plus(&v.times(w))).times(&R::of(2.0)))
    };
    end(start, &[turned(&axes[0]), turned(&axes[1]), turned(&axes[2])], &turned(&to_viewer))
}

async fn own(start: &CameraCase, steps: u32, progress: &Progress) -> End {
    let step = Operation::Azimuth(Angle::from_degrees(start.angle));
    // A rotated camera is a camera. If one weren't, it would stay in place, and the error would show it.
    let turned = |camera: Camera| step.apply(&camera, Convention::RightHand).unwrap_or(camera);
    End::of(&repeated(start.camera.clone(), steps, progress, turned).await)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    #[test]
    fn a_run_that_is_given_up_ends_after_its_first_stretch() {
        let steps = 10 * STRETCH;
        let start = CameraCase::new(&mut Random::new(1, 300), steps).unwrap();
        let progress = Progress::default();
        progress.cancel();
        for (name, turned) in METHODS {
            let cancelled = at_once(turned(&start, steps, &progress));
            let stretch = at_once(turned(&start, STRETCH, &Progress::default()));
            assert_eq!((cancelled.axes, cancelled.position), (stretch.axes, stretch.position), "{name}");
        }
    }
}
