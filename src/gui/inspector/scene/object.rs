//! The fields of an object: name, kind, parent, transform, colour, segments, and the data of its shape.

use eframe::egui::{self, RichText};
use glam::DVec3;

use super::{ROTATE, SCALE, SceneEdit, SceneForm, TRANSLATE, TransformPart, file_row, texture};
use crate::explain::Matrix;
use crate::gui::inspector::{VectorField, choice_row, complaint, row};
use crate::gui::kit::{Explained, FieldError, KeptLine, NumberField, Step, help_topic, help_topic_row, whole};
use crate::limits::{MAX_POINTS_IN_PANEL, MAX_SEGMENTS, MAX_TYPED_NAME, MIN_SEGMENTS};
use crate::sanitize::escaped;
use crate::scene::edit::{self, Children, descendants, placement};
use crate::scene::{ObjectPaint, ObjectSpec, SceneError, Shape, ShapeData, transform};
use crate::views::Transforming;
use camera_lab_desk::{Action, FileFor, MeshFor, Model, Selected, preset_objects};
use camera_lab_words::messages::{self, faults};
use camera_lab_words::why::notes;
use camera_lab_words::window::scenes::{self, Texts, preset_object};

/// The fields of the object at this place of the list. Returns the request of its buttons.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) -> Option<SceneEdit> {
    let t = form.t;
    let name = form.scene.objects[index].name.clone();
    let together = model.tree.names(&form.scene).len();
    if together > 1 {
        let words = format!("{together} {} {}", t.several, escaped(&name));
        ui.add(egui::Label::new(RichText::new(words).weak()).wrap());
    }
    rename(ui, model, form, &name);
    kind(ui, form, index);
    let mut asked = parent(ui, model, form, index);
    transform_fields(ui, form, index, &mut model.tree.transforming);
    if form.scene.objects[index].shape.is_some() || !descendants(&form.scene, &name).is_empty() {
        color(ui, model, form, index);
    }
    texture::ui(ui, model, form, index);
    segments(ui, form, index);
    if let ObjectSpec { shape: Some(Shape::Mesh { .. }), outline, .. } = &mut form.scene.objects[index] {
        ui.checkbox(outline, t.outline).explained(t.outline_hint);
    }
    data(ui, model, form, index);
    ui.add_space(3.0);
    ui.horizontal(|ui| {
        if ui.button(t.duplicate).explained(t.duplicate_hint).clicked() {
            duplicate(model, form);
        }
        asked = asked.take().or(delete(ui, form, &model.tree.names(&form.scene)));
    });
    matrix(ui, form, &name);
    asked
}

/// The properties of an object of the named scene, which can't be edited.
pub(super) fn of_preset(ui: &mut egui::Ui, model: &Model, form: &mut SceneForm, name: &str) {
    let t = scenes::texts(model.settings.lang);
    let preset = preset_objects(model.desk.shown.figure().scene.preset);
    let Some(object) = preset.iter().find(|o| o.name == name) else { return };
    ui.add(egui::Label::new(RichText::new(t.of_preset_hint).weak()).wrap());
    row(ui, "", t.kind, t.kind_hint, |ui| ui.label(t.shape(object.shape.as_ref())));
    row(ui, "", t.parent, t.parent_hint, |ui| {
        let parent = object.parent.as_deref().map(|name| preset_object(t.lang, name));
        ui.add(egui::Label::new(parent.unwrap_or_else(|| t.no_parent.to_owned())).truncate())
    });
    for (part, symbol, name, hint, v, unit) in [
        (TRANSLATE, "T", t.translate, t.translate_hint, object.translate, ""),
        (ROTATE, "R", t.rotate, t.rotate_hint, object.rotate, "°"),
        (SCALE, "S", t.scale, t.scale_hint, object.scale, ""),
    ] {
        let mark = model.settings.lang.mark();
        let components = v.to_array().map(|x| format!("{}{unit}", mark.number(x, 5)));
        let text = format!("({})", components.join(mark.separator()));
        let place = ui.scope(|ui| row(ui, symbol, name, hint, |ui| ui.label(text)));
        form.point_at(ui, place.response.rect, part);
    }
}

/// A name takes effect with Enter, or when its field is left. A wrong one stays with its reason until it's mended.
fn rename(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, name: &str) {
    let t = form.t;
    let id = egui::Id::unique(("object name", model.desk.shown.id(), name));
    let line = KeptLine { id, old: name, most: MAX_TYPED_NAME, width: 150.0 };
    let typed = row(ui, "", t.name, t.name_hint, |ui| {
        let (response, typed) = line.show(ui, t.lang, |wanted| {
            if wanted.is_empty() {
                return Err(t.name_empty.to_owned());
            }
            let renamed = edit::rename(&mut form.scene.clone(), name, wanted);
            renamed.map(|_| wanted.to_owned()).map_err(|error| faults::scene_error(t.lang, &error))
        });
        response.explained(t.name_hint).accessible_name(t.name);
        typed
    });
    match typed {
        Some(Err(problem)) => complaint(ui, &problem),
        Some(Ok(wanted)) => {
            // The draft of impossible numbers, if there is one, continues under the new name.
            let mut scene = model.desk.shown.figure().scene.clone();
            if edit::rename(&mut scene, name, &wanted).is_ok() && edit::rename(&mut form.scene, name, &wanted).is_ok() {
                model.desk.shown.edit(|figure| figure.scene = scene);
                model.desk.shown.show_mut().rename_object(name, &wanted);
                model.desk.shown.edit_labels(|labels| labels.rename_object(name, &wanted));
                model.tree.select(Some(Selected::Object(wanted)));
            }
        }
        None => {}
    }
}

/// Another shape with the same transform. Shapes with data of their own aren't offered.
fn kind(ui: &mut egui::Ui, form: &mut SceneForm, index: usize) {
    let t = form.t;
    let object = &mut form.scene.objects[index];
    let is_plain = |shape: &Shape| shape.data() == ShapeData::None;
    if !object.shape.as_ref().is_none_or(is_plain) {
        row(ui, "", t.kind, t.kind_hint, |ui| ui.label(t.shape(object.shape.as_ref())));
        return;
    }
    let shapes = Shape::NAMED.iter().map(|(_, shape)| shape).filter(|shape| is_plain(shape));
    let kinds = [None].into_iter().chain(shapes.cloned().map(Some));
    let kinds: Vec<_> = kinds.map(|kind| (kind.clone(), t.shape(kind.as_ref()))).collect();
    let usual = Shape::usual_segments;
    let mut chosen = object.shape.clone();
    if choice_row(ui, t.kind, t.kind_hint, &mut chosen, &kinds) {
        if object.segments == usual(object.shape.as_ref()) {
            object.segments = usual(chosen.as_ref());
        }
        object.shape = chosen;
    }
}

/// The parent: any object but itself and its descendants.
fn parent(ui: &mut egui::Ui, model: &mut Model, form: &SceneForm, index: usize) -> Option<SceneEdit> {
    let t = form.t;
    let object = &form.scene.objects[index];
    let below = descendants(&form.scene, &object.name);
    let own = form.scene.objects.iter().map(|o| &o.name);
    let preset = preset_objects(form.scene.preset);
    let mut names: Vec<&String> = own.filter(|name| **name != object.name && !below.contains(*name)).collect();
    names.extend(preset.iter().map(|o| &o.name).filter(|name| form.scene.objects.iter().all(|o| o.name != **name)));
    let is_own = |name: &str| form.scene.objects.iter().any(|o| o.name == name);
    let called = |name: &str| if is_own(name) { escaped(name) } else { preset_object(t.lang, name) };
    let mut chosen = object.parent.clone();
    let place = ui.scope(|ui| {
        row(ui, "", t.parent, t.parent_hint, |ui| {
            egui::ComboBox::from_id_salt(t.parent)
                .selected_text(chosen.as_deref().map_or_else(|| t.no_parent.to_owned(), called))
                .width(116.0)
                .truncate()
                .show_ui(ui, |ui| {
                    ui.selectable_value(&mut chosen, None, t.no_parent);
                    for name in names {
                        ui.selectable_value(&mut chosen, Some(name.clone()), called(name));
                    }
                })
                .response
                .explained(t.parent_hint)
                .accessible_name(t.parent);
        });
    });
    help_topic_row(ui, place.response.rect, notes::of_matrix(Matrix::Model));
    let mut stay = !model.tree.moves_with_parent;
    ui.checkbox(&mut stay, t.stay).explained(t.stay_hint);
    model.tree.moves_with_parent = !stay;
    (chosen != object.parent).then(|| SceneEdit::Hang { name: object.name.clone(), parent: chosen })
}

fn transform_fields(ui: &mut egui::Ui, form: &mut SceneForm, index: usize, transforming: &mut Transforming) {
    let t = form.t;
    let owner = form.scene.objects[index].name.clone();
    let step = form.step;
    gizmo(ui, form, transforming);
    let mut show = |ui: &mut egui::Ui,
                    part: TransformPart,
                    symbol,
                    name,
                    hint,
                    step,
                    angles,
                    value: fn(&mut ObjectSpec) -> &mut DVec3| {
        let marked = form.is_marked(Some(&owner), part.key);
        let field = VectorField { symbol, name, hint, field: name, owner: &owner, step, angles, marked };
        let outputs = ui.scope(|ui| field.show(ui, form.window, value(&mut form.scene.objects[index])));
        form.point_at(ui, outputs.response.rect, part);
        let outputs = outputs.inner;
        form.complain(ui, Some(&owner), part.key, &outputs);
    };
    show(ui, TRANSLATE, "T", t.translate, t.translate_hint, step, false, |o| &mut o.translate);
    show(ui, ROTATE, "R", t.rotate, t.rotate_hint, 15.0, true, |o| &mut o.rotate);
    show(ui, SCALE, "S", t.scale, t.scale_hint, 0.1, false, |o| &mut o.scale);
    form.complain(ui, Some(&owner), "parent", &[]);
}

/// The choice of the gizmo for dragging in the world.
fn gizmo(ui: &mut egui::Ui, form: &SceneForm, transforming: &mut Transforming) {
    let t = form.t;
    let kinds =
        [(Transforming::Move, t.gizmo_move), (Transforming::Turn, t.gizmo_turn), (Transforming::Scale, t.gizmo_scale)];
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        for (kind, name) in kinds {
            ui.selectable_value(transforming, kind, name).explained(t.gizmo_hint);
        }
    });
}

fn color(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) {
    let t = form.t;
    let owner = form.scene.objects[index].name.clone();
    let shown = model.scene_cache.scene().objects.iter().find_map(|o| match o.paint {
        ObjectPaint::Solid(color) if o.owner() == owner => Some(color),
        ObjectPaint::Solid(_) | ObjectPaint::Faces(_) | ObjectPaint::Vertices(_) | ObjectPaint::Texture(_) => None,
    });
    let automatic = form.scene.objects[index].color.is_none();
    let now = form.scene.objects[index].color.or(shown).unwrap_or(crate::scene::palette::BLUE);
    let mut chosen = form.scene.objects[index].color;
    let mut is_automatic = automatic;
    let id = egui::Id::unique(("object colour", model.desk.shown.id(), &owner));
    let line = KeptLine { id, old: &now.to_string(), most: MAX_TYPED_NAME, width: 66.0 };
    let typed = row(ui, "", t.color, t.color_hint, |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.checkbox(&mut is_automatic, t.color_auto).explained(t.color_auto_hint);
        let (response, typed) = line.show(ui, t.lang, str::parse);
        response.explained(t.color_hint).accessible_name(format!("{} #", t.color));
        let mut bytes = [now.r, now.g, now.b, now.a];
        let picker = ui.color_edit_button_srgba_unmultiplied(&mut bytes).accessible_name(t.color);
        if picker.changed() {
            let [r, g, b, a] = bytes;
            chosen = Some(crate::appearance::Rgba::rgba(r, g, b, a));
        }
        typed
    });
    match typed {
        Some(Ok(color)) => chosen = Some(color),
        Some(Err(_)) => complaint(ui, t.color_bad),
        None => {}
    }
    if is_automatic != automatic {
        chosen = (!is_automatic).then_some(now);
    }
    form.scene.objects[index].color = chosen;
}

fn segments(ui: &mut egui::Ui, form: &mut SceneForm, index: usize) {
    let (t, owner) = (form.t, form.scene.objects[index].name.clone());
    let object = &form.scene.objects[index];
    if !object.shape.as_ref().is_some_and(Shape::has_segments) {
        return;
    }
    let marked = form.is_marked(Some(&owner), "segments");
    let mut value = f64::from(object.segments);
    let output = row(ui, "", t.segments, t.segments_hint, |ui| {
        let allowed = f64::from(MIN_SEGMENTS)..=f64::from(MAX_SEGMENTS);
        let field = NumberField::new(t.segments, Step::Add(1.0)).of(&owner).whole().within(allowed).width(92.0);
        field.hint(t.segments_hint).marked(marked).show(ui, form.window, &mut value)
    });
    form.scene.objects[index].segments = whole(value);
    if matches!(output.error, Some(FieldError::Outside(_))) {
        complaint(ui, &faults::segments_allowed(form.lang));
    } else {
        form.complain(ui, Some(&owner), "segments", &[output]);
    }
}

/// The points of points and segments, the file of a mesh.
fn data(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) {
    let t = form.t;
    let owner = form.scene.objects[index].name.clone();
    let (window, step) = (form.window, form.step);
    match &mut form.scene.objects[index].shape {
        Some(Shape::Points(points)) => {
            point_list(ui, t, window, (&owner, step), t.shape_points, points, 1);
            if points.len() < MAX_POINTS_IN_PANEL && ui.button(t.add_point).clicked() {
                points.push(points.last().copied().unwrap_or_default());
            }
        }
        Some(Shape::Segments(segments)) => {
            let mut points: Vec<DVec3> = segments.as_flattened().to_vec();
            point_list(ui, t, window, (&owner, step), t.ends, &mut points, 2);
            *segments = points.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect();
            if segments.len() < MAX_POINTS_IN_PANEL / 2 && ui.button(t.add_segment).clicked() {
                let from = segments.last().map_or(DVec3::ZERO, |ends| ends[1]);
                segments.push([from, from + DVec3::X * step]);
            }
        }
        Some(Shape::Mesh { path }) => mesh_file(ui, model, t, &owner, path),
        // Shapes without data to edit here.
        Some(_) | None => {}
    }
    form.complain(ui, Some(&owner), "points", &[]);
    form.complain(ui, Some(&owner), "segments", &[]);
}

/// Points with a button that removes each, or each pair.
fn point_list(
    ui: &mut egui::Ui,
    t: &Texts,
    window: &camera_lab_words::window::Texts,
    (owner, step): (&str, f64),
    title: &'static str,
    points: &mut Vec<DVec3>,
    together: usize,
) {
    ui.label(title);
    if points.len() > MAX_POINTS_IN_PANEL {
        ui.add(egui::Label::new(RichText::new(t.too_many).weak()).wrap());
        return;
    }
    let mut removed = None;
    for (i, point) in points.iter_mut().enumerate() {
        let owner = format!("{owner} {i}");
        ui.horizontal(|ui| {
            let field = VectorField {
                symbol: "",
                name: title,
                hint: "",
                field: t.point_number,
                owner: &owner,
                step,
                angles: false,
                marked: false,
            };
            field.fields(ui, window, point, 26.0);
            if i % together == 0 {
                let button = ui.small_button("✕").explained(t.remove_point);
                if button.accessible_name(format!("{} {}", t.remove_point, i / together + 1)).clicked() {
                    removed = Some(i);
                }
            }
        });
    }
    if let Some(i) = removed.filter(|_| points.len() > together) {
        points.drain(i..i + together);
    }
}

fn mesh_file(ui: &mut egui::Ui, model: &mut Model, t: &Texts, owner: &str, path: &mut String) {
    let browse = Action::File(FileFor::Mesh(MeshFor::Object(owner.to_owned())));
    file_row(ui, model, (owner, "path"), [t.path, &scenes::path_hint(t.lang)], path, browse);
    let problem = model.scene_cache.problem_of(owner);
    let unread = model.scene_cache.unread_of(owner);
    let mut is_outside = matches!(&problem, Some(SceneError::Mesh { error, .. }) if error.is_outside());
    for error in unread {
        complaint(ui, &messages::without_file(model.settings.lang, error));
        is_outside |= error.is_outside();
    }
    let is_lacking = problem.is_some() || !unread.is_empty();
    if let Some(error) = problem {
        complaint(ui, &faults::scene_error(model.settings.lang, &error));
    }
    let [outside, lacking] = texture::notices(ui, model, owner);
    texture::mend(ui, model, [is_outside || outside, is_lacking || lacking]);
}

/// Duplicates the selection. The copies are selected then.
fn duplicate(model: &mut Model, form: &mut SceneForm) {
    let names = model.tree.names(&form.scene);
    let mut copies = transform::duplicate(&mut form.scene, &names);
    let first = copies.pop_first();
    model.tree.select_all(first.map(Selected::Object), copies);
}

/// The delete button, or a menu if the selection has children.
fn delete(ui: &mut egui::Ui, form: &SceneForm, names: &std::collections::BTreeSet<String>) -> Option<SceneEdit> {
    let t = form.t;
    let below = transform::below(&form.scene, names);
    let remove = |children| Some(SceneEdit::Remove { names: names.clone(), children });
    if below == 0 {
        let button = ui.button(t.delete).explained(t.delete_hint);
        return button.clicked().then(|| remove(Children::Removed)).flatten();
    }
    let mut asked = None;
    let button = ui.menu_button(format!("{} ▾", t.delete), |ui| {
        if ui.button(format!("{} (+ {below})", t.delete_all)).clicked() {
            asked = remove(Children::Removed);
            ui.close();
        }
        if ui.button(t.delete_alone).clicked() {
            asked = remove(Children::HungHigher);
            ui.close();
        }
    });
    button.response.explained(t.delete_hint).accessible_name(t.delete);
    asked
}

/// The matrix that takes the object to the world.
fn matrix(ui: &mut egui::Ui, form: &SceneForm, name: &str) {
    let t = form.t;
    let Ok(Some(matrix)) = placement(&form.scene, name) else { return };
    let shown = egui::CollapsingHeader::new(t.matrix).default_open(false).show_unindented(ui, |ui| {
        egui::Grid::new("world matrix").num_columns(4).spacing([10.0, 1.0]).show(ui, |ui| {
            for row in matrix.transpose().to_cols_array_2d() {
                for value in crate::numbers::without_rests(&row, 5) {
                    ui.monospace(form.window.lang.mark().number(value, 5));
                }
                ui.end_row();
            }
        });
    });
    help_topic(&shown.header_response, notes::of_matrix(Matrix::Model));
}
