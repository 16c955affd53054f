//! What both integration binaries share.

pub(crate) mod picture;
