//! Objects and lights to add to a scene, and their placement.

use eframe::egui;
use glam::DVec3;

use crate::camera::{Camera, Projection};
use crate::gui::kit::Explained;
use crate::scene::{DEFAULT_LIGHT, Light, LightKind, ObjectSpec, Shape};
use camera_lab_desk::{Action, FileFor, MeshFor, Model, Selected, free_place, rounded};
use camera_lab_words::window::scenes::Texts;

/// The menu of objects and lights to add.
pub(super) fn menu(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let button = egui::Button::new(format!("+ {}", t.add));
    let response = egui::containers::menu::MenuButton::from_button(button).ui(ui, |ui| entries(ui, model, t)).0;
    response.explained(t.add_hint).accessible_name(t.add);
}

fn entries(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
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
        if chosen(ui, t.shape(Some(&shape))) {
            add(model, ObjectSpec::new(t.shape(Some(&shape)), shape));
        }
    }
    ui.separator();
    for shape in flat {
        if chosen(ui, t.shape(Some(&shape))) {
            add(model, ObjectSpec::new(t.shape(Some(&shape)), shape));
        }
    }
    if chosen(ui, t.shape_mesh_file) {
        model.request(Action::File(FileFor::Mesh(MeshFor::New)));
    }
    ui.separator();
    if chosen(ui, t.group) {
        add(model, ObjectSpec { scale: DVec3::ONE, ..ObjectSpec::group(t.group) });
    }
    ui.separator();
    for (name, light) in
        [(t.directional_light, Light::directional(DEFAULT_LIGHT)), (t.point_light, Light::point(DVec3::ZERO))]
    {
        if chosen(ui, name) {
            add_light(model, light);
        }
    }
}

/// An entry. If the pointer or the keyboard chooses it, the menu closes.
fn chosen(ui: &mut egui::Ui, name: &str) -> bool {
    let clicked = ui.button(name).clicked();
    if clicked {
        ui.close();
    }
    clicked
}

/// Adds an object at PF, in a size that suits the view.
fn add(model: &mut Model, object: ObjectSpec) {
    let camera = model.desk.shown.camera();
    let size = if object.shape.is_some() { size_in(camera) } else { 1.0 };
    let place = match object.shape {
        // A grid lies at the bottom of the scene, and a group has no body.
        None | Some(Shape::Grid) => rounded(camera.focal_point(), size / 10.0),
        Some(_) => free_place(camera, model.scene_cache.scene(), size),
    };
    let object = ObjectSpec { translate: place, scale: DVec3::splat(size), ..object };
    model.insert(object);
}

fn add_light(model: &mut Model, light: Light) {
    let camera = model.desk.shown.camera();
    let light = match light.kind {
        LightKind::Directional => light,
        // Above the focal point, as a lamp hangs.
        LightKind::Point => {
            let size = size_in(camera);
            Light::point(rounded(camera.focal_point() + DVec3::new(size, 4.0 * size, size), size / 10.0))
        }
    };
    let index = model.desk.shown.figure().scene.lights.len();
    model.desk.shown.edit(|figure| figure.scene.lights.push(light));
    model.tree.select(Some(Selected::Light(index)));
}

/// 1, 2 or 5 times a power of ten, about a fifth of the visible height at PF above the middle.
fn size_in(camera: &Camera) -> f64 {
    let half = match camera.projection() {
        Projection::Parallel => camera.window().height() / 2.0,
        Projection::Perspective => camera.window().height() / 2.0 / camera.near() * camera.distance(),
    };
    let wanted = half / 5.0;
    crate::numbers::nice_below(wanted).unwrap_or(1.0)
}
