//! Asks for files and hands them out: opening and saving, sequences, links.

pub mod changed_file;
pub mod comparison;
pub mod file_flow;
pub(super) mod file_kind;
pub(super) mod link_dialog;
pub(super) mod opening;
pub(super) mod qr;
pub mod questions;
pub(super) mod sequence;
pub mod title_dialog;
pub(super) mod watch;
