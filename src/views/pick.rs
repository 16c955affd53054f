//! From a point of a picture to what is there.

use glam::{DVec2, DVec3};

use crate::figure::Observer;
use crate::geometry::Ray;

use super::Setup;

/// The ray in the world through a point (pixels) of the world picture.
#[must_use]
pub fn ray_in_world(_setup: &Setup, _observer: &Observer, _pointer: DVec2) -> Option<Ray> {
    None
}

/// The vertex of the scene (world) nearest to a point (pixels) of the world picture, within `reach` pixels; hidden ones lose.
#[must_use]
pub fn vertex_in_world(_setup: &Setup, _observer: &Observer, _pointer: DVec2, _reach: f64) -> Option<DVec3> {
    None
}

/// As [`vertex_in_world`], for the picture of the canonical volume. The result is in world space.
#[must_use]
pub fn vertex_in_canonical(_setup: &Setup, _observer: &Observer, _pointer: DVec2, _reach: f64) -> Option<DVec3> {
    None
}

/// As [`vertex_in_world`], for the image.
#[must_use]
pub fn vertex_in_image(_setup: &Setup, _pointer: DVec2, _reach: f64) -> Option<DVec3> {
    None
}

/// The point `(x_p, y_p)` of the view window at a point (pixels) of the image picture; `None` outside the frame.
#[must_use]
pub fn window_point_in_image(_setup: &Setup, _pointer: DVec2) -> Option<DVec2> {
    None
}
