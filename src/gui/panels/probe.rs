//! What is pointed at, in every space.

use eframe::egui::{self, RichText};
use glam::DVec2;

use super::{TEXT_LINE, section};
use crate::camera::Viewport;
use crate::gui::numbers;
use crate::gui::state::State;
use crate::i18n::window::{self, Texts};
use crate::views::Probe;

/// Shows the point or the ray that is pointed at, and afterwards the one that was, so that nothing jumps.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    if state.probe.is_some() {
        state.last_probe = state.probe;
    }
    section(ui, t.probe, "probe", true, |ui| {
        let rows = match state.last_probe {
            Some(Probe::Point(point)) => point_rows(t, state, point),
            Some(Probe::Window(point)) => window_rows(t, state, point),
            None => {
                ui.label(RichText::new(t.probe_empty).weak());
                return;
            }
        };
        if state.probe.is_none() {
            ui.visuals_mut().override_text_color = Some(ui.visuals().weak_text_color());
        }
        ui.spacing_mut().interact_size.y = TEXT_LINE;
        ui.spacing_mut().item_spacing.y = 0.0;
        for index in 0..8 {
            let (name, values, hint) = rows.get(index).cloned().unwrap_or(("", Vec::new(), ""));
            row(
                ui,
                name,
                hint,
                &values.iter().map(|v| v.text(t, state.settings.digits)).collect::<Vec<_>>().join("  "),
            );
        }
    });
}

fn row(ui: &mut egui::Ui, name: &str, hint: &str, text: &str) {
    ui.horizontal(|ui| {
        let (rect, response) = ui.allocate_exact_size(egui::vec2(60.0, TEXT_LINE), egui::Sense::hover());
        let label = egui::Label::new(RichText::new(name).small()).halign(egui::Align::LEFT);
        let label = ui.place(rect, label);
        if !hint.is_empty() {
            response.union(label).on_hover_text(hint);
        }
        ui.add(egui::Label::new(RichText::new(text).monospace()).truncate());
    });
}

#[derive(Clone, Copy)]
enum Value {
    Number(f64),
    Yes(bool),
    None,
}

impl Value {
    fn text(self, t: &Texts, digits: usize) -> String {
        match self {
            Self::Number(v) => numbers::significant(v, digits),
            Self::Yes(true) => t.yes.to_owned(),
            Self::Yes(false) => t.no.to_owned(),
            Self::None => "–".to_owned(),
        }
    }
}

type Row = (&'static str, Vec<Value>, &'static str);

fn all<const N: usize>(values: [f64; N]) -> Vec<Value> {
    values.into_iter().map(|v| Value::Number(v + 0.0)).collect()
}

fn point_rows(t: &'static Texts, state: &State, point: glam::DVec3) -> Vec<Row> {
    let figure = state.document.figure();
    let viewport = figure.viewport.unwrap_or_else(|| Viewport::whole(figure.image));
    let s = state.document.camera().stations(point, figure.image, &viewport);
    let after = |f: fn(&crate::camera::Projected) -> Vec<Value>| s.projected.as_ref().map_or(vec![Value::None], f);
    vec![
        (t.space_world, all(s.world.to_array()), t.space_world_hint),
        (t.space_view, all(s.view.to_array()), t.space_view_hint),
        (t.space_clip, all(s.clip.to_array()), t.space_clip_hint),
        (t.space_ndc, after(|p| all(p.ndc.to_array())), t.space_ndc_hint),
        (t.space_window, after(|p| all(p.window.to_array())), t.space_window_hint),
        (t.space_pixel, after(|p| all(p.pixel.to_array())), t.space_pixel_hint),
        (t.space_viewport, after(|p| all(p.viewport.to_array())), t.space_viewport_hint),
        (t.inside, vec![Value::Yes(s.inside)], t.inside_hint),
    ]
}

fn window_rows(t: &'static Texts, state: &State, point: DVec2) -> Vec<Row> {
    let camera = state.document.camera();
    let image = state.document.figure().image;
    let pixel = image.image_from_window(&camera.window(), point).floor();
    let ray = camera.ray_through_window(point);
    vec![
        (t.space_window, all(point.to_array()), t.space_window_hint),
        (t.space_pixel, all(pixel.to_array()), t.space_pixel_hint),
        (t.ray_origin, all(ray.origin.to_array()), t.ray_origin_hint),
        (t.ray_direction, all(ray.direction.to_array()), t.ray_direction_hint),
    ]
}
