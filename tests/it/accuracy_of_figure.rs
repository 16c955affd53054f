//! `accuracy FIGURE`: error, time and memory of each way to draw a figure.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::DepthFormat;
use camera_lab::figure::write::to_toml;
use camera_lab::lessons::{Step, shipped};
use serde_json::Value;

use crate::common::program::Bench;

const FIGURE: &str = "[camera]\nposition = [4, 3, 6]\n[style]\nantialias = 1\n[image]\nwidth = 80\nheight = 60\n";

fn pixels(png: &[u8]) -> Vec<[u8; 3]> {
    let image = image::load_from_memory(png).unwrap().to_rgb8();
    image.pixels().map(|pixel| pixel.0).collect()
}

fn linear(channel: u8) -> f64 {
    let v = f64::from(channel) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

/// Compares the errors of a row with those of its picture.
fn assert_errors(row: &Value, drawn: &[[u8; 3]], exact: &[[u8; 3]]) {
    let (mut different, mut squares) = (0.0, 0.0);
    for (a, b) in drawn.iter().zip(exact) {
        different += f64::from(u8::from(a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 4)));
        squares += a.iter().zip(b).map(|(&a, &b)| (linear(a) - linear(b)).powi(2)).sum::<f64>();
    }
    let pixels = exact.len() as f64;
    let near = |of: &Value, expected: f64| (of.as_f64().unwrap() - expected).abs() < 1e-12;
    assert!(near(&row["different"], different / pixels), "{row}");
    assert!(near(&row["rms"], (squares / (3.0 * pixels)).sqrt()), "{row}");
}

/// Every number but the times follows from pictures that the program writes.
#[test]
fn the_errors_are_those_of_rendered_pictures() {
    let bench = Bench::new("accuracy-errors");
    bench.write("figure.toml", FIGURE);
    let run = |seconds| {
        let size = ["--size", "64x48", "--reference", "exact.png", "--format", "json"];
        bench.run(&[&["accuracy", "figure.toml", "--seconds", seconds][..], &size].concat()).json()
    };
    let value = run("0");
    assert_eq!(value["size"], serde_json::json!([64, 48]));
    assert_eq!(value["choices"]["style.antialias"], serde_json::json!([1, 4, 16]));
    assert_eq!(value["reference"]["samples"], 64);
    let exact = pixels(&bench.read("exact.png"));
    let rows = value["rows"].as_array().unwrap();
    for flag in ["yours", "cheapest"] {
        assert_eq!(rows.iter().filter(|row| row[flag] == true).count(), 1, "{flag}");
    }
    let own = rows.iter().find(|row| row["yours"] == true).unwrap();
    assert_eq!(own["set"]["style.antialias"], 1);
    for row in rows {
        let set = row["set"].as_object().unwrap();
        assert!(set.keys().eq(value["choices"].as_object().unwrap().keys()));
        let style: String = set.iter().map(|(key, value)| format!("{} = {value}\n", &key["style.".len()..])).collect();
        bench.write("row.toml", FIGURE.replace("antialias = 1\n", &style));
        bench.run(&["render", "row.toml", "--view", "image", "--size", "64x48", "-o", "row.png"]).done();
        let drawn = pixels(&bench.read("row.png"));
        assert_errors(row, &drawn, &exact);
        let [ms, low, high] = [0, 1, 2].map(|k| row["ms"][k].as_f64().unwrap());
        assert!(0.0 < low && low <= ms && ms <= high, "{row}");
        assert!(row["bytes"].as_u64().unwrap() >= 4 * 64 * 48, "{row}");
    }
    let errors = |value: &Value| -> Vec<[Value; 4]> {
        let row = |row: &Value| ["set", "different", "rms", "bytes"].map(|key| row[key].clone());
        value["rows"].as_array().unwrap().iter().map(row).collect()
    };
    assert_eq!(errors(&value), errors(&run("0.2")));
}

/// Filters and shadow maps are keys of the scene. Their pictures are those of a figure that has them.
#[test]
fn the_errors_of_filters_and_shadow_maps_are_those_of_rendered_pictures() {
    let bench = Bench::new("accuracy-scene");
    let figure = |set: &serde_json::Map<String, Value>| {
        let of = |key: &str| set.get(key).map_or_else(String::new, |value| format!("{} = {value}\n", last(key)));
        let style: String = set.keys().filter(|key| key.starts_with("style.")).map(|key| of(key)).collect();
        format!(
            "[camera]\nposition = [2, 2, 5]\nnear = 1\n[scene]\npreset = \"empty\"\n[[scene.objects]]\nname = \"floor\"\n\
             shape = \"box\"\nscale = [4, 0.1, 4]\ntranslate = [0, -1, 0]\ntexture = \"chequer\"\n\
             texture_scale = [6, 6]\n{}[[scene.objects]]\nname = \"ball\"\nshape = \"sphere\"\n[[scene.lights]]\n\
             kind = \"directional\"\ndirection = [-1, -2, -1]\nshadows = true\n{}{}[style]\nshading = \"flat\"\n{style}",
            of("scene.objects.0.filter"),
            of("scene.lights.0.shadow_map"),
            of("scene.lights.0.shadow_bias"),
        )
    };
    bench.write("figure.toml", figure(&serde_json::Map::new()));
    let size = ["--size", "48x36"];
    let args = ["accuracy", "figure.toml", "--seconds", "0", "--reference", "exact.png", "--format", "json"];
    let value = bench.run(&[&args[..], &size].concat()).json();
    let exact = pixels(&bench.read("exact.png"));
    let rows = value["rows"].as_array().unwrap();
    for key in ["scene.objects.0.filter", "scene.lights.0.shadow_map", "scene.lights.0.shadow_bias"] {
        assert!(value["choices"].get(key).is_some(), "{key}: {}", value["choices"]);
    }
    for row in rows.iter().step_by(1 + rows.len() / 12) {
        bench.write("row.toml", figure(row["set"].as_object().unwrap()));
        bench.run(&[&["render", "row.toml", "--view", "image", "-o", "row.png"][..], &size].concat()).done();
        assert_errors(row, &pixels(&bench.read("row.png")), &exact);
    }
}

/// The last word of a path.
fn last(key: &str) -> &str {
    key.rsplit('.').next().unwrap_or(key)
}

#[test]
fn the_front_and_the_answer_follow_from_the_rows() {
    let bench = Bench::new("accuracy-front");
    bench.write("figure.toml", FIGURE);
    let value = bench.run(&["accuracy", "figure.toml", "--seconds", "0.5", "--format", "json"]).json();
    let rows = value["rows"].as_array().unwrap();
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap();
    let at_most =
        |a: &Value, b: &Value| ["different", "rms", "bytes"].iter().all(|key| number(a, key) <= number(b, key));
    for row in rows {
        let low = row["ms"][1].as_f64().unwrap();
        let beats = |other: &&Value| *other != row && at_most(other, row) && other["ms"][2].as_f64().unwrap() < low;
        assert_eq!(row["front"], !rows.iter().any(|other| beats(&other)), "{row}");
    }
    let best = rows.iter().map(|row| number(row, "different")).fold(f64::INFINITY, f64::min);
    let good = rows.iter().filter(|row| number(row, "different") <= best + 0.001);
    let fastest = good.min_by(|a, b| a["ms"][0].as_f64().unwrap().total_cmp(&b["ms"][0].as_f64().unwrap())).unwrap();
    assert_eq!(fastest["cheapest"], true);
}

/// The answer of the lesson's question, and what its notes say, is what the study of the step's figure finds.
#[test]
fn the_lesson_about_numbers_that_break_asks_what_the_study_answers() {
    let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == "limits").unwrap().lesson;
    let is_it = |step: &&Step| step.figure.style.depth_format == DepthFormat::Fixed24 && step.task.is_some();
    let step = lesson.steps.iter().find(is_it).unwrap();
    let bench = Bench::new("accuracy-lesson");
    bench.write("step.toml", to_toml(&step.figure));
    let args = ["accuracy", "step.toml", "--size", "240x180", "--seconds", "0", "--format", "json"];
    let value = bench.run(&args).json();
    let different = |visibility: &str, format: &str, samples: u32| {
        let is_it = |row: &&Value| {
            let set = &row["set"];
            let is_format = visibility != "depth-buffer" || set["style.depth_format"] == format;
            set["style.visibility"] == visibility && is_format && set["style.antialias"] == samples
        };
        value["rows"].as_array().unwrap().iter().find(is_it).unwrap()["different"].as_f64().unwrap()
    };
    let own = different("depth-buffer", "fixed-24", 4);
    assert!(different("depth-buffer", "f32-reversed", 4) < 0.2 * own);
    assert!(different("bsp", "", 4) < 0.2 * own);
    assert!(different("depth-buffer", "fixed-24", 16) > 0.9 * own);
    assert!(different("depth-buffer", "fixed-24", 16) > different("depth-buffer", "fixed-24", 1));
    assert!(different("painter", "", 4) > 0.5 * own);
}

#[test]
fn tables_and_charts_are_in_both_languages_and_each_reason_is_named() {
    let bench = Bench::new("accuracy-words");
    bench.write("figure.toml", FIGURE);
    let text = |more: &[&str]| {
        let run = bench.run(&[&["accuracy", "figure.toml", "--seconds", "0"][..], more].concat());
        String::from_utf8(run.done().to_vec()).unwrap()
    };
    let english = text(&["--lang", "en", "--plot", "chart.svg"]);
    assert!(
        english.contains("Yours: ") && english.contains("Not tried: scene.objects.filter: no object has a texture")
    );
    let portuguese = text(&["--lang", "pt-BR", "--plot", "chart.png"]);
    assert!(portuguese.contains("A sua: ") && portuguese.contains("Não experimentado: "), "{portuguese}");
    assert!(String::from_utf8_lossy(&bench.read("chart.svg")).contains(">yours</text>"));
    assert!(bench.read("chart.png").starts_with(b"\x89PNG"));
    // A format of depths means nothing without a depth buffer, so the table doesn't name one there.
    assert!(
        english.contains("  BSP tree, 4 samples\n")
            && english.contains("Depth buffer, depth: 24 bits, faces as listed, 4 samples")
    );
    let csv = text(&["--format", "csv"]);
    assert!(csv.starts_with("style.visibility,style.depth_format,style.order,style.antialias,different,"), "{csv}");
    bench.write("aside.toml", format!("{FIGURE}[reveal]\nclipping = true\n"));
    let value = bench.run(&["accuracy", "aside.toml", "--seconds", "0", "--format", "json"]).json();
    assert_eq!(value["set_aside"], serde_json::json!(["[reveal]"]));
}

#[test]
fn figures_with_nothing_to_choose_have_one_row_and_large_ones_a_way_out() {
    let bench = Bench::new("accuracy-extremes");
    for (name, text) in [
        ("empty.toml", "[scene]\npreset = \"empty\"\n[image]\nwidth = 64\nheight = 48\n"),
        ("wires.toml", "[style]\nshading = \"wireframe\"\n[image]\nwidth = 64\nheight = 48\n"),
    ] {
        bench.write(name, text);
        let value = bench.run(&["accuracy", name, "--seconds", "0", "--format", "json"]).json();
        assert_eq!(value["rows"].as_array().unwrap().len(), 1, "{name}");
        assert_eq!(value["choices"], serde_json::json!({}), "{name}");
        let keys: Vec<&str> =
            value["left_out"].as_array().unwrap().iter().map(|out| out["key"].as_str().unwrap()).collect();
        assert!(keys.contains(&"style.visibility") && keys.contains(&"style.antialias"), "{name}: {keys:?}");
    }
    bench.write("figure.toml", FIGURE);
    let one = bench.run(&["accuracy", "figure.toml", "--size", "1x1", "--seconds", "0", "--format", "json"]).json();
    assert_eq!(one["size"], serde_json::json!([1, 1]));
    for (more, named) in [
        (["--size", "4096x4096"], "--size"),
        (["--within", "2"], "--within"),
        (["--seconds", "-1"], "--seconds"),
        (["--study", "basis"], "--study"),
    ] {
        let run = bench.run(&["accuracy", "figure.toml", more[0], more[1]]);
        assert!(run.refused(2).contains(named), "{}", run.err);
    }
    let run = bench.run(&["accuracy", "--size", "64x48"]);
    assert!(run.refused(2).contains("FIGURE"), "{}", run.err);
}
