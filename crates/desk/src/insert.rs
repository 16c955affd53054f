//! Objects that are put into the scene.

use glam::{DMat4, DVec3};

use crate::camera::Camera;
use crate::geometry::Aabb;
use crate::scene::edit::{free_name, placement};
use crate::scene::palette::least_used;
use crate::scene::{Object, ObjectSpec, Scene, SceneSpec, Shape};
use crate::scene_tree::Selected;
use crate::views::pick::can_be_seen_by;
use crate::{Model, numbers};
use camera_lab_words::window::scenes;

impl Model {
    /// Adds a mesh file, by its path in the figure.
    pub fn insert_mesh(&mut self, path: String) {
        let file = path.rsplit(['/', '\\']).next().unwrap_or(&path);
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        let name = if stem.is_empty() { scenes::texts(self.settings.lang).shape_mesh } else { stem }.to_owned();
        // A mesh has its own size, so it stays as modelled.
        self.insert(ObjectSpec { segments: 32, outline: true, ..ObjectSpec::new(name, Shape::Mesh { path }) });
    }

    /// Adds an object to the selected group, or to none, and selects it.
    pub fn insert(&mut self, object: ObjectSpec) {
        let scene = &self.desk.shown.figure().scene;
        let parent = self.group_selected(scene);
        let name = free_name(scene, &object.name);
        let parent_from_world = parent
            .as_ref()
            .and_then(|parent| Some(placement(scene, parent).ok()??.inverse()))
            .filter(DMat4::is_finite)
            .unwrap_or(DMat4::IDENTITY);
        let translate =
            if parent.is_some() { parent_from_world.transform_point3(object.translate) } else { object.translate };
        let translate = rounded(translate, translate.abs().max_element() * 1e-6);
        // A mesh has the colours of its materials, a grid a grey of its own, a group none.
        let has_own = matches!(object.shape, None | Some(Shape::Mesh { .. } | Shape::Grid));
        let color = object.color.or_else(|| (!has_own).then(|| least_used(self.scene_cache.scene())));
        let object = ObjectSpec { name: name.clone(), parent, translate, color, ..object };
        self.desk.shown.edit(|figure| figure.scene.objects.push(object));
        self.tree.select(Some(Selected::Object(name)));
    }

    fn group_selected(&self, scene: &SceneSpec) -> Option<String> {
        let Some(Selected::Object(name)) = self.tree.selected(scene) else { return None };
        scene.objects.iter().find(|o| o.name == *name && o.shape.is_none()).map(|o| o.name.clone())
    }
}

/// A place for an object that reaches `half` (scene units) to every side. It's at or near the point that the camera
/// looks at, so that the object is visible as a whole, in front of everything, and touches nothing. If there is no such
/// place, it's that point itself.
pub fn free_place(camera: &Camera, scene: &Scene, half: f64) -> DVec3 {
    /// The distance to try to the sides (and half of it towards the eye), in steps of a thing's size.
    const MOST: i32 = 6;
    let (basis, middle) = (camera.basis(), camera.focal_point());
    let taken: Vec<Aabb> = scene.objects.iter().filter(|o| o.faces).filter_map(Object::bounds).collect();
    let mut steps: Vec<(i32, i32, i32)> =
        (-MOST..=MOST).flat_map(|i| (-MOST..=MOST).flat_map(move |j| (0..=MOST / 2).map(move |k| (i, j, k)))).collect();
    // Upwards before downwards, sideways before towards the eye.
    steps.sort_by_key(|&(i, j, k)| (i * i + j * j + 2 * k * k, -j, i.abs(), i));
    let place = |(i, j, k): (i32, i32, i32)| {
        let way = basis.u * f64::from(i) + basis.v * f64::from(j) + basis.n * f64::from(k);
        rounded(middle + way * (2.2 * half), half / 5.0)
    };
    let is_good = |p: &DVec3| {
        let around = Aabb { min: *p - half, max: *p + half };
        let apart = |other: &Aabb| (around.max.cmplt(other.min) | around.min.cmpgt(other.max)).any();
        taken.iter().all(apart)
            && around.corners().iter().all(|corner| is_in_volume(camera, *corner))
            && can_be_seen_by(camera, scene, *p)
    };
    steps.into_iter().map(place).find(is_good).unwrap_or_else(|| rounded(middle, half / 5.0))
}

fn is_in_volume(camera: &Camera, p: DVec3) -> bool {
    let clip = camera.clip_point(p);
    clip.truncate().abs().max_element() <= clip.w
}

/// Rounds each component to the nearest multiple of a power of ten not above `unit`.
pub fn rounded(v: DVec3, unit: f64) -> DVec3 {
    v.map(|x| numbers::round_to(x, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_rounded_to_readable_numbers() {
        assert_eq!(rounded(DVec3::new(0.123, -0.04, 12.0), 0.1), DVec3::new(0.1, 0.0, 12.0));
        assert_eq!(rounded(DVec3::new(1234.0, 5.0, -77.0), 20.0), DVec3::new(1230.0, 10.0, -80.0));
        assert_eq!(rounded(DVec3::new(1.5, 0.0, 0.0), 0.0), DVec3::new(1.5, 0.0, 0.0));
    }
}
