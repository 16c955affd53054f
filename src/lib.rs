//! Camera Lab: an interactive laboratory for the virtual camera of computer graphics.
//!
//! Data goes one way: **figure → camera → pipeline → drawing → picture**. The window ([`gui`]) and the command line
//! ([`cli`]) are two thin shells over the same library: what one can show, the other can print.
//!
//! | space | unit | axes |
//! | --- | --- | --- |
//! | world | scene units | right-handed, y up |
//! | view (VRC) | scene units | right-handed, x right, y up, z towards the viewer |
//! | clip | homogeneous | x, y, z in \[−w, w\] inside the volume |
//! | ndc | 1 | left-handed, −1 … 1, z into the screen |
//! | window | scene units | on the plane z_c = −F, x right, y up |
//! | image | pixels | (0, 0) is the top-left corner, y down |
//!
//! Start reading at [`camera`] for the model of the notes, and at [`pipeline`] for the way from a scene to a picture.

pub use camera_lab_engine::{
    appearance, camera, drawing, expression, geometry, lighting, limits, numbers, pipeline, progress, raster, sanitize,
    scene, stage, text,
};

pub mod chart;
pub mod cli;
pub mod clock;
pub mod exercises;
pub mod explain;
pub mod export;
pub mod figure;
pub mod files;
pub mod formula;
#[cfg(feature = "gui")]
pub mod gui;
pub mod i18n;
pub mod inspect;
pub mod lessons;
pub mod numerics;
pub mod picture;
pub mod share;
pub mod views;
