//! The panels at the sides.

pub(super) mod coach;
pub mod compare_dialog;
pub(super) mod number_tables;
pub mod numerics;
pub mod operations;
pub mod parameters;
mod predict;
pub mod scene;
pub(super) mod state;
pub mod values;

use crate::gui::kit::{
    TEXT_LINE, VectorField, choice_row, complain, complaint, erratum, kept_section, more, row, section, toggle,
};
