//! A camera on its way.

use crate::camera::{Amount, Camera, Convention, Framing, Freedom, Operation};
use crate::model::Model;
use crate::operations::DoneStep;
use crate::scene_tree::Selected;

/// Seconds in which the pictures of a step before fade into those of the next one.
pub const FADE: f64 = 0.4;

/// Duration of a step, in seconds.
const STEP: f64 = 0.2;

/// A step on its way to its end.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The camera before the step.
    pub start: Camera,
    /// The operation.
    pub freedom: Freedom,
    /// Degrees, scene units or a factor, by the operation.
    pub amount: f64,
    /// The signs of angles.
    pub convention: Convention,
    /// Its duration, in seconds.
    pub seconds: f64,
    /// When it began, in seconds. `None` for the next frame.
    pub began: Option<f64>,
}

impl Motion {
    /// The operation up to a share of the way: all of it at 1, exactly.
    pub fn at(&self, share: f64) -> Operation {
        self.freedom.by(match self.freedom.descriptor().amount {
            _ if share >= 1.0 => self.amount,
            Amount::Angle | Amount::Length => self.amount * share,
            Amount::Factor => self.amount.powf(share),
        })
    }
}

impl Model {
    /// Begins a step. It's at its end at once if motion is to be reduced, or if it leads to no camera.
    pub fn begin_motion(&mut self, freedom: Freedom, amount: f64) {
        self.finish_motion();
        let (start, convention) = (self.desk.shown.camera().clone(), self.operations.convention);
        let operation = freedom.by(amount);
        let ghost = crate::views::Ghost { before: start.clone(), operation, convention };
        self.operations.last = Some(ghost.clone());
        self.operations.done = Some(DoneStep { ghost, since: None });
        if self.settings.reduce_motion || operation.apply(&start, convention).is_err() {
            self.operate(operation);
        } else {
            self.motion = Some(Motion { start, freedom, amount, convention, seconds: STEP, began: None });
        }
    }

    /// Aims the camera at the selected objects, or fits the image to them. Without a selection, all objects are meant.
    /// One step to undo, and the world shows the camera before it.
    pub fn frame_objects(&mut self, framing: Framing) {
        self.finish_motion();
        let spec = &self.desk.shown.figure().scene;
        let mut names = self.tree.names(spec);
        if let Some(Selected::OfPreset(name)) = self.tree.selected(spec) {
            names.insert(name.clone());
        }
        let (before, scene) = (self.desk.shown.camera().clone(), self.scene_cache.scene().clone());
        let Some(extent) = scene.extent_of(spec, &names) else { return };
        match framing.of(&before, &extent) {
            Ok(after) => {
                // The way is drawn as that of a pan: from place to place.
                let (operation, convention) = (Operation::Pan { dx: 0.0, dy: 0.0 }, self.operations.convention);
                let ghost = crate::views::Ghost { before, operation, convention };
                self.operations.done = Some(DoneStep { ghost, since: None });
                self.desk.shown.set_camera(after);
                self.desk.commit();
            }
            Err(error) => self.say_camera_error(Err(error)),
        }
    }

    /// Puts the camera at the end of the step, as one change.
    pub fn finish_motion(&mut self) {
        let Some(motion) = self.motion.take() else { return };
        let done = self.desk.shown.operate_from(&motion.start, motion.at(1.0), motion.convention);
        self.desk.commit();
        self.say_camera_error(done);
    }
}

/// The apparent motion of the camera: an arrow for its place, its look or its turn. `None` without a sideways motion.
pub fn arrow(before: &Camera, freedom: Freedom, forwards: bool, convention: Convention) -> Option<char> {
    let unit = match freedom.descriptor().amount {
        Amount::Angle => 1.0,
        Amount::Length => before.distance() * 1e-3,
        Amount::Factor => return None,
    };
    let after = freedom.by(if forwards { unit } else { -unit }).apply(before, convention).ok()?;
    let basis = before.basis();
    let moved = after.position() - before.position();
    let way = if moved.length() > 1e-9 * before.distance() {
        moved / before.distance()
    } else {
        after.direction_of_projection() - before.direction_of_projection()
    };
    let (x, y) = (way.dot(basis.u), way.dot(basis.v));
    if x.abs().max(y.abs()) < 1e-6 {
        // n points to the viewer, who sees v lean to the left if it turns counter-clockwise.
        let lean = after.basis().v.dot(basis.u);
        return (lean.abs() > 1e-6).then_some(if lean < 0.0 { '↺' } else { '↻' });
    }
    Some(match (x.abs() > y.abs(), x > 0.0, y > 0.0) {
        (true, true, _) => '→',
        (true, false, _) => '←',
        (false, _, true) => '↑',
        (false, _, false) => '↓',
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::camera::Parameters;

    #[test]
    fn arrow_keys_agree_with_the_view_under_both_conventions() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let at = |freedom, forwards, convention| arrow(&camera, freedom, forwards, convention);
        let right_hand = Convention::RightHand;
        for (freedom, plus, minus) in [
            // By the right-hand rule a positive elevation lowers the camera.
            (Freedom::Elevation, Some('↓'), Some('↑')),
            (Freedom::Azimuth, Some('→'), Some('←')),
            (Freedom::Roll, Some('↺'), Some('↻')),
            (Freedom::Yaw, Some('←'), Some('→')),
            (Freedom::Pitch, Some('↑'), Some('↓')),
            (Freedom::Zoom, None, None),
            (Freedom::Dolly, None, None),
            (Freedom::PanU, Some('→'), Some('←')),
            (Freedom::PanV, Some('↑'), Some('↓')),
        ] {
            assert_eq!((at(freedom, true, right_hand), at(freedom, false, right_hand)), (plus, minus), "{freedom:?}");
        }
        assert_eq!(at(Freedom::Elevation, true, Convention::Vtk), Some('↑'));
        assert_eq!(at(Freedom::Roll, true, Convention::Vtk), Some('↻'));
        assert_eq!(at(Freedom::Azimuth, true, Convention::Vtk), Some('→'));
    }
}
