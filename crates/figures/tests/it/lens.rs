//! The lens in other words than θ, in figure files and in reports. Values are Blender's, or from tables of focal
//! lengths.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{Camera, Convention, ImageSize, Parameters, Sensor, SensorFit, ViewWindow};
use camera_lab_figures::figure::error::{Allowed, Problem};
use camera_lab_figures::figure::read::parse;
use camera_lab_figures::figure::variation::{Variation, variants};
use camera_lab_figures::figure::write::to_toml;
use camera_lab_figures::figure::{Figure, difference, number_at, update, varied};
use camera_lab_figures::inspect::Report;

fn figure(camera: &str) -> Figure {
    parse(&format!("[camera]\n{camera}\n")).unwrap()
}

fn is_near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 5e-5, "{found}, expected {expected}");
}

fn report(figure: &Figure) -> Report {
    Report::new(figure, &[], Convention::default(), &[], &[]).unwrap()
}

const WIDE: ImageSize = ImageSize { width: 1920, height: 1080 };

#[test]
fn a_focal_length_has_the_angles_of_blender() {
    // 50 mm on 36 × 24, 1920 × 1080: camera.data.angle_x is 39.5978°, and the height is 9/16 of the width.
    let lens = |fit: &str, aspect: &str| {
        figure(&format!("aspect = \"{aspect}\"\nlens = {{ focal_length = 50, sensor = [36, 24], fit = \"{fit}\" }}"))
    };
    let wide = Figure { image: WIDE, ..lens("horizontal", "16/9") };
    let found = report(&wide).lens.unwrap();
    is_near(found.horizontal_angle, 39.5978);
    let vertical = 2.0 * ((39.597_752_709_049_86_f64.to_radians() / 2.0).tan() * 9.0 / 16.0).atan().to_degrees();
    assert!((wide.camera.view_angle - vertical).abs() < 1e-12, "{}", wide.camera.view_angle);
    // f in pixels: 50/36 of the width, and pixels are square.
    let [f_x, f_y] = found.focal_length_pixels;
    assert!((f_x - 1920.0 * 50.0 / 36.0).abs() < 1e-9 && (f_y - f_x).abs() < 1e-9);
    // The height of the sensor spans the height of the image, whatever the aspect.
    for aspect in ["16/9", "9/16"] {
        is_near(lens("vertical", aspect).camera.view_angle, 26.9915);
    }
    // Auto: 36 mm span the larger side.
    assert_eq!(lens("larger", "16/9").camera.view_angle, wide.camera.view_angle);
    is_near(lens("larger", "9/16").camera.view_angle, 39.5978);
    // The diagonal of 36 × 24 behind 50 mm: 46.79°, as every table has it.
    is_near(report(&lens("horizontal", "3/2")).lens.unwrap().diagonal_angle, 46.7930);
}

#[test]
fn a_horizontal_angle_is_the_one_that_is_read_back() {
    // 90° and 4 : 3: tan θ/2 is 3/4.
    let found = figure("horizontal_angle = 90");
    is_near(found.camera.view_angle, 73.7398);
    is_near(report(&found).lens.unwrap().horizontal_angle, 90.0);
    assert_eq!(figure("horizontal_angle = \"90°\"\naspect = 1").camera.view_angle, 90.0);
}

#[test]
fn the_form_survives_until_the_angle_changes() {
    for text in [
        "[camera]\nhorizontal_angle = 60 # wide\n",
        "[camera]\nlens = { focal_length = 35, sensor = [36, 24], fit = \"larger\" } # ours\n",
        "[camera.lens]\nfocal_length = 85\n",
    ] {
        let before = parse(text).unwrap();
        assert_eq!(parse(&to_toml(&before)).unwrap(), before, "{text}");
        let mut moved = before.clone();
        moved.camera.near = 0.5;
        let saved = update(text, &moved);
        assert!(text.lines().all(|line| saved.contains(line)) && saved.contains("near = 0.5"), "{saved}");
        assert_eq!(parse(&saved).unwrap(), moved);
        let mut turned = before.clone();
        turned.camera.view_angle = 20.0;
        let saved = update(text, &turned);
        assert!(
            saved.contains("view_angle = 20.0") && !saved.contains("horizontal") && !saved.contains("focal_length")
        );
        assert_eq!(parse(&saved).unwrap().camera, turned.camera);
    }
}

#[test]
fn two_ways_to_give_the_angle_are_an_error() {
    for (text, key, rival) in [
        ("view_angle = 40\nhorizontal_angle = 60", "[camera] horizontal_angle", "view_angle"),
        ("lens = { focal_length = 35 }\nview_angle = 40", "[camera] lens", "view_angle"),
        ("horizontal_angle = 60\nlens = { focal_length = 35 }", "[camera] lens", "horizontal_angle"),
    ] {
        let error = parse(&format!("[camera]\n{text}\n")).unwrap_err();
        assert_eq!(error.key, key);
        assert!(matches!(error.problem, Problem::Rival { other, .. } if other == rival), "{error}");
    }
}

#[test]
fn values_out_of_range_name_line_key_and_range() {
    for (text, line, key, range) in [
        ("near = 1\nhorizontal_angle = 180", 3, "[camera] horizontal_angle", Allowed::HalfTurn),
        ("horizontal_angle = 0", 2, "[camera] horizontal_angle", Allowed::HalfTurn),
        ("lens = { focal_length = 0 }", 2, "[camera] lens.focal_length", Allowed::PositiveNumber),
        ("lens = { focal_length = 35, sensor = [36, -24] }", 2, "[camera] lens.sensor", Allowed::PositivePair),
        ("lens = { focal_length = 35, sensor = [36] }", 2, "[camera] lens.sensor", Allowed::PositivePair),
    ] {
        let error = parse(&format!("[camera]\n{text}\n")).unwrap_err();
        assert_eq!((error.line, error.key.as_str()), (line, key));
        assert!(matches!(&error.problem, Problem::Value { allowed, .. } if *allowed == range), "{error}");
    }
    let error = parse("[camera]\nlens = { sensor = [36, 24] }\n").unwrap_err();
    assert_eq!((error.key.as_str(), error.line), ("[camera] lens.focal_length", 2));
    let error = parse("[camera]\nlens = { focal_length = 35, fit = \"auto\" }\n").unwrap_err();
    assert_eq!(error.key, "[camera] lens.fit");
    // Possible by itself, but no angle below 180° is left.
    let error = parse("[camera]\nnear = 1\nlens = { focal_length = 1e-300 }\n").unwrap_err();
    assert_eq!((error.line, error.key.as_str()), (3, "[camera] lens"));
}

#[test]
fn a_family_varies_the_lens_whatever_the_file_has() {
    let figure = figure("lens = { focal_length = 35, sensor = [36, 24], fit = \"vertical\" }");
    let camera = Camera::new(&figure.camera).unwrap();
    let family = |key: &str| {
        let variation = Variation::parse(key, None).unwrap();
        let found = variants(&figure, &camera, &[variation], Convention::default(), 9).unwrap();
        found.iter().map(|variant| variant.camera.view_angle().degrees()).collect::<Vec<_>>()
    };
    for (found, table) in family("camera.lens.focal_length=24,50,85").into_iter().zip([53.1301, 26.9915, 16.0714]) {
        is_near(found, table);
    }
    is_near(family("camera.view_angle=20,40")[1], 40.0);
    is_near(family("camera.horizontal_angle=90,40")[0], 73.7398);
    assert_eq!(number_at(&figure, "camera.view_angle"), Some(figure.camera.view_angle));
    assert_eq!(varied(&figure, "camera.aspect", "2").unwrap().camera.view_angle, figure.camera.view_angle);
    let steps = difference(Some(&figure), &varied(&figure, "camera.view_angle", "40").unwrap());
    assert_eq!((steps.changed.to_string().as_str(), steps.without.len()), ("[camera]\nview_angle = 40.0\n", 0));
}

#[test]
fn parallel_projectors_have_no_lens() {
    let found = figure("projection = \"parallel\"\nhorizontal_angle = 60\nheight = 3");
    assert_eq!(report(&found).lens, None);
    assert_eq!(report(&found).window.height, 3.0);
}

#[test]
fn an_asymmetric_window_is_a_shift_as_blender_counts_it() {
    // F 2, W × H of 4 × 3 whose middle is (1, −0.75): shares of the larger side, which is W.
    let window = ViewWindow { left: -1.0, right: 3.0, bottom: -2.25, top: 0.75 };
    let camera = Camera::new(&Parameters { near: 2.0, window: Some(window), ..Parameters::default() }).unwrap();
    let sensor = |fit| Sensor { fit, ..Sensor::default() };
    assert_eq!(camera.lens_shift(sensor(SensorFit::Larger)), [0.25, -0.1875]);
    assert_eq!(camera.lens_shift(sensor(SensorFit::Vertical)), [1.0 / 3.0, -0.25]);
    assert_eq!(camera.window_with_shift(sensor(SensorFit::Larger), [0.25, -0.1875]), window);
    assert_eq!(camera.focal_length(sensor(SensorFit::Horizontal)), 18.0);
    assert_eq!(camera.view_size_at(10.0), [20.0, 15.0]);
    let lens = camera.lens_numbers(ImageSize { width: 400, height: 300 }).unwrap();
    assert_eq!(lens.focal_length_pixels, [200.0, 200.0]);
    is_near(lens.horizontal_angle, 26.5651 + 56.3099);
    // Between (−1, −2.25, −2) and (3, 0.75, −2).
    let cosine = (-3.0 - 1.6875 + 4.0) / (10.0625_f64.sqrt() * 13.5625_f64.sqrt());
    is_near(lens.diagonal_angle, cosine.acos().to_degrees());
}
