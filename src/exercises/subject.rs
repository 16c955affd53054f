//! The subject of an exercise, and its numbers from `inspect`.

use glam::DVec3;
use serde_json::Value;

use super::value::Table;
use crate::camera::{Camera, Convention, Operation};
use crate::figure::Figure;
use crate::inspect::{InspectError, Report, camera_after};

/// A figure with operations on its camera, and the points and pixels of interest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Subject {
    /// The figure before the operations.
    pub figure: Figure,
    /// Operations on the camera, in this order.
    pub operations: Vec<Operation>,
    /// Points of the world.
    pub points: Vec<DVec3>,
    /// Pixels, (i, j).
    pub pixels: Vec<[i64; 2]>,
}

impl Subject {
    /// The camera after the operations.
    ///
    /// # Errors
    /// [`InspectError`] names the impossible quantity.
    pub fn camera(&self) -> Result<Camera, InspectError> {
        camera_after(&self.figure.camera, &self.operations, Convention::RightHand)
    }

    /// Every number of it, as `camera-lab inspect` prints them.
    ///
    /// # Errors
    /// [`InspectError`] names the impossible quantity.
    pub fn report(&self) -> Result<Report, InspectError> {
        Report::new(&self.figure, &self.operations, Convention::RightHand, &self.points, &self.pixels)
    }

    /// The numbers at a path in that report, such as `basis.u` or `points.0.ndc`; a boolean is 1 or 0. `None`: there is
    /// nothing there, or no numbers.
    #[must_use]
    pub fn value(&self, path: &str) -> Option<Table> {
        let report = serde_json::to_value(self.report().ok()?).ok()?;
        let mut place = &report;
        for part in path.split('.') {
            place = match place {
                Value::Array(items) => items.get(part.parse::<usize>().ok()?)?,
                Value::Object(entries) => entries.get(part)?,
                _ => return None,
            };
        }
        table(place)
    }
}

fn table(value: &Value) -> Option<Table> {
    let numbers = |items: &[Value]| items.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>();
    match value {
        Value::Bool(is) => Some(Table::number(f64::from(u8::from(*is)))),
        Value::Array(items) if items.first().is_some_and(Value::is_array) => {
            let rows: Vec<Vec<f64>> = items.iter().map(|row| numbers(row.as_array()?)).collect::<Option<_>>()?;
            let columns = rows.first()?.len();
            Some(Table { rows: rows.len(), columns, entries: rows.concat() })
        }
        Value::Array(items) => Some(Table::column(&numbers(items)?)),
        other => other.as_f64().map(Table::number),
    }
}
