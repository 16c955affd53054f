//! The result of importing a mesh file.

use std::sync::Arc;

use glam::DMat4;

use crate::appearance::{Rgba, Sampler, Texture};
use crate::scene::texture::CornerUv;
use crate::scene::{Mesh, MeshNotice, TextureError};

/// A mesh file that has been read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// One for each name and material.
    pub parts: Vec<Part>,
    /// Parts that were left out, or read otherwise than written.
    pub notices: Vec<MeshNotice>,
}

/// Adds a notice once.
pub(super) fn note(notices: &mut Vec<MeshNotice>, notice: MeshNotice) {
    if !notices.contains(&notice) {
        notices.push(notice);
    }
}

/// The texture of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct PartTexture {
    /// Its texels, shared by all parts that use it.
    pub image: Arc<Texture>,
    /// How it's sampled.
    pub sampler: Sampler,
}

impl PartTexture {
    /// A picture that was read. If it can't be used, a notice says so, unless the reader of the
    /// files lists those that are missing.
    pub(super) fn new(
        image: Result<Arc<Texture>, TextureError>,
        sampler: Sampler,
        notices: &mut Vec<MeshNotice>,
    ) -> Option<Self> {
        match image {
            Ok(image) => return Some(Self { image, sampler }),
            Err(error) if error.is_unread() => {}
            Err(error) => note(notices, MeshNotice::Texture(error)),
        }
        None
    }
}

/// One object of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name in the file. May be empty, need not be unique.
    pub name: String,
    /// Triangles in the space of the file.
    pub mesh: Arc<Mesh>,
    /// The placement of the part in the file.
    pub file_from_part: DMat4,
    /// The base colour of its material.
    pub color: Option<Rgba>,
    /// Texture coordinates of the corners of each triangle. Empty means it has none.
    pub uv: Arc<Vec<CornerUv>>,
    /// The texture of its material.
    pub texture: Option<PartTexture>,
    /// The file wants both sides to be seen.
    pub two_sided: bool,
}
