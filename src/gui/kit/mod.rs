//! Widgets without state of the application: fields, formulas, text, tooltips, plots, the theme.

pub mod command;
pub(super) mod context_help;
pub(super) mod dialog_buttons;
pub(super) mod elide;
pub(super) mod focus;
pub(super) mod form;
pub mod frames;
pub(super) mod keys;
pub(super) mod mathematics;
pub mod number_field;
pub(super) mod plotting;
pub(super) mod prose;
pub(super) mod text_field;
pub mod theme;
pub(super) mod tooltip;
