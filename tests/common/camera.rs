//! Cameras for tests, and numbers that should be equal but for rounding.

use camera_lab_engine::camera::{Camera, Convention, Operation, Parameters};
use glam::{DMat4, DVec3};

/// The default camera with some parameters changed.
#[track_caller]
pub(crate) fn camera(change: impl FnOnce(&mut Parameters)) -> Camera {
    let mut parameters = Parameters::default();
    change(&mut parameters);
    match Camera::new(&parameters) {
        Ok(camera) => camera,
        Err(error) => panic!("{error}: {parameters:?}"),
    }
}

/// The camera after operations, written as on the command line, with blanks between.
#[track_caller]
pub(crate) fn apply(camera: &Camera, operations: &str) -> Camera {
    operations.split_whitespace().fold(camera.clone(), |camera, text| {
        let operation: Operation = match text.parse() {
            Ok(operation) => operation,
            Err(error) => panic!("{error}"),
        };
        match operation.apply(&camera, Convention::RightHand) {
            Ok(camera) => camera,
            Err(error) => panic!("{text}: {error}"),
        }
    })
}

/// Four ε, of the number or of 1.
#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64) {
    let tolerance = 4.0 * f64::EPSILON * expected.abs().max(1.0);
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected}");
}

/// Four ε of the vector's length, or of 1.
#[track_caller]
pub(crate) fn assert_close3(found: DVec3, expected: DVec3) {
    let tolerance = 4.0 * f64::EPSILON * expected.length().max(1.0);
    assert!((found - expected).abs().max_element() <= tolerance, "{found} is not {expected}");
}

/// The rows of a matrix, as they are written in the notes, with −0 as 0.
pub(crate) fn rows(m: DMat4) -> [[f64; 4]; 4] {
    m.transpose().to_cols_array_2d().map(|row| row.map(|x| x + 0.0))
}
