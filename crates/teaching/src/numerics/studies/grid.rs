//! Grids for the corners of faces: what rounding to parts of a pixel does to coverage.
//!
//! *Textbook*: edge functions in floating point. Two faces that share an edge compute it from either end, so both may
//! lose a pixel on it, or both take it. *Cards, and the program*: corners are rounded to a grid first, and then every
//! number is whole. Nothing is lost between neighbours, but silhouettes move by half a step. Sources: J. Pineda, *A
//! parallel algorithm for polygon rasterization* (1988); the rules of Direct3D 11, 8 bits.

#![expect(clippy::cast_possible_truncation, reason = "pixels of small images, and rounding is what is studied")]

use std::ops::{Mul, Sub};

use glam::DVec3;

use super::figure_with;
use super::painter::BLACK;
use crate::appearance::Rgba;
use crate::camera::{Parameters, Projection, ViewWindow};
use crate::drawing::{Drawing, Surface};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, bits_off};
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};
use crate::raster::Rasterizer;
use crate::scene::{ObjectSpec, Shape};

/// Pixels: y down.
type Triangle = [[f64; 2]; 3];

/// Where corners lie.
#[derive(Clone, Copy)]
enum Grid {
    /// On whole numbers of 1/2ᵏ pixel.
    Bits(u32),
    /// On the program's grid of 8 bits, painted by its rasterizer.
    Own,
    /// Wherever single precision has them, with edge functions in single precision.
    Single,
}

const METHODS: [(&str, Grid); 4] =
    [("4 bits", Grid::Bits(4)), (OWN, Grid::Own), ("12 bits", Grid::Bits(12)), ("f32", Grid::Single)];
/// So fine that no corner moves by more than a billionth of a pixel.
const EXACT: Grid = Grid::Bits(30);
/// The size of a triangle, in pixels.
const SIZES: [f64; 4] = [2.0, 8.0, 32.0, 128.0];
/// The side of an image that shows a mesh, in triangles.
const ACROSS: usize = 4;

#[derive(Clone, Copy)]
enum Faces {
    /// A mesh that covers the image: every pixel belongs to one face.
    Mesh,
    /// A single triangle.
    Silhouette,
    /// One that is a twentieth of a pixel wide.
    Sliver,
}

const CASES: [(&str, Faces); 3] =
    [("cracks", Faces::Mesh), ("silhouettes", Faces::Silhouette), ("slivers", Faces::Sliver)];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(40, 8);
    let watch = lab.watch(CASES.len() * SIZES.len() * METHODS.len(), count);
    let (mut rows, mut working_set) = (Vec::new(), 0);
    for (c, (case, faces)) in CASES.into_iter().enumerate() {
        for (s, size) in SIZES.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 900 + (c * SIZES.len() + s) as u64);
            let setups: Vec<Vec<Triangle>> = (0..count).map(|_| faces.triangles(&mut random, size)).collect();
            working_set = working_set.max(size_of_val(&setups[..]) + setups.concat().len() * size_of::<Triangle>());
            let side = (ACROSS as f64 * size) as usize;
            let measure = |grid: &Grid, input: usize, setup: &Vec<Triangle>, trial: &mut Trial| {
                let covered = trial.time(&watch, std::slice::from_ref(setup), |setup| grid.coverage(setup, side));
                for covered in covered.iter().take(trial.to_judge()) {
                    let exact = EXACT.coverage(setup, side);
                    let wrong = covered.iter().zip(&exact).filter(|(a, b)| a != b).count() as f64;
                    let share = wrong / exact.iter().filter(|faces| **faces > 0).count().max(1) as f64;
                    trial.note(input, Off { error: share, bits: bits_off(1.0 + share, 1.0) });
                }
            };
            let methods = lab.methods(&METHODS, &setups, measure).await;
            let group = Group { case: case.to_owned(), parameter: size, unit: Unit::Share, methods };
            rows.extend(group.rows(Study::Grid, |input| setups.get(input).map(|setup| figure(setup, side))));
        }
    }
    Findings { study: Study::Grid, reference: "exact coverage", working_set, rows }
}

impl Faces {
    fn triangles(self, random: &mut Random, size: f64) -> Vec<Triangle> {
        let side = ACROSS as f64 * size;
        match self {
            Self::Mesh => {
                // One row more on every side, so that its border lies outside the image.
                let n = ACROSS + 3;
                let mut corner = |k: usize| (k as f64 - 1.0 + random.between(-0.3, 0.3)) * size;
                let rows: Vec<Vec<[f64; 2]>> =
                    (0..n).map(|i| (0..n).map(|j| [corner(j), corner(i)]).collect()).collect();
                let cells = rows.windows(2).flat_map(|two| two[0].windows(2).zip(two[1].windows(2)));
                cells.flat_map(|(a, b)| [[a[0], a[1], b[1]], [a[0], b[1], b[0]]]).collect()
            }
            Self::Silhouette => {
                let mut corner = || [random.between(0.0, side), random.between(0.0, side)];
                // None so thin that it's a sliver.
                loop {
                    let [a, b, c] = [corner(), corner(), corner()];
                    let twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                    if twice_area.abs() > 2.0 * size * size {
                        break vec![[a, b, c]];
                    }
                }
            }
            Self::Sliver => {
                let [a, b] = [0; 2].map(|_| [random.between(0.0, side), random.between(0.0, side)]);
                let length = (b[0] - a[0]).hypot(b[1] - a[1]).max(1.0);
                let aside = 0.05 / length;
                vec![[a, b, [b[0] - (b[1] - a[1]) * aside, b[1] + (b[0] - a[0]) * aside]]]
            }
        }
    }
}

impl Grid {
    /// The number of faces at the centre of each pixel of a square image.
    fn coverage(self, triangles: &[Triangle], side: usize) -> Vec<u8> {
        let mut faces = vec![0; side * side];
        for triangle in triangles {
            match self {
                Self::Bits(bits) => {
                    let steps = f64::from(1_u32 << bits);
                    let at = |v: f64| (v * steps).round_ties_even();
                    if bits > 12 {
                        fill(triangle, side, |v| at(v) as i128, 0, &mut faces);
                    } else {
                        fill(triangle, side, |v| at(v) as i64, 0, &mut faces);
                    }
                }
                Self::Single => fill(triangle, side, |v| v as f32, 0.0, &mut faces),
                Self::Own => return own_coverage(triangles, side),
            }
        }
        faces
    }
}

/// 1 in each pixel that the program paints.
fn own_coverage(triangles: &[Triangle], side: usize) -> Vec<u8> {
    let snapped = |v: f64| ((v * 256.0).round_ties_even() / 256.0) as f32;
    let positions = triangles.iter().flatten().map(|[x, y]| [snapped(*x), snapped(*y), 0.5]).collect();
    let corners = (0..3 * triangles.len() as u32).collect::<Vec<_>>();
    let mut drawing = Drawing::new(side as u32, side as u32, BLACK);
    drawing.surfaces = vec![Surface::solid(positions, corners.as_chunks().0.to_vec(), Rgba::rgb(255, 255, 255))];
    let pixmap = Rasterizer::default().paint(&drawing);
    pixmap.map(|pixmap| pixmap.data().iter().step_by(4).map(|red| red / 255).collect()).unwrap_or_default()
}

/// The triangles before a parallel camera whose window is the image.
fn figure(triangles: &[Triangle], side: usize) -> String {
    let side = side as f64;
    let camera = Parameters {
        projection: Projection::Parallel,
        position: DVec3::Z,
        focal_point: DVec3::ZERO,
        near: 0.5,
        far: 2.0,
        window: Some(ViewWindow { left: 0.0, right: side, bottom: 0.0, top: side }),
        ..Parameters::default()
    };
    let sides = triangles.iter().flat_map(|t| {
        let [a, b, c] = t.map(|[x, y]| DVec3::new(x, side - y, 0.0));
        [[a, b], [b, c], [c, a]]
    });
    figure_with(&camera, vec![ObjectSpec::new("triangles", Shape::Segments(sides.collect()))])
}

/// Adds a face to the pixels whose centres it covers, by edge functions and the top-left rule. `at` takes pixels to the
/// numbers of the method.
fn fill<T>(triangle: &Triangle, side: usize, at: impl Fn(f64) -> T, zero: T, faces: &mut [u8])
where
    T: Copy + PartialOrd + Sub<Output = T> + Mul<Output = T>,
{
    let [a, b, c] = triangle.map(|corner| corner.map(&at));
    let edge = |[p, q]: [[T; 2]; 2], r: [T; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    let [a, b, c] = if edge([a, b], c) < zero { [a, c, b] } else { [a, b, c] };
    let is_inside = |p: [T; 2]| {
        [[a, b], [b, c], [c, a]].into_iter().all(|ends| {
            let e = edge(ends, p);
            let (right, down) = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
            e > zero || e == zero && (down < zero || down == zero && right > zero)
        })
    };
    let range = |k: usize| {
        let (low, high) = triangle.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p[k]), h.max(p[k])));
        (low.max(1.0) as usize - 1)..((high + 2.0).clamp(0.0, side as f64) as usize)
    };
    for y in range(1) {
        for x in range(0) {
            let center = [x, y].map(|pixel| at(pixel as f64 + 0.5));
            faces[y * side + x] += u8::from(is_inside(center));
        }
    }
}
