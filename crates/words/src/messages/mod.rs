//! Errors and warnings, in both languages, for both shells.

pub(super) mod cameras;
pub(super) mod expressions;
pub mod faults;
pub(super) mod figure_files;
pub(super) mod files;
pub(super) mod meshes;
pub(super) mod scene_errors;
pub mod toml_complaints;
pub(super) mod unreadable;
pub(super) mod wording;

pub use crate::messages::cameras::{camera, inspect, no_way_back, operation, warning};
pub use crate::messages::expressions::{at_most_characters, expression, not_whole, outside};
pub use crate::messages::figure_files::{figure, without_line};
pub use crate::messages::files::{encoder, file, left_out, link, not_printed, opened, out_of_reach, png};
pub use crate::messages::meshes::notice as mesh_notice;
pub use crate::messages::scene_errors::scene;
pub use crate::messages::unreadable::without_file;
pub use crate::window::progress::over_budget;
