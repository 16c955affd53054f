//! Pictures one after the other: a family, or the way from one camera to another, as an animation or as a strip of
//! stills.

use super::animation::filmed;
use super::{Composite, FileOptions, FilmFormat, PictureError, PictureFile, Told, file, gap};
use crate::export::animation::AnimationFormat;
use crate::progress::Progress;
use crate::views::{Arrangement, Palette, Request};

/// Pictures of one size, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The pictures; at least one.
    pub requests: Vec<Request>,
    /// The duration of all of them, in seconds.
    pub seconds: f64,
}

impl Sweep {
    /// The pictures side by side.
    ///
    /// # Errors
    /// [`PictureError::TooLarge`] where there are none.
    pub fn stills(&self) -> Result<Composite, PictureError> {
        let first = self.requests.first().ok_or(PictureError::TooLarge)?;
        let ground = Palette::of(first.shot.look.style.theme).surround;
        let gap = gap(first.size.scale);
        let requests = self.requests.clone();
        Ok(Composite { requests, arrangement: Arrangement::Row, gap, ground, crowded: None, grid: None, width: None })
    }

    /// The file: an animation, or a strip with a figure file in it where the format can carry one. It pauses after each
    /// picture, and within one.
    ///
    /// # Errors
    /// [`PictureError`].
    pub async fn file(
        &self,
        format: FilmFormat,
        told: &Told,
        progress: &Progress,
    ) -> Result<PictureFile, PictureError> {
        match format {
            FilmFormat::Animation(format) => {
                let bytes = self.animation(format, progress).await?;
                Ok(PictureFile { bytes, beside: None, too_much: None, no_areas: None })
            }
            FilmFormat::Strip(format) => file(&self.stills()?, FileOptions::of(format), told, progress).await,
        }
    }

    /// The animation.
    async fn animation(&self, format: AnimationFormat, progress: &Progress) -> Result<Vec<u8>, PictureError> {
        let first = self.requests.first().ok_or(PictureError::TooLarge)?;
        let size = [first.size.width, first.size.height];
        let count = u32::try_from(self.requests.len()).map_err(|_| PictureError::TooLarge)?;
        let each = self.seconds / f64::from(count);
        let at = |picture: u32| self.requests.get(picture as usize).map(|request| (request.clone(), each));
        filmed(format, size, count, at, progress).await
    }
}
