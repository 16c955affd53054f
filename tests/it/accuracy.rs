//! Error against run time: the studies' results agree with the theory, and the command prints them.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::OnceLock;

use camera_lab::appearance::Filter;
use camera_lab::figure::{ShadowReveal, read};
use camera_lab::numerics::{Effort, Findings, OWN, Row, Study, run};
use camera_lab::progress::{Progress, at_once};
use camera_lab::scene::{Shadows, TextureSource};
use camera_lab_words::Lang;
use camera_lab_words::why::numerics as words;

use crate::common::program::Bench;

/// The results of a study with few inputs: the same for all tests.
fn findings(study: Study) -> &'static Findings {
    static FOUND: [OnceLock<Findings>; Study::ALL.len()] = [const { OnceLock::new() }; Study::ALL.len()];
    let place = Study::ALL.iter().position(|s| *s == study).unwrap();
    FOUND[place]
        .get_or_init(|| at_once(run(study, &Effort { seed: 7, seconds: 0.0, thorough: false }, &Progress::default())))
}

fn row<'a>(findings: &'a Findings, case: &str, parameter: f64, method: &str) -> &'a Row {
    let found = findings.rows.iter().find(|r| r.case == case && r.parameter == parameter && r.method == method);
    found.unwrap_or_else(|| panic!("{case}, {parameter}, {method}"))
}

#[test]
fn every_case_has_all_methods_one_of_them_the_programs_own_and_a_front() {
    for study in Study::ALL {
        let findings = findings(study);
        let methods = findings.methods();
        assert_eq!(methods.iter().filter(|&&m| m == OWN).count(), 1, "{}", study.name());
        for rows in findings.rows.chunks(methods.len()) {
            assert!(rows.iter().all(|r| r.case == rows[0].case && r.parameter == rows[0].parameter));
            assert_eq!(rows.iter().map(|r| r.method).collect::<Vec<_>>(), methods);
            assert!(rows.iter().any(|r| r.pareto));
            for r in rows {
                assert!(r.error.is_finite() && r.error >= 0.0 && r.error <= r.error_max * (1.0 + 1e-12), "{r:?}");
                assert!((0.0..=64.0).contains(&r.bits) && r.nanos > 0.0, "{r:?}");
                assert!(r.nanos_low <= r.nanos && r.nanos <= r.nanos_high && r.bytes >= 0.0, "{r:?}");
                let beaten = rows.iter().any(|o| o.error <= r.error && o.nanos_high < r.nanos_low);
                assert_eq!(r.pareto, !beaten, "{r:?}");
            }
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_errors_and_another_seed_others() {
    let errors = |seed| {
        let effort = Effort { seed, seconds: 0.0, thorough: false };
        let rows = at_once(run(Study::VertexTransform, &effort, &Progress::default())).rows;
        rows.iter().map(|r| (r.error, r.error_max, r.bits)).collect::<Vec<_>>()
    };
    assert_eq!(errors(1), errors(1));
    assert_ne!(errors(1), errors(2));
}

/// Every case and every method has a name in Portuguese, or is the same in both languages.
#[test]
fn every_case_and_method_is_translated() {
    const SAME: &[&str] =
        &["double-double", "f32", "gouraud", "phong", "bilinear", "trilinear", "4 bits", "12 bits", OWN];
    for study in Study::ALL {
        for r in &findings(study).rows {
            for english in [r.case.as_str(), r.method] {
                let translated = words::name(Lang::PtBr, english) != english || SAME.contains(&english);
                assert!(translated, "{english} of {}", study.name());
                assert_eq!(words::name(Lang::En, english), english);
            }
        }
    }
}

/// The figures of the worst inputs open: they are the cameras that were measured.
#[test]
fn the_figure_of_the_worst_input_is_a_camera() {
    for study in Study::ALL {
        for r in &findings(study).rows {
            let figure = read::parse(r.figure.as_ref().unwrap()).unwrap();
            camera_lab::camera::Camera::new(&figure.camera).unwrap();
        }
    }
}

/// A pixel turns a line by its inverse length, and the intersection of two lines moves by that over their angle.
#[test]
fn the_camera_of_a_photograph_is_off_by_the_inverse_of_the_angle_between_the_lines() {
    let findings = findings(Study::Photograph);
    let error = |case, angle, method| row(findings, case, angle, method).error;
    for case in ["view angle", "direction"] {
        let share = error(case, 5.0, OWN) / error(case, 20.0, OWN);
        assert!((1.5..12.0).contains(&share), "{case}: {share}");
        for angle in [40.0, 20.0, 10.0, 5.0] {
            assert!(error(case, angle, OWN) < 1.3 * error(case, angle, "two lines"), "{case} {angle}");
        }
    }
    // Of the intersections of many lines, the worst decide their mean.
    assert!(error("view angle", 0.5, "mean of intersections") > 1.5 * error("view angle", 0.5, OWN));
}

/// A coordinate of 10^k in single precision is off by about 10^k · 2^-25. Relative to the eye it is not.
#[test]
fn single_precision_loses_a_world_far_away_and_keeps_it_relative_to_the_eye() {
    let findings = findings(Study::VertexTransform);
    for distance in [1.0, 1e3, 1e6, 1e9, 1e12] {
        let error = |method| row(findings, "perspective", distance, method).error;
        let half_ulp = distance * 2f64.powi(-25);
        assert!((0.3..30.0).contains(&(error("f32 matrix") / half_ulp.max(5e-8))), "{distance}");
        assert!(error("f32 relative to eye") < 1e-6);
        assert!(error("f64 stages") < 1e-15 && error(OWN) <= error("f64 stages"));
        assert!(error("camera-lab pictures") < 1e-15);
        assert!(distance < 1e3 || error("f64 matrix") > 100.0 * error("f64 stages"));
    }
}

/// The axis u is off by the unit roundoff over the angle: Higham, *Accuracy and Stability of Numerical Algorithms*,
/// 2002, §1.7 on cancellation.
#[test]
fn a_naive_basis_is_off_by_roundoff_over_the_angle_and_the_own_is_not() {
    let findings = findings(Study::Basis);
    for angle in [1e-2, 1e-6, 1e-11, 1e-13] {
        let error = |method| row(findings, "size 1", angle, method).error;
        assert!((0.01..10.0).contains(&(error("f64 naive") * angle / f64::EPSILON)), "{angle}");
        assert!(error(OWN) < f64::EPSILON / 2.0 && error("double-double") < f64::EPSILON / 2.0);
    }
    // Squares of 1e-165 are zero.
    assert!(row(findings, "size 1e-150", 1e-15, "f64 naive").error > 3.0);
    assert!(row(findings, "size 1e-150", 1e-15, OWN).error < f64::EPSILON);
}

#[test]
fn matrices_drift_with_the_number_of_operations_and_the_program_does_not() {
    let findings = findings(Study::RepeatedOperations);
    for case in ["orthonormality", "distance", "position"] {
        let drift = |method| row(findings, case, 1000.0, method).error / row(findings, case, 10.0, method).error;
        assert!(drift("f64 matrix") > 10.0, "{case}");
        assert!(row(findings, case, 1000.0, OWN).error < 1e-15, "{case}");
    }
}

/// The measured interval is the predicted one: exactly if the arithmetic is that of the format, within a few roundings
/// otherwise.
#[test]
fn depths_are_resolved_as_the_theory_predicts() {
    let findings = findings(Study::DepthBuffer);
    for r in findings.rows.iter().filter(|r| !r.case.contains("z-fighting")) {
        let share = r.error / r.predicted.unwrap();
        let most = if r.method == "f32 reversed" || r.parameter >= 1e7 { 1e3 } else { 12.0 };
        assert!((0.1..most).contains(&share), "{share} {} {} {}", r.case, r.parameter, r.method);
    }
    // A surface 1 ‰ behind another: 16 bits flicker from B / F = 100 on, 24 bits from 1e5 on, reversed floats never.
    let fights = |ratio, method| row(findings, "perspective z-fighting", ratio, method).error > 0.0;
    assert!(!fights(10.0, "fixed 16") && fights(1e3, "fixed 16"));
    assert!(!fights(1e4, "fixed 24") && fights(1e5, "fixed 24"));
    assert!(!fights(1e9, "f32 reversed") && !fights(1e9, OWN));
}

#[test]
fn dividing_first_is_wrong_only_if_a_segment_passes_the_eye() {
    let findings = findings(Study::Clipping);
    for behind in [1e-9, 1.0, 1e6] {
        for method in ["f64 after the divide", "f64 before the divide", OWN] {
            assert!(row(findings, "in front", behind, method).error < 1e-12, "{method}");
        }
        assert!(row(findings, "through w = 0", behind, "f64 after the divide").error > 0.1);
        assert!(row(findings, "through w = 0", behind, "f64 before the divide").error < 1e-12);
        assert!(row(findings, "through w = 0", behind, OWN).error < 1e-14);
    }
}

#[test]
fn a_cancelled_study_ends_with_its_partial_results() {
    let progress = Progress::default();
    progress.cancel();
    let effort = Effort { seed: 1, seconds: 60.0, thorough: true };
    for study in Study::ALL {
        assert!(at_once(run(study, &effort, &progress)).rows.len() <= 60, "{}", study.name());
    }
}

#[test]
fn the_command_prints_json_csv_and_tables_and_refuses_unknown_words() {
    let bench = Bench::new("accuracy");
    let run = |more: &[&str]| {
        bench.run(&[&["accuracy", "--study", "clipping", "--seconds", "0", "--seed", "3"][..], more].concat())
    };
    let text = |more| String::from_utf8(run(more).done().to_vec()).unwrap();
    let value = run(&["--format", "json"]).json();
    assert_eq!(value["seed"], 3);
    assert_eq!(value["studies"][0]["study"], "clipping");
    let first = value["studies"][0]["rows"][0].as_object().unwrap();
    for key in [
        "case",
        "parameter",
        "method",
        "error",
        "error_max",
        "unit",
        "nanos",
        "bits",
        "pareto",
        "figure",
        "nanos_low",
        "nanos_high",
        "bytes",
        "undecided",
    ] {
        assert!(first.contains_key(key), "{key}");
    }
    let csv = text(&["--format", "csv"]);
    assert_eq!(csv.lines().count(), value["studies"][0]["rows"].as_array().unwrap().len() + 1);
    assert!(csv.starts_with("study,case,parameter,method,error,error_max,unit,nanos,bits,pareto,predicted,nanos_low,nanos_high,bytes,undecided\n"));
    let table = text(&["--lang", "pt-BR"]);
    assert!(table.contains("Segmentos por w = 0") && table.contains("f64 depois da divisão"), "{table}");
    for (args, named) in [
        (["--seconds", "-1"], "--seconds"),
        (["--seed", "x"], "--seed"),
        (["--study", "nothing"], "vertex-transform"),
        (["--plot", "a.gif"], ".svg, .pdf, .tex"),
    ] {
        let run = bench.run(&["accuracy", args[0], args[1]]);
        assert!(run.refused(2).contains(named), "{}", run.err);
    }
}

#[test]
fn plots_are_files_of_their_kind() {
    let bench = Bench::new("plots");
    let plot = |name: &str| {
        bench.run(&["accuracy", "--study", "clipping", "--seconds", "0", "--plot", name]).done();
    };
    for (name, start) in
        [("plot.svg", &b"<svg"[..]), ("plot.png", b"\x89PNG"), ("plot.webp", b"RIFF"), ("plot.pdf", b"%PDF")]
    {
        plot(name);
        let bytes = bench.read(name);
        assert!(bytes.starts_with(start) && bytes.len() > 5_000, "{name}: {}", bytes.len());
    }
    assert!(String::from_utf8_lossy(&bench.read("plot.svg")).contains(">f32 before the divide</text>"));
    plot("plot.tex");
    let latex = String::from_utf8_lossy(&bench.read("plot.tex")).into_owned();
    assert!(latex.contains("{plot-art}") && latex.contains("f32 before the divide"), "{latex}");
    assert!(bench.read("plot-art.pdf").starts_with(b"%PDF"));
}

/// Of three bars each over the next no order of whole faces is right. A depth buffer and a BSP, which cuts them, are
/// right except at edges.
#[test]
fn interlocking_surfaces_break_the_painter_and_coarse_steps_the_buffer() {
    let findings = findings(Study::Visibility);
    let error = |case, ratio, method| row(findings, case, ratio, method).error;
    for case in ["cyclic overlap", "interpenetrating"] {
        assert!(error(case, 10.0, "painter") > 0.005, "{case}");
        for method in ["bsp", "depth buffer 24", OWN] {
            assert!(error(case, 10.0, method) < 0.001, "{case} {method}");
        }
    }
    assert!(error("close surfaces", 1e5, "depth buffer 16") > 0.1);
    assert!(error("close surfaces", 1e5, OWN) < 0.01);
}

/// With more segments all come nearer, Phong's shading fastest. Flat faces have no highlight however small they are.
#[test]
fn finer_meshes_come_nearer_to_the_true_surface() {
    let findings = findings(Study::Shading);
    for solid in ["sphere", "torus"] {
        let gain = |method| row(findings, solid, 8.0, method).error / row(findings, solid, 32.0, method).error;
        assert!(gain("flat") > 1.2 && gain("gouraud") > 2.5 && gain("phong") > 4.0, "{solid}");
        let at = |method| row(findings, solid, 32.0, method).error;
        assert!(at("phong") < at("gouraud") && at("gouraud") < at("flat"), "{solid}");
        let silhouette = format!("{solid} silhouette");
        let outline = |segments| row(findings, &silhouette, segments, OWN).error;
        assert!(outline(8.0) > 3.0 * outline(32.0), "{solid}");
    }
}

#[test]
fn more_samples_come_nearer_to_the_area() {
    let findings = findings(Study::Antialiasing);
    for size in [8.0, 64.0] {
        let error = |method| row(findings, "triangles", size, method).error;
        assert!(error("1 sample") > 1.5 * error("4 samples") && error("4 samples") > 1.5 * error("16 samples"));
        assert!(error("64 samples on a grid") < error("16 samples on a grid"));
        assert_eq!(error(OWN), error("4 samples"));
    }
}

/// One sample of a texel of many flickers, the levels of detail keep the mean, and a magnified chequer has sharp edges.
#[test]
fn levels_of_detail_keep_the_light_while_single_texels_flicker() {
    let findings = findings(Study::TextureFilter);
    for case in ["floor from above", "slanted floor", "grazing floor"] {
        let error = |scale, method| row(findings, case, scale, method).error;
        assert!(error(15.0, "trilinear") < 0.1 && error(15.0, "nearest") > 0.3, "{case}");
        assert!(error(15.0, "bilinear") > 0.2, "{case}: bilinear has no levels");
        assert!(error(0.125, "nearest") < error(0.125, "bilinear"), "{case}");
        assert!(error(0.125, "16 samples of nearest") < 0.5 * error(0.125, "nearest"), "{case}");
        for scale in [0.125, 1.0, 4.0, 15.0] {
            // But for the samples along the border of the floor's two triangles.
            let beside = (error(scale, OWN) / error(scale, "trilinear") - 1.0).abs();
            assert!(beside < 0.05, "{case}, {scale}: {beside}");
        }
    }
}

/// Without bias faces shadow themselves, and with too much of it shadows come off. Steps of the map are halved with its
/// texels.
#[test]
fn shadows_are_wrong_without_bias_and_with_too_much_and_less_so_in_larger_maps() {
    let findings = findings(Study::Shadows);
    for case in ["screen and ball", "house", "corridor with a lamp"] {
        let error = |what: &str, map, method| row(findings, &format!("{case}{what}"), map, method).error;
        for map in [256.0, 512.0] {
            for method in findings.methods() {
                let sum = error(", acne", map, method) + error(", detached", map, method);
                assert!((sum - error("", map, method)).abs() < 1e-12, "{case}, {map}, {method}");
            }
            assert!(error(", acne", map, "bias 0, edge 1") > 0.05, "{case}, {map}");
            assert!(error("", map, "bias 1, edge 1") < 0.03, "{case}, {map}");
            let [loose, usual] = ["bias 30, edge 1", "bias 1, edge 1"].map(|method| error(", detached", map, method));
            assert!(loose > 2.0 * usual, "{case}, {map}: {loose} {usual}");
            assert!(error("", map, OWN) < 0.005, "{case}");
        }
        for method in ["bias 1, edge 0", "bias 1, edge 1"] {
            assert!(error("", 512.0, method) < 0.8 * error("", 256.0, method), "{case}, {method}");
        }
    }
}

/// The figure of a row has the shadows of its method, and marks their errors.
#[test]
fn the_worst_shadows_open_with_their_wrong_pixels_marked() {
    for r in &findings(Study::Shadows).rows {
        let figure = read::parse(r.figure.as_ref().unwrap()).unwrap();
        let shadows = figure.scene.lights[0].shadows;
        assert_eq!(figure.reveal.shadows, Some(ShadowReveal::Truth));
        let map = if r.method == OWN { 1024.0 } else { r.parameter };
        assert_eq!(f64::from(shadows.map), map, "{}", r.method);
        let named = [(shadows.bias, "bias "), (shadows.softness, "edge ")];
        let is_named = named.iter().all(|(value, word)| r.method.contains(&format!("{word}{value}")));
        assert!(is_named || r.method == OWN && shadows == Shadows::CAST, "{}: {shadows:?}", r.method);
    }
}

/// The figure of a row shows a chequer, with the filter of its method.
#[test]
fn the_worst_filter_opens_with_that_filter_on_a_chequer() {
    for r in &findings(Study::TextureFilter).rows {
        let figure = read::parse(r.figure.as_ref().unwrap()).unwrap();
        let [floor] = &figure.scene.objects[..] else { panic!("one floor") };
        let filter = match r.method {
            "nearest" | "16 samples of nearest" => Filter::Nearest,
            "bilinear" => Filter::Bilinear,
            _ => Filter::Trilinear,
        };
        assert_eq!((&floor.texture, floor.filter), (&Some(TextureSource::Chequer), Some(filter)), "{}", r.method);
    }
}
