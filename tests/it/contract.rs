//! `inspect`: the numbers of the contract, compared with values that were computed with 150 digits, and its errors.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::{Bench, Run};

fn inspect(bench: &Bench, text: &str, arguments: &[&str]) -> Run {
    bench.write("figure.toml", text);
    bench.run(&[&["inspect", "figure.toml"], arguments, &["--format", "json"]].concat())
}

/// The value at a path such as `points.0.clip`.
fn at<'a>(value: &'a Value, path: &str) -> &'a Value {
    path.split('.').fold(value, |value, key| key.parse::<usize>().map_or(&value[key], |index| &value[index]))
}

/// Holds each number within its tolerance. A list of numbers may share one.
#[track_caller]
fn assert_near(found: &Value, expected: &Value, tolerance: &Value, path: &str) {
    if let Some(expected) = expected.as_array() {
        assert_eq!(found.as_array().map(Vec::len), Some(expected.len()), "{path}: {found}");
        for (i, expected) in expected.iter().enumerate() {
            let tolerance = if tolerance.is_array() { &tolerance[i] } else { tolerance };
            assert_near(&found[i], expected, tolerance, &format!("{path}.{i}"));
        }
    } else {
        let (x, y) = (found.as_f64().unwrap_or(f64::NAN), expected.as_f64().unwrap());
        assert!((x - y).abs() <= tolerance.as_f64().unwrap(), "{path}: {found} is not {expected} ± {tolerance}");
    }
}

#[track_caller]
fn assert_as_expected(found: &Value, expected: &Value, path: &str) {
    if let Some(value) = expected.get("v") {
        assert_near(found, value, &expected["t"], path);
    } else if let Some(value) = expected.get("s").or_else(|| expected.get("b")) {
        assert_eq!(found, value, "{path}");
    } else if let Some(whole) = expected.get("i").and_then(Value::as_array) {
        for (i, value) in whole.iter().enumerate().filter(|(_, value)| !value.is_null()) {
            assert_eq!(found[i].as_i64(), value.as_i64(), "{path}.{i}");
        }
        if let Some(z) = expected.get("z") {
            assert_near(&found[whole.len()], z, &expected["t"], path);
        }
    } else {
        assert!(found.is_null() || found == &Value::Bool(false), "{path}: {found} should be null");
    }
}

#[test]
fn the_numbers_are_those_of_high_precision() {
    let bench = Bench::new("numbers");
    let cases: Value = serde_json::from_str(include_str!("../figures/cases.json")).unwrap();
    let cases = cases.as_array().unwrap();
    assert_eq!(cases.len(), 6);
    for case in cases {
        let arguments: Vec<&str> = case["arguments"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        let report = inspect(&bench, case["figure"].as_str().unwrap(), &arguments).json();
        for (path, expected) in case["expected"].as_object().unwrap() {
            assert_as_expected(at(&report, path), expected, &format!("{}: {path}", case["name"]));
        }
    }
}

#[test]
fn a_report_has_every_key_of_the_contract() {
    let bench = Bench::new("keys");
    let report = inspect(&bench, "", &["--point", "-1,-2e0,.5", "--pixel", "3,4"]).json();
    let keys: Vec<&str> = report.as_object().unwrap().keys().map(String::as_str).collect();
    let expected = "camera dop distance basis window lens ndc view_matrix projection_matrix \
                    view_projection_matrix inverse_view_matrix inverse_projection_matrix volume_corners planes points rays warnings";
    assert_eq!(keys, expected.split_whitespace().collect::<Vec<_>>());
    let point: Vec<&str> = report["points"][0].as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(point, ["world", "view", "clip", "ndc", "window", "pixel", "viewport", "inside"]);
    assert_eq!(report["points"][0]["world"], serde_json::json!([-1.0, -2.0, 0.5]));
    assert_eq!(report["rays"][0]["pixel"], serde_json::json!([3, 4]));
    assert_eq!(report["camera"]["position"], serde_json::json!([3.0, 4.0, 5.0]));
}

#[test]
fn a_pixel_outside_of_the_image_has_a_ray_and_a_warning_beside_it() {
    let bench = Bench::new("outside-pixel");
    let figure = "[image]\nwidth = 20\nheight = 15\n";
    for (pixel, outside) in
        [("-1,0", true), ("0,-1", true), ("20,14", true), ("19,15", true), ("0,0", false), ("19,14", false)]
    {
        let run = inspect(&bench, figure, &["--pixel", pixel]);
        let report: Value = serde_json::from_slice(&run.out).unwrap();
        assert_eq!(run.status, Some(0));
        assert_eq!(report["rays"][0]["direction"].as_array().unwrap().len(), 3, "{pixel}");
        assert_eq!(report["warnings"], serde_json::json!([]), "the report is as ever");
        let warning = format!(
            "camera-lab: --pixel {pixel} lies outside the image, which has columns 0 to 19 and rows 0 to 14; its ray is \
             printed anyway\n"
        );
        assert_eq!(run.err, if outside { warning.as_str() } else { "" }, "{pixel}");
    }
    let told = inspect(&bench, figure, &["--pixel", "5000,5000", "--lang", "pt-BR"]).err;
    assert!(told.contains("fica fora da imagem, que tem colunas de 0 a 19 e linhas de 0 a 14"), "{told}");
}

#[test]
fn operations_apply_in_the_order_given() {
    let bench = Bench::new("operations");
    let figure = "[camera]\nposition = [0, 0, 2]\n";
    let position = |arguments: &[&str]| {
        let report = inspect(&bench, figure, arguments).json();
        let numbers = report["camera"]["position"].as_array().unwrap().clone();
        numbers.iter().map(|x| (x.as_f64().unwrap() * 1e9).round() / 1e9).collect::<Vec<_>>()
    };
    // A quarter turn about v through PF, then one step along the new u (−z), and the other way round along x.
    assert_eq!(position(&["--op", "azimuth=90", "--op", "pan=1,0"]), [2.0, 0.0, -1.0]);
    assert_eq!(position(&["--op", "pan=1,0", "--op", "azimuth=90"]), [3.0, 0.0, 0.0]);
    assert_eq!(position(&["--op", "pan=-1,-2"]), [-1.0, -2.0, 2.0]);
    assert_eq!(position(&["--op=dolly=4"]), [0.0, 0.0, 0.5]);
    assert_eq!(position(&["--op", "elevation=-90"]), [0.0, 2.0, 0.0]);
    assert_eq!(position(&["--op", "elevation=90", "--convention", "vtk"]), [0.0, 2.0, 0.0]);
}

#[test]
fn the_report_does_not_depend_on_the_language() {
    let bench = Bench::new("language");
    bench.write("figure.toml", "[camera]\nview_angle = 170\nfar = 1e15");
    let plain = bench.run(&["inspect", "figure.toml"]);
    let mut command = bench.command(&["inspect", "figure.toml", "--lang", "pt-BR"]);
    let portuguese = Run::of(command.env("LC_ALL", "pt_BR.UTF-8"));
    assert_eq!(plain.done(), portuguese.done());
    assert!(plain.json()["warnings"].as_array().unwrap().len() >= 2);
}

#[test]
fn faults_of_the_figure_are_named_in_one_paragraph() {
    let bench = Bench::new("faults");
    for (text, message) in [
        (
            "[camera]\nposition = [0, 5, 0]\nview_up = [0, 1, 0]",
            "figure.toml, line 3: [camera] view_up is collinear with focal_point − position; allowed: any vector \
             in another direction",
        ),
        ("[camera]\nnear = 0", "figure.toml, line 2: [camera] near is 0.0; allowed: a finite number greater than 0"),
        (
            "# a comment\n[camera]\nview_angle = 180.0",
            "figure.toml, line 3: [camera] view_angle is 180.0; allowed: greater than 0 and less than 180 degrees",
        ),
        (
            "[camera]\nposition = \"abc\"",
            "figure.toml, line 2: [camera] position is \"abc\"; allowed: three finite numbers, [x, y, z]",
        ),
        (
            "[style]\nthem = \"dark\"",
            "figure.toml, line 2: [style] them is unknown (did you mean theme?); allowed: shading, visibility, \
             hidden_lines, antialias, theme, depth_format, \
             vertex_format, subpixel_bits, order",
        ),
        (
            "[camera]\nnear = 1,5",
            "figure.toml, line 2: [camera] near cannot be read as TOML: near = 1,5 (unexpected key or value, expected \
             newline, `#`); allowed: KEY = VALUE with texts in quotes and a point in decimals, such as near = 0.5",
        ),
        (
            "[[scene.objects]]\nname = \"a\"\nshape = \"cube\"",
            "figure.toml, line 3: [[scene.objects]] shape is \"cube\"; allowed: \"box\", \"prism\", \"pyramid\", \
             \"sphere\", \"ellipsoid\", \"cylinder\", \"cone\", \"torus\", \"grid\", \"points\", \"segments\", \"mesh\" \
             (did you mean box?)",
        ),
    ] {
        assert_eq!(inspect(&bench, text, &[]).refused(2), format!("camera-lab: {message}"));
    }
}

#[test]
fn faults_of_mesh_files_name_figure_and_mesh() {
    let bench = Bench::new("meshes");
    bench.write("figure.toml", "[[scene.objects]]\nname = \"a\"\nshape = \"mesh\"\n\npath = \"sub.obj\"\n");
    let arguments = ["render", "figure.toml", "-o", "a.png"];
    let run = bench.run(&arguments);
    assert!(run.refused(2).contains("figure.toml, line 5: [[scene.objects]] \"a\": path \"sub.obj\""), "{}", run.err);
    assert!(run.err.contains("there is no such file"), "{}", run.err);
    bench.write("sub.obj", "v 0 0 0\nf 1 2 9\n");
    let run = bench.run(&arguments);
    assert!(run.refused(2).contains("line 5") && run.err.contains("line 2"), "{}", run.err);
    bench.write("sub.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    bench.run(&arguments).done();
}

#[test]
fn faults_of_the_arguments_are_named_too() {
    let bench = Bench::new("arguments");
    for (arguments, part) in [
        (&["--op", "zoom=0"][..], "zoom is \"0\"; allowed: a finite number greater than 0"),
        (&["--op", "zoom=nan"], "zoom"),
        (&["--op", "turn=3"], "there is no operation \"turn\"; allowed: elevation, azimuth"),
        (&["--op", "pan=3"], "DX,DY"),
        (&["--op", "roll"], "NAME=VALUE"),
        (&["--point", "1,2"], "--point is \"1,2\"; allowed: three finite numbers"),
        (&["--point", "1,2,inf"], "--point"),
        (&["--pixel", "1.5,2"], "--pixel is \"1.5,2\"; allowed: two integers"),
        (&["--convention", "opengl"], "right-hand, vtk"),
        (&["--points", "1,2,3"], "--point"),
        (&["--op", "dolly=1e-320"], "figure.toml: operation dolly"),
    ] {
        let run = inspect(&bench, "", arguments);
        assert!(run.refused(2).contains(part), "{part}: {}", run.err);
    }
    let run = bench.run(&["inspect"]);
    assert!(run.refused(2).contains("<FIGURE>"), "{}", run.err);
}

#[test]
fn files_that_are_not_figures_are_named() {
    let bench = Bench::new("no-figures");
    bench.write("latin1.toml", b"[camera]\n# c\xe2mera\n");
    bench.write("nul.toml", b"\0\0\0");
    bench.write("cut.png", b"\x89PNG\r\n\x1a\n");
    for (name, part) in [
        ("missing.toml", "missing.toml cannot be read: there is no such file"),
        (".", ". is a directory"),
        ("latin1.toml", "latin1.toml, line 2: byte 0xe2 is not UTF-8"),
        ("nul.toml", "nul.toml, line 1"),
        ("cut.png", "cut.png: the PNG is damaged"),
    ] {
        let run = bench.run(&["inspect", name]);
        assert!(run.refused(2).contains(part), "{part}: {}", run.err);
    }
}

/// The list has each number with the bounds of the JSON, and what the questions lose.
#[test]
fn bounds_are_printed_as_json_and_as_a_list() {
    let bench = Bench::new("contract-bounds");
    let arguments = ["--bounds", "--point", "0,0,0", "--pixel", "3,4", "--op", "azimuth=30"];
    let json = inspect(&bench, "", &arguments).json();
    let plain = inspect(&bench, "", &arguments[1..]).json();
    assert!(plain.get("bounds").is_none() && plain.get("condition").is_none());
    let [low, high] = [0, 1].map(|end| json["bounds"]["distance"][end].as_f64().unwrap());
    assert!((low..=high).contains(&json["distance"].as_f64().unwrap()) && high - low < 2e-15);
    // The centre of the image is the corner of four pixels.
    assert_eq!(json["bounds"]["points"][0]["pixel"][0][1], 512);
    assert!(json["condition"]["basis"].as_f64().unwrap() > 0.1);
    let run = bench.run(&[&["inspect", "figure.toml"], &arguments[..], &["--format", "text", "--lang", "en"]].concat());
    let list = String::from_utf8_lossy(run.done());
    let line = list.lines().find(|line| line.starts_with("distance ")).unwrap().to_owned();
    assert!(line.contains(&json["bounds"]["distance"][0].to_string()) && line.ends_with("15 digits proved"), "{line}");
    assert!(list.contains("(M_p M_v)⁻¹: the question itself loses"));
}
