//! The selected object in the world.

use glam::DMat4;

use crate::explain::Placement;
use crate::figure::Measured;
use crate::model::Model;
use crate::scene::edit::placement;
use crate::scene::transform::Trs;
use crate::scene_tree::{Selected, preset_objects};
use crate::views::ObjectTransform;

impl Model {
    /// The transform of the selected object, if the pointer is on a part of it.
    pub fn object_transform(&self) -> Option<ObjectTransform> {
        let of_object = |m: &Measured| matches!(m, Measured::Translate(_) | Measured::Rotate(_) | Measured::Scale(_));
        let (_, Placement { translate, rotate, scale, parent, .. }) =
            self.frame.hover.measured.iter().any(of_object).then(|| self.selected_placement()).flatten()?;
        let world_from_parent = parent.unwrap_or(DMat4::IDENTITY);
        Some(ObjectTransform { world_from_parent, trs: Trs { translate, rotate, scale } })
    }

    /// The placement of the selected object in the world. `None` if none is selected, or the scene is impossible.
    pub fn selected_placement(&self) -> Option<(String, Placement)> {
        let scene = &self.desk.shown.figure().scene;
        let (name, spec) = match self.tree.selected(scene)? {
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
}
