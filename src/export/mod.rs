//! Drawing or report → file formats.

pub mod png;
pub mod sheet;
