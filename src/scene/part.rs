//! What a mesh file gives.

use std::sync::Arc;

use glam::DMat4;

use super::Mesh;
use crate::appearance::Rgba;

/// One object of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name in the file; may be empty, need not be unique.
    pub name: String,
    /// Its surface.
    pub mesh: Arc<Mesh>,
    /// Where the file puts it.
    pub file_from_part: DMat4,
    /// The base colour of its material.
    pub color: Option<Rgba>,
    /// The file wants both sides to be seen.
    pub two_sided: bool,
}
