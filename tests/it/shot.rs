//! What a picture shows is one value: the figure file holds it, and every way to a picture draws the same of it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Convention, Decomposition, Ndc, Operation, Parameters};
use camera_lab::figure::words::MEASURES;
use camera_lab::figure::{
    Figure, Measured, Observers, Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, TriangleStep, View, read,
    show_with, write,
};
use camera_lab::geometry::Angle;
use camera_lab::i18n::{Lang, pictures::labels};
use camera_lab::picture::{Composite, Pixels, Renderer};
use camera_lab::progress::at_once;
use camera_lab::scene::{Preset, no_files};
use camera_lab::share;
use camera_lab::stage::Stage;
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{Picture, Request, SharedScene, Shot, Size, Views, scene_of};
use glam::DVec3;
use proptest::prelude::*;
use proptest::sample::select;

use crate::cli::pixels;
use crate::common::program::Bench;

fn figure(show: Show) -> Figure {
    Figure { show, ..Figure::of_preset(Preset::House) }
}

fn scene(figure: &Figure) -> SharedScene {
    SharedScene::new(scene_of(figure, &mut no_files, &Default::default()).unwrap())
}

fn picture(figure: &Figure, view: View, renderer: &mut Renderer) -> Pixels {
    let camera = Camera::new(&figure.camera).unwrap();
    let size = Size { width: 96, height: 72, scale: 1.0 };
    let request = Request::of(figure, view, &camera, &scene(figure), labels(Lang::En), size);
    renderer.pixels(&request).unwrap()
}

/// What may be shown of the house.
fn shows() -> impl Strategy<Value = Show> {
    let stage = (proptest::option::of(select(&Stage::ALL[..])), select(&View::ALL[..]));
    let step = (select(&Decomposition::ALL[..]), proptest::option::of(0.0..5.0_f64));
    let triangle = (0..8_u32, select(&TriangleStep::ALL[..]), proptest::option::of([0..64_u32, 0..48_u32]));
    let measures: Vec<Measured> = MEASURES.iter().map(|(_, measured)| *measured).collect();
    let probe = prop_oneof![
        [-2.0..2.0, 0.0..3.0, -2.0..2.0].prop_map(|p: [f64; 3]| ShownProbe::World(DVec3::from_array(p))),
        (0..1024_i64, 0..768_i64).prop_map(|(i, j)| ShownProbe::Pixel([i, j])),
        [-1.0..1.0, -1.0..1.0].prop_map(|p: [f64; 2]| ShownProbe::Window(p.into())),
    ];
    (
        stage,
        proptest::option::of(0.0..1.0_f64),
        proptest::option::of(step),
        proptest::option::of(triangle),
        proptest::collection::vec(select(measures), 0..3),
        proptest::option::of(probe),
        (any::<bool>(), proptest::option::of(select(&Ndc::ALL[..]))),
    )
        .prop_map(|((stage, of), painted, step, triangle, measure, probe, (answered, ndc))| {
            let name = scene(&Figure::of_preset(Preset::House)).objects[0].name.clone();
            Show {
                stage,
                stage_of: if stage.is_some() { StagePicture(of) } else { StagePicture::default() },
                painted: painted.filter(|_| stage.is_none()),
                step: step.map(|(way, at)| ShownStep { way, at }),
                triangle: triangle.map(|(index, step, pixel)| ShownTriangle {
                    object: name.clone(),
                    index,
                    step,
                    pixel,
                }),
                measure,
                measure_of: Some(name),
                probe,
                moved: Vec::new(),
                ndc,
                answer: answered
                    .then(|| Parameters { position: DVec3::new(4.0, 3.0, 2.0), ..Figure::default().camera }),
            }
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The shot of a figure, of its text read again, and of its link followed.
    #[test]
    fn a_file_and_a_link_draw_the_same_pixels_as_the_figure(show in shows()) {
        let figure = figure(show);
        let text = write::to_toml(&figure);
        let link = share::link("https://example.org/", &text).unwrap();
        let followed = share::text_in(&link).unwrap().unwrap();
        let (again, linked) = (read::parse(&text).unwrap(), read::parse_bytes(&followed).unwrap());
        prop_assert_eq!(&again, &figure);
        prop_assert_eq!(Shot::of(&again), Shot::of(&figure));
        for view in View::ALL {
            let one = picture(&figure, view, &mut Renderer::default());
            // Whatever a renderer has drawn before.
            let mut used = Renderer::default();
            picture(&Figure { show: Show::default(), ..figure.clone() }, view, &mut used);
            prop_assert!(one == picture(&linked, view, &mut used), "{view:?}");
        }
    }

    /// What is seen in a picture is seen in it again: what belongs to the others is gone.
    #[test]
    fn what_belongs_to_other_pictures_changes_nothing_in_this_one(show in shows()) {
        let shot = Shot::of(&figure(show));
        for view in View::ALL {
            let seen = shot.seen_in(view);
            prop_assert_eq!(seen.seen_in(view), seen);
        }
    }
}

/// Each key shows something in some picture, and in none to which it does not belong.
#[test]
fn each_key_shows_where_it_belongs() {
    let [world, canonical, image] = [[true, false, false], [false, true, false], [false, false, true]];
    let everywhere = [true; 3];
    let bare = Show::default();
    let mut renderer = Renderer::default();
    let plain = View::ALL.map(|view| picture(&figure(bare.clone()), view, &mut renderer));
    for (key, value, shows) in [
        ("stage", "transform", image),
        ("painted", "0.4", image),
        ("step", r#"{ way = "notes", at = 1.5 }"#, canonical),
        ("triangle", r#"{ object = "walls", index = 1, step = "view" }"#, everywhere),
        ("measure", r#"["F", "theta"]"#, world),
        ("measure", r#"["u.x", "C.y"]"#, world),
        ("probe", "{ world = [0.5, 0.5, 0.5] }", everywhere),
        ("probe", "{ pixel = [512, 300] }", everywhere),
        ("answer", "{ position = [6, 3, 2] }", world),
    ] {
        let show = show_with(&bare, key, value).unwrap();
        assert_ne!(show, bare, "{key}");
        for ((view, plain), shows) in View::ALL.into_iter().zip(&plain).zip(shows) {
            let drawn = picture(&figure(show.clone()), view, &mut renderer);
            assert_eq!(drawn != *plain, shows, "{key} = {value} in {view:?}");
        }
        assert_eq!(show_with(&show, key, "").unwrap(), bare, "{key}");
    }
}

#[test]
fn what_cannot_be_shown_is_told_by_line_key_and_what_is_allowed() {
    for (text, parts) in [
        ("stage = \"clipp\"", &["line 2", "[show] stage", "\"clipp\"", "\"clip\""][..]),
        ("painted = 1.5", &["line 2", "[show] painted", "0", "1"]),
        ("step = { at = 2 }", &["line 2", "[show] step.way", "\"notes\""]),
        ("step = { way = \"notes\", at = -1 }", &["[show] step.at", "-1"]),
        ("triangle = { index = 3 }", &["[show] triangle.object"]),
        ("triangle = { object = \"a\", step = \"outcode\" }", &["[show] triangle.step", "\"outcodes\""]),
        ("measure = [\"F\", \"Q\"]", &["[show] measure", "Q", "\"theta\""]),
        ("measure = 3", &["[show] measure", "a list of"]),
        ("probe = {}", &["[show] probe.world"]),
        ("probe = { pixel = [1.5, 2] }", &["[show] probe.pixel", "whole"]),
        ("probe = { world = [1, 2, 3], pixel = [1, 2] }", &["[show] probe.pixel", "either"]),
        ("stages = 3", &["[show] stages", "stage"]),
        ("[[show.moved]]\nframe = 3", &["[[show.moved]] change"]),
        ("[show.answer]\nnear = -3", &["[show.answer]", "near"]),
    ] {
        let error = read::parse(&format!("[show]\n{text}\n")).unwrap_err();
        let said = camera_lab::i18n::messages::figure(Lang::En, &error);
        for part in parts {
            assert!(said.contains(part), "{text}: {said} lacks {part}");
        }
        let said = camera_lab::i18n::messages::figure(Lang::PtBr, &error);
        assert!(said.contains("linha"), "{said}");
    }
}

/// What `render` writes is the same from a file, from a link, from the PNG that it wrote, and from arguments.
#[test]
fn render_draws_what_is_shown_and_arguments_override_it() {
    let bench = Bench::new("shot");
    let shown = "[show]\nstage = \"clip\"\nprobe = { pixel = [512, 300] }\n[scene]\npreset = \"house\"\n";
    bench.write("shown.toml", shown);
    bench.write("plain.toml", "[scene]\npreset = \"house\"\n");
    let render = |arguments: &[&str], out: &str| {
        let whole = [&["render"], arguments, &["--view", "image", "--size", "120x90", "-o", out]].concat();
        let run = bench.run(&whole);
        run.done();
        pixels(&bench.read(out))
    };
    let from_file = render(&["shown.toml"], "a.png");
    let from_arguments =
        render(&["plain.toml", "--show", "stage=clip", "--show", "probe={ pixel = [512, 300] }"], "b.png");
    assert!(from_file == from_arguments);
    assert!(from_file == render(&["a.png"], "c.png"), "the figure in the picture");
    let link = share::link("", shown).unwrap();
    assert!(from_file == render(&[&link], "d.png"));
    assert!(from_file != render(&["plain.toml"], "e.png"));
    assert!(
        render(&["shown.toml", "--show", "stage=", "--show", "probe="], "f.png") == render(&["plain.toml"], "g.png")
    );
}

#[test]
fn arguments_that_cannot_be_shown_are_told() {
    let bench = Bench::new("shot-arguments");
    bench.write("f.toml", "[scene]\npreset = \"house\"\n");
    for (argument, parts) in [
        ("stage", &["--show stage", "KEY=VALUE"][..]),
        ("stage=clipping", &["--show stage=clipping", "\"clip\""]),
        ("step=[1", &["TOML"]),
        ("stagee=clip", &["stagee"]),
        ("triangle={object=\"roof?\"}", &["roof?", "triangle.object", "allowed"]),
        ("triangle={object=\"walls\", index=99999}", &["99999", "triangle.index", "0 to"]),
    ] {
        let run = bench.run(&["render", "f.toml", "--show", argument, "-o", "x.png", "--lang", "en"]);
        assert_eq!(run.status, Some(2), "{argument}: {}", run.err);
        for part in parts {
            assert!(run.err.contains(part), "{argument}: {} lacks {part}", run.err);
        }
        assert!(!bench.names().contains(&"x.png".to_owned()));
    }
}

/// The pictures are drawn from what a file can hold: what operations know beyond it makes no difference between screen
/// and file.
#[test]
fn after_a_hundred_operations_the_file_draws_the_same_pixels() {
    let mut camera = Camera::new(&figure(Show::default()).camera).unwrap();
    for k in 0..100 {
        let turn = Angle::from_degrees(7.3);
        let operation = if k % 2 == 0 { Operation::Azimuth(turn) } else { Operation::Elevation(turn) };
        camera = operation.apply(&camera, Convention::default()).unwrap();
    }
    let figure = Figure { camera: *camera.parameters(), ..figure(Show::default()) };
    let again = read::parse(&write::to_toml(&figure)).unwrap();
    for view in View::ALL {
        let [one, other] = [&figure, &again].map(|figure| picture(figure, view, &mut Renderer::default()));
        assert!(one == other, "{view:?}");
    }
}

#[test]
fn pictures_are_a_list_a_second_observer_and_a_stereo_pair_are_entries_of_it() {
    let figure = figure(Show::default());
    let (camera, scene) = (Camera::new(&figure.camera).unwrap(), scene(&figure));
    let beside = |x: f64| {
        let aside = camera.basis().u * x;
        let (position, focal_point) = (figure.camera.position + aside, figure.camera.focal_point + aside);
        Camera::new(&Parameters { position, focal_point, ..figure.camera }).unwrap()
    };
    let request = |kind| {
        let size = Size { width: 96, height: 72, scale: 1.0 };
        Request::of(&figure, kind, &camera, &scene, labels(Lang::En), size)
    };
    let top = request(View::World).observer_from(Viewpoint::Top);
    let mut shot = Shot::of(&figure);
    assert_eq!(shot.pictures.iter().map(|picture| picture.kind).collect::<Vec<_>>(), View::ALL);
    shot.pictures = vec![
        Picture::new(View::World, None),
        Picture::new(View::World, top),
        Picture { camera: Some(beside(-0.2)), ..Picture::new(View::Image, None) },
        Picture { camera: Some(beside(0.2)), ..Picture::new(View::Image, None) },
    ];
    let sheet = Size { width: 4 * 96 + 3 * 4, height: 72, scale: 1.0 };
    let sheet = Request { size: sheet, ..request(View::World) };
    let composite = Composite::of(Views::All, &sheet, &shot, None).unwrap();
    let alone = [
        request(View::World),
        request(View::World).seen_by(top),
        Request { camera: beside(-0.2), ..request(View::Image) },
        Request { camera: beside(0.2), ..request(View::Image) },
    ];
    let mut renderer = Renderer::default();
    let whole = at_once(renderer.sheet(&composite, false)).unwrap().0;
    assert_eq!((whole.width(), whole.height()), (sheet.size.width, 72));
    for (i, (request, alone)) in composite.requests.iter().zip(&alone).enumerate() {
        assert_eq!(request, alone);
        let pixels = renderer.pixels(alone).unwrap();
        let rows = whole.rgba().chunks_exact(4 * whole.width() as usize).map(|row| &row[4 * 100 * i..][..4 * 96]);
        assert!(rows.zip(pixels.rgba().chunks_exact(4 * 96)).all(|(ours, own)| ours == own), "picture {i}");
    }
    // The file has room for one of each kind.
    assert_eq!(Picture::observers(&shot.pictures), Observers::default());
}
