//! Errors and warnings of the model beside the window's fields, in the symbols that these have.

use super::Lang;
use super::cameras::{camera_wording, warning_wording};
use super::scene_errors::scene_wording;
pub use super::scene_errors::segments_allowed;
use crate::camera::{CameraError, Warning};
use crate::scene::SceneError;

/// Why camera parameters are not a camera.
#[must_use]
pub fn camera_error(lang: Lang, error: &CameraError) -> String {
    camera_wording(lang, error).in_symbols
}

/// What is possible, but probably not what was meant.
#[must_use]
pub fn warning(lang: Lang, warning: &Warning) -> String {
    warning_wording(lang, warning).in_symbols
}

/// Why an object or a light cannot be so.
#[must_use]
pub fn scene_error(lang: Lang, error: &SceneError) -> String {
    scene_wording(lang, error).in_symbols
}
