//! The subject of an exercise, and its numbers from `inspect`.

use glam::DVec3;

use super::value::Table;
use crate::camera::{Camera, Convention, Operation};
use crate::figure::Figure;
use crate::inspect::quantity::{Numbers, QuantityPath};
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

    /// A quantity of that report; a boolean is 1 or 0. `None`: the report does not have it.
    #[must_use]
    pub fn value(&self, path: impl Into<QuantityPath>) -> Option<Table> {
        let Numbers { columns, entries } = path.into().numbers(&self.report().ok()?)?;
        Some(Table { rows: entries.len() / columns.max(1), columns, entries })
    }
}
