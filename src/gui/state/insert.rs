//! Objects that are put into the scene.

use glam::{DMat4, DVec3};

use super::{Selected, State};
use crate::i18n::scenes;
use crate::numbers;
use crate::scene::edit::{free_name, placements};
use crate::scene::{ObjectSpec, SceneSpec, Shape};

impl State {
    /// Adds a mesh file, by its path as the figure names it.
    pub(in crate::gui) fn insert_mesh(&mut self, path: String) {
        let file = path.rsplit(['/', '\\']).next().unwrap_or(&path);
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        let name = if stem.is_empty() { scenes::texts(self.settings.lang).shape_mesh } else { stem }.to_owned();
        // A mesh has its own size; what it is stays as it was modelled.
        self.insert(ObjectSpec { segments: 32, ..ObjectSpec::new(name, Shape::Mesh { path }) });
    }

    /// Adds an object to the group that is selected, else to no other; and selects it.
    pub(in crate::gui) fn insert(&mut self, object: ObjectSpec) {
        let scene = &self.document.figure().scene;
        let parent = self.group_selected(scene);
        let name = free_name(scene, &object.name);
        let parent_from_world = parent
            .as_ref()
            .and_then(|parent| Some(placements(scene).ok()?.get(parent)?.inverse()))
            .filter(DMat4::is_finite)
            .unwrap_or(DMat4::IDENTITY);
        let translate =
            if parent.is_some() { parent_from_world.transform_point3(object.translate) } else { object.translate };
        let translate = rounded(translate, translate.abs().max_element() * 1e-6);
        let object = ObjectSpec { name: name.clone(), parent, translate, ..object };
        self.document.edit(|figure| figure.scene.objects.push(object));
        self.tree.select(Some(Selected::Object(name)));
    }

    fn group_selected(&self, scene: &SceneSpec) -> Option<String> {
        let Some(Selected::Object(name)) = self.tree.selected(scene) else { return None };
        scene.objects.iter().find(|o| o.name == *name && o.shape.is_none()).map(|o| o.name.clone())
    }
}

/// Each component to the multiple of a power of ten, not above `unit`, that is nearest.
pub(in crate::gui) fn rounded(v: DVec3, unit: f64) -> DVec3 {
    v.map(|x| numbers::round_to(x, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_rounded_to_what_reads_well() {
        assert_eq!(rounded(DVec3::new(0.123, -0.04, 12.0), 0.1), DVec3::new(0.1, 0.0, 12.0));
        assert_eq!(rounded(DVec3::new(1234.0, 5.0, -77.0), 20.0), DVec3::new(1230.0, 10.0, -80.0));
        assert_eq!(rounded(DVec3::new(1.5, 0.0, 0.0), 0.0), DVec3::new(1.5, 0.0, 0.0));
    }
}
