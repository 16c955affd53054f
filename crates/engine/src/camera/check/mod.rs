//! Cameras that aren't what their author meant: repairs of impossible ones, warnings about possible ones.

mod repair;
mod warnings;

pub use repair::{CameraRepair, camera_repairs};
pub use warnings::{Warning, thresholds};
