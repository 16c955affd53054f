//! Labels that are the author's: in pixels, SVG, PDF and TeX, from every place of the camera.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::Camera;
use camera_lab::drawing::{Drawing, Label};
use camera_lab::figure::read::parse;
use camera_lab::figure::write::to_toml;
use camera_lab::figure::{Figure, NotePlace};
use camera_lab::picture::Renderer;
use camera_lab::progress::Progress;
use camera_lab::views::{
    LabelPlace, Request, SharedScene, Shot, Size, View, note_place, pick, scene_of, unknown_labels,
};
use camera_lab_words::{Lang, pictures};
use glam::{DVec2, DVec3};

use crate::common::program::Bench;

const SIZE: Size = Size { width: 640, height: 480, scale: 1.0 };
const FIGURE: &str = "[camera]\nnear = 2\nfar = 12\n[scene]\npreset = \"cube\"\n[style]\nantialias = 1\n";
const LABELS: &str = "[labels]\nhidden = [\"DOP\"]\n\
    [[labels.renamed]]\nname = \"C\"\ntext = 'eye $\\mathbf{e}$'\n\
    [[labels.moved]]\nname = \"PF\"\nview = \"world\"\nby = [5, -4]\n\
    [[labels.styled]]\nname = \"u\"\nsize = 2\ncolor = \"#ff0000\"\n\
    [[labels.notes]]\nat = [1, 1, 1]\ntext = \"corner\"\nby = [6, 3]\n\
    [[labels.notes]]\nview = \"world\"\nat = [0.5, 0.1]\ntext = \"Figure 1\"\n";

fn request(figure: &Figure, view: View, lang: Lang) -> Request {
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = scene_of(figure, &mut |_| unreachable!("no mesh"), &Progress::default()).unwrap();
    Request::of(figure, view, &camera, &SharedScene::new(scene), pictures::labels(lang), SIZE)
}

fn drawing(text: &str, view: View) -> Drawing {
    Renderer::default().drawing(&request(&parse(text).unwrap(), view, Lang::En)).unwrap().drawing
}

fn label<'a>(drawing: &'a Drawing, name: &str) -> Option<&'a Label> {
    drawing.labels.iter().find(|label| label.name == name)
}

fn place(drawing: &Drawing, name: &str) -> LabelPlace {
    LabelPlace::all(drawing).into_iter().find(|label| label.name == name).unwrap()
}

#[test]
fn names_of_objects_are_set_as_they_are_typed() {
    let object = |name: &str, x: f64| {
        format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\ntranslate = [{x}, 0, 0]\n")
    };
    let text = format!(
        "{}{}[[scene.objects]]\nname = \"P_1\"\nshape = \"points\"\npoints = [[0, 1, 0]]\n[show]\nstage = \"cull-objects\"\n",
        object("Cube_001", 0.0),
        object("left_{wheel}", 90.0)
    );
    let drawing = drawing(&text, View::Image);
    for (name, expected) in
        [("object:Cube_001", "Cube_001"), ("P_1", "P_1"), ("legend:object:left_{wheel}", "left_{wheel}")]
    {
        let runs = camera_lab::text::runs(&label(&drawing, name).unwrap_or_else(|| panic!("{name}")).text);
        assert!(runs.iter().all(|run| !run.lowered), "{runs:?}");
        let shown: String = runs.iter().map(|run| run.text).collect();
        assert_eq!(shown.split(':').next(), Some(expected));
    }
}

#[test]
fn labels_are_hidden_renamed_moved_and_styled_and_notes_are_added() {
    let own = drawing(FIGURE, View::World);
    let drawing = drawing(&format!("{FIGURE}{LABELS}"), View::World);
    assert!(label(&own, "DOP").is_some() && label(&drawing, "DOP").is_none());
    assert_eq!(label(&drawing, "C").unwrap().text, "eye 𝐞");
    let (before, after) = (label(&own, "u").unwrap(), label(&drawing, "u").unwrap());
    assert_eq!((after.size, after.color.to_string().as_str()), (2.0 * before.size, "#ff0000"));
    let pf = place(&drawing, "PF");
    assert!((pf.center - pf.point).abs_diff_eq(DVec2::new(5.0, 4.0) * pf.em, 1e-3), "{pf:?}");
    // A line leads from it to its point.
    let ends: Vec<DVec2> =
        drawing.strokes.last().unwrap().points.iter().map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))).collect();
    assert!(ends.iter().any(|end| end.distance(pf.point) < 0.5 * pf.em), "{ends:?}");
    assert_eq!(label(&drawing, "note:1").unwrap().text, "corner");
    let page = place(&drawing, "note:2");
    assert!(page.center.abs_diff_eq(DVec2::new(320.0, 432.0), 0.5), "{page:?}");
}

#[test]
fn labels_stay_with_their_objects_when_the_camera_moves() {
    let text = |position: &str| format!("{}{LABELS}", FIGURE.replace("near", &format!("position = {position}\nnear")));
    let mut places = Vec::new();
    for position in ["[3, 4, 5]", "[-4, 3, 4]"] {
        let figure = parse(&text(position)).unwrap();
        for (view, name, p) in
            [(View::World, "PF", DVec3::ZERO), (View::World, "note:1", DVec3::ONE), (View::Image, "note:1", DVec3::ONE)]
        {
            let request = request(&figure, view, Lang::En);
            let drawing = Renderer::default().drawing(&request).unwrap().drawing;
            let label = place(&drawing, name);
            let shown = pick::places(&request).unwrap()(p).unwrap();
            assert!(label.point.abs_diff_eq(shown, 0.1), "{view:?} {name}: {} not {shown}", label.point);
            let by = if name == "PF" { DVec2::new(5.0, 4.0) } else { DVec2::new(6.0, -3.0) };
            assert!((label.center - label.point).abs_diff_eq(by * label.em, 0.1), "{view:?} {name}");
            places.push(label.point);
        }
    }
    assert!(places[2].distance(places[5]) > 20.0, "the camera has moved: {places:?}");
}

#[test]
fn every_output_has_them() {
    let bench = Bench::new("labels");
    bench.write("own.toml", FIGURE);
    bench.write("figure.toml", format!("{FIGURE}{LABELS}"));
    let render = |figure: &str, output: &str| {
        bench.run(&["render", figure, "--view", "world", "--size", "640x480", "-o", output]).done();
        bench.read(output)
    };
    let svg = String::from_utf8(render("figure.toml", "a.svg")).unwrap();
    let drawn = svg.split("<metadata").next().unwrap_or_default().len().max(1);
    for text in [">corner<", ">Figure 1<", ">e<"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(drawn > 1 && !svg.contains(">DOP<"));
    let tex = String::from_utf8(render("figure.toml", "a.tex")).unwrap();
    assert!(tex.contains(r"eye $\mathbf{e}$") && tex.contains("}corner\\hss") && !tex.contains("DOP"), "{tex}");
    assert!(render("figure.toml", "a.png") != render("own.toml", "b.png"));
    let pdf = render("figure.toml", "a.pdf");
    assert!(String::from_utf8_lossy(&pdf).contains("KaTeX_Main-Bold"), "the bold letter has its font");
    // It is found again in the picture.
    let again = bench.run(&["render", "a.png", "--view", "world", "--size", "640x480", "-o", "c.png"]);
    again.done();
    assert!(bench.read("c.png") == bench.read("a.png"));
}

#[test]
fn names_are_the_same_in_both_languages() {
    let figure = Figure { camera: parse(FIGURE).unwrap().camera, ..Figure::default() };
    for view in View::ALL {
        let names = |lang| {
            let drawing = Renderer::default().drawing(&request(&figure, view, lang)).unwrap().drawing;
            let mut names: Vec<String> = LabelPlace::all(&drawing).into_iter().map(|label| label.name).collect();
            names.sort();
            names
        };
        let english = names(Lang::En);
        // Longer words may leave no room for others.
        assert!(names(Lang::PtBr).iter().all(|name| english.contains(name)), "{english:?}");
    }
}

#[test]
fn unknown_label_names_get_a_suggestion_and_all_drawn_labels_are_known() {
    let shipped = camera_lab_files::SHIPPED_FIGURES.iter().map(|figure| figure.text());
    for text in shipped {
        let Ok(figure) = parse(&text) else { continue };
        if !text.contains("mesh") {
            for view in View::ALL {
                let request = request(&figure, view, Lang::En);
                let drawing = Renderer::default().drawing(&request).unwrap().drawing;
                let mut shot = Shot::of(&figure);
                shot.labels.hidden = LabelPlace::all(&drawing).into_iter().map(|label| label.name).collect();
                assert_eq!(unknown_labels(&shot, &request.scene), [], "{view:?} {text}");
            }
        }
    }
    let bench = Bench::new("labels-unknown");
    bench.write("f.toml", format!("{FIGURE}[labels]\nhidden = [\"widnow\", \"C\"]\n"));
    let run = bench.run(&["render", "f.toml", "-o", "a.png"]);
    assert_eq!(run.status, Some(0));
    assert!(run.err.contains("widnow") && run.err.contains("window?") && !run.err.contains("\"C\""), "{}", run.err);
}

const DEPTH: &str = "[reveal]\ndepth = true\n";

#[test]
fn lines_of_a_legend_are_hidden_renamed_and_styled_and_the_legend_moves_as_a_whole() {
    let own = drawing(&format!("{FIGURE}{DEPTH}"), View::Image);
    let names = ["depth", "Z-near", "Z-middle", "Z-far", "distance-near", "distance-middle", "distance-far", "nothing"];
    let legend = names.map(|name| format!("legend:{name}"));
    for name in &legend {
        assert!(label(&own, name).is_some(), "{name}");
    }
    let changes = "[labels]\nhidden = [\"legend:nothing\", \"legend:Z-middle\"]\n\
        [[labels.renamed]]\nname = \"legend:depth\"\ntext = 'grey is $z_n$'\n\
        [[labels.moved]]\nname = \"legend\"\nby = [2, 3]\n\
        [[labels.styled]]\nname = \"legend:Z-near\"\ncolor = \"#ff0000\"\n";
    let changed = drawing(&format!("{FIGURE}{DEPTH}{changes}"), View::Image);
    assert!(label(&changed, "legend:nothing").is_none() && label(&changed, "legend:Z-middle").is_none());
    assert!(changed.areas.len() < own.areas.len(), "the sample of a hidden line is hidden with it");
    assert_eq!(label(&changed, "legend:depth").unwrap().text, "grey is 𝑧_{𝑛}");
    assert_eq!(label(&changed, "legend:Z-near").unwrap().color.to_string(), "#ff0000");
    for name in ["legend:Z-near", "legend:Z-far", "legend:distance-middle"] {
        let [before, after] = [place(&own, name), place(&changed, name)];
        // A line less, so that the others begin lower.
        let lower = place(&changed, "legend:Z-near").center.y - place(&own, "legend:Z-near").center.y;
        assert!((after.center - before.center).abs_diff_eq(DVec2::new(2.0 * after.em, lower), 0.01), "{name}");
        // Its reported place is the one that a drag of it begins with.
        assert!(after.moved_to(after.center).abs_diff_eq(DVec2::new(2.0, 3.0), 0.011), "{name} {after:?}");
    }
    let none = drawing(&format!("{FIGURE}{DEPTH}[labels]\nhidden = [\"legend\"]\n"), View::Image);
    assert!(none.areas.is_empty() && legend.iter().all(|name| label(&none, name).is_none()));
    // Farther than the picture reaches, it stays in it. Twice as large, its lines do not run into each other.
    let far = "[[labels.moved]]\nname = \"legend\"\nby = [1000, 1000]\n\
        [[labels.styled]]\nname = \"legend:depth\"\nsize = 2\n";
    let far = drawing(&format!("{FIGURE}{DEPTH}{far}"), View::Image);
    let title = place(&far, "legend:depth");
    assert!((title.center + title.half).cmplt(DVec2::new(640.0, 480.0)).all(), "{title:?}");
    assert!((title.em - 2.0 * place(&far, "legend:nothing").em).abs() < 1e-3);
    let below = place(&far, "legend:Z-near");
    assert!(below.center.y - below.half.y > title.center.y + title.half.y);
}

#[test]
fn a_dragged_line_of_a_legend_takes_it_along_and_automatic_undoes_it() {
    let mut labels = parse(FIGURE).unwrap().labels;
    labels.move_to("legend:depth", View::Image, DVec2::X);
    labels.move_to("legend:nothing", View::Image, DVec2::Y);
    assert_eq!(labels.moved.len(), 1, "there is one place for all");
    assert_eq!((labels.moved[0].name.as_str(), labels.moved[0].by), ("legend", DVec2::Y));
    assert_eq!(labels.change("legend:cuts", View::Image).by, Some(DVec2::Y));
    labels.reset("legend:depth");
    assert_eq!(labels, parse(FIGURE).unwrap().labels);
}

#[test]
fn labels_of_a_stage_can_be_changed_too() {
    let figure = FIGURE.replace("cube", "house");
    let stage = |stage: &str, view: &str| format!("{figure}[show]\nstage = \"{stage}\"\nstage_of = \"{view}\"\n");
    for (name, shown, view) in [
        ("traverse", "object:roof", View::Image),
        ("traverse", "object:camera", View::World),
        ("transform", "vertex:1", View::Image),
        ("lines", "goes-in", View::Image),
        ("lines", "comes-out", View::World),
        ("transform", "legend:vertices", View::Image),
        ("traverse", "legend:comes-out", View::Image),
    ] {
        let text = stage(name, view.name());
        let names: Vec<String> = drawing(&text, view).labels.into_iter().map(|label| label.name).collect();
        assert!(names.iter().any(|name| name == shown), "{name}: {shown} in {names:?}");
        let own = format!("{text}[labels]\n[[labels.renamed]]\nname = \"{shown}\"\ntext = \"mine\"\n");
        assert_eq!(label(&drawing(&own, view), shown).unwrap().text, "mine");
        let hidden = format!("{text}[labels]\nhidden = [\"{shown}\"]\n");
        assert!(label(&drawing(&hidden, view), shown).is_none());
        let figure = parse(&hidden).unwrap();
        assert_eq!(unknown_labels(&Shot::of(&figure), &request(&figure, view, Lang::En).scene), [], "{shown}");
    }
    for unknown in ["object:none", "vertex:11", "vertex:", "legend:dpeth", "legend:object:none"] {
        let figure = parse(&format!("{FIGURE}[labels]\nhidden = [\"{unknown}\"]\n")).unwrap();
        let scene = request(&figure, View::Image, Lang::En).scene;
        assert_eq!(unknown_labels(&Shot::of(&figure), &scene).len(), 1, "{unknown}");
    }
}

#[test]
fn the_labels_of_both_sides_of_a_comparison_are_the_authors() {
    let compare =
        |layout: &str| format!("{FIGURE}[compare]\nlayout = \"{layout}\"\nwith = {{ \"camera.view_angle\" = 30 }}\n");
    for layout in ["beside", "wiper"] {
        let text = compare(layout);
        let own = "[labels]\nhidden = [\"side:1\"]\n[[labels.renamed]]\nname = \"side:2\"\ntext = \"narrow\"\n";
        let labels = |text: &str| {
            let request = request(&parse(text).unwrap(), View::World, Lang::En);
            let mut picture = camera_lab::picture::Pixels::default();
            let mut renderer = Renderer::default();
            camera_lab::progress::at_once(renderer.pixels_into(&request, &mut picture)).unwrap().labels
        };
        let of = |labels: &[LabelPlace], name: &str| {
            labels.iter().filter(|label| label.name == name).cloned().collect::<Vec<_>>()
        };
        let before = labels(&text);
        assert_eq!(of(&before, "side:1").len() + of(&before, "side:2").len(), 2, "{layout}");
        let after = labels(&format!("{text}{own}"));
        assert!(of(&after, "side:1").is_empty());
        assert_eq!(of(&after, "side:2")[0].text, "narrow");
        // Each side has its own labels. Behind a wiper, only the visible ones of one picture are there.
        let middles: Vec<f64> = of(&before, "C").iter().map(|label| label.center.x).collect();
        if layout == "beside" {
            assert!(middles.len() == 2 && middles[0] < 320.0 && middles[1] > 320.0, "{middles:?}");
        }
    }
}

#[test]
fn letters_of_mathematics_are_bold_for_vectors_and_italic_for_others() {
    let drawing = drawing(&format!("{FIGURE}[labels]\nletters = \"mathematics\"\n"), View::World);
    let text = |name| label(&drawing, name).unwrap().text.as_str();
    assert_eq!([text("u"), text("C"), text("PF")], ["𝐮", "𝐶", "PF"]);
    assert!(drawing.labels.iter().all(|label| label.mathematical));
}

#[test]
fn measures_are_symbols_values_or_both() {
    for (shown, text) in [("symbol", "F"), ("value", "2"), ("both", "F = 2")] {
        let measures = format!("{FIGURE}[[labels.measures]]\nname = \"F\"\nas = \"{shown}\"\n");
        assert_eq!(label(&drawing(&measures, View::World), "F").unwrap().text, text);
    }
    assert!(label(&drawing(FIGURE, View::World), "F").is_none());
    // By hand: H = 2 F tan(θ/2), W = A H.
    let camera = parse(FIGURE).unwrap().camera;
    let height = 2.0 * camera.near * (0.5 * camera.view_angle.to_radians()).tan();
    let half = [("H/2", 0.5 * height), ("W/2", 0.5 * camera.aspect * height)];
    let angles = [("theta", camera.view_angle), ("theta/2", 0.5 * camera.view_angle)];
    for (name, value) in half.into_iter().chain(angles) {
        let measures = format!("{FIGURE}[[labels.measures]]\nname = \"{name}\"\nas = \"value\"\n");
        let drawing = drawing(&measures, View::World);
        let text = &label(&drawing, name).unwrap_or_else(|| panic!("{name}")).text;
        let shown: f64 = text.trim_end_matches('°').parse().unwrap();
        assert!((shown - value).abs() < 1e-3 * value, "{name}: {text}");
        assert_eq!(text.ends_with('°'), name.starts_with("theta"), "{name}: {text}");
    }
}

#[test]
fn however_far_a_label_is_moved_it_stays_on_the_page() {
    for by in ["[1000, 1000]", "[-1000, 0]", "[0, -1000]"] {
        let text =
            format!("{FIGURE}[[labels.moved]]\nname = \"C\"\nby = {by}\n[[labels.styled]]\nname = \"C\"\nsize = 8\n");
        let c = place(&drawing(&text, View::World), "C");
        let (low, high) = (c.center - c.half, c.center + c.half);
        assert!(low.min_element() > -1.0 && high.x < 641.0 && high.y < 481.0, "{by}: {c:?}");
    }
    // A long note on a tiny picture is an answer, too.
    let long = format!("{FIGURE}[[labels.notes]]\nat = [0, 0, 0]\ntext = \"{}\"\nsize = 8\n", "W".repeat(120));
    let tiny = Request {
        size: Size { width: 7, height: 5, scale: 1.0 },
        ..request(&parse(&long).unwrap(), View::World, Lang::En)
    };
    assert!(Renderer::default().pixels(&tiny).is_some());
}

#[test]
fn notes_hold_on_to_vertices_edges_and_places_of_the_picture() {
    let figure = parse(FIGURE).unwrap();
    let request = request(&figure, View::World, Lang::En);
    let places = pick::places(&request).unwrap();
    let object = &request.scene.objects[0];
    let world = |i: u32| object.world_from_object.transform_point3(object.mesh.positions[i as usize]);
    let [a, b] = object.mesh.edges[0];
    let vertex = note_place(&request, places(world(a)).unwrap(), 6.0);
    assert!(matches!(vertex, NotePlace::Vertex { .. }), "{vertex:?}");
    let middle = places(world(a).lerp(world(b), 0.5)).unwrap();
    assert!(matches!(note_place(&request, middle, 6.0), NotePlace::Edge { .. }));
    assert_eq!(note_place(&request, DVec2::new(320.0, 479.0), 6.0), NotePlace::Picture(DVec2::new(0.5, 0.002)));
    for at in ["{ object = \"cube\", vertex = 0 }", "{ object = \"none\", vertex = 0 }"] {
        let text = format!("{FIGURE}[[labels.notes]]\nat = {at}\ntext = \"here\"\n");
        let figure = parse(&text).unwrap();
        assert_eq!(parse(&to_toml(&figure)).unwrap(), figure);
        let named = label(&drawing(&text, View::World), "note:1").is_some();
        assert_eq!(named, at.contains(&object.name), "{at}: {}", object.name);
    }
}
