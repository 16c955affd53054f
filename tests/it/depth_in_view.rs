//! Visibility does not depend on F and B: depths are resolved over the objects in view.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::appearance::{Rgba, Samples, Shading, Style, Visibility};
use camera_lab::camera::{Camera, Parameters, Projection};
use camera_lab::figure::{Depth, Figure, Reveal, recommended_camera};
use camera_lab::pipeline::{Frame, Options, Pipeline, Target};
use camera_lab::progress::Progress;
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Preset, no_files};
use camera_lab::views::{self, Request, SharedScene, Size, TimedPipeline, View, frame, scene_of};
use camera_lab_words::{Lang, pictures};
use glam::DVec2;

const SIZE: Size = Size { width: 320, height: 240, scale: 1.0 };

fn figure(preset: Preset, projection: Projection) -> Figure {
    let mut figure = Figure { camera: recommended_camera(preset), ..Figure::default() };
    figure.scene.preset = preset;
    let distance = (figure.camera.focal_point - figure.camera.position).length();
    figure.camera.projection = projection;
    figure.camera.height = 0.8 * distance;
    (figure.camera.near, figure.camera.far) = (0.2 * distance, 4.0 * distance);
    figure
}

fn picture(figure: &Figure, view: View, style: Style) -> Vec<[u8; 4]> {
    let scene = SharedScene::new(scene_of(figure, &mut no_files, &Progress::default()).unwrap());
    let camera = Camera::new(&figure.camera).unwrap();
    let mut request = Request::of(figure, view, &camera, &scene, pictures::labels(Lang::En), SIZE);
    request = request.clone().with_shot(|shot| shot.look.style = style);
    let drawing = frame(&request, None, &mut TimedPipeline::default()).drawing;
    let pixmap = Rasterizer::default().paint(&drawing).unwrap();
    pixmap.data().as_chunks().0.to_vec()
}

/// The share of pixels that differ clearly.
fn differing(a: &[[u8; 4]], b: &[[u8; 4]]) -> f64 {
    let differ = a.iter().zip(b).filter(|(a, b)| (0..4).any(|k| a[k].abs_diff(b[k]) > 24)).count();
    f64::from(u32::try_from(differ).unwrap()) / f64::from(SIZE.width * SIZE.height)
}

#[test]
fn the_image_is_the_same_whatever_f_and_b_are() {
    for preset in [Preset::House, Preset::Primitives] {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let figure = figure(preset, projection);
            let style = Style { antialias: Samples::One, ..figure.style };
            let expected = picture(&figure, View::Image, style);
            for (near, far) in [(1e-2, 1e4), (1e-4, 1e7), (1e-9, 1e2), (1e-9, 1e6), (1.0, 1e12), (1e-3, 1e15)] {
                let camera = Parameters { near, far, ..figure.camera };
                let found = picture(&Figure { camera, ..figure.clone() }, View::Image, style);
                let share = differing(&expected, &found);
                assert!(share < 2e-3, "{preset:?} {projection:?} {near} {far}: {share}");
            }
        }
    }
}

#[test]
fn forced_stages_and_other_orders_show_the_same() {
    let mut figure = figure(Preset::Primitives, Projection::Parallel);
    (figure.camera.near, figure.camera.far) = (1e-9, 1e12);
    let scene = scene_of(&figure, &mut no_files, &Progress::default()).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let target = Target { width: 200, height: 150, scale: 1.0, background: Rgba::rgb(9, 9, 9) };
    let style = Style { antialias: Samples::One, shading: Shading::Flat, ..figure.style };
    let planned = Pipeline::default().frame(&scene, &camera, target, &style, Options::default());
    let forced = Options { force_all_stages: true, ..Options::default() };
    let forced = Pipeline::default().frame(&scene, &camera, target, &style, forced);
    assert_eq!(planned.depths, forced.depths);
    let pixels = |frame: &Frame| Rasterizer::default().paint(&frame.drawing).unwrap().take();
    assert!(pixels(&planned) == pixels(&forced), "a stage changes pixels");
    assert!(planned.depths.far < 100.0, "{:?}", planned.depths);
    let split = Style { visibility: Visibility::Bsp, ..style };
    let share = differing(&picture(&figure, View::Image, style), &picture(&figure, View::Image, split));
    assert!(share < 5e-3, "{share}");
}

#[test]
fn the_depths_that_are_shown_are_those_of_5_25() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let mut figure = figure(Preset::House, projection);
        (figure.camera.near, figure.camera.far) = (1e-4, 100.0);
        figure.reveal = Reveal { depth: Depth::Stored, ..Reveal::default() };
        let camera = Camera::new(&figure.camera).unwrap();
        let scene = SharedScene::new(scene_of(&figure, &mut no_files, &Progress::default()).unwrap());
        let mut request = Request::of(&figure, View::Image, &camera, &scene, pictures::labels(Lang::En), SIZE);
        request = request.clone().with_shot(|shot| shot.look.style.antialias = Samples::One);
        // In perspective nearly all is white there (Z near 1): distances say more.
        for shown in [Depth::Stored, Depth::Linear] {
            request = request.clone().with_shot(|shot| shot.look.reveal.depth = shown);
            let drawing = frame(&request, None, &mut TimedPipeline::default()).drawing;
            let pixels = Rasterizer::default().paint(&drawing).unwrap();
            let mut compared = 0;
            for (x, y) in (0..SIZE.width).step_by(7).flat_map(|x| (60..SIZE.height).step_by(7).map(move |y| (x, y))) {
                let w = camera.window();
                let (across, down) = ((f64::from(x) + 0.5) / 320.0, (f64::from(y) + 0.5) / 240.0);
                let point = DVec2::new(w.left + w.width() * across, w.top - w.height() * down);
                let Some(reading) = views::depth::reading(&request, point) else { continue };
                let level = match shown {
                    Depth::Stored => reading.z,
                    _ => (reading.distance - camera.near()) / (camera.far() - camera.near()),
                };
                let found = f64::from(pixels.pixel(x, y).unwrap().red()) / 255.0;
                compared += usize::from((found - level).abs() < 0.02);
            }
            assert!(compared > 200, "{projection:?} {shown:?}: {compared}");
        }
    }
}

#[test]
fn the_canonical_volume_shows_a_sheet_in_which_things_hide_each_other() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let mut figure = figure(Preset::Primitives, projection);
        (figure.camera.near, figure.camera.far) =
            if projection == Projection::Parallel { (1.0, 1e12) } else { (1e-9, 1e3) };
        let style = Style { antialias: Samples::One, ..figure.style };
        let split = Style { visibility: Visibility::Bsp, ..style };
        let (tested, split) = (picture(&figure, View::Canonical, style), picture(&figure, View::Canonical, split));
        let share = differing(&tested, &split);
        assert!(share < 0.01, "{projection:?}: {share}");
    }
}
