//! Helpers that the tests of the engine share with those above it.

pub(crate) mod any_camera;
pub(crate) mod any_scene;
pub(crate) mod camera;
pub(crate) mod picture;
pub(crate) mod scenes;
pub(crate) mod triangles;
