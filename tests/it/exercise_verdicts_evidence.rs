//! Verdicts on answers that look like a known mistake, or like none: what is told needs numbers that show it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::{Judged, read_answer};
use camera_lab::i18n::{Lang, exercises as said};

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
    let other_row = "[[0.333333,0,0,0],[0,0.5,0,0],[0,0,-0.0833333,-1.08333],[0,0,-1,0]]";
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
fn a_lost_sign_is_told_where_an_axis_is_right_and_beside_it_otherwise() {
    let view = ("view", "[-1.11803,-1.36931,-3.06186]");
    let judged = typed("ndc", 303, &[view, ("clip", "[0.496904,-0.456435,-0.573023,1]")]);
    assert_eq!(judged.iter().map(told).collect::<Vec<_>>(), ["", "sign"]);
    assert_eq!(verdict("ndc", 300, "view", "[-1.41421,1.17851,-3.33333]"), "u-reversed|sign");
    let view = right("ndc", 300, "view");
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
fn shapes_and_brackets_are_told_as_they_are() {
    for (lang, words) in [(Lang::En, "Expected 1 number, got 2."), (Lang::PtBr, "Esperava-se 1 número")] {
        assert!(text("window", 1, "H", "[1;2]", lang).contains(words));
    }
    let exercise = exercise("basis", 1);
    let ask = exercise.asks.iter().find(|ask| ask.name == "n").unwrap();
    for answer in ["[1,1,1]/sqrt3", "[0.577,0.577,0.577]^T"] {
        let error = read_answer(answer, ask, &[]).unwrap_err();
        assert!(said::answer_error(Lang::En, &error).contains("sqrt(3)"), "{answer}: {error:?}");
        assert!(said::answer_error(Lang::PtBr, &error).contains("sqrt(3)"), "{answer}");
    }
}
