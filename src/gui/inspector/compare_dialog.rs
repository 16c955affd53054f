//! The dialog that compares the figure with itself in another way. A choice is visible at once.

use eframe::egui::{Align2, Button, Context, Id, Key, Modifiers, Ui, Window, vec2};

use crate::camera::{Operation, Projection};
use crate::figure::{Comparison, Figure, read};
use crate::gui::inspector::complaint;
use crate::gui::inspector::state::compare::{CompareForm, compared_with, end, in_window, look, swap, take};
use crate::gui::kit::{Explained, NumberField, TextField, at_right, toggle};
use crate::limits::{MAX_EXPRESSION, MAX_TYPED_NAME};
use camera_lab_desk::{Action, FileFor, Model};
use camera_lab_words::messages;
use camera_lab_words::window::compare::Texts as Words;
use camera_lab_words::window::{Texts, compare as words};

/// Shows the dialog in a movable window of its own. The pictures beside it show the choice, and stay usable. Returns
/// the form while it stays open. While the user `draws` on the views, Esc is for that.
pub(in crate::gui) fn show(
    ctx: &Context,
    t: &Texts,
    model: &mut Model,
    form: CompareForm,
    draws: bool,
) -> Option<CompareForm> {
    let words = words::texts(model.settings.lang);
    let mut open = true;
    let corner = ctx.content_rect().left_bottom() + vec2(8.0, -8.0);
    let mut kept = Some(form);
    let window = Window::new(words.title).id(Id::unique("compare")).open(&mut open).collapsible(true).resizable(false);
    window.pivot(Align2::LEFT_BOTTOM).default_pos(corner).constrain(true).show(ctx, |ui| {
        ui.set_width(440.0_f32.min(ctx.content_rect().width() - 60.0));
        kept = kept.take().and_then(|form| content(ui, t, model, form));
    });
    let is_left = ctx.input_mut(|input| !draws && input.consume_key(Modifiers::NONE, Key::Escape));
    let stays = kept.filter(|_| open && !is_left);
    if stays.is_none() {
        end(model);
    }
    stays
}

/// The content of the window. Returns the form until it's closed.
fn content(ui: &mut Ui, t: &Texts, model: &mut Model, mut form: CompareForm) -> Option<CompareForm> {
    let words = words::texts(model.settings.lang);
    ui.label(words.text);
    ui.add_space(6.0);
    let mut chosen = others(ui, words, model);
    chosen = pairs(ui, words, model).or(chosen);
    chosen = angle(ui, t, words, model, &mut form).or(chosen);
    chosen = operation(ui, words, model, &mut form).or(chosen);
    chosen = key(ui, words, model, &mut form).or(chosen);
    ui.separator();
    chosen = options(ui, words, model).or(chosen);
    if let Some(figure) = chosen {
        take(model, figure);
        ui.request_repaint();
    }
    if let Some(why) = model.impossible_side() {
        complaint(ui, &why);
    }
    ui.add_space(8.0);
    let closes = ui.horizontal(|ui| at_right(ui, |ui| ui.button(t.close).clicked())).inner;
    (!closes).then_some(form)
}

/// Another file, and the figure as saved.
fn others(ui: &mut Ui, words: &Words, model: &mut Model) -> Option<Figure> {
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        if ui.button(words.with_file).explained(words.with_file_hint).clicked() {
            model.request(Action::File(FileFor::CompareWith));
        }
        let with_saved = ui.add_enabled(model.desk.shown.is_changed(), Button::new(words.with_saved));
        if with_saved.explained(words.with_saved_hint).explained_disabled(words.with_saved_none).clicked() {
            chosen = Some(compared_with(model, &model.desk.shown.saved().clone()));
        }
    });
    chosen
}

/// The ready pairs, and none.
fn pairs(ui: &mut Ui, words: &Words, model: &Model) -> Option<Figure> {
    let figure = model.desk.shown.figure();
    let compared = figure.compare.as_ref();
    let keys: Vec<&str> =
        compared.iter().flat_map(|comparison| &comparison.with).map(|(key, _)| key.as_str()).collect();
    let is_of = |key: &str, value: &str| {
        keys == [key] && compared.is_some_and(|comparison| comparison.values(figure).contains(&value.to_owned()))
    };
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        if toggle(ui, compared.is_none(), words.nothing).clicked() {
            chosen = Some(Figure { compare: None, ..figure.clone() });
        }
        for (name, key, pair, differences) in [
            (words.visibility_painter, "style.visibility", ["painter", "depth-buffer"], true),
            (words.visibility_bsp, "style.visibility", ["bsp", "depth-buffer"], true),
            (words.shading, "style.shading", ["flat", "phong"], false),
            (words.projection, "camera.projection", ["parallel", "perspective"], false),
            (words.convention, "show.ndc", ["opengl", "direct3d"], false),
            (words.depth, "style.depth_format", ["fixed-16", "f32-reversed"], false),
            (words.vertices, "style.vertex_format", ["f16", "f64"], true),
        ] {
            // The names stand as their sides do.
            let name = match name.split_once(" | ") {
                Some((first, second)) if Comparison::stands_left(figure, key, pair[1]) => format!("{second} | {first}"),
                _ => name.to_owned(),
            };
            if toggle(ui, is_of(key, pair[0]), &name).clicked() {
                let mut figure = in_window(model);
                if key == "camera.projection" {
                    give_other_projection(model, &mut figure);
                }
                let look = look(&figure);
                // The two boxes are side by side, so that each is visible as a whole.
                let beside = key == "show.ndc";
                chosen = Some(Comparison { beside, differences, ..look }.of_pair(&figure, key, pair));
            }
        }
    });
    chosen
}

/// Sets the height or the angle with which the other projection shows as much as this one does.
fn give_other_projection(model: &Model, figure: &mut Figure) {
    let other = match figure.camera.projection {
        Projection::Perspective => Projection::Parallel,
        Projection::Parallel => Projection::Perspective,
    };
    if let Ok(camera) = model.desk.shown.camera().with_projection(other) {
        let (height, view_angle) = (camera.parameters().height, camera.parameters().view_angle);
        (figure.camera.height, figure.camera.view_angle) = (height, view_angle);
    }
}

/// θ now and another one.
fn angle(ui: &mut Ui, t: &Texts, words: &Words, model: &Model, form: &mut CompareForm) -> Option<Figure> {
    let figure = model.desk.shown.figure();
    let has_angle = figure.camera.projection == Projection::Perspective && figure.camera.window.is_none();
    let is_of_angle = |comparison: &Comparison| comparison.with.iter().any(|(key, _)| key == "camera.view_angle");
    let on = figure.compare.as_ref().is_some_and(|comparison| is_of_angle(comparison) && !comparison.is_of_camera());
    ui.horizontal(|ui| {
        let now = t.lang.mark().number(figure.camera.view_angle, 4);
        let button = Button::selectable(on, format!("θ = {now}° | θ")).frame_when_inactive(true);
        let button = ui.add_enabled(has_angle, button).explained(words.angle_hint).explained_disabled(words.angle_none);
        let old = form.angle;
        NumberField::angle(words.angle_hint, 5.0).within(1e-6..=179.9).width(80.0).show(ui, t, &mut form.angle);
        let is_changed = old.to_bits() != form.angle.to_bits() && on;
        let comparison = || {
            let other = Comparison::of_key("camera.view_angle", &crate::numbers::exact(form.angle));
            Comparison { with: other.with, differences: false, ..look(figure) }
        };
        (has_angle && (button.clicked() || is_changed))
            .then(|| Figure { compare: Some(comparison()), ..in_window(model) })
    })
    .inner
}

/// Before and after an operation.
fn operation(ui: &mut Ui, words: &Words, model: &Model, form: &mut CompareForm) -> Option<Figure> {
    let compared = model.desk.shown.figure().compare.as_ref();
    let on = compared.is_some_and(|comparison| !comparison.ops.is_empty());
    let mut chosen = None;
    let (mut why, mut is_typed) = (None, false);
    ui.horizontal(|ui| {
        let clicked = toggle(ui, on, words.operation).explained(words.operation_hint).clicked();
        let field = TextField::line(&mut form.operation, MAX_TYPED_NAME);
        let typed = field.with(|edit| edit.desired_width(160.0)).show(ui, words.lang).explained(words.operation_hint);
        is_typed = typed.has_focus();
        let changed = typed.accessible_name(words.operation_hint).changed();
        match form.operation.parse::<Operation>() {
            Ok(operation) if clicked || changed && on => {
                let look = look(model.desk.shown.figure());
                let comparison = Comparison { ops: vec![operation], differences: false, ..look };
                chosen = Some(Figure { compare: Some(comparison), ..in_window(model) });
            }
            Ok(_) => {}
            Err(error) => why = Some(messages::operation(words.lang, &error)),
        }
    });
    if let Some(why) = why.filter(|_| on || is_typed) {
        complaint(ui, &why);
    }
    chosen
}

/// Any key and another value of it.
fn key(ui: &mut Ui, words: &Words, model: &Model, form: &mut CompareForm) -> Option<Figure> {
    let compared = model.desk.shown.figure().compare.as_ref();
    let typed = read::typed_comparison(&form.key);
    let on = matches!((&typed, compared), (Ok(typed), Some(compared)) if typed.with == compared.with);
    let mut chosen = None;
    ui.horizontal(|ui| {
        let clicked = toggle(ui, on, words.key).explained(words.key_hint).clicked();
        let field = TextField::line(&mut form.key, MAX_EXPRESSION.0);
        let field = field.with(|edit| edit.desired_width(260.0)).show(ui, words.lang).explained(words.key_hint);
        let field = field.accessible_name(words.key_hint);
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if let (Ok(typed), true) = (&typed, clicked || entered) {
            let comparison = Comparison { with: typed.with.clone(), ..look(model.desk.shown.figure()) };
            chosen = Some(Figure { compare: Some(comparison), ..in_window(model) });
        }
    });
    if let Err(error) = typed {
        complaint(ui, &messages::without_line(words.lang, &error));
    }
    chosen
}

/// The way in which it's compared.
fn options(ui: &mut Ui, words: &Words, model: &mut Model) -> Option<Figure> {
    let figure = in_window(model);
    let old = figure.compare.clone().unwrap_or_default();
    let mut new = old.clone();
    ui.add_enabled_ui(figure.compare.is_some(), |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut new.differences, words.differences).explained(words.differences_hint);
            ui.checkbox(&mut new.beside, words.beside).explained(words.beside_hint);
            let can_swap = figure.compare.as_ref().is_some_and(|comparison| comparison.swapped(&figure).is_some());
            if ui.add_enabled(can_swap, Button::new(words.swap)).explained(words.swap_hint).clicked() {
                swap(model);
            }
        });
    });
    (new != old).then_some(Figure { compare: Some(new), ..figure })
}
