//! The subject of the explanations: the figure's camera, and the selected object.

use glam::DMat4;

use crate::camera::Camera;
use crate::explain::{Placement, Setting};
use crate::figure::Measured;
use crate::gui::model::Model;
use crate::gui::model::scene_tree::{Selected, preset_objects};
use crate::scene::edit::placement;
use crate::scene::transform::Trs;
use crate::views::ObjectTransform;

/// The numbers of the symbols, without the rest of the window.
pub(super) struct ExplainedSetting {
    camera: Camera,
    /// The selected object, by its name.
    pub(super) object: Option<(String, Placement)>,
}

impl ExplainedSetting {
    /// The camera of the figure, and the object that is selected, if one is.
    pub(super) fn of(model: &Model) -> Self {
        Self { camera: model.document.camera().clone(), object: selected(model) }
    }

    /// The setting in the convention, image and viewport of the window.
    pub(super) fn setting(&self, model: &Model) -> Setting<'_> {
        let figure = model.document.figure();
        let space = self.camera.possible_clip_space(model.settings.conventions.ndc);
        let setting = Setting::new(space, figure.image, figure.viewport);
        match &self.object {
            Some((_, placement)) => setting.with_placement(*placement),
            None => setting,
        }
    }
}

/// The transform of the selected object, where a part of it is pointed at.
pub(in crate::gui) fn object_transform(model: &Model) -> Option<ObjectTransform> {
    let of_object = |m: &Measured| matches!(m, Measured::Translate(_) | Measured::Rotate(_) | Measured::Scale(_));
    let (_, Placement { translate, rotate, scale, parent, .. }) =
        model.hover.measured.iter().any(of_object).then(|| selected(model)).flatten()?;
    let world_from_parent = parent.unwrap_or(DMat4::IDENTITY);
    Some(ObjectTransform { world_from_parent, trs: Trs { translate, rotate, scale } })
}

/// The placement of the selected object in the world; `None` if none is selected, or the scene is impossible.
pub(super) fn selected(model: &Model) -> Option<(String, Placement)> {
    let scene = &model.document.figure().scene;
    let (name, spec) = match model.tree.selected(scene)? {
        Selected::Object(name) => (name, scene.objects.iter().find(|o| o.name == *name)?.clone()),
        Selected::OfPreset(name) => (name, preset_objects(scene.preset).into_iter().find(|o| o.name == *name)?),
        Selected::Light(_) => return None,
    };
    let parent = match &spec.parent {
        Some(parent) => Some(placement(scene, parent).ok()??),
        None => None,
    };
    let world_from_object = placement(scene, name).ok()??;
    let (translate, rotate, scale) = (spec.translate, spec.rotate, spec.scale);
    Some((name.clone(), Placement { translate, rotate, scale, parent, world_from_object }))
}
