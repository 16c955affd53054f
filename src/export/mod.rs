//! Drawing or report → file formats.

pub mod format;
pub mod png;
pub mod sheet;
