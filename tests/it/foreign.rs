//! Cameras of other programs, through the command line: `tests/cameras/make.py` makes them from published conventions.

use glam::DVec3;
use serde_json::Value;

use crate::common::program::{Bench, Run};

const CASES: &str = include_str!("../cameras/cases.json");

fn at<'a>(tree: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').try_fold(tree, |at, key| match at {
        Value::Array(items) => items.get(key.parse::<usize>().ok()?),
        other => other.get(key),
    })
}

/// A pattern of the cases: words with `.*` between them, and alternatives.
fn matches(pattern: &str, text: &str) -> bool {
    let text = text.to_lowercase();
    pattern.to_lowercase().split('|').any(|way| {
        let mut rest = text.as_str();
        way.split(".*").all(|part| match rest.split_once(part) {
            Some((_, behind)) => {
                rest = behind;
                true
            }
            None => false,
        })
    })
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => other.as_f64().into_iter().collect(),
    }
}

fn vector(value: &Value) -> DVec3 {
    match numbers(value)[..] {
        [x, y, z] => DVec3::new(x, y, z),
        _ => panic!("{value} is no vector"),
    }
}

/// Whether C, DOP and **v** are as expected, in the world of the program or in the one that the guide names.
fn has_pose(camera: &Value, expected: &Value, tolerance: f64, worlds: &Value) -> bool {
    let [position, focal_point, up] = ["position", "focal_point", "view_up"].map(|key| vector(&camera[key]));
    let dop = (focal_point - position).normalize();
    let found = [position, dop, (up - dop * up.dot(dop)).normalize()];
    let expected = ["C", "dop", "up"].map(|key| vector(&expected[key]));
    worlds.as_array().into_iter().flatten().filter_map(Value::as_str).any(|world| {
        let here = |v: DVec3| match world {
            "turned" => DVec3::new(v.x, v.z, -v.y),
            "z-reversed" => DVec3::new(v.x, v.y, -v.z),
            _ => v,
        };
        let size = 1.0 + expected[0].length();
        found.iter().zip(expected).all(|(found, expected)| (*found - here(expected)).length() <= tolerance * size)
    })
}

/// The mismatch with one expectation.
fn fault(check: &Value, run: &Run, tree: &Value) -> Option<String> {
    let said = || format!("{}{}", String::from_utf8_lossy(&run.out), run.err);
    if let Some(status) = check["rc"].as_i64() {
        return (run.status.map(i64::from) != Some(status)).then(|| format!("{:?}: {}", run.status, run.err));
    }
    if let Some(pattern) = check["says"].as_str() {
        return (!matches(pattern, &said())).then(|| format!("/{pattern}/ is not in {}", said()));
    }
    let tolerance = check["a"].as_f64().unwrap_or(0.0);
    if check.get("pose").is_some() {
        let good = has_pose(&tree["camera"], &check["pose"], tolerance, &check["worlds"]);
        return (!good).then(|| format!("{} is not {}", tree["camera"], check["pose"]));
    }
    let path = check["path"].as_str().unwrap_or_default();
    let Some(found) = at(tree, path) else { return Some(format!("no {path}")) };
    let good = match check["m"].as_str() {
        Some(pattern) => matches(pattern, &found.to_string()),
        None => {
            let (found, expected) = (numbers(found), numbers(&check["v"]));
            let slack = |x: f64| tolerance + check["r"].as_f64().unwrap_or(1e-9) * x.abs();
            found.len() == expected.len() && found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= slack(*b))
        }
    };
    (!good).then(|| format!("{path} is {found}, expected {check}"))
}

#[test]
fn cameras_of_other_programs_are_read_as_they_publish_them() {
    let cases: Value = serde_json::from_str(CASES).expect("JSON");
    let cases = cases["cases"].as_array().expect("a list");
    assert!(cases.len() > 50);
    let mut faults = Vec::new();
    for case in cases {
        let bench = Bench::new("foreign");
        bench.write("empty.toml", "");
        for (name, text) in case["files"].as_object().into_iter().flatten() {
            bench.write(name, text.as_str().unwrap_or_default());
        }
        let arguments: Vec<&str> = case["args"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        let run = bench.run(&arguments);
        let tree = serde_json::from_slice(&run.out).unwrap_or(Value::Null);
        let expected = case["expect"].as_array().into_iter().flatten();
        faults.extend(expected.filter_map(|check| Some(format!("{}: {}", case["id"], fault(check, &run, &tree)?))));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// At the corner (0.64, 0.48): r² = 0.64, and −0.21 r² + 0.05 r⁴ = −0.11392 of 0.8 × 500 pixels.
#[test]
fn a_distortion_is_named_with_its_shift_at_the_corner() {
    let bench = Bench::new("distortion");
    let text = r#"{"camera_model": "OPENCV", "fl_x": 500, "fl_y": 500, "cx": 320, "cy": 240, "w": 640, "h": 480,
        "k1": -0.21, "k2": 0.05,
        "frames": [{"transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3], [0, 0, 0, 1]]}]}"#;
    bench.write("transforms.json", text);
    bench.write("figure.toml", "");
    let run = bench.run(&["matrix", "figure.toml", "--from", "transforms.json", "--format", "json"]);
    let answer: Value = serde_json::from_slice(run.done()).unwrap_or_default();
    let reason = at(&answer, "left_out.0.reason").and_then(Value::as_str).unwrap_or_default();
    assert!(reason.contains("45.6") && reason.contains("-0.21 0.05"), "{reason}");
}
