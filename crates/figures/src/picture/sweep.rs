//! Pictures one after the other, for a family or the way from one camera to another, as an animation or as a strip of
//! stills.

use super::animation::{filmed, row};
use super::{Composite, FileOptions, FilmFormat, Metadata, PictureError, PictureFile, file};
use crate::export::animation::AnimationFormat;
use crate::progress::Progress;
use crate::views::Request;

/// Pictures of one size, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The pictures, at least one. The views of one frame follow each other.
    pub requests: Vec<Request>,
    /// The number of views in a frame, side by side; at least 1.
    pub views: usize,
    /// The duration of all of them, in seconds.
    pub seconds: f64,
}

impl Sweep {
    /// All pictures side by side.
    ///
    /// # Errors
    /// [`PictureError::TooLarge`] if there are none.
    pub fn stills(&self) -> Result<Composite, PictureError> {
        let first = self.requests.first().ok_or(PictureError::TooLarge)?;
        Ok(row(self.requests.clone(), first))
    }

    /// The file: an animation, or a strip with a figure file in it if the format can carry one. It pauses after each
    /// picture, and within one.
    ///
    /// # Errors
    /// [`PictureError`].
    pub async fn file(
        &self,
        format: FilmFormat,
        told: &Metadata,
        progress: &Progress,
    ) -> Result<PictureFile, PictureError> {
        match format {
            FilmFormat::Animation(format) => {
                Ok(PictureFile { bytes: self.animation(format, progress).await?, ..PictureFile::default() })
            }
            FilmFormat::Strip(format) => file(&self.stills()?, FileOptions::of(format), told, progress).await,
        }
    }

    /// The animation.
    async fn animation(&self, format: AnimationFormat, progress: &Progress) -> Result<Vec<u8>, PictureError> {
        let first = self.requests.first().ok_or(PictureError::TooLarge)?;
        let frames: Vec<Composite> =
            self.requests.chunks(self.views.max(1)).map(|views| row(views.to_vec(), first)).collect();
        let size = frames.first().and_then(Composite::size).ok_or(PictureError::TooLarge)?;
        let count = u32::try_from(frames.len()).map_err(|_| PictureError::TooLarge)?;
        let each = self.seconds / f64::from(count);
        let at = |picture: u32| frames.get(picture as usize).map(|frame| (frame.clone(), each));
        filmed(format, size, count, at, progress).await
    }
}
