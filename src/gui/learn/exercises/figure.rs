//! The figure of an exercise for the pictures, and the small picture to match.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::{ColorImage, Id, TextureHandle, TextureOptions, Ui};

use crate::camera::{Camera, Parameters};
use crate::exercises::{Ask, Exercise, Expected, Fact, Subject};
use crate::figure::points::{free_name, may_be_named};
use crate::figure::{Figure, NamedPoint};
use crate::picture::{Pixels, Renderer};
use crate::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures};

/// The size of the small picture, in pixels.
const SIZE: Size = Size { width: 320, height: 240, scale: 1.0 };

/// The figure before the operations, with its points and their names. If it has been tried, with its answers too.
pub(super) fn given(exercise: &Exercise, is_tried: bool) -> Figure {
    match exercise.answered.as_deref().filter(|_| is_tried) {
        Some(answered) => answered.clone(),
        None => with_camera(exercise, exercise.subject.figure.camera),
    }
}

/// The figure with another camera.
pub(super) fn with_camera(exercise: &Exercise, camera: Parameters) -> Figure {
    let mut figure = Figure { camera, ..exercise.subject.figure.clone() };
    for point in &exercise.subject.points {
        let is_shown = figure.points.iter().any(|named| named.position == *point);
        if !is_shown && figure.points.len() < crate::limits::MAX_NAMED_POINTS {
            let name = name_of(exercise, point.to_array(), &figure.points);
            figure.points.push(NamedPoint { name, position: *point });
        }
    }
    figure
}

/// The statement's name of a point, if it has one.
fn name_of(exercise: &Exercise, position: [f64; 3], points: &[NamedPoint]) -> String {
    let told = exercise.facts.iter().find(|(_, fact)| matches!(fact, Fact::Tuple(values) if **values == position));
    let told = told.map(|(name, _)| *name).filter(|name| may_be_named(name, points.iter()));
    told.map_or_else(|| free_name(points), str::to_owned)
}

/// The subject of an ask, if it isn't the exercise's own.
pub(super) fn subject_of<'a>(exercise: &'a Exercise, ask: &'a Ask) -> &'a Subject {
    match ask.expected() {
        Expected::Quantity(subject, _) => subject,
        Expected::Computed(..) | Expected::Choice(..) | Expected::Camera(..) => &exercise.subject,
    }
}

/// The thumbnail drawn last.
type Drawn = camera_lab_desk::Memo<(Figure, Lang), Option<TextureHandle>>;

/// The image of the figure by the camera to be found, drawn once.
pub(super) fn target(
    ui: &Ui,
    mut figure: Figure,
    (theme, lang): (crate::appearance::Theme, Lang),
) -> Option<TextureHandle> {
    figure.style.theme = theme;
    let drawn = ui.data_mut(|data| {
        Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Drawn>>>(Id::unique("picture to be matched")))
    });
    // A panic leaves a picture, or none.
    let mut drawn = drawn.lock().unwrap_or_else(PoisonError::into_inner);
    let make = |(figure, lang): &(Figure, Lang)| {
        let picture = draw(figure, *lang)?;
        let size = [picture.width() as usize, picture.height() as usize];
        let image = ColorImage::from_rgba_premultiplied(size, picture.rgba());
        Some(ui.ctx().load_texture("picture to be matched", image, TextureOptions::LINEAR))
    };
    drawn.of((figure, lang), make).clone()
}

fn draw(figure: &Figure, lang: Lang) -> Option<Pixels> {
    let camera = Camera::new(&figure.camera).ok()?;
    // The scenes of exercises name no files.
    let scene =
        SharedScene::new(scene_of(figure, &mut crate::scene::no_files, &crate::progress::Progress::default()).ok()?);
    Renderer::default().pixels(&Request::of(figure, View::Image, &camera, &scene, pictures::labels(lang), SIZE))
}
