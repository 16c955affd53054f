//! Picking, hovering and dragging in the pictures.

pub(super) mod cameras;
pub mod handles;
pub(super) mod hits;
pub(super) mod hover;
pub mod named_points;
pub mod pick;
pub mod transform_gizmo;
