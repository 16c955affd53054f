//! A step of an operation that the eye can follow. The camera moves to its end in a moment, and is there exactly.

use std::time::Duration;

use eframe::egui::{self, Event};

use crate::camera::{Amount, Camera, Convention, Freedom};
use crate::gui::inspector::state::operations::{DoneStep, Operations};
use crate::gui::model::Model;
use crate::gui::model::motion::Motion;
use crate::views::Ghost;

/// Duration of a step, in seconds.
const DURATION: f64 = 0.2;
/// Time for which a step is shown in the world, in seconds.
const SHOWN: f64 = 2.0;

/// Begins a step; at once at its end where motion is to be reduced, or where it leads to no camera.
pub(in crate::gui) fn begin(model: &mut Model, operations: &mut Operations, freedom: Freedom, amount: f64) {
    finish(model);
    let (start, convention) = (model.document.camera().clone(), operations.convention);
    let operation = freedom.by(amount);
    let ghost = Ghost { before: start.clone(), operation, convention };
    operations.last = Some(ghost.clone());
    operations.done = Some(DoneStep { ghost, since: None });
    if model.settings.reduce_motion || operation.apply(&start, convention).is_err() {
        operations.operate(model, operation);
    } else {
        model.motion = Some(Motion { start, freedom, amount, convention, began: None });
    }
}

/// Moves on, at the begin of a frame. Whatever is pressed then finds the camera where it was going.
pub(in crate::gui) fn advance(ctx: &egui::Context, model: &mut Model) {
    let Some(mut motion) = model.motion.take() else { return };
    let (now, pressed) = ctx.input(|input| {
        let presses = |event: &Event| {
            matches!(
                event,
                Event::Key { .. } | Event::Text(_) | Event::PointerButton { .. } | Event::AccessKitActionRequest(_)
            )
        };
        (input.time, input.raw.events.iter().any(presses))
    });
    let share = (now - *motion.began.get_or_insert(now)) / DURATION;
    if pressed || share >= 1.0 {
        model.motion = Some(motion);
        finish(model);
        return;
    }
    // The end is a camera; a place on the way that is none is passed over.
    let _ = model.document.operate_from(&motion.start, motion.at(share), motion.convention);
    model.motion = Some(motion);
    ctx.request_repaint();
}

/// Shows the step that was done last in the world, for a moment, whatever the pointer is over.
pub(in crate::gui) fn show_done(ctx: &egui::Context, model: &mut Model, operations: &mut Operations) {
    let Some(done) = &mut operations.done else { return };
    let now = ctx.input(|input| input.time);
    let left = *done.since.get_or_insert(now) + SHOWN - now;
    if left > 0.0 && operations.scrub.is_none() {
        model.hover.ghost = Some(done.ghost.clone());
        ctx.request_repaint_after(Duration::from_secs_f64(left));
    } else {
        operations.done = None;
    }
}

/// Puts the camera at the end of the step, as one change.
pub(in crate::gui) fn finish(model: &mut Model) {
    let Some(motion) = model.motion.take() else { return };
    let done = model.document.operate_from(&motion.start, motion.at(1.0), motion.convention);
    model.document.commit();
    model.say_camera_error(done);
}

/// The apparent motion of the camera. An arrow for its place, its look or its turn; `None` without a sideways motion.
pub(in crate::gui) fn arrow(before: &Camera, freedom: Freedom, forwards: bool, convention: Convention) -> Option<char> {
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
        // n points to the viewer, who sees v lean to the left where it turns counter-clockwise.
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
    fn arrows_say_what_the_eye_sees_under_both_conventions() {
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
