//! The tab that follows a point: its choice, its place in every space, and its whole way with the arithmetic.

use eframe::egui::{self, RichText};
use glam::{DVec2, DVec3};

use super::{ExplainedSetting, arithmetic};
use crate::camera::{NotProjectable, Place};
use crate::explain::{Component, Setting, Symbol};
use crate::figure::points::may_be_named;
use crate::gui::kit::{Explained, KeptLine, NumberField, Step, complaint, help_topic_row, toggle};
use crate::gui::why::state::explain::Explain;
use crate::limits::{MAX_NAMED_POINTS, MAX_TYPED_NAME};
use crate::views::{Probe, shadows_at, texel_at};
use camera_lab_desk::{Model, Space};
use camera_lab_words::why::explain_point::{self, Texts};
use camera_lab_words::why::notes;
use camera_lab_words::{messages, window};

/// Shows the tab.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, _explain: &mut Explain) {
    let t = explain_point::texts(model.settings.lang);
    choose(ui, model, t);
    let Some(index) = model.follow.index(&model.desk.shown.figure().points) else {
        ui.add(egui::Label::new(t.no_points).wrap());
        return;
    };
    name(ui, model, t, index);
    let position = model.desk.shown.figure().points[index].position;
    let subject = ExplainedSetting::of(model);
    let setting = subject.setting(model).with_point_seen_from_object(position);
    let moved = places(ui, model, t, &setting);
    if let Some(position) = moved {
        model.move_point(index, position);
        ui.ctx().request_repaint();
    }
    ui.separator();
    let name = model.desk.shown.figure().points[index].name.clone();
    arithmetic::ui(ui, &setting, &name, (t, model.settings.digits));
    texture(ui, model, position);
    shadows(ui, model, position);
}

/// The depths that each light with shadows compares at the point.
fn shadows(ui: &mut egui::Ui, model: &Model, position: DVec3) {
    let (lang, digits) = (model.settings.lang, model.settings.digits);
    for at in shadows_at(model.scene_cache.scene(), position) {
        let label = ui.add(egui::Label::new(explain_point::in_shadow(lang, &at, digits)).wrap());
        help_topic_row(ui, label.rect, "stage-shadow");
    }
}

/// The place of the point in a texture, if it's on a surface that has one.
fn texture(ui: &mut egui::Ui, model: &Model, position: DVec3) {
    let (lang, digits) = (model.settings.lang, model.settings.digits);
    let Some(at) = texel_at(model.scene_cache.scene(), model.desk.shown.camera(), position) else { return };
    let label = ui.add(egui::Label::new(explain_point::on_texture(lang, &at, digits)).wrap());
    help_topic_row(ui, label.rect, "stage-texture");
}

/// The points, one of them chosen, and the buttons that add and delete them.
fn choose(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let points = model.desk.shown.figure().points.clone();
    let chosen = model.follow.index(&points);
    ui.horizontal_wrapped(|ui| {
        for (i, point) in points.iter().enumerate() {
            if toggle(ui, chosen == Some(i), crate::sanitize::escaped(&point.name)).clicked() {
                model.follow.choose(&point.name);
            }
        }
        let is_room = points.len() < MAX_NAMED_POINTS;
        let add = ui.add_enabled(is_room, egui::Button::new(t.add));
        if add.explained(t.add_hint).explained_disabled(t.too_many).clicked() {
            let at = match model.frame.probe {
                Some(Probe::Point(p)) => p,
                Some(Probe::Window(_)) | None => model.desk.shown.camera().focal_point(),
            };
            // A new one at the same place, rather than the existing one.
            let taken = points.iter().any(|point| point.position == at);
            let step = DVec3::X * (0.1 * model.desk.shown.camera().distance());
            model.follow_point(if taken { at + step } else { at });
        }
        if let Some(index) = chosen
            && ui.button(t.delete).explained(t.delete_hint).clicked()
        {
            model.desk.shown.edit(|figure| drop(figure.points.remove(index)));
            model.follow = Default::default();
        }
    });
}

/// The field of the name. It takes effect with Enter, or when the user leaves it. A wrong one stays with its reason
/// until it's mended.
fn name(ui: &mut egui::Ui, model: &mut Model, t: &Texts, index: usize) {
    let points = &model.desk.shown.figure().points;
    let old = points[index].name.clone();
    let id = egui::Id::unique(("point name", model.desk.shown.id(), &old));
    let line = KeptLine { id, old: &old, most: MAX_TYPED_NAME, width: 150.0 };
    let (response, typed) = line.show(ui, model.settings.lang, |wanted| {
        let others = points.iter().filter(|point| point.name != old);
        match may_be_named(wanted, others) {
            true => Ok(wanted.to_owned()),
            false => Err(if wanted.is_empty() { t.name_empty } else { t.name_taken }),
        }
    });
    response.explained(t.name_hint).accessible_name(t.name);
    match typed {
        Some(Ok(wanted)) => {
            model.desk.shown.edit(|figure| figure.points[index].name.clone_from(&wanted));
            model.follow.choose(&wanted);
        }
        Some(Err(problem)) => complaint(ui, problem),
        None => {}
    }
}

/// The coordinates in one space: their name, and their symbols.
struct TraceRow {
    space: Space,
    name: &'static str,
    more: &'static str,
    fields: [(&'static str, Symbol); 3],
    whole: bool,
}

fn rows(t: &Texts, setting: &Setting<'_>) -> Vec<TraceRow> {
    use Component::{X, Y, Z};
    let row = |space, name, more, fields| TraceRow { space, name, more, fields, whole: space == Space::Pixel };
    let three = |names: [&'static str; 3], symbol: fn(Component) -> Symbol| {
        [(names[0], symbol(X)), (names[1], symbol(Y)), (names[2], symbol(Z))]
    };
    let mut rows = vec![
        row(Space::World, t.world, "", three(["x", "y", "z"], Symbol::World)),
        row(Space::View, t.view, "", three(["x_c", "y_c", "z_c"], Symbol::View)),
        row(Space::Ndc, t.ndc, "", three(["x_n", "y_n", "z_n"], Symbol::Ndc)),
        row(
            Space::Window,
            t.window,
            t.window_and_depth,
            [("x_p", Symbol::Window(X)), ("y_p", Symbol::Window(Y)), ("−z_c", Symbol::View(Z))],
        ),
        row(
            Space::Pixel,
            t.pixel,
            t.pixel_and_depth,
            [("i", Symbol::Pixel(X)), ("j", Symbol::Pixel(Y)), ("Z", Symbol::Viewport(Z))],
        ),
    ];
    if setting.local().is_some() {
        let fields = three(["x_o", "y_o", "z_o"], Symbol::Local);
        rows.insert(0, row(Space::Local, t.local, t.local_of, fields));
    }
    rows
}

/// The point in each of its spaces, as fields. Returns the new place if the user typed one.
fn places(ui: &mut egui::Ui, model: &mut Model, t: &Texts, setting: &Setting<'_>) -> Option<DVec3> {
    let words = window::texts(model.settings.lang);
    let step = crate::numbers::power_of_ten(model.desk.shown.camera().distance() / 10.0).unwrap_or(1.0);
    let mut moved = None;
    for row in rows(t, setting) {
        let caption = if row.more.is_empty() { row.name.to_owned() } else { format!("{} {}", row.name, row.more) };
        ui.label(RichText::new(caption).small().weak());
        let before = values(&row, setting);
        if before.iter().any(|x| !x.is_finite()) {
            ui.label(t.no_image);
            continue;
        }
        let mut after = before;
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let width = ((ui.available_width() - 8.0) / 3.0).floor();
            for (k, ((symbol, of), value)) in row.fields.iter().zip(&mut after).enumerate() {
                let small = matches!(row.space, Space::Ndc) || (row.space == Space::Pixel && k == 2);
                let whole = row.whole && k < 2;
                let step = if small {
                    0.01
                } else if whole {
                    1.0
                } else {
                    step
                };
                let field = NumberField::new(format!("{} {symbol}", row.name), Step::Add(step));
                let field = if whole { field.whole() } else { field };
                let field = field.of("point").prefix(symbol).hint(t.typed_hint).width(width);
                let shown = ui.scope(|ui| drop(field.show(ui, words, value)));
                help_topic_row(ui, shown.response.rect, notes::of_symbol(*of));
            }
        });
        if after != before {
            match place(row.space, after, setting) {
                Ok(world) => {
                    moved = Some(world);
                    model.follow.refused = None;
                }
                Err(why) => model.follow.refused = Some((row.space, why)),
            }
        }
        if let Some((_, why)) = model.follow.refused.filter(|(space, _)| *space == row.space) {
            complaint(ui, &messages::no_way_back(model.settings.lang, why));
            if row.space == Space::Pixel && matches!(why, NotProjectable::BeyondInfinity { .. }) {
                ui.add(egui::Label::new(RichText::new(t.behind_pixel).small().weak()).wrap());
            }
        }
    }
    moved
}

/// The coordinates as in the fields: of view coordinates beside the window, the distance.
fn values(row: &TraceRow, setting: &Setting<'_>) -> [f64; 3] {
    let mut values = row.fields.map(|(_, symbol)| setting.value(symbol));
    if row.space == Space::Window {
        values[2] = 0.0 - values[2];
    }
    values
}

/// The point of the world that has these coordinates in a space.
fn place(space: Space, [x, y, z]: [f64; 3], setting: &Setting<'_>) -> Result<DVec3, NotProjectable> {
    let p = DVec3::new(x, y, z);
    let place = match space {
        Space::Local => {
            let placed = setting.placement().map_or(p, |placement| placement.world_from_object.transform_point3(p));
            Place::World(placed)
        }
        Space::World => Place::World(p),
        Space::View => Place::View(p),
        Space::Ndc => Place::Ndc(p),
        Space::Window => Place::Window(DVec2::new(x, y), z),
        #[expect(
            clippy::cast_possible_truncation,
            reason = "whole numbers; beyond i64 they saturate, and are refused as too large"
        )]
        Space::Pixel => Place::Pixel([x as i64, y as i64], z),
    };
    setting.space().world_of(setting.image(), &setting.viewport(), place)
}
