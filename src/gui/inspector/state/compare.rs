//! The state of the dialog that compares the figure with itself in another way.

use crate::figure::Figure;

/// The values of the dialog that no figure has yet.
#[derive(Clone, Debug, PartialEq)]
pub struct CompareForm {
    /// θ of the other side, degrees.
    pub angle: f64,
    /// An operation as it is typed.
    pub operation: String,
    /// A key with its other value, as it is typed.
    pub key: String,
}

impl CompareForm {
    /// The values of the figure's comparison, else those that are offered.
    pub(in crate::gui) fn of(figure: &Figure) -> Self {
        let operation = figure.compare.as_ref().and_then(|comparison| comparison.ops.first());
        let with = figure.compare.as_ref().and_then(|comparison| comparison.with.first());
        Self {
            angle: if figure.camera.view_angle < 45.0 { 60.0 } else { 30.0 },
            key: with.map_or_else(|| "camera.near = 0.5".to_owned(), |(key, value)| format!("{key} = {value}")),
            operation: operation.map_or_else(|| "azimuth=30".to_owned(), ToString::to_string),
        }
    }
}
