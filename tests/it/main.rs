//! The contract, the pictures and the layers, in one binary.

#[path = "../common/mod.rs"]
mod common;

mod pipeline;
mod pipeline_project;
mod raster_pictures;
mod scene;
