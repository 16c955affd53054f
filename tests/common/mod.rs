//! What both integration binaries share.

pub(crate) mod camera;
pub(crate) mod named_files;
pub(crate) mod picture;
pub(crate) mod program;
pub(crate) mod shot;
