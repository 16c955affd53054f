//! A step of an operation that the eye can follow. The camera moves to its end in a moment, and arrives there exactly.

use eframe::egui::{self, Event};

use camera_lab_desk::Model;

/// Time for which a step is shown in the world, in seconds.
const SHOWN: f64 = 2.0;

/// Advances the motion, at the beginning of a frame, so that every key press finds the camera at its destination.
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
    let share = (now - *motion.began.get_or_insert(now)) / motion.seconds;
    if pressed || share >= 1.0 {
        model.motion = Some(motion);
        model.finish_motion();
        return;
    }
    // The end is a camera. Impossible ones on the way are skipped.
    let _ = model.desk.shown.operate_from(&motion.start, motion.at(share), motion.convention);
    model.motion = Some(motion);
    ctx.request_repaint();
}

/// Shows the last step in the world, for a moment, regardless of the pointer.
pub(in crate::gui) fn show_done(ctx: &egui::Context, model: &mut Model) {
    let Some(done) = &mut model.operations.done else { return };
    let now = ctx.input(|input| input.time);
    let left = *done.since.get_or_insert(now) + SHOWN - now;
    if left > 0.0 && model.operations.scrub.is_none() {
        model.frame.hover.ghost = Some(done.ghost.clone());
        ctx.request_repaint_after(std::time::Duration::from_secs_f64(left));
    } else {
        model.operations.done = None;
    }
}
