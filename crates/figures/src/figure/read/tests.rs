#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use glam::DVec3;

use super::*;
use crate::camera::{Projection, ViewWindow, Viewport};
use crate::figure::error::Allowed;
use crate::figure::{Arrangement, Depth, Outside, Reveal, Screen, ShadowReveal};
use crate::scene::{Light, Preset, SceneError, Shape};

/// The error of `text` as line, key and problem.
fn error(text: &str) -> (usize, String, Problem) {
    let error = parse(text).unwrap_err();
    (error.line, error.key, error.problem)
}

/// Line and key of the error of `text`.
fn place(text: &str) -> (usize, String) {
    let (line, key, _) = error(text);
    (line, key)
}

#[test]
fn the_empty_file_is_the_default_figure() {
    for text in [
        "",
        "\u{feff}",
        "\n\n",
        "# nothing\r\n",
        "[camera]\n[image]\n[viewport]\n[scene]\n[style]\n[reveal]\n[world]\n[observers]\n",
    ] {
        assert_eq!(parse(text), Ok(Figure::default()), "{text:?}");
    }
}

#[test]
fn every_key_is_read() {
    let figure = parse(
        r##"
        title = "A house"
        caption = { en = "By the sea.", "pt-BR" = "À beira-mar." }
        [camera]
        position = [1, -2.5, 3e150]
        focal_point = [0.5, 0, 0]
        view_up = [0, 0, 1]
        projection = "parallel"
        view_angle = 60
        height = 3.5
        aspect = 2
        near = 0.25
        far = 1e15
        window = { left = -2, right = 1.5, bottom = -1, top = 3 }
        [image]
        width = 640
        height = 480
        [viewport]
        x = -3
        depth_near = 1.0
        depth_far = 0
        [scene]
        preset = "house"
        [[scene.objects]]
        name = "lamp"
        shape = "cone"
        parent = "table"
        translate = [0, 1, 0]
        rotate = [0, 30, 0]
        scale = [1, 2, 1]
        color = "#4477aa80"
        segments = 3
        [[scene.objects]]
        name = "table"
        [[scene.objects]]
        name = "way"
        shape = "segments"
        points = [[0, 0, 0], [1, 0, 0]]
        [[scene.objects]]
        shape = "mesh"
        path = "bunny.obj"
        [[scene.lights]]
        kind = "point"
        position = [1, 2, 3]
        [[points]]
        name = "P"
        position = ["sqrt(2)/2", 2, -1]
        [[points]]
        name = "Q"
        position = [0, 0, 0]
        [style]
        shading = "gouraud"
        visibility = "painter"
        hidden_lines = "shown"
        antialias = 16
        theme = "print"
        [reveal]
        depth = "linear"
        outside = "tinted"
        clipping = true
        divide_first = true
        culled = true
        vanishing = true
        single_precision = true
        shadows = "acne"
        [world]
        section = true
        window_opacity = 0.25
        axes_length = 2.5
        [observers.world]
        target = [1, 1, 1]
        distance = 7
        azimuth = -400
        elevation = 90
        projection = "parallel"
        [screen]
        pictures = ["image", "world"]
        arrangement = "beside"
        panel = "none"
        "##,
    )
    .unwrap();
    assert_eq!(figure.camera.position, DVec3::new(1.0, -2.5, 3e150));
    assert_eq!(figure.camera.projection, Projection::Parallel);
    assert_eq!((figure.camera.near, figure.camera.far), (0.25, 1e15));
    assert_eq!(figure.camera.window, Some(ViewWindow { left: -2.0, right: 1.5, bottom: -1.0, top: 3.0 }));
    assert_eq!(
        figure.viewport,
        Some(Viewport { x: -3, y: 0, width: 640, height: 480, depth_near: 1.0, depth_far: 0.0 })
    );
    assert_eq!(figure.scene.preset, Preset::House);
    let names: Vec<_> = figure.scene.objects.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["lamp", "table", "way", "object 4"]);
    assert_eq!(figure.scene.objects[0].segments, 3);
    assert_eq!(figure.scene.objects[1].shape, None);
    assert_eq!(figure.scene.objects[2].shape, Some(Shape::Segments(vec![[DVec3::ZERO, DVec3::X]])));
    assert_eq!(figure.scene.lights, [Light::point(DVec3::new(1.0, 2.0, 3.0))]);
    let points: Vec<_> = figure.points.iter().map(|p| (p.name.as_str(), p.position)).collect();
    assert_eq!(points, [("P", DVec3::new(0.5_f64.sqrt(), 2.0, -1.0)), ("Q", DVec3::ZERO)]);
    assert_eq!(figure.style.antialias, crate::appearance::Samples::Sixteen);
    let all = Reveal {
        depth: Depth::Linear,
        outside: Outside::Tinted,
        clipping: true,
        divide_first: true,
        culled: true,
        vanishing: true,
        single_precision: true,
        texture: None,
        shadows: Some(ShadowReveal::Acne),
        cost: None,
    };
    assert_eq!(figure.reveal, all);
    let world = figure.observers.world.unwrap();
    assert_eq!((world.distance, world.azimuth, world.parallel), (7.0, -400.0, true));
    assert_eq!(figure.observers.canonical, None);
    assert_eq!(figure.title.unwrap().pt_br, "A house");
    assert_eq!(figure.caption, Some(["By the sea.", "À beira-mar."].map(str::to_owned).into()));
    let arrangement = Some(Some(Arrangement::Beside));
    assert_eq!(
        figure.screen,
        Screen { pictures: Some([true, false, true]), arrangement, panel: Some(None), entry: None }
    );
}

#[test]
fn titles_and_screens_are_refused_with_their_line() {
    for (text, at, key) in [
        ("\ntitle = 3".to_owned(), 2, "title"),
        (format!("title = \"{}\"", "é".repeat(121)), 1, "title"),
        (format!("title = \"{}\"\ncaption = {{ en = \"{}\" }}", "é".repeat(120), "a".repeat(601)), 2, "caption"),
        ("caption = \"two\\nlines\"".to_owned(), 1, "caption"),
        ("caption = { en = \"a\", pt = \"b\" }".to_owned(), 1, "caption"),
        ("[screen]\npictures = []".to_owned(), 2, "[screen] pictures"),
        ("[screen]\n\npictures = [\"wrold\"]".to_owned(), 3, "[screen] pictures"),
        ("[screen]\narrangement = \"rows\"".to_owned(), 2, "[screen] arrangement"),
        ("[screen]\npanel = true".to_owned(), 2, "[screen] panel"),
        ("[screen]\nentry = { matrix = \"projektion\" }".to_owned(), 2, "[screen] entry.matrix"),
        ("[screen]\nentry = { matrix = \"view\", row = 5 }".to_owned(), 2, "[screen] entry.row"),
        ("[screen]\nentry = { row = 3 }".to_owned(), 2, "[screen] entry.matrix"),
        ("title = \"\u{202e}eltit\"".to_owned(), 1, "title"),
    ] {
        assert_eq!(place(&text), (at, key.to_owned()), "{text}");
    }
}

#[test]
fn there_are_at_most_32_points() {
    let text = |count: usize| -> String {
        (0..count).map(|i| format!("[[points]]\nname = \"{i}\"\nposition = [{i}, 0, 0]\n")).collect()
    };
    assert_eq!(parse(&text(32)).unwrap().points.len(), 32);
    let (line, key, problem) = error(&text(34));
    assert_eq!((line, key.as_str()), (97, "[[points]]"));
    assert_eq!(problem, Problem::TooMany { count: 34, limit: 32 });
}

#[test]
fn listed_objects_stand_alone_unless_a_preset_is_named() {
    let list = "objects = [{ shape = \"box\" }]";
    assert_eq!(parse(&format!("[scene]\n{list}")).unwrap().scene.preset, Preset::Empty);
    assert_eq!(parse(&format!("[scene]\npreset = \"cube\"\n{list}")).unwrap().scene.preset, Preset::Cube);
}

#[test]
fn every_form_of_toml_will_do() {
    let expected = parse("[camera]\nnear = 2\nwindow = { left = -1, right = 1, bottom = -1, top = 2 }").unwrap();
    for text in [
        "camera.near = 2\ncamera.window.left = -1\ncamera.window.right = 1\ncamera.window.bottom=-1\ncamera.window.top=2",
        "camera = { near = 2.0, window = { left = -1, right = 1, bottom = -1, top = 2 } }",
        "[camera.window]\r\nleft = -1\r\nright = 1\r\nbottom = -1\r\ntop = 2\r\n[camera]\r\nnear = 0x2\r\n",
    ] {
        assert_eq!(parse(text).as_ref(), Ok(&expected), "{text:?}");
    }
}

#[test]
fn wrong_values_are_refused_with_line_key_and_allowed_values() {
    let (line, key, problem) = error("\n[camera]\nposition = \"abc\"");
    assert_eq!((line, key.as_str()), (3, "[camera] position"));
    assert_eq!(problem, Problem::Value { found: "\"abc\"".into(), allowed: Allowed::Vector });
    for (text, key, line) in [
        ("[camera]\nposition = [1, 2]", "[camera] position", 2),
        ("[camera]\nposition = [1, 2, 3, 4]", "[camera] position", 2),
        ("[camera]\nposition = [1, nan, 3]", "[camera] position", 2),
        ("[camera]\nfar = inf", "[camera] far", 2),
        ("[camera]\nfar = -nan", "[camera] far", 2),
        ("[camera]\nfar = 1979-05-27", "[camera] far", 2),
        ("[camera]\nprojection = \"oblique\"", "[camera] projection", 2),
        ("[camera]\nprojection = 1", "[camera] projection", 2),
        ("[camera]\nwindow = { left = -1, right = 1, bottom = -1 }", "[camera] window.top", 2),
        ("[camera]\nwindow = 3", "[camera] window", 2),
        ("[camera]\nwindow = { left = -1, right = 1, bottom = -1, top = 1, up = 3 }", "[camera] window.up", 2),
        ("camera = 3", "camera", 1),
        ("[[camera]]\nnear = 1", "camera", 1),
        ("[image]\nwidth = 640.0", "[image] width", 2),
        ("[image]\nwidth = 0", "[image] width", 2),
        ("[image]\nwidth = 16385", "[image] width", 2),
        ("[image]\nheight = -1", "[image] height", 2),
        ("[image]\nheight = 9223372036854775807", "[image] height", 2),
        ("[viewport]\nwidth = 0", "[viewport] width", 2),
        ("[viewport]\ndepth_far = 1.5", "[viewport] depth_far", 2),
        ("[style]\nantialias = 3", "[style] antialias", 2),
        ("[style]\nantialias = \"4\"", "[style] antialias", 2),
        ("[style]\ntheme = \"sepia\"", "[style] theme", 2),
        ("[reveal]\ndepth = 1", "[reveal] depth", 2),
        ("[reveal]\n\ndepth = \"linaer\"", "[reveal] depth", 3),
        ("[reveal]\noutside = true", "[reveal] outside", 2),
        ("[reveal]\noutside = \"hidden\"", "[reveal] outside", 2),
        ("[reveal]\nclipping = \"yes\"", "[reveal] clipping", 2),
        ("[reveal]\nshadows = true", "[reveal] shadows", 2),
        ("[reveal]\nculled = 1", "[reveal] culled", 2),
        ("reveal = true", "reveal", 1),
        ("[scene]\npreset = \"teapot\"", "[scene] preset", 2),
        ("[[scene.objects]]\nshape = \"box\"\nsegments = 2", "[[scene.objects]] segments", 3),
        ("[[scene.objects]]\nshape = \"box\"\nsegments = 513", "[[scene.objects]] segments", 3),
        ("[[scene.objects]]\nname = \"\"", "[[scene.objects]] name", 2),
        ("[[scene.objects]]\nscale = [1, 0, 1]", "[[scene.objects]] scale", 2),
        ("[[scene.objects]]\ncolor = \"red\"", "[[scene.objects]] color", 2),
        ("[[scene.objects]]\n\nshape = \"mesh\"", "[[scene.objects]] path", 1),
        ("[[scene.objects]]\nshape = \"points\"\npoints = [[1, 2]]", "[[scene.objects]] points", 3),
        ("[[scene.objects]]\nshape = \"segments\"\npoints = [[1, 2, 3]]", "[[scene.objects]] points", 3),
        ("[scene]\nobjects = [1]", "[scene] objects", 2),
        ("[[scene.lights]]\ndirection = [0, 1, 0]", "[[scene.lights]] kind", 1),
        ("[[scene.lights]]\nkind = \"directional\"\ndirection = [0, 0, 0]", "[[scene.lights]] direction", 3),
        ("[[scene.lights]]\nkind = \"point\"\ndirection = [0, 1, 0]", "[[scene.lights]] direction", 3),
        ("[[scene.lights]]\nkind = \"point\"\nshadows = 1", "[[scene.lights]] shadows", 3),
        ("[[scene.lights]]\nkind = \"point\"\nshadow_map = 63", "[[scene.lights]] shadow_map", 3),
        ("[[scene.lights]]\nkind = \"point\"\nshadow_map = 4097", "[[scene.lights]] shadow_map", 3),
        ("[[scene.lights]]\nkind = \"point\"\nshadow_bias = -1", "[[scene.lights]] shadow_bias", 3),
        ("[[scene.lights]]\nkind = \"point\"\nshadow_softness = 8.1", "[[scene.lights]] shadow_softness", 3),
        ("[[points]]\nposition = [1, 2, 3]", "[[points]] name", 1),
        ("[[points]]\nname = \"P\"", "[[points]] position", 1),
        ("[[points]]\nposition = [1, 2, 3]\nname = \"\"", "[[points]] name", 3),
        ("[[points]]\nname = \"P\"\nposition = [1, 2]", "[[points]] position", 3),
        ("[[points]]\nname = \"P\"\nposition = [1, inf, 2]", "[[points]] position", 3),
        ("[[points]]\nname = \"P\"\nposition = [1, 2, 3]\ncolor = \"#fff\"", "[[points]] color", 4),
        (
            "[[points]]\nname = \"P\"\nposition = [1, 2, 3]\n[[points]]\nposition = [1, 2, 3]\nname = \"P\"",
            "[[points]] name",
            6,
        ),
        ("[points]\nname = \"P\"", "points", 1),
        ("points = 3", "points", 1),
        ("[world]\nwindow_opacity = 1.5", "[world] window_opacity", 2),
        ("[world]\naxes_length = 5", "[world] axes_length", 2),
        ("[world]\n\ndimensions = 1", "[world] dimensions", 3),
        ("[world]\nsections = true", "[world] sections", 2),
        ("[observers.world]\ndistance = 0", "[observers.world] distance", 2),
        ("[observers.world]\nelevation = 91", "[observers.world] elevation", 2),
    ] {
        assert_eq!(place(text), (line, key.to_owned()), "{text:?}");
    }
}

#[test]
fn unknown_keys_lead_to_the_near_one() {
    let near = |text: &str| match error(text).2 {
        Problem::UnknownKey { near, .. } | Problem::Value { allowed: Allowed::Word { near, .. }, .. } => near,
        other => panic!("{other:?}"),
    };
    assert_eq!(near("[camera]\nfov = 45").as_deref(), Some("view_angle"));
    assert_eq!(near("[camera]\neye = [1, 2, 3]").as_deref(), Some("position"));
    assert_eq!(near("fov = 45").as_deref(), Some("[camera] view_angle"));
    assert_eq!(near("[camra]\nnear = 1").as_deref(), Some("camera"));
    assert_eq!(near("[image]\ntheme = \"dark\"").as_deref(), Some("[style] theme"));
    assert_eq!(near("[scene]\npreset = \"huose\"").as_deref(), Some("house"));
    assert_eq!(near("[camera]\nprojection = \"orthographic\"").as_deref(), Some("parallel"));
    assert_eq!(near("[reveal]\nculling = true").as_deref(), Some("culled"));
    assert_eq!(near("[style]\ndivide_first = true").as_deref(), Some("[reveal] divide_first"));
    assert_eq!(near("[screen]\npanel = \"depht\"").as_deref(), Some("depth"));
    assert_eq!(near("[screen]\nlayout = \"row\"").as_deref(), Some("arrangement"));
    assert_eq!(near("panel = \"depth\"").as_deref(), Some("[screen] panel"));
    assert_eq!(near("[camera]\nbanana = 1"), None);
}

#[test]
fn switches_are_on_off_or_a_word() {
    let depth = |text: &str| parse(&format!("[reveal]\ndepth = {text}")).unwrap().reveal.depth;
    assert_eq!([depth("true"), depth("false"), depth("\"linear\"")], [Depth::Stored, Depth::Off, Depth::Linear]);
    assert_eq!(parse("[reveal]\nclipping = false").unwrap(), Figure::default());
    let (_, _, problem) = error("[reveal]\ndepth = \"squared\"");
    let allowed = Allowed::SwitchOr(vec!["linear"]);
    assert_eq!(problem, Problem::Value { found: "\"squared\"".into(), allowed });
}

#[test]
fn an_unknown_preset_lists_all() {
    let Problem::Value { allowed: Allowed::Word { words, .. }, .. } = error("[scene]\npreset = \"teapot\"").2 else {
        panic!("another error");
    };
    assert_eq!(words.len(), 10);
    assert!(words.contains(&"ndc-cube"));
}

#[test]
fn the_first_fault_by_line_is_reported() {
    assert_eq!(place("[style]\ntheme = 3\n[camera]\nnear = \"x\""), (2, "[style] theme".into()));
    assert_eq!(place("[camera]\nview_up = [0, 0, 0]\nnaer = 3"), (2, "[camera] view_up".into()));
    assert_eq!(place("[viewport]\nx = 0.5\n[image]\nwidth = 0"), (2, "[viewport] x".into()));
}

#[test]
fn impossible_cameras_carry_the_line_of_a_key_that_is_there() {
    assert_eq!(place("[camera]\nposition = [0, 5, 0]"), (2, "[camera] position".into()));
    assert_eq!(place("[camera]\nposition = [0, 5, 0]\nview_up = [0, 1, 0]"), (3, "[camera] view_up".into()));
    assert_eq!(place("[camera]\n\nview_up = [0, 0, 0]"), (3, "[camera] view_up".into()));
    assert_eq!(place("[camera]\nfocal_point = [3, 4, 5]"), (2, "[camera] focal_point".into()));
}

#[test]
fn trees_are_checked() {
    let object = |name: &str, parent: &str| format!("[[scene.objects]]\nname = \"{name}\"\nparent = \"{parent}\"\n");
    let twice = "[[scene.objects]]\nname = \"a\"\n".repeat(2);
    let scene = |error, near| Problem::Scene { error: Box::new(error), near };
    let problem = scene(SceneError::DuplicateName { name: "a".into() }, None);
    assert_eq!(error(&twice), (4, "[[scene.objects]] name".into(), problem));
    let orphan = "[[scene.objects]]\nname = \"lamp\"\n".to_owned() + &object("shade", "lmap");
    let problem = scene(SceneError::UnknownParent { name: "shade".into(), parent: "lmap".into() }, Some("lamp".into()));
    assert_eq!(error(&orphan), (5, "[[scene.objects]] parent".into(), problem));
    let chain = |names: &[&str]| SceneError::Cycle { chain: names.iter().map(ToString::to_string).collect() };
    assert_eq!(error(&object("a", "a")).2, scene(chain(&["a", "a"]), None));
    let cycle = object("x", "a") + &object("a", "b") + &object("b", "c") + &object("c", "a");
    let (line, key, problem) = error(&cycle);
    assert_eq!((line, key.as_str()), (6, "[[scene.objects]] parent"));
    assert_eq!(problem, scene(chain(&["a", "b", "c", "a"]), None));
    let far = "[[scene.objects]]\nname = \"a\"\nscale = [1e200, 1, 1]\n".to_owned()
        + "[[scene.objects]]\nname = \"b\"\nparent = \"a\"\ntranslate = [1e200, 0, 0]\n";
    let problem = scene(SceneError::NotFinite { name: "b".into(), key: "parent" }, None);
    assert_eq!(error(&far), (6, "[[scene.objects]] parent".into(), problem));
    let chain: String = (0..20_000).map(|i| object(&format!("o{i}"), &format!("o{}", i + 1))).collect();
    let whole = chain + "[[scene.objects]]\nname = \"o20000\"\n";
    assert_eq!(parse(&whole).unwrap().scene.objects.len(), 20_001);
}

#[test]
fn a_preset_has_names_too() {
    let name = crate::scene::preset_objects(Preset::House, &crate::scene::palette::SceneColors::of(Default::default()))
        [0]
    .name
    .clone();
    let child = format!("[scene]\npreset = \"house\"\n[[scene.objects]]\nname = \"a\"\nparent = {name:?}");
    assert!(parse(&child).is_ok());
    let twin = format!("[scene]\npreset = \"house\"\n[[scene.objects]]\nname = {name:?}");
    assert!(parse(&twin).is_ok(), "the preset's own does not count");
}

#[test]
fn objects_are_found_by_their_names() {
    let text = "[scene]\n\n[[scene.objects]]\nshape = \"box\"\n[[scene.objects]]\nname = \"lamp\"";
    assert_eq!(line_of_object(text, "object 1", "path"), Some(3));
    assert_eq!(line_of_object(text, "object 1", "shape"), Some(4));
    assert_eq!(line_of_object(text, "lamp", "name"), Some(6));
    assert_eq!(line_of_object(text, "moon", "name"), None);
}

#[test]
fn syntax_errors_name_line_and_key() {
    for (text, line, key) in [
        ("[camera]\nposition = [3.0, 4.0\nfocal_point = [1, 2, 3]\n", 2, "[camera] position"),
        ("[camera\nnear = 1", 1, ""),
        ("[camera]\nnear = abc\n", 2, "[camera] near"),
        ("[camera]\nnear =\nfar = 3", 2, "[camera] near"),
        ("[camera]\nnear\nfar = 3", 2, "[camera] near"),
        ("[camera]\nnear = 1,5\n", 2, "[camera] near"),
        ("[camera]\nnear = 1e400\n", 2, "[camera] near"),
        ("[camera]\nnear = 99999999999999999999999\n", 2, "[camera] near"),
        ("[camera]\r\nnear = 1.0.0\r\n", 2, "[camera] near"),
        ("[camera]\nposition = [\n 1,\n 2 3\n]", 4, "[camera] position"),
        ("[camera]\nnear = 0.1\n\"lost", 3, "[camera]"),
        ("[camera]\nposition = [1, # [\n 2\n 3]", 3, "[camera] position"),
        ("near = 1\0\n", 1, "near"),
        ("[camera]\nname = \"abc\nfar = 3", 2, "[camera] name"),
    ] {
        let (found_line, found_key, problem) = error(text);
        assert_eq!((found_line, found_key.as_str()), (line, key), "{text:?}");
        assert!(matches!(problem, Problem::Syntax { .. }), "{problem:?}");
    }
}

#[test]
fn duplicate_keys_are_named() {
    assert_eq!(error("[camera]\nnear = 1\nnear = 2\n"), (3, "[camera] near".into(), Problem::Duplicate));
    assert_eq!(error("[camera]\nnear = 1\n[camera]\nfar = 2\n"), (3, "[camera]".into(), Problem::Duplicate));
    assert_eq!(error("a.b = 1\na.b = 2\n").2, Problem::Duplicate);
}

#[test]
fn deep_nesting_is_an_error_not_a_crash() {
    let dots = vec!["a"; 30_000].join(".");
    for text in [
        format!("a = {}", "[".repeat(30_000)),
        format!("a = {}1{}", "[".repeat(5000), "]".repeat(5000)),
        format!("a = {}", "{a=".repeat(30_000)),
        format!("{dots} = 1"),
        format!("[{dots}]"),
        format!("[[{dots}]]"),
    ] {
        assert!(parse(&text).is_err());
    }
}

#[test]
fn bytes_that_are_not_text_are_refused_with_their_line() {
    let error = parse_bytes(b"[camera]\nnear = 1 # \xe1\n").unwrap_err();
    assert_eq!((error.line, error.problem), (2, Problem::NotUtf8 { byte: 0xe1 }));
    assert!(parse_bytes(&vec![b'\n'; MAX_FIGURE_BYTES + 1]).is_err());
    assert_eq!(parse_bytes(b"\xef\xbb\xbf[camera]\r\n"), Ok(Figure::default()));
}

#[test]
fn found_values_are_shown_in_one_short_line() {
    let text = format!("[camera]\nposition = [\n  1,\n\n  \"{}\\u0007\"\n]", "x".repeat(1000));
    let Problem::Value { found, .. } = error(&text).2 else { panic!("another error") };
    assert_eq!(found, format!("[ 1, \"{}…", "x".repeat(34)));
}

proptest::proptest! {
    #[test]
    fn no_text_makes_it_panic(bytes in proptest::collection::vec(proptest::num::u8::ANY, 0..200)) {
        let _ = parse_bytes(&bytes);
    }

    #[test]
    fn no_figure_with_a_changed_piece_makes_it_panic(at in 0_usize..700, length in 0_usize..20, new in "\\PC{0,6}|[\\[\\]{}\"=\n,.#]{0,6}") {
        let text = crate::figure::write::to_toml(&Figure::default());
        let at = at.min(text.len());
        let end = (at + length).min(text.len());
        let _ = parse(&format!("{}{new}{}", &text[..at], &text[end..]));
    }
}

#[test]
fn numbers_may_be_written_as_expressions() {
    let figure = parse(
        r#"
        [camera]
        position = ["sqrt(2)/2", 0, "1/3"]
        view_angle = "2*atan(1/2) rad"
        aspect = "16/9"
        near = "0,5"
        [[scene.objects]]
        shape = "points"
        points = [["cos(60°)", 0, "2e3"]]
        rotate = ["pi/6", "45°", 10]
        [observers.world]
        azimuth = "360/8"
        "#,
    )
    .unwrap();
    let p = figure.camera;
    assert_eq!(p.position, DVec3::new(std::f64::consts::SQRT_2 / 2.0, 0.0, 1.0 / 3.0));
    assert!((p.view_angle - 53.130_102_354_155_98).abs() < 1e-13);
    assert_eq!((p.aspect, p.near), (16.0 / 9.0, 0.5));
    assert_eq!(figure.scene.objects[0].shape, Some(Shape::Points(vec![DVec3::new(0.5, 0.0, 2000.0)])));
    assert_eq!(figure.scene.objects[0].rotate, DVec3::new(30.0, 45.0, 10.0));
    assert_eq!(figure.observers.world.unwrap().azimuth, 45.0);
}

#[test]
fn a_bad_expression_is_named_with_its_place() {
    for (text, line, key, problem, at) in [
        ("[camera]\nview_angle = \"2*atn(1/2)\"", 2, "[camera] view_angle", "unknown name “atn”", "2*▸atn◂(1/2)"),
        ("[camera]\nnear = \"45°\"", 2, "[camera] near", "do not mix", "▸45°◂"),
        ("\n[camera]\nposition = [1, \"(2\", 3]", 3, "[camera] position", "is missing", "(2▸◂"),
        ("[observers.world]\ndistance = \"1/0\"", 2, "[observers.world] distance", "not a finite number", "▸1/0◂"),
        ("[camera]\nfar = \"\"", 2, "[camera] far", "a number is missing", "▸◂"),
    ] {
        let error = parse(text).unwrap_err();
        assert_eq!((error.line, error.key.as_str()), (line, key));
        assert!(matches!(error.problem, Problem::Expression { .. }), "{error}");
        let message = error.to_string();
        assert!(message.contains(problem) && message.contains(at), "{message}");
    }
    // Values are checked against the limits like any number.
    let (_, key, problem) = error("[observers.world]\nelevation = \"100°\"");
    assert_eq!(key, "[observers.world] elevation");
    assert_eq!(problem, Problem::Value { found: "\"100°\"".to_owned(), allowed: Allowed::NumberIn(-90.0, 90.0) });
    assert_eq!(place("[image]\nwidth = \"640\""), (2, "[image] width".to_owned()), "whole numbers are digits");
}

#[test]
fn very_many_unknown_parents_take_the_time_of_reading_them() {
    let figure = |parent: &dyn Fn(usize) -> String| -> String {
        (0..5000).map(|i| format!("[[scene.objects]]\nname = \"object {i}\"\n{}", parent(i))).collect()
    };
    let begin = std::time::Instant::now();
    assert!(parse(&figure(&|_| "color = \"#123456\"\n".to_owned())).is_ok());
    let reading = begin.elapsed();
    let begin = std::time::Instant::now();
    let (line, key, _) = error(&figure(&|i| format!("parent = \"objekt {i}\"\n")));
    assert_eq!((line, key.as_str()), (3, "[[scene.objects]] parent"));
    // Comparing every unknown name with all known ones would take hundreds of times as long.
    assert!(begin.elapsed() < 20 * reading, "{:?}, {reading:?} without a fault", begin.elapsed());
}
