//! The formats of depth buffers: which distances can be told apart, at which depth, for which far/near.
//!
//! The program's own pictures spread their depths over what is in view, where F … B would not tell it apart; here the cubes of the figure
//! are in view, which begin at the depths that are tried.
//!
//! F is 1. The error is the length of the interval of depths that get the same value, in scene units: what lies within may flicker.
//! Sources: P. Upchurch, M. Desbrun, *Tightening the precision of perspective rendering* (2012); N. Reed, *Depth precision visualized*
//! (2015).

use std::mem::size_of;

use glam::DVec3;

use crate::camera::{Camera, Parameters, Projection};
use crate::figure::{Figure, write};
use crate::numerics::measure::{Off, Trial, bits_off};
use crate::numerics::random::Random;
use crate::numerics::{Findings, Group, Lab, Method, OWN, Study, Unit};
use crate::pipeline::depths::{DepthScale, InView};
use crate::pipeline::project::depth_buffer_of;
use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape};

const RATIOS: [f64; 7] = [10.0, 100.0, 1e3, 1e4, 1e5, 1e7, 1e9];
/// Surfaces this share of their depth apart are tried for z-fighting.
const GAP: f64 = 1e-3;

/// Where in the volume.
#[derive(Clone, Copy)]
enum Place {
    Near,
    Middle,
    Far,
    /// Depths over the whole volume, for z-fighting.
    Everywhere,
}

const CASES: [(&str, Projection, Place); 6] = [
    ("perspective at F", Projection::Perspective, Place::Near),
    ("perspective at √(F B)", Projection::Perspective, Place::Middle),
    ("perspective at B", Projection::Perspective, Place::Far),
    ("perspective z-fighting", Projection::Perspective, Place::Everywhere),
    ("parallel at √(F B)", Projection::Parallel, Place::Middle),
    ("parallel z-fighting", Projection::Parallel, Place::Everywhere),
];

pub(in crate::numerics) fn run(lab: &Lab) -> Findings {
    let count = lab.many(400, 40);
    let watch = lab.watch(CASES.len() * RATIOS.len() * FORMATS.len());
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
            let range = Range { projection, far: ratio };
            let methods = FORMATS
                .into_iter()
                .map(|format| {
                    let value = |z: f64| if format == Format::Own { order(own(z)) } else { format.value(&range, z) };
                    let mut trial = Trial::default();
                    trial.time(&watch, &depths, |&z| value(z));
                    let predicted =
                        place.judge(&range, &depths, &value, &|z| format.step(&range, &own_scale, z), &mut trial);
                    lab.progress.advance(1);
                    let predicted = Some(predicted);
                    Method { name: format.name(), trial, predicted }
                })
                .collect();
            let unit = if matches!(place, Place::Everywhere) { Unit::Share } else { Unit::SceneUnits };
            let group = Group { case: case.to_owned(), parameter: ratio, unit, methods };
            rows.extend(group.rows(|i| depths.get(i).map(|&z| figure(&parameters, z))));
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

/// Two cubes whose front faces are [`GAP`] of their depth apart, seen by a camera: where the depth buffer cannot tell, they flicker.
fn figure(camera: &Parameters, depth: f64) -> String {
    let size = size_of_cube(depth);
    let front =
        |name: &str, z: f64, x: f64| ObjectSpec::new(name, Shape::Box).at(x, 0.0, -z - size).scaled(size, size, size);
    let objects = vec![front("near", depth, -size / 1.5), front("far", depth * (1.0 + GAP), size / 1.5)];
    let scene = SceneSpec { preset: Preset::Empty, objects, ..SceneSpec::default() };
    let focal_point = DVec3::new(0.0, 0.0, -depth);
    let camera = Parameters { focal_point, height: depth, ..*camera };
    write::to_toml(&Figure { camera, scene, ..Figure::default() })
}

impl Place {
    fn depth(self, random: &mut Random, far: f64) -> f64 {
        let middle = far.sqrt();
        match self {
            Self::Near => random.between(1.0, 1.01),
            Self::Middle => random.between(middle, middle * 1.01),
            Self::Far => random.between(far * 0.98, far * 0.99),
            // Every factor of depth as likely as every other.
            Self::Everywhere => far.powf(random.unit()).min(far / (1.0 + 2.0 * GAP)),
        }
    }

    /// Takes down how far off a format is at `depths`, and gives what the theory predicts for the mean.
    #[expect(clippy::cast_precision_loss, reason = "a few hundred depths")]
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
            // The share of depths at which the farther of two is not held for the farther.
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

/// How long the interval around `z` is in which every depth has the same value.
fn interval(range: &Range, z: f64, value: &impl Fn(f64) -> i64) -> f64 {
    let here = value(z);
    let edge = |towards: f64| {
        // The least step that is seen, between a power of two that is not and one that is.
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

/// F = 1, B, and the kind of projection.
pub(super) struct Range {
    pub(super) projection: Projection,
    pub(super) far: f64,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Format {
    Fixed16,
    Fixed24,
    Float,
    FloatReversed,
    Logarithmic,
    Own,
}

const FORMATS: [Format; 6] =
    [Format::Fixed16, Format::Fixed24, Format::Float, Format::FloatReversed, Format::Logarithmic, Format::Own];

/// Reversed depth as a number that grows with the depth.
fn order(reversed: f32) -> i64 {
    -i64::from(reversed.to_bits())
}

impl Format {
    const fn name(self) -> &'static str {
        match self {
            Self::Fixed16 => "fixed 16",
            Self::Fixed24 => "fixed 24",
            Self::Float => "f32",
            Self::FloatReversed => "f32 reversed",
            Self::Logarithmic => "logarithmic 24",
            Self::Own => OWN,
        }
    }

    /// The value that is stored for a depth, as a whole number that grows with it. The transformation is done in single precision, as
    /// graphics cards do: Z = (z_c entries of M_p) / w.
    pub(super) fn value(self, range: &Range, z: f64) -> i64 {
        #[expect(clippy::cast_possible_truncation, reason = "single precision is what is studied")]
        let (depth, far) = (z as f32, range.far as f32);
        let perspective = range.projection == Projection::Perspective;
        // 0 at F, 1 at B; reversed: 1 at F, 0 at B.
        let normal = || {
            if perspective {
                (far / (far - 1.0) * depth - far / (far - 1.0)) / depth
            } else {
                (depth - 1.0) / (far - 1.0)
            }
        };
        let reversed = || {
            if perspective { (far / (far - 1.0) - depth / (far - 1.0)) / depth } else { (far - depth) / (far - 1.0) }
        };
        #[expect(clippy::cast_possible_truncation, reason = "between 0 and 2^24")]
        let fixed = |x: f32, bits: i32| (f64::from(x) * (2f64.powi(bits) - 1.0)).round() as i64;
        match self {
            Self::Fixed16 => fixed(normal(), 16),
            Self::Fixed24 => fixed(normal(), 24),
            Self::Float => i64::from(normal().max(0.0).to_bits()),
            Self::FloatReversed | Self::Own => order(reversed().max(0.0)),
            Self::Logarithmic => fixed(depth.ln() / far.ln(), 24),
        }
    }

    /// The length of one step at depth `z`, for the program's own with its scale: a unit of what is stored over its derivative.
    fn step(self, range: &Range, own: &DepthScale, z: f64) -> f64 {
        if self != Self::Own {
            return self.step_in_range(range, z);
        }
        // Depths relative to the farthest in view, whatever their unit.
        let far = own.far;
        let slope = match range.projection {
            Projection::Perspective => z * (far - z) / far,
            Projection::Parallel => far - z,
        };
        let depth = own.depth(z);
        slope * ulp(depth) / depth
    }

    /// The same of a format whose range is F … B.
    fn step_in_range(self, range: &Range, z: f64) -> f64 {
        let far = range.far;
        let span = far - 1.0;
        // dz/dZ, and 1 − Z.
        let (slope, reversed) = match range.projection {
            Projection::Perspective => (z * z * span / far, (far - z) / (z * span)),
            Projection::Parallel => (span, (far - z) / span),
        };
        let step = match self {
            Self::Fixed16 => slope * 2f64.powi(-16),
            Self::Fixed24 => slope * 2f64.powi(-24),
            Self::Float => slope * ulp(1.0 - reversed),
            Self::FloatReversed | Self::Own => slope * ulp(reversed),
            Self::Logarithmic => z * far.ln() * 2f64.powi(-24),
        };
        // Of a depth in single precision no more can be told than its own last place.
        step.max(ulp(z)).min(2.0 * far)
    }
}

/// From one f32 to the next.
fn ulp(x: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "an exponent")]
    let exponent = x.max(f64::MIN_POSITIVE).log2().floor() as i32;
    2f64.powi(exponent.max(-126) - 23)
}

/// How a format of depth buffers keeps the depths of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// The format.
    pub format: &'static str,
    /// The length of one step at a depth, in scene units.
    pub step: f64,
    /// What is behind by the gap is always held for the farther.
    pub told_apart: bool,
}

/// Each format of graphics cards at a depth from the eye, F … B, and whether it tells two surfaces apart that are `gap` away from each
/// other there.
#[must_use]
pub fn resolutions(camera: &Camera, depth: f64, gap: f64) -> Vec<Resolution> {
    let near = camera.near();
    let range = Range { projection: camera.projection(), far: camera.far() / near };
    let z = depth / near;
    let of = |format: Format| {
        let step = format.step_in_range(&range, z);
        // Wherever within a step the surfaces lie.
        let mut places = (0..32).map(|i| z + step * f64::from(i) / 32.0);
        let told_apart = places.all(|z| format.value(&range, z + gap / near) > format.value(&range, z));
        Resolution { format: format.name(), step: step * near, told_apart }
    };
    FORMATS.into_iter().filter(|format| *format != Format::Own).map(of).collect()
}
