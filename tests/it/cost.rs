//! The cost of a frame: `explain --cost`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use camera_lab::appearance::{DepthFormat, FaceOrder, Samples, Theme, Visibility};
use camera_lab::camera::Camera;
use camera_lab::picture::Renderer;
use camera_lab::progress::{Progress, at_once};
use camera_lab::raster::textbook::PixelCost;
use camera_lab::scene::Wanted;
use camera_lab::stage::{Operations, Stage};
use camera_lab::views::{Finish, Palette, Request, SharedScene, Size, View, scene_of};
use camera_lab_files::{FigureFiles, FileAccess, open_figure};
use camera_lab_words::Lang;
use camera_lab_words::pictures::labels;
use serde_json::Value;

use crate::common::program::Bench;
use crate::words::files_below;

const SHIPPED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/figures/pipeline/frame-cost.toml");
/// Those of [Molnar90] for one of 25 frames, as [3] §1.1 quotes them: geometry, and rasterization with its accesses to
/// the memory of the image.
const ESTIMATE: [f64; 3] = [92e6 / 25.0, 106e6 / 25.0, 127e6 / 25.0];

fn told(bench: &Bench, arguments: &[&str]) -> Value {
    let arguments = [&["explain"], arguments, &["--cost", "--format", "json"]].concat();
    serde_json::from_slice(bench.run(&arguments).done()).unwrap()
}

fn of(told: &Value, name: &str) -> [u64; 3] {
    let stage = told["stages"].as_array().unwrap().iter().find(|stage| stage["stage"] == name).unwrap();
    ["float", "integer", "memory"].map(|kind| stage["operations"][kind].as_u64().unwrap())
}

fn names(told: &Value, which: impl Fn(&Value) -> bool) -> Vec<String> {
    let stages = told["stages"].as_array().unwrap().iter().filter(|stage| which(stage));
    stages.map(|stage| stage["stage"].as_str().unwrap().to_owned()).collect()
}

/// Sums of geometry and of rasterization.
fn sums(told: &Value) -> [[u64; 3]; 2] {
    let stages = names(told, |_| true);
    let fill = stages.iter().position(|name| name == "fill").unwrap();
    let sum = |stages: &[String]| {
        stages.iter().fold([0; 3], |sum, name| {
            let more = of(told, name);
            [sum[0] + more[0], sum[1] + more[1], sum[2] + more[2]]
        })
    };
    [sum(&stages[..fill]), sum(&stages[fill..])]
}

fn torus(segments: u32, rest: &str) -> String {
    format!(
        "[camera]\nposition = [0.0, 2.0, 6.0]\nfocal_point = [0.0, 0.0, 0.0]\nnear = 3.0\nfar = 12.0\n[image]\nwidth = 160\nheight = 120\n\
         [[scene.objects]]\nname = \"ring\"\nshape = \"torus\"\nsegments = {segments}\ncolor = \"#4477aa\"\n\
         [[scene.lights]]\nkind = \"directional\"\ndirection = [-1.0, -1.0, -1.0]\n{rest}"
    )
}

#[test]
fn the_cost_is_in_the_report_only_on_request() {
    let bench = Bench::new("cost-shape");
    bench.write("figure.toml", torus(16, ""));
    let explained = told(&bench, &["figure.toml"]);
    for stage in explained["stages"].as_array().unwrap() {
        let operations = stage["operations"].as_object().unwrap();
        assert_eq!(operations.keys().map(String::as_str).collect::<Vec<_>>(), ["float", "integer", "memory"]);
        assert!(operations.values().all(Value::is_u64), "{stage}");
    }
    assert_eq!(explained["not_counted"], serde_json::json!(["traverse", "cull-objects", "lines"]));
    let plain: Value =
        serde_json::from_slice(bench.run(&["explain", "figure.toml", "--format", "json"]).done()).unwrap();
    assert!(plain["stages"].as_array().unwrap().iter().all(|stage| stage.get("operations").is_none()));
    assert!(plain.get("not_counted").is_none());
}

#[test]
fn stages_that_did_not_run_cost_nothing_and_the_others_something() {
    let bench = Bench::new("cost-ran");
    let cases = [
        "[style]\nshading = \"gouraud\"\n",
        "[style]\nshading = \"flat\"\nantialias = 1\n",
        "[style]\nshading = \"phong\"\nvisibility = \"painter\"\n",
        "[style]\nshading = \"wireframe\"\n",
    ];
    for rest in cases {
        bench.write("figure.toml", torus(16, rest));
        for view in ["image", "world", "canonical"] {
            let told = told(&bench, &["figure.toml", "--view", view]);
            for name in names(&told, |stage| stage["ran"] == false) {
                assert_eq!(of(&told, &name), [0; 3], "{name}, {view}, {rest}");
            }
            let uncounted: Vec<&str> =
                told["not_counted"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
            for name in names(&told, |stage| stage["ran"] == true && stage["in"] != 0) {
                assert_eq!(of(&told, &name) == [0; 3], uncounted.contains(&name.as_str()), "{name}, {view}, {rest}");
            }
        }
    }
}

#[test]
fn the_cost_is_the_textbooks_for_each_element() {
    let bench = Bench::new("cost-grows");
    let style = "[style]\nshading = \"gouraud\"\nantialias = 1\n";
    bench.write("coarse.toml", torus(16, style));
    let coarse = told(&bench, &["coarse.toml"]);
    // 16 · 8 vertices: 22 operations to view and clip space, 3 divisions, 8 operations to the image.
    assert_eq!(of(&coarse, "transform"), [128 * 22, 0, 128 * 3]);
    assert_eq!(of(&coarse, "divide"), [128 * 3, 0, 0]);
    assert_eq!(of(&coarse, "viewport"), [128 * 8, 0, 128 * 3]);
    assert_eq!(of(&coarse, "write"), [0, 0, 160 * 120]);
    // Four times the pixels: vertices cost the same, pixels four times as much.
    let large = told(&bench, &["coarse.toml", "--size", "320x240"]);
    assert_eq!(of(&large, "transform"), of(&coarse, "transform"));
    let grown = of(&large, "interpolate")[0] as f64 / of(&coarse, "interpolate")[0] as f64;
    assert!((3.5..4.5).contains(&grown), "{grown}");
}

#[test]
fn the_shipped_scene_has_the_numbers_of_the_estimate_and_costs_of_its_order() {
    let bench = Bench::new("cost-shipped");
    let told = told(&bench, &[SHIPPED]);
    let faces = told["stages"].as_array().unwrap().iter().find(|stage| stage["stage"] == "cull-faces").unwrap();
    assert_eq!(faces["in"], 10_000);
    let [geometry, raster] = sums(&told);
    for (counted, estimated) in [geometry[0], raster[1], raster[2]].into_iter().zip(ESTIMATE) {
        let ratio = counted as f64 / estimated;
        assert!((0.1..10.0).contains(&ratio), "{counted} against {estimated}");
    }
}

/// The page on performance sets the counts beside the estimate: they are those of the command.
#[test]
fn the_page_has_the_counts_of_the_command() {
    let bench = Bench::new("cost-guides");
    let [geometry, raster] = sums(&told(&bench, &[SHIPPED]));
    let page = include_str!("../../docs/performance.md");
    let rows = page.lines().skip_while(|line| !line.starts_with("| block | estimate |")).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    let counted: Vec<&str> = rows.map(|row| row.trim_matches('|').split('|').nth(2).unwrap().trim()).collect();
    let million = |n: u64| format!("{:.0}", n as f64 * 25.0 / 1e6);
    assert_eq!(counted, [geometry[0], geometry[1], geometry[2], raster[0], raster[1], raster[2]].map(million));
}

/// The figures of the program, which have every preset.
fn figures() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/figures");
    let files = |folder: &str| files_below(&root.join(folder), ".toml");
    let figures = files("");
    assert!(figures.len() > 40, "{figures:?}");
    figures
}

fn request_of(path: &Path, [width, height]: [u32; 2]) -> Request {
    let figure = open_figure(path).unwrap().figure;
    let mut files = FigureFiles::new(path.parent().unwrap(), FileAccess::Figure);
    let mut read = |wanted: Wanted<'_>| files.read(wanted);
    let scene = SharedScene::new(scene_of(&figure, &mut read, &Progress::default()).unwrap());
    let camera = Camera::new(&figure.camera).unwrap();
    let size = Size { width, height, scale: 1.0 };
    Request::of(&figure, View::Image, &camera, &scene, labels(Lang::En), size)
}

/// Filling has a share in each triangle, `EDGES`, and sorting only in triangles. Everything else belongs to pixels.
#[test]
fn the_sums_of_the_pixels_are_the_costs_of_the_stages() {
    let bench = Bench::new("cost-sums");
    let mut stages_seen = BTreeSet::new();
    for path in figures().into_iter().chain([bench.write("coplanar.toml", COPLANAR)]) {
        let name = path.to_string_lossy().into_owned();
        let told = told(&bench, &[&name, "--size", "160x120"]);
        let request = request_of(&path, [160, 120]);
        let costs = at_once(Renderer::default().costs(&request, &Progress::default())).unwrap();
        let sum = |of: fn(&PixelCost) -> u32| costs.pixels.iter().map(|pixel| u64::from(of(pixel))).sum::<u64>();
        let report = |stage: Stage| {
            told["stages"].as_array().unwrap().iter().find(|told| told["stage"] == stage.name()).unwrap()
        };
        let in_order = request.shot.look.style.visibility != Visibility::DepthBuffer;
        for stage in Stage::ALL.into_iter().filter(|stage| stage.is_raster() && stage.is_counted()) {
            let pixels = costs.pixels.iter().map(|pixel| costs.at(stage, pixel));
            let Operations { float, integer, memory } = pixels.fold(Operations::NONE, Operations::and);
            let [entering, leaving] = ["in", "out"].map(|count| report(stage)[count].as_u64().unwrap());
            let told = of(&told, stage.name());
            match stage {
                Stage::Fill => {
                    assert_eq!(told, [float, integer + 23 * entering, memory + 9 * entering], "{name}");
                    assert_eq!(leaving, sum(|pixel| pixel.covered), "{name}: the fast rasterizer counts the same");
                }
                Stage::HiddenSurfaces if in_order => assert_eq!([float, integer, memory], [0; 3], "{name}"),
                _ => assert_eq!(told, [float, integer, memory], "{name}, {}", stage.name()),
            }
            if stage == Stage::HiddenSurfaces && report(stage)["ran"] == true && !in_order {
                assert_eq!([entering, leaving], [sum(|p| p.covered), sum(|p| p.filled)], "{name}");
            }
            if float + integer + memory > 0 {
                stages_seen.insert(stage.name());
            }
        }
        let all = costs.pixels.iter().map(|pixel| costs.of_pixel(pixel)).fold(Operations::NONE, Operations::and);
        let [_, raster] = sums(&told);
        assert!(all.float <= raster[0] && all.integer <= raster[1] && all.memory <= raster[2], "{name}");
        let fills = told["fills"].as_array().unwrap();
        assert_eq!(fills[0]["filled"], sum(|pixel| pixel.filled - pixel.ground), "{name}");
        assert_eq!(fills[0]["painted_over"], sum(|pixel| pixel.painted_over), "{name}");
    }
    assert_eq!(stages_seen.len(), 8, "{stages_seen:?}");
}

/// Boxes on each other, with common planes, besides the figures of the program.
const COPLANAR: &str = "[scene]\npreset = \"empty\"\n\
    [[scene.objects]]\nshape = \"box\"\ncolor = \"#cc3311\"\n\
    [[scene.objects]]\nshape = \"box\"\ncolor = \"#0077bb\"\ntranslate = [0.5, 0, 0]\n\
    [[scene.objects]]\nshape = \"box\"\ncolor = \"#ee7733\"\nscale = [2, 1, 1]\n\
    [[scene.objects]]\nshape = \"box\"\ncolor = \"#00998880\"\ntranslate = [0, 0.25, 0.5]\n";

#[test]
fn the_order_of_faces_changes_no_byte_with_a_depth_buffer() {
    let bench = Bench::new("cost-orders");
    bench.write("coplanar.toml", COPLANAR);
    let mut renderer = Renderer::default();
    let mut changed = 0;
    for path in figures().into_iter().chain([bench.path("coplanar.toml")]) {
        let request = request_of(&path, [64, 48]);
        for format in [DepthFormat::Fixed16, DepthFormat::Fixed24, DepthFormat::Float] {
            for antialias in Samples::ALL {
                let mut counts = Vec::new();
                let pictures = FaceOrder::NAMED.iter().map(|&(_, order)| {
                    let with = request.clone().with_shot(|shot| {
                        let style = &mut shot.look.style;
                        (style.depth_format, style.antialias, style.order) = (format, antialias, order);
                        style.visibility = Visibility::DepthBuffer;
                    });
                    if antialias == Samples::One {
                        let costs = at_once(renderer.costs(&with, &Progress::default())).unwrap();
                        counts.push(costs.fills[0].1);
                    }
                    renderer.pixels(&with).unwrap()
                });
                let pictures: Vec<_> = pictures.collect();
                assert!(pictures.iter().all(|picture| *picture == pictures[0]), "{path:?} {format:?} {antialias:?}");
                changed += usize::from(counts.iter().any(|count| *count != counts[0]));
            }
        }
    }
    assert!(changed > 30, "{changed}");
}

/// The tint: nothing where nothing is filled, and the greatest value where most is.
#[test]
fn the_image_is_tinted_and_says_what_was_painted_over() {
    let bench = Bench::new("cost-tint");
    let sheet = |z: f64, x: f64| {
        format!(
            "[[scene.objects]]\nshape = \"box\"\ncolor = \"#4477aa\"\nscale = [1, 1, 0.01]\ntranslate = [{x}, 0, {z}]\n"
        )
    };
    let figure = format!(
        "[camera]\nposition = [0, 0, 9]\nprojection = \"parallel\"\nheight = 4\naspect = 1\n[image]\nwidth = 64\nheight = 64\n\
         [scene]\npreset = \"empty\"\n{}{}[style]\nantialias = 1\nshading = \"flat\"\nhidden_lines = \"hidden\"\n[reveal]\ncost = \"overdraw\"\n",
        sheet(0.0, -0.5),
        sheet(1.0, 0.5),
    );
    bench.write("figure.toml", &figure);
    let request = request_of(&bench.path("figure.toml"), [64, 64]);
    let request = Request { finish: Finish { bare: true, ..Finish::default() }, ..request };
    let picture = Renderer::default().pixels(&request).unwrap();
    let at = |x: usize, y: usize| -> [u8; 3] { picture.rgba()[4 * (64 * y + x)..][..3].try_into().unwrap() };
    let paper = Palette::of(Theme::Light).paper;
    assert_eq!(at(3, 32), [paper.r, paper.g, paper.b], "no face");
    assert_eq!(at(14, 30), [33, 145, 140], "one of two: the middle of the scale");
    assert_eq!(at(32, 30), [253, 231, 37], "two");
    // Half of each sheet lies over or under the other.
    let told = told(&bench, &["figure.toml"]);
    let over = |order: &str| {
        let fills = told["fills"].as_array().unwrap().iter().find(|fills| fills["order"] == order).unwrap();
        let [filled, over] = ["filled", "painted_over"].map(|count| fills[count].as_f64().unwrap());
        over / filled
    };
    assert!((over("as-listed") - 1.0 / 4.0).abs() < 0.05 && over("front-to-back") == 0.0, "{}", told["fills"]);
    bench.run(&["render", "figure.toml", "--view", "image", "--size", "300x300", "-o", "figure.svg"]).done();
    let svg = String::from_utf8(bench.read("figure.svg")).unwrap();
    assert!(svg.contains("fills per pixel") && svg.contains("<image"), "{svg}");
}
