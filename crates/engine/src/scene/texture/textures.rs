//! The pictures of a scene, each read once, within a budget.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::appearance::Texture;
use crate::limits::MAX_TEXELS;
use crate::sanitize;
use crate::scene::read_error::Beside;

#[cfg(feature = "import")]
use super::decode::decode;
use super::fault::{Alpha, TextureError, TextureFault};

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
