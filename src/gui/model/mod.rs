//! What the window edits, without a widget: the document and its history, the scene, what the pictures show.

pub(super) mod asked_layout;
pub mod document;
pub(super) mod history;
pub(super) mod layout;
pub(super) mod message;
pub mod scene_cache;
pub(super) mod shown;
