//! The pointer and the keys in the pictures: probes, picking, drags.

pub(super) mod camera_drag;
pub(super) mod followed;
pub(in crate::gui) mod handle_drag;
pub(super) mod held;
pub(super) mod interaction;
pub(super) mod keyboard_probe;
pub(super) mod other_camera;
pub(super) mod picking;
pub(super) mod pixel;
pub(super) mod placing;
pub(super) mod probe_steps;
pub(in crate::gui) mod selection_gizmo;
pub(super) mod touch;
pub(super) mod vertex_name;
pub(super) mod wiper;
