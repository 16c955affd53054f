//! `explain` and `bench`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::Bench;

/// The stages in the order of the notes, as programs read them.
const STAGES: [&str; 19] = [
    "traverse",
    "cull-objects",
    "normals",
    "light",
    "transform",
    "cull-faces",
    "clip",
    "oblique-window",
    "divide",
    "viewport",
    "fill",
    "interpolate",
    "hidden-surfaces",
    "texture",
    "shadow",
    "blend",
    "antialias",
    "lines",
    "write",
];

fn json(bench: &Bench, arguments: &[&str]) -> Value {
    let mut arguments = arguments.to_vec();
    arguments.extend(["--format", "json"]);
    serde_json::from_slice(bench.run(&arguments).done()).unwrap()
}

fn stage<'a>(explanation: &'a Value, name: &str) -> &'a Value {
    explanation["stages"].as_array().unwrap().iter().find(|stage| stage["stage"] == name).unwrap()
}

/// A figure with a small picture.
fn figure(bench: &Bench, rest: &str) {
    bench.write("figure.toml", format!("{rest}\n[image]\nwidth = 64\nheight = 48\n"));
}

#[test]
fn stages_are_listed_in_the_order_of_the_notes() {
    let bench = Bench::new("explain-order");
    figure(&bench, "");
    for view in ["world", "canonical", "image"] {
        let told = json(&bench, &["explain", "figure.toml", "--view", view]);
        assert_eq!(told["view"], view);
        let stages = told["stages"].as_array().unwrap();
        let names: Vec<_> = stages.iter().map(|stage| stage["stage"].as_str().unwrap()).collect();
        assert_eq!(names, STAGES);
        let mut sum = 0.0;
        for stage in stages {
            let ran = stage["ran"].as_bool().unwrap();
            assert!(!stage["reason"].as_str().unwrap().is_empty(), "{stage}");
            assert!(stage["in"].is_u64() && stage["out"].is_u64(), "{stage}");
            let micros = stage["micros"].as_f64().unwrap();
            assert!(ran || micros == 0.0, "{stage}");
            sum += micros;
        }
        let total = told["total_micros"].as_f64().unwrap();
        // The times of the stages add up to the whole.
        assert!(sum > 0.0 && (sum - total).abs() < 1e-3 * total, "{sum} of {total}");
    }
}

#[test]
fn the_reasons_are_those_of_the_figure() {
    let bench = Bench::new("explain-reasons");
    figure(
        &bench,
        "[camera]\nprojection = \"parallel\"\n[scene]\npreset = \"cube\"\n[style]\nshading = \"gouraud\"\nantialias = 1",
    );
    let told = json(&bench, &["explain", "figure.toml"]);
    let left_out = |name: &str| {
        assert_eq!(stage(&told, name)["ran"], false, "{name}");
        stage(&told, name)["reason"].as_str().unwrap().to_owned()
    };
    assert_eq!(left_out("divide"), "parallel projection: w is 1 everywhere");
    assert_eq!(left_out("oblique-window"), "symmetric window: l = −r and b = −t, so these terms are 0");
    assert_eq!(left_out("antialias"), "one sample for each pixel");
    assert_eq!(left_out("blend"), "everything in view is opaque");
    assert_eq!(stage(&told, "normals")["ran"], true);

    let told = json(&bench, &["explain", "figure.toml", "--lang", "pt-BR"]);
    assert_eq!(stage(&told, "divide")["reason"], "projeção paralela: w vale 1 em toda parte");
}

#[test]
fn a_cube_is_counted_as_by_hand() {
    let bench = Bench::new("explain-counts");
    // From one corner of the cube three of its six sides are seen: 6 of 12 triangles.
    figure(
        &bench,
        "[camera]\nposition = [4, 4, 4]\nview_angle = 60\n[[scene.objects]]\nname = \"box\"\nshape = \"box\"\n\
         [[scene.objects]]\nname = \"behind\"\nshape = \"box\"\ntranslate = [20, 20, 20]",
    );
    let told = json(&bench, &["explain", "figure.toml"]);
    let counts = |name: &str| [&stage(&told, name)["in"], &stage(&told, name)["out"]].map(|n| n.as_u64().unwrap());
    assert_eq!(counts("traverse"), [2, 2]);
    assert_eq!(counts("cull-objects"), [2, 1]);
    assert_eq!(counts("cull-faces"), [12, 6]);
    assert_eq!(stage(&told, "clip")["ran"], false);
    assert_eq!(
        stage(&told, "cull-objects")["reason"],
        "1 of 2 objects: all of the bounding box is outside one plane of the volume"
    );
}

#[test]
fn each_object_has_its_outcome_and_reason() {
    let bench = Bench::new("explain-objects");
    let ball = |name: &str, x: i32| {
        format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"sphere\"\ntranslate = [{x}, 0, 0]\n")
    };
    // At the distance 10 the window is 10 high and 40 / 3 wide: the right plane is at x = 6.7.
    figure(
        &bench,
        &format!(
            "[camera]\nposition = [0, 0, 10]\nview_angle = 53.13010235415598\n{}{}{}",
            ball("in the middle", 0),
            ball("half", 7),
            ball("far out", 20)
        ),
    );
    let told = json(&bench, &["explain", "figure.toml"]);
    let objects: Vec<_> =
        told["objects"].as_array().unwrap().iter().map(|o| (&o["name"], &o["place"], &o["planes"])).collect();
    let right = serde_json::json!(["right"]);
    assert_eq!(objects[0], (&"in the middle".into(), &"inside".into(), &serde_json::json!([])));
    assert_eq!(objects[1], (&"half".into(), &"crosses".into(), &right));
    assert_eq!(objects[2], (&"far out".into(), &"outside".into(), &right));
    assert!(json(&bench, &["explain", "figure.toml", "--view", "world"]).get("objects").is_none());

    let table = String::from_utf8(bench.run(&["explain", "figure.toml", "--lang", "pt-BR"]).done().to_vec()).unwrap();
    assert!(table.contains("half"), "{table}");
    assert!(table.contains("fora: além do plano da direita"), "{table}");
}

#[test]
fn forced_stages_all_run() {
    let bench = Bench::new("explain-forced");
    figure(&bench, "[style]\nshading = \"wireframe\"");
    let told = json(&bench, &["explain", "figure.toml", "--force-all-stages"]);
    assert!(told["stages"].as_array().unwrap().iter().all(|stage| stage["ran"] == true));
    let told = json(&bench, &["explain", "figure.toml"]);
    assert_eq!(stage(&told, "fill")["reason"], "wireframe: only edges are drawn");
}

#[test]
fn the_table_lists_the_skipped_stages_and_why_in_both_languages() {
    let bench = Bench::new("explain-table");
    figure(&bench, "");
    let table = |lang: &str| {
        let run = bench.run(&["explain", "figure.toml", "--lang", lang]);
        let out = run.done();
        String::from_utf8(out.to_vec()).unwrap()
    };
    let english = table("en");
    assert!(english.starts_with("Image, 64 × 48\n"), "{english}");
    assert!(english.contains("skipped: everything in view is opaque"), "{english}");
    let portuguese = table("pt-BR");
    assert!(portuguese.starts_with("Imagem, 64 × 48\n"), "{portuguese}");
    assert!(portuguese.contains("omitida: tudo que se vê é opaco"), "{portuguese}");
    assert_eq!(english.lines().count(), portuguese.lines().count());
}

#[test]
fn a_bench_reports_the_requested_view_size_and_frames() {
    let bench = Bench::new("bench-json");
    figure(&bench, "[scene]\npreset = \"cube\"");
    for (view, size, [width, height]) in [("image", None, [64, 48]), ("all", Some("200x50"), [200, 50])] {
        let mut arguments = vec!["bench", "figure.toml", "--frames", "5", "--view", view];
        arguments.extend(size.iter().flat_map(|size| ["--size", size]));
        let told = json(&bench, &arguments);
        assert_eq!(told["view"], view);
        assert_eq!([&told["width"], &told["height"]], [width, height]);
        assert_eq!(told["triangles"], 12);
        assert_eq!(told["frames"], 5);
        let [least, middle, most] = ["min_ms", "median_ms", "p95_ms"].map(|key| told[key].as_f64().unwrap());
        assert!(0.0 < least && least <= middle && middle <= most, "{told}");
    }
    let text = String::from_utf8(bench.run(&["bench", "figure.toml", "--frames", "1"]).done().to_vec()).unwrap();
    assert!(text.starts_with("image, 64 × 48: 12 triangles, 1 frame\nmedian "), "{text}");
}

#[test]
fn frames_that_are_none_are_refused() {
    let bench = Bench::new("bench-frames");
    figure(&bench, "");
    for frames in ["0", "-1", "1000001", "many", "1.5", ""] {
        let run = bench.run(&["bench", "figure.toml", "--frames", frames]);
        assert_eq!(run.status, Some(2), "{frames}");
        assert!(run.err.contains("--frames") && run.err.contains("1 to 1000000"), "{}", run.err);
    }
}

#[test]
fn every_stage_that_is_left_out_has_its_saving_and_the_same_bytes() {
    let bench = Bench::new("explain-saved");
    figure(&bench, "");
    let told = json(&bench, &["explain", "figure.toml", "--saved"]);
    let stages = told["stages"].as_array().unwrap();
    assert!(stages.iter().any(|stage| stage["ran"] == false));
    for stage in stages {
        if stage["ran"] == true {
            assert!(stage.get("saved_ms").is_none() && stage.get("same_bytes").is_none(), "{stage}");
            continue;
        }
        let [ms, low, high] = [0, 1, 2].map(|k| stage["saved_ms"][k].as_f64().unwrap());
        assert!(low <= ms && ms <= high, "{stage}");
        assert_eq!(stage["same_bytes"], true, "{stage}");
    }
    let run = bench.run(&["explain", "figure.toml", "--saved", "--lang", "pt-BR"]);
    let text = String::from_utf8(run.done().to_vec()).unwrap();
    assert!(text.contains("a mesma imagem, byte por byte"), "{text}");
}
