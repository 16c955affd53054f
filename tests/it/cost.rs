//! The cost of a frame: `explain --cost`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::Bench;

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
