//! 1, 4, 16, 64 samples of a pixel against the exact area that a triangle covers of it.
//!
//! White triangles on black, in a parallel projection whose window is the picture, so that a scene unit is a pixel. The
//! error is that of the covered share, over the pixels that an edge passes through.

use std::mem::size_of;

use glam::{DVec2, DVec3};

use super::figure_with;
use super::painter::{Painter, flat};
use crate::appearance::{Rgba, Samples, Style, Visibility};
use crate::camera::{Camera, Parameters, Projection, ViewWindow};
use crate::chain::real::Real;
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, Watch, bits_off};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};
use crate::progress::pause;
use crate::scene::{ObjectSpec, Scene, Shape};

/// A side of the picture.
const SIDE: u32 = 72;
const SIZES: [f64; 4] = [2.0, 8.0, 24.0, 64.0];
const WHITE: Rgba = Rgba::rgb(255, 255, 255);

type Triangle = [DVec2; 3];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(12, 2);
    let watch = lab.watch(2 * SIZES.len() * METHODS.len(), count);
    let mut rows = Vec::new();
    for (c, (case, thin)) in [("triangles", false), ("slivers", true)].into_iter().enumerate() {
        for (s, size) in SIZES.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 700 + (c * SIZES.len() + s) as u64);
            let mut setups = Vec::new();
            for _ in 0..count {
                setups.extend(Setup::new(&mut random, size, thin));
                pause().await;
            }
            let measure = |method: &Way, input, setup: &Setup, trial: &mut Trial| {
                let coverage = method.coverage(setup, trial, &watch);
                if trial.is_first() {
                    setup.judge(input, &coverage, trial);
                }
            };
            let methods = lab.methods(&METHODS, &setups, measure).await;
            let group = Group { case: case.to_owned(), parameter: size, unit: Unit::Color, methods };
            rows.extend(group.rows(Study::Antialiasing, |input| setups.get(input).map(Setup::figure)));
        }
    }
    let working_set = (SIDE * SIDE) as usize * size_of::<u32>();
    Findings { study: Study::Antialiasing, reference: "exact area in 512 bits", working_set, rows }
}

/// A triangle and how much of each pixel it covers.
struct Setup {
    parameters: Parameters,
    camera: Camera,
    triangle: Triangle,
    scene: Scene,
    exact: Vec<f64>,
}

impl Setup {
    fn new(random: &mut Random, size: f64, thin: bool) -> Option<Self> {
        let side = f64::from(SIDE);
        let window = Some(ViewWindow { left: 0.0, right: side, bottom: 0.0, top: side });
        let parameters = Parameters {
            projection: Projection::Parallel,
            position: DVec3::Z,
            focal_point: DVec3::ZERO,
            near: 0.5,
            far: 2.0,
            window,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).ok()?;
        // A whole number of 256ths of a pixel, because the program places vertices there, which isn't the subject of
        // the study.
        let grid = |p: DVec2| (p * 256.0).round() / 256.0;
        let middle = DVec2::splat(side / 2.0) + DVec2::new(random.unit(), random.unit());
        let turn = DVec2::from_angle(random.between(0.0, std::f64::consts::TAU));
        let half = size / 2.0;
        let wide = if thin { 0.25 } else { half };
        let corners = [DVec2::new(-half, -wide), DVec2::new(half, -wide * random.unit()), DVec2::new(0.3 * half, wide)];
        let triangle = corners.map(|p| grid(middle + turn.rotate(p)));
        let object = super::painter::triangle(triangle.map(|p| p.extend(0.0)), WHITE);
        let scene = Scene { objects: vec![object], ..Scene::default() };
        let exact = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| covered(&triangle, i, j))).collect();
        Some(Self { parameters, camera, triangle, scene, exact })
    }

    /// Pixels that are entirely inside or outside are right with any number of samples, so they're left out.
    fn judge(&self, input: usize, coverage: &[f64], trial: &mut Trial) {
        for (&computed, &exact) in coverage.iter().zip(&self.exact) {
            if (exact > 0.0 && exact < 1.0) || computed != exact {
                trial.note(input, Off { error: (computed - exact).abs(), bits: bits_off(computed, exact) });
            }
        }
    }

    fn figure(&self) -> String {
        let [a, b, c] = self.triangle.map(|p| p.extend(0.0));
        let edges = Shape::Segments(vec![[a, b], [b, c], [c, a]]);
        figure_with(&self.parameters, vec![ObjectSpec::new("triangle", edges)])
    }
}

/// The exact share of pixel (i, j), rows from the top, that a triangle covers, by I. Sutherland, G. Hodgman, *Reentrant
/// polygon clipping* (1974), on the triangle against the pixel, and the area of the remaining polygon.
fn covered(triangle: &Triangle, i: u32, j: u32) -> f64 {
    let (left, top) = (f64::from(i), f64::from(SIDE - j));
    let (low, high) = triangle.iter().fold((DVec2::MAX, DVec2::MIN), |(low, high), p| (low.min(*p), high.max(*p)));
    if low.x >= left + 1.0 || high.x <= left || low.y >= top || high.y <= top - 1.0 {
        return 0.0;
    }
    let mut polygon: Vec<[Reference; 2]> = triangle.iter().map(|p| [Reference::of(p.x), Reference::of(p.y)]).collect();
    for (axis, border, sign) in [(0, left, 1.0), (0, left + 1.0, -1.0), (1, top - 1.0, 1.0), (1, top, -1.0)] {
        let distance = |p: &[Reference; 2]| (p[axis].clone() - Reference::of(border)) * Reference::of(sign);
        let mut kept = Vec::new();
        for k in 0..polygon.len() {
            let (a, b) = (&polygon[k], &polygon[(k + 1) % polygon.len()]);
            let (da, db) = (distance(a), distance(b));
            let zero = Reference::zero();
            if da >= zero {
                kept.push(a.clone());
            }
            if (da < zero) != (db < zero) {
                let t = da.clone() / (da - db);
                kept.push([0, 1].map(|i: usize| a[i].clone() + (b[i].clone() - a[i].clone()) * t.clone()));
            }
        }
        polygon = kept;
    }
    let mut twice = Reference::zero();
    for k in 0..polygon.len() {
        let (a, b) = (&polygon[k], &polygon[(k + 1) % polygon.len()]);
        twice = twice + a[0].clone() * b[1].clone() - a[1].clone() * b[0].clone();
    }
    (twice.abs() / Reference::of(2.0)).to_f64()
}

#[derive(Clone, Copy)]
enum Way {
    /// The program's drawing with this number of samples.
    Program(Samples),
    /// The program's drawing by default.
    Own,
    /// A grid with this number of samples in a row and column, at even distances.
    Grid(u32),
}

const METHODS: [(&str, Way); 6] = [
    ("1 sample", Way::Program(Samples::One)),
    ("4 samples", Way::Program(Samples::Four)),
    ("16 samples", Way::Program(Samples::Sixteen)),
    ("16 samples on a grid", Way::Grid(4)),
    ("64 samples on a grid", Way::Grid(8)),
    (OWN, Way::Own),
];

impl Way {
    fn coverage(self, setup: &Setup, trial: &mut Trial, watch: &Watch) -> Vec<f64> {
        match self {
            Self::Program(antialias) => painted(setup, &flat(Visibility::DepthBuffer, antialias), trial, watch),
            Self::Own => painted(setup, &flat(Visibility::default(), Style::default().antialias), trial, watch),
            Self::Grid(n) => sampled(setup, n, trial, watch),
        }
    }
}

fn painted(setup: &Setup, style: &Style, trial: &mut Trial, watch: &Watch) -> Vec<f64> {
    let mut painter = Painter::default();
    let mut pixels = Vec::new();
    trial.time_whole(watch, setup.exact.len(), || {
        pixels = painter.paint(&setup.scene, &setup.camera, [SIDE; 2], style);
    });
    pixels.iter().map(|pixel| f64::from(pixel.g) / 255.0).collect()
}

fn sampled(setup: &Setup, n: u32, trial: &mut Trial, watch: &Watch) -> Vec<f64> {
    let [a, b, c] = setup.triangle;
    let inside = |p: DVec2| {
        let sides = [(a, b), (b, c), (c, a)].map(|(a, b)| (b - a).perp_dot(p - a));
        sides.iter().all(|&x| x >= 0.0) || sides.iter().all(|&x| x <= 0.0)
    };
    let share = |i: u32, j: u32| {
        let at = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
        let samples = (0..n * n).map(|k| DVec2::new(f64::from(i) + at(k % n), f64::from(SIDE - j) - at(k / n)));
        samples.map(|p| f64::from(inside(p))).sum::<f64>() / f64::from(n * n)
    };
    let mut coverage = Vec::new();
    trial.time_whole(watch, setup.exact.len(), || {
        coverage.clear();
        coverage.extend((0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j))).map(|(i, j)| share(i, j)));
    });
    coverage
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_in_a_pixel_is_exact() {
        let top = f64::from(SIDE);
        let at = |x: f64, y: f64| DVec2::new(x, top - y);
        // Half of the first pixel, a quarter of it, all of it, nothing.
        assert_eq!(covered(&[at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)], 0, 0), 0.5);
        assert_eq!(covered(&[at(0.0, 0.0), at(1.0, 0.0), at(0.0, 0.5)], 0, 0), 0.25);
        assert_eq!(covered(&[at(-9.0, -9.0), at(20.0, -9.0), at(-9.0, 20.0)], 0, 0), 1.0);
        assert_eq!(covered(&[at(2.0, 0.0), at(3.0, 0.0), at(2.0, 1.0)], 0, 0), 0.0);
    }
}
