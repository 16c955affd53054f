//! The model of the window, without a widget: the document and its history, the scene, the shot of the pictures.

pub(super) mod asked_layout;
pub mod document;
pub(super) mod history;
pub(super) mod layout;
pub(super) mod message;
pub mod scene_cache;
pub(super) mod shown;
