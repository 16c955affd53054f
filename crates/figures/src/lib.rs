//! Figures of virtual cameras: their files, all their numbers, the three views, and pictures as pixels and vectors.
//!
//! A [`figure::Figure`] is read from TOML. [`inspect`] and [`explain`] give its numbers, each with its equation in the
//! notes. [`views`] turns it into requests for the world, the canonical volume and the image, which [`picture`] renders
//! and [`export`] writes as PNG, SVG, PDF or TeX. Nothing here opens a file, because callers pass in texts and bytes,
//! and write the results.

use camera_lab_engine::{
    appearance, camera, chain, drawing, expression, geometry, limits, listed, numbers, pipeline, progress, raster,
    sanitize, scene, stage, text, worded,
};

pub mod chart;
pub mod explain;
pub mod figure;
pub mod formula;
pub mod inspect;
pub mod picture;
pub mod views;

/// Drawing or report → file formats.
pub mod export {
    pub mod animation;
    pub mod crop;
    pub mod format;
    pub mod paper;
    pub mod plot;
    pub mod png;
    pub mod sheet;
    pub mod vector;
    pub mod web;
}
