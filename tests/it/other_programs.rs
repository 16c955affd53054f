//! Matrices that other programs recorded, recognised and read. Each names its source.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{
    Axes, Camera, Candidate, Certainty, Evidence, ImageSize, MatrixEntries, MatrixKind, Order, Parameters, Projection,
    Recognised, RecoveryError, Stated, Unknown, read_cameras, recognise,
};
use camera_lab::explain::vocabulary::Vocabulary;
use glam::{DMat3, DMat4, DVec3, DVec4};
use proptest::prelude::*;

use crate::common::any_camera::plain_camera;
use crate::common::program::Bench;

/// `matrix_local` of the camera of Blender's default scene, which has no parent: so it is its `matrix_world`.
/// <https://github.com/needabetterusername/blender_vdiff>, `integration/test_script_wrapper.py`.
const BLENDER: &str = "[[0.6859206557273865, -0.32401347160339355, 0.6515582203865051, 7.358891487121582], \
    [0.7276763319969177, 0.305420845746994, -0.6141703724861145, -6.925790786743164], \
    [0.0, 0.8953956365585327, 0.44527140259742737, 4.958309173583984], [0.0, 0.0, 0.0, 1.0]]";

/// The node of the camera, by columns. <https://github.com/KhronosGroup/glTF-Sample-Models>, `2.0/Duck/glTF/Duck.gltf`.
const GLTF: &str = r#""matrix": [
    -0.7289686799049377, 0.0, -0.6845470666885376, 0.0,
    -0.4252049028873444, 0.7836934328079224, 0.4527972936630249, 0.0,
    0.5364750623703003, 0.6211478114128113, -0.571287989616394, 0.0,
    400.1130065917969, 463.2640075683594, -431.0780334472656, 1.0 ]"#;
/// The scale of its parent there.
const GLTF_SCALE: f64 = 0.009999999776482582;

/// The camera as `Object3D.toJSON` wrote it, by columns. <https://github.com/mrdoob/three.js>,
/// `editor/examples/arkanoid.app.json`.
const THREE_JS: &str = r#""matrix": [0.9392361044883728,-2.8092810300250903e-9,-0.3432718515396118,0,
    -0.14778217673301697,0.902585506439209,-0.404351145029068,0,
    0.3098321855068207,0.43051064014434814,0.847740888595581,0,142.32125854492188,202.75485229492188,389.40936279296875,1]"#;

/// `P2` as `cv::stereoRectify` gave it, of images of 1624 × 1240 pixels. <https://github.com/opencv/opencv_extra>,
/// `testdata/cv/structured_light/data/sinus_complementary_graycode/test_decode/cali.yml`.
const OPENCV: &str = "data: [ 8.8008897391777791e+03, 0., 5.9461077880859375e+03,
       -1.0752400328185910e+06, 0., 8.8008897391777791e+03,
       5.9953065490722656e+02, 0., 0., 0., 1., 0. ]";
/// `T` there: how far the second camera stands from the first, before they were rectified.
const OPENCV_T: DVec3 = DVec3::new(-106.916_564_891_292_31, 3.716_194_075_346_376, 59.004_473_846_341_02);

/// `P2` of KITTI, padded. <https://github.com/open-mmlab/mmdetection3d>, `demo/data/kitti/000008.txt`.
const KITTI: &str =
    "721.5377 0.0 609.5593 44.85728 0.0 721.5377 172.854 0.2163791 0.0 0.0 1.0 0.002745884 0.0 0.0 0.0 1.0";

/// `pos_001.txt` of the multiple view stereo data of DTU. Readers of a copy that has K and \[R | t\] apart
/// (`read_cam_file` of `MVSNet`) quote these as its first camera: [`DTU_R`], [`DTU_T`], [`DTU_K`].
const DTU: &str = "2607.429996 -3.844898 1498.178098 -533936.661373
    -192.076910 2862.552532 681.798177 23434.686572
    -0.241605 -0.030951 0.969881 22.540121";
const DTU_R: DMat3 = DMat3::from_cols_array(&[
    0.970263, -0.0147429, -0.241605, 0.00747983, 0.999493, -0.030951, 0.241939, 0.0282234, 0.969881,
]);
const DTU_T: DVec3 = DVec3::new(-191.02, 3.28832, 22.5401);
const DTU_K: [f64; 4] = [2892.33, 2883.18, 823.205, 619.071];

/// R. Hartley, A. Zisserman, *Multiple View Geometry in Computer Vision*, 2nd ed., Example 6.2: `f_x` is 468.2, the
/// skew 91.2. Also in <https://github.com/borglab/gtsam>, `gtsam/geometry/tests/testSimpleCamera.cpp`.
const WITH_SKEW: &str = "3.53553e2, 3.39645e2, 2.77744e2, -1.44946e6, -1.03528e2, 2.33212e1, 4.59607e2, -6.32525e5,
    7.07107e-1, -3.53553e-1,6.12372e-1, -9.18559e2";

fn read(text: &str, stated: Stated) -> Result<Recognised, RecoveryError> {
    recognise(&read_cameras(text.as_bytes()).unwrap()[0], &stated, &Parameters::default())
}

fn camera_of(found: &Recognised) -> Camera {
    Camera::new(&found.best().found.parameters).unwrap()
}

fn is_by_columns(found: &Recognised) -> bool {
    found.best().order == Order::Columns
}

/// `f_x`, `f_y`, `c_x`, `c_y`, as the words of computer vision have them.
fn intrinsics(camera: &Camera, image: ImageSize) -> [f64; 4] {
    let lines = Vocabulary::Pinhole.lines(camera, image).unwrap();
    ["f_x", "f_y", "c_x", "c_y"].map(|name| lines[0].arguments.iter().find(|a| a.name == name).unwrap().value)
}

/// M_v in the axes of another program: its axes of the camera, from its world.
fn view_of(camera: &Camera, axes: Axes) -> DMat4 {
    let z_up = DMat4::from_cols_array(&[1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1.]);
    let z_reversed = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0));
    let world = match axes.name {
        "blender" | "ros" => z_up,
        "direct3d" | "unity" => z_reversed,
        "unreal" => DMat4::from_cols(DVec4::X, DVec4::Z, DVec4::Y, DVec4::W),
        _ => DMat4::IDENTITY,
    };
    let rows = match axes.name {
        "opencv" => [DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z],
        "direct3d" | "left-handed-view" => [DVec3::X, DVec3::Y, DVec3::NEG_Z],
        "unreal" => [DVec3::NEG_Z, DVec3::X, DVec3::Y],
        "pytorch3d" => [DVec3::NEG_X, DVec3::Y, DVec3::NEG_Z],
        "ros" => [DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y],
        _ => [DVec3::X, DVec3::Y, DVec3::Z],
    };
    DMat4::from_mat3(DMat3::from_cols(rows[0], rows[1], rows[2]).transpose()) * camera.view_from_world() * world
}

fn assert_near(found: DVec3, expected: [f64; 3], slack: f64) {
    assert!(found.abs_diff_eq(DVec3::from_array(expected), slack), "{found} is not {expected:?}");
}

#[test]
fn the_camera_of_blenders_default_scene() {
    let found = read(BLENDER, Stated::default()).unwrap();
    assert_eq!((found.best().reading.kind, found.best().reading.axes), (MatrixKind::CameraToWorld, Axes::BLENDER));
    assert_eq!((is_by_columns(&found), found.evidence), (false, Evidence::Level));
    assert!(found.others.contains(&MatrixKind::View), "the other reading is offered: {:?}", found.others);
    assert!(
        found.best().found.unknown.contains(&Unknown::WorldTurned)
            && found.best().found.unknown.contains(&Unknown::Lens)
    );
    let camera = camera_of(&found);
    // Location 7.3589, -6.9258, 4.9583, rotation 63.559°, 0°, 46.692°, as its panel shows them. Here y is up.
    assert_near(camera.position(), [7.3589, 4.9583, 6.9258], 1e-4);
    let (tilt, turn) = (63.559_f64.to_radians(), 46.692_f64.to_radians());
    let dop = [-tilt.sin() * turn.sin(), -tilt.cos(), -tilt.sin() * turn.cos()];
    assert_near(camera.direction_of_projection(), dop, 1e-4);
    assert_eq!(camera.view_up(), DVec3::Y, "it is level, so VUP stays");
    // In the world as it is, if asked for.
    let as_it_is = read(BLENDER, Stated { axes: Some(Axes::OPENGL), ..Stated::default() }).unwrap();
    assert_near(camera_of(&as_it_is).position(), [7.3589, -6.9258, 4.9583], 1e-4);
    // As its console prints it.
    let printed = "<Matrix 4x4 (0.6859, -0.3240,  0.6516,  7.3589)\n            (0.7277,  0.3054, -0.6142, -6.9258)\n\
        (0.0000,  0.8954,  0.4453,  4.9583)\n            (0.0000,  0.0000,  0.0000,  1.0000)>";
    let printed = read(printed, Stated::default()).unwrap();
    assert_eq!((printed.best().reading.axes, printed.evidence), (Axes::BLENDER, Evidence::Level));
    assert!(printed.best().found.unknown.contains(&Unknown::Rounded));
}

#[test]
fn the_node_of_a_camera_in_gltf() {
    let found = read(GLTF, Stated::default()).unwrap();
    assert_eq!((found.best().reading.kind, found.best().reading.axes), (MatrixKind::CameraToWorld, Axes::OPENGL));
    // In the axes of Direct3D it's level too, but looks away.
    assert_eq!((is_by_columns(&found), found.evidence), (true, Evidence::OriginAhead));
    assert_near(camera_of(&found).position(), [400.113, 463.264, -431.078], 1e-3);
    assert_near(camera_of(&found).direction_of_projection(), [-0.536475, -0.621148, 0.571288], 1e-6);
    // In the world its parent scales it.
    let node = MatrixEntries::read(GLTF).unwrap().matrix(true);
    let whole = (DMat4::from_scale(DVec3::splat(GLTF_SCALE)) * node).to_cols_array();
    let scaled = read(&format!("{whole:?}"), Stated::default()).unwrap();
    assert_eq!((scaled.best().reading.kind, is_by_columns(&scaled)), (MatrixKind::CameraToWorld, true));
    assert!(scaled.best().found.unknown.contains(&Unknown::Scaled), "{:?}", scaled.best().found.unknown);
    assert_near(camera_of(&scaled).position(), [4.00113, 4.63264, -4.31078], 1e-5);
    assert_near(camera_of(&scaled).direction_of_projection(), [-0.536475, -0.621148, 0.571288], 1e-6);
}

#[test]
fn a_camera_of_three_js() {
    let found = read(THREE_JS, Stated::default()).unwrap();
    assert_eq!((found.best().reading.kind, found.best().reading.axes), (MatrixKind::CameraToWorld, Axes::OPENGL));
    // In the axes of Direct3D it's level too, but looks away.
    assert_eq!((is_by_columns(&found), found.evidence), (true, Evidence::OriginAhead));
    assert_near(camera_of(&found).position(), [142.32126, 202.75485, 389.40936], 1e-5);
    assert_near(camera_of(&found).direction_of_projection(), [-0.309832, -0.430511, -0.847741], 1e-6);
    // `matrixWorldInverse` of it is recognised as different.
    let inverse = MatrixEntries::read(THREE_JS).unwrap().matrix(true).inverse().to_cols_array();
    let view = read(&format!("{inverse:?}"), Stated::default()).unwrap();
    let read = (view.best().reading.kind, is_by_columns(&view), view.best().certainty);
    assert_eq!(read, (MatrixKind::View, true, Certainty::Likely));
    assert_near(camera_of(&view).position(), [142.32126, 202.75485, 389.40936], 1e-3);
}

#[test]
fn a_projection_matrix_of_opencv() {
    let image = ImageSize { width: 1624, height: 1240 };
    let found = read(OPENCV, Stated { image, ..Stated::default() }).unwrap();
    assert_eq!((found.best().reading.kind, found.evidence), (MatrixKind::Pinhole, Evidence::Only));
    let before = Parameters::default();
    let p = found.best().found.parameters;
    assert_eq!((p.near, p.far, p.projection), (before.near, before.far, Projection::Perspective));
    for said in [Unknown::ClippingPlanes, Unknown::ImageSize] {
        assert!(found.best().found.unknown.contains(&said), "{said:?} is told");
    }
    let camera = camera_of(&found);
    let expected = [8_800.889_739_177_78, 8_800.889_739_177_78, 5_946.107_788_085_937, 599.530_654_907_226_6];
    for (number, expected) in intrinsics(&camera, image).into_iter().zip(expected) {
        assert!((number - expected).abs() < 1e-8, "{number} is not {expected}");
    }
    // Rectified, it stands beside the first one, as far as it stood before.
    assert!((camera.position() - DVec3::X * OPENCV_T.length()).length() < 1e-9 * OPENCV_T.length());
    assert_near(camera.direction_of_projection(), [0.0, 0.0, 1.0], 1e-12);
    assert!(p.window.is_some(), "its axis meets no pixel");
}

#[test]
fn k_r_t_is_found_in_twelve_numbers_and_in_sixteen() {
    let image = ImageSize { width: 1600, height: 1200 };
    let stated = Stated { image, ..Stated::default() };
    let found = read(DTU, stated).unwrap();
    let camera = camera_of(&found);
    for (number, expected) in intrinsics(&camera, image).into_iter().zip(DTU_K) {
        assert!((number - expected).abs() < 0.01, "{number} is not {expected}");
    }
    let basis = camera.basis();
    let r = DMat3::from_cols(basis.u, -basis.v, -basis.n).transpose();
    assert!(r.abs_diff_eq(DTU_R, 1e-5), "{r} is not {DTU_R}");
    let t = -(r * camera.position());
    assert!(t.abs_diff_eq(DTU_T, 2e-3), "{t} is not {DTU_T}");
    assert!(found.best().found.unknown.contains(&Unknown::PixelAspect), "{:?}", found.best().found.unknown);
    // Known up to a factor: also a negative one.
    let m = MatrixEntries::read(DTU).unwrap().matrix(false);
    let minus: Vec<f64> = (0..3).flat_map(|row| (m.row(row) * -0.5).to_array()).collect();
    let turned = read(&format!("{minus:?}"), stated).unwrap();
    assert!(turned.best().found.unknown.contains(&Unknown::SignReversed));
    assert!(camera_of(&turned).position().abs_diff_eq(camera.position(), 1e-6));
    // Padded by 0 0 0 1, and by a row of z.
    let by_z: Vec<f64> = [0, 1, 3, 2].into_iter().flat_map(|row| m.row(row).to_array()).collect();
    for padded in [format!("{DTU} 0 0 0 1"), format!("{by_z:?}")] {
        let padded = read(&padded, stated).unwrap();
        assert_eq!(padded.best().reading.kind, MatrixKind::Pinhole);
        assert!(camera_of(&padded).position().abs_diff_eq(camera.position(), 1e-9));
    }
    let kitti = read(KITTI, Stated { image: ImageSize { width: 1242, height: 375 }, ..stated }).unwrap();
    assert_eq!((kitti.best().reading.kind, is_by_columns(&kitti)), (MatrixKind::Pinhole, false));
    let numbers = intrinsics(&camera_of(&kitti), kitti.best().reading.image);
    for (number, expected) in numbers.into_iter().zip([721.5377, 721.5377, 609.5593, 172.854]) {
        assert!((number - expected).abs() < 1e-9, "{number} is not {expected}");
    }
    // The colour camera of KITTI stands 6 cm to the left of the first grey one.
    let eye = camera_of(&kitti).position();
    assert!((eye.x + 0.06).abs() < 1e-3 && eye.y.abs() < 1e-3, "{eye}");
}

#[test]
fn matrices_of_no_camera_are_refused_with_the_reason() {
    let Err(RecoveryError::Skew { skew, focal_length }) = read(WITH_SKEW, Stated::default()) else { panic!("skew") };
    assert!((skew - 91.2).abs() < 0.1 && (focal_length - 468.2).abs() < 0.1, "{skew} {focal_length}");
    let affine = read("800 0 0 320  0 800 0 240  0 0 0 1", Stated::default());
    assert_eq!(affine, Err(RecoveryError::Affine));
    let sheared = "1 0.5 0 0  0 1 0 0  0 0 1 0  0 0 0 1";
    let stated = Stated { kind: Some(MatrixKind::CameraToWorld), ..Stated::default() };
    assert!(matches!(read(sheared, stated), Err(RecoveryError::Shear { .. })));
}

#[test]
fn an_ambiguous_rigid_matrix_is_read_as_camera_to_world_and_says_so() {
    // The camera of Blender after 90° about x, from a page about it: level and upright with z up alone.
    let found = read("1 0 0 0  0 0 -1 -6  0 1 0 0  0 0 0 1", Stated::default()).unwrap();
    assert_eq!((found.best().reading.kind, found.best().reading.axes), (MatrixKind::CameraToWorld, Axes::BLENDER));
    assert_eq!(camera_of(&found).position(), DVec3::new(0.0, 0.0, 6.0));
    // A translation: the origin is ahead in one reading.
    let found = read("1 0 0 0  0 1 0 0  0 0 1 5  0 0 0 1", Stated::default()).unwrap();
    // So it is in that of Direct3D and of OpenCV, which look the other way.
    assert_eq!((found.best().reading.kind, found.best().certainty), (MatrixKind::CameraToWorld, Certainty::Open));
    let found = read("1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1", Stated::default()).unwrap();
    assert_eq!((found.best().reading.kind, found.best().certainty), (MatrixKind::View, Certainty::Likely));
    assert_eq!(camera_of(&found).position(), DVec3::new(0.0, 0.0, 5.0));
    assert!(found.others.contains(&MatrixKind::CameraToWorld));
}

#[test]
fn the_command_line_reads_them_too() {
    let bench = Bench::new("other programs");
    bench.write("f.toml", "# mine\n[camera]\nnear = 0.5\nfar = 50\n");
    let json = |args: &[&str]| {
        let run = bench.run(&[&["matrix", "f.toml", "--format", "json"], args].concat());
        serde_json::from_slice::<serde_json::Value>(run.done()).unwrap()
    };
    let blender = json(&["--numbers", BLENDER]);
    assert_eq!(
        (&blender["as"], &blender["axes"], &blender["evidence"]),
        (&"camera-to-world".into(), &"blender".into(), &"level".into())
    );
    assert_eq!(blender["others"][0], "view");
    let as_view = json(&["--numbers", BLENDER, "--as", "view", "--axes", "opengl"]);
    assert_eq!((&as_view["as"], &as_view["others"][0]), (&"view".into(), &"camera-to-world".into()));
    assert_ne!(as_view["camera"]["position"], blender["camera"]["position"]);
    let by_columns = json(&["--numbers", GLTF, "--as", "camera-to-world", "--columns"]);
    assert_eq!(by_columns["by_columns"], true);
    // The figure that it prints is read again, with the camera, and with F and B of the file.
    let run = bench.run(&["matrix", "f.toml", "--numbers", KITTI, "--size", "1242x375", "--lang", "pt-BR"]);
    let text = String::from_utf8(run.done().to_vec()).unwrap();
    assert!(text.contains("# Lida como K [R | t].") && text.contains("F e B são desconhecidos"), "{text}");
    assert!(text.contains("# mine") && text.contains("near = 0.5"), "{text}");
    bench.write("g.toml", &text);
    let inspected = bench.run(&["inspect", "g.toml"]);
    let inspected: serde_json::Value = serde_json::from_slice(inspected.done()).unwrap();
    let window = &inspected["window"];
    let c_x = -window["left"].as_f64().unwrap() / window["width"].as_f64().unwrap() * 1242.0;
    assert!((c_x - 609.5593).abs() < 1e-9, "{c_x}");
    assert_eq!(inspected["camera"]["far"], 50.0);
    assert!(bench.run(&["matrix", "f.toml", "--numbers", "1 2 3"]).refused(2).contains("3 numbers"));
    assert!(bench.run(&["matrix", "f.toml", "--numbers", WITH_SKEW]).refused(2).contains("skew of 91.2"));
}

#[test]
fn files_and_their_cameras_are_chosen_on_the_command_line() {
    let bench = Bench::new("files of other programs");
    bench.write("f.toml", "");
    // Half a turn about x: OpenCV's axes become those of the notes. t = (0, 0, 4) is C there.
    bench.write("cameras.txt", "# Camera list\n1 PINHOLE 640 480 500 500 320 240\n");
    bench.write("images.txt", "1 0 1 0 0 0 0 4 1 a.png\n1.5 2.5 -1\n2 0 1 0 0 0.5 0 4 1 b.png\n\n");
    let json = |args: &[&str]| {
        let run = bench.run(&[&["matrix", "f.toml", "--format", "json"], args].concat());
        serde_json::from_slice::<serde_json::Value>(run.done()).unwrap()
    };
    let first = json(&["--from", "images.txt"]);
    assert_eq!(first["cameras"], serde_json::json!(["a.png", "b.png"]));
    assert_eq!(first["camera"]["position"][2], 4.0);
    assert_eq!(first["image"], serde_json::json!([640, 480]));
    // The lens of `cameras.txt`: tan(θ/2) = 240/500.
    let angle = first["camera"]["view_angle"].as_f64().unwrap();
    assert!((angle - 2.0 * 0.48_f64.atan().to_degrees()).abs() < 1e-9, "{angle}");
    for choice in ["2", "b.png"] {
        assert_eq!(json(&["--from", "images.txt", "--camera", choice])["camera"]["position"][0], -0.5);
    }
    let run = bench.run(&["matrix", "f.toml", "--from", "images.txt", "--camera", "c.png"]);
    let refused = run.refused(2);
    assert!(refused.contains("c.png") && refused.contains("b.png"), "{refused}");
    assert!(bench.run(&["matrix", "f.toml"]).refused(2).contains("--numbers"));
    assert!(bench.run(&["matrix", "f.toml", "--from", "none.txt"]).refused(2).contains("none.txt"));
    // 90°, F 1, B 3: other ranges of NDC fit, so F is no certainty.
    let projection = json(&["--numbers", "1 0 0 0\n0 1 0 0\n0 0 -2 -3\n0 0 -1 0"]);
    let readings = projection["readings"].as_array().unwrap();
    let first = &readings[0];
    assert_eq!(
        (&first["kind"], &first["order"], &first["ndc"], &first["handedness"], &first["certainty"]),
        (&"projection".into(), &"rows".into(), &"opengl".into(), &"right".into(), &"likely".into())
    );
    assert_eq!(first["camera"], projection["camera"]);
    assert!(!first["reasons"].as_array().unwrap().is_empty() && readings.len() > 1);
    let assumed = projection["assumed"].to_string();
    assert!(assumed.contains("direct3d") && assumed.contains("F = 1.5"), "{assumed}");
    // Stated, it is the one.
    let stated = json(&["--numbers", "1 0 0 0\n0 1 0 0\n0 0 -2 -3\n0 0 -1 0", "--ndc", "direct3d"]);
    assert_eq!(stated["camera"]["near"], 1.5);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    /// K [R | t], its inverse question, of any camera in perspective: at the present F the image has the same pixels.
    #[test]
    fn the_camera_of_k_r_t_has_its_numbers(camera in plain_camera(), factor in 0.1..10.0_f64, sign in any::<bool>()) {
        prop_assume!(camera.projection() == Projection::Perspective);
        let image = ImageSize { width: 640, height: 480 };
        let numbers = intrinsics(&camera, image);
        let basis = camera.basis();
        let r = DMat3::from_cols(basis.u, -basis.v, -basis.n).transpose();
        let k = DMat3::from_cols_array(&[numbers[0], 0.0, 0.0, 0.0, numbers[1], 0.0, numbers[2], numbers[3], 1.0]);
        let (kr, kt) = (k * r, -(k * (r * camera.position())));
        let factor = if sign { factor } else { -factor };
        let p: Vec<f64> = (0..3).flat_map(|i| kr.row(i).extend(kt[i]).to_array()).map(|x| x * factor).collect();
        let stated = Stated { kind: Some(MatrixKind::Pinhole), image, ..Stated::default() };
        let found = read(&format!("{p:?}"), stated).unwrap();
        prop_assert_eq!(found.best().found.unknown.contains(&Unknown::SignReversed), !sign);
        let again = camera_of(&found);
        for (number, expected) in intrinsics(&again, image).into_iter().zip(numbers) {
            prop_assert!((number - expected).abs() <= 1e-6 * numbers[0].max(numbers[1]).max(expected.abs()));
        }
        let size = 1.0 + camera.position().length();
        prop_assert!(again.position().abs_diff_eq(camera.position(), 1e-7 * size));
        prop_assert!(again.basis().n.abs_diff_eq(basis.n, 1e-9) && again.basis().v.abs_diff_eq(basis.v, 1e-9));
    }

    /// M_v and its inverse, in the axes of each program, by rows and by columns, give the camera back if they are
    /// stated.
    #[test]
    fn a_stated_reading_gives_the_camera_back(camera in plain_camera(), by_columns in any::<bool>(), scale in 0.01..100.0) {
        for axes in Axes::ALL {
            let view = view_of(&camera, axes);
            let scaled = view.inverse() * DMat4::from_scale(DVec3::splat(scale));
            for (kind, matrix) in
                [(MatrixKind::View, view), (MatrixKind::CameraToWorld, view.inverse()), (MatrixKind::CameraToWorld, scaled)]
            {
                let matrix = if by_columns { matrix } else { matrix.transpose() };
                let stated = Stated { kind: Some(kind), axes: Some(axes), by_columns, ..Stated::default() };
                let found = read(&format!("{:?}", matrix.to_cols_array()), stated).unwrap();
                let again = camera_of(&found);
                let size = 1.0 + camera.position().length();
                prop_assert!(again.position().abs_diff_eq(camera.position(), 1e-6 * size), "{kind:?} {axes:?}");
                prop_assert!(again.basis().n.abs_diff_eq(camera.basis().n, 1e-6), "{kind:?} {axes:?}");
                prop_assert!(again.basis().v.abs_diff_eq(camera.basis().v, 1e-6), "{kind:?} {axes:?}");
            }
        }
    }

    /// Of a level camera that looks down on the origin, both are recognised in the world of either program.
    #[test]
    fn a_level_camera_is_recognised(turn in 15.0..75.0_f64, down in 15.0..75.0_f64, distance in 1.0..100.0, by_columns in any::<bool>()) {
        let (turn, down) = (turn.to_radians(), down.to_radians());
        let position = distance * DVec3::new(down.cos() * turn.sin(), down.sin(), down.cos() * turn.cos());
        let camera = Camera::new(&Parameters { position, ..Parameters::default() }).unwrap();
        let z_up = DMat4::from_cols_array(&[1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1.]);
        for (axes, view) in
            [(Axes::OPENGL, camera.view_from_world()), (Axes::BLENDER, camera.view_from_world() * z_up)]
        {
            for (kind, matrix) in [(MatrixKind::View, view), (MatrixKind::CameraToWorld, view.inverse())] {
                let matrix = if by_columns { matrix } else { matrix.transpose() };
                // Blender prints four lines. Sixteen numbers in one list by columns are those of glTF and three.js.
                let found = read(&format!("{:?}", matrix.to_cols_array_2d()), Stated::default()).unwrap();
                let read = (found.best().reading.kind, found.best().reading.axes, is_by_columns(&found));
                // M_v by columns is a rotation by rows too, but never with 0 0 0 1 below.
                prop_assert_eq!(read, (kind, axes, by_columns));
                // Those of Direct3D fit a camera that looks away.
                prop_assert!(found.best().certainty != Certainty::Only);
                prop_assert!(camera_of(&found).position().abs_diff_eq(position, 1e-9 * distance));
            }
        }
    }

    /// M_p M_v and M_p are distinguished from the others, by rows and by columns.
    #[test]
    fn a_projection_is_recognised(camera in plain_camera(), by_columns in any::<bool>()) {
        // From the origin along an axis, M_p M_v has the zeros of M_p.
        prop_assume!(camera.position().length() > 1e-6);
        // So it has from anywhere if it is parallel: that is the M_p of another window, with other F and B.
        let looks_along_z = camera.basis().u.abs_diff_eq(DVec3::X, 1e-6) && camera.basis().v.abs_diff_eq(DVec3::Y, 1e-6);
        prop_assume!(camera.projection() == Projection::Perspective || !looks_along_z);
        // Windows far beside the axis are rather those of K.
        let w = camera.window();
        prop_assume!((w.left + w.right).abs() < 3.0 * w.width() && (w.bottom + w.top).abs() < 3.0 * w.height());
        for (kind, matrix) in [
            (MatrixKind::ViewProjection, camera.clip_from_world()),
            (MatrixKind::Projection, camera.clip_from_view()),
        ] {
            let written = if by_columns { matrix } else { matrix.transpose() };
            let pasted = read_cameras(format!("{:?}", written.to_cols_array()).as_bytes()).unwrap();
            let found = recognise(&pasted[0], &Stated::default(), camera.parameters()).unwrap();
            prop_assert_eq!((found.best().reading.kind, is_by_columns(&found)), (kind, by_columns));
            let size = camera.clip_from_world().to_cols_array().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            // An upside-down camera is less likely than one whose world is left-handed.
            let is_right = |c: &Candidate| {
                let again = Camera::new(&c.found.parameters).unwrap().clip_from_world();
                again.abs_diff_eq(camera.clip_from_world(), 1e-6 * size)
            };
            prop_assert!(found.readings.iter().any(is_right), "{found:#?} {}", camera.clip_from_world());
        }
    }

    #[test]
    fn no_matrix_panics(entries in prop::collection::vec(prop_oneof![
        4 => -10.0..10.0, 2 => Just(0.0), 2 => Just(1.0), 1 => -1e300..1e300, 1 => -1e-300..1e-300,
    ], 16), twelve in any::<bool>()) {
        let entries = if twelve { &entries[..12] } else { &entries };
        let text: Vec<String> = entries.iter().map(|x| format!("{x:e}")).collect();
        let pasted = read_cameras(text.join(" ").as_bytes()).unwrap();
        for kind in std::iter::once(None).chain(MatrixKind::ALL.map(Some)) {
            if let Ok(found) = recognise(&pasted[0], &Stated { kind, ..Stated::default() }, &Parameters::default()) {
                Camera::new(&found.best().found.parameters).unwrap();
            }
        }
    }
}
