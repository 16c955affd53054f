//! Studies of rounding and cost, the diagnosis of cameras and answers, exercises and lessons.
//!
//! [`numerics`] measures the cost of accuracy and diagnoses cameras. [`exercises`] states the exercises of the notes,
//! judges answers and finds the step that went wrong. [`lessons`] reads lessons and checks their tasks.

use camera_lab_engine::{
    appearance, camera, drawing, expression, geometry, limits, listed, numbers, pipeline, progress, raster, scene,
    worded,
};
use camera_lab_figures::{chart, explain, figure, formula, inspect, picture, views};

pub mod clock;
pub mod exercises;
pub mod lessons;
pub mod numerics;
