//! The image and the viewport.

use eframe::egui;

use super::{complain, photograph, row};
use crate::camera::{ImageSize, Viewport};
use crate::explain::Symbol;
use crate::gui::inspector::{more, section};
use crate::gui::kit::{Explained, NumberField, Step, has_focus, help_topic_row, whole};
use crate::limits;
use camera_lab_desk::Model;
use camera_lab_words::why::notes;
use camera_lab_words::window::{self, Texts};

const MAX_SIDE: f64 = limits::MAX_SIDE as f64;
const MAX_OFFSET: f64 = limits::MAX_OFFSET as f64;

/// Image size and, closed at first, the viewport.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    section(ui, t.image, "image", true, |ui| {
        let ImageSize { width, height } = model.desk.shown.figure().image;
        let [mut m, mut n] = [f64::from(width), f64::from(height)];
        let size = ui.scope(|ui| {
            row(ui, "m × n", t.image_size, t.image_size_hint, |ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let field = |name: &str| {
                    let field = NumberField::new(name, Step::Add(16.0)).whole().within(1.0..=MAX_SIDE);
                    field.hint(t.image_size_hint).width(62.0)
                };
                let first = field("m").show(ui, t, &mut m);
                ui.label("×");
                [first, field("n").show(ui, t, &mut n)]
            })
        });
        let mut symbols = vec![Symbol::ImageWidth, Symbol::ImageHeight];
        if model.desk.shown.figure().viewport.is_none() {
            symbols.extend([Symbol::ViewportWidth, Symbol::ViewportHeight]);
        }
        if model.settings.aspect_follows_image && model.desk.shown.draft().window.is_none() {
            symbols.push(Symbol::Aspect);
        }
        point_at(ui, &mut model.frame.hover.pointed, size.response.rect, &symbols);
        complain(ui, t.lang, &size.inner);
        let size = ImageSize { width: whole(m), height: whole(n) };
        model.desk.shown.set(|figure| &mut figure.image, size);
        let symmetric = model.desk.shown.draft().window.is_none();
        let mut follows = model.settings.aspect_follows_image && symmetric;
        let follow = ui.add_enabled(symmetric, egui::Checkbox::new(&mut follows, t.aspect_follows));
        let follow = follow.explained(t.aspect_follows_hint).explained_disabled(t.aspect_follows_not);
        if follow.changed() {
            model.settings.aspect_follows_image = follows;
        }
        if follows {
            let aspect = f64::from(size.width) / f64::from(size.height);
            let mut parameters = *model.desk.shown.draft();
            if parameters.aspect != aspect {
                parameters.aspect = aspect;
                model.desk.shown.set_parameters(parameters);
            }
        }
        photograph::ui(ui, model);
    });
    more(ui, t, t.viewport, |ui| viewport(ui, model, t));
}

/// The note on a row. While the row is under the pointer, or has the focus, the explanations mark the entries that
/// depend on it.
fn point_at(ui: &egui::Ui, pointed: &mut Vec<Symbol>, row: egui::Rect, symbols: &[Symbol]) {
    if let Some(symbol) = symbols.first() {
        help_topic_row(ui, row, notes::of_symbol(*symbol));
    }
    if ui.rect_contains_pointer(row) {
        pointed.clear();
    }
    if ui.rect_contains_pointer(row) || (has_focus(ui, row) && pointed.is_empty()) {
        pointed.extend_from_slice(symbols);
    }
}

/// A place in pixels. Its field takes only whole numbers of −[`MAX_OFFSET`] … [`MAX_OFFSET`].
#[expect(clippy::cast_possible_truncation, reason = "a whole number that fits")]
fn to_corner(value: f64) -> i32 {
    value as i32
}

fn viewport(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let figure = model.desk.shown.figure();
    let image = figure.image;
    let of_image = Viewport { x: 0, y: 0, width: image.width, height: image.height, depth_near: 0.0, depth_far: 1.0 };
    let old = figure.viewport;
    let mut is_whole = old.is_none();
    ui.checkbox(&mut is_whole, t.whole_image).explained(t.whole_image_hint);
    let mut new = old.unwrap_or(of_image);
    if !is_whole {
        let mut pair = |of: [(Symbol, &str); 2],
                        name: &str,
                        hint: &'static str,
                        range: std::ops::RangeInclusive<f64>,
                        values: [&mut f64; 2]| {
            let [first, second] = values;
            let pair = ui.scope(|ui| {
                row(ui, "", name, hint, |ui| {
                    ui.spacing_mut().item_spacing.x = 4.0;
                    let field = |symbol: &str| {
                        let pixels = *range.end() > 1.0;
                        let field = NumberField::new(symbol, Step::Add(if pixels { 16.0 } else { 0.1 }));
                        let field = field.within(range.clone()).hint(hint).width(72.0);
                        if pixels { field.whole() } else { field }
                    };
                    [field(of[0].1).show(ui, t, first), field(of[1].1).show(ui, t, second)]
                })
            });
            point_at(ui, &mut model.frame.hover.pointed, pair.response.rect, &of.map(|(symbol, _)| symbol));
            complain(ui, t.lang, &pair.inner);
        };
        let [mut x, mut y] = [f64::from(new.x), f64::from(new.y)];
        let [mut width, mut height] = [f64::from(new.width), f64::from(new.height)];
        let corner = [(Symbol::ViewportX, "X_v"), (Symbol::ViewportY, "Y_v")];
        let sides = [(Symbol::ViewportWidth, "W_v"), (Symbol::ViewportHeight, "H_v")];
        pair(corner, t.viewport_corner, t.viewport_hint, -MAX_OFFSET..=MAX_OFFSET, [&mut x, &mut y]);
        pair(sides, t.viewport_size, t.viewport_hint, 1.0..=MAX_SIDE, [&mut width, &mut height]);
        pair(
            [(Symbol::DepthNear, "n (Z)"), (Symbol::DepthFar, "f (Z)")],
            t.depth_range,
            t.depth_range_hint,
            0.0..=1.0,
            [&mut new.depth_near, &mut new.depth_far],
        );
        new = Viewport { x: to_corner(x), y: to_corner(y), width: whole(width), height: whole(height), ..new };
    }
    let new = (!is_whole).then_some(new);
    model.desk.shown.set(|figure| &mut figure.viewport, new);
}
