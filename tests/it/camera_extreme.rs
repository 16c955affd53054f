//! Cameras at the borders of `f64`, and long chains of operations, against values that were computed with 360 digits:
//! each number must be the nearest `f64`, or its neighbour.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Convention, ImageSize, Operation, Parameters, Projection, Viewport};
use camera_lab::chain::real::Real;
use camera_lab::chain::{self, Vector};
use camera_lab::geometry::Angle;
use camera_lab::numerics::reference::Reference;
use glam::DVec3;
use serde_json::Value;

use crate::common::program::Bench;

/// The value at a path such as `points.0.clip`.
fn at<'a>(value: &'a Value, path: &str) -> &'a Value {
    path.split('.').fold(value, |value, key| key.parse::<usize>().map_or(&value[key], |index| &value[index]))
}

/// A component that differs by more than one unit in the last place or, if it is 0 or nearly so beside the `size` of
/// its neighbours, by more than 106 bits can tell.
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

/// A camera as many powers of ten from the origin as PF is near it, with this projection.
fn far_away(decade: i32, projection: Projection) -> Parameters {
    Parameters {
        position: DVec3::new(-5.98, 10.1, -7.85) * 10_f64.powi(decade),
        focal_point: DVec3::new(-1.71, -0.02, 1.75),
        view_up: DVec3::new(-0.39, 0.59, 0.95),
        projection,
        near: 10_f64.powi(decade - 2),
        far: 10_f64.powi(decade + 2),
        ..Parameters::default()
    }
}

/// Equal, or neighbours.
fn is_nearest(found: f64, exact: f64) -> bool {
    (found - exact).abs() <= exact.abs().next_up() - exact.abs()
}

/// With C so far away, p − C has no digits left of p. Compared with 512 bits, in which **u** · (p − C) = **u** · (p −
/// PF) is computed from PF, so that nothing cancels, and with a value of 1500 digits.
#[test]
fn a_camera_however_far_away_keeps_every_digit() {
    const ENTRY: f64 = -1.423_883_761_860_283_6;
    let image = ImageSize { width: 640, height: 480 };
    let p = DVec3::new(0.3, -1.7, 2.9);
    for decade in 10..=160 {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let parameters = far_away(decade, projection);
            let camera = Camera::new(&parameters).unwrap();
            let basis = chain::basis::<Reference>(&chain::pose(&parameters));
            let from = |point: DVec3| Vector::<Reference>::of(point).minus(&Vector::of(parameters.focal_point));
            let distance = from(parameters.position).length();
            let exact = |point: DVec3| {
                let [u, v, n] = [0, 1, 2].map(|i| basis[i].dot(&from(point)));
                [u.to_f64(), v.to_f64(), (n - distance.clone()).to_f64()]
            };
            let matrix = camera.view_from_world();
            let stations = camera.stations(p, image, &Viewport::whole(image));
            let found = [matrix.w_axis.truncate(), stations.view].map(|v| v.to_array());
            for (found, exact) in found.into_iter().zip([exact(DVec3::ZERO), exact(p)]) {
                let good = found.into_iter().zip(exact).all(|(found, exact)| is_nearest(found, exact));
                assert!(good, "C · 1e{decade}, {projection:?}: {found:?} instead of {exact:?}");
            }
            if decade >= 18 {
                assert!(is_nearest(matrix.w_axis.x, ENTRY), "C · 1e{decade}: {}", matrix.w_axis.x);
            }
            if projection == Projection::Parallel {
                let projected = stations.projected.unwrap();
                let exact = exact(p)[0] * 2.0 / camera.window_width();
                assert!((projected.ndc.x - exact).abs() <= 4.0 * f64::EPSILON * exact.abs(), "C · 1e{decade}");
            }
        }
    }
}

/// A turn about PF moves C, and its rounding error is as large as the world near PF. The sideways coordinates come from
/// PF all the same.
#[test]
fn a_far_camera_that_has_turned_about_pf_keeps_every_digit() {
    let image = ImageSize { width: 640, height: 480 };
    let p = DVec3::new(0.3, -1.7, 2.9);
    for decade in [10, 18, 25, 60, 150] {
        let near = Camera::new(&far_away(0, Projection::Parallel)).unwrap();
        let far = Camera::new(&far_away(decade, Projection::Parallel)).unwrap();
        let turned = |camera: &Camera| {
            let turn = Operation::Azimuth(Angle::from_degrees(33.0));
            turn.apply(camera, Convention::default()).unwrap()
        };
        let view = |camera: &Camera| camera.stations(p, image, &Viewport::whole(image)).view;
        let (before, after) = (view(&far), view(&turned(&far)));
        // About v: y_c stays, and x_c stays a matter of p − PF.
        assert!(
            (after.y - before.y).abs() <= 4.0 * f64::EPSILON * before.y.abs(),
            "1e{decade}: {after} after {before}"
        );
        let offset = (p - near.focal_point()).length();
        assert!(after.x.abs() <= offset && after.x != 0.0, "1e{decade}: {after}");
    }
}
