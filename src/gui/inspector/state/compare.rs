//! The comparison of the figure with itself in another way, with one of its cameras or with another file.

use crate::figure::{Comparison, Figure};
use camera_lab_desk::{Message, Model};
use camera_lab_files::{FileError, Opened};

/// The values of the dialog that no figure has yet.
#[derive(Clone, Debug, PartialEq)]
pub struct CompareForm {
    /// θ of the other side, degrees.
    pub angle: f64,
    /// A typed operation.
    pub operation: String,
    /// A key with its other value, as typed.
    pub key: String,
}

impl CompareForm {
    /// The values of the figure's comparison, or the proposed ones.
    pub(in crate::gui) fn of(figure: &Figure) -> Self {
        let operation = figure.compare.as_ref().and_then(|comparison| comparison.ops.first());
        let of_keys = figure.compare.as_ref().filter(|comparison| !comparison.is_of_camera());
        let with = of_keys.and_then(|comparison| comparison.with.first());
        Self {
            angle: if figure.camera.view_angle < 45.0 { 60.0 } else { 30.0 },
            key: with.map_or_else(|| "camera.near = 0.5".to_owned(), |(key, value)| format!("{key} = {value}")),
            operation: operation.map_or_else(|| "azimuth=30".to_owned(), ToString::to_string),
        }
    }
}

/// Ends the comparison. The views show the figure alone, framed as before.
pub(in crate::gui) fn end(model: &mut Model) {
    if model.desk.shown.figure().compare.is_some() {
        model.desk.shown.edit(|figure| figure.compare = None);
        model.desk.commit();
    }
}

/// Swaps the sides of the comparison. Without one, shows the image of the camera that was kept last beside this one.
pub(in crate::gui) fn swap(model: &mut Model) {
    let figure = in_window(model);
    match (&figure.compare, model.camera_beside(), figure.cameras.len().checked_sub(1)) {
        (Some(_), Some(index), _) => model.look_through(index),
        (Some(comparison), None, _) => {
            if let Some(figure) = comparison.swapped(&figure) {
                take(model, figure);
            }
        }
        (None, _, Some(last)) => model.show_beside(Some(last)),
        (None, _, None) => return model.say(Message::NothingToSwap),
    }
    model.desk.commit();
}

/// The way in which the figure shows two versions now, for the next one.
pub(in crate::gui) fn look(figure: &Figure) -> Comparison {
    let now = figure.compare.as_ref();
    let Comparison { wiper, beside, differences, .. } = now.cloned().unwrap_or_default();
    Comparison { wiper, beside, differences, ..Comparison::default() }
}

/// Compares with the figure in a file. Returns false if it can't be read.
pub(in crate::gui) fn with_file(model: &mut Model, path: &std::path::Path, opened: Result<Opened, FileError>) -> bool {
    let other = match opened {
        Ok(opened) => opened.figure,
        Err(error) => {
            model.say(Message::File(path.to_owned(), error));
            return false;
        }
    };
    let is_same_scene = other.scene == model.desk.shown.figure().scene;
    let figure = compared_with(model, &other);
    take(model, figure);
    model.desk.commit();
    if !is_same_scene {
        model.say(Message::OtherScene(path.to_owned()));
    }
    true
}

/// The figure compared with the camera and the ways of drawing of another one.
pub(in crate::gui) fn compared_with(model: &Model, other: &Figure) -> Figure {
    let figure = in_window(model);
    let look = if figure.compare.is_some() { look(&figure) } else { Comparison { beside: true, ..look(&figure) } };
    Figure { compare: Some(look.with_figure(&figure, other)), ..figure }
}

/// The figure with the convention of the window, which the figure itself lacks.
pub(in crate::gui) fn in_window(model: &Model) -> Figure {
    let mut figure = model.desk.shown.figure().clone();
    figure.show.ndc = Some(model.settings.conventions.ndc);
    figure
}

/// Takes over a figure that differs in its comparison and in the parts that belong to it.
pub(in crate::gui) fn take(model: &mut Model, figure: Figure) {
    let Figure { camera, image, undistorted, photograph, viewport, style, reveal, world, show, compare, .. } = figure;
    if camera != model.desk.shown.figure().camera {
        // Only then, so that text being typed stays.
        model.desk.shown.set_parameters(camera);
    }
    model.desk.shown.edit(|figure| {
        (figure.image, figure.undistorted, figure.viewport) = (image, undistorted, viewport);
        figure.photograph = photograph;
        (figure.style, figure.reveal, figure.world, figure.compare) = (style, reveal, world, compare);
    });
    *model.desk.shown.show_mut() = show;
}
