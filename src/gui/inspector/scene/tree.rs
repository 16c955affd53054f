//! The tree of objects and the list of lights: rows that are selected, folded, dragged onto each other and deleted.

use std::collections::{BTreeMap, BTreeSet};

use eframe::egui::accesskit::Role;
use eframe::egui::{
    self, Align2, Color32, EventFilter, Id, Key, Rect, Response, RichText, Sense, Stroke, StrokeKind, TextStyle,
    WidgetInfo, WidgetText, pos2, vec2,
};

use super::SceneEdit;
use crate::appearance::Rgba;
use crate::camera::Framing;
use crate::gui::kit::{Explained, keep_in_sight};
use crate::sanitize::escaped;
use crate::scene::edit::descendants;
use crate::scene::{LightKind, ObjectPaint, ObjectSpec, Preset, Scene, SceneSpec};
use camera_lab_desk::{Model, Selected, preset_objects};
use camera_lab_words::window;
use camera_lab_words::window::scenes::{Texts, preset_object};

/// Width of a step of the tree, in points.
const INDENT: f32 = 13.0;

/// A line of the tree.
#[derive(Default)]
struct TreeRow {
    /// `None` means the world, on which everything hangs.
    what: Option<Selected>,
    /// Its name in the figure.
    name: String,
    /// Its displayed name.
    shown: String,
    kind: &'static str,
    depth: u16,
    /// True if its children are shown. `None` if it has none.
    open: Option<bool>,
    color: Option<Rgba>,
    hint: &'static str,
}

impl TreeRow {
    /// Belongs to the program, not to the figure.
    fn named(name: String) -> Self {
        Self { shown: name.clone(), name, ..Self::default() }
    }
}

/// Rows farther out of sight than this are left out, for keys and screen readers too. Each costs time in each frame.
const FAR: f32 = 150.0;

/// A dragged object, by name.
struct Dragged(String);

/// Shows the tree, up to `height`, and returns the edits.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, t: &'static Texts, height: f32) -> Vec<SceneEdit> {
    let mut edits = Vec::new();
    let scene = &model.desk.shown.figure().scene;
    let is_empty = scene.objects.is_empty() && scene.preset == Preset::Empty;
    let rows = rows(scene, model.scene_cache.scene(), &model.tree.folded, t);
    let selected = model.tree.selected(scene).cloned();
    let dragged = egui::DragAndDrop::payload::<Dragged>(ui.ctx());
    let frame = egui::Frame::NONE
        .fill(ui.visuals().extreme_bg_color)
        .stroke(ui.visuals().widgets.noninteractive.bg_stroke)
        .inner_margin(1.0);
    frame.show(ui, |ui| {
        egui::ScrollArea::vertical().id_salt("tree").max_height(height).auto_shrink([false, true]).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for row in &rows {
                let place = Rect::from_min_size(ui.cursor().min, vec2(ui.available_width(), row_height(ui)));
                if !place.intersects(ui.clip_rect().expand2(vec2(0.0, FAR * row_height(ui)))) {
                    ui.advance_cursor_after_rect(place);
                    continue;
                }
                let is_also = matches!(&row.what, Some(Selected::Object(name)) if model.tree.also().contains(name));
                let is_selected = row.what.is_some() && row.what == selected || is_also;
                let response = show(ui, row, is_selected);
                if let (Selected::Object(name), true) =
                    (row.what.as_ref().unwrap_or(&Selected::Light(0)), response.drag_started())
                {
                    response.dnd_set_drag_payload(Dragged(name.clone()));
                }
                let scene = &model.desk.shown.figure().scene;
                if let Some(edit) = dropped(ui, row, &response, scene, dragged.as_deref()) {
                    edits.push(edit);
                }
                clicks_and_keys(ui, model, row, &response, &mut edits);
            }
            keep_in_sight(ui);
            if is_empty {
                ui.weak(t.empty);
            }
        });
    });
    if let Some(Dragged(name)) = dragged.as_deref() {
        follow(ui, name);
    }
    edits
}

/// Clicks and keys on a row.
fn clicks_and_keys(ui: &egui::Ui, model: &mut Model, row: &TreeRow, response: &Response, edits: &mut Vec<SceneEdit>) {
    if response.clicked() {
        model.select(row.what.clone(), ui.input(|input| input.modifiers.command));
        response.request_focus();
        ui.ctx().request_repaint();
    }
    let is_object = matches!(row.what, Some(Selected::Object(_) | Selected::OfPreset(_)));
    if is_object {
        response.context_menu(|ui| {
            let t = window::texts(model.settings.lang);
            // Without hints, which would cover the entry below.
            for (framing, text) in [(Framing::Aim, t.aim), (Framing::Fit, t.fit_image)] {
                if ui.button(text).clicked() {
                    model.tree.selected = row.what.clone();
                    model.frame_objects(framing);
                    ui.close();
                }
            }
        });
    }
    let fold = |folded: &mut BTreeSet<String>, fold: bool| {
        if fold {
            folded.insert(row.name.clone());
        } else {
            folded.remove(&row.name);
        }
    };
    if let Some(open) = row.open.filter(|_| row.what.is_some()) {
        let triangle = ui.interact(triangle_place(row, response.rect), response.id.with("fold"), Sense::CLICK);
        if triangle.clicked() || response.double_clicked() {
            fold(&mut model.tree.folded, open);
            ui.ctx().request_repaint();
        }
    }
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    if row.open.is_some() && (pressed(Key::ArrowLeft) || pressed(Key::ArrowRight)) {
        fold(&mut model.tree.folded, pressed(Key::ArrowLeft));
        ui.ctx().request_repaint();
    }
    if pressed(Key::Delete) {
        match &row.what {
            Some(Selected::Object(name)) => {
                let mut names = model.tree.names(&model.desk.shown.figure().scene);
                if !names.contains(name) {
                    names = BTreeSet::from([name.clone()]);
                }
                edits.push(SceneEdit::AskRemove(names));
            }
            Some(Selected::Light(index)) => edits.push(SceneEdit::RemoveLight(*index)),
            Some(Selected::OfPreset(_)) | None => {}
        }
    }
}

/// The edit by an object held over, or dropped on, a row.
fn dropped(
    ui: &egui::Ui,
    row: &TreeRow,
    response: &Response,
    scene: &SceneSpec,
    dragged: Option<&Dragged>,
) -> Option<SceneEdit> {
    let Dragged(name) = dragged?;
    let parent = match &row.what {
        None => None,
        Some(Selected::Object(parent) | Selected::OfPreset(parent)) => Some(parent.clone()),
        Some(Selected::Light(_)) => return None,
    };
    let now = scene.objects.iter().find(|o| o.name == *name)?.parent.clone();
    let possible = parent.as_ref() != Some(name)
        && parent != now
        && parent.as_ref().is_none_or(|parent| !descendants(scene, name).contains(parent));
    if !possible || !response.contains_pointer() {
        return None;
    }
    let stroke = Stroke::new(1.5, ui.visuals().hyperlink_color);
    ui.painter().rect_stroke(response.rect, 2.0, stroke, StrokeKind::Inside);
    response.dnd_release_payload::<Dragged>().map(|_| SceneEdit::Hang { name: name.clone(), parent })
}

/// The name of the dragged object, beside the pointer.
fn follow(ui: &egui::Ui, name: &str) {
    let Some(pointer) = ui.input(|input| input.pointer.latest_pos()) else { return };
    ui.set_cursor_icon(egui::CursorIcon::Grabbing);
    let layer = egui::LayerId::new(egui::Order::Tooltip, Id::unique("dragged object"));
    let painter = ui.ctx().layer_painter(layer);
    let font = TextStyle::Body.resolve(ui.style());
    let galley = painter.layout_no_wrap(escaped(name), font, ui.visuals().text_color());
    let place = Rect::from_min_size(pointer + vec2(12.0, 4.0), galley.size());
    painter.rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, ui.visuals().selection.bg_fill);
    painter.galley(place.min, galley, ui.visuals().text_color());
}

fn row_height(ui: &egui::Ui) -> f32 {
    ui.spacing().interact_size.y - 2.0
}

/// Draws a row: triangle, colour, name, kind.
fn show(ui: &mut egui::Ui, row: &TreeRow, selected: bool) -> Response {
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), row_height(ui)));
    let sense = if matches!(row.what, Some(Selected::Object(_))) { Sense::click_and_drag() } else { Sense::CLICK };
    let response = ui.interact(rect, Id::unique(("row of the scene", format!("{:?} {}", row.what, row.kind))), sense);
    response.widget_info(|| WidgetInfo::selected(Role::TreeItem, true, selected, &row.shown));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_level(row.depth.into());
        node.set_description(row.kind);
        if let Some(open) = row.open {
            node.set_expanded(open);
        }
    });
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let visuals = ui.visuals();
    if selected {
        ui.painter().rect_filled(rect, 2.0, visuals.selection.bg_fill);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 2.0, visuals.widgets.hovered.weak_bg_fill);
    }
    if response.has_focus() {
        let ring = Stroke::new(1.5, visuals.hyperlink_color);
        ui.painter().rect_stroke(rect, 2.0, ring, StrokeKind::Inside);
    }
    if let Some(open) = row.open {
        paint_triangle(ui, triangle_place(row, rect), open);
    }
    let mut left = triangle_place(row, rect).right() + 3.0;
    if let Some(color) = row.color {
        let dot = Rect::from_center_size(pos2(left + 4.0, rect.center().y), vec2(8.0, 8.0));
        let Rgba { r, g, b, .. } = color;
        ui.painter().rect_filled(dot, 2.0, Color32::from_rgb(r, g, b));
        ui.painter().rect_stroke(dot, 2.0, visuals.widgets.noninteractive.bg_stroke, StrokeKind::Outside);
        left = dot.right() + 5.0;
    }
    let small = TextStyle::Small.resolve(ui.style());
    let weak = visuals.weak_text_color();
    let kind = ui.painter().layout_no_wrap(row.kind.to_owned(), small, weak);
    let room = rect.right() - 4.0 - kind.size().x;
    let kind_place = Align2::RIGHT_CENTER.anchor_size(pos2(rect.right() - 4.0, rect.center().y), kind.size());
    ui.painter().galley(kind_place.min, kind, weak);
    let color = match row.what {
        Some(Selected::Object(_) | Selected::Light(_)) => visuals.text_color(),
        Some(Selected::OfPreset(_)) | None => weak,
    };
    let name = WidgetText::from(RichText::new(&row.shown).color(color));
    let width = (room - 4.0 - left).max(0.0);
    let name = name.into_galley(ui, Some(egui::TextWrapMode::Truncate), width, TextStyle::Body);
    let place = Align2::LEFT_CENTER.anchor_size(pos2(left, rect.center().y), name.size());
    ui.painter().galley(place.min, name, color);
    response.explained(row.hint)
}

fn triangle_place(row: &TreeRow, rect: Rect) -> Rect {
    let left = rect.left() + 2.0 + INDENT * f32::from(row.depth);
    Rect::from_min_max(pos2(left, rect.top()), pos2(left + 12.0, rect.bottom()))
}

fn paint_triangle(ui: &egui::Ui, place: Rect, open: bool) {
    let c = place.center();
    let points = if open {
        vec![c + vec2(-4.0, -2.5), c + vec2(4.0, -2.5), c + vec2(0.0, 3.5)]
    } else {
        vec![c + vec2(-2.5, -4.0), c + vec2(3.5, 0.0), c + vec2(-2.5, 4.0)]
    };
    let color = ui.visuals().weak_text_color();
    ui.painter().add(egui::Shape::convex_polygon(points, color, Stroke::NONE));
}

/// An object, and true if it's the figure's own.
type Node<'a> = (bool, &'a ObjectSpec);

/// The displayed rows: the world, the objects of the named scene and of the figure under their parents, the lights.
fn rows(scene: &SceneSpec, built: &Scene, folded: &BTreeSet<String>, t: &'static Texts) -> Vec<TreeRow> {
    let preset = preset_objects(scene.preset);
    let colors: BTreeMap<&str, Rgba> = built
        .objects
        .iter()
        .filter_map(|o| match o.paint {
            ObjectPaint::Solid(color) => Some((o.name.as_str(), color)),
            ObjectPaint::Faces(_) | ObjectPaint::Vertices(_) | ObjectPaint::Texture(_) => None,
        })
        .collect();
    // If an object of the figure and one of the preset have the same name, children hang on the figure's.
    let own: BTreeSet<&str> = scene.objects.iter().map(|o| o.name.as_str()).collect();
    let mut children: BTreeMap<Option<(bool, &str)>, Vec<Node<'_>>> = BTreeMap::new();
    for object in &preset {
        children.entry(object.parent.as_deref().map(|p| (false, p))).or_default().push((false, object));
    }
    for object in &scene.objects {
        let parent = object.parent.as_deref().map(|p| (own.contains(p), p));
        children.entry(parent).or_default().push((true, object));
    }
    let count = preset.len() + scene.objects.len();
    let open = (count > 0).then_some(true);
    let world = TreeRow { open, hint: t.root_hint, ..TreeRow::named(t.root.to_owned()) };
    let mut rows = vec![world];
    let of = |key: Option<(bool, &str)>| children.get(&key).into_iter().flatten().rev().copied().collect::<Vec<_>>();
    let mut open: Vec<(u16, Node<'_>)> = of(None).into_iter().map(|child| (1, child)).collect();
    while let Some((depth, (is_own, object))) = open.pop() {
        // Parents in a circle hang on no object, so they are never reached.
        let below = of(Some((is_own, &object.name)));
        let is_open = !folded.contains(&object.name);
        let name = object.name.clone();
        rows.push(TreeRow {
            color: colors.get(name.as_str()).copied().filter(|_| object.shape.is_some()),
            kind: t.shape(object.shape.as_ref()),
            depth,
            open: (!below.is_empty()).then_some(is_open),
            hint: if is_own { t.row_hint } else { t.of_preset_hint },
            shown: if is_own { escaped(&name) } else { preset_object(t.lang, &name) },
            what: Some(if is_own { Selected::Object(name.clone()) } else { Selected::OfPreset(name.clone()) }),
            name,
        });
        if is_open {
            open.extend(below.into_iter().map(|child| (depth.saturating_add(1), child)));
        }
    }
    rows.extend(scene.lights.iter().enumerate().map(|(i, light)| TreeRow {
        what: Some(Selected::Light(i)),
        kind: t.light(light.kind),
        hint: t.row_hint,
        ..TreeRow::named(format!("{} {}", t.light, i + 1))
    }));
    if scene.lights.is_empty() {
        rows.push(TreeRow {
            kind: t.light(LightKind::Directional),
            hint: t.default_light_hint,
            ..TreeRow::named(t.default_light.to_owned())
        });
    }
    rows
}
