//! Errors and warnings, in both languages, for both shells.

pub use super::cameras::{camera, inspect, no_way_back, operation, warning};
pub use super::expressions::{at_most_characters, expression, not_whole, outside};
pub use super::figure_files::{figure, without_line};
pub use super::files::{encoder, file, link, opened, png};
pub use super::meshes::notice as mesh_notice;
pub use super::progress::too_much;
pub use super::scene_errors::scene;
pub use super::unreadable::without_colors;
