//! The reasons why a picture can't be a texture, and the meaning of its alpha.

use crate::limits::{MAX_HALVED_TEXELS, MAX_TEXELS, MAX_TEXTURE_SIDE};
use crate::scene::ReadError;

/// The reason why a picture can't be used as a texture: the file, and the fault.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file} {fault}")]
pub struct TextureError {
    /// The file, as its figure or mesh names it.
    pub file: String,
    /// The reason why the file is refused.
    pub fault: TextureFault,
}

impl TextureError {
    /// True if the file lies outside the folder that the figure may read from. The user can allow it.
    pub const fn is_outside(&self) -> bool {
        matches!(&self.fault, TextureFault::Unreadable(error) if error.is_outside())
    }

    /// True if the file couldn't be read at all.
    pub(in crate::scene) const fn is_unread(&self) -> bool {
        matches!(self.fault, TextureFault::Unreadable(_))
    }
}

/// A fault of a picture. Displayed, it follows the name of the file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TextureFault {
    /// The file couldn't be read.
    #[error("{}", .0.problem)]
    Unreadable(Box<ReadError>),
    /// Another format.
    #[cfg_attr(feature = "import", error("is no known image; allowed: PNG, JPEG and WebP"))]
    #[cfg_attr(
        not(feature = "import"),
        error("is left out, since this program was built without the feature “import”")
    )]
    Format,
    /// The file is incomplete, or breaks the rules of its format.
    #[error("is damaged, or not whole")]
    Damaged,
    /// It's wider or higher than a texture may be.
    #[error(
        "has {width} × {height} pixels; allowed: at most {MAX_TEXTURE_SIDE} a side and {MAX_TEXELS} in all, or {MAX_HALVED_TEXELS} in a JPEG file that isn't progressive and in a PNG file with 8 bits and without transparency, which are halved"
    )]
    TooLarge {
        /// In pixels.
        width: u32,
        /// In pixels.
        height: u32,
    },
    /// The textures of the scene have too many texels together.
    #[error("was left out: with it the textures of this figure would have more than {MAX_TEXELS} pixels")]
    Budget,
}

/// The meaning of the alpha of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::scene) enum Alpha {
    /// Opacity.
    Kept,
    /// None. The picture is opaque.
    Ignored,
    /// Clear below this share, opaque from there on.
    #[cfg_attr(not(feature = "import"), expect(dead_code, reason = "only glTF has masks"))]
    Mask(f32),
}
