//! The camera of a photograph on the command line: a render of ours stands for the photograph.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::Bench;

const KNOWN: &str = "[camera]\nposition = [6, 3, 8]\nfocal_point = [0.5, 1, 0.3]\nview_angle = 42\nfar = 20\n\
                     [image]\nwidth = 4096\nheight = 3072\n";

/// The pixel of a point of the world in the picture of the known camera.
fn pixel(bench: &Bench, point: &str) -> String {
    let report = bench.run(&["inspect", "known.toml", "--point", point, "--format", "json"]).json();
    let pixel = &report["points"][0]["pixel"];
    format!("{},{}", pixel[0], pixel[1])
}

/// The text that the program prints.
fn text(bench: &Bench, arguments: &[&str]) -> String {
    String::from_utf8(bench.run(arguments).done().to_vec()).unwrap()
}

/// Lines along an axis from the pixels of their ends.
fn lines(bench: &Bench, axis: &str, ends: [[&str; 2]; 2]) -> String {
    let [a, b] = ends.map(|ends| ends.map(|end| pixel(bench, end)).join(" "));
    format!("{axis}: {a}; {b}")
}

#[test]
fn the_camera_of_a_render_comes_back_within_its_cost() {
    let bench = Bench::new("photograph");
    bench.write("known.toml", KNOWN);
    bench.write("figure.toml", "[scene]\npreset = \"house\" # a house\n");
    let x = lines(&bench, "x", [["0,0,0", "2,0,0"], ["0,0,2", "2,0,2"]]);
    let z = lines(&bench, "z", [["0,0,0", "0,0,2"], ["2,0,0", "2,0,2"]]);
    let (origin, length) = (pixel(&bench, "0,0,0"), format!("x: {} 2", pixel(&bench, "2,0,0")));
    let arguments = [
        "photograph",
        "figure.toml",
        "--size",
        "4096x3072",
        "--lines",
        &x,
        "--lines",
        &z,
        "--origin",
        &origin,
        "--length",
        &length,
    ];
    let found = bench.run(&[&arguments[..], &["--format", "json"]].concat()).json();
    let number = |value: &Value| value.as_f64().unwrap();
    let cost = number(&found["view_angle_per_pixel"]);
    assert!((number(&found["camera"]["view_angle"]) - 42.0).abs() < 3.0 * cost && cost < 2.0, "{found}");
    for (place, known) in [6.0, 3.0, 8.0].into_iter().enumerate() {
        assert!((number(&found["camera"]["position"][place]) - known).abs() < 0.2, "{found}");
    }
    assert_eq!(found["untold"], serde_json::json!([]));
    let written = text(&bench, &arguments);
    assert!(written.contains("# a house") && written.contains("width = 4096"), "{written}");
    let told = text(&bench, &[&arguments[..], &["--lang", "pt-BR"]].concat());
    assert!(told.contains("um pixel de erro"), "{told}");
}

#[test]
fn lines_that_meet_at_infinity_leave_theta_to_the_figure_and_say_so() {
    let bench = Bench::new("photograph-infinity");
    bench.write("figure.toml", "[camera]\nview_angle = 33\n");
    let x = "x: 100,200 900,200; 100,600 900,600";
    let y = "y: 200,700 200,100; 800,700 800,100";
    let run = ["photograph", "figure.toml", "--lines", x, "--lines", y, "--format", "json"];
    let found = bench.run(&run).json();
    assert_eq!(found["untold"][0]["code"], "view-angle");
    assert_eq!((&found["focal_length"], found["camera"]["view_angle"].as_f64()), (&Value::Null, Some(33.0)));
    let lone = bench.run(&["photograph", "figure.toml", "--lines", x]);
    assert_eq!(lone.status, Some(2));
    let bad = bench.run(&["photograph", "figure.toml", "--lines", "x: 1,2", "--lang", "pt-BR"]);
    assert_eq!(bad.status, Some(2));
    assert!(bad.err.contains("não pode ser lido"), "{}", bad.err);
}

#[test]
fn all_cameras_of_a_file_become_those_of_a_figure() {
    let bench = Bench::new("all-cameras");
    bench.write("figure.toml", "");
    let pose = |x: f64| format!("[[1, 0, 0, {x}], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]");
    let frames: Vec<String> = [0.0, 1.0, 2.0]
        .into_iter()
        .enumerate()
        .map(|(i, x)| format!("{{ \"file_path\": \"{i}.png\", \"transform_matrix\": {} }}", pose(x)))
        .collect();
    let file = format!("{{ \"camera_angle_x\": 0.8, \"w\": 800, \"h\": 600, \"frames\": [{}] }}", frames.join(", "));
    bench.write("transforms.json", file);
    let written = text(&bench, &["matrix", "figure.toml", "--from", "transforms.json", "--camera", "all"]);
    bench.write("all.toml", &written);
    let report = bench.run(&["inspect", "all.toml", "--format", "json"]).json();
    let names: Vec<&str> = report["cameras"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), 2, "{written}");
    for (camera, x) in report["cameras"].as_array().unwrap().iter().zip([1.0, 2.0]) {
        // In the world of nerfstudio z points up.
        assert_eq!(camera["position"], serde_json::json!([x, 5.0, 0.0]));
    }
}

/// Two cameras, each on a node of its own, the second one on an arm.
const GLTF: &str = include_str!("../common/two_cameras.gltf");

#[test]
fn all_cameras_of_a_gltf_file_open_as_those_of_a_figure() {
    let bench = Bench::new("all-cameras-gltf");
    bench.write("figure.toml", "");
    bench.write("two.gltf", GLTF);
    let written = text(&bench, &["matrix", "figure.toml", "--from", "two.gltf", "--camera", "all"]);
    bench.write("all.toml", &written);
    let report = bench.run(&["inspect", "all.toml", "--format", "json"]).json();
    assert_eq!(report["camera"]["position"], serde_json::json!([1.0, 2.0, 6.0]), "{written}");
    let others = report["cameras"].as_array().unwrap();
    assert_eq!((others.len(), &others[0]["name"]), (1, &serde_json::json!("arm")));
    assert_eq!(others[0]["position"], serde_json::json!([0.0, 1.0, 9.0]));
    // The picture of both, as the window shows it.
    bench.run(&["render", "all.toml", "--view", "world", "--size", "200x150", "-o", "all.png"]).done();
}

#[test]
fn the_arithmetic_has_the_horizon_and_its_roll() {
    let bench = Bench::new("photograph-roll");
    bench.write("figure.toml", "");
    // The photograph of the lesson, whose camera is rolled by 3°.
    let run = [
        "photograph",
        "figure.toml",
        "--size",
        "640x480",
        "--lines",
        "x: 210.3,293.4 443.5,360.5; 215.1,157.3 458.6,160",
        "--lines",
        "z: 561.9,320.8 443.5,360.5; 575.7,174.7 458.6,160",
        "--origin",
        "210.3,293.4",
        "--length",
        "x: 443.5,360.5 4",
    ];
    let written = text(&bench, &run);
    let roll = written.lines().find_map(|line| line.split_once("rolled by ")).unwrap().1;
    let roll: f64 = roll.trim_end_matches('°').parse().unwrap();
    assert!((roll - 3.03).abs() < 0.3, "{written}");
    bench.write("found.toml", &written);
    let report = bench.run(&["inspect", "found.toml", "--format", "json"]).json();
    for (place, known) in [7.0, 1.7, 5.0].into_iter().enumerate() {
        let found = report["camera"]["position"][place].as_f64().unwrap();
        assert!((found - known).abs() < 0.1, "{found} for {known}");
    }
    assert!(text(&bench, &[&run[..], &["--lang", "pt-BR"]].concat()).contains("está rolada em"));
}

/// The marks of a photograph of a corner of a house, for a level camera of 59°. The verticals are drawn by hand.
const CORNER: [&str; 6] = [
    "--size",
    "1920x1080",
    "--lines",
    "x: 1440,12 1179,69; 1731,952 1209,854; 1329,86 957,151",
    "--lines",
    "z: 120,973 683,802; 366,95 1145,419; 872,116 1167,330",
];

#[test]
fn a_figure_that_is_written_can_be_opened_whatever_camera_it_had() {
    let bench = Bench::new("photograph-openable");
    for before in [
        "",
        "projection = \"parallel\"\nnear = -3\n",
        "projection = \"parallel\"\nnear = -3\nfar = -1\n",
        "window = { left = -1, right = 2, bottom = -1, top = 1 }\n",
        "horizontal_angle = 60\n",
        "lens = { focal_length = 50, sensor = [36, 24], fit = \"horizontal\" }\n",
    ] {
        bench.write("f.toml", format!("[camera]\n{before}"));
        let written = text(&bench, &[&["photograph", "f.toml"][..], &CORNER].concat());
        bench.write("g.toml", written);
        let read = bench.run(&["inspect", "g.toml", "--format", "json"]).json();
        assert_eq!(read["camera"]["projection"], "perspective", "{before}");
        let theta = read["camera"]["view_angle"].as_f64().unwrap();
        assert!((theta - 59.0).abs() < 1.0, "{before}{theta}");
    }
}

#[test]
fn verticals_drawn_by_hand_change_little_and_notices_are_in_both_languages() {
    let bench = Bench::new("photograph-verticals");
    bench.write("f.toml", "");
    let verticals = "y: 1435,829 1447,410; 1447,1054 1478,139; 1250,475 1268,66";
    let with = [&["photograph", "f.toml", "--format", "json", "--lines", verticals][..], &CORNER].concat();
    let found = bench.run(&with).json();
    assert!((found["camera"]["view_angle"].as_f64().unwrap() - 59.0).abs() < 1.0, "{found}");
    assert_eq!(found["notices"], serde_json::json!([]));
    let pieces = "y: 100,100 100,200; 100,400 100,700";
    for (lang, words) in [("en", "pieces of one line"), ("pt-BR", "pedaços de uma só reta")] {
        let with = ["photograph", "f.toml", "--format", "json", "--lang", lang, "--lines", pieces];
        let notice = bench.run(&[&with[..], &CORNER].concat()).json()["notices"][0].clone();
        assert!(notice["code"] == "one-line" && notice["message"].as_str().unwrap().contains(words), "{notice}");
    }
}
