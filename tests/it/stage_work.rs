//! The marks of a stage in a picture: its input and its output.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::{Rgba, Samples, Shading};
use camera_lab::camera::Camera;
use camera_lab::clock;
use camera_lab::figure::{Depth, Figure, StagePicture};
use camera_lab::picture::{Pixels, Renderer};
use camera_lab::pipeline::{Containment, Frame, Options, Pipeline, Stage, StageReport, Target};
use camera_lab::progress::at_once;
use camera_lab::scene::Preset;
use camera_lab::views::{Finish, Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures::labels};

const SIDE: u32 = 200;

/// The picture with a stage shown in it.
fn staged(plain: &Request, stage: Stage) -> Request {
    let of = StagePicture(plain.view);
    plain.clone().with_shot(|shot| (shot.show.stage, shot.show.stage_of) = (Some(stage), of))
}

fn request(near: f64) -> Request {
    let mut figure = Figure::default();
    figure.scene.preset = Preset::House;
    (figure.camera.near, figure.camera.far) = (near, 40.0);
    (figure.camera.aspect, figure.style.antialias) = (1.0, Samples::Four);
    figure.style.shading = Shading::Flat;
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = scene_of(&figure, &mut |_| unreachable!("no meshes"), &Default::default()).unwrap();
    let size = Size { width: SIDE, height: SIDE, scale: 1.0 };
    let request = Request::of(&figure, View::Image, &camera, &SharedScene::new(scene), labels(Lang::En), size);
    Request { finish: Finish { bare: true, ..Finish::default() }, ..request }
}

fn frame(near: f64, stage: Option<Stage>) -> Frame {
    let request = request(near);
    let target = Target { width: SIDE, height: SIDE, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
    let options = Options { shown: stage, ..Options::default() };
    Pipeline::default().frame(&*request.scene, &request.camera, target, &request.shot.look.style, options)
}

fn report(frame: &Frame, stage: Stage) -> StageReport {
    *frame.report.iter().find(|report| report.stage == stage).unwrap()
}

#[test]
fn noting_a_stage_changes_nothing_and_one_that_did_not_run_has_nothing_to_show() {
    let plain = frame(2.0, None);
    assert!(plain.work.is_none());
    for stage in Stage::ALL {
        let noted = frame(2.0, Some(stage));
        assert_eq!(noted.drawing, plain.drawing, "{stage:?}");
        assert_eq!(noted.work.is_some(), report(&plain, stage).ran, "{stage:?}");
    }
}

#[test]
fn noted_work_agrees_with_the_counts_of_the_report() {
    for near in [0.5, 2.0, 6.0] {
        let culled = frame(near, Some(Stage::CullFaces));
        let (from, to) = report(&culled, Stage::CullFaces).counts.unwrap();
        let work = culled.work.unwrap();
        assert!(from > to && !work.dropped.is_empty());
        assert!(work.dropped.len() <= from - to, "of those that are dropped some are not in the picture");
        assert!(work.after.len() <= 3 * to);

        let divided = frame(near, Some(Stage::Divide));
        let (vertices, _) = report(&divided, Stage::Divide).counts.unwrap();
        let work = divided.work.unwrap();
        assert!(!work.vertices.is_empty() && work.vertices.len() <= vertices);
        for v in work.vertices {
            // Independent: pixels by (5.24) from the numbers that are shown.
            let half = f64::from(SIDE) / 2.0;
            let [x, y] = [half + v.clip[0] / v.w * half, half - v.clip[1] / v.w * half];
            assert!((x - f64::from(v.image[0])).abs() < 1e-3 && (y - f64::from(v.image[1])).abs() < 1e-3, "{v:?}");
            assert!((v.w + v.view.z).abs() < 1e-12 * v.w, "w is the distance from the eye");
        }
    }
}

#[test]
fn every_vertex_that_clipping_makes_lies_in_a_plane() {
    let clipped = frame(6.0, Some(Stage::Clip));
    let work = clipped.work.unwrap();
    assert!(!work.cuts.is_empty() && !work.before.is_empty() && !work.after.is_empty());
    let depths = clipped.depths;
    let volume =
        camera_lab::pipeline::depths::DepthScale::of_volume(camera_lab::camera::Projection::Perspective, 6.0, 40.0);
    for [x, y, depth] in work.cuts {
        let at = |v: f32| v < 0.01 || v > SIDE as f32 - 0.01;
        let of_volume = depths.in_scale(&volume, f64::from(depth));
        assert!(at(x) || at(y) || of_volume.abs() < 1e-4 || (of_volume - 1.0).abs() < 1e-4, "{x} {y} {of_volume}");
    }
}

#[test]
fn objects_that_are_dropped_are_named() {
    let mut plain = request(2.0);
    let mut scene = (*plain.scene).clone();
    scene.objects[0].world_from_object = glam::DMat4::from_translation(glam::DVec3::Y * 500.0);
    let away = scene.objects[0].name.clone();
    plain.scene = SharedScene::new(scene);
    let target = Target { width: SIDE, height: SIDE, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
    let options = Options { shown: Some(Stage::CullObjects), ..Options::default() };
    let frame = Pipeline::default().frame(&*plain.scene, &plain.camera, target, &plain.shot.look.style, options);
    let work = frame.work.unwrap();
    assert_eq!(work.objects.len(), plain.scene.objects.len());
    let dropped: Vec<_> = work.objects.iter().filter(|o| matches!(o.containment, Containment::Outside(_))).collect();
    assert!(dropped.iter().any(|object| object.name == away && object.middle.is_none()));
}

/// The pixels of one half, away from the line in the middle and from the text beside it.
fn half(picture: &Pixels, right: bool) -> Vec<[u8; 4]> {
    let (side, half) = (SIDE as usize, SIDE as usize / 2);
    let columns = if right { half + 4..side } else { 0..half - 4 };
    let pixel = |i: usize| <[u8; 4]>::try_from(&picture.rgba()[4 * i..4 * i + 4]).unwrap();
    (40..side).flat_map(|y| columns.clone().map(move |x| y * side + x)).map(pixel).collect()
}

#[test]
fn the_left_half_is_before_the_stage_and_the_right_half_after_it() {
    let mut renderer = Renderer::default();
    let plain = request(2.0);
    let whole = renderer.pixels(&plain).unwrap();
    let shown = renderer.pixels(&staged(&plain, Stage::Antialias)).unwrap();
    let mut rough = plain.clone();
    rough = rough.with_shot(|shot| shot.look.style.antialias = Samples::One);
    let rough = renderer.pixels(&rough).unwrap();
    assert_eq!(half(&shown, true), half(&whole, true));
    assert_eq!(half(&shown, false), half(&rough, false));
    assert_ne!(half(&rough, false), half(&whole, false), "it makes a difference there");

    let shown = renderer.pixels(&staged(&plain, Stage::Write)).unwrap();
    let empty = renderer.pixels(&Request { scene: SharedScene::default(), ..plain.clone() }).unwrap();
    assert_eq!(half(&shown, false), half(&empty, false), "nothing is written yet");
    assert_eq!(half(&shown, true), half(&whole, true));

    // Without light the faces have their own colours.
    let shown = renderer.pixels(&staged(&plain, Stage::Light)).unwrap();
    let mut scene = (*plain.scene).clone();
    scene.lights.clear();
    let dark = renderer.pixels(&Request { scene: SharedScene::new(scene), ..plain.clone() }).unwrap();
    assert_eq!(half(&shown, false), half(&dark, false));
    assert_ne!(half(&dark, false), half(&whole, false));

    // A stage that did not run changes nothing.
    let shown = renderer.pixels(&staged(&plain, Stage::Texture)).unwrap();
    assert_eq!(shown, whole);
}

#[test]
fn every_stage_is_shown_in_every_picture() {
    let mut renderer = Renderer::default();
    for view in View::ALL {
        let plain = Request { view, ..request(2.0) };
        let target = renderer.drawing(&plain).unwrap();
        for stage in Stage::ALL {
            let shown = renderer.drawing(&staged(&plain, stage)).unwrap();
            let ran = report(&target, stage).ran;
            assert_eq!(shown.drawing != target.drawing || shown.before.is_some(), ran, "{view:?} {stage:?}");
        }
    }
}

/// The triangles that a stage drops are shown in another colour and are not counted: the stages report the same of the
/// picture as without it.
#[test]
fn faces_that_show_a_stage_are_not_counted_even_with_depths_shown() {
    for depth in [Depth::Off, Depth::Stored] {
        let plain = request(2.0).with_shot(|shot| shot.look.reveal.depth = depth);
        let accounts = |request: &Request| {
            let mut renderer = Renderer::default();
            renderer.measure(Some(clock::now));
            let mut picture = Pixels::default();
            let account = at_once(renderer.pixels_into(request, &mut picture)).unwrap();
            account.stages.iter().map(|report| (report.stage, report.ran, report.counts)).collect::<Vec<_>>()
        };
        let usual = accounts(&plain);
        assert!(usual.iter().any(|(stage, ran, _)| *stage == Stage::Fill && *ran), "{depth:?}");
        for stage in [Stage::CullObjects, Stage::CullFaces, Stage::Clip] {
            assert_eq!(accounts(&staged(&plain, stage)), usual, "{stage:?} {depth:?}");
        }
    }
}
