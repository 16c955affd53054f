//! Pictures as files, in the format that is asked for.

use super::{Picture, Renderer, gap};
use crate::export::format::PictureFormat;
use crate::export::png::PngError;
use crate::export::web;
use crate::pipeline::TooMuch;
use crate::progress::Progress;
use crate::views::Request;

/// Why there is no picture file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// A side is 0, or there is no memory for so many pixels.
    #[error("there is no memory for a picture of this size")]
    TooLarge,
    /// It is not wanted any more.
    #[error("cancelled")]
    Cancelled,
    /// It cannot be written as WebP or JPEG.
    #[error("the picture cannot be written as {} ({why})", .format.name())]
    Encode {
        /// The format.
        format: PictureFormat,
        /// What the encoder says.
        why: String,
    },
    /// It cannot be written as PNG.
    #[error(transparent)]
    Png(#[from] PngError),
}

/// A picture as a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PictureFile {
    /// What is written.
    pub bytes: Vec<u8>,
    /// What could not be done as it was asked for.
    pub too_much: Option<TooMuch>,
}

/// What is in such a file: `requests` side by side, and what could not be done as it was asked for; `crop`: without the empty ground
/// around them.
///
/// # Errors
/// [`PictureError::TooLarge`] and [`PictureError::Cancelled`].
pub fn assembled(
    requests: &[Request],
    crop: bool,
    progress: &Progress,
) -> Result<(Picture, Option<TooMuch>), PictureError> {
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let mut renderer = Renderer::default();
    renderer.watch(progress);
    let (picture, too_much) = renderer.sheet(requests).ok_or(PictureError::TooLarge).map_err(or_cancelled)?;
    let scale = requests.first().map_or(1.0, |request| request.size.scale);
    Ok((if crop { picture.cropped(gap(scale)) } else { picture }, too_much))
}

/// The file that shows `requests` side by side, with a figure file in it where the format can carry one; `crop`: without the empty
/// ground around them.
///
/// *Guarantees*: the same requests and text give the same bytes.
///
/// # Errors
/// [`PictureError`].
pub fn file(
    format: PictureFormat,
    requests: &[Request],
    crop: bool,
    figure: &str,
    progress: &Progress,
) -> Result<PictureFile, PictureError> {
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let (mut picture, too_much) = assembled(requests, crop, progress)?;
    let encode = |bytes: Result<Vec<u8>, String>| bytes.map_err(|why| PictureError::Encode { format, why });
    let bytes = match format {
        PictureFormat::Png => picture.into_png(figure, progress).map_err(|error| or_cancelled(error.into()))?,
        PictureFormat::WebP => encode(web::webp(picture.take_pixmap().ok_or(PictureError::TooLarge)?))?,
        PictureFormat::Jpeg => encode(web::jpeg(&picture.take_pixmap().ok_or(PictureError::TooLarge)?))?,
    };
    Ok(PictureFile { bytes, too_much })
}
