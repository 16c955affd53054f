//! Health of a camera against independent formulas, and the command `diagnose`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::DepthFormat;
use camera_lab::camera::{Camera, ImageSize, Ndc, Parameters, Projection};
use camera_lab::figure::read;
use camera_lab::numbers::random::Random;
use camera_lab::numerics::health::{Health, HealthQuantity, Level, health};
use camera_lab::numerics::resolutions;
use glam::{DVec3, DVec4};

use crate::common::program::Bench;

const IMAGE: ImageSize = ImageSize { width: 400, height: 300 };

fn line(p: &Parameters, quantity: HealthQuantity) -> Health {
    let lines = health(&Camera::new(p).unwrap(), DepthFormat::Float, IMAGE, None);
    lines.into_iter().find(|line| line.quantity == quantity).unwrap()
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found} is not {expected}");
}

/// The depth of the next step of a depth buffer is the one at which Z (5.25), as a formula of its own, has grown by
/// 2^−24.
#[test]
fn the_values_are_those_of_formulas_of_their_own() {
    let mut random = Random::new(4, 0);
    for i in 0..200 {
        let position = random.direction() * random.between(0.0, 1e3);
        let direction = random.direction();
        let p = Parameters {
            position,
            focal_point: position + direction * random.between(1.0, 10.0),
            view_up: random.direction() * 3.0,
            near: random.between(0.1, 2.0),
            far: random.between(10.0, 1e3),
            view_angle: random.between(5.0, 170.0),
            projection: if i % 2 == 0 { Projection::Perspective } else { Projection::Parallel },
            ..Parameters::default()
        };
        let (f, b) = (p.near, p.far);
        let cosine = p.view_up.normalize().dot((p.focal_point - p.position).normalize()).abs();
        near(line(&p, HealthQuantity::VupAngle).value, cosine.acos().to_degrees());
        near(line(&p, HealthQuantity::FarNearRatio).value, b / f);
        let half = (p.view_angle / 2.0).to_radians().tan();
        let step = 2f64.powi(-24);
        match p.projection {
            Projection::Perspective => {
                // 1/d is even in Z: Z = (1/F − 1/d) / (1/F − 1/B). Its derivative at B.
                let slope = (1.0 / (b * b)) / (1.0 / f - 1.0 / b);
                near(line(&p, HealthQuantity::DepthResolution).value, step / slope);
                near(line(&p, HealthQuantity::ViewAngle).value, p.view_angle);
                let height = half * (f + b);
                let sides = [height, height * p.aspect, b - f];
                let ratio =
                    sides.iter().fold(0.0, |a: f64, &b| a.max(b)) / sides.iter().fold(1e99, |a: f64, &b| a.min(b));
                near(line(&p, HealthQuantity::VolumeShape).value, ratio);
            }
            Projection::Parallel => {
                near(line(&p, HealthQuantity::DepthResolution).value, step * (b - f));
                assert_eq!(line(&p, HealthQuantity::ViewAngle).value, 0.0);
            }
        }
        let greatest = p.position.abs().max(p.focal_point.abs()).max_element();
        let lost = (greatest / p.position.distance(p.focal_point)).max(1.0).log10();
        near(line(&p, HealthQuantity::PositionDigits).value, 15.954589770191003 - lost);
    }
}

#[test]
fn levels_begin_where_the_thresholds_stand() {
    use Level::{Fair, Good, Poor};
    let usual = Parameters { position: DVec3::new(0.0, 0.0, 5.0), ..Parameters::default() };
    let hold = |quantity, level, p: Parameters| assert_eq!(line(&p, quantity).level, level, "{quantity:?} {p:?}");
    for quantity in HealthQuantity::ALL {
        hold(quantity, Good, usual);
    }
    let up = |degrees: f64| {
        let angle = degrees.to_radians();
        Parameters { view_up: DVec3::new(0.0, angle.sin(), -angle.cos()), ..usual }
    };
    hold(HealthQuantity::VupAngle, Fair, up(0.5));
    hold(HealthQuantity::VupAngle, Poor, up(0.005));
    let planes = |near, far| Parameters { near, far, ..usual };
    hold(HealthQuantity::FarNearRatio, Fair, planes(0.1, 5e3));
    hold(HealthQuantity::FarNearRatio, Poor, planes(0.1, 5e4));
    hold(HealthQuantity::DepthResolution, Fair, planes(0.1, 5e3));
    hold(HealthQuantity::DepthResolution, Poor, planes(0.1, 5e4));
    let parallel = |far| Parameters { projection: Projection::Parallel, ..planes(0.1, far) };
    hold(HealthQuantity::FarNearRatio, Good, parallel(1e12));
    hold(HealthQuantity::DepthResolution, Good, parallel(1e2));
    hold(HealthQuantity::DepthResolution, Fair, parallel(1e5));
    hold(HealthQuantity::DepthResolution, Poor, parallel(1e12));
    let away = |distance: f64| {
        let position = DVec3::new(distance, 0.0, 5.0);
        Parameters { position, focal_point: DVec3::new(distance, 0.0, 0.0), ..usual }
    };
    hold(HealthQuantity::PositionDigits, Fair, away(1e6));
    hold(HealthQuantity::PositionDigits, Poor, away(1e9));
    let angle = |view_angle| Parameters { view_angle, ..usual };
    for (degrees, level) in [(1e-6, Poor), (0.5, Fair), (45.0, Good), (130.0, Fair), (179.9, Poor)] {
        hold(HealthQuantity::ViewAngle, level, angle(degrees));
    }
    hold(HealthQuantity::VolumeShape, Poor, angle(1e-3));
    hold(HealthQuantity::VolumeShape, Fair, Parameters { aspect: 1.0, ..usual });
    hold(HealthQuantity::VolumeShape, Fair, planes(6.0, 50.0));
}

/// One way to judge: if the camera has a warning, the line is not good, and a repair makes it better.
#[test]
fn if_the_camera_has_a_warning_the_line_is_not_good_and_repairs_help() {
    let mut random = Random::new(9, 1);
    let mut warned = 0;
    for _ in 0..400 {
        let e = |random: &mut Random, low: f64, high: f64| 10f64.powf(random.between(low, high));
        let position = random.direction() * e(&mut random, -2.0, 12.0);
        let near = e(&mut random, -3.0, 1.0);
        let p = Parameters {
            position,
            focal_point: position + random.direction() * e(&mut random, -1.0, 2.0),
            view_up: random.direction(),
            near,
            far: near * e(&mut random, 0.1, 9.0),
            view_angle: random.between(0.5, 179.0),
            aspect: random.between(0.5, 2.0),
            ..Parameters::default()
        };
        let Ok(camera) = Camera::new(&p) else { continue };
        let warnings = camera.warnings().len() + usize::from(camera.aspect_warning(IMAGE).is_some());
        let lines = health(&camera, DepthFormat::Float, IMAGE, None);
        assert_eq!(lines.iter().map(|line| line.warnings.len()).sum::<usize>(), warnings);
        for line in lines {
            warned += line.warnings.len();
            assert!(line.warnings.is_empty() || line.level > Level::Good, "{line:?}");
            assert!(line.value.is_finite());
            if let Some(repair) = line.repair {
                assert!(Camera::new(&repair).is_ok());
                assert_ne!(repair, p);
            }
        }
    }
    assert!(warned > 400);
}

/// z_n as the matrix of each convention has it, and two planes in each format: the length of a step against the change
/// of depth that changes the stored value by one, by a formula of its own, and stripes if that is longer than the gap.
#[test]
fn depth_formats_follow_the_convention() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let p = Parameters { projection, near: 0.5, far: 400.0, ..Parameters::default() };
        let camera = Camera::new(&p).unwrap();
        for ndc in Ndc::ALL {
            let space = camera.possible_clip_space(ndc);
            for depth in [0.5, 0.7, 30.0, 399.0, 400.0] {
                let clip = space.clip_from_view() * DVec4::new(0.1, 0.2, -depth, 1.0);
                let z_n = space.ndc_depth(depth);
                assert!((z_n - clip.z / clip.w).abs() < 1e-12, "{}: {z_n}", ndc.name());
                let [at_near, at_far] = space.ndc().depths();
                // From z_n to 0 … 1, of which 2^-16 is a step.
                let slope = (space.ndc_depth(depth * 1.0001) - space.ndc_depth(depth * 0.9999)) / (depth * 0.0002);
                let expected = (at_far - at_near).abs() / (65536.0 * slope.abs());
                let found = resolutions(&space, depth, 0.01);
                let fixed = &found[0];
                assert_eq!(fixed.format, "fixed 16");
                let expected = expected.min(800.0);
                assert!((fixed.step / expected - 1.0).abs() < 1e-3, "{} {depth}: {fixed:?} {expected}", ndc.name());
                assert_eq!(found.iter().any(|format| format.format == "f32"), !ndc.reversed);
                for format in found {
                    let through = format.planes.share_through();
                    // A step that is much shorter than the gap parts the planes everywhere, one that is much longer
                    // almost nowhere.
                    let clear = format.step < 0.004 || format.step > 0.2;
                    assert!(
                        !clear || (through > 0.5) == (format.step > 0.2),
                        "{} {depth} {}: {through}, {}",
                        ndc.name(),
                        format.format,
                        format.step
                    );
                }
            }
        }
    }
}

const BEHIND: &str = "# Mine.\n[camera]\nposition = [0, 0, 5]  # here\nfocal_point = [0, 0, 9]\n\n[image]\nwidth = 200\nheight = 150\n\n[scene]\n[[scene.objects]]\nname = \"ball\"\nshape = \"sphere\"\n";

#[test]
fn the_answer_has_the_keys_of_the_contract() {
    let bench = Bench::new("diagnose-json");
    bench.write("a.toml", BEHIND);
    let json = bench.run(&["diagnose", "a.toml", "--format", "json"]).json();
    assert_eq!((json["visible"].as_u64(), json["covered"].as_f64()), (Some(0), Some(0.0)));
    let health = json["health"].as_array().unwrap();
    let codes: Vec<&str> = health.iter().map(|line| line["code"].as_str().unwrap()).collect();
    assert_eq!(
        codes,
        ["vup-angle", "far-near-ratio", "depth-resolution", "position-digits", "volume-shape", "view-angle"]
    );
    for line in health {
        assert!(["good", "fair", "poor"].contains(&line["level"].as_str().unwrap()));
        assert!(line["value"].is_f64() && line["message"].as_str().unwrap().ends_with('.'));
    }
    let first = &json["findings"][0];
    assert_eq!((first["code"].as_str(), first["objects"][0].as_str()), (Some("behind-camera"), Some("ball")));
    assert!(first["repair"]["focal_point"].is_array());
    // An operation comes first: turned round, the camera sees it.
    let turned = bench.run(&["diagnose", "a.toml", "--op", "yaw=180", "--format", "json"]).json();
    assert_eq!(turned["findings"].as_array().unwrap().len(), 0);
    assert!(turned["visible"].as_u64().unwrap() > 1000);
    let text =
        |lang: &str| String::from_utf8(bench.run(&["diagnose", "a.toml", "--lang", lang]).done().to_vec()).unwrap();
    assert!(text("en").contains("ball: behind the camera") && text("pt-BR").contains("ball: atrás da câmera"));
}

#[test]
fn the_repair_is_written_with_comments_and_shows_the_object() {
    let bench = Bench::new("diagnose-repair");
    bench.write("a.toml", BEHIND);
    bench.run(&["diagnose", "a.toml", "--repair", "-o", "b.toml"]).done();
    let text = String::from_utf8(bench.read("b.toml")).unwrap();
    assert!(text.starts_with("# Mine.\n[camera]\nposition = [0, 0, 5]  # here\n"), "{text}");
    read::parse(&text).unwrap();
    let json = bench.run(&["diagnose", "b.toml", "--format", "json"]).json();
    assert_eq!(json["findings"].as_array().unwrap().len(), 0);
    assert!(json["visible"].as_u64().unwrap() > 1000);
    // There is nothing to repair now. The output says so, and the figure stays as it is.
    let again = bench.run(&["diagnose", "b.toml", "--repair", "-o", "c.toml"]);
    assert!(again.status == Some(0) && again.err.contains("nothing to repair"), "{}", again.err);
    assert_eq!(bench.read("c.toml"), bench.read("b.toml"));
    // Both options, or none.
    bench.run(&["diagnose", "a.toml", "--repair"]).refused(2);
    bench.run(&["diagnose", "a.toml", "-o", "d.toml"]).refused(2);
}

/// A figure that goes to another folder still finds its meshes.
#[test]
fn a_repaired_figure_in_another_folder_has_the_same_meshes() {
    let bench = Bench::new("diagnose-meshes");
    for folder in ["aula/meshes", "other"] {
        std::fs::create_dir_all(bench.path(folder)).unwrap();
    }
    bench.write("aula/meshes/face.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    let text = "[camera]\nposition = [0, 0, 5]\nfocal_point = [0, 0, 9]\n\n[scene]\n[[scene.objects]]\nname = \"face\"\nshape = \"mesh\"\npath = \"meshes/face.obj\"  # here\n";
    bench.write("aula/a.toml", text);
    bench.run(&["diagnose", "aula/a.toml", "--repair", "-o", "aula/b.toml"]).done();
    assert!(String::from_utf8(bench.read("aula/b.toml")).unwrap().contains("path = \"meshes/face.obj\"  # here"));
    for there in ["other/b.toml", "b.toml"] {
        bench.run(&["diagnose", "aula/a.toml", "--repair", "-o", there]).done();
        let json = bench.run(&["diagnose", there, "--format", "json"]).json();
        assert!(json["visible"].as_u64().unwrap() > 1000 && json["findings"].as_array().unwrap().is_empty(), "{there}");
    }
    assert!(String::from_utf8(bench.read("b.toml")).unwrap().contains("path = \"aula/meshes/face.obj\""));
}

/// The parts of a named scene have names in the language. Programs read the name itself.
#[test]
fn objects_of_a_named_scene_have_their_names_in_the_language() {
    let bench = Bench::new("diagnose-names");
    bench.write("a.toml", "[camera]\nposition = [0, 0, 9]\nfocal_point = [0, 0, 20]\n\n[scene]\npreset = \"house\"\n[[scene.objects]]\nname = \"my tree\"\nshape = \"box\"\n");
    let json = bench.run(&["diagnose", "a.toml", "--format", "json", "--lang", "pt-BR"]).json();
    let first = &json["findings"][0];
    let names: Vec<&str> = first["objects"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    assert!(names.contains(&"walls") && names.contains(&"my tree"), "{names:?}");
    assert!(first["message"].as_str().unwrap().starts_with("chão, paredes, telhado, chaminé e mais "), "{first}");
}

/// The figures that come with the program are as they should be.
#[test]
fn nothing_is_wrong_with_the_figures_that_come_with_the_program() {
    let bench = Bench::new("diagnose-shipped");
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/figures");
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let json = bench.run(&["diagnose", entry.to_str().unwrap(), "--format", "json"]).json();
        let findings = json["findings"].as_array().unwrap();
        let expected: &[&str] = if entry.ends_with("empty.toml") { &["empty-scene"] } else { &[] };
        let codes: Vec<&str> = findings.iter().map(|finding| finding["code"].as_str().unwrap()).collect();
        assert_eq!(codes, expected, "{}", entry.display());
        let lines = json["health"].as_array().unwrap();
        let bad: Vec<&str> =
            lines.iter().filter(|line| line["level"] != "good").map(|line| line["code"].as_str().unwrap()).collect();
        // [0] 5.2 asks for a picture of 1024 × 768 of a window of 3 : 4.
        let expected: &[&str] = if entry.ends_with("exercise-5.2.toml") { &["volume-shape"] } else { &[] };
        assert_eq!(bad, expected, "{}", entry.display());
    }
}

/// Depths that an `f64` has no number for are reported as such. Any other depth is a number, in whatever way it was
/// computed.
#[test]
fn no_sentence_and_no_number_is_infinite() {
    let bench = Bench::new("diagnose-infinite");
    for (camera, known) in [
        ("position = [0, 0, 1e300]\n", "more than 10³⁰⁸ at PF"),
        ("near = 1e-100\nfar = 1e150\n", "more than 10³⁰⁸ at B"),
        // (1e157)² is one, a step of 2⁻²⁴ of it is none.
        ("near = 1\nfar = 1e157\n", "5.96e306 at B"),
        ("position = [0, 0, 1e300]\nprojection = \"parallel\"\nfar = 1e300\n", "5e299 times"),
    ] {
        bench.write("f.toml", format!("[image]\nwidth = 16\nheight = 12\n[camera]\n{camera}"));
        for lang in ["en", "pt-BR"] {
            let of = |format: &str| {
                let run = bench.run(&["diagnose", "f.toml", "--format", format, "--lang", lang]);
                String::from_utf8(run.done().to_vec()).unwrap()
            };
            let (text, json) = (of("text"), of("json"));
            assert!(lang != "en" || (text.contains(known) && json.contains(known)), "{camera}: {text}");
            for said in [&text, &json] {
                let words = said.split(|c: char| !c.is_alphanumeric());
                assert!(words.into_iter().all(|word| !["inf", "NaN", "nan"].contains(&word)), "{camera}: {said}");
            }
            let answer: serde_json::Value = serde_json::from_str(&json).unwrap();
            let health = answer["health"].as_array().unwrap();
            assert!(health.iter().all(|line| line["value"].as_f64().is_some_and(f64::is_finite)), "{json}");
        }
    }
}

/// A narrow view magnifies roundings, and the proof says to how many pixels.
#[test]
fn the_distance_of_vertices_from_their_places_is_proved_for_this_figure() {
    let bench = Bench::new("diagnose-placed");
    let within = |degrees: f64| {
        let small = "[[scene.objects]]\nname = \"box\"\nshape = \"box\"\nscale = [1e-10, 1e-10, 1e-10]\n";
        bench.write("placed.toml", format!("[camera]\nview_angle = {degrees:?}\n{small}"));
        let run = bench.run(&["diagnose", "placed.toml", "--lang", "en"]);
        let text = String::from_utf8_lossy(run.done());
        assert!(text.contains("of its place, proved."), "{text}");
        bench.run(&["diagnose", "placed.toml", "--format", "json"]).json()["placed_within"].as_f64().unwrap()
    };
    let ordinary = within(45.0);
    // Half a step of the grid of 1/256 of a pixel in x and in y, and hardly more.
    assert!((1.0 / 256.0..0.02).contains(&ordinary), "{ordinary}");
    assert!(within(1e-8) > 2.0 * ordinary);
}

/// VUP is 0.001° from the line of sight. The basis loses five digits by the question itself, and none by our method.
#[test]
fn the_check_tells_the_loss_of_the_question_from_that_of_the_method() {
    let bench = Bench::new("diagnose-question");
    bench.write("stiff.toml", "[camera]\nview_up = [3.0, 4.00014966, 5.0]\n");
    for (lang, said) in [
        ("en", ["VUP is 0.001° from the line of sight", "The question itself loses 4.5 digits; our method loses none"]),
        (
            "pt-BR",
            ["VUP está a 0,001° da linha de visão", "A própria pergunta perde 4,5 dígitos; o nosso método, nenhum"],
        ),
    ] {
        let run = bench.run(&["diagnose", "stiff.toml", "--lang", lang]);
        let text = String::from_utf8_lossy(run.done());
        assert!(said.iter().all(|said| text.contains(said)), "{text}");
    }
}
