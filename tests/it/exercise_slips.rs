//! Mistakes made by hand, in formulas that share nothing with those of the program, over many seeds: the first reason
//! in the verdict is the mistake that was made, or one of several that give the same.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeMap;

use camera_lab::camera::{Operation, Parameters, Projection};
use camera_lab::exercises::{Exercise, check, entry};
use glam::{DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use super::exercise_verdicts::exercise;

/// A question, a wrong answer to it, row by row, and the code of the mistake that gives it.
pub(super) type Wrong = (&'static str, Vec<f64>, &'static str);

fn axes(p: &Parameters) -> [DVec3; 3] {
    let n = (p.position - p.focal_point).normalize();
    let u = p.view_up.cross(n).normalize();
    [u, n.cross(u), n]
}

/// W and H.
fn window(p: &Parameters) -> DVec2 {
    let height = match p.projection {
        Projection::Perspective => 2.0 * p.near * (p.view_angle / 2.0).to_radians().tan(),
        Projection::Parallel => p.height,
    };
    DVec2::new(height * p.aspect, height)
}

fn view([u, v, n]: [DVec3; 3], last: DVec3) -> Vec<f64> {
    [[u.x, u.y, u.z, last.x], [v.x, v.y, v.z, last.y], [n.x, n.y, n.z, last.z], [0.0, 0.0, 0.0, 1.0]].concat()
}

fn seen(p: &Parameters, point: DVec3) -> DVec3 {
    let from = point - p.position;
    DVec3::from_array(axes(p).map(|axis| axis.dot(from)))
}

fn projection([x, y]: [f64; 2], [scale, shift]: [f64; 2], last: [f64; 2]) -> Vec<f64> {
    [[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, scale, shift], [0.0, 0.0, last[0], last[1]]].concat()
}

fn array(v: DVec3) -> Vec<f64> {
    v.to_array().to_vec()
}

fn of_axes(p: &Parameters) -> Vec<Wrong> {
    let [u, v, n] = axes(p);
    vec![
        ("n", array(-n), "n-reversed"),
        ("n", array(p.position - p.focal_point), "not-normalised"),
        ("n", array(n * 3.5), "not-normalised"),
        ("u", array(n.cross(p.view_up).normalize()), "u-reversed"),
        ("u", array(p.view_up.cross(n)), "not-normalised"),
        ("v", array(p.view_up), "vup-as-v"),
        ("v", array(p.view_up.normalize()), "vup-as-v"),
        ("v", array(u.cross(n)), "v-reversed"),
        ("v", array(-v), "v-reversed"),
    ]
}

fn of_view(p: &Parameters) -> Vec<Wrong> {
    let at @ [u, v, n] = axes(p);
    let c = p.position;
    let turned = DVec3::new(u.dot(c), v.dot(c), n.dot(c));
    let columns = {
        let rows = DMat3::from_cols(u, v, n);
        [rows.row(0), rows.row(1), rows.row(2)]
    };
    let right = DMat4::from_cols_slice(&view(at, -turned)).transpose();
    vec![
        ("Mv", view(at, -c), "translation-not-rotated"),
        ("Mv", view(at, -DVec3::from_array(at.map(|axis| axis.dot(p.focal_point)))), "focal-point-for-position"),
        ("Mv", view(at, turned), "position-not-negated"),
        ("Mv", view(at, c), "position-not-negated"),
        ("Mv", view(columns, -turned), "transposed"),
        ("Mv", view(columns, c), "inverse"),
        ("Mv", right.to_cols_array().to_vec(), "transposed"),
        ("Mv", view([-u, v, n], DVec3::new(turned.x, -turned.y, -turned.z)), "u-reversed"),
        ("Mv", view([u, -v, n], DVec3::new(-turned.x, turned.y, -turned.z)), "v-reversed"),
        ("Mv", view([-u, v, -n], DVec3::new(turned.x, -turned.y, turned.z)), "n-reversed"),
    ]
}

fn of_window(p: &Parameters) -> Vec<Wrong> {
    let [half, whole] = [p.view_angle / 2.0, p.view_angle].map(|angle| angle.to_radians().tan());
    let (f, d) = (p.near, (p.position - p.focal_point).length());
    let height = 2.0 * f * half;
    vec![
        ("H", vec![f * half], "factor-two"),
        ("H", vec![2.0 * height], "factor-two"),
        ("W", vec![height], "aspect-inverted"),
        ("H", vec![2.0 * half], "near-forgotten"),
        ("H", vec![2.0 * d * half], "distance-for-near"),
        ("H", vec![2.0 * f * whole], "whole-angle"),
        ("H", vec![2.0 * f * (p.view_angle / 2.0).tan()], "radians"),
        ("W", vec![height / p.aspect], "aspect-inverted"),
        ("W", vec![2.0 * half * p.aspect], "near-forgotten"),
        ("r", vec![height * p.aspect], "factor-two"),
        ("b", vec![-height], "factor-two"),
        ("b", vec![height / 2.0], "sign"),
    ]
}

fn of_perspective(p: &Parameters) -> Vec<Wrong> {
    let (size, f, b) = (window(p), p.near, p.far);
    let d = (p.position - p.focal_point).length();
    let scale = |times: f64| [times / size.x, times / size.y];
    let depth = [-(b + f) / (b - f), -2.0 * b * f / (b - f)];
    let w = [-1.0, 0.0];
    vec![
        ("Mp", projection(scale(f), depth, w), "factor-two"),
        ("Mp", projection(scale(2.0), depth, w), "near-forgotten"),
        ("Mp", projection(scale(2.0 * d), depth, w), "distance-for-near"),
        ("Mp", projection(scale(2.0 * f), [depth[0], depth[1] / 2.0], w), "factor-two"),
        ("Mp", projection(scale(2.0 * f), [depth[0], -depth[1]], w), "sign"),
        ("Mp", projection(scale(2.0 * f), depth, [1.0, 0.0]), "z-sign"),
        ("Mp", projection(scale(2.0 * f), [-b / (b - f), -b * f / (b - f)], w), "z-range"),
        ("Mp", projection(scale(2.0), [-2.0 / (b - f), -(b + f) / (b - f)], [0.0, 1.0]), "projections-exchanged"),
    ]
}

fn of_parallel(p: &Parameters) -> Vec<Wrong> {
    let (size, f, b) = (window(p), p.near, p.far);
    let scale = |times: f64| [times / size.x, times / size.y];
    let depth = [-2.0 / (b - f), -(b + f) / (b - f)];
    let w = [0.0, 1.0];
    vec![
        ("Mp", projection(scale(2.0), depth, [0.0, 0.0]), "as-printed"),
        ("Mp", projection(scale(1.0), depth, w), "factor-two"),
        ("Mp", projection(scale(2.0), [depth[0] / 2.0, depth[1]], w), "factor-two"),
        ("Mp", projection(scale(2.0), [-depth[0], depth[1]], w), "sign"),
        ("Mp", projection(scale(2.0), [-1.0 / (b - f), -f / (b - f)], w), "z-range"),
    ]
}

fn of_point(p: &Parameters, point: DVec3) -> Vec<Wrong> {
    let (at, size, f, b) = (seen(p, point), window(p), p.near, p.far);
    let in_perspective = p.projection == Projection::Perspective;
    let clip = if in_perspective {
        let z = -(b + f) / (b - f) * at.z - 2.0 * b * f / (b - f);
        DVec4::new(2.0 * f * at.x / size.x, 2.0 * f * at.y / size.y, z, -at.z)
    } else {
        DVec4::new(2.0 * at.x / size.x, 2.0 * at.y / size.y, -2.0 / (b - f) * at.z - (b + f) / (b - f), 1.0)
    };
    let mut wrong = vec![("view", array(DVec3::new(at.x, at.y, -at.z)), "z-sign")];
    if in_perspective {
        wrong.push(("ndc", array(clip.truncate()), "no-divide"));
        wrong.push(("clip", vec![clip.x, clip.y, clip.z, at.z], "z-sign"));
        wrong.push(("clip", vec![clip.x / 2.0, clip.y / 2.0, clip.z, clip.w], "factor-two"));
        wrong.push(("clip", vec![clip.x / f, clip.y / f, clip.z, clip.w], "near-forgotten"));
    }
    wrong
}

fn of_pixel(exercise: &Exercise) -> Vec<Wrong> {
    let p = &exercise.subject.figure.camera;
    let (at, size) = (seen(p, exercise.subject.points[0]), window(p));
    let in_perspective = p.projection == Projection::Perspective;
    let d = (p.position - p.focal_point).length();
    let on_window = |f: f64| if in_perspective { at.truncate() * f / -at.z } else { at.truncate() };
    let image = exercise.subject.figure.image;
    let [m, n] = [image.width, image.height].map(f64::from);
    let place = on_window(p.near);
    let [i, j] = [m * (place.x / size.x + 0.5), n * (0.5 - place.y / size.y)];
    let up = n * (0.5 + place.y / size.y);
    let exchanged = [(n * (place.x / size.x + 0.5)).floor(), (m * (0.5 - place.y / size.y)).floor()];
    let mut wrong = vec![
        ("window", vec![place.x / size.x * 2.0, place.y / size.y * 2.0], "not-done"),
        ("pixel", vec![i, j], "not-floored"),
        ("pixel", vec![i.round(), j.round()], "rounded-not-floored"),
        ("pixel", vec![i.floor() + 1.0, j.floor() + 1.0], "one-based"),
        ("pixel", vec![j.floor(), i.floor()], "columns-and-rows-exchanged"),
        ("pixel", vec![i.floor(), up.floor()], "y-not-flipped"),
        ("pixel", exchanged.to_vec(), "columns-and-rows-exchanged"),
    ];
    if in_perspective {
        wrong.push(("window", on_window(1.0).to_array().to_vec(), "near-forgotten"));
        wrong.push(("window", on_window(d).to_array().to_vec(), "distance-for-near"));
        wrong.push(("window", at.truncate().to_array().to_vec(), "no-divide"));
    }
    wrong
}

fn of_ray(exercise: &Exercise) -> Vec<Wrong> {
    let p = &exercise.subject.figure.camera;
    let ([u, v, n], size) = (axes(p), window(p));
    let image = exercise.subject.figure.image;
    #[expect(clippy::cast_precision_loss, reason = "a few pixels")]
    let [i, j] = exercise.subject.pixels[0].map(|k| k as f64);
    let at =
        |i: f64, j: f64| [size.x * (i / f64::from(image.width) - 0.5), size.y * (0.5 - j / f64::from(image.height))];
    let [x, y] = at(i + 0.5, j + 0.5);
    let across = u * x + v * y;
    let c = p.position;
    if p.projection == Projection::Parallel {
        let [corner_x, corner_y] = at(i, j);
        return vec![
            ("origin", array(c), "projections-exchanged"),
            ("origin", array(c + DVec3::new(x, y, 0.0)), "view-as-world"),
            ("origin", array(c + u * corner_x + v * corner_y), "pixel-corner"),
            ("direction", array(n), "sign"),
            ("direction", array((across - n * p.near).normalize()), "projections-exchanged"),
        ];
    }
    vec![
        ("direction", array(-n), "projections-exchanged"),
        ("direction", array(across - n * p.near), "not-normalised"),
        ("direction", array((across - n).normalize()), "near-forgotten"),
        ("direction", array(DVec3::new(x, y, -p.near).normalize()), "view-as-world"),
        ("origin", array(c + across), "projections-exchanged"),
        ("origin", array(c + across - n * p.near), "window-as-start"),
    ]
}

fn of_viewport(exercise: &Exercise) -> Vec<Wrong> {
    let ask = exercise.asks.iter().find(|ask| ask.name == "ndc").unwrap();
    let ndc = ask.expected().table().unwrap().entries;
    let port = exercise.subject.figure.viewport.unwrap();
    let real = |size: u32, n: f64| f64::from(size) / 2.0 * (n + 1.0);
    let [x, y] = [real(port.width, ndc[0]), real(port.height, ndc[1])];
    let [left, low] = [f64::from(port.x), f64::from(port.y)];
    let z = port.depth_near + (port.depth_far - port.depth_near) * (ndc[2] + 1.0) / 2.0;
    vec![
        ("viewport", vec![x.round() + left, y.round() + low, z], "rounded-not-floored"),
        ("viewport", vec![x.floor() + left, y.floor() + low, f64::midpoint(ndc[2], 1.0)], "depth-range-ignored"),
        ("viewport", vec![x.floor(), y.floor(), z], "offset-ignored"),
        ("viewport", vec![x.floor() + left, y.floor() + low, ndc[2]], "z-range"),
    ]
}

fn of_turn(exercise: &Exercise) -> Vec<Wrong> {
    let p = &exercise.subject.figure.camera;
    let ([u, v, n], operation) = (axes(p), exercise.subject.operations[0]);
    let angle = operation.angle().unwrap().degrees().to_radians();
    let turned = |axis: DVec3, angle: f64, x: DVec3| DQuat::from_axis_angle(axis, angle) * x;
    let (c, pf) = (p.position, p.focal_point);
    let (axis, other, world) = match operation {
        Operation::Elevation(_) | Operation::Pitch(_) => (u, v, DVec3::X),
        _ => (v, u, DVec3::Y),
    };
    match operation {
        Operation::Elevation(_) | Operation::Azimuth(_) => vec![
            ("C", array(c), "not-done"),
            ("C", array(pf + turned(axis, -angle, c - pf)), "opposite-angle"),
            ("C", array(pf + turned(other, angle, c - pf)), "other-operation"),
            ("C", array(pf + turned(world, angle, c - pf)), "world-axis"),
            ("C", array(turned(axis, angle, c)), "through-origin"),
            ("n", array(turned(axis, -angle, n)), "opposite-angle"),
            ("n", array(n), "not-done"),
            ("u", array(p.view_up.cross(turned(axis, angle, n)).normalize()), "not-done"),
        ],
        Operation::Yaw(_) | Operation::Pitch(_) => vec![
            ("PF", array(pf), "not-done"),
            ("PF", array(c + turned(axis, -angle, pf - c)), "opposite-angle"),
            ("PF", array(c + turned(other, angle, pf - c)), "as-printed"),
            ("PF", array(c + turned(world, angle, pf - c)), "world-axis"),
            ("PF", array(turned(axis, angle, pf)), "through-origin"),
        ],
        _ => vec![
            ("u", array(u), "not-done"),
            ("u", array(turned(n, -angle, u)), "opposite-angle"),
            ("v", array(turned(n, -angle, v)), "opposite-angle"),
        ],
    }
}

fn of_other_operations(exercise: &Exercise) -> Vec<Wrong> {
    let p = &exercise.subject.figure.camera;
    let ([u, v, _], size) = (axes(p), window(p));
    let (c, pf) = (p.position, p.focal_point);
    match exercise.subject.operations[0] {
        Operation::Zoom(s) => {
            let mut wrong = vec![("H", vec![size.y], "not-done"), ("H", vec![size.y * s], "inverse")];
            if p.projection == Projection::Perspective && p.view_angle / s < 180.0 {
                wrong.push(("theta", vec![p.view_angle / s], "zoom-on-angle"));
                let half = (p.view_angle / 2.0).to_radians().tan() / s;
                wrong.push(("theta", vec![2.0 * half.atan()], "radians"));
            }
            wrong
        }
        Operation::Dolly(f) => vec![
            ("C", array(c), "not-done"),
            ("C", array(c / f), "through-origin"),
            ("C", array(pf + (c - pf) * f), "inverse"),
        ],
        Operation::Pan { dx, dy } => vec![
            ("C", array(c), "not-done"),
            ("C", array(c + DVec3::new(dx, dy, 0.0)), "view-as-world"),
            ("C", array(c - u * dx + v * dy), "u-reversed"),
            ("C", array(c + u * dx - v * dy), "v-reversed"),
            ("PF", array(pf - u * dx - v * dy), "opposite-angle"),
            ("PF", array(pf), "not-done"),
        ],
        _ => Vec::new(),
    }
}

fn wrong_answers(id: &str, exercise: &Exercise) -> Vec<Wrong> {
    let p = &exercise.subject.figure.camera;
    match id {
        "basis" => of_axes(p),
        "view-matrix" => of_view(p),
        "window" => of_window(p),
        "perspective-matrix" => of_perspective(p),
        "parallel-matrix" => of_parallel(p),
        "ndc" => of_point(p, exercise.subject.points[0]),
        "pixel" => of_pixel(exercise),
        "ray" => of_ray(exercise),
        "viewport" => of_viewport(exercise),
        "elevation" | "azimuth" | "roll" | "yaw" | "pitch" => of_turn(exercise),
        _ => of_other_operations(exercise),
    }
}

const FAMILIES: [&str; 17] = [
    "basis",
    "view-matrix",
    "window",
    "perspective-matrix",
    "parallel-matrix",
    "ndc",
    "pixel",
    "ray",
    "viewport",
    "elevation",
    "azimuth",
    "roll",
    "yaw",
    "pitch",
    "zoom",
    "dolly",
    "pan",
];

/// Six digits, as a calculator shows them.
pub(super) fn typed(numbers: &[f64], [rows, columns]: [usize; 2]) -> String {
    let list = |numbers: &[f64]| {
        let texts: Vec<String> = numbers.iter().map(|x| format!("{x:.5e}")).collect();
        if texts.len() == 1 { texts.concat() } else { format!("[{}]", texts.join(", ")) }
    };
    if columns == 1 || rows == 1 {
        return list(numbers);
    }
    format!("[{}]", numbers.chunks(columns).map(list).collect::<Vec<_>>().join(", "))
}

/// The verdicts on wrong answers: their number, and how many name the mistake alone, as one of several, or not at all,
/// with the answers that are right by chance.
#[derive(Default)]
pub(super) struct Counts {
    pub(super) all: u32,
    first: u32,
    either: u32,
    none: BTreeMap<(&'static str, &'static str, &'static str), u32>,
    same: BTreeMap<(&'static str, &'static str, &'static str), u32>,
}

impl Counts {
    /// Judges the wrong answers to one exercise.
    pub(super) fn judge(&mut self, id: &'static str, exercise: &Exercise, wrong: Vec<Wrong>) {
        for (name, numbers, code) in wrong {
            let Some(ask) = exercise.asks.iter().find(|ask| ask.name == name) else { continue };
            let judged = check(entry(id).unwrap(), exercise, ask, &typed(&numbers, ask.shape())).unwrap();
            let context = format!("{id} {} {name} {code}: {:?}", exercise.seed, judged.diagnosis);
            // By chance it is the right number there.
            if judged.right {
                *self.same.entry((id, name, code)).or_default() += 1;
                continue;
            }
            self.all += 1;
            let Some(diagnosis) = &judged.diagnosis else {
                *self.none.entry((id, name, code)).or_default() += 1;
                continue;
            };
            assert!(diagnosis.mistakes().any(|told| told.code() == code), "{context}");
            assert!(diagnosis.causes.len() == 1, "{context}");
            if diagnosis.others.is_empty() { self.first += 1 } else { self.either += 1 }
        }
    }

    /// Most are named alone, few are right by chance, and none goes unnamed.
    pub(super) fn hold(&self) {
        let Self { all, first, either, none, same } = self;
        assert!(none.is_empty(), "{none:?}");
        // A point that did not move was left alone, or turned about itself: always one of two.
        assert!(*first > 4 * either, "{first} alone, {either} as one of several");
        assert!(same.values().sum::<u32>() < all / 10, "{same:?}");
    }
}

#[test]
fn the_first_reason_is_the_one_that_was_made() {
    const SEEDS: u64 = 110;
    let mut counts = Counts::default();
    for id in FAMILIES {
        for seed in 0..SEEDS {
            let exercise = exercise(id, seed);
            counts.judge(id, &exercise, wrong_answers(id, &exercise));
        }
    }
    counts.hold();
    assert!(counts.all > 10_000, "{}", counts.all);
}
