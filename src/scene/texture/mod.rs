//! Textures of objects: where they come from, and how they lie on the surfaces.
//!
//! | file | purpose |
//! | --- | --- |
//! | `builtin` | the textures that are part of the program |
//! | `decode` | PNG, JPEG and WebP → texels, within limits |
//! | `unwrap` | texture coordinates of the primitives, and vertices that are there once for each of theirs |

mod builtin;
mod decode;
mod unwrap;

use std::fmt;
use std::sync::Arc;

use super::Mesh;
pub(super) use decode::{Alpha, Textures};
pub use decode::{TextureError, TextureFault};
pub(super) use unwrap::{mapped, split};

/// The source of the texture of an object, `texture` in a figure file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum TextureSource {
    /// None, also where the mesh file has one.
    None,
    /// Black and white squares, eight by eight.
    Chequer,
    /// A grid with a letter in each of its sixteen cells.
    Letters,
    /// u in red, v in green.
    Uv,
    /// A picture, relative to the figure file.
    File(String),
}

impl TextureSource {
    /// Those of the program, with their names in a figure file.
    pub const NAMED: [(&'static str, Self); 4] =
        [("none", Self::None), ("chequer", Self::Chequer), ("letters", Self::Letters), ("uv", Self::Uv)];

    /// The source with this name, or the file.
    #[must_use]
    pub fn of(text: &str) -> Self {
        let named = Self::NAMED.into_iter().find(|(name, _)| *name == text);
        named.map_or_else(|| Self::File(text.to_owned()), |(_, source)| source)
    }

    /// The file that it comes from, relative to the figure file.
    #[must_use]
    pub fn file(&self) -> Option<&str> {
        match self {
            Self::File(path) => Some(path),
            Self::None | Self::Chequer | Self::Letters | Self::Uv => None,
        }
    }
}

impl fmt::Display for TextureSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "none",
            Self::Chequer => "chequer",
            Self::Letters => "letters",
            Self::Uv => "uv",
            Self::File(path) => path,
        })
    }
}

/// Texture coordinates of the corners of each triangle: (0, 0) at the top left of the picture.
pub type CornerUv = [[f32; 2]; 3];

/// A mesh whose vertices have texture coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct UvMesh {
    /// The mesh; a vertex is there once for each of its coordinates.
    pub mesh: Arc<Mesh>,
    /// One for each vertex.
    pub uv: Arc<Vec<[f32; 2]>>,
}

/// The built-in texture of a source; `None` for files, and where there is to be none.
pub(super) fn builtin(source: &TextureSource) -> Option<Arc<crate::appearance::Texture>> {
    match source {
        TextureSource::Chequer => Some(Arc::clone(&builtin::CHEQUER)),
        TextureSource::Letters => Some(Arc::clone(&builtin::LETTERS)),
        TextureSource::Uv => Some(Arc::clone(&builtin::UV)),
        TextureSource::None | TextureSource::File(_) => None,
    }
}
