//! The way from the world to the canonical volume: the steps of each source against M_p M_v, its pictures, and
//! `animate`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::pin::pin;
use std::task::{Context, Poll, Waker};

use camera_lab::camera::{Camera, Decomposition, Parameters, Projection, ViewWindow};
use camera_lab::export::animation::AnimationFormat;
use camera_lab::figure::Figure;
use camera_lab::figure::ShownStep;
use camera_lab::picture::{Animation, PictureError, Renderer};
use camera_lab::progress::{Activity, Progress};
use camera_lab::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures::labels};
use glam::{DMat4, DVec3, DVec4};
use proptest::prelude::*;

use crate::common::any_camera::plain_camera;
use crate::common::program::Bench;

fn product(camera: &Camera, decomposition: Decomposition) -> Option<DMat4> {
    let factors = camera.decomposed(decomposition)?;
    Some(factors.iter().fold(DMat4::IDENTITY, |product, factor| factor.matrix * product))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_steps_of_each_source_multiply_to_the_matrix(camera in plain_camera()) {
        for decomposition in Decomposition::ALL {
            let Some(product) = product(&camera, decomposition) else { continue };
            let space = camera.clip_space(decomposition.ndc()).unwrap();
            for corner in camera.volume_corners() {
                let expected = space.stations(corner, Default::default(), &camera_lab::camera::Viewport::whole(Default::default()));
                let q: DVec4 = product * corner.extend(1.0);
                let found = q.truncate() / q.w;
                prop_assert!(q.w > 0.0);
                prop_assert!(found.abs_diff_eq(expected.projected.unwrap().ndc, 1e-6), "{decomposition:?}: {found}");
            }
        }
    }

    #[test]
    fn no_step_turns_the_shown_scene_inside_out(camera in plain_camera()) {
        for decomposition in Decomposition::ALL {
            let mut before = false;
            for factor in camera.decomposed(decomposition).unwrap_or_default() {
                for share in [0.25, 0.5, 0.75, 1.0] {
                    let matrix = factor.part(before, share);
                    prop_assert!(matrix.determinant() > 0.0, "{:?} at {share}", factor.step);
                }
                prop_assert!(factor.part(before, 1.0).abs_diff_eq(factor.displayed(before), 1e-9 * (1.0 + camera.far())));
                before = factor.left_handed;
            }
        }
    }
}

#[test]
fn steps_are_those_of_the_sources() {
    let p = Parameters {
        position: DVec3::new(0.0, 0.0, 5.0),
        view_angle: 90.0,
        aspect: 2.0,
        near: 1.0,
        far: 4.0,
        ..Parameters::default()
    };
    let camera = Camera::new(&p).unwrap();
    let steps = |decomposition| camera.decomposed(decomposition).unwrap();
    // [2]: P over n, T, S.
    let by_box = steps(Decomposition::Box);
    assert_eq!(by_box[2].matrix.row(2), DVec4::new(0.0, 0.0, 5.0, 4.0));
    assert_eq!(by_box[3].matrix, DMat4::from_translation(DVec3::new(0.0, 0.0, 2.5)));
    assert_eq!(by_box[4].matrix, DMat4::from_scale(DVec3::new(0.5, 1.0, -2.0 / 3.0)));
    // [3] (1-10) to (1-17), k = 1/4.
    let normalised = steps(Decomposition::Normalised);
    assert_eq!(normalised[2].matrix, DMat4::from_scale(DVec3::new(0.5, 1.0, 1.0)));
    assert_eq!(normalised[3].matrix, DMat4::from_scale(DVec3::splat(0.25)));
    assert!(normalised[4].matrix.row(2).abs_diff_eq(DVec4::new(0.0, 0.0, 4.0 / 3.0, -1.0 / 3.0), 1e-15));
    assert_eq!(normalised[4].matrix.row(3), DVec4::Z);
    // Handedness changes once, and stays.
    for decomposition in Decomposition::ALL {
        let sides: Vec<bool> = steps(decomposition).iter().map(|factor| factor.left_handed).collect();
        assert!(sides.is_sorted() && !sides[0] && sides[sides.len() - 1], "{decomposition:?}: {sides:?}");
    }
    let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    let aslant = Camera::new(&Parameters { window, ..p }).unwrap();
    let parallel = Camera::new(&Parameters { projection: Projection::Parallel, ..p }).unwrap();
    let has = |camera: &Camera| Decomposition::ALL.map(|d| camera.decomposed(d).is_some());
    assert_eq!((has(&aslant), has(&parallel)), ([true, true, false, false], [true, true, false, true]));
}

fn film(projection: Projection, decomposition: Decomposition) -> Animation {
    let mut figure = Figure::default();
    figure.camera.position = DVec3::new(4.0, 3.0, 5.0);
    (figure.camera.near, figure.camera.far, figure.camera.projection) = (3.0, 11.0, projection);
    figure.camera.height = 4.0;
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = scene_of(&figure, &mut |_| unreachable!("no meshes"), &Default::default()).unwrap();
    let size = Size { width: 240, height: 180, scale: 1.0 };
    let request = Request::of(&figure, View::Canonical, &camera, &SharedScene::new(scene), labels(Lang::En), size);
    Animation { request, decomposition }
}

#[test]
fn the_last_still_is_the_canonical_picture() {
    let mut renderer = Renderer::default();
    for projection in [Projection::Perspective, Projection::Parallel] {
        for decomposition in Decomposition::ALL {
            let film = film(projection, decomposition);
            if film.steps() == 0 {
                continue;
            }
            let stills = film.stills();
            assert_eq!(u32::try_from(stills.requests.len()), Ok(film.steps() + 1));
            let last = renderer.pixels(stills.requests.last().unwrap()).unwrap();
            let canonical =
                film.request.clone().with_shot(|shot| (shot.show.step, shot.ndc) = (None, decomposition.ndc()));
            assert_eq!(last, renderer.pixels(&canonical).unwrap(), "{projection:?} {decomposition:?}");
            let mut seen = Vec::new();
            for request in &stills.requests {
                let picture = renderer.pixels(request).unwrap();
                assert!(!seen.contains(&picture), "each step changes the picture");
                seen.push(picture);
            }
        }
    }
}

#[test]
fn times_beyond_the_way_are_its_ends() {
    let film = film(Projection::Perspective, Decomposition::Notes);
    let mut renderer = Renderer::default();
    let mut at = |time| renderer.pixels(&film.at(time)).unwrap();
    assert_eq!(at(-3.0), at(0.0));
    assert_eq!(at(99.0), at(4.0));
    assert_eq!(at(f64::NAN), at(4.0));
    let step = ShownStep { way: Decomposition::Notes, at: Some(1.0) };
    let other = film.request.clone().with_shot(|shot| shot.show.step = Some(step));
    assert_eq!(other, film.at(1.0));
}

#[test]
fn an_animation_is_given_up_within_a_picture() {
    let figure = Figure::default();
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = SharedScene::new(scene_of(&figure, &mut camera_lab::scene::no_files, &Default::default()).unwrap());
    let size = Size { width: 640, height: 480, scale: 1.0 };
    let request = Request::of(&figure, View::Canonical, &camera, &scene, labels(Lang::En), size);
    let film = Animation { request, decomposition: Decomposition::Notes };
    let progress = Progress::default();
    // On one thread a picture pauses after each of its bands.
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    alone.install(|| {
        let mut work = pin!(film.animation(AnimationFormat::Gif, 0.1, &progress));
        let mut slice = || work.as_mut().poll(&mut Context::from_waker(Waker::noop()));
        assert!(slice().is_pending());
        assert_eq!(progress.now(), Some((Activity::Encoding, Some(0.0))), "the first picture is not done");
        progress.cancel();
        // A few slices on, and long before the picture would be done.
        let ended = (0..3).find_map(|_| if let Poll::Ready(made) = slice() { Some(made) } else { None });
        assert!(matches!(ended, Some(Err(PictureError::Cancelled))));
    });
}

#[test]
fn animations_and_strips_are_written() {
    let bench = Bench::new("animate");
    bench.write("f.toml", "[camera]\nnear = 3\nfar = 11\nposition = [4, 3, 5]\n[scene]\npreset = \"house\"\n");
    let animate = |arguments: &[&str]| bench.run(&[&["animate", "f.toml", "--size", "96x72"], arguments].concat());
    animate(&["--seconds", "0.1", "-o", "a.gif"]).done();
    animate(&["--seconds", "0.1", "--steps", "box", "-o", "a.apng"]).done();
    animate(&["-o", "a.png"]).done();
    let gif = bench.read("a.gif");
    let mut decoder = gif::DecodeOptions::new().read_info(&gif[..]).unwrap();
    let mut pictures = 0;
    while decoder.read_next_frame().unwrap().is_some() {
        pictures += 1;
    }
    // Four steps of two pictures, and the last.
    assert_eq!((pictures, decoder.width(), decoder.height()), (9, 96, 72));
    let apng = bench.read("a.apng");
    let reader = png::Decoder::new(std::io::Cursor::new(&apng)).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 11);
    let strip = bench.read("a.png");
    let reader = png::Decoder::new(std::io::Cursor::new(&strip)).read_info().unwrap();
    assert_eq!((reader.info().width, reader.info().height), (5 * 96 + 4 * 4, 72));
    assert!(animate(&["-o", "a.mp4"]).refused(2).contains(".gif, .apng"));
    assert!(animate(&["--seconds", "0", "-o", "b.gif"]).refused(2).contains("0.1 to 60"));
    bench.write("f.toml", "[camera]\nwindow = { left = -1, right = 2, bottom = -1, top = 1 }\n");
    assert!(animate(&["--steps", "scale", "-o", "b.gif"]).refused(2).contains("symmetric window"));
    assert_eq!(bench.names(), ["a.apng", "a.gif", "a.png", "f.toml"]);
}
