//! The tree of a figure's scene: presets, its edits, and its names and transforms resolved.

pub mod edit;
pub(crate) mod presets;
pub(crate) mod resolve;
pub mod transform;
