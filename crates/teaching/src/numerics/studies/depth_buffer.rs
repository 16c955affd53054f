//! The formats of depth buffers: the distances that each resolves, by depth and by far/near.
//!
//! The program's own pictures spread their depths over the visible part of the volume if F … B wouldn't resolve it.
//! Here the cubes of the figure are in view, which begin at the depths under test.
//!
//! F is 1. The error is the length of the interval of depths that get the same value, in scene units, because surfaces
//! within it may flicker. Sources: P. Upchurch, M. Desbrun, *Tightening the precision of perspective rendering* (2012);
//! N. Reed, *Depth precision visualized* (2015).

use std::mem::size_of;

use glam::DVec3;

use super::figure_with;
use crate::appearance::VertexFormat;
use crate::camera::{Camera, Parameters, Projection};
use crate::numbers::random::Random;
use crate::numerics::depth_format::{Format, Range, order};
use crate::numerics::measure::{Off, Trial, bits_off};
use crate::numerics::{Findings, Group, Lab, Method, Study, Unit};
use crate::pipeline::canonical::depth_buffer_of;
use crate::pipeline::depths::InView;
use crate::scene::{ObjectSpec, Shape};

const FORMATS: [Format; 9] = [
    Format::Fixed16,
    Format::Fixed24,
    Format::Narrow(VertexFormat::F16),
    Format::Narrow(VertexFormat::Bf16),
    Format::Narrow(VertexFormat::Fixed16),
    Format::Float,
    Format::FloatReversed,
    Format::Logarithmic,
    Format::Own,
];
const RATIOS: [f64; 7] = [10.0, 100.0, 1e3, 1e4, 1e5, 1e7, 1e9];
/// Surfaces that are this share of their depth apart are tested for z-fighting.
const GAP: f64 = 1e-3;

/// The place in the volume.
#[derive(Clone, Copy)]
enum DepthCase {
    Near,
    Middle,
    Far,
    /// Depths over the whole volume, for z-fighting.
    Everywhere,
}

const CASES: [(&str, Projection, DepthCase); 6] = [
    ("perspective at F", Projection::Perspective, DepthCase::Near),
    ("perspective at √(F B)", Projection::Perspective, DepthCase::Middle),
    ("perspective at B", Projection::Perspective, DepthCase::Far),
    ("perspective z-fighting", Projection::Perspective, DepthCase::Everywhere),
    ("parallel at √(F B)", Projection::Parallel, DepthCase::Middle),
    ("parallel z-fighting", Projection::Parallel, DepthCase::Everywhere),
];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(400, 40);
    let watch = lab.watch(CASES.len() * RATIOS.len() * FORMATS.len(), 1);
    let mut rows = Vec::new();
    for (c, (case, projection, place)) in CASES.into_iter().enumerate() {
        for (r, ratio) in RATIOS.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let parameters = camera(projection, ratio);
            let Ok(camera) = Camera::new(&parameters) else { continue };
            let mut random = Random::new(lab.effort.seed, 400 + (c * RATIOS.len() + r) as u64);
            let depths: Vec<f64> = (0..count).map(|_| place.depth(&mut random, ratio)).collect();
            let cubes = depths.iter().map(|&z| InView::between(z, z * (1.0 + GAP) + 2.0 * size_of_cube(z)));
            let (own_scale, own) = depth_buffer_of(&camera, cubes.fold(InView::NOTHING, InView::and));
            let range = Range::from_0_to_1(projection, ratio);
            let mut predicted = [0.0; FORMATS.len()];
            let run = async |k: usize, [trial]: &mut [Trial; 1]| {
                let format = FORMATS[k];
                let value = |z: f64| if format == Format::Own { order(own(z)) } else { format.value(&range, z) };
                trial.time(&watch, &depths, |&z| value(z));
                if trial.is_first() {
                    predicted[k] = place.judge(&range, &depths, &value, &|z| format.step(&range, &own_scale, z), trial);
                }
            };
            let trials = lab.in_turns(FORMATS.len(), run).await;
            let methods = FORMATS.iter().zip(trials).zip(predicted);
            let methods = methods.map(|((format, [trial]), predicted)| Method {
                name: format.name(),
                trial,
                predicted: Some(predicted),
            });
            let methods = methods.collect();
            let unit = if matches!(place, DepthCase::Everywhere) { Unit::Share } else { Unit::SceneUnits };
            let group = Group { case: case.to_owned(), parameter: ratio, unit, methods };
            rows.extend(group.rows(Study::DepthBuffer, |i| depths.get(i).map(|&z| figure(&parameters, z))));
        }
    }
    let working_set = count * size_of::<f64>();
    Findings { study: Study::DepthBuffer, reference: "exact order of depths", working_set, rows }
}

/// A camera that looks along −z from the origin, F = 1.
fn camera(projection: Projection, far: f64) -> Parameters {
    let (position, focal_point) = (DVec3::ZERO, DVec3::NEG_Z);
    Parameters { projection, position, focal_point, near: 1.0, far, view_angle: 60.0, ..Parameters::default() }
}

/// Half the side of a cube that begins at a depth.
fn size_of_cube(depth: f64) -> f64 {
    depth / 8.0
}

/// Two cubes whose front faces are [`GAP`] of their depth apart, seen by a camera. They flicker if the depth buffer
/// can't distinguish them.
fn figure(camera: &Parameters, depth: f64) -> String {
    let size = size_of_cube(depth);
    let front =
        |name: &str, z: f64, x: f64| ObjectSpec::new(name, Shape::Box).at(x, 0.0, -z - size).scaled(size, size, size);
    let objects = vec![front("near", depth, -size / 1.5), front("far", depth * (1.0 + GAP), size / 1.5)];
    let focal_point = DVec3::new(0.0, 0.0, -depth);
    figure_with(&Parameters { focal_point, height: depth, ..*camera }, objects)
}

impl DepthCase {
    fn depth(self, random: &mut Random, far: f64) -> f64 {
        let middle = far.sqrt();
        match self {
            Self::Near => random.between(1.0, 1.01),
            Self::Middle => random.between(middle, middle * 1.01),
            Self::Far => random.between(far * 0.98, far * 0.99),
            // Every factor of depth is as likely as every other.
            Self::Everywhere => far.powf(random.unit()).min(far / (1.0 + 2.0 * GAP)),
        }
    }

    /// Records the error of a format at `depths`, and returns the theoretical prediction for the mean.
    fn judge(
        self,
        range: &Range,
        depths: &[f64],
        value: &impl Fn(f64) -> i64,
        step: &dyn Fn(f64) -> f64,
        trial: &mut Trial,
    ) -> f64 {
        let mean = |of: &dyn Fn(f64) -> f64| depths.iter().map(|&z| of(z)).sum::<f64>() / depths.len().max(1) as f64;
        match self {
            Self::Near | Self::Middle | Self::Far => {
                for (i, &z) in depths.iter().enumerate() {
                    let length = interval(range, z, value);
                    trial.note(i, Off { error: length, bits: bits_off(z + length, z) });
                }
                mean(&|z| step(z) * step(z)).sqrt()
            }
            // The share of depths at which the farther of two isn't recognized as farther.
            Self::Everywhere => {
                let fights = |z: f64| value(z * (1.0 + GAP)) <= value(z);
                let first = depths.iter().position(|&z| fights(z)).unwrap_or(0);
                let share = mean(&|z| f64::from(fights(z)));
                trial.note(first, Off { error: share, bits: 64.0 * share });
                // Two depths fall into one interval with this probability.
                mean(&|z| 1.0 - (z * GAP / step(z)).min(1.0))
            }
        }
    }
}

/// Length of the interval around `z` in which every depth has the same value.
fn interval(range: &Range, z: f64, value: &impl Fn(f64) -> i64) -> f64 {
    let here = value(z);
    let edge = |towards: f64| {
        // The least visible step, between a power of two that isn't visible and one that is.
        let mut step = z * f64::EPSILON;
        while value(z + towards * step) == here {
            step *= 2.0;
            if step > range.far {
                return range.far;
            }
        }
        let (mut low, mut high) = (step / 2.0, step);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if value(z + towards * middle) == here {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    };
    edge(1.0) + edge(-1.0)
}
