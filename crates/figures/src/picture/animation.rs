//! The way from the world to the canonical volume, as a strip of stills, and as an animation.

use std::path::Path;

use super::{Composite, FileOptions, Metadata, PictureError, PictureFile, Renderer, file, gap};
use crate::camera::Decomposition;
use crate::export::animation::{AnimationError, AnimationFormat, TICK, animation};
use crate::export::format::PictureFormat;
use crate::figure::ShownStep;
use crate::progress::{Activity, Progress};
use crate::views::{Arrangement, Palette, Request};

/// A way, and its display.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// The canonical picture. Its size is that of each picture.
    pub request: Request,
    /// The source of the steps.
    pub decomposition: Decomposition,
}

/// The format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmFormat {
    /// Pictures one after the other.
    Animation(AnimationFormat),
    /// The whole steps side by side.
    Strip(PictureFormat),
}

impl FilmFormat {
    /// The format of a file's extension.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        AnimationFormat::of_ending(ending).map(Self::Animation).or_else(|| PictureFormat::of(path).map(Self::Strip))
    }
}

/// Pictures in a second of an animation.
const PER_SECOND: u32 = 20;
/// Duration of the rest after a whole step, in seconds.
const REST: f64 = 1.2;

impl Animation {
    /// Number of steps; 0 if the camera has no such steps.
    pub fn steps(&self) -> u32 {
        let factors = self.request.camera.decomposed(self.decomposition).unwrap_or_default();
        u32::try_from(factors.len()).unwrap_or(0)
    }

    /// The picture after a number of steps, the last of which may be incomplete.
    pub fn at(&self, time: f64) -> Request {
        let step = ShownStep { way: self.decomposition, at: Some(time) };
        self.request.clone().with_shot(|shot| shot.show.step = Some(step))
    }

    /// The world and the result of each step, side by side.
    pub fn stills(&self) -> Composite {
        row((0..=self.steps()).map(|step| self.at(f64::from(step))).collect(), &self.request)
    }

    /// The file: an animation with this many seconds for each step, or a strip, with a figure file in it if the format
    /// can carry one. It pauses after each picture, and within one.
    ///
    /// # Errors
    /// [`PictureError`].
    pub async fn file(
        &self,
        format: FilmFormat,
        seconds: f64,
        told: &Metadata,
        progress: &Progress,
    ) -> Result<PictureFile, PictureError> {
        match format {
            FilmFormat::Animation(format) => {
                Ok(PictureFile { bytes: self.animation(format, seconds, progress).await?, ..PictureFile::default() })
            }
            FilmFormat::Strip(format) => file(&self.stills(), FileOptions::of(format), told, progress).await,
        }
    }

    /// The animation, with this many seconds for each step. Each whole step stands still for a moment. It pauses after
    /// each picture, and within one.
    ///
    /// # Errors
    /// [`PictureError`].
    pub async fn animation(
        &self,
        format: AnimationFormat,
        seconds: f64,
        progress: &Progress,
    ) -> Result<Vec<u8>, PictureError> {
        #[expect(clippy::cast_possible_truncation, reason = "a few seconds")]
        let per_step = (seconds * f64::from(PER_SECOND)).round().clamp(1.0, 10_000.0) as u32;
        let pictures = self.steps() * per_step + 1;
        let size = [self.request.size.width, self.request.size.height];
        let at = |picture: u32| {
            let time = f64::from(picture / per_step) + eased(f64::from(picture % per_step) / f64::from(per_step));
            let still = picture.is_multiple_of(per_step);
            let frame = row(vec![self.at(time)], &self.request);
            Some((frame, if still { REST } else { 1.0 / f64::from(PER_SECOND) }))
        };
        filmed(format, size, pictures, at, progress).await
    }
}

/// Pictures side by side, with the gap and the background of `like`.
pub(super) fn row(requests: Vec<Request>, like: &Request) -> Composite {
    let ground = Palette::of(like.shot.look.style.theme).surround;
    let gap = gap(like.size.scale);
    Composite { requests, arrangement: Arrangement::Row, gap, ground, crowded: None, grid: None, width: None }
}

/// An animation of `pictures` frames. `at` gives each frame, of `size` pixels, and its duration in seconds. It pauses
/// after each picture, and within one.
///
/// # Errors
/// [`PictureError`].
pub(super) async fn filmed(
    format: AnimationFormat,
    size: [u32; 2],
    pictures: u32,
    at: impl Fn(u32) -> Option<(Composite, f64)>,
    progress: &Progress,
) -> Result<Vec<u8>, PictureError> {
    // The progress counts pictures. A picture that takes long can be cancelled too.
    let mut renderer = Renderer::default();
    renderer.watch(&progress.part());
    progress.begin(Activity::Encoding, pictures as usize);
    let made = animation(format, size, pictures, async |picture| {
        if progress.is_cancelled() {
            return None;
        }
        let (frame, seconds) = at(picture)?;
        let (mut drawn, _) = renderer.sheet(&frame, false).await?;
        let pixmap = drawn.take_pixmap()?;
        progress.advance_and_pause(1).await;
        #[expect(clippy::cast_possible_truncation, reason = "at most a minute")]
        let ticks = (seconds / TICK).round().max(1.0) as u16;
        Some((pixmap, ticks))
    });
    made.await.map_err(|error| match error {
        AnimationError::NoPicture if progress.is_cancelled() => PictureError::Cancelled,
        AnimationError::NoPicture => PictureError::TooLarge,
        AnimationError::Encode(why) => PictureError::Animate { format, why },
    })
}

/// Begins and ends slowly: 3 t² − 2 t³.
fn eased(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}
