//! Drawing or report → file formats.
