//! Mistakes that a teacher would name at once, made by hand from the statements: each verdict names the mistake and the
//! way of making it, beside others that give the same.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use camera_lab::camera::{Operation, Parameters, Projection};
use camera_lab::exercises::Exercise;
use glam::{DMat4, DQuat, DVec3, DVec4};

use super::exercise_slips::typed;
use super::exercise_slips_others::{number, tuple};
use super::exercise_verdicts::{exercise, right, together};

/// The axes as (5.3) has them.
fn axes(p: &Parameters) -> [DVec3; 3] {
    let n = (p.position - p.focal_point).normalize();
    let u = p.view_up.cross(n).normalize();
    [u, n.cross(u), n]
}

fn array(v: DVec3) -> Vec<f64> {
    v.to_array().to_vec()
}

/// W and H.
fn window(p: &Parameters) -> [f64; 2] {
    let height = match p.projection {
        Projection::Perspective => 2.0 * p.near * (p.view_angle / 2.0).to_radians().tan(),
        Projection::Parallel => p.height,
    };
    [height * p.aspect, height]
}

fn is_in_perspective(p: &Parameters) -> bool {
    p.projection == Projection::Perspective
}

/// Asserts that the verdict names the mistake for every seed whose wrong answer isn't right by coincidence, and this
/// way of making it for some.
fn named(id: &str, name: &str, (code, variant): (&str, &str), wrong: impl Fn(&Exercise) -> Option<Vec<f64>>) {
    let (mut count, mut told) = (0, 0);
    for seed in (0..12).chain(60..84) {
        let exercise = exercise(id, seed);
        let Some(answer) = wrong(&exercise) else { continue };
        let shape = exercise.asks.iter().find(|ask| ask.name == name).unwrap().shape();
        let answer = typed(&answer, shape);
        let judged = together(id, seed, &[(name, answer.clone())]).remove(0);
        if judged.right {
            continue;
        }
        let context = format!("{id} {seed} {name} = {answer}: {:?} without {code}/{variant}", judged.diagnosis);
        let diagnosis = judged.diagnosis.unwrap_or_else(|| panic!("{context}"));
        assert!(diagnosis.mistakes().any(|mistake| mistake.code() == code), "{context}");
        let mut causes = diagnosis.causes.iter().chain(&diagnosis.others);
        told += u32::from(causes.any(|cause| cause.mistake.code() == code && cause.variant == variant));
        count += 1;
    }
    assert!(count >= 5, "{id} {name} {code}/{variant}: {count}");
    assert!(told > 0, "{id} {name} {code}/{variant} is never told");
}

/// The same for an exercise of the notes, which has one set of numbers.
fn named_once(id: &str, name: &str, (code, variant): (&str, &str), answer: &[f64]) {
    let exercise = exercise(id, 0);
    let shape = exercise.asks.iter().find(|ask| ask.name == name).unwrap().shape();
    let judged = together(id, 0, &[(name, typed(answer, shape))]).remove(0);
    let diagnosis = judged.diagnosis.unwrap_or_else(|| panic!("{id} {name} {code}/{variant}"));
    let mut causes = diagnosis.causes.iter().chain(&diagnosis.others);
    assert!(
        causes.any(|cause| cause.mistake.code() == code && cause.variant == variant),
        "{id} {name}: {diagnosis:?} without {code}/{variant}"
    );
}

#[test]
fn axes_in_each_others_place_are_named() {
    let of = |exercise: &Exercise| axes(&exercise.subject.figure.camera);
    named("basis", "u", ("order-reversed", "axes"), |exercise| Some(array(of(exercise)[1])));
    named("basis", "v", ("order-reversed", "axes"), |exercise| Some(array(of(exercise)[0])));
    named("basis", "n", ("not-done", "focal-point"), |exercise| {
        Some(array(exercise.subject.figure.camera.position.normalize()))
    });
    named("view-matrix", "Mv", ("order-reversed", "rows-reversed"), |exercise| {
        let ([u, v, n], c) = (of(exercise), exercise.subject.figure.camera.position);
        let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(c)];
        Some([row(n), row(v), row(u), [0.0, 0.0, 0.0, 1.0]].concat())
    });
    let pan = |exercise: &Exercise| match exercise.subject.operations[0] {
        Operation::Pan { dx, dy } => (dx, dy),
        other => panic!("{other:?}"),
    };
    for (name, is_eye) in [("C", true), ("PF", false)] {
        let start = move |exercise: &Exercise| {
            let p = &exercise.subject.figure.camera;
            if is_eye { p.position } else { p.focal_point }
        };
        named("pan", name, ("order-reversed", "axes"), |exercise| {
            let ([u, v, _], (dx, dy)) = (of(exercise), pan(exercise));
            (dx != dy).then(|| array(start(exercise) + v * dx + u * dy))
        });
        named("pan", name, ("vup-as-v", ""), |exercise| {
            let ([u, ..], (dx, dy)) = (of(exercise), pan(exercise));
            Some(array(start(exercise) + u * dx + exercise.subject.figure.camera.view_up * dy))
        });
        named("pan", name, ("vup-as-v", ""), |exercise| {
            let ([u, ..], (dx, dy)) = (of(exercise), pan(exercise));
            Some(array(start(exercise) + u * dx + exercise.subject.figure.camera.view_up.normalize() * dy))
        });
    }
}

fn rows(x: [f64; 4], y: [f64; 4], z: [f64; 4], w: [f64; 4]) -> Vec<f64> {
    [x, y, z, w].concat()
}

#[test]
fn windows_to_one_side_have_their_mistakes() {
    let matrix = |exercise: &Exercise, size: [f64; 2], middle: [f64; 2], in_other: bool| {
        let [f, far] = ["F", "B"].map(|name| number(exercise, name));
        let in_perspective = is_in_perspective(&exercise.subject.figure.camera);
        let [x, y] = size.map(|size| if in_perspective { 2.0 * f / size } else { 2.0 / size });
        let [a, b] = middle.map(|middle| if in_perspective { middle } else { -middle });
        let (z, w) = if in_perspective {
            ([0.0, 0.0, -(far + f) / (far - f), -2.0 * far * f / (far - f)], [0.0, 0.0, -1.0, 0.0])
        } else {
            ([0.0, 0.0, -2.0 / (far - f), -(far + f) / (far - f)], [0.0, 0.0, 0.0, 1.0])
        };
        if in_perspective == in_other {
            rows([x, 0.0, 0.0, a], [0.0, y, 0.0, b], z, w)
        } else {
            rows([x, 0.0, a, 0.0], [0.0, y, b, 0.0], z, w)
        }
    };
    let sides = |exercise: &Exercise| ["l", "r", "b", "t"].map(|name| number(exercise, name));
    /// The matrix of a mistake, from the sizes of the window and the sums of its sides.
    type Wrong<'a> = &'a dyn Fn(&Exercise, [f64; 2], [f64; 2]) -> Vec<f64>;
    let named = |cause, wrong: Wrong<'_>| {
        named("asymmetric-window", "Mp", cause, |exercise| {
            let [l, r, b, t] = sides(exercise);
            Some(wrong(exercise, [r - l, t - b], [r + l, t + b]))
        });
    };
    let share = |sum: [f64; 2], size: [f64; 2]| [sum[0] / size[0], sum[1] / size[1]];
    named(("not-done", "middle"), &|exercise, size, _| matrix(exercise, size, [0.0; 2], false));
    named(("not-done", "middle-divided"), &|exercise, size, sum| matrix(exercise, size, sum, false));
    named(("projections-exchanged", "middle"), &|exercise, size, sum| matrix(exercise, size, share(sum, size), true));
    named(("sign", "sides"), &|exercise, size, sum| matrix(exercise, sum, share(sum, size), false));
    named(("sign", "sides"), &|exercise, _, sum| matrix(exercise, sum, [1.0; 2], false));
}

#[test]
fn rows_of_the_other_projection_are_named() {
    let numbers = |exercise: &Exercise| {
        let p = &exercise.subject.figure.camera;
        let ([w, h], f, b) = (window(p), p.near, p.far);
        let along = if is_in_perspective(p) { f } else { 1.0 };
        let perspective = [[0.0, 0.0, -(b + f) / (b - f), -2.0 * b * f / (b - f)], [0.0, 0.0, -1.0, 0.0]];
        let parallel = [[0.0, 0.0, -2.0 / (b - f), -(b + f) / (b - f)], [0.0, 0.0, 0.0, 1.0]];
        let both = if is_in_perspective(p) { [perspective, parallel] } else { [parallel, perspective] };
        ([2.0 * along / w, 2.0 * along / h], both, (f, b, w, h))
    };
    let with = |[x, y]: [f64; 2], z, w| Some(rows([x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], z, w));
    for id in ["perspective-matrix", "parallel-matrix"] {
        named(id, "Mp", ("projections-exchanged", "depth-row"), |exercise| {
            let (scale, [own, other], _) = numbers(exercise);
            with(scale, other[0], own[1])
        });
        named(id, "Mp", ("projections-exchanged", "last-rows"), |exercise| {
            let (scale, [_, other], _) = numbers(exercise);
            with(scale, other[0], other[1])
        });
        named(id, "Mp", ("order-reversed", "last-rows"), |exercise| {
            let (scale, [own, _], _) = numbers(exercise);
            with(scale, own[1], own[0])
        });
        named(id, "Mp", ("aspect-inverted", "other"), |exercise| {
            let ([x, y], [own, _], _) = numbers(exercise);
            with([y, x], own[0], own[1])
        });
    }
    named("parallel-matrix", "Mp", ("inverse", "scale"), |exercise| {
        let (_, [own, _], (_, _, w, h)) = numbers(exercise);
        with([w / 2.0, h / 2.0], own[0], own[1])
    });
    named("parallel-matrix", "Mp", ("order-reversed", "shift"), |exercise| {
        let (scale, [own, _], (f, b, ..)) = numbers(exercise);
        with(scale, [0.0, 0.0, own[0][2], f64::midpoint(f, b)], own[1])
    });
}

/// A point in the VRC.
fn seen(p: &Parameters, point: DVec3) -> DVec3 {
    DVec3::from_array(axes(p).map(|axis| axis.dot(point - p.position)))
}

#[test]
fn points_on_their_way_have_their_mistakes() {
    let at = |exercise: &Exercise| seen(&exercise.subject.figure.camera, exercise.subject.points[0]);
    let projected = |exercise: &Exercise, depth: f64| {
        let p = &exercise.subject.figure.camera;
        at(exercise).truncate() * p.near / depth
    };
    let in_image = |exercise: &Exercise, [x, y]: [f64; 2], with_middle: bool| {
        let [w, h] = window(&exercise.subject.figure.camera);
        let image = exercise.subject.figure.image;
        let half = if with_middle { 0.5 } else { 0.0 };
        vec![(f64::from(image.width) * (x / w + half)).floor(), (f64::from(image.height) * (half - y / h)).floor()]
    };
    named("pixel", "window", ("distance-for-depth", ""), |exercise| {
        is_in_perspective(&exercise.subject.figure.camera)
            .then(|| projected(exercise, at(exercise).length()).to_array().to_vec())
    });
    named("pixel", "pixel", ("offset-ignored", "middle"), |exercise| {
        let (p, place) = (&exercise.subject.figure.camera, at(exercise));
        let place = if is_in_perspective(p) { projected(exercise, -place.z) } else { place.truncate() };
        Some(in_image(exercise, place.to_array(), false))
    });
    let (ndc, clip) = (
        |exercise: &Exercise| right("ndc", exercise.seed, "ndc"),
        |exercise: &Exercise| right("ndc", exercise.seed, "clip"),
    );
    named("ndc", "ndc", ("projections-exchanged", "depth"), |exercise| {
        let (p, ndc) = (&exercise.subject.figure.camera, ndc(exercise));
        let z = 2.0 * (-at(exercise).z - p.near) / (p.far - p.near) - 1.0;
        is_in_perspective(p).then(|| vec![ndc[0], ndc[1], z])
    });
    named("ndc", "ndc", ("no-divide", "depth"), |exercise| {
        let ndc = ndc(exercise);
        is_in_perspective(&exercise.subject.figure.camera).then(|| vec![ndc[0], ndc[1], clip(exercise)[2]])
    });
    named("ndc", "ndc", ("not-done", "scale"), |exercise| {
        let ([w, h], ndc) = (window(&exercise.subject.figure.camera), ndc(exercise));
        Some(vec![ndc[0] * w / 2.0, ndc[1] * h / 2.0, ndc[2]])
    });
    named("viewport", "viewport", ("factor-two", "viewport"), |exercise| {
        let (ndc, port) = (right("viewport", exercise.seed, "ndc"), exercise.subject.figure.viewport.unwrap());
        let along = |start: i32, size: u32, n: f64| (f64::from(size) * (n + 1.0)).floor() + f64::from(start);
        let z = right("viewport", exercise.seed, "viewport")[2];
        Some(vec![along(port.x, port.width, ndc[0]), along(port.y, port.height, ndc[1]), z])
    });
}

#[test]
fn rays_from_the_origin_are_named() {
    let on_window = |exercise: &Exercise| {
        let (p, image) = (&exercise.subject.figure.camera, exercise.subject.figure.image);
        let [i, j] = ["i", "j"].map(|name| number(exercise, name));
        let [w, h] = window(p);
        [w * ((i + 0.5) / f64::from(image.width) - 0.5), h * (0.5 - (j + 0.5) / f64::from(image.height))]
    };
    named("ray", "direction", ("position-forgotten", "ray"), |exercise| {
        let (p, [x, y]) = (&exercise.subject.figure.camera, on_window(exercise));
        let [u, v, n] = axes(p);
        is_in_perspective(p).then(|| array((p.position + u * x + v * y - n * p.near).normalize()))
    });
    named("ray", "direction", ("view-as-world", "minus-eye"), |exercise| {
        let (p, [x, y]) = (&exercise.subject.figure.camera, on_window(exercise));
        is_in_perspective(p).then(|| array((DVec3::new(x, y, -p.near) - p.position).normalize()))
    });
    named("ray", "direction", ("order-reversed", "axes"), |exercise| {
        let (p, [x, y]) = (&exercise.subject.figure.camera, on_window(exercise));
        let [u, v, n] = axes(p);
        is_in_perspective(p).then(|| array((v * x + u * y - n * p.near).normalize()))
    });
    named("ray", "origin", ("position-forgotten", "eye"), |exercise| {
        let (p, [x, y]) = (&exercise.subject.figure.camera, on_window(exercise));
        let [u, v, _] = axes(p);
        (!is_in_perspective(p)).then(|| array(u * x + v * y))
    });
    // 5.1: C = (3, 4, 0), and u and v as the camera has them.
    let c = DVec3::new(3.0, 4.0, 0.0);
    let (n, v) = (DVec3::new(0.6, 0.8, 0.0), DVec3::new(-0.8, 0.6, 0.0));
    let u = DVec3::Y.cross(n).normalize();
    let vrc = DVec3::new(1.0, 1.0, 0.0);
    named_once("0-5.1", "perspective_direction", ("view-as-world", "minus-eye"), &array((vrc - c).normalize()));
    named_once("0-5.1", "perspective_direction", ("position-forgotten", "ray"), &array((c + u + v).normalize()));
}

#[test]
fn operations_have_their_mistakes() {
    for (id, name, about_u, moves_c) in [
        ("elevation", "C", true, true),
        ("azimuth", "C", false, true),
        ("yaw", "PF", false, false),
        ("pitch", "PF", true, false),
    ] {
        let turned = |exercise: &Exercise| {
            let p = &exercise.subject.figure.camera;
            let [u, v, _] = axes(p);
            let angle = exercise.subject.operations[0].angle().unwrap().degrees().to_radians();
            let (fixed, moved) = if moves_c { (p.focal_point, p.position) } else { (p.position, p.focal_point) };
            (fixed, DQuat::from_axis_angle(if about_u { u } else { v }, angle) * (moved - fixed))
        };
        named(id, name, ("not-done", "back"), |exercise| Some(array(turned(exercise).1)));
        named(id, name, ("not-done", "distance"), |exercise| {
            let (fixed, to) = turned(exercise);
            Some(array(fixed + to.normalize()))
        });
        named(id, name, ("order-reversed", "sine"), |exercise| {
            let p = &exercise.subject.figure.camera;
            let [u, v, _] = axes(p);
            let angle = 90.0 - exercise.subject.operations[0].angle().unwrap().degrees();
            let (fixed, moved) = if moves_c { (p.focal_point, p.position) } else { (p.position, p.focal_point) };
            let turn = DQuat::from_axis_angle(if about_u { u } else { v }, angle.to_radians());
            Some(array(fixed + turn * (moved - fixed)))
        });
    }
    let dolly = |exercise: &Exercise| match exercise.subject.operations[0] {
        Operation::Dolly(factor) => factor,
        other => panic!("{other:?}"),
    };
    named("dolly", "C", ("wrong-point", "way"), |exercise| {
        let (p, f) = (&exercise.subject.figure.camera, dolly(exercise));
        (f > 1.0).then(|| array(p.position + (p.focal_point - p.position) / f))
    });
    named("dolly", "D", ("wrong-point", "way"), |exercise| {
        let (p, f) = (&exercise.subject.figure.camera, dolly(exercise));
        let d = (p.position - p.focal_point).length();
        (f > 1.0).then(|| vec![d - d / f])
    });
    let theta = |exercise: &Exercise, of: fn(f64) -> f64| {
        let p = &exercise.subject.figure.camera;
        let Operation::Zoom(s) = exercise.subject.operations[0] else { panic!() };
        // H'/F
        let ratio = 2.0 * (p.view_angle / 2.0).to_radians().tan() / s;
        is_in_perspective(p).then(|| vec![of(ratio).to_degrees()])
    };
    named("zoom", "theta", ("factor-two", "half-angle"), |exercise| theta(exercise, |ratio| (ratio / 2.0).atan()));
    named("zoom", "theta", ("whole-angle", "height"), |exercise| theta(exercise, f64::atan));
}

#[test]
fn segments_products_and_light_have_their_mistakes() {
    let ends = |exercise: &Exercise| {
        ["A", "B"].map(|name| {
            let p = DVec4::from_slice(&tuple(exercise, name));
            [p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.w + p.z, p.w - p.z]
        })
    };
    for (name, enters) in [("t_in", true), ("t_out", false)] {
        named("clip-segment", name, ("sign", "cut"), |exercise| {
            let [a, b] = ends(exercise);
            let mut cuts: Vec<(f64, f64)> = a
                .into_iter()
                .zip(b)
                .filter(|(a, b)| if enters { *a < 0.0 } else { *a >= 0.0 && *b < 0.0 })
                .map(|(a, b)| (a / (a - b), a / (a + b)))
                .collect();
            cuts.sort_by(|one, other| one.0.total_cmp(&other.0));
            let found = if enters { cuts.last() } else { cuts.first() };
            found.map(|cut| vec![cut.1]).filter(|t| t[0].is_finite())
        });
    }
    named("outcodes", "A", ("order-reversed", "planes"), |exercise| {
        let bits = ends(exercise)[0].map(|d| f64::from(u8::from(d < 0.0)));
        Some([0, 2, 4, 1, 3, 5].map(|k: usize| bits[k]).to_vec())
    });
    let factors = |exercise: &Exercise| {
        let [by, stretch] = ["t", "s"].map(|name| DVec3::from_slice(&tuple(exercise, name)));
        let whole = DMat4::from_cols_slice(&right("order", exercise.seed, "M")).transpose();
        let (t, s) = (DMat4::from_translation(by), DMat4::from_scale(stretch));
        (t, t.inverse() * whole * s.inverse(), s)
    };
    let flat = |m: DMat4| Some(m.transpose().to_cols_array().to_vec());
    named("order", "M", ("not-done", "without-t"), |exercise| {
        let (_, r, s) = factors(exercise);
        flat(r * s)
    });
    named("order", "M", ("not-done", "without-r"), |exercise| {
        let (t, _, s) = factors(exercise);
        flat(t * s)
    });
    named("order", "M", ("not-done", "without-s"), |exercise| {
        let (t, r, _) = factors(exercise);
        flat(t * r)
    });
    named("light", "share", ("done-too-much", "ambient"), |exercise| {
        Some(vec![right("light", exercise.seed, "share")[0] + number(exercise, "ka")])
    });
    named("light", "share", ("done-too-much", "highlight"), |exercise| {
        Some(vec![right("light", exercise.seed, "share")[0] + right("light", exercise.seed, "highlight")[0]])
    });
    named("depth-resolution", "step", ("factor-two", ""), |exercise| {
        Some(vec![2.0 * right("depth-resolution", exercise.seed, "step")[0]])
    });
}

#[test]
fn the_pyramid_has_its_mistakes() {
    // D = 15, M = 8. The vertices in any order, and the base round it the other way.
    let vertices = |side: f64, height: f64, w: f64| {
        let h = side / 2.0;
        rows5([-h, -h, h, h, 0.0], [0.0, 0.0, 0.0, 0.0, height], [-h, h, h, -h, 0.0], w)
    };
    for (answer, cause) in [
        (vertices(1.0, 1.0, 0.0), ("w-is-zero", "")),
        (vertices(2.0, 1.0, 1.0), ("factor-two", "base")),
        (vertices(2.0, 2.0, 1.0), ("factor-two", "base")),
        (vertices(8.0, 15.0, 1.0), ("done-too-much", "scaled")),
        (
            rows5([-0.5, -0.5, 0.5, 0.5, 0.0], [-0.5, 0.5, 0.5, -0.5, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0], 1.0),
            ("order-reversed", "upright"),
        ),
    ] {
        named_once("1-I", "local", cause, &answer);
    }
    // Before C = (0, 0, M), which looks along −z: x, y and z − M.
    let clip = |p: DVec3, m: f64, [f, b]: [f64; 2]| {
        let z = p.z - m;
        vec![p.x, p.y, -(b + f) / (b - f) * z - 2.0 * b * f / (b - f), -z]
    };
    named("pyramid", "apex", ("not-done", "model"), |exercise| {
        let [d, m] = ["D", "M"].map(|name| number(exercise, name));
        Some(clip(DVec3::Y, m, [d / 100.0, 10.0 * d]))
    });
    named("pyramid", "Mp", ("not-done", "hundredth"), |exercise| {
        let d = number(exercise, "D");
        Some(projection([d, 10.0 * d]))
    });
    named("pyramid", "Mp", ("order-reversed", "month-for-day"), |exercise| {
        let m = number(exercise, "M");
        Some(projection([m / 100.0, 10.0 * m]))
    });
}

/// M_p for θ = 90° and A = 1.
fn projection([f, b]: [f64; 2]) -> Vec<f64> {
    let depth = [0.0, 0.0, -(b + f) / (b - f), -2.0 * b * f / (b - f)];
    rows([1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], depth, [0.0, 0.0, -1.0, 0.0])
}

fn rows5(x: [f64; 5], y: [f64; 5], z: [f64; 5], w: f64) -> Vec<f64> {
    [x, y, z, [w; 5]].concat()
}
