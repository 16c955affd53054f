//! Promises about any bytes: each module has one, and `run` tries it on one input.
//!
//! The targets of libFuzzer call these functions with inputs that find new paths through the program. The program's own
//! tests call them with a few hundred inputs that are the same every time.

pub mod answer;
pub mod clip;
pub mod draw;
pub mod exercise;
pub mod expression;
pub mod figure;
pub mod lesson;
pub mod link;
mod mesh;
mod notation;
pub mod paper;
pub mod png;
pub mod raster;
pub mod texture;

pub use mesh::{gltf, obj, ply, stl};
