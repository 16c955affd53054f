//! The texture of an object: its source, and its place on the surface.

use eframe::egui::{self, RichText};

use super::{SceneForm, file_row};
use crate::appearance::{Filter, TextureReveal, Wrap};
use crate::gui::inspector::{choice_row, row};
use crate::gui::kit::{Explained, NumberField, Step};
use crate::limits::MAX_TEXTURE_SCALE;
use crate::scene::{MeshNotice, ObjectPaint, Shape, TextureSource};
use camera_lab_desk::{Action, FileFor, Model};
use camera_lab_words::{messages, window};

/// The fields of the texture of the object at this place of the list.
pub(super) fn ui(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) {
    let object = &form.scene.objects[index];
    let Some(shape) = object.shape.as_ref().filter(|shape| has_faces(shape)) else { return };
    let (is_mesh, owner) = (shape.mesh_file().is_some(), object.name.clone());
    source(ui, form, index, is_mesh);
    if let Some(TextureSource::File(_)) = &form.scene.objects[index].texture {
        file(ui, model, form, index);
    }
    let scene = model.scene_cache.scene();
    let is_textured = |object: &crate::scene::Object| matches!(object.paint, ObjectPaint::Texture(_));
    if scene.objects.iter().any(|object| object.owner() == owner && is_textured(object)) {
        wrap_and_filter(ui, form, index, is_mesh);
        scale(ui, form, index);
        reveal(ui, model, form.t);
    }
    if !is_mesh {
        let found = notices(ui, model, &owner);
        mend(ui, model, found);
    }
}

/// True for shapes that can carry a picture.
fn has_faces(shape: &Shape) -> bool {
    !matches!(shape, Shape::Grid | Shape::Points(_) | Shape::Segments(_))
}

/// Notices about unusable files of an object. Returns if the user can allow files, and if they can be read again.
pub(super) fn notices(ui: &mut egui::Ui, model: &Model, owner: &str) -> [bool; 2] {
    let mut found = [false; 2];
    for (_, notice) in model.scene_cache.scene().notices.iter().filter(|(object, _)| object == owner) {
        let words = format!("⚠ {}", messages::mesh_notice(model.settings.lang, notice));
        ui.add(egui::Label::new(RichText::new(words).weak()).wrap());
        if let MeshNotice::Texture(error) = notice {
            found = [found[0] || error.is_outside(), true];
        }
    }
    found
}

/// The buttons with which the user mends unreadable files.
pub(in crate::gui::inspector) fn mend(ui: &mut egui::Ui, model: &mut Model, [is_outside, is_lacking]: [bool; 2]) {
    let t = window::scenes::texts(model.settings.lang);
    if is_outside && ui.button(t.allow_files).explained(t.allow_files_hint).clicked() {
        model.desk.shown.allow_files();
        model.message = None;
    }
    if is_lacking && ui.button(window::texts(t.lang).reload).explained(t.read_again_hint).clicked() {
        model.scene_cache.read_again();
        model.message = None;
    }
}

fn source(ui: &mut egui::Ui, form: &mut SceneForm, index: usize, is_mesh: bool) {
    let t = form.t;
    let mut chosen = form.scene.objects[index].texture.clone();
    let unsaid = if is_mesh { t.texture_of_file } else { t.texture_none };
    let name = |source: &Option<TextureSource>| match source {
        None => unsaid,
        Some(TextureSource::None) => t.texture_none,
        Some(TextureSource::Chequer) => t.texture_chequer,
        Some(TextureSource::Letters) => t.texture_letters,
        Some(TextureSource::Uv) => t.texture_uv,
        Some(TextureSource::File(_)) => t.texture_file,
    };
    let is_file = |source: &Option<TextureSource>| matches!(source, Some(TextureSource::File(_)));
    // Without a mesh file there is no texture that `None` could replace.
    let is_listed =
        |source: &TextureSource| is_mesh || *source != TextureSource::None || chosen.as_ref() == Some(source);
    let named = TextureSource::NAMED.into_iter().map(|(_, source)| source).filter(is_listed).map(Some);
    let file = if is_file(&chosen) { chosen.clone() } else { Some(TextureSource::File(String::new())) };
    let all = [None].into_iter().chain(named).chain([file]);
    let all: Vec<_> = all.map(|source| (source.clone(), name(&source))).collect();
    choice_row(ui, t.texture, t.texture_hint, &mut chosen, &all);
    form.scene.objects[index].texture = chosen;
}

/// The file, typed or chosen.
fn file(ui: &mut egui::Ui, model: &mut Model, form: &mut SceneForm, index: usize) {
    let t = form.t;
    let owner = form.scene.objects[index].name.clone();
    let Some(TextureSource::File(path)) = &mut form.scene.objects[index].texture else { return };
    let browse = Action::File(FileFor::Texture(owner.clone()));
    file_row(ui, model, (&owner, "texture"), [t.texture_file, t.texture_file_hint], path, browse);
}

fn wrap_and_filter(ui: &mut egui::Ui, form: &mut SceneForm, index: usize, is_mesh: bool) {
    let t = form.t;
    let object = &mut form.scene.objects[index];
    let wraps = [(Wrap::Repeat, t.wrap_repeat), (Wrap::Clamp, t.wrap_clamp), (Wrap::Mirror, t.wrap_mirror)];
    let unsaid = if is_mesh { t.texture_of_file } else { t.wrap_repeat };
    let all = or_unsaid(unsaid, wraps, object.wrap);
    choice_row(ui, t.wrap, t.wrap_hint, &mut object.wrap, &all);
    let filters = [
        (Filter::Nearest, t.filter_nearest),
        (Filter::Bilinear, t.filter_bilinear),
        (Filter::Trilinear, t.filter_trilinear),
    ];
    let unsaid = if is_mesh { t.texture_of_file } else { t.filter_trilinear };
    let all = or_unsaid(unsaid, filters, object.filter);
    choice_row(ui, t.filter, t.filter_hint, &mut object.filter, &all);
}

/// Some words to choose from, after the one that leaves it open. The same word appears there once, unless the figure
/// gives it.
fn or_unsaid<T: Copy + PartialEq>(
    unsaid: &'static str,
    all: [(T, &'static str); 3],
    now: Option<T>,
) -> Vec<(Option<T>, &'static str)> {
    let is_shown = |(one, name): &(T, &'static str)| *name != unsaid || now == Some(*one);
    let said = all.into_iter().filter(is_shown).map(|(one, name)| (Some(one), name));
    [(None, unsaid)].into_iter().chain(said).collect()
}

/// The inner work of texturing, in all pictures.
fn reveal(ui: &mut egui::Ui, model: &mut Model, t: &window::scenes::Texts) {
    let mut chosen = model.desk.shown.figure().reveal.texture;
    let all = [
        (TextureReveal::Affine, t.texture_affine),
        (TextureReveal::Levels, t.texture_levels),
        (TextureReveal::Texels, t.texture_texels),
    ];
    let all = or_unsaid(t.texture_plain, all, chosen);
    choice_row(ui, t.texture_reveal, t.texture_reveal_hint, &mut chosen, &all);
    model.desk.shown.set(|figure| &mut figure.reveal.texture, chosen);
}

/// Repetitions along u and v.
fn scale(ui: &mut egui::Ui, form: &mut SceneForm, index: usize) {
    let (t, owner) = (form.t, form.scene.objects[index].name.clone());
    let mut scale = form.scene.objects[index].texture_scale;
    row(ui, "", t.texture_scale, t.texture_scale_hint, |ui| {
        for (name, value) in [("u", &mut scale.x), ("v", &mut scale.y)] {
            let allowed = -MAX_TEXTURE_SCALE..=MAX_TEXTURE_SCALE;
            let mut typed = *value;
            let field = NumberField::new(name, Step::Add(1.0)).of(&owner).within(allowed).width(56.0);
            field.hint(t.texture_scale_hint).show(ui, form.window, &mut typed);
            // No repetition at all would leave nothing visible.
            if typed != 0.0 {
                *value = typed;
            }
        }
    });
    form.scene.objects[index].texture_scale = scale;
}
