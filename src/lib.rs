//! Camera Lab: an interactive laboratory for the virtual camera of computer graphics.
//!
//! Data goes one way: **figure → camera → shot → request → drawing → image**. The window ([`gui`]) and the command line
//! ([`cli`]) are two thin shells over six libraries. This crate re-exports the modules of the first three. Whatever one
//! can show, the other can print.
//!
//! - `camera-lab-engine`: the camera of the notes, scenes, the pipeline, the rasterizer.
//! - `camera-lab-figures`: figure files, all their numbers, the three views, pictures as pixels and vectors.
//! - `camera-lab-teaching`: studies, diagnosis, exercises, lessons.
//! - `camera-lab-files`: the file system, figures and lessons in links.
//! - `camera-lab-words`: texts in every language.
//! - `camera-lab-desk`: what the window knows, without a window.
//!
//! Start reading at [`camera`] for the model of the notes, and at [`pipeline`] for the way from a scene to a picture.

pub use camera_lab_engine::{
    appearance, camera, chain, drawing, expression, geometry, lighting, limits, numbers, pipeline, progress, raster,
    sanitize, scene, stage, text,
};
pub use camera_lab_figures::{chart, explain, export, figure, formula, inspect, picture, views};
pub use camera_lab_teaching::{clock, exercises, lessons, numerics};

pub mod cli;
#[cfg(feature = "gui")]
pub mod gui;
#[cfg(all(test, feature = "gui"))]
#[path = "../crates/files/src/testing.rs"]
mod testing;
