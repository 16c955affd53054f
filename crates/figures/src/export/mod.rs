//! Drawing or report → file formats.

pub mod animation;
pub mod crop;
pub mod format;
pub mod paper;
pub mod plot;
pub mod png;
pub mod sheet;
pub mod vector;
pub mod web;
