//! One figure in two ways in one picture: the sides, and the formats of depths, which are worth comparing.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;

use camera_lab::camera::Camera;
use camera_lab::figure::variation::VariedValue;
use camera_lab::figure::{Comparison, Figure, Show, View, read, varied, words, write};
use camera_lab::picture::{Pixels, Renderer};
use camera_lab::progress::at_once;
use camera_lab::text::runs;
use camera_lab::views::{Finish, Request, Size, caption, overlay};
use camera_lab_files::share;
use camera_lab_words::{Lang, messages, pictures::labels};

use crate::cli::pixels;
use crate::common::program::Bench;
use crate::common::shot::{house, scene};

const SIZE: Size = Size { width: 240, height: 180, scale: 1.0 };
/// Rows from the top without headings, and columns beside the wiper without its line.
const BELOW_HEADINGS: usize = 40;
const BESIDE_LINE: usize = 4;

fn compared(comparison: Comparison) -> Figure {
    Figure { compare: Some(comparison), ..house(Show::default()) }
}

fn request(figure: &Figure, view: View) -> Request {
    let camera = Camera::new(&figure.camera).unwrap();
    Request::of(figure, view, &camera, &scene(figure), labels(Lang::En), SIZE)
}

fn drawn(request: &Request) -> Pixels {
    Renderer::default().pixels(request).unwrap()
}

/// The columns of a picture, below the headings and above the count.
fn columns(picture: &Pixels, columns: std::ops::Range<usize>) -> Vec<u8> {
    let rows = picture.rgba().chunks_exact(4 * picture.width() as usize);
    let rows = rows.skip(BELOW_HEADINGS).take(100);
    rows.flat_map(|row| &row[4 * columns.start..4 * columns.end]).copied().collect()
}

#[test]
fn left_of_the_wiper_is_one_picture_and_right_of_it_the_other() {
    let mut renderer = Renderer::default();
    for (key, value) in [
        ("style.visibility", "\"painter\""),
        ("style.hidden_lines", "\"shown\""),
        ("camera.projection", "\"parallel\""),
        ("camera.view_angle", "80"),
    ] {
        for wiper in [0.0, 0.25, 0.5, 1.0] {
            let figure = compared(Comparison { wiper, ..Comparison::of_key(key, value) });
            for view in View::ALL {
                let whole = request(&figure, view);
                let [own, other] = whole.sides().unwrap();
                assert_eq!(own.request.observer, other.request.observer, "one observer");
                let joined = renderer.pixels(&whole).unwrap();
                let varied = Figure { compare: None, ..varied(&figure, key, value).unwrap() };
                let right = drawn(&request(&varied, view).seen_by(other.request.observer));
                let left = drawn(&own.request);
                let at = own.columns.end as usize;
                let (before, after) = (0..at.saturating_sub(BESIDE_LINE), (at + BESIDE_LINE).min(240)..240);
                assert!(columns(&joined, before.clone()) == columns(&left, before), "{key} {view:?} {wiper}");
                assert!(columns(&joined, after.clone()) == columns(&right, after), "{key} {view:?} {wiper}");
            }
        }
    }
}

#[test]
fn hidden_lines_are_compared_except_for_marks_on_faces_and_grids() {
    let text = "[scene]\npreset = \"cube\"\n[[scene.objects]]\nname = \"g\"\nshape = \"grid\"\nscale = [3, 1, 3]\n\
        translate = [0, -0.5, 0]\n";
    let mut renderer = Renderer::default();
    let ways = ["dashed", "hidden", "shown"];
    for (own, other) in ways.iter().flat_map(|own| ways.map(|other| (own, other))).filter(|(own, other)| *own != other)
    {
        let figure = read::parse(&format!("{text}[style]\nhidden_lines = \"{own}\"\n")).unwrap();
        let value = format!("\"{other}\"");
        let comparison = Comparison { beside: true, ..Comparison::of_key("style.hidden_lines", &value) };
        let whole = request(&Figure { compare: Some(comparison), ..figure.clone() }, View::Image);
        let joined = renderer.pixels(&whole).unwrap();
        let [_, side] = whole.sides().unwrap();
        let alone = read::parse(&format!("{text}[style]\nhidden_lines = \"{other}\"\n")).unwrap();
        let alone = Request { size: side.request.size, ..request(&alone, View::Image) };
        let right = side.left as usize..SIZE.width as usize;
        assert!(columns(&joined, right) == columns(&drawn(&alone), 0..alone.size.width as usize), "{own} {other}");
    }
}

#[test]
fn each_side_is_the_picture_of_a_figure_with_the_other_value() {
    let other = compared(Comparison::of_key("camera.view_angle", "80"));
    let angled = varied(&house(Show::default()), "camera.view_angle", "80").unwrap();
    let [own, beside] = request(&other, View::Image).sides().unwrap();
    assert!(drawn(&own.request) == drawn(&request(&house(Show::default()), View::Image)));
    assert!(drawn(&beside.request) == drawn(&request(&angled, View::Image)));
    // Operations are done on the camera.
    let operated = Comparison { ops: vec!["azimuth=30".parse().unwrap()], ..Comparison::default() };
    let [_, after] = request(&compared(operated), View::Image).sides().unwrap();
    let turned = camera_lab::camera::Operation::Azimuth(camera_lab::geometry::Angle::from_degrees(30.0));
    let camera = Camera::new(&house(Show::default()).camera).unwrap();
    let camera = turned.apply(&camera, Default::default()).unwrap();
    assert_eq!(after.request.camera, camera.rounded());
}

#[test]
fn sides_are_headed_by_words_and_by_the_symbols_of_the_notes() {
    let words = |comparison: Comparison, lang| {
        let figure = compared(comparison);
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width: 800, ..SIZE };
        let request = Request::of(&figure, View::Image, &camera, &scene(&figure), labels(lang), size);
        let over = overlay(&request, &request.sides().unwrap(), &[], None).unwrap();
        over.labels.iter().map(|label| label.text.to_string()).collect::<Vec<_>>()
    };
    let turned = Comparison { with: Vec::new(), ops: vec!["azimuth=30".parse().unwrap()], ..Comparison::default() };
    assert_eq!(words(turned.clone(), Lang::En), ["before", "Azimuth 30°"]);
    assert_eq!(words(turned, Lang::PtBr), ["antes", "Azimute 30°"]);
    for (key, value, headings) in [
        ("style.visibility", "\"painter\"", ["depth buffer", "painter"]),
        ("reveal.clipping", "true", ["Vértices do recorte: não", "Vértices do recorte: sim"]),
        ("style.depth_format", "\"fixed-24\"", ["profundidade: f32 invertido", "profundidade: 24 bits"]),
        ("camera.near", "0.5", ["F = 3", "F = 0,5"]),
        ("camera.view_angle", "60.0", ["θ = 38°", "θ = 60°"]),
    ] {
        let lang = if headings[0].contains("buffer") { Lang::En } else { Lang::PtBr };
        assert_eq!(words(Comparison::of_key(key, value), lang), headings);
    }
}

#[test]
fn two_halves_have_a_whole_picture_each() {
    let figure = compared(Comparison { beside: true, ..Comparison::of_key("style.shading", "\"phong\"") });
    for view in View::ALL {
        let whole = request(&figure, view);
        let [own, other] = whole.sides().unwrap();
        assert_eq!([own.request.size.width, other.request.size.width, other.left], [118, 118, 122]);
        let joined = drawn(&whole);
        assert!(columns(&joined, 0..118) == columns(&drawn(&own.request), 0..118), "{view:?}");
        assert!(columns(&joined, 122..240) == columns(&drawn(&other.request), 0..118), "{view:?}");
    }
}

#[test]
fn both_boxes_of_two_conventions_show_and_equal_sides_do_not() {
    let figure = compared(Comparison::of_key("show.ndc", "\"direct3d\""));
    assert!(request(&figure, View::World).sides().is_none() && request(&figure, View::Image).sides().is_none());
    let [own, other] = request(&figure, View::Canonical).sides().unwrap();
    assert_ne!(own.request.shot.ndc, other.request.shot.ndc);
    let alone = request(&house(Show::default()), View::Canonical).seen_from().unwrap();
    let both = own.request.observer.unwrap();
    let direct3d = compared(Comparison::default());
    let direct3d = Figure { compare: None, show: other.request.shot.show.clone(), ..direct3d };
    let direct3d = Figure { show: Show { ndc: Some(other.request.shot.ndc), ..Show::default() }, ..direct3d };
    let third = request(&direct3d, View::Canonical).seen_from().unwrap();
    assert!(both.distance >= alone.distance.max(third.distance) - 1e-9, "{both:?} {alone:?} {third:?}");
    // A value that the figure has already.
    let same = compared(Comparison::of_key("style.shading", "\"flat\""));
    assert!(View::ALL.into_iter().all(|view| request(&same, view).sides().is_none()));
    assert!(drawn(&request(&same, View::Image)) == drawn(&request(&house(Show::default()), View::Image)));
}

#[test]
fn pixels_that_differ_are_marked_and_no_others() {
    let plain = Comparison { wiper: 1.0, ..Comparison::of_key("style.shading", "\"wireframe\"") };
    let marked = compared(Comparison { differences: true, ..plain.clone() });
    let [own, other] = request(&marked, View::Image).sides().unwrap();
    let [left, right] = [own, other].map(|side| columns(&drawn(&side.request), 0..230));
    let [unmarked, marked] =
        [&compared(plain), &marked].map(|figure| columns(&drawn(&request(figure, View::Image)), 0..230));
    assert!(unmarked == left);
    let mut differing = 0;
    let both = left.chunks(4).zip(right.chunks(4));
    for ((one, other), (before, after)) in both.zip(unmarked.chunks(4).zip(marked.chunks(4))) {
        let differs = one.iter().zip(other).any(|(a, b)| a.abs_diff(*b) > 8);
        assert_eq!(before != after, differs, "{one:?} {other:?} {after:?}");
        differing += usize::from(differs);
    }
    assert!(differing > 500, "{differing}");
}

/// The count in the image, as it is written in a picture of some size.
fn counted(figure: &Figure, size: Size) -> String {
    let camera = Camera::new(&figure.camera).unwrap();
    let request = Request::of(figure, View::Image, &camera, &scene(figure), labels(Lang::En), size);
    let mut picture = Pixels::default();
    let report = at_once(Renderer::default().pixels_into(&request, &mut picture)).unwrap();
    report.labels.iter().find(|label| label.name == "differ").unwrap().text.clone()
}

#[test]
fn the_count_of_pixels_is_that_of_the_image_in_every_size() {
    let other = "position = [4.0, 2.0, 6.0]";
    let with = vec![("camera.position".to_owned(), other.split_once("= ").unwrap().1.to_owned())];
    let beside = Comparison { with: with.clone(), differences: true, beside: true, ..Comparison::default() };
    let figure = compared(beside.clone());
    // The two images as anyone makes them, pixel by pixel.
    let image = figure.image;
    let own = Size { width: image.width, height: image.height, scale: 1.0 };
    let finish = Finish { bare: true, ..Finish::default() };
    let pictures =
        [house(Show::default()), varied(&house(Show::default()), &with[0].0, &with[0].1).unwrap()].map(|figure| {
            let camera = Camera::new(&figure.camera).unwrap();
            let request = Request::of(&figure, View::Image, &camera, &scene(&figure), labels(Lang::En), own);
            drawn(&Request { finish, ..request })
        });
    let [one, two] = pictures.each_ref().map(|picture| picture.rgba().chunks(4));
    let differing = one.zip(two).filter(|(one, two)| one.iter().zip(*two).any(|(a, b)| a.abs_diff(*b) > 8)).count();
    let share = 100.0 * differing as f64 / f64::from(image.width * image.height);
    assert!((1.0..99.0).contains(&share), "{share}");
    let expected = format!("{}: {} %", labels(Lang::En).differ, Lang::En.mark().number(share, 3));
    for (width, height, beside) in [(240, 180, true), (640, 200, true), (300, 700, false), (900, 240, false)] {
        let figure = compared(Comparison { beside, ..figure.compare.clone().unwrap() });
        assert_eq!(counted(&figure, Size { width, height, scale: 1.0 }), expected, "{width} × {height}");
    }
}

#[test]
fn a_camera_of_another_figure_is_compared_whole() {
    let of = |text: &str| read::parse(text).unwrap();
    let figures = [
        of("[camera]\nposition = [1, 2, 3]\nview_angle = 30\n"),
        of("[camera]\nprojection = \"parallel\"\nheight = 3\nnear = -1\nfar = 4\n"),
        of(
            "[camera]\nwindow = { left = -1, right = 2, bottom = -1, top = 1 }\nnear = 2\n[style]\nshading = \"phong\"\n",
        ),
        of("[camera]\nlens = { focal_length = 35, sensor = [36, 24], fit = \"horizontal\" }\n[style]\nantialias = 1\n"),
    ];
    for (one, other) in figures.iter().flat_map(|one| figures.iter().map(move |other| (one, other))) {
        let comparison = Comparison::default().with_figure(one, other);
        assert!(comparison.is_of_camera());
        // As a file keeps it.
        let kept = Figure { compare: Some(comparison), ..one.clone() };
        let kept = read::parse(&write::to_toml(&kept)).unwrap();
        let comparison = kept.compare.clone().unwrap();
        let side = comparison.other_side(&kept).unwrap();
        assert_eq!(side.figure.camera, other.camera);
        assert_eq!(side.figure.style, other.style);
        let swapped = comparison.swapped(&kept).unwrap();
        assert_eq!(swapped.camera, other.camera);
        assert_eq!(swapped.compare.clone().unwrap().other_side(&swapped).unwrap().figure.camera, one.camera);
    }
}

#[test]
fn a_file_a_link_and_render_draw_the_same_comparison() {
    let bench = Bench::new("compare");
    let wiped = Comparison { wiper: 0.3, differences: true, ..Comparison::of_key("style.visibility", "\"painter\"") };
    let beside = Comparison { beside: true, ops: vec!["zoom=2".parse().unwrap()], ..Comparison::default() };
    for comparison in [wiped, beside] {
        let figure = compared(comparison);
        let text = write::to_toml(&figure);
        assert_eq!(read::parse(&text).unwrap(), figure);
        bench.write("figure.toml", &text);
        let link = share::link("", share::Held::Figure, &text).unwrap();
        for view in View::ALL {
            let own = drawn(&request(&figure, view));
            let opaque: Vec<u8> = own.rgba().chunks(4).flat_map(|pixel| &pixel[..3]).copied().collect();
            for source in ["figure.toml", &link] {
                let arguments = ["render", source, "--view", view.name(), "--size", "240x180", "--scale", "1"];
                bench.run(&[&arguments[..], &["--lang", "en", "-o", "a.png"]].concat()).done();
                assert!((240, 180, opaque.clone()) == pixels(&bench.read("a.png")), "{view:?}");
            }
        }
    }
}

#[test]
fn a_comparison_that_is_impossible_is_no_picture_less() {
    let figure = compared(Comparison::of_key("camera.near", "1e9"));
    assert!(drawn(&request(&figure, View::Image)) == drawn(&request(&house(Show::default()), View::Image)));
    // It is drawn, and a message gives the reason.
    let bench = Bench::new("impossible side");
    bench.write("figure.toml", "[compare]\nwith = { \"camera.near\" = 1e9 }\n");
    let run = bench.run(&["render", "figure.toml", "--size", "60x40", "-o", "a.png", "--lang", "pt-BR"]);
    assert_eq!(run.status, Some(0));
    assert!(run.err.contains("A outra versão é impossível: ") && run.err.contains("near"), "{}", run.err);
}

/// Two boxes, of which one is 0.05 nearer, seen with a near plane that is far too near.
fn fighting(format: &str) -> Figure {
    let object = |name: &str, color: &str, z: f64| {
        format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\ncolor = \"{color}\"\ntranslate = [0, 0, {z}]\n")
    };
    let text = format!(
        "[camera]\nposition = [3, 2, 10]\nnear = 0.01\nfar = 1000\n{}{}[style]\nantialias = 1\n\
         depth_format = \"{format}\"\n",
        object("one", "#cc2222", 0.0),
        object("two", "#2222cc", 0.05),
    );
    read::parse(&text).unwrap()
}

fn differing(one: &Pixels, other: &Pixels) -> usize {
    one.rgba().chunks(4).zip(other.rgba().chunks(4)).filter(|(a, b)| a != b).count()
}

#[test]
fn planes_fight_in_the_image_if_depths_have_few_bits() {
    let image = |format| request(&fighting(format), View::Image);
    let [fixed_16, fixed_24, float] = ["fixed-16", "fixed-24", "f32-reversed"].map(|format| drawn(&image(format)));
    let (coarse, fine) = (differing(&fixed_16, &float), differing(&fixed_24, &float));
    assert!(coarse > 300 && fine * 5 < coarse, "{coarse} {fine}");
    for format in ["fixed-16", "f32-reversed"] {
        let forced = Request { force_all_stages: true, ..image(format) };
        assert!(drawn(&forced) == drawn(&image(format)), "{format}");
        for antialias in [camera_lab::appearance::Samples::Four, camera_lab::appearance::Samples::Sixteen] {
            let of = |format| drawn(&image(format).with_shot(|shot| shot.look.style.antialias = antialias));
            assert!(differing(&of("fixed-16"), &of("f32-reversed")) > 300);
        }
    }
    // The canonical volume has no depth buffer of its own. The world has the image on its window.
    assert!(
        drawn(&request(&fighting("fixed-16"), View::Canonical))
            == drawn(&request(&fighting("f32-reversed"), View::Canonical))
    );
    let both =
        Figure { compare: Some(Comparison::of_key("style.depth_format", "\"fixed-16\"")), ..fighting("f32-reversed") };
    let [own, other] = request(&both, View::Image).sides().unwrap();
    assert!(drawn(&own.request) == float && drawn(&other.request) == fixed_16);
}

#[test]
fn an_impossible_comparison_is_refused_by_line_and_key() {
    let many: Vec<String> = (0..17).map(|i| format!("\"zoom=1.{i}\"")).collect();
    for (text, parts) in [
        (
            "with = { \"style.visibilty\" = \"painter\" }",
            &["line 2", "[compare] with.style.visibilty", "visibility"][..],
        ),
        ("with = { \"styel.visibility\" = \"painter\" }", &["style"]),
        ("with = { \"style.visibility\" = \"paint\" }", &["line 2", "\"paint\"", "\"painter\""]),
        ("with = { \"style.theme\" = \"dark\" }", &["style.theme", "shading"]),
        ("with = { \"scene.preset\" = \"house\" }", &["scene.preset", "camera"]),
        ("with = { style = \"dark\" }", &["[compare] with.style", "\"dark\"", "section"]),
        ("with = { \"camera.near\" = 0 }", &["line 2", "near is 0", "greater than 0"]),
        ("with = { \"camera.view_up\" = [0, 0, 0] }", &["line 2", "view_up"]),
        ("with = 3", &["[compare] with"]),
        ("", &["[compare] with"]),
        ("ops = [\"azimut=3\"]", &["[compare] ops"]),
        (&format!("ops = [{}]", many.join(", ")), &["17", "16"]),
        ("with = { \"camera.near\" = 1 }\nwiper = 2", &["line 3", "[compare] wiper", "1"]),
        ("with = { \"camera.near\" = 1 }\nlayout = \"side\"", &["[compare] layout", "beside"]),
        ("with = { \"camera.near\" = 1 }\nwipe = 0.5", &["[compare] wipe", "wiper"]),
    ] {
        let error = read::parse(&format!("[compare]\n{text}\n")).unwrap_err();
        let message = messages::figure(Lang::En, &error);
        for part in parts {
            assert!(message.contains(part), "{text}: {message} lacks {part}");
        }
    }
}

fn caption_of(key: &str, value: Option<&str>, lang: Lang) -> String {
    caption(&[VariedValue::Key(key.to_owned(), value.map(str::to_owned))], labels(lang))
}

#[test]
fn captions_describe_in_words_the_options_of_reveal() {
    fn names<T>(list: words::Words<T>) -> Vec<Option<&'static str>> {
        std::iter::once(None).chain(list.iter().map(|(word, _)| Some(*word))).collect()
    }
    let on_and_off = || vec![Some("false"), Some("true")];
    let keys = [
        ("reveal.depth", vec![Some("false"), Some("true"), Some("linear")]),
        ("reveal.outside", names(words::OUTSIDES)),
        ("reveal.texture", names(words::TEXTURE_REVEALS)),
        ("reveal.shadows", names(words::SHADOW_REVEALS)),
        ("reveal.cost", names(words::COST_REVEALS)),
        ("style.order", words::FACE_ORDERS.iter().map(|(word, _)| Some(*word)).collect()),
        ("show.stage", names(words::STAGES)),
        ("reveal.clipping", on_and_off()),
        ("reveal.divide_first", on_and_off()),
        ("reveal.culled", on_and_off()),
        ("reveal.vanishing", on_and_off()),
        ("reveal.single_precision", on_and_off()),
    ];
    for (key, values) in keys {
        let all = |lang| values.iter().map(|value| caption_of(key, *value, lang)).collect::<Vec<_>>();
        let [english, portuguese] = [Lang::En, Lang::PtBr].map(all);
        for texts in [&english, &portuguese] {
            assert!(texts.iter().all(|text| !text.contains('=') && !text.contains('–')), "{texts:?}");
            assert_eq!(texts.iter().collect::<BTreeSet<_>>().len(), values.len(), "{texts:?}");
        }
        assert_ne!(english, portuguese);
    }
}

#[test]
fn captions_print_keys_and_words_of_a_file_without_subscripts() {
    let shown = |key, value| {
        let text = caption_of(key, Some(value), Lang::En);
        let runs = runs(&text);
        assert!(runs.iter().all(|run| !run.lowered), "{runs:?}");
        runs.iter().map(|run| run.text).collect::<String>()
    };
    assert_eq!(shown("world.window_opacity", "0.5"), "window_opacity = 0.5");
    assert_eq!(shown("scene.preset", "my_scene"), "preset = my_scene");
}
