//! The report: its keys and their order, its numbers as text, and its refusals.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{Convention, ImageSize, Operation, Parameters, Projection, ViewWindow};
use camera_lab_figures::figure::Figure;
use camera_lab_figures::inspect::{InspectError, Report};
use glam::DVec3;
use serde_json::Value;

const KEYS: [&str; 17] = [
    "camera",
    "dop",
    "distance",
    "basis",
    "window",
    "lens",
    "ndc",
    "view_matrix",
    "projection_matrix",
    "view_projection_matrix",
    "inverse_view_matrix",
    "inverse_projection_matrix",
    "volume_corners",
    "planes",
    "points",
    "rays",
    "warnings",
];

fn figure(change: impl FnOnce(&mut Parameters)) -> Figure {
    let mut figure = Figure::default();
    change(&mut figure.camera);
    figure
}

fn report(figure: &Figure, points: &[DVec3], pixels: &[[i64; 2]]) -> Result<Report, InspectError> {
    Report::new(figure, &[], Convention::RightHand, points, pixels)
}

fn json(report: &Report) -> Value {
    serde_json::from_str(&report.to_json()).unwrap()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn keys_stand_in_the_order_of_the_contract() {
    let window = ViewWindow { left: -1.0, right: 2.0, bottom: -3.0, top: 4.0 };
    let figure = figure(|p| p.window = Some(window));
    let found = json(&report(&figure, &[DVec3::ZERO], &[[3, 4]]).unwrap());
    assert_eq!(keys(&found), KEYS);
    let camera =
        ["position", "focal_point", "view_up", "projection", "view_angle", "height", "aspect", "near", "far", "window"];
    assert_eq!(keys(&found["camera"]), camera);
    assert_eq!(keys(&found["camera"]["window"]), ["left", "right", "bottom", "top"]);
    assert_eq!(keys(&found["basis"]), ["u", "v", "n"]);
    assert_eq!(keys(&found["window"]), ["left", "right", "bottom", "top", "width", "height", "aspect"]);
    assert_eq!(keys(&found["points"][0]), ["world", "view", "clip", "ndc", "window", "pixel", "viewport", "inside"]);
    assert_eq!(keys(&found["rays"][0]), ["pixel", "origin", "direction"]);
    assert_eq!(keys(&found["warnings"][0]), ["code", "message"], "3/7 is not the image's aspect");
    assert!(found["points"][0]["pixel"][0].is_i64() && found["points"][0]["viewport"][1].is_i64());
    let plain = json(&report(&Figure::default(), &[], &[]).unwrap());
    assert!(plain["camera"].get("window").is_none());
    assert_eq!(plain["camera"]["projection"], "perspective");
    assert_eq!(
        (&plain["points"], &plain["rays"], &plain["warnings"]),
        (&Value::from([0; 0]), &Value::from([0; 0]), &Value::from([0; 0]))
    );
}

#[test]
fn vectors_and_rows_stand_on_one_line() {
    let text = report(&Figure::default(), &[DVec3::ZERO], &[]).unwrap().to_json();
    assert!(text.starts_with("{\n  \"camera\": {\n    \"position\": [3.0, 4.0, 5.0],\n"), "{text}");
    assert!(text.contains("\n    [0.0, 0.0, -1.0, 0.0]\n  ],\n"), "{text}");
    assert!(text.contains("      \"inside\": true\n    }\n  ],\n  \"rays\": [],\n  \"warnings\": []\n}\n"), "{text}");
}

#[test]
fn numbers_read_back_as_the_same_numbers() {
    let awkward = [1.0 / 3.0, 1e-5 + f64::EPSILON, 123_456_789.123_456_78];
    let point = DVec3::new(1e23, -2.5e-7, 5e-324);
    let figure = figure(|p| {
        p.position = DVec3::from_array(awkward);
        p.near = 1e-7;
        p.far = 9_007_199_254_740_993.0;
    });
    let report = report(&figure, &[point], &[[-7, 1_000_000_007]]).unwrap();
    let text = report.to_json();
    // Not by serde_json, whose reader may be wrong in the last digit.
    let numbers = |start: &str| -> Vec<u64> {
        let line = text.split_once(start).unwrap().1.trim_start_matches('[').split([']', '\n']).next().unwrap();
        line.split(", ").map(|x| x.trim_end_matches(',').parse::<f64>().unwrap().to_bits()).collect()
    };
    assert_eq!(numbers("\"position\": "), awkward.map(f64::to_bits));
    assert_eq!(numbers("\"world\": "), point.to_array().map(f64::to_bits));
    assert_eq!(numbers("\"near\": "), [1e-7f64.to_bits()]);
    assert_eq!(numbers("\"dop\": "), report.dop.map(f64::to_bits));
    for row in 0..4 {
        let start = "\"view_projection_matrix\": [\n    ".to_owned()
            + &report.view_projection_matrix[..row].iter().map(|row| format!("{row:?},\n    ")).collect::<String>();
        assert_eq!(numbers(&start), report.view_projection_matrix[row].map(f64::to_bits), "{start}");
    }
    assert_eq!(json(&report)["rays"][0]["pixel"], serde_json::json!([-7, 1_000_000_007]));
    assert!(!report.to_json().contains("-0.0,"), "zero has no sign");
}

#[test]
fn pixels_far_outside_stay_whole_numbers() {
    let figure = figure(|p| (p.position, p.projection, p.aspect) = (DVec3::Z, Projection::Parallel, 1.0));
    let found = json(&report(&figure, &[DVec3::new(-1e9, 3e15, 0.0), DVec3::new(1e100, 0.0, 0.0)], &[]).unwrap());
    assert_eq!(found["points"][0]["pixel"][0].as_i64(), Some(-511_999_999_488));
    assert_eq!(found["points"][1]["pixel"][0].as_f64().map(f64::fract), Some(0.0));
    assert_eq!(found["points"][1]["inside"], Value::Bool(false));
}

#[test]
fn a_point_beside_the_eye_has_null_after_clip() {
    let figure = figure(|p| p.position = DVec3::new(0.0, 0.0, 5.0));
    let found = json(&report(&figure, &[DVec3::new(2.0, 1.0, 5.0)], &[]).unwrap());
    let point = &found["points"][0];
    assert_eq!(point["clip"][3].as_f64(), Some(0.0));
    for key in ["ndc", "window", "pixel", "viewport", "inside"] {
        assert!(point[key].is_null(), "{key}");
    }
}

#[test]
fn operations_come_in_their_order() {
    let operations: Vec<Operation> = ["yaw=90", "pan=1,0"].iter().map(|text| text.parse().unwrap()).collect();
    let figure = figure(|p| p.position = DVec3::new(0.0, 0.0, 5.0));
    let forth = Report::new(&figure, &operations, Convention::RightHand, &[], &[]).unwrap();
    assert_eq!(forth.camera.position, [0.0, 0.0, 4.0], "yaw first: u points along −z then");
    let operations: Vec<Operation> = operations.into_iter().rev().collect();
    let back = Report::new(&figure, &operations, Convention::RightHand, &[], &[]).unwrap();
    assert_eq!(back.camera.position, [1.0, 0.0, 5.0]);
}

#[test]
fn impossible_requests_are_named() {
    let message = |result: Result<Report, InspectError>| result.map(|_| ()).unwrap_err().to_string();
    assert!(message(report(&figure(|p| p.near = -1.0), &[], &[])).contains("near is -1.0"));
    let zoom = [Operation::Zoom(1e-320)];
    let found = message(Report::new(&Figure::default(), &zoom, Convention::RightHand, &[], &[]));
    assert!(found.contains("zoom"), "{found}");
    let figure = figure(|p| (p.position, p.projection) = (DVec3::Z, Projection::Parallel));
    for point in [DVec3::new(1e308, 1.5e308, 0.0), DVec3::NAN, DVec3::new(0.0, f64::INFINITY, 0.0)] {
        let found = message(report(&figure, &[point], &[]));
        assert!(found.starts_with("point "), "{found}");
    }
    let empty = Figure { image: ImageSize { width: 0, height: 10 }, ..figure };
    assert!(message(report(&empty, &[], &[[1, 2]])).contains("pixel 1,2"));
}
