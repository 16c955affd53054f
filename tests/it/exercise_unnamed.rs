//! Frequent mistakes that had no name, made by hand from the statements: each verdict names the mistake, beside others
//! that give the same.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::Projection;
use camera_lab::exercises::{check, entry};
use camera_lab_words::Lang;
use glam::{DMat3, DQuat, DVec3, DVec4};

use super::exercise_verdicts::{exercise, is_one_of, right, square, text, verdict};

/// Seeds of each family.
const SEEDS: std::ops::Range<u64> = 0..24;

fn list(entries: &[f64]) -> String {
    format!("[{}]", entries.iter().map(|x| format!("{x:.9}")).collect::<Vec<_>>().join(", "))
}

fn vector(v: DVec3) -> String {
    list(&v.to_array())
}

/// The numbers of the statement, and the axes as (5.3) has them.
struct Given {
    c: DVec3,
    pf: DVec3,
    u: DVec3,
    v: DVec3,
    n: DVec3,
}

fn given(id: &str, seed: u64) -> Given {
    let camera = exercise(id, seed).subject.figure.camera;
    let (c, pf) = (camera.position, camera.focal_point);
    let n = (c - pf).normalize();
    let u = camera.view_up.cross(n).normalize();
    Given { c, pf, u, v: n.cross(u), n }
}

/// Asserts it for every seed whose wrong answer isn't right by coincidence, and for half of them at least.
fn told_of(id: &str, name: &str, code: &str, wrong: impl Fn(u64) -> Option<String>) {
    let mut count = 0;
    for seed in SEEDS {
        let Some(answer) = wrong(seed) else { continue };
        let told = verdict(id, seed, name, answer.clone());
        assert!(is_one_of(&told, code), "{id} {seed} {name} = {answer}: {told:?} without {code}");
        for lang in [Lang::En, Lang::PtBr] {
            assert!(text(id, seed, name, &answer, lang).len() > 40, "{id} {code}");
        }
        count += 1;
    }
    assert!(count >= 6, "{id} {name} {code}: {count} seeds");
}

#[test]
fn a_rotation_about_the_wrong_point_is_recognised() {
    for (id, name, about_u, moves_c) in [
        ("elevation", "C", true, true),
        ("azimuth", "C", false, true),
        ("yaw", "PF", false, false),
        ("pitch", "PF", true, false),
    ] {
        told_of(id, name, "wrong-point", |seed| {
            let Given { c, pf, u, v, .. } = given(id, seed);
            let angle = exercise(id, seed).subject.operations[0].angle().unwrap().degrees().to_radians();
            let turn = DQuat::from_axis_angle(if about_u { u } else { v }, angle);
            Some(vector(if moves_c { c + turn * (pf - c) } else { pf + turn * (c - pf) }))
        });
        // Turned about itself it stays, as it was before, so the verdict names both.
        told_of(id, name, "wrong-point", |seed| {
            let Given { c, pf, .. } = given(id, seed);
            let told = verdict(id, seed, name, vector(if moves_c { c } else { pf }));
            assert!(is_one_of(&told, "not-done"), "{id} {seed}: {told}");
            Some(vector(if moves_c { c } else { pf }))
        });
    }
}

#[test]
fn half_of_the_view_transform_is_recognised() {
    let p = |seed: u64| exercise("ndc", seed).subject.points[0];
    told_of("ndc", "view", "not-done", |seed| Some(vector(p(seed) - given("ndc", seed).c)));
    told_of("ndc", "view", "not-done", |seed| {
        let Given { u, v, n, .. } = given("ndc", seed);
        Some(vector(DMat3::from_cols(u, v, n).transpose() * p(seed)))
    });
    told_of("ndc", "view", "not-done", |seed| Some(vector(p(seed))));
    // The words fit the question: no matrix of projection was asked for.
    let said = text("ndc", 1, "view", &vector(p(1)), Lang::En);
    assert!(said.contains("coordinates of the world") && !said.contains("M_p"), "{said}");
    let rows = |seed| {
        let Given { c, u, v, n, .. } = given("view-matrix", seed);
        (c, [u, v, n])
    };
    let whole = |rows: [[f64; 4]; 4]| Some(square(rows.concat()));
    told_of("view-matrix", "Mv", "not-done", |seed| {
        let (_, [u, v, n]) = rows(seed);
        whole(
            [u, v, n]
                .map(|axis| [axis.x, axis.y, axis.z, 0.0])
                .into_iter()
                .chain([[0.0, 0.0, 0.0, 1.0]])
                .collect::<Vec<_>>()
                .try_into()
                .unwrap(),
        )
    });
    told_of("view-matrix", "Mv", "not-done", |seed| {
        let (c, _) = rows(seed);
        whole([[1.0, 0.0, 0.0, -c.x], [0.0, 1.0, 0.0, -c.y], [0.0, 0.0, 1.0, -c.z], [0.0, 0.0, 0.0, 1.0]])
    });
    told_of("view-matrix", "Mv", "transposed", |seed| {
        let (c, [u, v, n]) = rows(seed);
        let last = [-u.dot(c), -v.dot(c), -n.dot(c), 1.0];
        whole([[u.x, u.y, u.z, 0.0], [v.x, v.y, v.z, 0.0], [n.x, n.y, n.z, 0.0], last])
    });
    told_of("view-matrix", "Mv", "order-reversed", |seed| {
        let (c, [u, v, n]) = rows(seed);
        let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(c)];
        whole([row(v), row(u), row(n), [0.0, 0.0, 0.0, 1.0]])
    });
}

#[test]
fn mistakes_in_the_fourth_coordinate_are_recognised() {
    let in_perspective =
        |seed: &u64| exercise("ndc", *seed).subject.figure.camera.projection == Projection::Perspective;
    let clip = |seed: u64| DVec4::from_slice(&right("ndc", seed, "clip"));
    told_of("ndc", "clip", "divided-early", |seed| {
        in_perspective(&seed).then(|| list(&(clip(seed) / clip(seed).w).to_array()))
    });
    told_of("ndc", "clip", "w-is-one", |seed| {
        in_perspective(&seed).then(|| list(&clip(seed).truncate().extend(1.0).to_array()))
    });
}

#[test]
fn rays_from_the_window_and_view_coordinates_are_recognised() {
    let window = |seed: u64| {
        let exercise = exercise("ray", seed);
        let (figure, [i, j]) = (&exercise.subject.figure, exercise.subject.pixels[0]);
        let camera = &figure.camera;
        let is_parallel = camera.projection == Projection::Parallel;
        let h =
            if is_parallel { camera.height } else { 2.0 * camera.near * (camera.view_angle / 2.0).to_radians().tan() };
        let w = h * camera.aspect;
        let (m, rows) = (f64::from(figure.image.width), f64::from(figure.image.height));
        let x = w / m * (i as f64 + 0.5) - w / 2.0;
        let y = h / 2.0 - h / rows * (j as f64 + 0.5);
        (is_parallel, x, y, camera.near)
    };
    told_of("ray", "origin", "window-as-start", |seed| {
        let (Given { c, u, v, n, .. }, (_, x, y, f)) = (given("ray", seed), window(seed));
        Some(vector(c + u * x + v * y - n * f))
    });
    told_of("ray", "origin", "view-as-world", |seed| {
        let (is_parallel, x, y, _) = window(seed);
        is_parallel.then(|| list(&[x, y, 0.0]))
    });
}

#[test]
fn the_corner_of_5_2_has_its_mistakes() {
    // F = 5, θ = 90°: H = 10, W = 7.5, and a third of both after the zoom.
    let Given { c, u, v, n, .. } = given("0-5.2", 0);
    let (w, h, f) = (7.5 / 3.0, 10.0 / 3.0, 5.0);
    let corner = |x: f64, y: f64| vector(c + u * x + v * y - n * f);
    assert!(is_one_of(&verdict("0-5.2", 0, "corner", corner(w, h)), "factor-two"));
    let of_view = list(&[w / 2.0, h / 2.0, -f]);
    assert!(is_one_of(&verdict("0-5.2", 0, "corner", of_view), "view-as-world"));
    let (narrow, tall) = (7.5 * 15_f64.to_radians().tan(), 10.0 * 15_f64.to_radians().tan());
    assert!(is_one_of(&verdict("0-5.2", 0, "corner", corner(narrow / 2.0, tall / 2.0)), "zoom-on-angle"));
}

#[test]
fn the_least_of_several_entries_is_recognised() {
    let planes = |p: &[f64]| [p[3] + p[0], p[3] - p[0], p[3] + p[1], p[3] - p[1], p[3] + p[2], p[3] - p[2]];
    let ends = |seed: u64| {
        let facts = exercise("clip-segment", seed).facts;
        let tuple = |name: &str| match facts.iter().find(|(fact, _)| *fact == name).unwrap() {
            (_, camera_lab::exercises::Fact::Tuple(tuple)) => tuple.clone(),
            _ => panic!("a tuple"),
        };
        (planes(&tuple("A")), planes(&tuple("B")))
    };
    let mut told = 0;
    for seed in 0..60 {
        let (a, b) = ends(seed);
        let cuts = |enters: bool| {
            let pairs =
                a.into_iter().zip(b).filter(move |(a, b)| if enters { *a < 0.0 } else { *a >= 0.0 && *b < 0.0 });
            pairs.map(|(a, b)| a / (a - b))
        };
        for (name, wrong) in [
            ("t_in", cuts(true).fold(f64::INFINITY, f64::min)),
            ("t_out", cuts(false).fold(f64::NEG_INFINITY, f64::max)),
        ] {
            if (wrong - right("clip-segment", seed, name)[0]).abs() > 0.01 {
                let said = verdict("clip-segment", seed, name, format!("{wrong:.9}"));
                assert!(is_one_of(&said, "entry-exit-exchanged"), "{seed} {name} {wrong}: {said}");
                told += 1;
            }
        }
    }
    assert!(told > 10, "{told}");
}

#[test]
fn the_model_matrix_has_its_mistakes() {
    let (d, m) = (15.0, 8.0);
    let moved = |x: f64, s: [f64; 3]| {
        square([[s[0], 0.0, 0.0, x], [0.0, s[1], 0.0, 0.0], [0.0, 0.0, s[2], x], [0.0, 0.0, 0.0, 1.0]].concat())
    };
    for (answer, code) in [
        (moved(0.5, [m, d, m]), "order-reversed"),
        (moved(m * m / 2.0, [m, d, m]), "order-reversed"),
        (moved(0.0, [m, d, m]), "not-done"),
        (moved(d / 2.0, [d, m, d]), "order-reversed"),
        (moved(m, [m, d, m]), "not-touching"),
        (moved(m / 2.0 + 1.0, [m, d, m]), "not-touching"),
    ] {
        let told = verdict("1-II", 0, "Mm", answer.clone());
        assert!(is_one_of(&told, code), "{answer}: {told}");
    }
    // An octant that the notes allow is not called a lost factor.
    assert!(!verdict("1-II", 0, "Mm", moved(m, [m, d, m])).contains("factor-two"));
}

/// Beside the condition that isn't met stands the way that mends it.
#[test]
fn a_picture_to_match_says_the_direction() {
    for seed in 0..8 {
        let exercise = exercise("match-picture", seed);
        let wanted = exercise.figure_to_match().unwrap().camera;
        let ask = &exercise.asks[0];
        let told = |position: DVec3, angle: f64| {
            let text = format!(
                "C=[{}, {}, {}]; PF=[0, 0.5, 0]; θ={angle}°; A={}; F=1; B=40",
                position.x, position.y, position.z, wanted.aspect
            );
            let judged = check(entry("match-picture").unwrap(), &exercise, ask, &text).unwrap();
            let wrong = judged.conditions.iter().zip(judged.entries.iter().flatten()).filter(|(_, right)| !**right);
            (judged.right, wrong.map(|(name, _)| *name).collect::<Vec<_>>())
        };
        assert_eq!(told(wanted.position, wanted.view_angle), (true, vec![]), "{seed}");
        let pf = DVec3::new(0.0, 0.5, 0.0);
        let away = wanted.position - pf;
        let turned = |degrees: f64| pf + DQuat::from_rotation_y(f64::to_radians(degrees)) * away;
        // Counter-clockwise from above is to the right of a camera that looks at PF.
        assert!(told(turned(20.0), wanted.view_angle).1.contains(&"more-to-the-left"), "{seed}");
        assert!(told(turned(-20.0), wanted.view_angle).1.contains(&"more-to-the-right"), "{seed}");
        let right = away.cross(DVec3::Y).normalize();
        let raised = |degrees: f64| pf + DQuat::from_axis_angle(-right, f64::to_radians(degrees)) * away;
        let higher = raised(12.0);
        let (more, less) = if higher.y > wanted.position.y { (higher, raised(-12.0)) } else { (raised(-12.0), higher) };
        assert!(told(more, wanted.view_angle).1.contains(&"lower"), "{seed}");
        assert!(told(less, wanted.view_angle).1.contains(&"higher"), "{seed}");
        assert!(told(pf + away * 1.5, wanted.view_angle).1.contains(&"nearer"), "{seed}");
        assert!(told(pf + away / 1.5, wanted.view_angle).1.contains(&"farther"), "{seed}");
        assert!(told(wanted.position, wanted.view_angle * 1.4).1.contains(&"angle-smaller"), "{seed}");
        assert!(told(wanted.position, wanted.view_angle / 1.4).1.contains(&"angle-larger"), "{seed}");
    }
}
