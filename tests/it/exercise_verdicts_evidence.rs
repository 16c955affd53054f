//! Verdicts on answers that look like a known mistake, or like none: a reason needs numbers that show it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Parameters, Projection, ViewWindow};
use camera_lab::exercises::{Answer, Expected, Judged, entry, read_answer};
use camera_lab::expression::{Dimension, evaluate};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;
use glam::DVec3;

use super::exercise_verdicts::{exercise, right, text, together, told, verdict};

/// The verdicts on answers as they were typed.
fn typed(id: &str, seed: u64, answers: &[(&str, &str)]) -> Vec<Judged> {
    let answers: Vec<(&str, String)> = answers.iter().map(|(name, text)| (*name, (*text).to_owned())).collect();
    together(id, seed, &answers)
}

#[test]
fn a_camera_has_the_tolerance_of_its_box() {
    let camera = |aspect: &str| format!("C=(-2,-1,8); PF=(-2,-1,3); projection=parallel; H=6; A={aspect}; F=1; B=9");
    for (aspect, right) in [("0.6667", true), ("0.667", true), ("2/3", true), ("0.66", false), ("0.867", false)] {
        let judged = typed("canonical-camera", 4, &[("camera", &camera(aspect))]).remove(0);
        assert_eq!(judged.right, right, "{aspect}");
    }
    assert_eq!(verdict("canonical-camera", 4, "camera", camera("1.5")), "aspect-inverted");
    let cube = |height: &str| format!("C=(0,0,2); PF=(0,0,0); projection=parallel; H={height}; A=1; F=1; B=3");
    assert!(typed("0-5.3", 0, &[("camera", &cube("1.9999"))]).remove(0).right);
    assert!(!typed("0-5.3", 0, &[("camera", &cube("1.98"))]).remove(0).right);
}

#[test]
fn one_number_is_no_evidence_of_a_mistake_beside_another_one() {
    let other_row = "[[1/3,0,0,0],[0,0.5,0,0],[0,0,-5/39,-41/39],[0,0,-1,0]]";
    assert_eq!(verdict("parallel-matrix", 600, "Mp", other_row), "projections-exchanged");
    for (lang, words) in [(Lang::En, "The last row"), (Lang::PtBr, "A última linha")] {
        assert!(text("parallel-matrix", 600, "Mp", other_row, lang).contains(words));
    }
    let depth = "[[0.5,0,0,0],[0,1,0,0],[0,0,-1.11111,-1.22222],[0,0,-1,0]]";
    assert_eq!(verdict("perspective-matrix", 600, "Mp", depth), "");
}

#[test]
fn whole_pixels_are_not_rounded_and_points_have_no_length() {
    assert_eq!(verdict("viewport", 309, "viewport", "[140,170,0.92306]"), "");
    assert!(!verdict("viewport", 608, "viewport", "[155,120,0.923646]").contains("not-normalised"));
    assert_eq!(verdict("pixel", 706, "pixel", "[200,149]"), "");
}

#[test]
fn a_lost_sign_is_named_alone_if_an_axis_is_right_else_beside_it() {
    let view = ("view", "[-1.11803,-1.36931,-3.06186]");
    let judged = typed("ndc", 303, &[view, ("clip", "[0.496904,-0.456435,-0.573023,1]")]);
    assert_eq!(judged.iter().map(told).collect::<Vec<_>>(), ["", "sign"]);
    let view = right("ndc", 300, "view");
    let turned = format!("[{:.6}, {:.6}, {:.6}]", -view[0], view[1], view[2]);
    assert_eq!(verdict("ndc", 300, "view", turned), "u-reversed|sign");
    let turned = format!("[{:.6}, {:.6}, {:.6}]", view[0], -view[1], view[2]);
    assert_eq!(verdict("ndc", 300, "view", turned), "v-reversed|sign");
}

#[test]
fn zeros_and_single_digits_are_no_evidence() {
    for (id, seed, name, answer) in [
        ("depth-resolution", 300, "Z", "1"),
        ("ndc", 300, "clip", "[1,2,3,3]"),
        ("ndc", 301, "clip", "[0,0,12.6,13]"),
        ("pixel", 307, "window", "[0,0]"),
        ("painter", 702, "order", "[1,2,3,4]"),
    ] {
        assert_eq!(verdict(id, seed, name, answer), "", "{id} {seed} {name} {answer}");
    }
}

#[test]
fn nothing_follows_from_nothing() {
    let judged = typed("window", 501, &[("H", "0"), ("W", "0"), ("r", "0"), ("b", "0")]);
    assert!(judged.iter().all(|judged| judged.carried.is_empty() && judged.score < 1e-12), "{judged:?}");
    let judged = typed("painter", 702, &[("depths", "[1, 1, 1, 1]"), ("order", "[1, 2, 3, 4]")]);
    assert!(judged[1].carried.is_empty());
}

#[test]
fn the_plane_of_a_right_point_is_not_blamed_on_its_depth() {
    let answers = [("clip", "[0.111631,-0.600879,-1.1462,1]"), ("inside", "no"), ("plane", "far")];
    let judged = typed("inside", 0, &answers);
    let exercise = exercise("inside", 0);
    let said = said::diagnosis(Lang::En, &exercise.asks[2], &judged[2]).unwrap();
    assert!(judged[0].right && said.contains("planes are exchanged") && !said.contains("sign"), "{said}");
}

#[test]
fn hints_are_those_of_the_question() {
    let of_order = text("order", 3, "P", "[2,15,3]", Lang::En);
    assert!(!of_order.contains("name of each number"), "{of_order}");
    let of_segment = text("clip-segment", 6, "P", "[0.5,0.5,2.75,2.75]", Lang::En);
    assert!(of_segment.contains("t = 0 at A") && !of_segment.contains("name of each number"), "{of_segment}");
    let of_turn = text("order", 3, "P", "[1,-2,3]", Lang::En);
    assert!(!of_turn.contains("M_v") && !of_turn.contains("block R"), "{of_turn}");
}

#[test]
fn a_wrong_shape_is_named_with_the_expected_one() {
    for (lang, words) in [(Lang::En, "Expected 1 number, got 2."), (Lang::PtBr, "Esperava-se 1 número")] {
        assert!(text("window", 1, "H", "[1;2]", lang).contains(words));
    }
    let exercise = exercise("basis", 1);
    let ask = exercise.asks.iter().find(|ask| ask.name == "n").unwrap();
    for answer in ["[0.577,0.577,0.577]^2", "[1,1,1] unit"] {
        let error = read_answer(answer, ask, &[]).unwrap_err();
        assert!(said::answer_error(Lang::En, &error).contains("sqrt(3)"), "{answer}: {error:?}");
        assert!(said::answer_error(Lang::PtBr, &error).contains("sqrt(3)"), "{answer}");
    }
}

/// A camera of an answer, read as it is typed.
fn camera(text: &str) -> Result<Parameters, String> {
    let exercise = exercise("canonical-camera", 4);
    let read = read_answer(text, &exercise.asks[0], &[]);
    match read {
        Ok(Answer::Camera(parameters)) => Ok(*parameters),
        other => Err(said::answer_error(Lang::En, &other.unwrap_err())),
    }
}

#[test]
fn cameras_are_written_as_in_the_notes_and_read_back_exactly() {
    let ask = &exercise("canonical-camera", 4).asks[0];
    let window = ViewWindow { left: -0.1, right: 1.0 / 3.0, bottom: -0.25, top: 0.7 };
    let odd = Parameters {
        position: DVec3::new(1.0 / 3.0, -2.5, 1e-7),
        view_angle: 50.1,
        height: 0.1 + 0.2,
        ..Parameters::default()
    };
    let parallel = Parameters { projection: Projection::Parallel, ..odd };
    for (parameters, en, pt) in [
        (odd, "projection = perspective; θ = 50.1; A = ", "projeção = perspectiva; θ = 50,1; A = "),
        (
            parallel,
            "projection = parallel; H = 0.30000000000000004; A",
            "projeção = paralela; H = 0,30000000000000004; A",
        ),
        (Parameters { window: Some(window), ..odd }, "window = (-0.1, 0.33", "janela = (-0,1; 0,33"),
    ] {
        for (lang, part) in [(Lang::En, en), (Lang::PtBr, pt)] {
            let text = said::understood(lang, ask, &Answer::Camera(Box::new(parameters)));
            assert!(text.starts_with("C = (0") && text.contains(part), "{text}");
            assert!(!text.contains(['_', '"', '{']), "{text}");
            let again = camera(&text).unwrap();
            assert_eq!(
                (again.position, again.window, again.near),
                (parameters.position, parameters.window, parameters.near)
            );
            assert_eq!(again.projection, parameters.projection);
            if parameters.window.is_none() {
                let size = |p: &Parameters| if p.projection == Projection::Parallel { p.height } else { p.view_angle };
                assert_eq!((size(&again), again.aspect), (size(&parameters), parameters.aspect));
            }
        }
    }
}

#[test]
fn parameters_of_a_camera_may_stand_between_commas() {
    let apart = camera("C=(0,0,2); PF=(0,0,0); F=0.5; B=1/3+9").unwrap();
    for text in [
        "C=(0,0,2), PF=(0,0,0), F=0.5, B=1/3+9",
        "C=(0; 0; 2), PF=(0;0;0), F=0,5, B=1/3+9",
        "C=[0,0,2],PF=[0,0,0]\nF=.5,B=28/3",
    ] {
        let read = camera(text).unwrap();
        assert_eq!((read.position, read.near), (apart.position, apart.near), "{text}");
        assert!((read.far - apart.far).abs() < 1e-12, "{text}");
    }
}

#[test]
fn an_impossible_camera_is_refused_in_the_names_of_the_notes() {
    for (text, told) in [
        ("C=(0,0,2); F=0", "F must be greater than 0"),
        ("C=(0,0,2), F=-1", "F must be greater than 0"),
        ("F=2; B=1", "F must be less than B"),
        ("C=(1,1,1); PF=(1,1,1)", "PF must differ from C"),
        ("θ=180", "θ must be greater than 0° and less than 180°"),
        ("window=(1, 0, -1, 1)", "l must be less than r"),
        ("window=(1, 0)", "window is [1, 0]"),
        ("window={x", "window is"),
        ("C=(1, 2)", "C is [1, 2]"),
        ("F=abc", "F is"),
        ("F=1; near=2", "F appears twice"),
    ] {
        let error = camera(text).unwrap_err();
        assert!(error.contains(told), "{text}: {error}");
        assert!(!error.contains("[camera]") && !error.contains("TOML"), "{text}: {error}");
    }
}

/// B11.
#[test]
fn cameras_that_are_to_be_found_have_a_way() {
    for id in ["match-picture", "place-camera", "canonical-camera", "0-5.3"] {
        for seed in 0..5 {
            let exercise = exercise(id, seed);
            let ask = exercise.asks.last().unwrap();
            let Expected::Camera(_, model, ..) = ask.expected() else { panic!("{id}") };
            for lang in [Lang::En, Lang::PtBr] {
                let way = said::steps(lang, &exercise, ask, 6).join("\n");
                for (name, value) in ["C_x", "C_y", "C_z"].into_iter().zip(model.position.to_array()) {
                    let row = way.lines().skip_while(|line| !line.trim_start().starts_with(name)).nth(1).unwrap();
                    let (_, end) = row.rsplit_once("= ").unwrap();
                    let told = evaluate(end, Dimension::Number).unwrap();
                    assert!(
                        (told - value).abs() <= 1e-5 * value.abs(),
                        "{id} {seed} {lang:?}: {name} = {value} in {way}"
                    );
                }
            }
        }
    }
}

/// B12.
#[test]
fn an_operation_not_in_the_notes_cites_its_derivation() {
    for (id, source) in [("dolly", "[0] §5.2, (5.2)"), ("pan", "[0] §5.2, (5.3)"), ("zoom-or-dolly", "[0] §5.6, (5.5)")]
    {
        assert_eq!(entry(id).unwrap().source, source, "{id}");
    }
}
