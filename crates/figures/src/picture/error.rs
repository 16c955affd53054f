//! The reasons why there's no picture file.

use super::NoComposite;
use crate::export::animation::AnimationFormat;
use crate::export::format::PictureFormat;
use crate::export::png::PngError;
use crate::pipeline::OverBudget;

/// The reason why there's no picture file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// A side is 0, or there isn't enough memory.
    #[error("there is not enough memory for an image of this size")]
    TooLarge,
    /// There's no sheet.
    #[error(transparent)]
    Composite(#[from] NoComposite),
    /// Cancelled.
    #[error("cancelled")]
    Cancelled,
    /// An error of WebP or JPEG.
    #[error("the image cannot be written as {} ({why})", .format.name())]
    Encode {
        /// The format that refuses the image.
        format: PictureFormat,
        /// The message of the encoder. Its own error belongs to another crate, and can't be cloned or compared.
        why: String,
    },
    /// An error of an animation.
    #[error("the image cannot be written as {} ({why})", .format.name())]
    Animate {
        /// The format that refuses the animation.
        format: AnimationFormat,
        /// The message of the encoder, as for [`Encode`](Self::Encode).
        why: String,
    },
    /// The visible parts of strokes were not found.
    #[error("{}", OverBudget::Strokes)]
    Strokes,
    /// The font of a PDF.
    #[error("the letters of the image cannot be written as PDF")]
    Font,
    /// An error of PNG.
    #[error(transparent)]
    Png(#[from] PngError),
}
