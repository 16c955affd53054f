//! The fields of a light, and of its shadows.

use eframe::egui;

use super::{SceneEdit, SceneForm};
use crate::figure::ShadowReveal;
use crate::gui::inspector::{VectorField, choice_row, complain, row};
use crate::gui::kit::{Explained, NumberField, Step, whole};
use crate::scene::{DEFAULT_LIGHT, Light, LightKind, Shadows};
use camera_lab_desk::Model;
use camera_lab_words::window::scenes::Texts;

/// Kind, direction or position. Returns the request of the button.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) -> Option<SceneEdit> {
    let t = form.t;
    let light = *form.scene.lights.get(index)?;
    let mut kind = light.kind;
    let kinds = [(LightKind::Directional, t.directional), (LightKind::Point, t.point)];
    choice_row(ui, t.kind, t.light_kind_hint, &mut kind, &kinds);
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
        LightKind::Directional if vector == glam::DVec3::ZERO => DEFAULT_LIGHT,
        LightKind::Directional => -vector,
        LightKind::Point => -vector * (10.0 * form.step),
    };
    let shadows = shadows(ui, form, &owner, light.shadows);
    form.scene.lights[index] = Light { kind, vector, shadows };
    if shadows.cast {
        reveal(ui, model, form.t);
    }
    ui.add_space(2.0);
    ui.button(t.delete).explained(t.delete_hint).clicked().then_some(SceneEdit::RemoveLight(index))
}

/// The inner work of shadows, in all pictures.
fn reveal(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let mut chosen = model.desk.shown.figure().reveal.shadows;
    let all = [
        (None, t.shadow_plain),
        (Some(ShadowReveal::Map), t.shadow_of_light),
        (Some(ShadowReveal::Acne), t.shadow_acne),
        (Some(ShadowReveal::Truth), t.shadow_truth),
    ];
    choice_row(ui, t.shadow_reveal, t.shadow_reveal_hint, &mut chosen, &all);
    model.desk.shown.set(|figure| &mut figure.reveal.shadows, chosen);
}

/// The switch, and the numbers if it's on.
fn shadows(ui: &mut egui::Ui, form: &SceneForm, owner: &str, mut now: Shadows) -> Shadows {
    let t = form.t;
    ui.checkbox(&mut now.cast, t.shadows).explained(t.shadows_hint);
    if !now.cast {
        return now;
    }
    let number =
        |ui: &mut egui::Ui, [name, hint]: [&'static str; 2], step, [least, most]: [f64; 2], value: &mut f64| {
            let output = row(ui, "", name, hint, |ui| {
                let field = NumberField::new(name, step).of(owner).within(least..=most).width(92.0).hint(hint);
                let field = if matches!(step, Step::Multiply(_)) { field.whole() } else { field };
                field.show(ui, form.window, value)
            });
            complain(ui, form.lang, [&output]);
        };
    let mut map = f64::from(now.map);
    number(ui, [t.shadow_map, t.shadow_map_hint], Step::Multiply(2.0), Shadows::MAPS.map(f64::from), &mut map);
    now.map = whole(map);
    number(ui, [t.shadow_bias, t.shadow_bias_hint], Step::Add(0.25), Shadows::BIASES, &mut now.bias);
    number(ui, [t.shadow_softness, t.shadow_softness_hint], Step::Add(0.25), Shadows::SOFTNESSES, &mut now.softness);
    now
}
