//! The camera as code, and in other words: glam's runs here, GLU's numbers go through the formulas of its manual,
//! others are run by `tests/code/check.py`.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::Path;

use camera_lab::camera::{
    Camera, Certainty, ImageSize, MatrixTextError, Parameters, Projection, Stated, Unknown, ViewWindow, read_cameras,
    recognise,
};
use camera_lab::explain::Setting;
use camera_lab::explain::code::{CodeConvention, CodeTarget};
use camera_lab::explain::vocabulary::{CameraNumber, Limitation, Line, Vocabulary};
use camera_lab_words::Lang;
use camera_lab_words::why::code as texts;
use glam::{DMat3, DMat4, DVec3, DVec4};
use proptest::prelude::*;

use crate::common::any_camera::plain_camera;
use crate::common::camera::camera;
use crate::common::program::Bench;

const IMAGE: ImageSize = ImageSize { width: 640, height: 480 };

/// Three cameras whose code for glam is kept in `tests/code`. This file includes it and so runs it.
fn cameras() -> [(&'static str, Camera, (DMat4, DMat4)); 3] {
    let pose = Parameters {
        position: DVec3::new(3.0, 4.0, 5.0),
        focal_point: DVec3::new(0.5, -1.0, 0.25),
        view_up: DVec3::new(0.1, 1.0, -0.2),
        near: 0.75,
        far: 40.0,
        view_angle: 50.0,
        aspect: 1.6,
        ..Parameters::default()
    };
    let window = Some(ViewWindow { left: -0.5, right: 0.75, bottom: -0.25, top: 0.5 });
    let made = |p: Parameters| Camera::new(&p).unwrap();
    [
        ("perspective", made(pose), include!("../code/perspective.rs")),
        ("asymmetric", made(Parameters { window, ..pose }), include!("../code/asymmetric.rs")),
        (
            "parallel",
            made(Parameters { projection: Projection::Parallel, height: 5.0, ..pose }),
            include!("../code/parallel.rs"),
        ),
    ]
}

#[test]
fn code_for_glam_gives_the_matrices() {
    for (name, camera, (view, projection)) in cameras() {
        let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
        let comments = texts::comments(Lang::En, CodeTarget::Glam, &CodeTarget::Glam.conventions(&camera));
        let code = CodeTarget::Glam.code(&setting, &comments);
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/code").join(format!("{name}.rs"));
        // An expression, as `include!` wants it.
        let expression = format!("{{\n{code}(view, projection)\n}}\n");
        if std::env::var_os("UPDATE_CODE").is_some() {
            std::fs::write(&kept, &expression).unwrap();
        }
        assert_eq!(
            std::fs::read_to_string(&kept).unwrap(),
            expression,
            "UPDATE_CODE=1 renews it: then run the test again"
        );
        assert!(view.abs_diff_eq(camera.view_from_world(), 1e-14), "{name}: {view}");
        assert!(projection.abs_diff_eq(camera.clip_from_view(), 1e-13), "{name}: {projection}");
    }
}

/// The numbers between the parentheses of a call.
fn numbers(code: &str, call: &str) -> Vec<f64> {
    let from = code.split_once(&format!("{call}(")).unwrap_or_else(|| panic!("{call} in {code}")).1;
    let inside = from.split_once(");").unwrap().0;
    inside.split(',').map(|x| x.trim().parse().unwrap()).collect()
}

#[test]
fn calls_of_opengl_give_the_matrices_by_the_formulas_of_its_manual() {
    for (name, camera, _) in cameras() {
        let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
        let code = CodeTarget::OpenGl.code(&setting, &[]);
        let projection = match name {
            "perspective" => {
                let [fovy, aspect, near, far] = numbers(&code, "gluPerspective").try_into().unwrap();
                let f = 1.0 / (fovy.to_radians() / 2.0).tan();
                DMat4::from_cols(
                    DVec4::X * (f / aspect),
                    DVec4::Y * f,
                    DVec4::new(0.0, 0.0, (far + near) / (near - far), -1.0),
                    DVec4::Z * (2.0 * far * near / (near - far)),
                )
            }
            "asymmetric" => {
                let [l, r, b, t, n, f] = numbers(&code, "glFrustum").try_into().unwrap();
                DMat4::from_cols(
                    DVec4::X * (2.0 * n / (r - l)),
                    DVec4::Y * (2.0 * n / (t - b)),
                    DVec4::new((r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0),
                    DVec4::Z * (-2.0 * f * n / (f - n)),
                )
            }
            _ => {
                let [l, r, b, t, n, f] = numbers(&code, "glOrtho").try_into().unwrap();
                DMat4::from_cols(
                    DVec4::X * (2.0 / (r - l)),
                    DVec4::Y * (2.0 / (t - b)),
                    DVec4::Z * (-2.0 / (f - n)),
                    DVec4::new(-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1.0),
                )
            }
        };
        assert!(projection.abs_diff_eq(camera.clip_from_view(), 1e-13), "{name}: {projection}");
        let look: Vec<f64> = numbers(&code, "gluLookAt");
        let [eye, centre, up] = [0, 3, 6].map(|i| DVec3::from_slice(&look[i..]));
        let f = (centre - eye).normalize();
        let s = f.cross(up.normalize()).normalize();
        let turn = DMat3::from_cols(s, s.cross(f), -f).transpose();
        let view = DMat4::from_mat3(turn) * DMat4::from_translation(-eye);
        assert!(view.abs_diff_eq(camera.view_from_world(), 1e-13), "{name}: {view}");
    }
}

#[test]
fn code_states_its_conventions_in_both_languages() {
    let [_, (_, asymmetric, _), _] = cameras();
    for target in CodeTarget::ALL {
        let conventions = target.conventions(&asymmetric);
        assert!(matches!(conventions[0], CodeConvention::OfTheNotes | CodeConvention::Axes(_)));
        let setting = Setting::new(asymmetric.notes_clip_space(), IMAGE, None);
        let [english, portuguese] = [Lang::En, Lang::PtBr].map(|lang| texts::comments(lang, target, &conventions));
        assert!(english.iter().zip(&portuguese).all(|(a, b)| a != b));
        let code = target.code(&setting, &portuguese);
        if let Some(mark) = target.comment() {
            assert!(code.starts_with(&format!("{mark}{}", portuguese[0])), "{code}");
        }
    }
    assert!(CodeTarget::ThreeJs.conventions(&asymmetric).contains(&CodeConvention::ByMatrix));
}

#[test]
fn code_is_printed_for_a_figure_after_operations() {
    let bench = Bench::new("code");
    bench.write("f.toml", "[camera]\nposition = [0, 0, 5]\n");
    let run = bench.run(&["code", "f.toml", "--for", "glm", "--op", "dolly=2", "--lang", "pt-BR"]);
    let text = String::from_utf8(run.done().to_vec()).unwrap();
    assert!(text.contains("glm::dvec3(0.0, 0.0, 2.5)") && text.contains("vetores coluna"), "{text}");
    assert!(bench.run(&["code", "f.toml", "--for", "cobol"]).refused(2).contains("threejs"));
    assert!(bench.run(&["code", "f.toml"]).refused(2).contains("--for"));
}

/// Programs whose code has no F and B.
const WITHOUT_PLANES: [CodeTarget; 5] =
    [CodeTarget::OpenCv, CodeTarget::Open3d, CodeTarget::Colmap, CodeTarget::Nerfstudio, CodeTarget::PyTorch3d];

/// The code of a camera gives it back, likely or better, with F and B if the program has them. `current` is the figure
/// that the reader has.
fn is_read_back(target: CodeTarget, camera: &Camera) -> Result<(), TestCaseError> {
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
    let comments = texts::comments(Lang::En, target, &target.conventions(camera));
    let code = target.code(&setting, &comments);
    let is_image = (camera.window_aspect() / IMAGE.aspect() - 1.0).abs() < 1e-9;
    if target == CodeTarget::Blender && !is_image && !code.contains("pixel_aspect") {
        // Blender's window has the shape of its image, unless its pixels aren't square.
        return Ok(());
    }
    let fail = |why: String| TestCaseError::fail(format!("{}: {why}\n{code}", target.name()));
    let pasted = read_cameras(code.as_bytes()).map_err(|error| fail(error.to_string()))?.remove(0);
    let stated = Stated { image: pasted.image.unwrap_or(IMAGE), ..Stated::default() };
    let aspect = camera.window_aspect();
    let current = Parameters { aspect, view_angle: 33.0, near: 0.3, far: 333.0, ..Parameters::default() };
    let found = recognise(&pasted, &stated, &current).map_err(|error| fail(error.to_string()))?;
    prop_assert!(found.best().certainty >= Certainty::Likely, "{}: open\n{code}", target.name());
    let mut read = found.best().found.parameters;
    let is_parallel = camera.projection() == Projection::Parallel;
    let has_planes = !WITHOUT_PLANES.contains(&target) && (target != CodeTarget::Unreal || is_parallel);
    if has_planes {
        let near = (read.near - camera.near()).abs() <= 1e-6 * camera.near().abs();
        prop_assert!(near && (read.far / camera.far() - 1.0).abs() < 1e-6, "{} {}\n{code}", read.near, read.far);
    } else {
        // The window over F is what the code has.
        let by = if is_parallel { 1.0 } else { camera.near() / read.near };
        let scaled = |w: ViewWindow| ViewWindow {
            left: w.left * by,
            right: w.right * by,
            bottom: w.bottom * by,
            top: w.top * by,
        };
        read.window = read.window.map(scaled);
        (read.near, read.far) = (camera.near(), camera.far());
    }
    let again = Camera::new(&read).map_err(|error| fail(error.to_string()))?;
    let (here, there) = (camera.clip_from_world(), again.clip_from_world());
    let size = here.to_cols_array().iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    prop_assert!(here.abs_diff_eq(there, 1e-6 * size), "{}: {there} is not {here}\n{code}", target.name());
    Ok(())
}

/// What we write, we read.
#[test]
fn the_code_of_each_program_gives_the_camera_back() {
    for (_, camera, _) in cameras() {
        for target in CodeTarget::ALL.into_iter().filter(|target| target.limitation(&camera).is_none()) {
            if target == CodeTarget::Latex {
                let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
                let error = read_cameras(target.code(&setting, &[]).as_bytes()).unwrap_err();
                assert_eq!(error, MatrixTextError::Latex);
            } else {
                is_read_back(target, &camera).unwrap();
            }
        }
    }
}

#[test]
fn code_is_refused_for_a_camera_that_a_program_lacks() {
    let [(_, perspective, _), (_, asymmetric, _), (_, parallel, _)] = cameras();
    for target in CodeTarget::ALL {
        assert_eq!(target.limitation(&perspective), None, "{}", target.name());
    }
    assert_eq!(CodeTarget::Bevy.limitation(&asymmetric), Some(Limitation::SymmetricOnly));
    assert_eq!(CodeTarget::Colmap.limitation(&parallel), Some(Limitation::PerspectiveOnly));
    let bench = Bench::new("code that is refused");
    bench.write("f.toml", "[camera]\nprojection = \"parallel\"\n");
    assert!(bench.run(&["code", "f.toml", "--for", "opencv"]).refused(2).contains("perspective only"));
}

/// Each row of the table of programs is that of its target.
#[test]
fn targets_and_programs_have_one_order() {
    for target in CodeTarget::ALL {
        assert_eq!(format!("{target:?}").to_lowercase(), target.word());
    }
}

/// Unreal: the rows of an `FMatrix` are its axes X (ahead), Y (right), Z (up) and its origin, in centimetres.
#[test]
fn a_camera_for_unreal_is_read_back_and_keeps_its_up() {
    for (name, camera, _) in cameras() {
        if CodeTarget::Unreal.limitation(&camera).is_some() {
            continue;
        }
        let code = CodeTarget::Unreal.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
        let vectors: Vec<DVec3> = code
            .split("FVector(")
            .skip(1)
            .map(|rest| {
                let numbers = rest.split(')').next().unwrap().split(", ").map(|x| x.parse().unwrap());
                DVec3::from_slice(&numbers.collect::<Vec<f64>>())
            })
            .collect();
        let [eye, ahead, up] = vectors[..] else { panic!("{code}") };
        assert!((up.z - camera.basis().v.y).abs() < 1e-12, "its up is z: {up}");
        // FVector::CrossProduct(Up, Ahead) is to the right there.
        let rows = [ahead, up.cross(ahead), up, eye / 100.0];
        let rows: Vec<String> = rows.map(|row| format!("{:?} {:?} {:?}", row.x, row.y, row.z)).into();
        let text = format!("{} 0\n{} 0\n{} 0\n{} 1", rows[0], rows[1], rows[2], rows[3]);
        let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
        let axes = Some(CodeTarget::Unreal.program().axes);
        for axes in [axes, None] {
            let found = recognise(pasted, &Stated { axes, ..Stated::default() }, camera.parameters()).unwrap();
            let is_it = |p: &Parameters| {
                let again = Camera::new(p).unwrap();
                again.view_from_world().abs_diff_eq(camera.view_from_world(), 1e-12)
            };
            let among = found.readings.iter().any(|candidate| is_it(&candidate.found.parameters));
            assert!(among, "{name}: {text}");
            if axes.is_some() {
                assert!(found.best().found.unknown.contains(&Unknown::WorldExchanged));
            }
        }
    }
}

/// C = (3, 4, 5): left-handed worlds have z the other way, Blender has z up, Unreal has z up and centimetres.
#[test]
fn positions_are_those_of_the_worlds_of_programs() {
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 5.0));
    for (target, position) in [
        (CodeTarget::Unity, "Vector3(3.0f, 4.0f, -5.0f)"),
        (CodeTarget::Babylon, "Vector3(3.0, 4.0, -5.0)"),
        (CodeTarget::Unreal, "FVector(300.0, 500.0, 400.0)"),
        (CodeTarget::Godot, "Vector3(3.0, 4.0, 5.0)"),
        (CodeTarget::Bevy, "from_xyz(3.0, 4.0, 5.0)"),
    ] {
        let code = target.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
        assert!(code.contains(position), "{code}");
    }
    let code = CodeTarget::Blender.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
    for (row, last) in
        code.lines().find(|line| line.contains("Matrix((")).unwrap().split("), (").zip(["3.0", "-5.0", "4.0"])
    {
        assert!(row.ends_with(last), "{code}");
    }
}

fn line<'a>(lines: &'a [Line], name: &str) -> Vec<f64> {
    let line: &'a Line = lines.iter().find(|line| line.name == name).unwrap();
    line.arguments.iter().map(|argument| argument.value).collect()
}

#[test]
fn other_vocabularies_have_the_numbers_of_their_sources() {
    let p = Parameters {
        position: DVec3::new(0.0, 0.0, 5.0),
        view_angle: 90.0,
        aspect: 2.0,
        near: 1.0,
        far: 4.0,
        ..Parameters::default()
    };
    let camera = Camera::new(&p).unwrap();
    let lines = |vocabulary: Vocabulary| vocabulary.lines(&camera, IMAGE).unwrap();
    assert_eq!(line(&lines(Vocabulary::OpenGl), "gluPerspective"), [90.0, 2.0, 1.0, 4.0]);
    let vrc = lines(Vocabulary::Vrc);
    assert_eq!((line(&vrc, "VPN"), line(&vrc, "w"), line(&vrc, "h")), (vec![0.0, 0.0, -1.0], vec![2.0], vec![1.0]));
    let reference = lines(Vocabulary::ReferencePoint);
    assert_eq!((line(&reference, "z_{near}"), line(&reference, "z_{far}")), (vec![-1.0], vec![-4.0]));
    let pinhole = lines(Vocabulary::Pinhole);
    assert_eq!(line(&pinhole, "K"), [160.0, 0.0, 320.0, 240.0, 240.0]);
    assert_eq!(line(&pinhole, "R"), [1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0]);
    assert_eq!(line(&pinhole, "t"), [0.0, 0.0, 5.0]);
    let parallel = Camera::new(&Parameters { projection: Projection::Parallel, ..p }).unwrap();
    assert_eq!(Vocabulary::Pinhole.lines(&parallel, IMAGE), Err(Limitation::PerspectiveOnly));
    let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    let aslant = Camera::new(&Parameters { window, ..p }).unwrap();
    assert_eq!(Vocabulary::Vrc.lines(&aslant, IMAGE), Err(Limitation::SymmetricOnly));
    assert_eq!(line(&Vocabulary::OpenGl.lines(&aslant, IMAGE).unwrap(), "glFrustum"), [-1.0, 3.0, -2.0, 1.0, 1.0, 4.0]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 80, failure_persistence: None, ..ProptestConfig::default() })]

    /// K [R | t] p, divided, is the place in the image of (5.22).
    #[test]
    fn the_pinhole_model_projects_to_the_same_pixels(camera in plain_camera(), p in [-1.0..1.0, -1.0..1.0, 0.1..0.9]) {
        prop_assume!(camera.projection() == Projection::Perspective);
        let ndc = DVec3::from_array(p);
        let world = (camera.world_from_view() * (camera.view_from_clip() * ndc.extend(1.0))).truncate()
            / (camera.view_from_clip() * ndc.extend(1.0)).w;
        let lines = Vocabulary::Pinhole.lines(&camera, IMAGE).unwrap();
        let (k, r, t) = (line(&lines, "K"), line(&lines, "R"), line(&lines, "t"));
        let row = |i: usize| DVec3::from_slice(&r[3 * i..]);
        let q = DVec3::new(row(0).dot(world), row(1).dot(world), row(2).dot(world)) + DVec3::from_slice(&t);
        let (i, j) = (k[0] * q.x / q.z + k[2], k[3] * q.y / q.z + k[4]);
        let expected = ((ndc.x + 1.0) / 2.0 * 640.0, (1.0 - ndc.y) / 2.0 * 480.0);
        let slack = 1e-5;
        prop_assert!((i - expected.0).abs() < slack && (j - expected.1).abs() < slack, "{i} {j} {expected:?}");
    }

    /// What we write, we read, for any camera.
    #[test]
    fn any_camera_is_read_back_from_its_code(camera in plain_camera()) {
        // No program counts F ≤ 0 as the others do.
        prop_assume!(camera.near() > 0.0);
        for target in CodeTarget::ALL {
            if target != CodeTarget::Latex && target.limitation(&camera).is_none() {
                is_read_back(target, &camera)?;
            }
        }
    }

    /// The camera that was set is the one shown afterwards.
    #[test]
    fn a_number_that_is_set_is_there_afterwards(camera in plain_camera(), factor in 0.5..1.5) {
        for vocabulary in Vocabulary::ALL {
            let Ok(lines) = vocabulary.lines(&camera, IMAGE) else { continue };
            for (l, line) in lines.iter().enumerate() {
                for (a, argument) in line.arguments.iter().enumerate() {
                    let mut wanted: f64 = argument.value * factor + 0.01;
                    if matches!(argument.quantity, CameraNumber::Axis(..)) {
                        // Entries of a rotation are cosines.
                        wanted = wanted.clamp(-1.0, 1.0);
                    }
                    let p = vocabulary.set(&camera, IMAGE, argument.quantity, wanted);
                    let fixed = argument.quantity == CameraNumber::Fixed;
                    prop_assert_eq!(p == *camera.parameters(), fixed, "{:?}", argument);
                    // Directions are brought back to length 1.
                    let direction = matches!(argument.quantity, CameraNumber::Direction(_));
                    let Ok(changed) = Camera::new(&p) else { continue };
                    let Ok(again) = vocabulary.lines(&changed, IMAGE) else { continue };
                    if fixed || direction || again.len() != lines.len() || again[l].name != line.name {
                        continue;
                    }
                    let value = again[l].arguments[a].value;
                    let size = camera.position().length() + camera.distance() + wanted.abs();
                    prop_assert!((value - wanted).abs() <= 1e-9 * size, "{argument:?}: {value}, not {wanted}");
                }
            }
        }
    }
}
