//! The scene: the named scene, the tree of objects, the lights, and below them the selection.

mod add;
mod light;
mod object;
mod texture;
mod tree;

use std::collections::{BTreeMap, BTreeSet};

use eframe::egui::{self, RichText};
pub(super) use texture::mend;

use super::{choice_row, row, section};
use crate::explain::{Component, Symbol};
use crate::figure::Measured;
use crate::gui::kit::{Explained, FieldOutput, KeptLine, has_focus, help_topic_row, keep_in_sight, whole};
use crate::limits::{MAX_SIDE, MAX_TYPED};
use crate::scene::edit::{self, Children};
use crate::scene::transform::{below, topmost};
use crate::scene::{Preset, SceneError, SceneSpec, check};
use camera_lab_desk::{Action, Draft, Message, Model, Selected};
use camera_lab_words::messages::faults;
use camera_lab_words::why::notes;
use camera_lab_words::window::scenes::{self, Texts};
use camera_lab_words::{Lang, window};

/// A change requested by the tree or a button.
enum SceneEdit {
    Hang {
        name: String,
        parent: Option<String>,
    },
    Remove {
        names: BTreeSet<String>,
        children: Children,
    },
    /// Asks about the children, if there are any.
    AskRemove(BTreeSet<String>),
    RemoveLight(usize),
}

/// Shows the tab.
pub(in crate::gui) fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = scenes::texts(model.settings.lang);
    named_scene(ui, model);
    ui.horizontal(|ui| {
        add::menu(ui, model, t);
        edit_a_copy(ui, model, t);
    });
    let half = (ui.available_height() * 0.42).max(120.0);
    let mut edits = tree::ui(ui, model, t, half);
    ui.add_space(2.0);
    egui::ScrollArea::vertical().id_salt("selected").auto_shrink(false).show(ui, |ui| {
        edits.extend(selected(ui, model, t));
        keep_in_sight(ui);
    });
    for edit in edits {
        perform(model, edit);
    }
}

fn named_scene(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let old = model.desk.shown.figure().scene.preset;
    let mut preset = old;
    let presets = [
        (Preset::Empty, t.scene_empty),
        (Preset::Primitives, t.scene_primitives),
        (Preset::Cube, t.scene_cube),
        (Preset::House, t.scene_house),
        (Preset::Corridor, t.scene_corridor),
        (Preset::Pyramid, t.scene_pyramid),
        (Preset::NdcCube, t.scene_ndc_cube),
        (Preset::Exercise51, t.scene_exercise_51),
        (Preset::Exercise52, t.scene_exercise_52),
        (Preset::Exercise53, t.scene_exercise_53),
    ];
    choice_row(ui, t.preset, t.preset_hint, &mut preset, &presets);
    if preset != old {
        model.desk.shown.edit(|figure| edit::choose_preset(&mut figure.scene, preset));
        // An empty scene has nothing to frame, so the viewpoint stays.
        if preset != Preset::Empty {
            show_from_its_best_side(model, preset);
        }
    }
}

/// A scene of another size would be out of sight, so each preset comes with its camera, and with an image of the same
/// aspect.
fn show_from_its_best_side(model: &mut Model, preset: Preset) {
    let mut camera = crate::figure::recommended_camera(preset);
    if model.settings.aspect_follows_image {
        let n = model.desk.shown.figure().image.height;
        let m = (f64::from(n) * camera.aspect).round();
        // An image that would be too wide stays as it is, and A follows it.
        if (1.0..=f64::from(MAX_SIDE)).contains(&m) {
            model.desk.shown.edit(|figure| figure.image.width = whole(m));
        }
        camera.aspect = f64::from(model.desk.shown.figure().image.width) / f64::from(n);
    }
    model.desk.shown.set_parameters(camera);
    *model.desk.shown.observers_mut() = Default::default();
}

/// The button that expands the named scene into a list of objects. It lists beforehand and afterwards what the list
/// can't express.
fn edit_a_copy(ui: &mut egui::Ui, model: &mut Model, t: &Texts) {
    let preset = model.desk.shown.figure().scene.preset;
    if preset == Preset::Empty {
        return;
    }
    let hint = format!("{}. {}", t.edit_copy_hint, scenes::lost(model.settings.lang, preset));
    if !ui.button(t.edit_copy).explained(hint.trim()).clicked() {
        return;
    }
    let (theme, lang) = (model.settings.theme, model.settings.lang);
    let called = |name: &str| scenes::preset_object(lang, name);
    let mut names = BTreeMap::new();
    model.desk.shown.edit(|figure| names = edit::write_out_preset(&mut figure.scene, theme, called));
    if let Some(Selected::OfPreset(name)) = model.tree.selected.clone() {
        model.tree.select(names.remove(&name).map(Selected::Object));
    }
    model.say(Message::WrittenOut(preset));
}

/// The selection, with its fields. Returns the request of its buttons.
fn selected(ui: &mut egui::Ui, model: &mut Model, t: &Texts) -> Option<SceneEdit> {
    let scene = &model.desk.shown.figure().scene;
    let mut form = SceneForm::new(model);
    let asked = match model.tree.selected(scene).cloned() {
        None => {
            ui.add(egui::Label::new(RichText::new(t.nothing_selected).weak()).wrap());
            None
        }
        Some(Selected::Object(name)) => {
            let index = form.scene.objects.iter().position(|o| o.name == name)?;
            section_of(ui, t.object, |ui| object::ui(ui, model, &mut form, index)).flatten()
        }
        Some(Selected::OfPreset(name)) => {
            section_of(ui, t.object, |ui| object::of_preset(ui, model, &mut form, &name));
            None
        }
        Some(Selected::Light(index)) => section_of(ui, t.light, |ui| light::ui(ui, model, &mut form, index)).flatten(),
    };
    form.finish(model);
    asked
}

fn section_of<R>(ui: &mut egui::Ui, title: &str, body: impl FnOnce(&mut egui::Ui) -> R) -> Option<R> {
    let mut result = None;
    section(ui, title, "selected", true, |ui| result = Some(body(ui)));
    result
}

/// The scene while its fields are shown, and its faults.
struct SceneForm {
    t: &'static Texts,
    window: &'static window::Texts,
    lang: Lang,
    scene: SceneSpec,
    error: Option<SceneError>,
    /// A unit of length that suits the scene.
    step: f64,
    /// The measure of the part of the transform under the pointer.
    measured: Vec<Measured>,
    /// The part of the transform under the pointer, or with the keyboard.
    pointed: Vec<Symbol>,
}

impl SceneForm {
    fn new(model: &Model) -> Self {
        let lang = model.settings.lang;
        let scene = &model.desk.shown.figure().scene;
        let draft = model.tree.draft.as_ref().filter(|draft| draft.base == *scene);
        Self {
            t: scenes::texts(lang),
            window: window::texts(lang),
            lang,
            scene: draft.map_or(scene, |draft| &draft.now).clone(),
            error: draft.map(|draft| draft.error.clone()),
            step: crate::numbers::power_of_ten(model.desk.shown.camera().distance() / 10.0).unwrap_or(1.0),
            measured: Vec::new(),
            pointed: Vec::new(),
        }
    }

    /// While the pointer is on a part of the transform, or its field has the focus, the world shows its measure, and
    /// the explanations mark the entries that depend on it.
    fn point_at(&mut self, ui: &egui::Ui, rect: egui::Rect, part: TransformPart) {
        let symbols = Component::THREE.map(part.symbol);
        help_topic_row(ui, rect, notes::of_symbol(symbols[0]));
        let pointed = ui.rect_contains_pointer(rect);
        if pointed || (has_focus(ui, rect) && self.pointed.is_empty()) {
            self.measured = if ui.input(|input| input.pointer.any_down()) {
                Vec::new()
            } else {
                (0..3).map(part.measure).collect()
            };
            self.pointed = symbols.to_vec();
        }
    }

    fn is_marked(&self, object: Option<&str>, key: &str) -> bool {
        self.error.as_ref().is_some_and(|error| error.object() == object && error.key() == key)
    }

    /// Shows the fault of a value below its field, either of the typed text or of the value.
    fn complain(&self, ui: &mut egui::Ui, object: Option<&str>, key: &str, fields: &[FieldOutput]) {
        super::complain(ui, self.lang, fields);
        if let Some(error) = self.error.as_ref().filter(|_| self.is_marked(object, key)) {
            super::complaint(ui, &faults::scene_error(self.lang, error));
        }
    }

    /// Takes the scene over if it's possible. Otherwise the fields keep it, and the figure keeps the last possible one.
    fn finish(self, model: &mut Model) {
        model.frame.hover.measured.extend_from_slice(&self.measured);
        model.frame.hover.pointed.extend_from_slice(&self.pointed);
        let base = &model.desk.shown.figure().scene;
        if self.scene == *base {
            model.tree.draft = None;
            return;
        }
        match check(&self.scene) {
            Ok(()) => {
                model.tree.draft = None;
                model.desk.shown.edit(|figure| figure.scene = self.scene);
            }
            Err(error) => model.tree.draft = Some(Draft { base: base.clone(), now: self.scene, error }),
        }
    }
}

/// A part of an object's transform: its key in a figure file, its symbols and its measures, by axis.
#[derive(Clone, Copy)]
struct TransformPart {
    key: &'static str,
    symbol: fn(Component) -> Symbol,
    measure: fn(usize) -> Measured,
}

const TRANSLATE: TransformPart =
    TransformPart { key: "translate", symbol: Symbol::Translate, measure: Measured::Translate };
const ROTATE: TransformPart = TransformPart { key: "rotate", symbol: Symbol::Rotate, measure: Measured::Rotate };
const SCALE: TransformPart = TransformPart { key: "scale", symbol: Symbol::Scale, measure: Measured::Scale };

/// Deletes an object, reports it, and selects its parent.
pub(in crate::gui) fn remove(model: &mut Model, names: &BTreeSet<String>, children: Children) {
    let mut scene = model.desk.shown.figure().scene.clone();
    let before = scene.objects.len();
    let tops = topmost(&scene, names);
    let Some(name) = tops.first() else { return };
    let next = scene.objects.iter().find(|o| o.name == *name).and_then(|o| o.parent.clone());
    let mut stayed = true;
    for name in names {
        match edit::remove(&mut scene, name, children) {
            Ok(all) => stayed &= all,
            Err(_) => return,
        }
    }
    let others = before - scene.objects.len();
    let selected = next.filter(|parent| scene.objects.iter().any(|o| o.name == *parent));
    model.desk.shown.edit(|figure| figure.scene = scene);
    model.tree.select(selected.map(Selected::Object));
    model.say(Message::Deleted { name: name.clone(), others: others.saturating_sub(1), shear: !stayed });
}

fn perform(model: &mut Model, edit: SceneEdit) {
    match edit {
        SceneEdit::Hang { name, parent } => {
            let mut scene = model.desk.shown.figure().scene.clone();
            let stay = !model.tree.moves_with_parent;
            // A parent that can't take the object isn't offered.
            let Ok(stayed) = edit::hang(&mut scene, &name, parent.as_deref(), stay) else { return };
            model.desk.shown.edit(|figure| figure.scene = scene);
            if !stayed {
                model.say(Message::Shear);
            }
            if let Some(parent) = parent {
                model.tree.folded.remove(&parent);
            }
        }
        SceneEdit::Remove { names, children } => remove(model, &names, children),
        SceneEdit::AskRemove(names) => {
            let below = below(&model.desk.shown.figure().scene, &names);
            if below == 0 {
                remove(model, &names, Children::Removed);
            } else {
                model.request(Action::Delete { names, below });
            }
        }
        SceneEdit::RemoveLight(index) => {
            model.desk.shown.edit(|figure| {
                if index < figure.scene.lights.len() {
                    figure.scene.lights.remove(index);
                }
            });
            model.tree.select(None);
            model.say(Message::LightDeleted(index));
        }
    }
}

/// A row for a file of an object, named as in a figure file. You type its path, or the button asks for one.
fn file_row(
    ui: &mut egui::Ui,
    model: &mut Model,
    (owner, key): (&str, &'static str),
    [name, hint]: [&str; 2],
    path: &mut String,
    browse: Action,
) {
    let t = scenes::texts(model.settings.lang);
    let id = egui::Id::unique(("file of an object", model.desk.shown.id(), owner, key));
    let line = KeptLine { id, old: path, most: MAX_TYPED, width: 110.0 };
    let typed = row(ui, "", t.path, hint, |ui| {
        let (response, typed) = line.show(ui, t.lang, |text| Ok::<_, ()>(text.to_owned()));
        response.explained(hint).accessible_name(name);
        if ui.button(t.browse).clicked() {
            model.request(browse);
        }
        typed
    });
    if let Some(Ok(text)) = typed.filter(|typed| typed.as_ref().is_ok_and(|text| !text.is_empty())) {
        *path = text;
    }
}
