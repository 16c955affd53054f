//! Mistakes made by hand in questions beside a camera's matrices, from the numbers of the statements alone: windows
//! that are not symmetric, clip space, other vocabularies, products of transforms, depth.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use camera_lab::camera::Projection;
use camera_lab::exercises::{Exercise, Fact};
use glam::{DMat4, DVec3, DVec4};

use super::exercise_slips::{Counts, Wrong};
use super::exercise_verdicts::exercise;

/// A number of the statement.
pub(super) fn number(exercise: &Exercise, name: &str) -> f64 {
    match exercise.facts.iter().rev().find(|(fact, _)| *fact == name) {
        Some((_, Fact::Number(value) | Fact::Angle(value))) => *value,
        other => panic!("{name}: {other:?}"),
    }
}

/// A point or a vector of the statement.
pub(super) fn tuple(exercise: &Exercise, name: &str) -> Vec<f64> {
    match exercise.facts.iter().rev().find(|(fact, _)| *fact == name) {
        Some((_, Fact::Tuple(values))) => values.clone(),
        other => panic!("{name}: {other:?}"),
    }
}

fn array(v: DVec3) -> Vec<f64> {
    v.to_array().to_vec()
}

fn of_asymmetric_window(exercise: &Exercise) -> Vec<Wrong> {
    let [l, r, b, t, f, far] = ["l", "r", "b", "t", "F", "B"].map(|name| number(exercise, name));
    let (width, height, range) = (r - l, t - b, far - f);
    let in_perspective = exercise.subject.figure.camera.projection == Projection::Perspective;
    let matrix = |scale: f64, sign: f64, offset: f64, [z, last]: [f64; 2]| {
        let [x, y] = [offset * (r + l) / width, offset * (t + b) / height];
        if in_perspective {
            let rows = [[scale / width, 0.0, x, 0.0], [0.0, scale / height, y, 0.0], [0.0, 0.0, z, last]];
            [rows.concat(), vec![0.0, 0.0, -sign, 0.0]].concat()
        } else {
            let rows = [[scale / width, 0.0, 0.0, -x], [0.0, scale / height, 0.0, -y], [0.0, 0.0, z, last]];
            [rows.concat(), vec![0.0, 0.0, 0.0, sign]].concat()
        }
    };
    if in_perspective {
        let depth = [-(far + f) / range, -2.0 * far * f / range];
        return vec![
            ("Mp", matrix(f, 1.0, 1.0, depth), "factor-two"),
            ("Mp", matrix(2.0, 1.0, 1.0, depth), "near-forgotten"),
            ("Mp", matrix(2.0 * f, -1.0, 1.0, depth), "z-sign"),
            ("Mp", matrix(2.0 * f, 1.0, -1.0, depth), "sign"),
            ("Mp", matrix(2.0 * f, 1.0, 1.0, [-far / range, -far * f / range]), "z-range"),
            ("Mp", matrix(2.0 * f, 1.0, 1.0, [depth[0], depth[1] / 2.0]), "factor-two"),
        ];
    }
    let depth = [-2.0 / range, -(far + f) / range];
    vec![
        ("Mp", matrix(1.0, 1.0, 1.0, depth), "factor-two"),
        ("Mp", matrix(2.0, 0.0, 1.0, depth), "as-printed"),
        ("Mp", matrix(2.0, 1.0, -1.0, depth), "sign"),
        ("Mp", matrix(2.0, 1.0, 1.0, [-1.0 / range, -f / range]), "z-range"),
    ]
}

/// Distances inside the planes of `[2]`, with `w` and the plane of the front taken as given.
fn inside([x, y, z, w]: [f64; 4], front: f64) -> [f64; 6] {
    [w + x, w - x, w + y, w - y, front + z, w - z]
}

/// t at which a segment enters, and t at which it leaves. `None` if nothing of it is inside.
fn cut(a: [f64; 6], b: [f64; 6]) -> Option<[f64; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (at_a, at_b) in a.into_iter().zip(b) {
        match (at_a < 0.0, at_b < 0.0) {
            (true, true) => return None,
            (true, false) => from = from.max(at_a / (at_a - at_b)),
            (false, true) => to = to.min(at_a / (at_a - at_b)),
            (false, false) => {}
        }
    }
    (from < to).then_some([from, to])
}

fn clip_points(exercise: &Exercise) -> [[f64; 4]; 2] {
    ["A", "B"].map(|name| tuple(exercise, name).try_into().unwrap())
}

fn of_segment(exercise: &Exercise) -> Vec<Wrong> {
    let [a, b] = clip_points(exercise);
    let [t_in, t_out] = cut(inside(a, a[3]), inside(b, b[3])).unwrap();
    let at = |t: f64| {
        let [a, b] = [a, b].map(DVec4::from_array);
        (a + (b - a) * t).to_array().to_vec()
    };
    let mut wrong = vec![
        ("t_in", vec![t_out], "entry-exit-exchanged"),
        ("t_out", vec![t_in], "entry-exit-exchanged"),
        ("t_in", vec![1.0 - t_out], "order-reversed"),
        ("t_out", vec![1.0 - t_in], "order-reversed"),
        ("P", at(t_out), "entry-exit-exchanged"),
    ];
    let divided = |p: [f64; 4]| inside([p[0] / p[3], p[1] / p[3], p[2] / p[3], 1.0], 1.0);
    let with_1 = |p: [f64; 4]| inside([p[0], p[1], p[2], 1.0], 1.0);
    let others = [
        (cut(divided(a), divided(b)), "clip-after-divide"),
        (cut(with_1(a), with_1(b)), "no-divide"),
        (cut(inside(a, 0.0), inside(b, 0.0)), "z-range"),
    ];
    for (found, code) in others {
        if let Some([t_in, t_out]) = found {
            wrong.extend([("t_in", vec![t_in], code), ("t_out", vec![t_out], code)]);
        }
    }
    wrong
}

fn of_outcodes(exercise: &Exercise) -> Vec<Wrong> {
    let bits = |distances: [f64; 6]| distances.map(|d| f64::from(u8::from(d < 0.0))).to_vec();
    let mut wrong = Vec::new();
    for (name, p) in ["A", "B"].into_iter().zip(clip_points(exercise)) {
        let right = bits(inside(p, p[3]));
        wrong.extend([
            (name, bits(inside([p[0], p[1], p[2], 1.0], 1.0)), "no-divide"),
            (name, bits(inside(p, 0.0)), "z-range"),
            (name, bits(inside([p[0], p[1], -p[2], p[3]], p[3])), "z-sign"),
            (name, [1, 0, 3, 2, 5, 4].iter().map(|k| right[*k]).collect(), "order-reversed"),
            (name, [1, 0, 3, 2, 4, 5].iter().map(|k| right[*k]).collect(), "order-reversed"),
        ]);
    }
    wrong
}

fn of_painter(exercise: &Exercise) -> Vec<Wrong> {
    let [c, pf] = ["C", "PF"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
    let points = ["P1", "P2", "P3", "P4"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
    let n = (c - pf).normalize();
    let depths = points.map(|p| n.dot(c - p));
    let distances = points.map(|p| (p - c).length());
    let order = |depths: [f64; 4]| {
        let mut order = [0, 1, 2, 3];
        order.sort_by(|a, b| f64::total_cmp(&depths[*b], &depths[*a]));
        order.map(|k: usize| [1.0, 2.0, 3.0, 4.0][k])
    };
    let right = order(depths);
    let ranks = [1.0, 2.0, 3.0, 4.0].map(|thing| {
        let place = right.iter().position(|at| *at == thing).unwrap();
        [1.0, 2.0, 3.0, 4.0][place]
    });
    vec![
        ("depths", depths.map(|d| -d).to_vec(), "z-sign"),
        ("depths", distances.to_vec(), "distance-for-depth"),
        ("order", right.iter().rev().copied().collect(), "order-reversed"),
        ("order", order(distances).to_vec(), "distance-for-depth"),
        ("order", ranks.to_vec(), "order-reversed"),
    ]
}

fn of_left_handed(exercise: &Exercise) -> Vec<Wrong> {
    let [vpn, up] = ["VPN", "VUV"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
    let n = vpn.normalize();
    let whole = up - n * n.dot(up);
    let v = whole.normalize();
    let printed = up - vpn * vpn.dot(up);
    vec![
        ("n", array(vpn), "not-normalised"),
        ("n", array(-n), "n-reversed"),
        ("v", array(up), "vup-as-v"),
        ("v", array(up.normalize()), "vup-as-v"),
        ("v", array(whole), "not-normalised"),
        ("v", array(-v), "v-reversed"),
        ("v", array(printed), "as-printed"),
        ("v", array(printed.normalize()), "as-printed"),
        ("u", array(v.cross(n)), "u-reversed"),
    ]
}

fn of_vocabulary(exercise: &Exercise) -> Vec<Wrong> {
    let [theta, aspect, f, m, n] = ["theta", "A", "F", "m", "n"].map(|name| number(exercise, name));
    let half = (theta / 2.0).to_radians().tan();
    let frustum = |top: f64, aspect: f64| vec![-top * aspect, top * aspect, -top, top];
    let top = f * half;
    let right = top * aspect;
    let k = |f: [f64; 2], c: [f64; 2]| [[f[0], 0.0, c[0]], [0.0, f[1], c[1]], [0.0, 0.0, 1.0]].concat();
    let focal = [m * f / (2.0 * right), n * f / (2.0 * top)];
    let centre = [m / 2.0, n / 2.0];
    vec![
        ("frustum", frustum(2.0 * top, aspect), "factor-two"),
        ("frustum", frustum(half, aspect), "near-forgotten"),
        ("frustum", frustum(f * theta.to_radians().tan(), aspect), "whole-angle"),
        ("frustum", frustum(f * (theta / 2.0).tan(), aspect), "radians"),
        ("frustum", frustum(top, 1.0 / aspect), "aspect-inverted"),
        ("frustum", vec![-right, -top, right, top], "order-reversed"),
        ("K", k(focal, [centre[0] - 0.5, centre[1] - 0.5]), "pixel-corner"),
        ("K", k(focal, [centre[1], centre[0]]), "columns-and-rows-exchanged"),
        ("K", k([m * f / (2.0 * top), focal[1]], centre), "aspect-inverted"),
        ("K", k(focal, [0.0, 0.0]), "offset-ignored"),
        ("K", k(focal, [m, n]), "factor-two"),
        ("K", k(focal.map(|x| 2.0 * x), centre), "factor-two"),
        ("K", k(focal.map(|x| x / f), centre), "near-forgotten"),
    ]
}

/// The rotation of `order` about an axis of coordinates.
fn turn(exercise: &Exercise, angle: f64) -> DMat4 {
    let axis = exercise.facts.iter().find_map(|(name, fact)| match fact {
        Fact::Word(word) if *name == "axis" => Some(word.clone()),
        _ => None,
    });
    match axis.unwrap().find('1').unwrap() {
        0 => DMat4::from_rotation_x(angle),
        3 => DMat4::from_rotation_y(angle),
        _ => DMat4::from_rotation_z(angle),
    }
}

fn of_order(exercise: &Exercise) -> Vec<Wrong> {
    let [by, stretch, p] = ["t", "s", "p"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
    let alpha = number(exercise, "alpha");
    let (t, r, s) = (DMat4::from_translation(by), turn(exercise, alpha.to_radians()), DMat4::from_scale(stretch));
    let products = [
        (s * r * t, "order-reversed"),
        (r * t * s, "order-reversed"),
        (t * s * r, "order-reversed"),
        (s * t * r, "order-reversed"),
        (r * s * t, "order-reversed"),
        (t * r.transpose() * s, "opposite-angle"),
        (t * turn(exercise, alpha) * s, "radians"),
    ];
    let tell = |(m, code): (DMat4, &'static str)| {
        [("M", m.transpose().to_cols_array().to_vec(), code), ("P", array(m.transform_point3(p)), code)]
    };
    products.into_iter().flat_map(tell).collect()
}

fn of_depth(exercise: &Exercise) -> Vec<Wrong> {
    let [f, b, d, bits] = ["F", "B", "d", "bits"].map(|name| number(exercise, name));
    let steps = bits.exp2() - 1.0;
    let ndc = (b + f) / (b - f) - 2.0 * b * f / ((b - f) * d);
    let step = (b - f) * d * d / (b * f * steps);
    vec![
        ("Z", vec![ndc], "z-range"),
        ("Z", vec![(d - f) / (b - f)], "projections-exchanged"),
        ("step", vec![1.0 / steps], "not-done"),
        ("step", vec![(b - f) / steps], "projections-exchanged"),
        ("step", vec![step / 2.0], "z-range"),
        ("step", vec![1.0 / step], "inverse"),
    ]
}

fn of_zoom_or_dolly(exercise: &Exercise) -> Vec<Wrong> {
    let [size, e, s, d, theta] = ["h", "e", "s", "D", "theta"].map(|name| number(exercise, name));
    let half = (theta / 2.0).to_radians().tan();
    let share = |d: f64| size / (2.0 * d * half);
    let mut wrong = vec![
        ("before", vec![2.0 * share(d)], "factor-two"),
        ("before", vec![size / (2.0 * d * (theta / 2.0).tan())], "radians"),
        ("zoomed", vec![share(d)], "not-done"),
        ("zoomed", vec![share(d) / s], "inverse"),
        ("zoomed", vec![size / (2.0 * d * (theta / s / 2.0).to_radians().tan())], "zoom-on-angle"),
        ("dollied", vec![share(d) / s], "inverse"),
        ("zoomed_behind", vec![share(d / s + e)], "other-operation"),
        ("dollied_behind", vec![share(d + e) * s], "other-operation"),
    ];
    if theta < 90.0 {
        wrong.push(("before", vec![size / (2.0 * d * theta.to_radians().tan())], "whole-angle"));
    }
    wrong
}

fn of_disparity(exercise: &Exercise) -> Vec<Wrong> {
    let [theta, near, m, n, b] = ["theta", "F", "m", "n", "b"].map(|name| number(exercise, name));
    let [d, meeting, left, right] = ["d", "D", "xl", "xr"].map(|name| number(exercise, name));
    let f = n / (2.0 * (theta / 2.0).to_radians().tan());
    let delta = left - right;
    vec![
        ("f", vec![2.0 * f], "factor-two"),
        ("f", vec![n / (2.0 * theta.to_radians().tan())], "whole-angle"),
        ("f", vec![n / (2.0 * (theta / 2.0).tan())], "radians"),
        ("f", vec![f * m / n], "columns-and-rows-exchanged"),
        ("f", vec![near], "not-done"),
        ("disparity", vec![f * b / (2.0 * d)], "factor-two"),
        ("disparity", vec![f * d / b], "inverse"),
        ("disparity", vec![d / (f * b)], "inverse"),
        ("disparity", vec![-f * b / d], "sign"),
        ("disparity", vec![near * b / d], "not-done"),
        ("disparity", vec![b * m / (2.0 * d * (theta / 2.0).to_radians().tan())], "columns-and-rows-exchanged"),
        ("shifted", vec![f * b / d], "not-done"),
        ("shifted", vec![f * b * (1.0 / meeting - 1.0 / d)], "sign"),
        ("shifted", vec![f * b * (1.0 / d - 1.0 / meeting) / 2.0], "factor-two"),
        ("depth", vec![f * b / (2.0 * delta)], "factor-two"),
        ("depth", vec![f * b / left], "not-done"),
        ("depth", vec![f * b / (left + right)], "sign"),
        ("depth", vec![-f * b / delta], "sign"),
        ("depth", vec![delta / (f * b)], "inverse"),
        ("depth", vec![near * b / delta], "not-done"),
        ("step", vec![f * b / (2.0 * delta * delta)], "factor-two"),
        ("step", vec![delta * delta / (f * b)], "inverse"),
        ("step", vec![f * b / (left * left)], "not-done"),
    ]
}

/// The way from P to lamp 1, and to lamp 2, as the statement tells them.
fn ways(exercise: &Exercise, p: DVec3) -> [DVec3; 2] {
    let vector = |name| DVec3::from_slice(&tuple(exercise, name));
    let [near, far] = [vector("S") - p, -vector("d")];
    let is_near = exercise.facts.iter().any(|(_, fact)| matches!(fact, Fact::Text("lamps-near-far")));
    if is_near { [near, far] } else { [far, near] }
}

fn of_light(exercise: &Exercise) -> Vec<Wrong> {
    let [p, given, c] = ["P", "N", "C"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
    let [ka, kd, ks, m] = ["ka", "kd", "ks", "exponent"].map(|name| number(exercise, name));
    let [way, behind] = ways(exercise, p);
    let (n, l, v) = (given.normalize(), way.normalize(), (c - p).normalize());
    let (cosine, second) = (n.dot(l), n.dot(behind.normalize()));
    let h = (l + v).normalize();
    let from_origin = (ways(exercise, DVec3::ZERO)[0].normalize() + c.normalize()).normalize();
    // Phong's angle, by turning the way to the lamp half round the normal.
    let reflected = glam::DQuat::from_axis_angle(n, std::f64::consts::PI) * l;
    let share = |light: f64| vec![ka + kd * light];
    let white = |cosine: f64| vec![ks * cosine.powf(m)];
    let right = [
        ("L", array(l)),
        ("cosine", vec![cosine]),
        ("share", share(cosine)),
        ("H", array(h)),
        ("highlight", white(n.dot(h))),
    ];
    for (name, numbers) in right {
        let table = exercise.asks.iter().find(|ask| ask.name == name).unwrap().expected().table().unwrap();
        let apart = table.entries.iter().zip(&numbers).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-12 && table.entries.len() == numbers.len(), "{} {name}: {apart}", exercise.seed);
    }
    let mut wrong = vec![
        ("L", array(way), "not-normalised"),
        ("L", array(-l), "sign"),
        ("L", array(v), "view-for-light"),
        ("cosine", vec![given.dot(l)], "not-normalised"),
        ("cosine", vec![n.dot(way)], "not-normalised"),
        ("cosine", vec![-cosine], "sign"),
        ("cosine", vec![n.dot(v)], "view-for-light"),
        ("cosine", vec![cosine.acos().to_degrees()], "angle-for-cosine"),
        ("cosine", vec![1.0 - cosine.acos() / std::f64::consts::FRAC_PI_2], "angle-for-cosine"),
        ("share", share(given.dot(l)), "not-normalised"),
        ("share", share(cosine + second), "negative-light"),
        ("share", share(1.0 - cosine.acos() / std::f64::consts::FRAC_PI_2), "angle-for-cosine"),
        ("share", share(n.dot(v)), "view-for-light"),
        ("share", vec![kd * cosine], "share-forgotten"),
        ("share", vec![ka + cosine], "share-forgotten"),
        ("H", array(l + v), "not-normalised"),
        ("H", array((l + v) / 2.0), "not-normalised"),
        ("H", array(from_origin), "position-forgotten"),
        ("H", array(v), "view-for-light"),
        ("highlight", vec![n.dot(h).powf(m)], "share-forgotten"),
        ("highlight", vec![ks * n.dot(h)], "exponent-forgotten"),
        ("highlight", white(n.dot(l)), "halfway-forgotten"),
        ("highlight", white(n.dot(l + v)), "not-normalised"),
        ("highlight", white(n.dot(l + v) / 2.0), "not-normalised"),
        ("highlight", white(given.dot(h)), "not-normalised"),
    ];
    if reflected.dot(v) > 0.0 {
        wrong.push(("highlight", white(reflected.dot(v)), "halfway-forgotten"));
    }
    wrong
}

/// Wrong answers to an exercise.
type WrongAnswers = fn(&Exercise) -> Vec<Wrong>;

const FAMILIES: [(&str, WrongAnswers); 11] = [
    ("asymmetric-window", of_asymmetric_window),
    ("clip-segment", of_segment),
    ("outcodes", of_outcodes),
    ("painter", of_painter),
    ("left-handed", of_left_handed),
    ("vocabulary", of_vocabulary),
    ("order", of_order),
    ("depth-resolution", of_depth),
    ("zoom-or-dolly", of_zoom_or_dolly),
    ("light", of_light),
    ("disparity", of_disparity),
];

#[test]
fn the_first_reason_is_the_one_that_was_made_beside_cameras() {
    const SEEDS: u64 = 60;
    let mut counts = Counts::default();
    for (id, wrong_answers) in FAMILIES {
        for seed in 0..SEEDS {
            let exercise = exercise(id, seed);
            counts.judge(id, &exercise, wrong_answers(&exercise));
        }
    }
    counts.hold();
    assert!(counts.all > 3_000, "{}", counts.all);
}
