//! The subject of the explanations: the figure's camera, and the selected object.

use crate::camera::Camera;
use crate::explain::{Placement, Setting};
use camera_lab_desk::Model;

/// The numbers of the symbols, without the rest of the window.
pub(super) struct ExplainedSetting {
    camera: Camera,
    /// The selected object, by its name.
    pub(super) object: Option<(String, Placement)>,
}

impl ExplainedSetting {
    /// The camera of the figure, and the selected object, if there is one.
    pub(super) fn of(model: &Model) -> Self {
        Self { camera: model.desk.shown.camera().clone(), object: model.selected_placement() }
    }

    /// The setting in the convention, image and viewport of the window.
    pub(super) fn setting(&self, model: &Model) -> Setting<'_> {
        let figure = model.desk.shown.figure();
        let space = self.camera.possible_clip_space(model.settings.conventions.ndc);
        let setting = Setting::new(space, figure.image, figure.viewport);
        match &self.object {
            Some((_, placement)) => setting.with_placement(*placement),
            None => setting,
        }
    }
}
