//! What can be added to a scene, and where it is put.

use eframe::egui;
use glam::{DMat4, DVec3};

use super::Selected;
use crate::camera::{Camera, Projection};
use crate::gui::filing::{self, MeshFor, Purpose};
use crate::gui::state::State;
use crate::i18n::scenes::{self, Texts};
use crate::numbers;
use crate::scene::edit::{free_name, placements};
use crate::scene::{LightSpec, ObjectSpec, SceneSpec, Shape};

/// The menu of what can be added.
pub(super) fn menu(ui: &mut egui::Ui, state: &mut State, t: &Texts) {
    let button = egui::Button::new(format!("+ {}", t.add));
    let response = egui::containers::menu::MenuButton::from_button(button).ui(ui, |ui| entries(ui, state, t)).0;
    response.on_hover_text(t.add_hint).accessible_name(t.add);
}

fn entries(ui: &mut egui::Ui, state: &mut State, t: &Texts) {
    let solids = [
        Shape::Box,
        Shape::Prism,
        Shape::Pyramid,
        Shape::Sphere,
        Shape::Ellipsoid,
        Shape::Cylinder,
        Shape::Cone,
        Shape::Torus,
    ];
    let flat = [Shape::Grid, Shape::Points(vec![DVec3::ZERO]), Shape::Segments(vec![[DVec3::ZERO, DVec3::X]])];
    ui.set_min_width(170.0);
    for shape in solids {
        if ui.button(t.shape(Some(&shape))).clicked() {
            add(state, ObjectSpec::new(t.shape(Some(&shape)), shape));
        }
    }
    ui.separator();
    for shape in flat {
        if ui.button(t.shape(Some(&shape))).clicked() {
            add(state, ObjectSpec::new(t.shape(Some(&shape)), shape));
        }
    }
    if ui.button(t.shape_mesh_file).clicked() {
        filing::ask(ui.ctx(), state, Purpose::Mesh(MeshFor::New));
    }
    ui.separator();
    if ui.button(t.group).clicked() {
        add(state, ObjectSpec { scale: DVec3::ONE, ..ObjectSpec::group(t.group) });
    }
    ui.separator();
    for (name, light) in [
        (t.directional_light, LightSpec::Directional(crate::scene::DEFAULT_LIGHT)),
        (t.point_light, LightSpec::Point(DVec3::ZERO)),
    ] {
        if ui.button(name).clicked() {
            add_light(state, light);
        }
    }
}

/// Adds a mesh file, by its path as the figure names it.
pub fn add_mesh(state: &mut State, path: String) {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(&path);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let name = if stem.is_empty() { scenes::texts(state.settings.lang).shape_mesh } else { stem }.to_owned();
    // A mesh has its own size; what it is stays as it was modelled.
    insert(state, ObjectSpec { segments: 32, ..ObjectSpec::new(name, Shape::Mesh { path }) });
}

/// Adds an object where the camera looks, in a size that suits what it sees.
fn add(state: &mut State, object: ObjectSpec) {
    let camera = state.document.camera();
    let size = if object.shape.is_some() { size_in(camera) } else { 1.0 };
    let place = round_to(camera.focal_point(), size / 10.0);
    let object = ObjectSpec { translate: place, scale: DVec3::splat(size), ..object };
    insert(state, object);
}

/// Adds an object to the group that is selected, else to no other; and selects it.
fn insert(state: &mut State, object: ObjectSpec) {
    let scene = &state.document.figure().scene;
    let parent = group_selected(state, scene);
    let name = free_name(scene, &object.name);
    let parent_from_world = parent
        .as_ref()
        .and_then(|parent| Some(placements(scene).ok()?.get(parent)?.inverse()))
        .filter(DMat4::is_finite)
        .unwrap_or(DMat4::IDENTITY);
    let translate =
        if parent.is_some() { parent_from_world.transform_point3(object.translate) } else { object.translate };
    let translate = round_to(translate, translate.abs().max_element() * 1e-6);
    let object = ObjectSpec { name: name.clone(), parent, translate, ..object };
    state.document.edit(|figure| figure.scene.objects.push(object));
    state.tree.select(Some(Selected::Object(name)));
}

fn group_selected(state: &State, scene: &SceneSpec) -> Option<String> {
    let Some(Selected::Object(name)) = state.tree.selected(scene) else { return None };
    scene.objects.iter().find(|o| o.name == *name && o.shape.is_none()).map(|o| o.name.clone())
}

fn add_light(state: &mut State, light: LightSpec) {
    let camera = state.document.camera();
    let light = match light {
        LightSpec::Directional(_) => light,
        // Above what is looked at, as a lamp hangs.
        LightSpec::Point(_) => {
            let size = size_in(camera);
            LightSpec::Point(round_to(camera.focal_point() + DVec3::new(size, 4.0 * size, size), size / 10.0))
        }
    };
    let index = state.document.figure().scene.lights.len();
    state.document.edit(|figure| figure.scene.lights.push(light));
    state.tree.select(Some(Selected::Light(index)));
}

/// 1, 2 or 5 times a power of ten, about a fifth of what the camera sees at PF from the middle upwards.
fn size_in(camera: &Camera) -> f64 {
    let half = match camera.projection() {
        Projection::Parallel => camera.window().height() / 2.0,
        Projection::Perspective => camera.window().height() / 2.0 / camera.near() * camera.distance(),
    };
    let wanted = half / 5.0;
    numbers::nice_below(wanted).unwrap_or(1.0)
}

/// Each component to the multiple of a power of ten, not above `unit`, that is nearest.
fn round_to(v: DVec3, unit: f64) -> DVec3 {
    v.map(|x| numbers::round_to(x, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_rounded_to_what_reads_well() {
        assert_eq!(round_to(DVec3::new(0.123, -0.04, 12.0), 0.1), DVec3::new(0.1, 0.0, 12.0));
        assert_eq!(round_to(DVec3::new(1234.0, 5.0, -77.0), 20.0), DVec3::new(1230.0, 10.0, -80.0));
        assert_eq!(round_to(DVec3::new(1.5, 0.0, 0.0), 0.0), DVec3::new(1.5, 0.0, 0.0));
    }
}
