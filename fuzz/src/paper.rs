//! Pictures of any size, with letters and lines of any height and width, are drawn or refused: on paper, of one picture
//! or of three.

use std::sync::LazyLock;

use arbitrary::{Arbitrary, Unstructured};
use camera_lab::camera::Camera;
use camera_lab::figure::Figure;
use camera_lab::picture::{Composite, OnPaper, Renderer};
use camera_lab::progress::at_once;
use camera_lab::scene::{Preset, no_files};
use camera_lab::views::{Finish, Request, SharedScene, Shot, Size, View, Views, scene_of};
use camera_lab_words::{Lang, pictures::labels};

#[derive(Arbitrary, Debug)]
struct Input {
    which: u8,
    width: u8,
    height: u8,
    scale: f32,
    paper: Option<(f64, Option<f64>, Option<f64>, bool)>,
    stroke_factor: Option<f32>,
    bare: bool,
    crop: bool,
}

static SUBJECT: LazyLock<(Shot, Camera, SharedScene)> = LazyLock::new(|| {
    let mut figure = Figure::of_preset(Preset::Cube);
    figure.style.antialias = camera_lab::appearance::Samples::One;
    let camera = Camera::new(&figure.camera).expect("a camera");
    let scene = scene_of(&figure, &mut no_files, &Default::default()).expect("a scene");
    (Shot::of(&figure), camera, SharedScene::new(scene))
});

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(input) = Input::arbitrary_take_rest(Unstructured::new(bytes)) else { return };
    let (shot, camera, scene) = &*SUBJECT;
    // As the shells hand them on: positive and finite.
    let positive = |x: f64| x.is_finite() && x > 0.0;
    if !positive(f64::from(input.scale)) || input.stroke_factor.is_some_and(|factor| !positive(f64::from(factor))) {
        return;
    }
    let numbers = input.paper.iter().flat_map(|(dpi, letters, lines, _)| [Some(*dpi), *letters, *lines]);
    if !numbers.flatten().all(positive) {
        return;
    }
    let paper = input.paper.map(|(dpi, letters, lines, arranged)| OnPaper { dpi, letters, lines, arranged });
    let views = Views::CHOICES[usize::from(input.which) % Views::CHOICES.len()];
    let size = Size { width: input.width.into(), height: input.height.into(), scale: input.scale };
    let finish = Finish { bare: input.bare, stroke_factor: input.stroke_factor, ..Finish::default() };
    let request = Request { finish, ..Request::new(shot, View::Image, camera, scene, labels(Lang::En), size) };
    let Ok(sheet) = Composite::of(views, &request, shot, paper.as_ref()) else { return };
    if let Some((picture, _)) = at_once(Renderer::default().sheet(&sheet, input.crop)) {
        assert!(picture.width() <= size.width && picture.height() <= size.height);
    }
}
