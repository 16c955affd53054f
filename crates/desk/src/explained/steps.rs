//! The explanation of the steps: the source of the next steps, and if they are playing. Their progress is in the
//! figure's `[show]`.

use crate::camera::{Camera, Decomposition};
use crate::figure::ShownStep;

/// Duration of a step in playback, in seconds.
const STEP_SECONDS: f64 = 2.0;
/// After a longer pause between two frames, playing continues from the same place.
const LONGEST_FRAME: f64 = 0.5;

/// The explanation of steps.
#[derive(Clone, Debug, Default)]
pub struct Steps {
    /// The source of the steps.
    pub way: Decomposition,
    /// The explained entry, of the step's matrix (0) or of the product so far (1), with row and column from 0.
    pub entry: Option<(usize, [usize; 2])>,
    /// When the last frame was shown, in seconds, while it's playing.
    played: Option<f64>,
}

/// Number of steps for a camera. 0 if the source has none.
pub fn count(way: Decomposition, camera: &Camera) -> usize {
    camera.decomposed(way).map_or(0, |factors| factors.len())
}

/// The time at which all steps of a camera are done.
#[expect(clippy::cast_precision_loss, reason = "a handful of steps")]
pub fn end_of(way: Decomposition, camera: &Camera) -> f64 {
    count(way, camera) as f64
}

/// The way after a time in steps.
pub fn step_at(way: Decomposition, time: f64, camera: &Camera) -> ShownStep {
    ShownStep { way, at: Some(time.max(0.0)).filter(|time| *time < end_of(way, camera)) }
}

/// The number of steps applied, 0 … all.
pub fn time_of(step: ShownStep, camera: &Camera) -> f64 {
    crate::views::Normalizing::of(step, camera).map_or(0.0, |way| way.time)
}

impl Steps {
    /// True while it's playing.
    pub fn plays(&self) -> bool {
        self.played.is_some()
    }

    /// Plays from its place, or from the beginning if it's at its end, or pauses. `now` is a time in seconds. Returns
    /// the new place.
    pub fn play_or_hold(&mut self, step: ShownStep, now: f64) -> ShownStep {
        if self.played.take().is_some() {
            return step;
        }
        self.played = Some(now);
        ShownStep { at: step.at.or(Some(0.0)), ..step }
    }

    /// Pauses at its place.
    pub fn hold(&mut self) {
        self.played = None;
    }

    /// Advances, and stops at the end. Returns the new place.
    pub fn advance(&mut self, step: ShownStep, now: f64, camera: &Camera) -> ShownStep {
        let Some(before) = self.played else { return step };
        // If the clock goes back, nothing plays.
        let passed = (now - before).max(0.0);
        let passed = if passed <= LONGEST_FRAME { passed / STEP_SECONDS } else { 0.0 };
        let next = step_at(step.way, time_of(step, camera) + passed, camera);
        self.played = next.at.map(|_| now);
        next
    }
}
