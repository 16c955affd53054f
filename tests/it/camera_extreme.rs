//! Cameras at the borders of `f64`, and long chains of operations, against values that were computed with 360 digits:
//! each number must be the nearest `f64`, or its neighbour.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::Bench;

/// The value at a path such as `points.0.clip`.
fn at<'a>(value: &'a Value, path: &str) -> &'a Value {
    path.split('.').fold(value, |value, key| key.parse::<usize>().map_or(&value[key], |index| &value[index]))
}

/// What differs by more than one unit in the last place, or, for what is 0 or nearly so beside the `size` of its
/// neighbours, by more than 106 bits can tell.
fn difference(found: &Value, expected: &Value, size: f64) -> Option<String> {
    match (found, expected) {
        (Value::Array(found), Value::Array(expected)) if found.len() == expected.len() => {
            let size = expected.iter().filter_map(Value::as_f64).fold(size, |size, x| size.max(x.abs()));
            found.iter().zip(expected).find_map(|(found, expected)| difference(found, expected, size))
        }
        (Value::Number(found), Value::Number(expected)) => {
            let (found, expected) = (found.as_f64().unwrap(), expected.as_f64().unwrap());
            let ulp = expected.abs().next_up() - expected.abs();
            let good = (found - expected).abs() <= ulp.max(size * 1e-26);
            (!good).then(|| format!("{found:?} instead of {expected:?}"))
        }
        _ => (found != expected).then(|| format!("{found} instead of {expected}")),
    }
}

#[test]
fn every_digit_is_right() {
    let bench = Bench::new("extreme");
    let cases: Vec<Value> = serde_json::from_str(include_str!("../figures/extreme.json")).unwrap();
    assert_eq!(cases.len(), 29);
    let mut wrong = Vec::new();
    for case in &cases {
        bench.write("figure.toml", case["figure"].as_str().unwrap());
        let arguments: Vec<&str> = case["arguments"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        let report = bench.run(&[&["inspect", "figure.toml"], &arguments[..], &["--format", "json"]].concat()).json();
        for (path, expected) in case["expect"].as_object().unwrap() {
            if let Some(difference) = difference(at(&report, path), expected, 0.0) {
                wrong.push(format!("{}: {path}: {difference}", case["tag"]));
            }
        }
    }
    assert!(wrong.is_empty(), "{} differences:\n{}", wrong.len(), wrong.join("\n"));
}
