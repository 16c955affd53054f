//! Files that are opened: figures, lessons, and what a scene is made of.

use std::path::Path;
use std::sync::Arc;

use crate::figure::Photograph;
use crate::files;
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::Chosen;
use crate::gui::model::Model;
use crate::gui::model::action::MeshFor;
use crate::gui::model::document::Document;
use crate::gui::model::message::Message;
use crate::gui::model::source::Source;
use crate::gui::storage::recent::Recent;
use crate::lessons::OpenLesson;
use crate::scene::{Shape, TextureSource};
use crate::share;

/// Puts a mesh file into the scene.
pub(super) fn mesh(model: &mut Model, which: MeshFor, path: &Path) {
    let named = files::named_in_figure(model.document.folder(), path);
    match which {
        MeshFor::New => model.insert_mesh(named),
        MeshFor::Object(name) => model.document.edit(|figure| {
            if let Some(object) = figure.scene.objects.iter_mut().find(|o| o.name == name) {
                object.shape = Some(Shape::Mesh { path: named });
            }
        }),
    }
}

/// Puts a picture on an object.
pub(super) fn texture(model: &mut Model, object: &str, path: &Path) {
    let named = files::named_in_figure(model.document.folder(), path);
    model.document.edit(|figure| {
        if let Some(object) = figure.scene.objects.iter_mut().find(|o| o.name == object) {
            object.texture = Some(TextureSource::of(&named));
        }
    });
}

/// Puts a photograph under the image. One in the place of another keeps the opacity.
pub(super) fn photograph(model: &mut Model, path: &Path) {
    let file = files::named_in_figure(model.document.folder(), path);
    model.document.edit(|figure| {
        let opacity = figure.photograph.as_ref().map_or(Photograph::USUAL_OPACITY, |before| before.opacity);
        figure.photograph = Some(Photograph { file, opacity });
    });
}

/// Opens a figure, a lesson, or a link in a file. `look` becomes true if another program may have changed the file.
pub(super) fn open(model: &mut Model, learn: &mut Learn, (recent, look): (&mut Recent, &mut bool), path: &Path) {
    if files::is_lesson(path) {
        return match files::read_lesson(path) {
            Ok((lesson, _)) => {
                let is_link = share::link_of(path).is_some();
                let path = if is_link { path.to_owned() } else { files::whole(path) };
                if !is_link {
                    recent.add(&path);
                }
                learn.play(model, OpenLesson { lesson: Arc::new(lesson), path: Some(path), step: 0 });
            }
            Err(error) => model.say(Message::File(path.to_owned(), error)),
        };
    }
    if let Some(kept) = model.take_kept(Some(&Source::File(files::whole(path)))) {
        learn.take_over(model, kept);
        *look = true;
        return;
    }
    match files::open_figure_with_any_camera(path) {
        Ok((opened, _)) => {
            let (figure, file) = opened.at(path);
            match Document::with_any_camera(figure, Some(file)) {
                Ok(document) => {
                    let problem = document.problem().cloned();
                    learn.take_over(model, document);
                    if let Some(error) = problem {
                        model.say(Message::Impossible(path.to_owned(), error));
                    } else if share::link_of(path).is_some() {
                        model.say(Message::LinkOpened);
                    } else {
                        recent.add(&files::whole(path));
                        model.say(Message::Opened(path.to_owned()));
                    }
                }
                Err(error) => model.say(Message::NotOpened(path.to_owned(), error)),
            }
        }
        Err(error) => model.say(Message::File(path.to_owned(), error)),
    }
}

/// Goes on with a figure of the program.
pub(super) fn open_shipped(model: &mut Model, learn: &mut Learn, name: &'static str) {
    let kept = model.take_kept(Some(&Source::Shipped(name)));
    if let Some(document) = kept.or_else(|| Document::shipped(name)) {
        learn.take_over(model, document);
    }
    // The figure of an exercise of the notes opens the exercise, not the list.
    if let Some(number) = name.strip_prefix("exercise-") {
        learn.exercises.work_on(Chosen { id: format!("0-{number}"), seed: 0 });
    }
}
