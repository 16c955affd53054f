//! The desk of Camera Lab: what the window knows, without a window.
//!
//! - [`desk`] owns the [documents](document), shown and hidden, and undo.
//! - [`model`] has the scene, the layout, the selection and the explanations for every feature of the window.
//! - [`background`] does work beside the window's thread, and [`storage`] keeps sessions and the files that several
//!   windows write.
//!
//! Nothing here draws or asks. The window is a [`Wake`], which can be asked for another frame.

pub mod action;
pub mod background;
pub mod cameras;
pub mod coach;
pub mod comparison;
pub mod desk;
pub mod document;
pub mod exchange;
pub mod explained;
pub mod export_error;
pub mod follow;
pub mod handout_job;
pub mod history;
pub mod insert;
pub mod layout;
pub mod message;
pub mod model;
pub mod operations;
pub mod photograph;
pub mod scene_cache;
pub mod scene_tree;
pub mod selected_placement;
pub mod settings;
pub mod shown;
pub mod storage;
#[cfg(test)]
#[path = "../../files/src/testing.rs"]
mod testing;
pub mod unsaved_text;
mod wake;
pub mod watch;

use camera_lab_engine::{appearance, camera, geometry, limits, numbers, pipeline, progress, sanitize, scene, stage};
use camera_lab_figures::{chart, explain, export, figure, picture, views};
use camera_lab_teaching::{clock, exercises, lessons, numerics};

pub use model::Model;
pub use wake::Wake;
