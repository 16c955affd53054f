//! A matrix → its camera: (5.7) and (5.13) to (5.16) read backwards, in any convention of NDC.
//!
//! Quantities that a matrix doesn't hold are taken from the present camera, and reported ([`Unknown`]): D (a direction
//! has no length), VUP (only **v** is known), and in parallel projection C along **n** (moving the eye along its line
//! of sight changes nothing).

mod error;
mod evidence;
mod reading;
mod recognition;
mod solve;
mod text;

pub use error::{Lines, MatrixTextError, RecoveryError};
pub use evidence::Reason;
pub use reading::{MatrixEntries, MatrixKind, Reading, Stated, Unknown};
pub use recognition::{Assumed, Candidate, Certainty, Evidence, Recognised, recognise};
pub use text::{LeftOut, Pasted, Used, Why, camera_names, read_cameras};

use glam::DMat4;

use crate::camera::{Axes, Camera, Order, Parameters, Toward, WorldUp};
use solve::Recovery;

/// A camera's parameters from a matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovered {
    /// The parameters of the camera.
    pub parameters: Parameters,
    /// Quantities that the matrix left open, and other notices.
    pub unknown: Vec<Unknown>,
}

/// The tolerance beside 1, which a matrix copied with three digits still passes.
pub(crate) const SLACK: f64 = 2e-3;
/// Errors below this aren't reported. All digits of an `f64` are there.
pub(crate) const EXACT: f64 = 1e-9;

/// The camera of a matrix that acts on column vectors, as read by a reading. Quantities that the matrix doesn't hold
/// come from `current`.
///
/// ```
/// use camera_lab_engine::camera::{MatrixKind, Parameters, Projection, Reading, recover};
/// use glam::DMat4;
///
/// // [0] Exercise 5.3: the camera whose view volume is the cube of NDC. The identity keeps z, which a camera
/// // turns around.
/// let found = recover(&Reading::of(MatrixKind::ViewProjection), DMat4::IDENTITY, &Parameters::default())?;
/// let p = found.parameters;
/// assert_eq!((p.projection, p.height, p.aspect), (Projection::Parallel, 2.0, 1.0));
/// assert_eq!(p.far - p.near, 2.0);
/// assert_eq!(p.position.z, 1.0 + p.near);
/// # Ok::<(), camera_lab_engine::camera::RecoveryError>(())
/// ```
///
/// # Errors
/// [`RecoveryError`] names the entry or row that no camera has.
pub fn recover(reading: &Reading, matrix: DMat4, current: &Parameters) -> Result<Recovered, RecoveryError> {
    for row in 0..4 {
        for column in 0..4 {
            if !matrix.row(row)[column].is_finite() {
                let value = matrix.row(row)[column];
                return Err(RecoveryError::NotFinite { value, row: row + 1, column: column + 1 });
            }
        }
    }
    let mut recovery = Recovery { current: *current, found: *current, reading: *reading, unknown: Vec::new() };
    match reading.kind {
        MatrixKind::View => recovery.view(matrix)?,
        MatrixKind::CameraToWorld => recovery.camera_to_world(matrix)?,
        MatrixKind::Projection => recovery.projection(matrix)?,
        MatrixKind::ViewProjection => recovery.both(matrix)?,
        MatrixKind::Pinhole => recovery.pinhole(matrix)?,
        MatrixKind::Intrinsics => recovery.intrinsics(matrix)?,
        MatrixKind::LookAt => recovery.look_at(matrix),
    }
    // Nobody writes −0.
    let Parameters { position, focal_point, view_up, .. } = &mut recovery.found;
    [position, focal_point, view_up].into_iter().for_each(|v| *v += 0.0);
    Camera::new(&recovery.found)?;
    recovery.unknown.sort();
    recovery.unknown.dedup();
    Ok(Recovered { parameters: recovery.found, unknown: recovery.unknown })
}
