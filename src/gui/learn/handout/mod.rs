//! Lessons and exercises as pages to print: the choices, the pages, and the dialog.

pub(in crate::gui) mod dialog;
pub mod form;
pub mod pages;
