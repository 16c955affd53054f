//! The contract, the pictures and the layers, in one binary.

#[path = "../common/mod.rs"]
mod common;

mod raster_pictures;
