//! Cameras at the limits of numbers draw pictures that a person can read: the gallery of `assets/figures/extreme`.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::collections::BTreeSet;

use camera_lab::appearance::{Rgba, Samples, Theme};
use camera_lab::camera::Camera;
use camera_lab::drawing::Drawing;
use camera_lab::figure::read::parse;
use camera_lab::progress::Progress;
use camera_lab::raster::Rasterizer;
use camera_lab::scene::no_files;
use camera_lab::text::measure;
use camera_lab::views::{Palette, Request, SharedScene, Size, TimedPipeline, View, frame, scene_of};
use camera_lab_files::{SHIPPED_FIGURES, ShippedFigure, Topic};
use camera_lab_words::{Lang, pictures};

use crate::common::picture::assert_picture;

const SIZE: Size = Size { width: 400, height: 300, scale: 1.0 };

fn extreme() -> impl Iterator<Item = ShippedFigure> {
    SHIPPED_FIGURES.into_iter().filter(|figure| figure.topic == Topic::Limits)
}

fn drawing(figure: ShippedFigure, view: View, lang: Lang) -> Drawing {
    drawing_of(&figure.text(), view, lang)
}

fn drawing_of(text: &str, view: View, lang: Lang) -> Drawing {
    let figure = parse(text).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = SharedScene::new(scene_of(&figure, &mut no_files, &Progress::default()).unwrap());
    let mut request = Request::of(&figure, view, &camera, &scene, pictures::labels(lang), SIZE);
    request = request.clone().with_shot(|shot| shot.look.style.antialias = Samples::One);
    frame(&request, None, &mut TimedPipeline::default()).drawing
}

/// All numbers of a drawing.
fn numbers(drawing: &Drawing) -> impl Iterator<Item = f32> + '_ {
    let faces = drawing.surfaces.iter().flat_map(|s| s.positions.iter().flatten().chain(&s.inverse_w));
    let strokes = drawing.strokes.iter().flat_map(|s| s.points.iter().flatten());
    let marks = drawing.marks.iter().flat_map(|m| &m.position);
    let labels = drawing.labels.iter().flat_map(|l| l.position.iter().chain(&l.offset));
    faces.chain(strokes).chain(marks).chain(labels).copied()
}

#[test]
fn nothing_is_blank_nan_or_crowded_past_reading() {
    assert!(extreme().count() >= 12);
    for figure in extreme() {
        for view in [View::World, View::Canonical, View::Image] {
            let what = format!("{} {view:?}", figure.name);
            let drawing = drawing(figure, view, Lang::PtBr);
            assert!(numbers(&drawing).all(f32::is_finite), "{what}");
            assert!(drawing.labels.len() <= 24, "{what}: {} texts", drawing.labels.len());
            let pixels = Rasterizer::default().paint(&drawing).unwrap();
            let colours: BTreeSet<[u8; 4]> = pixels.data().as_chunks().0.iter().copied().collect();
            let ground = pixels.data().as_chunks::<4>().0.iter().filter(|p| {
                let background = drawing.background;
                **p == [background.r, background.g, background.b, 255]
            });
            let covered = 1.0 - ground.count() as f64 / f64::from(SIZE.width * SIZE.height);
            // Of the image of a table in a window of a million units a mark is left.
            let (few, least) = if figure.name == "zoomed-out" && view == View::Image { (5, 1e-4) } else { (8, 0.01) };
            assert!(colours.len() >= few && covered > least, "{what}: {} colours, {covered}", colours.len());
            for label in &drawing.labels {
                let size = measure(&label.text, label.size, label.mathematical);
                let x = label.position[0] + label.offset[0];
                let y = label.position[1] + label.offset[1];
                let inside = x > -size.width && x < 400.0 + size.width && y > 0.0 && y < 300.0;
                assert!(inside, "{what}: {} at {x}, {y}", label.text);
            }
        }
    }
}

#[test]
fn the_world_shows_the_camera_and_names_its_parts() {
    for figure in extreme() {
        let drawing = drawing(figure, View::World, Lang::En);
        let texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
        for wanted in ["C", "PF", "u", "v", "n", "VUP", "DOP"] {
            assert!(texts.contains(&wanted), "{}: {wanted} is not in {texts:?}", figure.name);
        }
        // The scene, or the ring if it is too small.
        let c = drawing.labels.iter().find(|label| label.text == "C").unwrap();
        assert!((0.0..400.0).contains(&c.position[0]) && (0.0..300.0).contains(&c.position[1]), "{}", figure.name);
        let speck = ["narrow-angle", "large-distance", "aside"].contains(&figure.name);
        assert_eq!(texts.contains(&"scene"), speck, "{}: {texts:?}", figure.name);
    }
}

/// The rectangle around the points of all strokes of a colour.
fn around(drawing: &Drawing, color: Rgba) -> [[f32; 2]; 2] {
    let strokes = drawing.strokes.iter().filter(|stroke| stroke.style.color == color);
    let points = strokes.flat_map(|stroke| &stroke.points);
    points.fold([[f32::MAX; 2], [f32::MIN; 2]], |[least, most], p| {
        [[least[0].min(p[0]), least[1].min(p[1])], [most[0].max(p[0]), most[1].max(p[1])]]
    })
}

/// The share of the picture's width or height that the volume has. Panics if it leaves the picture.
fn share_of_the_volume(drawing: &Drawing, what: &str) -> f32 {
    // Strokes end at the border of the picture.
    let [least, most] = around(drawing, Palette::of(Theme::Light).volume_edge);
    let inside = least[0] > 2.0 && least[1] > 2.0 && most[0] < 398.0 && most[1] < 298.0;
    assert!(inside, "{what}: the volume is at {least:?} to {most:?}");
    ((most[0] - least[0]) / 400.0).max((most[1] - least[1]) / 300.0)
}

#[test]
fn the_world_frames_the_volume_however_thin_deep_wide_or_far_it_is() {
    for figure in extreme() {
        let share = share_of_the_volume(&drawing(figure, View::World, Lang::En), figure.name);
        assert!((0.3..0.95).contains(&share), "{}: {share}", figure.name);
    }
    for projection in ["perspective", "parallel"] {
        for (near, far) in [("5000.0", "6000.0"), ("5000.0", "5003.0"), ("1e12", "1.5e12"), ("1e6", "1e12")] {
            let text = format!("[camera]\nprojection = \"{projection}\"\nnear = {near}\nfar = {far}\n");
            let what = format!("{projection} {near} {far}");
            let drawing = drawing_of(&text, View::World, Lang::En);
            assert!((0.2..0.95).contains(&share_of_the_volume(&drawing, &what)), "{what}");
            let named = |start: &str| drawing.labels.iter().any(|label| label.text.starts_with(start));
            assert!(named("window (F = ") && named("far (B = "), "{what}");
            // And the objects near C have room: camera and table are a quarter of the picture.
            let table = drawing.surfaces.iter().filter(|s| s.depth_test && !s.translucent).flat_map(|s| &s.positions);
            let [least, most] = table.fold([f32::MAX, f32::MIN], |[a, b], p| [a.min(p[0]), b.max(p[0])]);
            assert!(most - least > 100.0, "{what}: {least} to {most}");
        }
    }
}

#[test]
fn the_worlds_of_the_wide_and_of_the_far() {
    for name in ["zoomed-out", "wide-angle", "far-position", "large-distance"] {
        let drawing = drawing(ShippedFigure::named(name).unwrap(), View::World, Lang::En);
        assert_picture(
            &format!("extreme_world_{}", name.replace('-', "_")),
            &Rasterizer::default().paint(&drawing).unwrap(),
        );
    }
}

#[test]
fn the_canonical_volumes_of_the_deep() {
    for name in ["far-plane", "far-near", "thin-volume"] {
        let drawing = drawing(ShippedFigure::named(name).unwrap(), View::Canonical, Lang::En);
        assert_picture(
            &format!("extreme_canonical_{}", name.replace('-', "_")),
            &Rasterizer::default().paint(&drawing).unwrap(),
        );
    }
}
