//! The tab of steps of the side of explanations: whose steps, and how far the view volume has come on its way to the canonical one.

use crate::camera::{Camera, Decomposition};
use crate::views::Normalizing;

/// How long a step takes while it is played, in seconds.
const STEP_SECONDS: f64 = 2.0;
/// After a longer pause between two frames, playing goes on where it was.
const LONGEST_FRAME: f64 = 0.5;

/// The tab of steps.
#[derive(Clone, Debug, Default)]
pub struct Steps {
    /// Whose steps.
    pub decomposition: Decomposition,
    /// How many steps are left until the canonical volume; the last may be under way. 0: all are done, as when the tab is opened.
    pub left: f64,
    /// When the last frame was shown, in seconds, while it is played.
    played: Option<f64>,
}

impl Steps {
    /// How many steps the camera has; 0 where it has none of this source.
    #[must_use]
    pub fn count(&self, camera: &Camera) -> usize {
        camera.decomposed(self.decomposition).map_or(0, |factors| factors.len())
    }

    /// How many steps are done, 0 … their number.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a handful of steps")]
    pub fn time(&self, camera: &Camera) -> f64 {
        let count = self.count(camera) as f64;
        (count - self.left).clamp(0.0, count)
    }

    /// Goes to where so many steps are done.
    #[expect(clippy::cast_precision_loss, reason = "a handful of steps")]
    pub fn go_to(&mut self, time: f64, camera: &Camera) {
        let count = self.count(camera) as f64;
        self.left = count - time.clamp(0.0, count);
    }

    /// How the canonical picture is shown; `None` where the camera has no such steps.
    #[must_use]
    pub fn normalizing(&self, camera: &Camera) -> Option<Normalizing> {
        let Self { decomposition, .. } = *self;
        (self.count(camera) > 0).then(|| Normalizing { decomposition, time: self.time(camera) })
    }

    /// True while it is played.
    #[must_use]
    pub fn plays(&self) -> bool {
        self.played.is_some()
    }

    /// Plays from where it is, from the beginning where it is at its end; or holds. `now` is a time in seconds.
    pub(in crate::gui) fn play_or_hold(&mut self, now: f64, camera: &Camera) {
        if self.played.take().is_some() {
            return;
        }
        if self.left <= 0.0 {
            self.go_to(0.0, camera);
        }
        self.played = Some(now);
    }

    /// Holds where it is.
    pub(in crate::gui) fn hold(&mut self) {
        self.played = None;
    }

    /// Goes on playing; at its end it stops.
    pub(in crate::gui) fn advance(&mut self, now: f64) {
        let Some(before) = self.played else { return };
        let passed = now - before;
        self.left -= if passed <= LONGEST_FRAME { passed / STEP_SECONDS } else { 0.0 };
        self.played = Some(now);
        if self.left <= 0.0 {
            (self.left, self.played) = (0.0, None);
        }
    }
}
