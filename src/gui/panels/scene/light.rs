//! The fields of a light.

use eframe::egui;
use glam::DVec3;

use super::{Edit, SceneForm};
use crate::gui::panels::{VectorField, choice, row};
use crate::gui::tooltip::Explained;
use crate::scene::{DEFAULT_LIGHT, Light, LightKind};

/// Kind, direction or position; returns the request of the button.
pub(super) fn ui(ui: &mut egui::Ui, form: &mut SceneForm, index: usize) -> Option<Edit> {
    let t = form.t;
    let light = *form.scene.lights.get(index)?;
    let mut kind = light.kind;
    row(ui, "", t.kind, t.light_kind_hint, |ui| {
        let kinds = [(LightKind::Directional, t.directional), (LightKind::Point, t.point)];
        choice(ui, t.kind, t.light_kind_hint, &mut kind, &kinds)
    });
    let mut vector = light.vector;
    let (key, _) = light.kind.vector();
    let (name, hint, step) = match light.kind {
        LightKind::Directional => (t.direction, t.direction_hint, 0.1),
        LightKind::Point => (t.light_position, t.light_position_hint, form.step),
    };
    let owner = format!("light {index}");
    let marked = form.is_marked(None, key);
    let field = VectorField { symbol: "", name, hint, field: name, owner: &owner, step, angles: false, marked };
    let outputs = field.show(ui, form.window, &mut vector);
    form.complain(ui, None, key, &outputs);
    // A light of the other kind is at the opposite side, or shines from there.
    let vector = match kind {
        _ if kind == light.kind => vector,
        LightKind::Directional if vector == DVec3::ZERO => DEFAULT_LIGHT,
        LightKind::Directional => -vector,
        LightKind::Point => -vector * (10.0 * form.step),
    };
    form.scene.lights[index] = Light { kind, vector };
    ui.add_space(2.0);
    ui.button(t.delete).explained(t.delete_hint).clicked().then_some(Edit::RemoveLight(index))
}
