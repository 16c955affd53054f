//! An expression has a finite value, or a fault whose place lies in the text.

use camera_lab::camera::Operation;
use camera_lab::expression::{Dimension, evaluate, marked, parts};

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for dimension in [Dimension::Number, Dimension::Angle] {
        match evaluate(text, dimension) {
            Ok(value) => assert!(value.is_finite()),
            Err(error) => {
                assert!(text.get(error.span.clone()).is_some());
                assert!(!marked(text, &error.span).contains('\n'));
            }
        }
    }
    assert!(parts(text).map(str::len).sum::<usize>() <= text.len());
    if let Ok(operation) = text.parse::<Operation>() {
        assert_eq!(operation.to_string().parse(), Ok(operation));
    }
}
