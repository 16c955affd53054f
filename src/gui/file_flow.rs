//! Opening, saving and closing: what is asked, in which order, and what is done then.
//!
//! ```text
//! New, Open, a dropped file, Quit ── unsaved? ── ask ──┐
//! Save, Save as, Export ── which file? ── there already? ── ask ── do it ── then what was wanted
//! ```

use std::path::{Path, PathBuf};

use eframe::egui::{self, ViewportCommand};

use super::document::Document;
use super::export;
use super::native::{FileAnswer, FileQuestion, OpenFileDialog};
use super::state::{AfterSave, Dialog, MESH_ENDINGS, MeshFor, Purpose, State, Tab};
use crate::figure::Figure;
use crate::figure::update;
use crate::files::{self, Opened, Overwrite};
use crate::i18n::window::{self, Texts};
use crate::i18n::{messages, scenes};
use crate::scene::Shape;

/// Does what comes `next`, after asking about changes that would be lost.
pub fn begin(ctx: &egui::Context, state: &mut State, next: AfterSave) {
    state.document.commit();
    if state.document.is_changed() {
        state.file_flow.dialog = Some(Dialog::Unsaved(next));
    } else {
        go_on(ctx, state, next);
    }
}

/// Does what comes `next`; what was changed is lost.
pub fn go_on(ctx: &egui::Context, state: &mut State, next: AfterSave) {
    match next {
        AfterSave::New => {
            if let Ok(document) = Document::new(super::fresh(), None) {
                state.take_over(document);
            }
        }
        AfterSave::Open => ask(ctx, state, Purpose::Open),
        AfterSave::OpenPath(path) => open(state, &path),
        AfterSave::Quit => {
            state.file_flow.may_close = true;
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
    }
}

/// Saves to the figure's own file; asks for one where there is none.
pub fn save(ctx: &egui::Context, state: &mut State, then: Option<AfterSave>) {
    match state.document.path().cloned() {
        Some(path) => write(ctx, state, &path, then),
        None => ask(ctx, state, Purpose::Save(then)),
    }
}

/// Asks for a file: with the dialog of the system, or with a field where it has none.
pub fn ask(ctx: &egui::Context, state: &mut State, purpose: Purpose) {
    let t = window::texts(state.settings.lang);
    if state.file_flow.native {
        let question = question(t, state, &purpose);
        state.file_flow.asking = Some((purpose, OpenFileDialog::start(ctx, question)));
    } else {
        let text = proposal(t, state, &purpose);
        state.file_flow.dialog = Some(Dialog::Path(purpose, text));
    }
}

fn question(t: &'static Texts, state: &State, purpose: &Purpose) -> FileQuestion {
    let folder = state.document.folder().map(Path::to_owned).filter(|folder| !folder.as_os_str().is_empty());
    let name = Path::new(&proposal(t, state, purpose)).file_name().unwrap_or_default().to_string_lossy().into_owned();
    match purpose {
        Purpose::Open => FileQuestion {
            save: false,
            title: t.open_title,
            filter: t.figure_filter,
            endings: &["toml", "png"],
            name: String::new(),
            folder,
        },
        Purpose::Save(_) => {
            FileQuestion { save: true, title: t.save_title, filter: t.figure_filter, endings: &["toml"], name, folder }
        }
        Purpose::Export(_) => FileQuestion {
            save: true,
            title: t.export_title,
            filter: t.picture_filter,
            endings: &["png"],
            name,
            folder,
        },
        Purpose::Mesh(_) => {
            let t = scenes::texts(state.settings.lang);
            let name = String::new();
            FileQuestion {
                save: false,
                title: t.mesh_title,
                filter: t.mesh_filter,
                endings: MESH_ENDINGS,
                name,
                folder,
            }
        }
    }
}

/// The path that stands in the field at first.
fn proposal(t: &Texts, state: &State, purpose: &Purpose) -> String {
    let folder = state.document.folder().map(Path::to_owned).unwrap_or_default();
    let stem = state.document.name().map_or_else(|| PathBuf::from(t.untitled_file), PathBuf::from);
    match purpose {
        Purpose::Open | Purpose::Mesh(_) => folder.display().to_string(),
        Purpose::Save(_) => folder.join(stem).with_extension("toml").display().to_string(),
        Purpose::Export(export) => {
            let stem = stem.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            folder.join(format!("{stem}-{}.png", export.what.name())).display().to_string()
        }
    }
}

/// Goes on with the file that was chosen; asks before a file is replaced.
pub fn chosen(ctx: &egui::Context, state: &mut State, purpose: Purpose, path: PathBuf) {
    let path = match &purpose {
        Purpose::Open | Purpose::Mesh(_) => path,
        Purpose::Save(_) => with_ending(path, "toml"),
        Purpose::Export(_) => with_ending(path, "png"),
    };
    let own = state.document.path() == Some(&path);
    let reads = matches!(purpose, Purpose::Open | Purpose::Mesh(_));
    if !reads && !own && path.exists() {
        state.file_flow.dialog = Some(Dialog::Overwrite(purpose, path));
    } else {
        confirmed(ctx, state, purpose, &path);
    }
}

/// Appends the ending unless the name has it.
fn with_ending(path: PathBuf, ending: &str) -> PathBuf {
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending)) {
        return path;
    }
    let mut name = path.into_os_string();
    name.push(".");
    name.push(ending);
    name.into()
}

/// Opens or writes the file.
pub fn confirmed(ctx: &egui::Context, state: &mut State, purpose: Purpose, path: &Path) {
    match purpose {
        Purpose::Open => open(state, path),
        Purpose::Save(then) => write(ctx, state, path, then),
        Purpose::Mesh(which) => mesh(state, which, path),
        Purpose::Export(export) => {
            let exporting = export::start(ctx, &state.document, state.settings.lang, export, path.to_owned());
            state.file_flow.exporting.push(exporting);
            state.say(window::texts(state.settings.lang).exporting);
        }
    }
}

/// Puts a mesh file into the scene.
fn mesh(state: &mut State, which: MeshFor, path: &Path) {
    let named = named_in_figure(state.document.folder(), path);
    match which {
        MeshFor::New => state.insert_mesh(named),
        MeshFor::Object(name) => state.document.edit(|figure| {
            if let Some(object) = figure.scene.objects.iter_mut().find(|o| o.name == name) {
                object.shape = Some(Shape::Mesh { path: named });
            }
        }),
    }
}

/// How a figure in this folder names a file: relative to the folder where the file lies in it, with slashes; else by its
/// whole path.
fn named_in_figure(folder: Option<&Path>, path: &Path) -> String {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let folder = folder.and_then(|folder| std::path::absolute(folder).ok());
    match folder.as_deref().and_then(|folder| whole.strip_prefix(folder).ok()) {
        Some(inside) => {
            let parts: Vec<_> = inside.components().map(|part| part.as_os_str().to_string_lossy()).collect();
            parts.join("/")
        }
        None => whole.to_string_lossy().into_owned(),
    }
}

/// The figure as it is written to `to`: in another folder it names its meshes anew, so that they are the same files.
fn for_folder(document: &Document, to: &Path) -> Figure {
    let mut figure = document.figure().clone();
    let (from, to) = (document.folder(), to.parent());
    if from == to {
        return figure;
    }
    for object in &mut figure.scene.objects {
        if let Some(Shape::Mesh { path }) = &mut object.shape {
            let file = from.unwrap_or(Path::new("")).join(&path);
            // A foreign figure must not make the system look for another machine.
            if !files::is_network(&file) && file.exists() {
                *path = named_in_figure(to, &file);
            }
        }
    }
    figure
}

fn open(state: &mut State, path: &Path) {
    let name = path.display().to_string();
    let lang = state.settings.lang;
    match files::open_figure(path) {
        Ok(Opened { figure, text, .. }) => match Document::new(figure, Some((path.to_owned(), text))) {
            Ok(document) => {
                state.take_over(document);
                state.say(format!("{} {name}", window::texts(lang).opened));
            }
            Err(error) => state.say_error(format!("{name}: {}", messages::camera(lang, &error))),
        },
        Err(error) => state.say_error(messages::file(lang, &name, &error)),
    }
}

fn write(ctx: &egui::Context, state: &mut State, path: &Path, then: Option<AfterSave>) {
    let figure = for_folder(&state.document, path);
    let text = update(state.document.source(), &figure);
    let name = path.display().to_string();
    match files::save(path, text.as_bytes(), Overwrite::Writable) {
        Ok(()) => {
            if figure.scene != state.document.figure().scene {
                state.document.edit(|own| own.scene = figure.scene);
            }
            state.document.mark_saved(path.to_owned(), text);
            state.say(format!("{} {name}", window::texts(state.settings.lang).saved));
            if let Some(then) = then {
                go_on(ctx, state, then);
            }
        }
        Err(error) => state.say_error(messages::file(state.settings.lang, &name, &error)),
    }
}

/// What happens by itself in each frame: answers of dialogs and of exports, dropped files, the window's own close button.
pub fn poll(ctx: &egui::Context, state: &mut State) {
    if let Some((purpose, answer)) = state.file_flow.asking.as_mut().and_then(|(p, a)| Some((p.clone(), a.poll()?))) {
        state.file_flow.asking = None;
        match answer {
            FileAnswer::Chosen(path) => chosen(ctx, state, purpose, path),
            FileAnswer::Cancelled => {}
            FileAnswer::Unavailable => {
                state.file_flow.native = false;
                ask(ctx, state, purpose);
            }
        }
    }
    for done in state.file_flow.exported() {
        match done.outcome {
            Some(Ok(path)) => state.say(format!("{} {}", window::texts(state.settings.lang).saved, path.display())),
            Some(Err(error)) => state.say_error(error),
            None => state.say_error(window::texts(state.settings.lang).picture_too_large),
        }
    }
    let dropped = ctx.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()));
    if let Some(path) = dropped {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        if MESH_ENDINGS.contains(&ending.as_str()) {
            mesh(state, MeshFor::New, &path);
            state.settings.tab = Tab::Scene;
        } else {
            begin(ctx, state, AfterSave::OpenPath(path));
        }
    }
    if ctx.input(|input| input.viewport().close_requested()) && !state.file_flow.may_close {
        state.document.commit();
        if state.document.is_changed() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            state.file_flow.dialog = Some(Dialog::Unsaved(AfterSave::Quit));
        } else {
            state.file_flow.may_close = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_named_relative_to_their_figure() {
        let named = |folder: Option<&str>, path: &str| named_in_figure(folder.map(Path::new), Path::new(path));
        assert_eq!(named(Some("/lecture"), "/lecture/meshes/cow.obj"), "meshes/cow.obj");
        assert_eq!(named(Some("/lecture"), "/other/cow.obj"), "/other/cow.obj");
        assert_eq!(named(None, "/other/cow.obj"), "/other/cow.obj");
    }

    #[test]
    fn endings_are_appended_once() {
        for (given, made) in [("a", "a.toml"), ("a.toml", "a.toml"), ("a.TOML", "a.TOML"), ("v1.2", "v1.2.toml")] {
            assert_eq!(with_ending(PathBuf::from(given), "toml"), PathBuf::from(made));
        }
    }
}
