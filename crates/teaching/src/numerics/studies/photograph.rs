//! The camera of a photograph, from lines whose ends are a pixel off, over the angle at which the lines meet.
//!
//! The lines run along x and z, four of each, through the middle of an image of 4000 × 3000 pixels. The error of each
//! coordinate of each end has a standard deviation of one pixel. The errors are those of θ and of the direction of
//! **n**. A method that finds no camera is off by π.

use std::f64::consts::PI;
use std::mem::size_of;

use glam::{DVec2, DVec3};

use super::figure_of;
use crate::camera::{
    Camera, Convention, ImageSize, Operation, Parameters, PhotographLine, PhotographMarks, WorldAxis,
    camera_of_photograph,
};
use crate::geometry::Angle;
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, mean_bits};
use crate::numerics::{Findings, Group, Lab, Method, OWN, Study, Unit};

/// The angles between the outermost lines of an axis, in degrees.
const ANGLES: [f64; 7] = [40.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5];
const CASES: [&str; 2] = ["view angle", "direction"];
const IMAGE: ImageSize = ImageSize { width: 4000, height: 3000 };
const AXES: [(WorldAxis, DVec3); 2] = [(WorldAxis::X, DVec3::X), (WorldAxis::Z, DVec3::Z)];
/// Lines of an axis.
const LINES: usize = 4;
/// Half the length of a line in pixels, if its vanishing point is far enough away.
const HALF: f64 = 600.0;

/// θ in degrees and **n**.
type Found = (f64, DVec3);

struct Input {
    parameters: Parameters,
    exact: Found,
    marks: PhotographMarks,
}

type Solve = fn(&Input) -> Option<Found>;

const METHODS: [(&str, Solve); 3] = [("two lines", two_lines), ("mean of intersections", mean), (OWN, own)];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let count = lab.many(200, 20);
    let watch = lab.watch(ANGLES.len() * METHODS.len(), 1);
    let mut rows = CASES.map(|_| Vec::new());
    for (place, angle) in ANGLES.into_iter().enumerate() {
        if lab.progress.is_cancelled() {
            break;
        }
        let mut random = Random::new(lab.effort.seed, 1100 + place as u64);
        let inputs: Vec<Input> = (0..count).filter_map(|_| input(&mut random, angle)).collect();
        let mut methods = CASES.map(|_| Vec::new());
        let run = async |k: usize, trials: &mut [Trial; CASES.len()]| {
            let results = trials[0].time(&watch, &inputs, METHODS[k].1);
            for (i, (result, input)) in results.iter().zip(&inputs).enumerate().take(trials[0].to_judge()) {
                for (trial, off) in trials.iter_mut().zip(off(result.as_ref(), input.exact)) {
                    trial.note(i, off);
                }
            }
        };
        for ((name, _), trials) in METHODS.into_iter().zip(lab.in_turns(METHODS.len(), run).await) {
            for (methods, trial) in methods.iter_mut().zip(trials) {
                methods.push(Method::new(name, trial));
            }
        }
        for ((case, methods), rows) in CASES.into_iter().zip(methods).zip(&mut rows) {
            let group = Group { case: case.to_owned(), parameter: angle, unit: Unit::Radians, methods };
            rows.extend(
                group.rows(Study::Photograph, |i| inputs.get(i).map(|input| figure_of(&input.parameters, 1.0))),
            );
        }
    }
    let working_set = count * (size_of::<Input>() + AXES.len() * LINES * size_of::<PhotographLine>());
    Findings { study: Study::Photograph, reference: "the camera that was drawn", working_set, rows: rows.concat() }
}

fn off(found: Option<&Found>, exact: Found) -> [Off; 2] {
    let Some((theta, n)) = found.filter(|(theta, n)| theta.is_finite() && n.is_finite()) else {
        return [Off { error: PI, bits: 64.0 }; 2];
    };
    let angle = Off { error: (theta - exact.0).abs().to_radians(), bits: mean_bits([(*theta, exact.0)]) };
    let pairs = n.to_array().into_iter().zip(exact.1.to_array());
    [angle, Off { error: n.angle_between(exact.1), bits: mean_bits(pairs) }]
}

/// A camera that sees x and z slantwise, with its lines.
fn input(random: &mut Random, angle: f64) -> Option<Input> {
    let (azimuth, elevation) = (random.between(0.5, 1.1), random.between(0.05, 0.4));
    let out = DVec3::new(azimuth.sin() * elevation.cos(), elevation.sin(), azimuth.cos() * elevation.cos());
    let level = Parameters {
        position: out * random.between(5.0, 12.0),
        focal_point: DVec3::ZERO,
        view_angle: random.between(25.0, 70.0),
        aspect: IMAGE.aspect(),
        ..Parameters::default()
    };
    let camera = Camera::new(&level).ok()?;
    let camera =
        Operation::Roll(Angle::from_degrees(random.between(-8.0, 8.0))).apply(&camera, Convention::RightHand).ok()?;
    let lines = AXES.into_iter().flat_map(|(axis, d)| lines(random, &camera, (axis, d), angle)).collect();
    Some(Input {
        parameters: *camera.parameters(),
        exact: (camera.view_angle().degrees(), camera.basis().n),
        marks: PhotographMarks { lines, ..PhotographMarks::default() },
    })
}

/// f in pixels.
fn focal_length(view_angle: f64) -> f64 {
    f64::from(IMAGE.height) / (2.0 * (view_angle.to_radians() / 2.0).tan())
}

fn middle() -> DVec2 {
    DVec2::new(f64::from(IMAGE.width), f64::from(IMAGE.height)) / 2.0
}

/// The lines along an axis, spread by this angle (degrees) about the way from its vanishing point to the middle.
fn lines(random: &mut Random, camera: &Camera, (axis, d): (WorldAxis, DVec3), angle: f64) -> Vec<PhotographLine> {
    let (basis, f) = (camera.basis(), focal_length(camera.view_angle().degrees()));
    let seen = DVec3::new(d.dot(basis.u), d.dot(basis.v), d.dot(basis.n));
    let vanishing = middle() + DVec2::new(seen.x, -seen.y) * (f / -seen.z);
    let (towards_middle, distance) = (middle() - vanishing, (middle() - vanishing).length());
    let half = HALF.min(distance / 2.0);
    let line = |k: usize, random: &mut Random| {
        let turned = (k as f64 / (LINES - 1) as f64 - 0.5) * angle.to_radians();
        let way = DVec2::from_angle(turned).rotate(towards_middle / distance);
        let mut off = || random.between(-1.0, 1.0) * 3.0_f64.sqrt();
        let ends = [distance - half, distance + half].map(|r| vanishing + way * r + DVec2::new(off(), off()));
        // A direction away from the camera leads towards its vanishing point.
        PhotographLine { axis, ends: if seen.z < 0.0 { [ends[1], ends[0]] } else { ends } }
    };
    (0..LINES).map(|k| line(k, random)).collect()
}

/// The intersection of two lines, by Cramer's rule.
fn intersection(a: &PhotographLine, b: &PhotographLine) -> DVec2 {
    let [p, q] = [a, b].map(|line| line.ends[1] - line.ends[0]);
    a.ends[0] + p * ((b.ends[0] - a.ends[0]).perp_dot(q) / p.perp_dot(q))
}

/// The textbook way: the two outermost lines of each axis, f² = −V₁ · V₂, R from the directions.
fn two_lines(input: &Input) -> Option<Found> {
    of_vanishing_points(input, |lines| Some(intersection(lines.first()?, lines.last()?)))
}

/// The same from the mean of all intersections of two lines.
fn mean(input: &Input) -> Option<Found> {
    of_vanishing_points(input, |lines| {
        let pairs = (0..lines.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
        let places: Vec<DVec2> = pairs.map(|(a, b)| intersection(&lines[a], &lines[b])).collect();
        let count = places.len() as f64;
        Some(places.into_iter().sum::<DVec2>() / count)
    })
}

fn of_vanishing_points(input: &Input, point: impl Fn(&[PhotographLine]) -> Option<DVec2>) -> Option<Found> {
    let [x_lines, z_lines] = [&input.marks.lines[..LINES], &input.marks.lines[LINES..]];
    let centred = |p: DVec2| DVec2::new(p.x - middle().x, middle().y - p.y);
    let points = [point(x_lines)?, point(z_lines)?];
    let [a, b] = points.map(centred);
    let square = -a.dot(b);
    if !(square.is_finite() && square > 0.0) {
        return None;
    }
    let f = square.sqrt();
    let direction = |at: DVec2, place: DVec2, line: &PhotographLine| {
        let away = at.extend(-f).normalize();
        if line.ends[1].distance(place) < line.ends[0].distance(place) { away } else { -away }
    };
    let x = direction(a, points[0], x_lines.first()?);
    let z = direction(b, points[1], z_lines.first()?);
    let y = z.cross(x).normalize();
    let theta = 2.0 * (f64::from(IMAGE.height) / (2.0 * f)).atan().to_degrees();
    Some((theta, DVec3::new(x.z, y.z, z.z)))
}

/// If θ is unknown, it's that of the given camera, 45°.
fn own(input: &Input) -> Option<Found> {
    let given = Parameters { view_angle: 45.0, ..Parameters::default() };
    let found = camera_of_photograph(&input.marks, IMAGE, &given).ok()?;
    Some((found.parameters.view_angle, found.axes()[2]))
}
