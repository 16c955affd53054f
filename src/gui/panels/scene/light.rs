//! The fields of a light.

use eframe::egui;

use super::{Edit, SceneForm};
use crate::gui::panels::{VectorField, choice, row};
use crate::gui::tooltip::Explained;
use crate::scene::LightSpec;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Directional,
    Point,
}

/// Kind, direction or position; returns the request of the button.
pub(super) fn ui(ui: &mut egui::Ui, form: &mut SceneForm, index: usize) -> Option<Edit> {
    let t = form.t;
    let light = *form.scene.lights.get(index)?;
    let old = if matches!(light, LightSpec::Directional(_)) { Kind::Directional } else { Kind::Point };
    let mut kind = old;
    row(ui, "", t.kind, t.light_kind_hint, |ui| {
        let kinds = [(Kind::Directional, t.directional), (Kind::Point, t.point)];
        choice(ui, t.kind, t.light_kind_hint, &mut kind, &kinds)
    });
    let (mut vector, key, name, hint) = match light {
        LightSpec::Directional(v) => (v, "direction", t.direction, t.direction_hint),
        LightSpec::Point(p) => (p, "position", t.light_position, t.light_position_hint),
    };
    let owner = format!("light {index}");
    let step = if key == "direction" { 0.1 } else { form.step };
    let marked = form.is_marked(None, key);
    let field = VectorField { symbol: "", name, hint, field: name, owner: &owner, step, angles: false, marked };
    let outputs = field.show(ui, form.window, &mut vector);
    form.complain(ui, None, key, &outputs);
    // A lamp of the other kind is, or shines, opposite to the old one.
    form.scene.lights[index] = match (kind, kind == old) {
        (Kind::Directional, true) => LightSpec::Directional(vector),
        (Kind::Point, true) => LightSpec::Point(vector),
        (Kind::Directional, false) => {
            LightSpec::Directional(if vector == glam::DVec3::ZERO { crate::scene::DEFAULT_LIGHT } else { -vector })
        }
        (Kind::Point, false) => LightSpec::Point(-vector * (10.0 * form.step)),
    };
    ui.add_space(2.0);
    ui.button(t.delete).explained(t.delete_hint).clicked().then_some(Edit::RemoveLight(index))
}
