//! Opens files: figures, lessons, and the parts of a scene.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::figure::Photograph;
use crate::gui::app::file_flow::begin;
use crate::gui::app::file_flow::questions::Dialog;
use crate::gui::app::file_flow::reading::Take;
use crate::gui::app::state::State;
use crate::gui::inspector::state::compare::{self, CompareForm};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::Chosen;
use crate::lessons::{Lesson, OpenLesson};
use crate::scene::import::MESH_ENDINGS;
use crate::scene::{Shape, TextureSource};
use camera_lab_desk::{Document, Intent, MeshFor, Message, Model, Recent, Source};
use camera_lab_files::{self as files, FileError, Opened, share};

/// Puts a mesh file into the scene.
pub(in crate::gui) fn mesh(model: &mut Model, which: MeshFor, path: &Path) {
    let carried = model.desk.shown.carry_mesh(path);
    let named = carried.unwrap_or_else(|| files::named_in_figure(model.desk.shown.folder(), path));
    match which {
        MeshFor::New => model.insert_mesh(named),
        MeshFor::Object(name) => model.desk.shown.edit(|figure| {
            if let Some(object) = figure.scene.objects.iter_mut().find(|o| o.name == name) {
                object.shape = Some(Shape::Mesh { path: named });
            }
        }),
    }
}

/// Puts a picture on an object.
pub(in crate::gui) fn texture(model: &mut Model, object: &str, path: &Path) {
    let named = files::named_in_figure(model.desk.shown.folder(), path);
    model.desk.shown.edit(|figure| {
        if let Some(object) = figure.scene.objects.iter_mut().find(|o| o.name == object) {
            object.texture = Some(TextureSource::of(&named));
        }
    });
}

/// Puts a photograph under the image. If it replaces another, the opacity stays.
pub(in crate::gui) fn photograph(model: &mut Model, path: &Path) {
    let file = files::named_in_figure(model.desk.shown.folder(), path);
    model.desk.shown.edit(|figure| {
        let opacity = figure.photograph.as_ref().map_or(Photograph::USUAL_OPACITY, |before| before.opacity);
        figure.photograph = Some(Photograph { file, opacity });
    });
}

/// Shows the content of a file.
type Show = Box<dyn FnOnce(&mut State, PathBuf) + Send>;

/// Reads a figure, a lesson, or a link. Returns how to go on with it.
pub(super) fn read(path: PathBuf) -> Take {
    let show: Show = if files::is_lesson(&path) {
        let read = files::read_lesson(&path).map(|(lesson, _)| Arc::new(lesson));
        Box::new(|State { model, learn, recent, .. }, path| lesson(model, learn, recent, path, read))
    } else if files::has_ending(&path, MESH_ENDINGS) {
        let document = Document::of_mesh(&path);
        Box::new(|State { model, learn, recent, .. }, path| match document {
            Ok(document) => {
                learn.take_over(model, document);
                recent.add(&files::whole(&path));
                model.say(Message::Opened(path));
            }
            Err(message) => model.say(*message),
        })
    } else {
        let opened = files::open_figure_with_any_camera(&path).map(|(opened, _)| opened);
        Box::new(|State { model, learn, recent, .. }, path| figure(model, learn, recent, path, opened))
    };
    Box::new(move |ctx, state, is_changed| {
        if is_changed && state.model.is_unsaved() {
            // The user changed the figure after the question about changes.
            begin(ctx, state, Intent::OpenPath(path));
        } else {
            show(state, path);
        }
    })
}

/// Reads the figure to compare with. The comparison is shown then.
pub(super) fn read_compared(path: PathBuf) -> Take {
    let opened = files::open_figure_with_any_camera(&path).map(|(opened, _)| opened);
    Box::new(move |_, State { model, file_flow, .. }, _| {
        if compare::with_file(model, &path, opened) {
            file_flow.show(Dialog::Compare(CompareForm::of(model.desk.shown.figure())));
        }
    })
}

/// Plays the lesson of a file or link.
fn lesson(
    model: &mut Model,
    learn: &mut Learn,
    recent: &mut Recent,
    path: PathBuf,
    lesson: Result<Arc<Lesson>, FileError>,
) {
    match lesson {
        Ok(lesson) => {
            let is_link = share::link_of(&path).is_some();
            let path = if is_link { path } else { files::whole(&path) };
            if !is_link {
                recent.add(&path);
            }
            learn.play(model, OpenLesson { lesson, path: Some(path), step: 0 });
        }
        Err(error) => model.say(Message::File(path, error)),
    }
}

/// Shows the figure of a file or link.
fn figure(model: &mut Model, learn: &mut Learn, recent: &mut Recent, path: PathBuf, opened: Result<Opened, FileError>) {
    let document = match opened {
        Ok(opened) => {
            let (figure, file) = opened.at(&path);
            Document::with_any_camera(figure, Some(file)).map_err(|error| Message::NotOpened(path.clone(), error))
        }
        Err(error) => Err(Message::File(path.clone(), error)),
    };
    let document = match document {
        Ok(document) => document,
        Err(message) => return model.say(message),
    };
    let problem = document.problem().cloned();
    learn.take_over(model, document);
    if let Some(error) = problem {
        model.say(Message::Impossible(path, error));
    } else if share::link_of(&path).is_some() {
        model.say(Message::LinkOpened);
    } else {
        recent.add(&files::whole(&path));
        model.say(Message::Opened(path));
    }
}

/// Goes on with a built-in figure.
pub(in crate::gui) fn open_shipped(model: &mut Model, learn: &mut Learn, name: &'static str) {
    let kept = model.desk.take_left(Some(&Source::Shipped(name)));
    if let Some(document) = kept.or_else(|| Document::shipped(name)) {
        learn.take_over(model, document);
    }
    // The figure of an exercise of the notes opens the exercise, not the list.
    if let Some(number) = name.strip_prefix("exercise-") {
        learn.exercises.work_on(Chosen { id: format!("0-{number}"), seed: 0 });
    }
}
