//! The move of the camera from one step of a lesson to the next.

use glam::DVec3;

use crate::camera::{Camera, Parameters};
use crate::gui::learn::Learn;
use crate::numbers::round_to;
use camera_lab_desk::{Document, FADE, Model};

/// A move from one step to another.
#[derive(Debug)]
pub(crate) struct Moving {
    pub(super) passage: crate::lessons::Passage,
    /// The step's document in its final state.
    pub(super) target: Box<Document>,
    pub(super) seconds: f64,
    pub(super) began: Option<f64>,
}

impl Learn {
    /// True while the camera moves to a step. Then a change of it isn't the user's.
    pub(in crate::gui) fn moves_to_step(&self) -> bool {
        self.lesson.as_ref().is_some_and(|playing| playing.moving.is_some())
    }

    /// Advances the move to the step. Returns true while it continues. `now` is a time in seconds.
    pub(in crate::gui) fn go_on_moving(&mut self, model: &mut Model, now: f64) -> bool {
        let Some(moving) = self.lesson.as_mut().and_then(|playing| playing.moving.as_mut()) else { return false };
        let share = ((now - *moving.began.get_or_insert(now + FADE)) / moving.seconds).max(0.0);
        if share >= 1.0 {
            self.end_move(model);
            return false;
        }
        // It begins and ends slowly.
        let figure = moving.passage.at(share * share * (3.0 - 2.0 * share));
        // Numbers that change with every frame are readable only with few digits.
        if let Ok(camera) = Camera::new(&few_digits(figure.camera)).or_else(|_| Camera::new(&figure.camera)) {
            model.desk.shown.set_camera(camera);
        }
        *model.desk.shown.observers_mut() = figure.observers;
        *model.desk.shown.show_mut() = figure.show;
        true
    }

    /// Ends the move to the step, if there is one. The step is there exactly.
    pub(in crate::gui) fn end_move(&mut self, model: &mut Model) -> bool {
        let Some(moving) = self.lesson.as_mut().and_then(|playing| playing.moving.take()) else { return false };
        let (now, target) = (model.desk.shown.figure(), moving.target.figure());
        let is_changed = now.scene != target.scene
            || now.points != target.points
            || now.labels != target.labels
            || (&now.title, &now.caption) != (&target.title, &target.caption);
        if is_changed {
            // If the figure was changed meanwhile, only the camera arrives.
            let target = moving.target.figure();
            (*model.desk.shown.observers_mut(), *model.desk.shown.show_mut()) = (target.observers, target.show.clone());
            model.desk.shown.set_camera(moving.target.camera().clone());
        } else {
            model.desk.shown = *moving.target;
        }
        true
    }
}

/// The numbers of a camera with three decimals, in the unit of its distance.
fn few_digits(camera: Parameters) -> Parameters {
    let distance = (camera.focal_point - camera.position).length();
    let unit = 1e-3 * 10_f64.powf(distance.max(f64::MIN_POSITIVE).log10().floor());
    let rounded = |p: DVec3| DVec3::from_array(p.to_array().map(|x| round_to(x, unit)));
    Parameters {
        position: rounded(camera.position),
        focal_point: rounded(camera.focal_point),
        view_up: DVec3::from_array(camera.view_up.to_array().map(|x| round_to(x, 1e-3))),
        view_angle: round_to(camera.view_angle, 0.01),
        height: round_to(camera.height, unit),
        near: round_to(camera.near, unit),
        far: round_to(camera.far, unit),
        ..camera
    }
}
