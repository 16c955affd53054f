//! The selection of the tree, marked in the pictures.

use std::collections::BTreeSet;

use glam::{DMat4, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, Theme};
use crate::geometry::{Aabb, try_unit};
use crate::scene::edit::{descendants, placement};
use crate::scene::{Light, LightKind, Line, PointMark, Scene, SceneSpec, Shape, preset_objects};
use crate::views::{Palette, SharedScene};
use camera_lab_desk::{Memo, Model, Selected};

/// The scene with the selection marked in it. Rebuilt only if one of both has changed.
#[derive(Debug, Default)]
pub(in crate::gui) struct Highlight {
    marked: Memo<(SharedScene, Selected, BTreeSet<String>, Theme), SharedScene>,
}

/// An object with more edges is marked by its box.
const MOST_EDGES: usize = 400;

impl Highlight {
    /// The scene that the pictures show.
    pub(in crate::gui) fn scene(&mut self, model: &Model) -> SharedScene {
        let (scene, figure) = (model.scene_cache.scene(), model.desk.shown.figure());
        let Some(selected) = model.tree.selected(&figure.scene) else {
            self.marked.forget();
            return scene.clone();
        };
        let key = (scene.clone(), selected.clone(), model.tree.also().clone(), model.settings.theme);
        let mark = |(scene, selected, also, theme): &(SharedScene, Selected, BTreeSet<String>, Theme)| {
            let color = Palette::of(*theme).probe;
            let mut marked = Scene::clone(scene);
            for name in also {
                mark_objects(&mut marked, &figure.scene, name, color);
            }
            match selected {
                Selected::Object(name) | Selected::OfPreset(name) => {
                    mark_objects(&mut marked, &figure.scene, name, color);
                }
                Selected::Light(index) => {
                    if let Some(light) = figure.scene.lights.get(*index) {
                        mark_light(&mut marked, *light, scene.bounds(), color);
                    }
                }
            }
            scene.marked(marked)
        };
        self.marked.of(key, mark).clone()
    }
}

fn style(color: Rgba, width: f32) -> LineStyle {
    LineStyle { color, width, dash: Dash::Solid, hidden: HiddenLines::Dashed, arrow: false }
}

/// Marks an object and its descendants, by its edges if it has few and shows them, otherwise by the box around it.
fn mark_objects(scene: &mut Scene, spec: &SceneSpec, name: &str, color: Rgba) {
    let names = with_descendants(spec, name);
    let mut boxes = Vec::new();
    for object in scene.objects.iter_mut().filter(|object| names.contains(object.owner())) {
        if object.edges.is_some() && object.mesh.edges.len() <= MOST_EDGES {
            object.edges = Some(style(color, 2.2));
        } else if let Some(bounds) = object.mesh.bounds() {
            boxes.push((bounds, object.world_from_object));
        }
    }
    // A grid is lines without an object.
    let preset = preset_objects(spec.preset, &crate::scene::palette::SceneColors::of(Theme::Light));
    let grids = spec.objects.iter().chain(&preset).filter(|o| o.shape == Some(Shape::Grid));
    for grid in grids.filter(|o| names.contains(&o.name)) {
        let flat = Aabb { min: DVec3::new(-1.0, 0.0, -1.0), max: DVec3::new(1.0, 0.0, 1.0) };
        boxes.extend(placement(spec, &grid.name).ok().flatten().map(|matrix| (flat, matrix)));
    }
    for (bounds, matrix) in boxes {
        scene.lines.extend(box_edges(&bounds, &matrix).map(|ends| Line::new(ends.to_vec(), style(color, 1.6))));
    }
}

/// The name and those of all its descendants.
fn with_descendants(spec: &SceneSpec, name: &str) -> BTreeSet<String> {
    let mut all = SceneSpec {
        objects: preset_objects(spec.preset, &crate::scene::palette::SceneColors::of(Theme::Light)),
        ..SceneSpec::default()
    };
    all.objects.retain(|object| spec.objects.iter().all(|own| own.name != object.name));
    all.objects.extend(spec.objects.iter().cloned());
    let mut names = descendants(&all, name);
    names.insert(name.to_owned());
    names
}

/// The edges of a box that turns with its object. Those without length are left out.
fn box_edges(bounds: &Aabb, world_from_object: &DMat4) -> impl Iterator<Item = [DVec3; 2]> {
    let corners = bounds.corners().map(|p| (p, world_from_object.transform_point3(p)));
    let mut edges: Vec<[DVec3; 2]> = Vec::new();
    for (i, (a, a_world)) in corners.into_iter().enumerate() {
        for (b, b_world) in corners.into_iter().skip(i + 1) {
            let along_one_axis = (a - b).to_array().into_iter().filter(|d| *d != 0.0).count() == 1;
            // The corners of a flat box coincide in pairs.
            let is_known = edges.contains(&[a_world, b_world]) || edges.contains(&[b_world, a_world]);
            if along_one_axis && !is_known {
                edges.push([a_world, b_world]);
            }
        }
    }
    edges.into_iter()
}

/// A lamp gets a mark, and parallel light an arrow that ends in the middle of the scene.
fn mark_light(scene: &mut Scene, light: Light, bounds: Option<Aabb>, color: Rgba) {
    match light.kind {
        LightKind::Point => {
            scene.marks.push(PointMark {
                position: light.vector,
                shape: MarkShape::Diamond,
                radius: 7.0,
                color,
                fade_if_hidden: false,
            });
        }
        LightKind::Directional => {
            let Some(unit) = try_unit(light.vector) else { return };
            let around = bounds.unwrap_or(Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE });
            let (to, length) = (around.center(), 1.2 * around.radius().max(1e-3));
            let style = LineStyle { arrow: true, hidden: HiddenLines::Shown, ..style(color, 2.5) };
            scene.lines.push(Line::new(vec![to - unit * length, to], style));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_has_twelve_edges_and_a_flat_one_four() {
        let unit = Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE };
        assert_eq!(box_edges(&unit, &DMat4::from_scale(DVec3::new(1.0, 2.0, 3.0))).count(), 12);
        let flat = Aabb { min: DVec3::new(-1.0, 0.0, -1.0), max: DVec3::new(1.0, 0.0, 1.0) };
        assert_eq!(box_edges(&flat, &DMat4::IDENTITY).count(), 4);
    }
}
