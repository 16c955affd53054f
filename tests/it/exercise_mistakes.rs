//! Every known mistake, made by hand, gets its code, and the command line judges as the contract says.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;

use camera_lab::exercises::{Free, Judged, check, entry};

use crate::common::program::Bench;

fn judge(id: &str, seed: u64, name: &str, answer: &str) -> Judged {
    let entry = entry(id).unwrap();
    let exercise = entry.exercise(seed, &Free::new());
    let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    check(entry, &exercise, ask, answer).unwrap()
}

fn codes(judged: &Judged) -> Vec<&'static str> {
    judged.diagnosis.iter().flat_map(|found| &found.causes).map(|cause| cause.mistake.code()).collect()
}

/// M_v of `view-matrix` with seed 1, C = (2, 1, 1), by hand: **n** = (3, 1, 2)/√14, **u** = (2, 0, −3)/√13, **v** =
/// (−3, 13, −2)/√182.
fn view_matrix(last: [&str; 3]) -> String {
    let [x, y, z] = last;
    format!("[[2/√13, 0, -3/√13, {x}], [-3/√182, 13/√182, -2/√182, {y}], [3/√14, 1/√14, 2/√14, {z}], [0, 0, 0, 1]]")
}

/// M_p of `perspective-matrix` with seed 1, by hand: θ = 50°, A = 5/4, F = 2/5, B = 8.
fn projection_matrix([first, second]: [&str; 2], [scale, shift]: [&str; 2], w: &str) -> String {
    format!("[[{first}, 0, 0, 0], [0, {second}, 0, 0], [0, 0, {scale}, {shift}], [0, 0, {w}, 0]]")
}

#[test]
fn each_mistake_gets_its_code() {
    // θ = 50°, A = 5/4.
    let perspective = ["4/5/tan(25°)", "1/tan(25°)"];
    let depth = ["-21/19", "-16/19"];
    assert!(judge("view-matrix", 1, "Mv", &view_matrix(["-1/√13", "-5/√182", "-9/√14"])).right);
    assert!(judge("perspective-matrix", 1, "Mp", &projection_matrix(perspective, depth, "-1")).right);
    let cases: [(&str, &str, String, &str); 24] = [
        // The others have theirs in `exercise_verdicts` and `exercise_slips`.
        ("perspective-matrix", "Mp", projection_matrix(["4/5/tan(25°)", "1.5"], depth, "-1"), "arithmetic-slip"),
        ("perspective-matrix", "Mp", projection_matrix(["-4/5/tan(25°)", "1/tan(25°)"], depth, "-1"), "sign"),
        // C − PF = (1, 1, 1), VUP = (0, 1, 0).
        ("basis", "n", "[-1/√3, -1/√3, -1/√3]".to_owned(), "n-reversed"),
        ("basis", "u", "[-1/√2, 0, 1/√2]".to_owned(), "u-reversed"),
        ("basis", "v", "[0, 1, 0]".to_owned(), "vup-as-v"),
        ("basis", "n", "[1, 1, 1]".to_owned(), "not-normalised"),
        (
            "view-matrix",
            "Mv",
            "[[2/√13, -3/√182, 3/√14, 0], [0, 13/√182, 1/√14, 0], [-3/√13, -2/√182, 2/√14, 0], [-1/√13, -5/√182, -9/√14, 1]]"
                .to_owned(),
            "transposed",
        ),
        (
            "view-matrix",
            "Mv",
            "[[2/√13, -3/√182, 3/√14, 2], [0, 13/√182, 1/√14, 1], [-3/√13, -2/√182, 2/√14, 1], [0, 0, 0, 1]]".to_owned(),
            "inverse",
        ),
        ("view-matrix", "Mv", view_matrix(["-2", "-1", "-1"]), "translation-not-rotated"),
        ("view-matrix", "Mv", view_matrix(["1/√13", "5/√182", "9/√14"]), "position-not-negated"),
        // θ = 40°, A = 5/4, F = 2/5, and the tangent of 20 rad.
        ("window", "H", "0.8*2.2371609442247422".to_owned(), "radians"),
        ("window", "H", "0.8*tan(40°)".to_owned(), "whole-angle"),
        ("window", "W", "0.8*tan(20°)/1.25".to_owned(), "aspect-inverted"),
        // θ = 40°, s = 3.
        ("zoom", "theta", "40/3".to_owned(), "zoom-on-angle"),
        // The point is (1/(2√5), −7/(3√5), −25/6) in the VRC, with θ = 50°, A = 4/3, F = 3/2, B = 75/2.
        ("ndc", "ndc", "[0.5/√5*3/4/tan(25°), -7/(3√5)/tan(25°), 25/18]".to_owned(), "no-divide"),
        ("perspective-matrix", "Mp", projection_matrix(perspective, depth, "1"), "z-sign"),
        ("perspective-matrix", "Mp", projection_matrix(perspective, ["-20/19", "-8/19"], "-1"), "z-range"),
        ("perspective-matrix", "Mp", projection_matrix(["-4/5/tan(25°)", "-1/tan(25°)"], ["-21/19", "16/19"], "-1"), "near-far-as-coordinates"),
        // x_p = −21/4 + (21/2)·15/84 = −3.375 and y_p = 3 − 6·47/48 = −2.875 along u = (−2, 3, 0)/√13 and v = (18, 12,
        // 13)/(7√13).
        (
            "ray",
            "origin",
            "[3 + 6.75/√13 - 51.75/(7√13), -10.125/√13 - 34.5/(7√13), -8 - 37.375/(7√13)]".to_owned(),
            "pixel-corner",
        ),
        // T(5, −4, 1), R(45° about z), S(3, 1, 1/2): S R T.
        (
            "order",
            "M",
            "[[3/√2, -3/√2, 0, 27/√2], [1/√2, 1/√2, 0, 1/√2], [0, 0, 0.5, 0.5], [0, 0, 0, 1]]".to_owned(),
            "order-reversed",
        ),
        // n = (1, 1, 1)/√3, u = (−1, 1, 0)/√2, v = (−1, −1, 2)/√6, and 45°: about v in place of u, and the other way.
        ("elevation", "n", "[1/√6 - 1/2, 1/√6 + 1/2, 1/√6]".to_owned(), "other-operation"),
        ("elevation", "n", "[1/√6 - 1/√12, 1/√6 - 1/√12, 1/√6 + 2/√12]".to_owned(), "opposite-angle"),
        ("window", "H", "0.29".to_owned(), "rounded-too-early"),
        ("basis", "u", "[1/√2, 0]".to_owned(), "wrong-shape"),
    ];
    for (id, name, answer, code) in &cases {
        let judged = judge(id, 1, name, answer);
        assert!(!judged.right && codes(&judged) == [*code], "{id} {name} {answer}: {code}, not {:?}", judged.diagnosis);
    }
    let told: BTreeSet<&str> = cases.iter().map(|(_, _, _, code)| *code).collect();
    assert_eq!(told.len(), cases.len());
}

#[test]
fn axes_in_the_columns_of_the_view_matrix_are_recognised() {
    let columns = |x: &str, y: &str, z: &str| {
        format!("[[2/√13, -3/√182, 3/√14, {x}], [0, 13/√182, 1/√14, {y}], [-3/√13, -2/√182, 2/√14, {z}], [0, 0, 0, 1]]")
    };
    let cases: [(String, &[&str]); 3] = [
        (columns("-1/√13", "-5/√182", "-9/√14"), &["transposed"]),
        (columns("-4/√13 + 3/√182 - 3/√14", "-13/√182 - 1/√14", "6/√13 + 2/√182 - 2/√14"), &["transposed"]),
        (columns("-2", "-1", "-1"), &["translation-not-rotated", "transposed"]),
    ];
    for (answer, expected) in &cases {
        let judged = judge("view-matrix", 1, "Mv", answer);
        assert!(!judged.right && codes(&judged) == *expected, "{answer}: {expected:?}, not {:?}", judged.diagnosis);
    }
}

#[test]
fn the_whole_angle_is_found_with_and_without_the_factor_of_two() {
    // θ = 40°, A = 5/4, F = 2/5: H = 2 F tan θ, H = F tan θ, and the W that follows.
    for (name, answer) in [("H", "0.8*tan(40°)"), ("H", "0.4*tan(40°)"), ("W", "0.5*tan(40°)")] {
        assert_eq!(codes(&judge("window", 1, name, answer)), ["whole-angle"], "{name} = {answer}");
    }
}

#[test]
fn two_mistakes_together_are_both_named() {
    // −C, not turned, beside axes in the columns.
    let matrix = "[[2/√13, -3/√182, 3/√14, -2], [0, 13/√182, 1/√14, -1], [-3/√13, -2/√182, 2/√14, -1], [0, 0, 0, 1]]";
    assert_eq!(codes(&judge("view-matrix", 1, "Mv", matrix)), ["translation-not-rotated", "transposed"]);
    // One number, or two, may come from anything: W = H/A with H = 2 F tan θ, and (j, i) with rows from the bottom.
    let [i, j] = [0, 1].map(|k| super::exercise_verdicts::right("pixel", 1, "pixel")[k]);
    for (id, name, answer) in
        [("window", "W", "0.8*tan(40°)/1.25".to_owned()), ("pixel", "pixel", format!("[{}, {i}]", 479.0 - j))]
    {
        assert_eq!(codes(&judge(id, 1, name, &answer)), [""; 0], "{id} {answer}");
    }
}

/// `[0]` 5.2 by hand: **n** = (6, −1, −1)/√38, **u** = (0, 1, −1)/√2, **v** = (1, 3, 3)/√19. After the zoom t = F/3 and
/// r = F/4.
#[test]
fn answers_that_depend_on_f_may_be_formulas_in_f() {
    let corner = |f: &str, of_v: &str| {
        format!("[7 + {of_v}/(3√19) - 6*{f}/√38, {f}/(4√2) + {f}/√19 + {f}/√38, {f}/√19 - {f}/(4√2) + {f}/√38]")
    };
    assert!(judge("0-5.2", 0, "corner", &corner("F", "F")).right);
    assert!(judge("0-5.2", 0, "corner", &corner("5", "5")).right);
    // This fits F = 5 alone.
    let judged = judge("0-5.2", 0, "corner", &corner("F", "5"));
    assert!(!judged.right && judged.entries == [[false], [true], [true]], "{judged:?}");
}

#[test]
fn every_camera_of_the_family_is_right() {
    for camera in [
        "position=[0, 0, 2]; focal_point=[0, 0, 0]; projection=parallel; height=2; aspect=1; near=1; far=3",
        "position=[0, 0, 11]; focal_point=[0, 0, 3]; projection=parallel; height=2; aspect=1; near=10; far=12",
        "position=[5, 0, 0]; focal_point=[0, 0, 0]; projection=parallel; height=2; aspect=1; near=4; far=6",
        "position=[0, -3, 0]; focal_point=[0, 0, 0]; view_up=[0, 0, 1]; projection=parallel; height=2; aspect=1; near=2; far=4",
    ] {
        let judged = judge("0-5.3", 0, "camera", camera);
        assert!(judged.right, "{camera}: {judged:?}");
    }
    let tall = "position=[0, 0, 2]; focal_point=[0, 0, 0]; projection=parallel; height=4; aspect=1; near=1; far=3";
    assert!(!judge("0-5.3", 0, "camera", tall).right);
}

#[test]
fn the_command_line_judges_as_the_contract_says() {
    let bench = Bench::new("exercise-check");
    let run = |answers: &[&str]| {
        let mut arguments = vec!["exercise", "check", "0-5.1", "--format", "json"];
        arguments.extend(answers.iter().flat_map(|answer| ["--answer", answer]));
        bench.run(&arguments)
    };
    let right = run(&["parallel_origin=[2,2; 4,6; -1]", "perspective_origin=[6/2, 4, 0]"]).json();
    assert_eq!((&right["right"], right["answers"].as_array().unwrap().len()), (&true.into(), 2));
    assert_eq!(right["answers"][0]["diagnosis"], serde_json::Value::Null);
    // An unknown name costs its own part alone.
    let part = run(&["parallel_origin=[11/5, ?, -1]"]);
    let judged: serde_json::Value = serde_json::from_slice(&part.out).unwrap();
    assert_eq!((part.status, &judged["right"]), (Some(1), &false.into()));
    assert_eq!(judged["answers"][0]["entries"], serde_json::json!([[true], [false], [true]]));
    assert!((judged["answers"][0]["score"].as_f64().unwrap() - 2.0 / 3.0).abs() < 1e-12);
    let wrong = run(&["parallel_direction=[3/5, 4/5, 0]"]);
    let judged: serde_json::Value = serde_json::from_slice(&wrong.out).unwrap();
    let diagnosis = &judged["answers"][0]["diagnosis"];
    assert_eq!((wrong.status, diagnosis["code"].as_str()), (Some(1), Some("sign")));
    assert!(!diagnosis["message"].as_str().unwrap().is_empty() && diagnosis["hints"].as_array().unwrap().len() >= 2);
    assert_eq!(diagnosis["others"], serde_json::json!(["n-reversed"]));
    // An unreadable answer is not judged, and neither is the one beside it.
    for answers in [
        &["parallel_origin=[11/5, 23/5, -1"][..],
        &["parallel_origin=[11/5, 23/5, -1]", "parallel_direction=[3/5, 4/, 0]"],
        &["parallel_origin"],
        &["elsewhere=1"],
        &["parallel_origin=[1, 2, 3]", "parallel_origin=[1, 2, 3]"],
    ] {
        run(answers).refused(2);
    }
    let angle = bench.run(&["exercise", "check", "zoom", "--seed", "1", "--answer", "theta=2*atan(tan(20°)/3)"]);
    assert_eq!(angle.status, Some(0), "{}", angle.err);
}
