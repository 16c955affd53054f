//! Pictures as files, in the format that is asked for.

use super::Renderer;
use crate::export::format::PictureFormat;
use crate::export::png::PngError;
use crate::views::Request;

/// Why there is no picture file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// A side is 0, or there is no memory for so many pixels.
    #[error("there is no memory for a picture of this size")]
    TooLarge,
    /// It cannot be written as PNG.
    #[error(transparent)]
    Png(#[from] PngError),
}

/// The bytes of the file that shows `requests` side by side, with a figure file in it.
///
/// *Guarantees*: the same requests and text give the same bytes.
///
/// # Errors
/// [`PictureError`].
pub fn file(format: PictureFormat, requests: &[Request], figure: &str) -> Result<Vec<u8>, PictureError> {
    match format {
        PictureFormat::Png => {
            let picture = Renderer::default().sheet(requests).ok_or(PictureError::TooLarge)?;
            Ok(picture.into_png(figure)?)
        }
    }
}
