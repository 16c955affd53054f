//! The contents of a picture are one value: the figure file holds it, and every way to a picture draws the same of it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Convention, Operation, Parameters};
use camera_lab::figure::{Figure, Observers, Show, View, read, show_with, write};
use camera_lab::geometry::Angle;
use camera_lab::picture::{Composite, Pixels, Renderer};
use camera_lab::progress::at_once;
use camera_lab::stage::Stage;
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{Finish, Picture, Request, SharedScene, Shot, Size, Views};
use camera_lab_files::share;
use camera_lab_words::{Lang, pictures::labels};
use proptest::prelude::*;

use crate::cli::pixels;
use crate::common::program::Bench;
use crate::common::shot::{house, observers, operations, scene, shows};

fn picture(figure: &Figure, view: View, renderer: &mut Renderer) -> Pixels {
    picture_by(&Camera::new(&figure.camera).unwrap(), figure, view, renderer)
}

/// A picture of a figure whose camera may know more than its parameters.
fn picture_by(camera: &Camera, figure: &Figure, view: View, renderer: &mut Renderer) -> Pixels {
    renderer.pixels(&request(camera, figure, view, &scene(figure))).unwrap()
}

fn request(camera: &Camera, figure: &Figure, view: View, scene: &SharedScene) -> Request {
    let size = Size { width: 96, height: 72, scale: 1.0 };
    Request::of(figure, view, camera, scene, labels(Lang::En), size)
}

/// The camera after operations, as far as they can be done.
fn operated(mut camera: Camera, operations: &[Operation]) -> Camera {
    for operation in operations {
        camera = operation.apply(&camera, Convention::default()).unwrap_or(camera);
    }
    camera
}

/// `show`, with all that does not belong to a picture as in `other`.
fn with_others(show: &Show, view: View, other: &Show) -> Show {
    let mut mixed = show.clone();
    if view != View::World {
        (mixed.measure, mixed.measure_of) = (other.measure.clone(), other.measure_of.clone());
        (mixed.moved, mixed.answer) = (other.moved.clone(), other.answer);
    }
    if view != View::Canonical {
        mixed.step = other.step;
    }
    if view != View::Canonical || mixed.step.is_some() {
        // Steps end in a convention of their own.
        mixed.ndc = other.ndc;
    }
    if view != View::Image {
        mixed.painted = other.painted;
    }
    // Faces culled and clipped in the image are seen in the pictures beside it.
    let is_beside = |stage| matches!(stage, Stage::CullObjects | Stage::CullFaces | Stage::Clip);
    let belongs = |show: &Show| {
        show.stage.is_some_and(|stage| show.stage_of.0 == view || show.stage_of.0 == View::Image && is_beside(stage))
    };
    if !belongs(show) && !belongs(other) {
        (mixed.stage, mixed.stage_of) = (other.stage, other.stage_of);
    }
    mixed
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The shot of a figure, of its text read again, and of its link followed.
    #[test]
    fn a_file_and_a_link_draw_the_same_pixels_as_the_figure(
        show in shows(),
        observers in observers(),
        operations in operations(),
    ) {
        let figure = Figure { observers, ..house(show) };
        let camera = operated(Camera::new(&figure.camera).unwrap(), &operations);
        let figure = Figure { camera: *camera.parameters(), ..figure };
        let text = write::to_toml(&figure);
        let link = share::link("https://example.org/", share::Held::Figure, &text).unwrap();
        let followed = share::text_in(&link).unwrap().unwrap();
        let (again, linked) = (read::parse(&text).unwrap(), read::parse_bytes(&followed).unwrap());
        prop_assert_eq!(&again, &figure);
        prop_assert_eq!(Shot::of(&again), Shot::of(&figure));
        for view in View::ALL {
            // Digits that the operations know beyond the file make no difference, however little of them pixels could
            // show.
            let scene = scene(&figure);
            let of_file = request(&Camera::new(&again.camera).unwrap(), &again, view, &scene);
            prop_assert!(request(&camera, &figure, view, &scene) == of_file, "{view:?}");
            let one = picture_by(&camera, &figure, view, &mut Renderer::default());
            // Whatever a renderer has drawn before.
            let mut used = Renderer::default();
            picture(&Figure { show: Show::default(), ..figure.clone() }, view, &mut used);
            prop_assert!(one == picture(&linked, view, &mut used), "{view:?}");
        }
    }

    #[test]
    fn settings_of_other_pictures_change_nothing_in_this_one(show in shows(), other in shows()) {
        let mut renderer = Renderer::default();
        for view in View::ALL {
            let mixed = with_others(&show, view, &other);
            let [one, beside] = [&show, &mixed].map(|show| house(show.clone()));
            let [seen, again] = [&one, &beside].map(|figure| Shot::of(figure).seen_in(view));
            prop_assert_eq!(seen.seen_in(view), seen);
            prop_assert_eq!(again.seen_in(view), again);
            prop_assert!(picture(&one, view, &mut renderer) == picture(&beside, view, &mut renderer), "{view:?}: {mixed:?}");
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
    let plain = View::ALL.map(|view| picture(&house(bare.clone()), view, &mut renderer));
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
            let drawn = picture(&house(show.clone()), view, &mut renderer);
            assert_eq!(drawn != *plain, shows, "{key} = {value} in {view:?}");
        }
        assert_eq!(show_with(&show, key, "").unwrap(), bare, "{key}");
    }
}

#[test]
fn impossible_shows_are_refused_with_line_key_and_allowed_values() {
    for (text, parts) in [
        ("stage = \"clipp\"", &["line 2", "[show] stage", "\"clipp\"", "\"clip\""][..]),
        ("painted = 1.5", &["line 2", "[show] painted", "0", "1"]),
        ("step = { at = 99 }", &["line 2", "[show] step.at", "from 0 to 4"]),
        ("step = { way = \"notes\", at = -1 }", &["[show] step.at", "-1"]),
        ("step = { way = \"notes\", at = 99.0 }", &["line 2", "[show] step.at", "99", "from 0 to 4"]),
        ("step = { way = \"box\", at = 5.5 }", &["line 2", "[show] step.at", "5.5", "from 0 to 5"]),
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
        let said = camera_lab_words::messages::figure(Lang::En, &error);
        for part in parts {
            assert!(said.contains(part), "{text}: {said} lacks {part}");
        }
        let said = camera_lab_words::messages::figure(Lang::PtBr, &error);
        assert!(said.contains("linha"), "{said}");
    }
}

/// The output of `render` is the same from a file, from a link, from the PNG that it wrote, and from arguments.
#[test]
fn render_draws_the_show_table_and_arguments_override_it() {
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
    let link = share::link("", share::Held::Figure, shown).unwrap();
    assert!(from_file == render(&[&link], "d.png"));
    assert!(from_file != render(&["plain.toml"], "e.png"));
    assert!(
        render(&["shown.toml", "--show", "stage=", "--show", "probe="], "f.png") == render(&["plain.toml"], "g.png")
    );
}

#[test]
fn impossible_show_arguments_are_refused() {
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

/// The pictures are drawn from values that a file can hold: digits that operations know beyond it make no difference
/// between screen and file.
#[test]
fn after_a_hundred_operations_the_file_draws_the_same_pixels() {
    let bench = Bench::new("shot-operations");
    let begun = house(Show::default());
    let turn = Angle::from_degrees(7.3);
    let operations: Vec<Operation> =
        (0..100).map(|k| if k % 2 == 0 { Operation::Azimuth(turn) } else { Operation::Elevation(turn) }).collect();
    let camera = operated(Camera::new(&begun.camera).unwrap(), &operations);
    assert_ne!(camera, camera.rounded(), "it knows more than its parameters");
    let figure = Figure { camera: *camera.parameters(), ..begun.clone() };
    bench.write("begun.toml", write::to_toml(&begun));
    bench.write("saved.toml", write::to_toml(&figure));
    let operations: Vec<String> = operations.iter().flat_map(|each| ["--op".to_owned(), each.to_string()]).collect();
    let operations: Vec<&str> = operations.iter().map(String::as_str).collect();
    for view in View::ALL {
        let render = |arguments: &[&str]| {
            let size = ["--view", view.name(), "--size", "96x72", "--scale", "1", "--lang", "en", "-o", "a.png"];
            bench.run(&[&["render"], arguments, &size].concat()).done();
            pixels(&bench.read("a.png"))
        };
        let drawn = picture_by(&camera, &figure, view, &mut Renderer::default());
        let saved = render(&["saved.toml"]);
        let opaque: Vec<u8> = drawn.rgba().chunks(4).flat_map(|pixel| &pixel[..3]).copied().collect();
        assert!((96, 72, opaque) == saved, "{view:?}");
        assert!(render(&[&["begun.toml"], &operations[..]].concat()) == saved, "{view:?}");
    }
}

#[test]
fn pictures_are_a_list_a_second_observer_and_a_stereo_pair_are_entries_of_it() {
    let figure = house(Show::default());
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
    let beside_others = |request: &Request| {
        let finish = Finish { framed: true, ..request.finish };
        Request { finish, ..request.clone() }
    };
    for (i, (request, alone)) in composite.requests.iter().zip(alone.iter().map(beside_others)).enumerate() {
        assert_eq!(*request, alone);
        let pixels = renderer.pixels(&alone).unwrap();
        let rows = whole.rgba().chunks_exact(4 * whole.width() as usize).map(|row| &row[4 * 100 * i..][..4 * 96]);
        assert!(rows.zip(pixels.rgba().chunks_exact(4 * 96)).all(|(ours, own)| ours == own), "picture {i}");
    }
    // The file has room for one of each kind.
    assert_eq!(Picture::observers(&shot.pictures), Observers::default());
}
