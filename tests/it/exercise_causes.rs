//! Causes that were false once: each wrong answer is made by hand from the numbers of a statement, and the mistake that
//! was made is named, alone or as one of several.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fmt::Write as _;

use camera_lab::camera::Projection;
use camera_lab::exercises::{Exercise, Fact, check, entry, families};
use camera_lab::lessons::{Task, shipped};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;
use glam::{DMat3, DVec3};

use super::exercise_slips::typed;
use super::exercise_verdicts::{exercise, right, together};

/// Seeds of each family. Those up to 50 keep their coincidences.
const SEEDS: std::ops::Range<u64> = 0..120;

fn number(exercise: &Exercise, name: &str) -> f64 {
    match exercise.facts.iter().find(|(other, _)| *other == name) {
        Some((_, Fact::Number(number) | Fact::Angle(number))) => *number,
        other => panic!("{name}: {other:?}"),
    }
}

fn tuple(exercise: &Exercise, name: &str) -> DVec3 {
    match exercise.facts.iter().find(|(other, _)| *other == name) {
        Some((_, Fact::Tuple(tuple))) => DVec3::from_slice(tuple),
        other => panic!("{name}: {other:?}"),
    }
}

fn axes(exercise: &Exercise) -> [DVec3; 3] {
    let p = &exercise.subject.figure.camera;
    let n = (p.position - p.focal_point).normalize();
    let u = p.view_up.cross(n).normalize();
    [u, n.cross(u), n]
}

fn half_tangent(exercise: &Exercise) -> f64 {
    (exercise.subject.figure.camera.view_angle / 2.0).to_radians().tan()
}

fn is_in_perspective(exercise: &Exercise) -> bool {
    exercise.subject.figure.camera.projection == Projection::Perspective
}

fn turned(axis: DVec3, degrees: f64, v: DVec3) -> DVec3 {
    DMat3::from_axis_angle(axis, degrees.to_radians()) * v
}

/// Both cosines of `light`, that of lamp 1 first.
fn cosines(exercise: &Exercise) -> [f64; 2] {
    let [p, normal] = ["P", "N"].map(|name| tuple(exercise, name));
    let near = (tuple(exercise, "S") - p).normalize().dot(normal.normalize());
    let far = -tuple(exercise, "d").normalize().dot(normal.normalize());
    if near > 0.0 { [near, far] } else { [far, near] }
}

/// A mistake made by hand: the question, its code, and the wrong answer, row by row, if the exercise has it.
struct Made {
    id: &'static str,
    ask: &'static str,
    code: &'static str,
    answer: fn(&Exercise, &[f64]) -> Option<Vec<f64>>,
}

/// The kinds, in the order in which they were found.
const KINDS: [Made; 18] = [
    Made {
        id: "pan",
        ask: "C",
        code: "opposite-angle",
        answer: |e, _| {
            let [u, v, _] = axes(e);
            let by = u * number(e, "dx") + v * number(e, "dy");
            Some((e.subject.figure.camera.position - by).to_array().to_vec())
        },
    },
    Made {
        id: "perspective-matrix",
        ask: "Mp",
        code: "near-far-as-coordinates",
        answer: |e, right| {
            let mut rows = right.to_vec();
            let share = number(e, "B") / number(e, "F");
            (rows[0], rows[5]) = (rows[0] * share, rows[5] * share);
            Some(rows)
        },
    },
    Made {
        id: "light",
        ask: "share",
        code: "negative-light",
        answer: |e, _| {
            let [a, b] = cosines(e);
            Some(vec![0.35 + 0.65 * (a + b.abs())])
        },
    },
    Made {
        id: "light",
        ask: "share",
        code: "factor-two",
        answer: |e, _| Some(vec![0.35 + 0.65 * cosines(e)[0] / 2.0]),
    },
    Made {
        id: "vocabulary",
        ask: "K",
        code: "inverse",
        answer: |e, right| {
            let [m, n] = ["m", "n"].map(|name| number(e, name));
            let mut rows = right.to_vec();
            (rows[0], rows[4]) = (m / 2.0 * half_tangent(e) * number(e, "A"), n / 2.0 * half_tangent(e));
            Some(rows)
        },
    },
    Made {
        id: "disparity",
        ask: "f",
        code: "inverse",
        answer: |e, _| Some(vec![number(e, "n") / 2.0 * half_tangent(e)]),
    },
    Made {
        id: "pyramid",
        ask: "apex",
        code: "not-done",
        answer: |e, _| {
            let [day, month] = ["D", "M"].map(|name| number(e, name));
            Some(vec![month / 2.0, day, -month / 2.0, 1.0])
        },
    },
    Made {
        id: "pixel",
        ask: "pixel",
        code: "y-not-flipped",
        answer: |e, right| {
            let m = number(e, "m");
            Some(vec![m - 1.0 - right[0], right[1]])
        },
    },
    Made {
        id: "zoom-or-dolly",
        ask: "dollied_behind",
        code: "wrong-point",
        answer: |e, _| {
            let [h, d, e_, s] = ["h", "D", "e", "s"].map(|name| number(e, name));
            Some(vec![h / (2.0 * (d + e_) / s * half_tangent(e))])
        },
    },
    Made { id: "window", ask: "H", code: "aspect-inverted", answer: |e, right| Some(vec![right[0] / number(e, "A")]) },
    Made {
        id: "ndc",
        ask: "clip",
        code: "not-done",
        answer: |e, clip| {
            let view = right("ndc", e.seed, "view");
            let along = if is_in_perspective(e) { number(e, "F") } else { 1.0 };
            Some(vec![along * view[0], along * view[1], clip[2], clip[3]])
        },
    },
    Made {
        id: "pitch",
        ask: "n",
        code: "factor-two",
        answer: |e, _| {
            let [u, _, n] = axes(e);
            Some(turned(u, number(e, "alpha") / 2.0, n).to_array().to_vec())
        },
    },
    Made {
        id: "zoom-or-dolly",
        ask: "zoomed_behind",
        code: "not-done",
        answer: |e, _| Some(right("zoom-or-dolly", e.seed, "zoomed")),
    },
    Made {
        id: "disparity",
        ask: "shifted",
        code: "distance-for-depth",
        answer: |e, _| {
            let f = number(e, "n") / (2.0 * half_tangent(e));
            Some(vec![f * number(e, "b") / number(e, "D")])
        },
    },
    Made {
        id: "yaw",
        ask: "n",
        code: "order-reversed",
        answer: |e, _| {
            let [u, _, n] = axes(e);
            let (sin, cos) = number(e, "alpha").to_radians().sin_cos();
            Some((n * sin + u * cos).to_array().to_vec())
        },
    },
    Made {
        id: "vocabulary",
        ask: "frustum",
        code: "aspect-inverted",
        answer: |e, _| {
            let r = number(e, "F") * half_tangent(e);
            let t = r / number(e, "A");
            Some(vec![-r, r, -t, t])
        },
    },
    Made {
        id: "perspective-matrix",
        ask: "Mp",
        code: "z-sign",
        answer: |_, right| {
            let mut rows = right.to_vec();
            rows[14] = 1.0;
            Some(rows)
        },
    },
    Made {
        id: "ndc",
        ask: "clip",
        code: "z-sign",
        answer: |e, right| is_in_perspective(e).then(|| vec![right[0], right[1], right[2], -right[3]]),
    },
];

#[test]
fn the_mistake_that_was_made_is_among_those_named() {
    for Made { id, ask: name, code, answer } in &KINDS {
        let mut told = 0;
        for seed in SEEDS {
            let exercise = exercise(id, seed);
            let ask = exercise.asks.iter().find(|ask| ask.name == *name).unwrap();
            let Some(entries) = answer(&exercise, &right(id, seed, name)) else { continue };
            let text = typed(&entries, ask.shape());
            let judged = check(entry(id).unwrap(), &exercise, ask, &text).unwrap();
            if judged.right {
                continue;
            }
            let diagnosis = judged.diagnosis.as_ref();
            let context = || format!("{id} {seed} {name} = {text}: {diagnosis:?} without {code}");
            let codes: Vec<&str> =
                diagnosis.iter().flat_map(|found| found.mistakes()).map(|mistake| mistake.code()).collect();
            // With many that give the same, the verdict names none.
            if codes.is_empty() {
                continue;
            }
            assert!(codes.contains(code), "{}", context());
            // One mistake was made, not two.
            assert_eq!(diagnosis.unwrap().causes.len(), 1, "{}", context());
            told += 1;
        }
        assert!(told >= 40, "{id} {name} {code}: told {told} times");
    }
}

/// Words of its own, for a mistake that another question has too.
#[test]
fn a_cause_speaks_of_the_steps_of_its_question() {
    let message = |id: &str, seed: u64, name: &str, entries: &[f64], lang: Lang| {
        let exercise = exercise(id, seed);
        let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
        let judged = check(entry(id).unwrap(), &exercise, ask, &typed(entries, ask.shape())).unwrap();
        said::diagnosis(lang, ask, &judged).unwrap()
    };
    for seed in 0..20 {
        for (lang, rotated, depth) in [(Lang::En, "rotated", "Depth"), (Lang::PtBr, "girou", "profundidade")] {
            let moved = (KINDS[0].answer)(&exercise("pan", seed), &[]).unwrap();
            assert!(!message("pan", seed, "C", &moved, lang).contains(rotated), "{seed}");
            let rows =
                (KINDS[16].answer)(&exercise("perspective-matrix", seed), &right("perspective-matrix", seed, "Mp"));
            let said = message("perspective-matrix", seed, "Mp", &rows.unwrap(), lang);
            assert!(!said.contains(depth) && said.contains('w'), "{seed}: {said}");
        }
    }
}

/// The step prints the view coordinates of Q, so students multiply no vectors.
#[test]
fn a_question_of_a_lesson_names_no_step_that_its_text_has_done() {
    let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == "triangles").unwrap().lesson;
    let Some(Task::Question(entry)) = &lesson.steps[2].task else { panic!("a question") };
    let exercise = entry.exercise(0, &Default::default());
    let ask = &exercise.asks[0];
    assert!(check(entry, &exercise, ask, "[0.8, 0.6]").unwrap().right);
    let judged = check(entry, &exercise, ask, "[-0.8, -0.6]").unwrap();
    let codes: Vec<&str> = judged.diagnosis.unwrap().mistakes().map(|mistake| mistake.code()).collect();
    assert_eq!(codes, ["z-sign"]);
    let judged = check(entry, &exercise, ask, "[-0.8, 0.6]").unwrap();
    let codes: Vec<&str> =
        judged.diagnosis.iter().flat_map(|found| found.mistakes()).map(|mistake| mistake.code()).collect();
    assert!(!codes.contains(&"u-reversed"), "{codes:?}");
}

/// The vertices of I in each order are right, a wrong one isn't another, and the marks stand at the numbers as typed.
#[test]
fn the_vertices_of_the_pyramid_are_right_in_any_order() {
    let vertices = [[-0.5, 0.0, -0.5], [0.5, 0.0, -0.5], [0.5, 0.0, 0.5], [-0.5, 0.0, 0.5], [0.0, 1.0, 0.0]];
    let table = |columns: &[[f64; 3]]| {
        let row = |k: usize| columns.iter().map(|p| if k < 3 { p[k] } else { 1.0 }).collect::<Vec<_>>();
        typed(&(0..4).flat_map(row).collect::<Vec<_>>(), [4, 5])
    };
    let judge = |columns: &[[f64; 3]]| together("1-I", 0, &[("local", table(columns))]).remove(0);
    for start in 0..5 {
        let mut order = vertices;
        order.rotate_left(start);
        assert!(judge(&order).right);
        order.reverse();
        assert!(judge(&order).right, "the base the other way round");
        order.swap(0, 2);
        let mut wrong = order;
        let k = wrong.iter().position(|vertex| vertex[1] == 1.0).unwrap();
        wrong[k][1] = 2.0;
        let judged = judge(&wrong);
        let marks: Vec<bool> = (0..5).map(|column| judged.entries[1][column]).collect();
        assert!(!judged.right && marks.iter().enumerate().all(|(column, is)| *is == (column != k)), "{marks:?}");
        // One vertex twice, and another one left out.
        let mut twice = vertices;
        twice[start % 4] = twice[(start + 1) % 4];
        assert!(!judge(&twice).right);
    }
}

#[test]
fn a_ray_that_runs_backwards_may_also_have_lost_its_sign() {
    let backwards: Vec<f64> = right("0-5.1", 0, "perspective_direction").iter().map(|x| -x).collect();
    let judged = together("0-5.1", 0, &[("perspective_direction", typed(&backwards, [3, 1]))]).remove(0);
    let codes: Vec<&str> = judged.diagnosis.unwrap().mistakes().map(|mistake| mistake.code()).collect();
    assert!(codes.contains(&"sign") && codes.contains(&"u-reversed"), "{codes:?}");
}

#[test]
fn later_seeds_have_no_numbers_that_make_mistakes_look_alike() {
    for seed in 51..250 {
        for id in ["window", "ndc", "inside", "pixel", "ray", "viewport", "zoom", "vocabulary", "perspective-matrix"] {
            let exercise = exercise(id, seed);
            let p = &exercise.subject.figure.camera;
            let angle = p.view_angle;
            let is_free = p.near != p.aspect && angle != 60.0 && angle != 90.0;
            assert!(is_free || !is_in_perspective(&exercise), "{id} {seed}: F = {}, θ = {angle}", p.near);
        }
        for id in ["ndc", "pixel"] {
            let exercise = exercise(id, seed);
            let p = exercise.facts.iter().find_map(|(name, fact)| match fact {
                Fact::Tuple(values) if *name == "P" => Some(values),
                _ => None,
            });
            let zeros = p.unwrap().iter().filter(|value| **value == 0.0).count();
            assert!(zeros < 2, "{id} {seed}: P on an axis");
        }
        let both = exercise("zoom-or-dolly", seed);
        assert_ne!(number(&both, "D"), number(&both, "e"), "{seed}");
    }
}

/// Sheets with these seeds are printed. `UPDATE_SEEDS=1` writes the file.
#[test]
fn the_first_seeds_of_every_family_keep_their_numbers() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/it/exercise_seeds.txt");
    let mut lines = String::new();
    for family in families::ENTRIES {
        let content = (0..=50).map(|seed| {
            let exercise = family.exercise(seed, &Default::default());
            format!("{:?} {:?} {:?}", exercise.facts, exercise.subject.points, exercise.subject.pixels)
        });
        // FNV-1a, because it has to give the same in every version of the program.
        let byte = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let hash = content.collect::<String>().bytes().fold(0xcbf2_9ce4_8422_2325_u64, byte);
        writeln!(lines, "{} {hash:016x}", family.id).unwrap();
    }
    if std::env::var_os("UPDATE_SEEDS").is_some() {
        std::fs::write(path, &lines).unwrap();
    }
    let kept = std::fs::read_to_string(path).unwrap();
    let changed: Vec<&str> = kept.lines().zip(lines.lines()).filter(|(a, b)| a != b).map(|(a, _)| a).collect();
    assert!(changed.is_empty() && kept == lines, "{changed:?}");
}
