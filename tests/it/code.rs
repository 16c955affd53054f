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

/// The code of a camera gives it back, likely or better, with F and B if the program has them.
fn is_read_back(target: CodeTarget, camera: &Camera) -> Result<(), TestCaseError> {
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
    let comments = texts::comments(Lang::En, target, &target.conventions(camera));
    let code = target.code(&setting, &comments);
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
        for target in CodeTarget::ALL.into_iter().filter(|target| target.limitation(&camera, IMAGE).is_none()) {
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
        assert_eq!(target.limitation(&perspective, IMAGE), None, "{}", target.name());
    }
    assert_eq!(CodeTarget::Bevy.limitation(&asymmetric, IMAGE), Some(Limitation::SymmetricOnly));
    assert_eq!(CodeTarget::Colmap.limitation(&parallel, IMAGE), Some(Limitation::PerspectiveOnly));
    let bench = Bench::new("code that is refused");
    bench.write("f.toml", "[camera]\nprojection = \"parallel\"\n");
    assert!(bench.run(&["code", "f.toml", "--for", "opencv"]).refused(2).contains("perspective only"));
}

/// The values that code assigns or passes under a name.
fn values(code: &str, name: &str) -> Option<Vec<f64>> {
    let rest = code.split_once(name)?.1.trim_start_matches([' ', '=', '(']);
    let text = rest.split(['\n', ')']).next()?;
    text.split(',').map(|x| x.trim().parse().ok()).collect()
}

/// Cameras with any shape of pixels, lens, window and, in parallel projection, any F.
fn any_shape() -> impl Strategy<Value = (Camera, DVec3)> {
    let window = prop_oneof![
        Just(None),
        (0.2..2.0, 0.2..2.0, 0.2..2.0, 0.2..2.0).prop_map(|(l, r, b, t): (f64, f64, f64, f64)| {
            Some(ViewWindow { left: -l, right: r, bottom: -b, top: t })
        })
    ];
    let lens = (0.4..179.0, any::<bool>(), -30.0..5.0, window, 0.3..4.0);
    (lens, (-1.0..1.0, -1.0..1.0, 0.2..0.9)).prop_map(|((view_angle, is_parallel, near, window, aspect), at)| {
        let parameters = Parameters {
            position: DVec3::new(3.0, 4.0, 5.0),
            view_angle,
            aspect,
            window,
            near: if is_parallel { near } else { 0.5 },
            far: 40.0,
            projection: if is_parallel { Projection::Parallel } else { Projection::Perspective },
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).unwrap();
        let depth: f64 = camera.near() + at.2 * (camera.far() - camera.near());
        let scale = if is_parallel { 1.0 } else { depth / camera.near() };
        let side = 0.4 * camera.window_width().min(camera.window_height()) * scale;
        let view = DVec3::new(at.0 * side, at.1 * side, -depth);
        let p = camera.world_from_view().transform_point3(view);
        (camera, p)
    })
}

/// (i, j), not floored.
fn pixel_of(camera: &Camera, p: DVec3) -> [f64; 2] {
    let clip = camera.clip_from_world() * p.extend(1.0);
    let [m, n] = [f64::from(IMAGE.width), f64::from(IMAGE.height)];
    [(clip.x / clip.w + 1.0) / 2.0 * m, (1.0 - clip.y / clip.w) / 2.0 * n]
}

proptest! {
    /// The rules of `BKE_camera_params_compute_viewplane`, and Blender's ranges.
    #[test]
    fn blender_gets_every_camera_in_its_ranges((camera, p) in any_shape()) {
        prop_assert_eq!(CodeTarget::Blender.limitation(&camera, IMAGE), None);
        let code = CodeTarget::Blender.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
        let matrix = code.split_once("Matrix((").unwrap().1.split_once("))\n").unwrap().0;
        let matrix: Vec<f64> =
            matrix.split([',', '(', ')', ' ']).filter(|x| !x.is_empty()).map(|x| x.parse().unwrap()).collect();
        let world_from_camera = DMat4::from_cols_slice(&matrix).transpose();
        // Blender's z is up.
        let v = (world_from_camera.inverse() * DVec4::new(p.x, -p.z, p.y, 1.0)).truncate();
        let clip = values(&code, "camera.data.clip_end").unwrap();
        prop_assert!(clip[0] >= 1e-6 && -v.z > clip[0] && -v.z < clip[1], "{} {:?}", v.z, clip);
        let pixel = values(&code, "scene.render.pixel_aspect_y").unwrap_or_else(|| vec![1.0, 1.0]);
        prop_assert!(pixel.iter().all(|x| (1.0..=200.0).contains(x)));
        // The sizes of the view plane at the distance 1, from the height, in pixels as wide as high.
        let [m, n] = [f64::from(IMAGE.width), f64::from(IMAGE.height) * pixel[1] / pixel[0]];
        let (height, at) = if let Some(scale) = values(&code, "ortho_scale") {
            (scale[0], [v.x, v.y])
        } else {
            let [lens, sensor] = ["data.lens", "sensor_height"].map(|name| values(&code, name).unwrap()[0]);
            prop_assert!((1.0..=5000.0).contains(&lens) && sensor >= 1.0);
            (sensor / lens, [v.x / -v.z, v.y / -v.z])
        };
        let shift = values(&code, "shift_y").unwrap();
        let across = [at[0] / (height * m / n) - shift[0] * n / m, at[1] / height - shift[1]];
        let seen = [(across[0] + 0.5) * m, (0.5 - across[1]) * f64::from(IMAGE.height)];
        let expected = pixel_of(&camera, p);
        prop_assert!((0..2).all(|k| (seen[k] - expected[k]).abs() < 1e-5), "{seen:?} {expected:?}\n{code}");
    }

    /// In pixels: x = c − f x_c, since PyTorch3D's x runs to the left and its y up.
    #[test]
    fn pytorch3d_gets_every_camera_in_pixels((camera, p) in any_shape()) {
        prop_assert_eq!(CodeTarget::PyTorch3d.limitation(&camera, IMAGE), None);
        let code = CodeTarget::PyTorch3d.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
        prop_assert!(code.contains("in_ndc=False") && code.contains("image_size=((480, 640),)"));
        let numbers = |name: &str| -> Vec<f64> {
            let text = code.split_once(name).unwrap().1.split_once('\n').unwrap().0;
            text.split(['[', ']', '(', ')', ',', ' ', '=']).filter_map(|x| x.parse().ok()).collect()
        };
        let (r, t) = (DMat3::from_cols_slice(&numbers("R = torch.tensor")), DVec3::from_slice(&numbers("T = torch.tensor")));
        // Row vectors: the rows of R are the columns that act on p.
        let v = r * p + t;
        let [f, c] = ["focal_length", "principal_point"].map(numbers);
        let depth = if camera.projection() == Projection::Parallel { 1.0 } else { v.z };
        let seen = [c[0] - f[0] * v.x / depth, c[1] - f[1] * v.y / depth];
        let expected = pixel_of(&camera, p);
        prop_assert!((0..2).all(|k| (seen[k] - expected[k]).abs() < 1e-5), "{seen:?} {expected:?}\n{code}");
    }

    #[test]
    fn no_program_gets_a_smaller_near_than_it_takes((camera, _) in any_shape()) {
        let code = CodeTarget::Gltf.code(&Setting::new(camera.notes_clip_space(), IMAGE, None), &[]);
        let value: serde_json::Value = serde_json::from_str(&code).unwrap();
        let lens = &value["cameras"][0];
        let near = lens["orthographic"]["znear"].as_f64().or(lens["perspective"]["znear"].as_f64()).unwrap();
        prop_assert!(near >= 0.0);
        // JSON is read to within a bit.
        if (near - camera.near()).abs() > 1e-9 {
            let matrix: Vec<f64> = value["nodes"][0]["matrix"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
            let back = DVec3::from_slice(&matrix[12..15]) - camera.position();
            prop_assert!(back.abs_diff_eq(camera.basis().n * (near - camera.near()), 1e-12), "{back}");
            let said = CodeTarget::Gltf.conventions(&camera);
            prop_assert!(said.iter().any(|said| matches!(said, CodeConvention::MovedBack(_))));
        }
    }
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
        if CodeTarget::Unreal.limitation(&camera, IMAGE).is_some() {
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
            if target != CodeTarget::Latex && target.limitation(&camera, IMAGE).is_none() {
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
