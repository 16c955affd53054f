//! `inspect --trace` and `--depth-pixel`: the values that other programs read of a point's way.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use serde_json::Value;

use crate::common::program::Bench;

const FIGURE: &str = "[camera]\nposition = [3, 4, 5]\nview_angle = 60\nnear = 1\nfar = 20\n\n[viewport]\nx = 7\ny = -3\nwidth = 640\nheight = 480\n";

fn inspected(arguments: &[&str]) -> Value {
    let bench = Bench::new(&format!("trace-{}", arguments.concat().replace(['/', ' '], "")));
    let figure = bench.write("f.toml", FIGURE);
    let figure = figure.to_str().unwrap();
    let run = bench.run(&[&["inspect", figure, "--format", "json"], arguments].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    serde_json::from_slice(&run.out).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

#[test]
fn each_row_adds_up_to_the_numbers_of_the_point() {
    let report = inspected(&["--point", "0.5,1,0", "--point", "-1,0.25,2", "--trace"]);
    for point in report["points"].as_array().unwrap() {
        let steps = point["trace"].as_array().unwrap();
        let ways: Vec<_> = steps
            .iter()
            .map(|s| (s["from"].as_str().unwrap(), s["to"].as_str().unwrap(), s["equation"].as_str().unwrap()))
            .collect();
        let expected = [
            ("world", "view", "(5.7)"),
            ("view", "clip", "(5.14)"),
            ("clip", "ndc", "(5.6)"),
            ("view", "window", "(5.9), (5.10)"),
            ("window", "pixel", "(5.22)"),
            ("ndc", "viewport", "(5.24), (5.25)"),
        ];
        assert_eq!(ways, expected);
        for (step, (_, to, _)) in steps.iter().zip(ways) {
            assert_eq!(numbers(&step["output"]), numbers(&point[to]), "{to}");
            let rows = step["terms"].as_array().unwrap();
            assert_eq!(rows.len(), numbers(&step["output"]).len());
            for (row, output) in rows.iter().zip(numbers(&step["output"])) {
                let (sum, size) =
                    numbers(row).iter().fold((0.0, 1.0_f64), |(sum, size), x| (sum + x, size.max(x.abs())));
                assert!((sum - output).abs() <= 1e-14 * size, "{to}: {row} is {sum}, not {output}");
            }
            if let Some(matrix) = step.get("matrix") {
                let matrix: Vec<Vec<f64>> = matrix.as_array().unwrap().iter().map(numbers).collect();
                let input = numbers(&step["input"]);
                assert_eq!((matrix.len(), input.len()), (4, 4));
                for (row, terms) in matrix.iter().zip(rows) {
                    for ((m, x), term) in row.iter().zip(&input).zip(numbers(terms)) {
                        // (The reader of this test may miss the last digit.)
                        assert!((m * x - term).abs() <= 1e-15 * term.abs(), "{m} · {x} is not {term}");
                    }
                }
            }
        }
    }
    assert_eq!(inspected(&["--point", "0,0,0"])["points"][0].get("trace"), None, "only where it is asked for");
}

#[test]
fn other_conventions_are_followed_too() {
    for ndc in ["direct3d", "vulkan-reversed", "webgpu-reversed-infinite", "opengl-reversed"] {
        let report = inspected(&["--point", "0.5,1,0", "--trace", "--ndc", ndc]);
        let point = &report["points"][0];
        assert_eq!(point["trace"][1]["equation"], ndc);
        for step in point["trace"].as_array().unwrap() {
            assert_eq!(numbers(&step["output"]), numbers(&point[step["to"].as_str().unwrap()]));
            for (row, output) in step["terms"].as_array().unwrap().iter().zip(numbers(&step["output"])) {
                let sum: f64 = numbers(row).iter().sum();
                assert!((sum - output).abs() <= 1e-12 * (1.0 + output.abs()), "{ndc}: {step}");
            }
        }
    }
}

#[test]
fn a_pixel_with_a_depth_leads_to_the_point_that_has_them() {
    for operation in ["azimuth=0", "azimuth=40"] {
        let report = inspected(&["--depth-pixel", "300,200,0.75", "--op", operation]);
        let way = &report["depth_pixels"][0];
        assert_eq!((&way["pixel"], &way["depth"]), (&serde_json::json!([300, 200]), &serde_json::json!(0.75)));
        let world: Vec<String> = numbers(&way["world"]).iter().map(f64::to_string).collect();
        let again = inspected(&["--op", operation, "--point", &world.join(",")]);
        let point = &again["points"][0];
        assert_eq!(point["pixel"], serde_json::json!([300, 200]));
        assert!((numbers(&point["viewport"])[2] - 0.75).abs() < 1e-12);
        let steps: Vec<&str> = way["trace"].as_array().unwrap().iter().map(|s| s["to"].as_str().unwrap()).collect();
        assert_eq!(steps, ["window", "ndc", "homogeneous", "view", "world"]);
        for step in way["trace"].as_array().unwrap() {
            for (row, output) in step["terms"].as_array().unwrap().iter().zip(numbers(&step["output"])) {
                let sum: f64 = numbers(row).iter().sum();
                assert!((sum - output).abs() <= 1e-12 * (1.0 + output.abs()), "{step}");
            }
        }
    }
}

#[test]
fn untraceable_points_are_refused_with_the_allowed_values() {
    let bench = Bench::new("trace-refused");
    bench.write("f.toml", FIGURE);
    for (arguments, said) in [
        (&["--trace"][..], "--point"),
        (&["--depth-pixel", "1,2"], "I,J,Z"),
        (&["--depth-pixel", "1.5,2,0.5"], "two integers"),
        (&["--depth-pixel", "1,2,2"], "no point of the world is that far"),
    ] {
        let run = bench.run(&[&["inspect", "f.toml"], arguments].concat());
        let message = run.refused(2);
        assert!(message.contains(said), "{message}");
    }
    bench.write("flat.toml", "[viewport]\ndepth_near = 0.5\ndepth_far = 0.5\n");
    let run = bench.run(&["inspect", "flat.toml", "--depth-pixel", "1,2,0.5", "--lang", "pt-BR"]);
    assert!(run.refused(2).contains("depth_near = depth_far"));
}
