//! Textures of objects: where they come from, and how they lie on the surfaces.

mod builtin;
#[cfg(feature = "import")]
mod decode;
mod fault;
mod textures;
mod unwrap;

use std::sync::Arc;

use super::{Mesh, TextureSource};
use crate::appearance::Rgba;
pub(super) use fault::Alpha;
pub use fault::{TextureError, TextureFault};
pub(super) use textures::Textures;
pub(super) use unwrap::{mapped, split};

/// Texture coordinates of the corners of each triangle: (0, 0) at the top left of the picture.
pub type CornerUv = [[f32; 2]; 3];

/// A mesh whose vertices have texture coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct UvMesh {
    /// The mesh. A vertex is there once for each of its coordinates.
    pub mesh: Arc<Mesh>,
    /// One for each vertex.
    pub uv: Arc<Vec<[f32; 2]>>,
    /// The colour of each, if its mesh file gives them several.
    pub colors: Arc<Vec<Rgba>>,
}

/// The built-in texture of a source. `None` for files, and if there's to be none.
pub(super) fn builtin(source: &TextureSource) -> Option<Arc<crate::appearance::Texture>> {
    match source {
        TextureSource::Chequer => Some(Arc::clone(&builtin::CHEQUER)),
        TextureSource::Letters => Some(Arc::clone(&builtin::LETTERS)),
        TextureSource::Uv => Some(Arc::clone(&builtin::UV)),
        TextureSource::None | TextureSource::File(_) => None,
    }
}
