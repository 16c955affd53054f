//! Pictures as files, in the requested format.

use super::{Composite, NoComposite, Pixels, Renderer};
use crate::camera::Ndc;
use crate::export::animation::AnimationFormat;
use crate::export::format::PictureFormat;
use crate::export::png::PngError;
use crate::export::web;
use crate::pipeline::OverBudget;
use crate::progress::Progress;
use crate::views::View;

/// Why there is no picture file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// A side is 0, or there is not enough memory.
    #[error("there is not enough memory for a picture of this size")]
    TooLarge,
    /// There is no sheet.
    #[error(transparent)]
    Composite(#[from] NoComposite),
    /// Cancelled.
    #[error("cancelled")]
    Cancelled,
    /// An error of WebP or JPEG.
    #[error("the picture cannot be written as {} ({why})", .format.name())]
    Encode {
        /// The format.
        format: PictureFormat,
        /// The message of the encoder: its own error belongs to another crate, and can be neither cloned nor compared.
        why: String,
    },
    /// An error of an animation.
    #[error("the picture cannot be written as {} ({why})", .format.name())]
    Animate {
        /// The format.
        format: AnimationFormat,
        /// The message of the encoder, as for [`Encode`](Self::Encode).
        why: String,
    },
    /// An error of PNG.
    #[error(transparent)]
    Png(#[from] PngError),
}

/// A picture as a file.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureFile {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// A shortfall of the picture.
    pub too_much: Option<OverBudget>,
}

/// Options of a picture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileOptions {
    /// The format.
    pub format: PictureFormat,
    /// Crop the empty background around each picture.
    pub crop: bool,
    /// Pixels per inch on paper, which PNG and JPEG can tell to who prints them; `None`: not for paper.
    pub dpi: Option<f64>,
}

/// The content of such a file: the pictures of `sheet`, and their shortfall; `crop`: each without the empty background
/// around it. Pauses after each band of a picture.
///
/// # Errors
/// [`PictureError::TooLarge`] and [`PictureError::Cancelled`].
pub async fn assembled(
    sheet: &Composite,
    crop: bool,
    progress: &Progress,
) -> Result<(Pixels, Option<OverBudget>), PictureError> {
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let mut renderer = Renderer::default();
    renderer.watch(progress);
    renderer.sheet(sheet, crop).await.ok_or(PictureError::TooLarge).map_err(or_cancelled)
}

/// The file that shows the pictures of `sheet`, with a figure file in it where the format can carry one. It pauses
/// after each band of a picture and each row of a PNG; WebP and JPEG are encoded without a pause.
///
/// Where a PNG shows the canonical volume in another convention than the notes', it says which, also where the picture
/// is too small to.
///
/// *Guarantees*: the same sheet, form and text give the same bytes.
///
/// # Errors
/// [`PictureError`].
pub async fn file(
    sheet: &Composite,
    form: FileOptions,
    figure: &str,
    progress: &Progress,
) -> Result<PictureFile, PictureError> {
    let FileOptions { format, crop, dpi } = form;
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let (mut picture, too_much) = assembled(sheet, crop, progress).await?;
    let encode = |bytes: Result<Vec<u8>, String>| bytes.map_err(|why| PictureError::Encode { format, why });
    let bytes = match format {
        PictureFormat::Png => picture
            .into_png(figure, convention(sheet).as_deref(), dpi, progress)
            .await
            .map_err(|error| or_cancelled(error.into()))?,
        PictureFormat::WebP => encode(web::webp(picture.take_pixmap().ok_or(PictureError::TooLarge)?))?,
        PictureFormat::Jpeg => encode(web::jpeg(&picture.take_pixmap().ok_or(PictureError::TooLarge)?, dpi))?,
    };
    Ok(PictureFile { bytes, too_much })
}

/// The convention of NDC of the canonical volume, where it is not that of the notes.
fn convention(sheet: &Composite) -> Option<String> {
    let request = sheet.requests.iter().find(|request| request.view == View::Canonical)?;
    let ndc = request.camera.possible_clip_space(request.shot.ndc).ndc();
    (ndc != Ndc::default()).then(|| format!("NDC: {}", request.labels.ndc_title(ndc)))
}
