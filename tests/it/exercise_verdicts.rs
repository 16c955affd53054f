//! Verdicts on wrong answers, each made by hand from the numbers of an exercise: the reason in the verdict is the
//! mistake that was made, or one of several that give the same.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::{Answer, Exercise, Free, Judged, Table, check_beside, entry, read_answer};
use camera_lab::inspect::quantity::QuantityPath;
use camera_lab::lessons::lesson_of;
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_messages, exercises as said};
use glam::{DMat4, DVec3};

/// The exercise of a family.
pub(crate) fn exercise(id: &str, seed: u64) -> Exercise {
    entry(id).unwrap().exercise(seed, &Free::new())
}

/// The right answer.
pub(crate) fn right(id: &str, seed: u64, name: &str) -> Vec<f64> {
    let exercise = exercise(id, seed);
    let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    ask.expected().table().unwrap().entries
}

/// A matrix that `inspect` prints of the subject of an exercise.
fn matrix(exercise: &Exercise, path: &str) -> DMat4 {
    let table = exercise.subject.value(QuantityPath::of(path).unwrap()).unwrap();
    table.matrix().unwrap()
}

fn vector(entries: &[f64]) -> String {
    format!("[{}]", entries.iter().map(|x| format!("{x:.6}")).collect::<Vec<_>>().join(", "))
}

fn of_shape(table: &Table) -> String {
    let rows: Vec<String> = table.rows().map(vector).collect();
    format!("[{}]", rows.join(", "))
}

pub(crate) fn square(entries: Vec<f64>) -> String {
    let rows = if entries.len() == 16 { 4 } else { 3 };
    of_shape(&Table { rows, columns: rows, entries })
}

/// The verdicts on answers that are submitted together.
pub(crate) fn together(id: &str, seed: u64, answers: &[(&str, String)]) -> Vec<Judged> {
    let (entry, exercise) = (entry(id).unwrap(), exercise(id, seed));
    let ask = |name: &str| exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let read = |(name, text): &(&str, String)| {
        let answer = read_answer(text, ask(name), &exercise.free).unwrap();
        ((*name).to_owned(), answer)
    };
    let read: Vec<(String, Answer)> = answers.iter().map(read).collect();
    answers.iter().map(|(name, text)| check_beside(entry, &exercise, ask(name), text, &read).unwrap()).collect()
}

/// The codes of the verdict: those made together, and after a `|` those that give the same.
pub(crate) fn told(judged: &Judged) -> String {
    let codes = |causes: &[camera_lab::exercises::Cause]| {
        causes.iter().map(|cause| cause.mistake.code()).collect::<Vec<_>>().join("+")
    };
    judged.diagnosis.as_ref().map_or(String::new(), |diagnosis| {
        let others = codes(&diagnosis.others).replace('+', "|");
        let causes = codes(&diagnosis.causes);
        if others.is_empty() { causes } else { format!("{causes}|{others}") }
    })
}

/// The verdict on one answer, which is not right.
pub(crate) fn verdict(id: &str, seed: u64, name: &str, answer: impl Into<String>) -> String {
    let judged = together(id, seed, &[(name, answer.into())]).remove(0);
    assert!(!judged.right, "{id} {seed} {name}");
    told(&judged)
}

pub(crate) fn is_one_of(told: &str, code: &str) -> bool {
    told.split('|').any(|one| one == code)
}

pub(crate) fn text(id: &str, seed: u64, name: &str, answer: &str, lang: Lang) -> String {
    let exercise = exercise(id, seed);
    let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let judged = together(id, seed, &[(name, answer.to_owned())]).remove(0);
    let hints = exercise_messages::hints(lang, &exercise, ask, &judged);
    format!("{} {}", said::diagnosis(lang, ask, &judged).unwrap_or_default(), hints.join(" "))
}

/// A1.
#[test]
fn the_floor_has_one_rule_in_pixels_and_viewports() {
    let whole = right("viewport", 11, "viewport");
    let exercise = exercise("viewport", 11);
    let (ndc, viewport) = (right("viewport", 11, "ndc"), exercise.subject.figure.viewport.unwrap());
    let along = |start: i32, size: u32, n: f64| f64::from(start) + f64::from(size) / 2.0 * (n + 1.0);
    let real = [along(viewport.x, viewport.width, ndc[0]), along(viewport.y, viewport.height, ndc[1]), whole[2]];
    assert_eq!(verdict("viewport", 11, "viewport", vector(&real)), "not-floored");
    let rounded = [real[0].round(), real[1].round(), real[2]];
    assert!(rounded[..2] != whole[..2]);
    assert_eq!(verdict("viewport", 11, "viewport", vector(&rounded)), "rounded-not-floored");
}

/// A2, A15.
#[test]
fn small_numbers_are_judged_by_their_size() {
    let window = right("pixel", 205, "window");
    for answer in ["[0.0029, 0.0019]", "[0.001, 0]"] {
        assert!(!together("pixel", 205, &[("window", answer.to_owned())]).remove(0).right, "{answer} for {window:?}");
    }
    let camera = exercise("pixel", 205).subject.camera().unwrap();
    let times = |factor: f64| vector(&window.iter().map(|x| x * factor).collect::<Vec<_>>());
    assert_eq!(verdict("pixel", 205, "window", times(1.0 / camera.near())), "near-forgotten");
    assert!(is_one_of(&verdict("pixel", 205, "window", times(camera.distance() / camera.near())), "distance-for-near"));
    for seed in [200, 201, 202, 203, 204] {
        let window = right("pixel", seed, "window");
        let camera = exercise("pixel", seed).subject.camera().unwrap();
        if camera.projection() == camera_lab::camera::Projection::Perspective {
            let scaled = window.iter().map(|x| x * camera.distance() / camera.near()).collect::<Vec<_>>();
            assert!(is_one_of(&verdict("pixel", seed, "window", vector(&scaled)), "distance-for-near"), "{seed}");
        }
    }
}

/// A3.
#[test]
fn a_misprint_of_the_notes_is_recognised() {
    for (id, seed) in [("parallel-matrix", 0), ("parallel-matrix", 200), ("0-5.2", 0)] {
        let mut matrix = right(id, seed, "Mp");
        matrix[15] = 0.0;
        assert_eq!(verdict(id, seed, "Mp", square(matrix.clone())), "as-printed", "{id}");
        for (lang, words) in [(Lang::En, "(5.15)"), (Lang::PtBr, "errata")] {
            assert!(text(id, seed, "Mp", &square(matrix.clone()), lang).contains(words), "{id} {lang:?}");
        }
    }
    let mut matrix = right("parallel-matrix", 7, "Mp");
    let camera = exercise("parallel-matrix", 7).subject.camera().unwrap();
    matrix[10] = -2.0 * (1.0 / camera.far() - camera.near());
    assert!(is_one_of(&verdict("parallel-matrix", 7, "Mp", square(matrix)), "as-printed"));
    let (id, seed) = ("yaw", 200);
    let pitched = {
        let subject = exercise(id, seed).subject;
        let camera = camera_lab::camera::Camera::new(&subject.figure.camera).unwrap();
        let angle = subject.operations[0].angle().unwrap().degrees().to_radians();
        let basis = camera.basis();
        let n = basis.n * angle.cos() - basis.v * angle.sin();
        camera.position() - n * camera.distance()
    };
    assert_eq!(verdict(id, seed, "PF", vector(&pitched.to_array())), "as-printed|other-operation");
}

/// A4, A5.
#[test]
fn axes_are_judged_with_the_students_own() {
    let [u, v, n] = ["u", "v", "n"].map(|name| DVec3::from_slice(&right("basis", 200, name)));
    let text = |v: DVec3| vector(&v.to_array());
    let judged = together("basis", 200, &[("u", text(u)), ("v", text(-v)), ("n", text(n))]);
    assert_eq!(judged.iter().map(told).collect::<Vec<_>>(), ["", "v-reversed", ""]);
    // n reversed, u and v computed rightly from it: v = −n × −u is right again.
    let judged = together("basis", 200, &[("u", text(-u)), ("v", text(v)), ("n", text(-n))]);
    assert_eq!(told(&judged[2]), "n-reversed");
    assert!(judged[1].right);
    assert_eq!((told(&judged[0]).as_str(), judged[0].carried.as_slice()), ("", &["n".to_owned()][..]));
    assert!((judged[0].score - 1.0).abs() < 1e-12 && !judged[0].right);
    for lang in [Lang::En, Lang::PtBr] {
        assert!(said::carried(lang, &judged[0]).is_some_and(|text| text.contains('n')));
    }
}

/// A5 and B10 along other ways.
#[test]
fn answers_right_for_a_wrong_value_are_marked_as_carried() {
    let carried = |id: &str, seed, answers: &[(&str, String)]| -> Vec<Vec<String>> {
        together(id, seed, answers).into_iter().map(|judged| judged.carried).collect()
    };
    let none: Vec<String> = Vec::new();
    // H twice too large, W = A H, r = W/2.
    let [h, w, r] = ["H", "W", "r"].map(|name| right("window", 200, name)[0] * 2.0);
    let answers = [("H", h.to_string()), ("W", w.to_string()), ("r", r.to_string())];
    assert_eq!(carried("window", 200, &answers), [none.clone(), vec!["H".to_owned()], vec!["H".to_owned()]]);
    // The pixel of a wrong point of the window.
    let (id, seed) = ("pixel", 200);
    let subject = exercise(id, seed).subject;
    let (camera, size) = (subject.camera().unwrap(), subject.figure.image);
    let wrong: Vec<f64> = right(id, seed, "window").iter().map(|x| x * 0.7).collect();
    let window = camera.window();
    let i = (f64::from(size.width) * (wrong[0] - window.left) / window.width()).floor();
    let j = (f64::from(size.height) * (window.top - wrong[1]) / window.height()).floor();
    let answers = [("window", vector(&wrong)), ("pixel", format!("[{i}, {j}]"))];
    assert_eq!(carried(id, seed, &answers), [none.clone(), vec!["window".to_owned()]]);
    // Clip and NDC of a wrong point of the VRC: the first cause is named, and not each on the way.
    let (id, seed) = ("ndc", 200);
    let projection = matrix(&exercise(id, seed), "projection_matrix");
    let mut seen = DVec3::from_slice(&right(id, seed, "view"));
    seen.x += 0.25;
    let clip = projection * seen.extend(1.0);
    let ndc = clip.truncate() / clip.w;
    let answers =
        [("view", vector(&seen.to_array())), ("clip", vector(&clip.to_array())), ("ndc", vector(&ndc.to_array()))];
    assert_eq!(carried(id, seed, &answers), [none, vec!["view".to_owned()], vec!["view".to_owned()]]);
}

/// A6, A7, A9.
#[test]
fn a_window_has_one_cause_or_none() {
    let (camera, a) = (exercise("window", 200).subject.camera().unwrap(), right("window", 200, "W")[0]);
    let tangent = (camera.parameters().view_angle / 2.0).to_radians().tan();
    assert_eq!(verdict("window", 200, "H", format!("{:.6}", 2.0 * tangent)), "near-forgotten");
    let width = a / right("window", 200, "H")[0] * 2.0 * tangent;
    assert_eq!(verdict("window", 200, "W", format!("{width:.6}")), "near-forgotten");
    for seed in [202, 201, 203] {
        let exercise = exercise("zoom", seed);
        let camera = camera_lab::camera::Camera::new(&exercise.subject.figure.camera).unwrap();
        if camera.projection() == camera_lab::camera::Projection::Perspective {
            let whole = camera.parameters().view_angle.to_radians().tan();
            let half = (camera.parameters().view_angle / 2.0).to_radians().tan();
            let height = right("zoom", seed, "H")[0] * whole / half;
            if height > 0.0 && height < 1e6 {
                assert_eq!(verdict("zoom", seed, "H", format!("{height:.6}")), "whole-angle", "{seed}");
            }
        }
    }
    // 4/3 is not 1.
    assert!(!verdict("window", 204, "W", "1").contains("rounded"));
    let half = "position=[0, 0, 2]; focal_point=[0, 0, 0]; projection=parallel; height=1; aspect=1; near=1; far=3";
    assert_eq!(verdict("0-5.3", 0, "camera", half), "factor-two");
}

/// A8.
#[test]
fn conventions_of_others_are_not_called_rounding() {
    let mut k = right("vocabulary", 31, "K");
    (k[2], k[5]) = (k[2] - 0.5, k[5] - 0.5);
    assert_eq!(verdict("vocabulary", 31, "K", square(k.clone())), "pixel-corner");
    assert!(text("vocabulary", 31, "K", &square(k), Lang::En).contains("computer vision"));
    let step = right("depth-resolution", 32, "step")[0];
    let told = verdict("depth-resolution", 32, "step", format!("{:.6}", step * 255.0 / 256.0));
    assert_eq!(told, "approximation");
}

/// A10, A11.
#[test]
fn segments_have_reasons_of_their_own() {
    for seed in [31, 32] {
        let [t_in, t_out] = ["t_in", "t_out"].map(|name| right("clip-segment", seed, name)[0]);
        for (name, other) in [("t_in", t_out), ("t_out", t_in)] {
            let told = verdict("clip-segment", seed, name, format!("{other:.6}"));
            assert!(told.starts_with("entry-exit-exchanged"), "{told}");
        }
        let said = text("clip-segment", seed, "t_in", &format!("{:.6}", 1.0 - t_out), Lang::En);
        assert!(!said.contains("A B p"), "{said}");
        let right_order = right("painter", seed, "order");
        let reversed: Vec<f64> = right_order.iter().rev().copied().collect();
        let reversed = reversed.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        assert_eq!(verdict("painter", seed, "order", format!("[{reversed}]")), "order-reversed");
        let said = text("painter", seed, "order", &format!("[{reversed}]"), Lang::En);
        assert!(said.contains("farthest") && !said.contains("A B p"), "{said}");
    }
    assert!(verdict("clip-segment", 31, "t_in", "1/7").starts_with("clip-after-divide"));
}

/// A12.
#[test]
fn outcodes_have_no_signs() {
    for name in ["A", "B"] {
        let bits = right("outcodes", 31, name);
        let swapped: Vec<f64> = [1, 0, 3, 2, 5, 4].iter().map(|k| bits[*k]).collect();
        let answer = format!("[{}]", swapped.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "));
        let told = verdict("outcodes", 31, name, &*answer);
        assert!(is_one_of(&told, "order-reversed") && !told.contains("sign|") && told != "sign", "{told}");
        let said = text("outcodes", 31, name, &answer, Lang::En);
        assert!(!said.contains("a sign is not"), "{said}");
    }
}

/// A13, A14.
#[test]
fn pixels_are_floored_and_depth_has_its_range() {
    let subject = exercise("pixel", 200).subject;
    let (camera, size) = (subject.camera().unwrap(), subject.figure.image);
    let (at, window) = (right("pixel", 200, "window"), camera.window());
    let i = f64::from(size.width) * (at[0] - window.left) / window.width();
    let j = f64::from(size.height) * (window.top - at[1]) / window.height();
    assert_eq!(verdict("pixel", 200, "pixel", vector(&[i, j])), "not-floored");
    assert_eq!(verdict("pixel", 200, "pixel", format!("[{}, {}]", i.round(), j.round())), "rounded-not-floored");
    assert_eq!(verdict("pixel", 200, "pixel", format!("[{}, {}]", i.floor() + 1.0, j.floor() + 1.0)), "one-based");
    let [mut at, ndc] = ["viewport", "ndc"].map(|name| right("viewport", 200, name));
    at[2] = f64::midpoint(ndc[2], 1.0);
    assert_eq!(verdict("viewport", 200, "viewport", vector(&at)), "depth-range-ignored");
    let mut at = right("viewport", 200, "viewport");
    let corner = exercise("viewport", 200).subject.figure.viewport.unwrap();
    (at[0], at[1]) = (at[0] - f64::from(corner.x), at[1] - f64::from(corner.y));
    assert_eq!(verdict("viewport", 200, "viewport", vector(&at)), "offset-ignored");
}

/// A16.
#[test]
fn another_order_of_transforms_is_recognised() {
    let m = DMat4::from_cols_array(&right("order", 31, "M").try_into().unwrap()).transpose();
    // M = T R S, so R T S has the translation R t.
    let scale = DVec3::new(m.x_axis.truncate().length(), m.y_axis.truncate().length(), m.z_axis.truncate().length());
    let turn = m * DMat4::from_scale(DVec3::ONE / scale);
    let turn = DMat4::from_mat3(glam::DMat3::from_mat4(turn));
    let rts = turn * DMat4::from_translation(m.w_axis.truncate()) * DMat4::from_scale(scale);
    let told = verdict("order", 31, "M", square(rts.transpose().to_cols_array().to_vec()));
    assert!(told.starts_with("order-reversed"), "{told}");
}

/// A17.
#[test]
fn vup_that_was_not_turned_is_recognised() {
    use camera_lab::camera::{Camera, Convention, Parameters};
    let subject = exercise("pitch", 205).subject;
    let before = Camera::new(&subject.figure.camera).unwrap();
    let after = subject.operations[0].apply(&before, Convention::RightHand).unwrap();
    let kept = Camera::new(&Parameters { view_up: before.view_up(), ..*after.parameters() }).unwrap();
    let told = verdict("pitch", 205, "v", vector(&kept.basis().v.to_array()));
    assert!(is_one_of(&told, "not-done"), "{told}");
}

/// A18, A19, A20.
#[test]
fn several_causes_are_listed_the_likelier_first() {
    let told = verdict("0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]");
    assert!(told.starts_with("sign|") && is_one_of(&told, "n-reversed"), "{told}");
    let said = text("0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]", Lang::En);
    assert!(said.contains("More than one mistake gives this. Either:") && said.contains("Or:"), "{said}");
    let said = text("0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]", Lang::PtBr);
    assert!(said.contains("Mais de um erro") && said.contains("Ou este:"), "{said}");
    for seed in [0, 5, 200] {
        let mut matrix = right("parallel-matrix", seed, "Mp");
        matrix[10] = -matrix[10];
        assert!(verdict("parallel-matrix", seed, "Mp", square(matrix.clone())).starts_with("sign"), "{seed}");
        assert!(is_one_of(&verdict("parallel-matrix", seed, "Mp", square(matrix)), "near-far-as-coordinates"));
    }
    let window = right("pixel", 200, "window");
    let told = verdict("pixel", 200, "window", vector(&[-window[0], window[1]]));
    assert!(is_one_of(&told, "u-reversed"), "{told}");
}

/// A21.
#[test]
fn one_cause_is_preferred_to_two() {
    let exercise = exercise("ndc", 200);
    let seen = matrix(&exercise, "view_matrix").inverse().transform_point3(exercise.subject.points[0]);
    assert_eq!(verdict("ndc", 200, "view", vector(&seen.to_array())), "inverse");
}

/// A22.
#[test]
fn a_camera_returned_as_it_was_is_recognised() {
    use camera_lab::camera::Camera;
    for id in ["elevation", "azimuth", "roll", "yaw", "pitch", "zoom", "dolly", "pan"] {
        let subject = exercise(id, 200).subject;
        let before = Camera::new(&subject.figure.camera).unwrap();
        let (name, answer) = match id {
            "elevation" | "azimuth" | "dolly" | "pan" => ("C", vector(&before.position().to_array())),
            "yaw" | "pitch" => ("PF", vector(&before.focal_point().to_array())),
            "roll" => ("u", vector(&before.basis().u.to_array())),
            _ => ("H", format!("{:.6}", before.window_height())),
        };
        let told = verdict(id, 200, name, answer);
        assert!(told.starts_with("not-done"), "{id}: {told}");
    }
    // B9: (a) before the zoom.
    let exercise = exercise("0-5.2", 0);
    let camera = Camera::new(&exercise.subject.figure.camera).unwrap();
    assert_eq!(verdict("0-5.2", 0, "corner", vector(&camera.volume_corners()[2].to_array())), "not-done");
}

/// A23.
#[test]
fn a_step_of_the_buffer_is_not_called_an_inverse() {
    assert_eq!(verdict("depth-resolution", 32, "step", "1/(2^8 - 1)"), "not-done");
    assert!(text("depth-resolution", 32, "step", "1/(2^8 - 1)", Lang::En).contains("dZ/dd"));
}

/// A24.
#[test]
fn a_number_alone_is_wrong_only_beside_four_that_are_right() {
    use camera_lab::camera::Camera;
    let subject = exercise("pan", 204).subject;
    let before = Camera::new(&subject.figure.camera).unwrap();
    let camera_lab::camera::Operation::Pan { dx, dy } = subject.operations[0] else { unreachable!() };
    let basis = before.basis();
    let reversed = before.position() - basis.u * dx + basis.v * dy;
    assert_eq!(verdict("pan", 204, "C", vector(&reversed.to_array())), "u-reversed");
    let subject = exercise("dolly", 204).subject;
    let camera_lab::camera::Operation::Dolly(factor) = subject.operations[0] else { unreachable!() };
    let position = subject.figure.camera.position / factor;
    assert_eq!(verdict("dolly", 204, "C", vector(&position.to_array())), "through-origin");
    let subject = exercise("pixel", 201).subject;
    let ndc = subject.camera().unwrap().clip_point(subject.points[0]);
    let told = verdict("pixel", 201, "window", vector(&[ndc.x / ndc.w, ndc.y / ndc.w]));
    assert!(!told.contains("arithmetic-slip"), "{told}");
    let mut n = right("basis", 200, "n");
    n[0] += 0.3;
    assert!(!verdict("basis", 200, "n", vector(&n)).contains("arithmetic-slip"));
}

/// B1.
#[test]
fn numbers_tell_a_mistake_from_the_right_way() {
    for seed in 0..40 {
        for id in ["vocabulary", "window", "perspective-matrix"] {
            let near = exercise(id, seed).subject.figure.camera.near;
            assert!((near - 1.0).abs() > 1e-9, "{id} {seed}");
        }
    }
    for seed in [31, 32] {
        let exercise = exercise("painter", seed);
        let (points, position) = (&exercise.subject.points, exercise.subject.figure.camera.position);
        let mut order: Vec<usize> = (0..4).collect();
        order.sort_by(|a, b| {
            let distance = |k: &usize| (points[*k] - position).length();
            distance(b).total_cmp(&distance(a))
        });
        let order: Vec<f64> = order.into_iter().map(|k| [1.0, 2.0, 3.0, 4.0][k]).collect();
        assert_ne!(order, right("painter", seed, "order"), "{seed}");
    }
}

/// B2, B3, B4.
#[test]
fn answers_are_read_as_students_write_them() {
    let judged = |id: &str, seed, name: &str, text: &str| together(id, seed, &[(name, text.to_owned())]).remove(0);
    // C − PF = (1, 1, 1).
    for text in [
        "1/sqrt(3)*[1, 1, 1]",
        "[1, 1, 1]/sqrt(3)",
        r"\frac{1}{\sqrt{3}} [1, 1, 1]",
        "(1; 1; 1)/√3",
        "(1/√3)(1, 1, 1)",
        "-[-1, -1, -1]/√3",
        "0.57735 0.57735 0.57735",
        "[57,735%; 57,735%; 57,735%]",
        "0,57735 0,57735 0,57735",
    ] {
        assert!(judged("basis", 1, "n", text).right, "{text}");
    }
    assert!(judged("window", 1, "H", "0.8 tan 20°").right);
    assert!(judged("window", 1, "H", "2*(0,5)/2 + 0,8*tan(20°) − 0,5").right);
    for text in ["1 + 2*[1, 1, 1]", "[1, 1, 1]/2 + 1", "[1, 1, 1]2", "x*[1, 1, 1]"] {
        let exercise = exercise("basis", 1);
        let ask = exercise.asks.iter().find(|ask| ask.name == "n").unwrap();
        assert!(read_answer(text, ask, &[]).is_err(), "{text}");
    }
    assert!(judged("window", 1, "H", r"0.8\tan{20^\circ}").right);
    let rows = right("view-matrix", 1, "Mv");
    let blanks: Vec<String> =
        rows.chunks(4).map(|row| row.iter().map(|x| format!("{x:.5}")).collect::<Vec<_>>().join(" ")).collect();
    for text in [blanks.join("; "), blanks.join("\n"), format!("[[{}]]", blanks.join("] ["))] {
        assert!(judged("view-matrix", 1, "Mv", &text).right, "{text}");
    }
    for camera in [
        "C=[0,0,2]; PF=[0,0,0]; projection=parallel; H=2; A=1; F=1; B=3",
        "C=(0; 0; 2); PF=(0; 0; 0); projeção=paralela; H=2; A=1; F=1; B=3",
        "C = (0, 0, 2)\nPF = (0, 0, 0)\nVUP = (0, 1, 0)\nprojection = parallel\nH = 2\nA = 1\nF = 1\nB = 3",
    ] {
        assert!(judged("0-5.3", 0, "camera", camera).right, "{camera}");
    }
    let exercise = exercise("0-5.3", 0);
    for text in ["C", "X=1", "C=[0, 0", "H=two", "F=\"", "projeção=oblíqua"] {
        let error = read_answer(text, &exercise.asks[0], &[]).unwrap_err();
        for lang in [Lang::En, Lang::PtBr] {
            let why = said::answer_error(lang, &error);
            assert!(!why.contains("TOML") && !why.is_empty(), "{text}: {why}");
        }
    }
    let said = text("basis", 1, "n", "[0,577350, 0,57735, 0,57735]", Lang::PtBr);
    assert!(said.contains("“;”"), "{said}");
}

/// B6, B7.
#[test]
fn the_block_and_the_operation_are_named() {
    let m = right("view-matrix", 1, "Mv");
    let block = [m[0], m[4], m[8], m[3], m[1], m[5], m[9], m[7], m[2], m[6], m[10], m[11], 0.0, 0.0, 0.0, 1.0];
    let said = text("view-matrix", 1, "Mv", &square(block.to_vec()), Lang::En);
    assert!(said.contains("The block R is transposed") && !said.contains("translation is its last"), "{said}");
    let said = text("elevation", 1, "n", "[1/√6 - 1/2, 1/√6 + 1/2, 1/√6]", Lang::En);
    assert!(said.contains("This is an azimuth"), "{said}");
    let said = text("elevation", 1, "n", "[1/√6 - 1/2, 1/√6 + 1/2, 1/√6]", Lang::PtBr);
    assert!(said.contains("Isto é um azimute"), "{said}");
}

/// B8, C3.
#[test]
fn without_a_known_mistake_help_begins_at_the_first_step_that_is_wrong() {
    let exercise = exercise("ndc", 200);
    let hints = |answers: &[(&str, String)], name: &str| {
        let judged = together("ndc", 200, answers);
        let (ask, judged) = exercise.asks.iter().zip(&judged).find(|(ask, _)| ask.name == name).unwrap();
        assert_eq!(told(judged), "");
        exercise_messages::hints(Lang::En, &exercise, ask, judged).join(" ")
    };
    let view = vector(&right("ndc", 200, "view"));
    let wrong = "[17.123, 23.456, 31.789, 41.234]".to_owned();
    let alone = hints(&[("view", "[17.123, 23.456, 31.789]".to_owned()), ("clip", wrong.clone())], "clip");
    let after = hints(&[("view", view), ("clip", wrong)], "clip");
    assert!(alone.contains("The solution begins with") && after.contains("The steps before are right"), "{after}");
    // The first is the sentence to keep, and the step that says it.
    let way = lesson_of("ndc").unwrap();
    let sentence = camera_lab_words::told(Lang::En, way.lesson.sentence.as_ref().unwrap()).trim();
    assert!(alone.starts_with(sentence) && alone.contains(&format!("step {}", way.step + 1)), "{alone}");
    // Without a known mistake there is a hint.
    for (id, name, answer) in [("1-I", "height", "7777"), ("order", "first", "rotate"), ("inside", "plane", "none")] {
        let exercise = self::exercise(id, 3);
        let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
        let judged = together(id, 3, &[(name, answer.to_owned())]).remove(0);
        assert!(judged.right || !exercise_messages::hints(Lang::PtBr, &exercise, ask, &judged).is_empty(), "{id}");
    }
}

/// Multiples of the right direction, and of the reversed one if **n** may be.
#[test]
fn directions_of_any_length_are_recognised() {
    let n = DVec3::from_slice(&right("basis", 200, "n"));
    for factor in [2.0, 0.37, 13.0] {
        assert_eq!(verdict("basis", 200, "n", vector(&(n * factor).to_array())), "not-normalised");
        let told = verdict("basis", 200, "n", vector(&(-n * factor).to_array()));
        assert_eq!(told, "n-reversed+not-normalised");
    }
}

/// The four usual wrong answers to `[0]` 5.1.
#[test]
fn exchanged_projections_and_spaces_in_5_1_are_recognised() {
    let root = "1/√2";
    for (name, answer, code) in [
        ("parallel_origin", "[3, 4, 0]".to_owned(), "projections-exchanged"),
        ("parallel_origin", "[4, 5, 0]".to_owned(), "view-as-world"),
        ("perspective_origin", "[11/5, 23/5, -1]".to_owned(), "projections-exchanged"),
        ("perspective_direction", format!("[{root}, {root}, 0]"), "view-as-world"),
        ("perspective_direction", "[-3/5, -4/5, 0]".to_owned(), "projections-exchanged"),
    ] {
        let told = verdict("0-5.1", 0, name, &*answer);
        assert!(is_one_of(&told, code), "{name} {answer}: {told}");
    }
}

/// B5.
#[test]
fn portuguese_statements_do_not_mix_separators() {
    let is_decimal = |text: &str| {
        let bytes = text.as_bytes();
        bytes.windows(3).any(|w| w[0].is_ascii_digit() && w[1] == b',' && w[2].is_ascii_digit())
    };
    for entry in camera_lab::exercises::entries() {
        for seed in 0..if entry.is_family { 20 } else { 1 } {
            let exercise = entry.exercise(seed, &Free::new());
            for paragraph in said::statement(Lang::PtBr, &exercise) {
                for group in paragraph.split('(').skip(1).filter_map(|rest| rest.split(')').next()) {
                    assert!(!(is_decimal(group) && group.contains(", ")), "{} {seed}: ({group})", entry.id);
                }
            }
        }
    }
}
