//! The spaces that a point goes through, and the camera between them.

pub mod depths;
pub(crate) mod planes;
pub(crate) mod point;
pub(crate) mod projector;
pub(crate) mod screen;
