//! The subject of an exercise, and its numbers from `inspect`.

use glam::DVec3;

use super::value::Table;
use crate::camera::{Camera, Convention, ImageSize, Operation, Viewport};
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

/// The place of a point of the world in the image, as in [`Subject::place`].
pub fn place_of(camera: &Camera, image: ImageSize, point: DVec3) -> Option<[f64; 2]> {
    let stations = camera.stations(point, image, &Viewport::whole(image));
    let projected = stations.projected.filter(|_| stations.view.z < 0.0)?;
    let place = image.image_from_window(&camera.window(), projected.window);
    place.is_finite().then(|| place.to_array())
}

impl Subject {
    /// The camera after the operations.
    ///
    /// # Errors
    /// [`InspectError`] names the impossible quantity.
    pub fn camera(&self) -> Result<Camera, InspectError> {
        camera_after(&self.figure.camera, &self.operations, Convention::RightHand)
    }

    /// Every number of the subject, as `camera-lab inspect` prints them.
    ///
    /// # Errors
    /// [`InspectError`] names the impossible quantity.
    pub fn report(&self) -> Result<Report, InspectError> {
        Report::new(&self.figure, &self.operations, Convention::RightHand, &self.points, &self.pixels)
    }

    /// The place of a point of the world in the image, in pixels from its left edge and from its upper one, (5.22)
    /// without the floor. `None` if the point has no image.
    pub fn place(&self, point: DVec3) -> Option<[f64; 2]> {
        place_of(&self.camera().ok()?, self.figure.image, point)
    }

    /// A quantity of that report. A boolean is 1 or 0. `None` means the report doesn't have it.
    pub fn value(&self, path: impl Into<QuantityPath>) -> Option<Table> {
        let Numbers { columns, entries } = path.into().numbers(&self.report().ok()?)?;
        Some(Table { rows: entries.len() / columns.max(1), columns, entries })
    }
}
