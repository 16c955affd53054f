//! C, PF, VUP, then the projection with θ or H, A, F, B, then the view window.

use eframe::egui;

use super::lens_menu::{self, free_window, symmetric_window};
use super::{ParameterForm, row, toggle};
use crate::camera::{ParameterKey, Projection, ViewWindow};
use crate::figure::WindowSide;
use crate::gui::inspector::{erratum, section};
use crate::gui::kit::{Explained, NumberField, Step, help_topic};
use crate::inspect::quantity::{Quantity, WindowNumber};
use crate::numbers::{EXACT_DIGITS, power_of_ten};
use crate::scene::Preset;
use camera_lab_words::window::Texts;

/// C, PF and VUP.
pub(super) fn placement(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    // A drag of a hundred points moves by about the distance to PF.
    let step = power_of_ten(form.good.distance() / 10.0).unwrap_or(1.0);
    section(ui, t.camera, "placement", true, |ui| {
        form.vector(ui, ParameterKey::Position, [t.position, t.position_hint], step, |p| &mut p.position);
        form.vector(ui, ParameterKey::FocalPoint, [t.focal_point, t.focal_point_hint], step, |p| &mut p.focal_point);
        form.vector(ui, ParameterKey::ViewUp, [t.view_up, t.view_up_hint], 0.1, |p| &mut p.view_up);
        if form.preset == Preset::Exercise51 {
            erratum(ui, t, t.erratum_51);
        }
    });
}

/// The kind of projection, θ or H, A, F and B.
pub(super) fn projection(ui: &mut egui::Ui, form: &mut ParameterForm, model: &camera_lab_desk::Model) {
    let t = form.t;
    section(ui, t.projection, "projection", true, |ui| {
        kind(ui, form);
        if form.parameters.window.is_none() {
            angle_or_height(ui, form);
            if form.preset == Preset::Exercise52 && form.parameters.projection == Projection::Parallel {
                erratum(ui, t, t.erratum_52);
            }
            let follows = model.settings.aspect_follows_image;
            ui.add_enabled_ui(!follows, |ui| {
                let field = NumberField::new("A", Step::Multiply(1.1)).fractions().greyed(t.aspect_greyed);
                form.number(ui, ParameterKey::Aspect, [t.aspect, t.aspect_hint], field, |p| &mut p.aspect);
            });
        } else {
            derived(ui, form);
        }
        let [near, far] = ["F", "B"].map(|symbol| NumberField::new(symbol, Step::Multiply(1.1)));
        form.number(ui, ParameterKey::Near, [t.near, t.near_hint], near, |p| &mut p.near);
        form.number(ui, ParameterKey::Far, [t.far, t.far_hint], far, |p| &mut p.far);
    });
}

/// θ and A of a free window, at the places of their fields, so that the padlock below stays under the pointer.
fn derived(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    let window = form.good.window();
    match form.parameters.projection {
        Projection::Perspective => {
            let angle = form.good.view_angle().degrees();
            let words = (t.view_angle, t.view_angle_hint);
            form.derived_beside(ui, ParameterKey::ViewAngle, words, (angle, "°"), lens_menu::button);
        }
        Projection::Parallel => form.derived(ui, ParameterKey::Height, (t.height, t.height_hint), window.height()),
    }
    form.derived(ui, ParameterKey::Aspect, (t.aspect, t.aspect_hint), window.aspect());
}

fn kind(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    let mut chosen = form.parameters.projection;
    ui.columns(2, |columns| {
        for (column, projection, text, hint, note) in [
            (0, Projection::Perspective, t.perspective, t.perspective_hint, "perspective"),
            (1, Projection::Parallel, t.parallel, t.parallel_hint, "parallel"),
        ] {
            columns[column].vertical_centered_justified(|ui| {
                let button = toggle(ui, chosen == projection, text).explained(hint);
                help_topic(&button, note);
                if button.clicked() {
                    chosen = projection;
                }
            });
        }
    });
    if chosen == form.parameters.projection {
        return;
    }
    match form.good.with_projection(chosen) {
        Ok(camera) if form.error.is_none() => form.replaced = Some(camera),
        _ => form.parameters.projection = chosen,
    }
}

fn angle_or_height(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    match form.parameters.projection {
        Projection::Perspective => {
            let (words, field) = ([t.view_angle, t.view_angle_hint], NumberField::angle("θ", 5.0));
            form.number(ui, ParameterKey::ViewAngle, words, field, |p| &mut p.view_angle);
        }
        Projection::Parallel => {
            let (words, field) = ([t.height, t.height_hint], NumberField::new("H", Step::Multiply(1.1)));
            form.number(ui, ParameterKey::Height, words, field, |p| &mut p.height);
        }
    }
}

/// The window: symmetric, from θ or H and A, or free.
pub(super) fn window(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    section(ui, t.window, "window", true, |ui| {
        let mut symmetric = form.parameters.window.is_none();
        if padlock(ui, t, &mut symmetric) {
            form.parameters =
                if symmetric { symmetric_window(&form.parameters) } else { free_window(&form.parameters, &form.good) };
        }
        if form.parameters.window.is_some() {
            sides(ui, form);
        }
        let window = form.good.window();
        let sizes = |digits| {
            let [width, height] = [window.width(), window.height()].map(|side| t.lang.mark().number(side, digits));
            format!("{width} × {height}")
        };
        let quantities = [WindowNumber::Width, WindowNumber::Height].map(Quantity::Window);
        if form.is_hidden(ui, ["W × H", ""], (&quantities, &[window.width(), window.height()])) {
            return;
        }
        let size = ui.scope(|ui| {
            row(ui, "W × H", "", t.window_size_hint, |ui| {
                ui.label(sizes(5)).explained(sizes(EXACT_DIGITS));
            });
        });
        form.point_at(ui, ParameterKey::Aspect, size.response.rect);
    });
}

/// A padlock that is closed while the window is symmetric.
fn padlock(ui: &mut egui::Ui, t: &Texts, closed: &mut bool) -> bool {
    ui.horizontal(|ui| {
        let response = ui.checkbox(closed, t.symmetric).explained(t.symmetric_hint);
        let height = ui.spacing().interact_size.y;
        let (rect, _) = ui.allocate_exact_size(egui::vec2(14.0, height), egui::Sense::hover());
        paint_padlock(ui, rect, *closed);
        response.changed()
    })
    .inner
}

fn paint_padlock(ui: &egui::Ui, rect: egui::Rect, closed: bool) {
    let color = ui.visuals().weak_text_color();
    let body = egui::Rect::from_center_size(rect.center() + egui::vec2(0.0, 2.5), egui::vec2(10.0, 7.0));
    ui.painter().rect_filled(body, 1.0, color);
    // The shackle: down on both sides, or swung out of the body.
    let lift = if closed { 0.0 } else { 2.0 };
    let (left, right, top) = (body.center().x - 3.0, body.center().x + 3.0, body.top() - 3.0 - lift);
    let mut points = vec![egui::pos2(left, body.top() + if closed { 0.0 } else { -lift })];
    points.extend((0..=8).map(|i| {
        let angle = std::f32::consts::PI * (1.0 + i as f32 / 8.0);
        egui::pos2(body.center().x, top) + 3.0 * egui::Vec2::angled(angle)
    }));
    points.push(egui::pos2(right, body.top()));
    ui.painter().line(points, egui::Stroke::new(1.5, color));
}

fn sides(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = form.t;
    let Some(ViewWindow { mut left, mut right, mut bottom, mut top }) = form.parameters.window else { return };
    if form.is_hidden(ui, ["l r b t", ""], (&[Quantity::Window(WindowNumber::Left)], &[left, right, bottom, top])) {
        return;
    }
    let step = power_of_ten((right - left).abs().max((top - bottom).abs()) / 10.0).unwrap_or(1.0);
    let marked = form.is_marked(ParameterKey::Window);
    let mut outputs = Vec::new();
    for pair in [
        [("l", WindowSide::Left, t.left, &mut left), ("r", WindowSide::Right, t.right, &mut right)],
        [("b", WindowSide::Bottom, t.bottom, &mut bottom), ("t", WindowSide::Top, t.top, &mut top)],
    ] {
        let width = ((ui.available_width() - 4.0) / 2.0).floor();
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for (symbol, side, name, value) in pair {
                let field = NumberField::new(format!("{symbol}, {name}"), Step::Add(step)).prefix(symbol);
                let field = field.hint(t.side_hint).width(width).marked(marked);
                let output = ui.scope(|ui| field.show(ui, t, value));
                form.point_at_side(ui, side, output.response.rect);
                outputs.push(output.inner);
            }
        });
    }
    form.parameters.window = Some(ViewWindow { left, right, bottom, top });
    form.complain(ui, ParameterKey::Window, &outputs);
}
