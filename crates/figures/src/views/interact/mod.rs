//! What the pointer does in the pictures: pick, hover and drag.

pub mod handles;
pub(super) mod hits;
pub(super) mod hover;
pub mod named_points;
pub mod pick;
pub mod transform_gizmo;
