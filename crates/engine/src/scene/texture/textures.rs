//! The pictures of a scene, each read once, within a budget.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::appearance::Texture;
use crate::limits::{MAX_TEXELS, MAX_TEXTURE_SIDE};
use crate::sanitize;
use crate::scene::ReadError;
use crate::scene::read_error::Beside;

#[cfg(feature = "import")]
use super::decode::decode;

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
    #[error("has {width} × {height} pixels; allowed: at most {MAX_TEXTURE_SIDE} a side and {MAX_TEXELS} in all")]
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

/// Pictures that have been read, each once, and the texels that they may still have together.
#[derive(Clone, Debug, Default)]
pub(in crate::scene) struct Textures {
    known: BTreeMap<String, Result<Arc<Texture>, TextureError>>,
}

impl Textures {
    /// The picture in a file.
    ///
    /// # Errors
    /// [`TextureError`]. A file that couldn't be read is tried again the next time.
    pub(in crate::scene) fn get(
        &mut self,
        file: &str,
        alpha: Alpha,
        read_file: &mut Beside<'_>,
    ) -> Result<Arc<Texture>, TextureError> {
        if let Some(known) = self.known.get(&key(file, alpha)) {
            return known.clone();
        }
        match read_file(file) {
            Ok(bytes) => self.of_bytes(file, alpha, &bytes),
            Err(error) => {
                let fault = TextureFault::Unreadable(Box::new(error));
                Err(TextureError { file: sanitize::path_text(file), fault })
            }
        }
    }

    /// The picture in the bytes of a file with this name, or of a part of one.
    ///
    /// # Errors
    /// [`TextureError`].
    pub(in crate::scene) fn of_bytes(
        &mut self,
        name: &str,
        alpha: Alpha,
        bytes: &[u8],
    ) -> Result<Arc<Texture>, TextureError> {
        let key = key(name, alpha);
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let decoded = decode(bytes, alpha).and_then(|texture| self.within_budget(Arc::new(texture)));
        let decoded = decoded.map_err(|fault| TextureError { file: sanitize::path_text(name), fault });
        self.known.insert(key, decoded.clone());
        decoded
    }

    /// The picture, if all together have no more texels than allowed.
    fn within_budget(&self, texture: Arc<Texture>) -> Result<Arc<Texture>, TextureFault> {
        let texels = |texture: &Texture| u64::from(texture.width()) * u64::from(texture.height());
        let held: u64 = self.known.values().flatten().map(|texture| texels(texture)).sum();
        if held + texels(&texture) > MAX_TEXELS { Err(TextureFault::Budget) } else { Ok(texture) }
    }

    /// True for a file that has been read as a texture of a figure, with or without success.
    pub(in crate::scene) fn knows(&self, file: &str) -> bool {
        self.known.contains_key(&key(file, Alpha::Kept))
    }

    /// Takes over a texture of a figure that was read elsewhere.
    pub(in crate::scene) fn insert(&mut self, file: &str, read: Result<Arc<Texture>, TextureError>) {
        let refused = |fault| TextureError { file: sanitize::path_text(file), fault };
        let read = read.and_then(|texture| self.within_budget(texture).map_err(refused));
        self.known.insert(key(file, Alpha::Kept), read);
    }

    /// Forgets the files that `is_used` denies.
    pub(in crate::scene) fn retain(&mut self, is_used: impl Fn(&str) -> bool) {
        self.known.retain(|key, _| key.split_once('\n').is_some_and(|(_, file)| is_used(file)));
    }
}

/// A file is another picture if its alpha means something else.
fn key(file: &str, alpha: Alpha) -> String {
    format!("{alpha:?}\n{file}")
}

/// Stands in for the decoder.
#[cfg(not(feature = "import"))]
fn decode(_: &[u8], _: Alpha) -> Result<Texture, TextureFault> {
    Err(TextureFault::Format)
}
