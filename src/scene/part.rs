//! What a mesh file gives.

use std::sync::Arc;

use glam::DMat4;

use super::{Mesh, MeshNotice};
use crate::appearance::Rgba;

/// A mesh file that has been read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// Its objects.
    pub parts: Vec<Part>,
    /// What of it was left out, or taken otherwise than it stands.
    pub notices: Vec<MeshNotice>,
}

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
