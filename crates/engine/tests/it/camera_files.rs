//! Cameras of other programs: names decide, a file's cameras stand in one world, and no entry is lost without a word.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::ops::Range;

use camera_lab_engine::camera::{
    Camera, Certainty, ImageSize, Parameters, Pasted, Projection, RecoveryError, Stated, Why, camera_names,
    read_cameras, recognise,
};
use glam::DVec3;
use proptest::prelude::*;

fn cameras(text: &str) -> Vec<Pasted> {
    read_cameras(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn camera(pasted: &Pasted) -> Result<(Camera, Certainty), RecoveryError> {
    let image = pasted.image.unwrap_or(ImageSize { width: 640, height: 480 });
    let found = recognise(pasted, &Stated { image, ..Stated::default() }, &Parameters::default())?;
    Ok((Camera::new(&found.best().found.parameters)?, found.best().certainty))
}

#[track_caller]
fn first(text: &str) -> Camera {
    camera(&cameras(text)[0]).unwrap_or_else(|error| panic!("{error}\n{text}")).0
}

/// C, DOP and VUP of the first camera.
#[track_caller]
fn stands(text: &str, position: [f64; 3], dop: [f64; 3], up: [f64; 3]) -> Camera {
    let camera = first(text);
    let found = [camera.position(), camera.direction_of_projection(), camera.basis().v];
    for (found, right) in found.into_iter().zip([position, dop, up]) {
        assert!(found.abs_diff_eq(DVec3::from_array(right), 1e-6), "{found} is not {right:?}\n{text}");
    }
    camera
}

/// l, r, b and t over F.
#[track_caller]
fn spans(text: &str, sides: [f64; 4]) -> Camera {
    let camera = first(text);
    let (w, near) = (camera.window(), camera.near());
    let found = [w.left, w.right, w.bottom, w.top].map(|side| side / near);
    assert!(found.iter().zip(sides).all(|(a, b)| (a - b).abs() < 1e-6), "{found:?} is not {sides:?}\n{text}");
    camera
}

const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];
const UP: [f64; 3] = [0.0, 1.0, 0.0];

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the order of the names, their separators and the words around them.
    #[test]
    fn names_decide_in_any_order(
        order in Just([0_usize, 1, 2]).prop_shuffle(), set in 0..5_usize, form in 0..5_usize, c in prop::array::uniform3(-9.0..9.0_f64),
    ) {
        let names = [["eye", "center", "up"], ["position", "target", "viewUp"], ["cameraPosition", "lookAt", "up_vector"],
            ["SetPosition", "SetFocalPoint", "SetViewUp"], ["location", "look_at", "sky"]][set];
        let values = [c, [c[0] + 1.0, c[1], c[2] - 2.0], UP];
        let part = |at: usize| {
            let [x, y, z] = values[at];
            match form {
                0 => format!("{} = ({x:?}, {y:?}, {z:?})", names[at]),
                1 => format!("\"{}\": [{x:?}, {y:?}, {z:?}]", names[at]),
                2 => format!("{}: {x:?} {y:?} {z:?}", names[at]),
                3 => format!("{} {x:?} {y:?} {z:?}", names[at]),
                _ => format!("camera.{}({x:?}, {y:?}, {z:?});", names[at]),
            }
        };
        let text = order.map(part).join(if form == 1 { ",\n" } else { "\n" });
        let text = if form == 1 { format!("{{{text}}}") } else { text };
        let camera = first(&text);
        // POV-Ray's world is left-handed.
        let z = if set == 4 { -1.0 } else { 1.0 };
        let right = DVec3::new(c[0], c[1], z * c[2]);
        prop_assert!(camera.position().abs_diff_eq(right, 1e-9), "{} is not {right}\n{text}", camera.position());
        let dop = DVec3::new(1.0, 0.0, -2.0 * z).normalize();
        prop_assert!(camera.direction_of_projection().abs_diff_eq(dop, 1e-9), "{text}");
    }

    /// A chain of any length: each camera stands beside the one before.
    #[test]
    fn a_chain_stands_in_one_world(steps in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 1..5)) {
        let lens = "  camera_model: pinhole\n  intrinsics: [460, 460, 376, 240]\n  resolution: [752, 480]\n";
        let mut text = format!("cam0:\n{lens}");
        for (k, [x, y, z]) in steps.iter().enumerate() {
            let rows = format!("  - [1.0, 0.0, 0.0, {x:?}]\n  - [0.0, 1.0, 0.0, {y:?}]\n  - [0.0, 0.0, 1.0, {z:?}]\n  - [0.0, 0.0, 0.0, 1.0]\n");
            text += &format!("cam{}:\n  T_cn_cnm1:\n{rows}{lens}", k + 1);
        }
        let all = cameras(&text);
        prop_assert_eq!(all.len(), steps.len() + 1);
        let mut place = DVec3::ZERO;
        prop_assert!(camera(&all[0]).unwrap().0.position().abs_diff_eq(place, 1e-12));
        for (k, step) in steps.iter().enumerate() {
            place -= DVec3::from_array(*step);
            prop_assert!(camera(&all[k + 1]).unwrap().0.position().abs_diff_eq(place, 1e-9), "{text}");
        }
    }

    /// A list in which some cameras lack a part: each keeps its place and its name.
    #[test]
    fn a_broken_camera_keeps_its_place(broken in prop::collection::vec(0..4_usize, 2..6)) {
        let one = |(k, kind): (usize, &usize)| {
            let position = if *kind == 1 { String::new() } else { format!("\"position\": [{k}, 0, 0], ") };
            let fx = if *kind == 2 { "\"fx\": -5," } else { "\"fx\": 500," };
            format!("{{\"img_name\": \"n{k}\", {position}\"rotation\": [[1,0,0],[0,1,0],[0,0,1]], {fx} \"width\": 640, \"height\": 480}}")
        };
        let text = format!("[{}]", broken.iter().enumerate().map(one).collect::<Vec<_>>().join(", "));
        let all = cameras(&text);
        let names: Vec<String> = (0..broken.len()).map(|k| format!("n{k}")).collect();
        prop_assert_eq!(camera_names(&all), names);
        for (k, (pasted, kind)) in all.iter().zip(&broken).enumerate() {
            match camera(pasted) {
                Ok((camera, _)) => {
                    prop_assert!(!matches!(kind, 1 | 2), "{k} is no camera: {text}");
                    prop_assert!((camera.position().x - f64::from(u8::try_from(k).unwrap())).abs() < 1e-12);
                }
                Err(_) => prop_assert!(matches!(kind, 1 | 2), "{k} is one: {text}"),
            }
        }
    }

    /// A lens of K beside distortion: the corner moves as the model says, and no reading is certain.
    #[test]
    fn distortion_is_named_with_its_shift(k in -0.3..0.3_f64, f in 300.0..900.0_f64, style in 0..3_usize) {
        prop_assume!(k.abs() > 1e-3);
        let text = match style {
            0 => format!("1 SIMPLE_RADIAL 640 480 {f:?} 320 240 {k:?}\n"),
            1 => format!("image_width: 640\nimage_height: 480\ncamera_matrix: [{f:?}, 0, 320, 0, {f:?}, 240, 0, 0, 1]\ndistortion_coefficients: [{k:?}, 0, 0, 0, 0]\n"),
            _ => format!("{{\"w\": 640, \"h\": 480, \"fl_x\": {f:?}, \"fl_y\": {f:?}, \"cx\": 320, \"cy\": 240, \"k1\": {k:?}}}"),
        };
        let all = cameras(&text);
        let Some(Why::Distortion { pixels: Some(pixels), .. }) = all[0].left_out.first().map(|left| &left.why) else {
            return Err(TestCaseError::fail(format!("{:?}\n{text}", all[0].left_out)));
        };
        // x (1 + k r²) at the corner (320, 240)/f.
        let right = k.abs() * 400.0_f64.powi(3) / (f * f);
        prop_assert!((pixels - right).abs() < 1e-6 * right, "{pixels} is not {right}");
        prop_assert!(camera(&all[0]).unwrap().1 < Certainty::Only);
    }

    /// A size of an image, under each of its names and in each of its forms.
    #[test]
    fn the_size_of_an_image_comes_back(m in 17..9000_u32, n in 17..9000_u32) {
        let sides = ["width height", "w h", "image_width image_height", "imageWidth imageHeight", "img_width img_height",
            "resolution_x resolution_y", "res_x res_y", "xresolution yresolution", "Image Width Image Height"];
        let pairs = ["resolution", "size", "image_size", "imageSize", "img_size", "imsize", "image resolution", "window_size"];
        let k = "K = [500 0 300; 0 500 200; 0 0 1]";
        let mut texts = Vec::new();
        for names in sides {
            let words: Vec<&str> = names.split(' ').collect();
            let (a, b) = (words[..words.len() / 2].join(" "), words[words.len() / 2..].join(" "));
            texts.push(format!("{b}: {n}\n{a}: {m}\nfx: 500\nfy: 500\ncx: 300\ncy: 200\n"));
            texts.push(format!("{{\"{a}\": {m}, \"fx\": 500, \"cx\": 300, \"cy\": 200, \"{b}\": {n}}}"));
            if !a.contains(' ') {
                texts.push(format!("{k}\n{a} = {m}\n{b} = {n}\n"));
                texts.push(format!("<camera><{b}>{n}</{b}><{a}>{m}</{a}><fx>500</fx><cx>300</cx><cy>200</cy></camera>"));
            }
        }
        for name in pairs {
            texts.push(format!("fx: 500\nfy: 500\ncx: 300\ncy: 200\n{name}: [{m}, {n}]\n"));
            texts.push(format!("{{\"{name}\": [{m}, {n}], \"K\": [[500, 0, 300], [0, 500, 200], [0, 0, 1]]}}"));
        }
        texts.extend([
            format!("[ {m}x{n}  p[300 200]  f[500 500]  Inverse Brown Conrady [0 0 0 0 0] ]"),
            format!("Image size: {m} x {n}\nFocal length: 500 500\nPrincipal point: 300 200\n"),
            format!("1 PINHOLE {m} {n} 500 500 300 200\n"),
            format!("cam0:\n  camera_model: pinhole\n  intrinsics: [500, 500, 300, 200]\n  resolution: [{m}, {n}]\n"),
            format!("S_rect_02: {m} {n}\nP_rect_02: 500 0 300 0 0 500 200 0 0 0 1 0\n"),
            format!("Pinhole 500 500 300 200 0\n{m} {n}\n"),
            format!("LookAt 3 4 1 0 4 1 0 0 1\nCamera \"perspective\" \"float fov\" [45]\nFilm \"rgb\" \"integer xresolution\" [{m}] \"integer yresolution\" [{n}]\n"),
            format!("Format {m} {n} 1\nProjection \"perspective\" \"fov\" [40]\nTranslate 0 0 5\nWorldBegin\n"),
            format!("{{\"height\": {n}, \"width\": {m}, \"k\": [500, 0, 300, 0, 500, 200, 0, 0, 1], \"binning_x\": 1, \"binning_y\": 1}}"),
            format!("<project><VCGCamera TranslationVector=\"-2 -1 -6 1\" ViewportPx=\"{m} {n}\" PixelSizeMm=\"0.01 0.01\" CenterPx=\"300 240\" \
                FocalMm=\"5\" RotationMatrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></project>"),
        ]);
        for text in texts {
            let found = cameras(&text)[0].image;
            prop_assert_eq!(found, Some(ImageSize { width: m, height: n }), "{}", text);
        }
    }

    /// Pixels that are put together divide the size, and the part of an image is one of its window.
    #[test]
    fn binned_pixels_keep_the_window(by in 2..5_u32, x in 0..100_u32, y in 0..100_u32) {
        let [m, n] = [40 * by * 4, 30 * by * 4];
        let roi = format!("\"roi\": {{\"x_offset\": {x}, \"y_offset\": {y}, \"width\": {m}, \"height\": {n}}}");
        for matrix in ["\"k\": [500, 0, 300, 0, 500, 200, 0, 0, 1]", "\"p\": [500, 0, 300, 0, 0, 500, 200, 0, 0, 0, 1, 0]"] {
            let text = format!("{{\"width\": 4000, \"height\": 3000, {matrix}, {roi}, \"binning_x\": {by}, \"binning_y\": {by}}}");
            prop_assert_eq!(cameras(&text)[0].image, Some(ImageSize { width: m / by, height: n / by }));
            let [x, y, m, n] = [x, y, m, n].map(f64::from);
            spans(&text, [(x - 300.0) / 500.0, (x + m - 300.0) / 500.0, (200.0 - y - n) / 500.0, (200.0 - y) / 500.0]);
        }
    }

    /// The nodes above a camera of glTF: scales and mirrors move it, and only rotations turn it.
    #[test]
    fn scales_above_a_camera_of_gltf_only_move_it(scale in prop::array::uniform3(prop_oneof![-3.0..-0.2_f64, 0.2..3.0_f64]), turn in -3.0..3.0_f64) {
        let (s, c) = (turn / 2.0).sin_cos();
        let text = format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"scale": {scale:?}, "children": [1]}}, {{"camera": 0, "translation": [1, 2, 5], "rotation": [0, {s:?}, 0, {c:?}]}}],
            "cameras": [{{"type": "perspective", "perspective": {{"yfov": 0.8, "znear": 0.3}}}}]}}"#
        );
        let camera = first(&text);
        prop_assert!(camera.position().abs_diff_eq(DVec3::from_array(scale) * DVec3::new(1.0, 2.0, 5.0), 1e-9));
        let dop = DVec3::new(-turn.sin(), 0.0, -turn.cos());
        prop_assert!(camera.direction_of_projection().abs_diff_eq(dop, 1e-9), "{text}");
        prop_assert!((camera.view_angle().radians() - 0.8).abs() < 1e-9);
    }
}

#[test]
fn scene_files_are_read() {
    let pbrt = "LookAt 3 4 1.5  0 4 1.5  0 0 1\nCamera \"perspective\" \"float fov\" [45]\nFilm \"rgb\" \"integer xresolution\" [300] \"integer yresolution\" [400]\n";
    // Left-handed: z is reversed. The angle is that of the smaller side.
    let camera = stands(pbrt, [3.0, 4.0, -1.5], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
    assert!((camera.window().width() / camera.near() - 2.0 * 22.5_f64.to_radians().tan()).abs() < 1e-12);
    let mitsuba = "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/><float name=\"near_clip\" value=\"0.5\"/>\
        <float name=\"far_clip\" value=\"50\"/><transform name=\"to_world\"><lookat target=\"4, 3, 0\" up=\"0, 1, 0\" origin=\"4, 3, 5\"/></transform>\
        <film type=\"hdrfilm\"><integer name=\"width\" value=\"800\"/><integer name=\"height\" value=\"400\"/></film></sensor></scene>";
    let camera = stands(mitsuba, [4.0, 3.0, 5.0], AHEAD, UP);
    assert_eq!((camera.near(), camera.far()), (0.5, 50.0));
    assert!((camera.window().width() / camera.near() - 2.0 * 20.0_f64.to_radians().tan()).abs() < 1e-12);
    let x3d = "<X3D><Scene><Viewpoint DEF='A' position='4 2 3' orientation='0 1 0 1.5707963267948966' fieldOfView='0.9'/>\
        <Viewpoint DEF='B' position='1 2 3' orientation='1 0 0 -0.3'/></Scene></X3D>";
    let camera = stands(x3d, [4.0, 2.0, 3.0], [-1.0, 0.0, 0.0], UP);
    assert!((camera.view_angle().radians() - 0.9).abs() < 1e-12);
    assert_eq!(camera_names(&cameras(x3d)), ["A", "B"]);
    let pov = "camera {\n  orthographic\n  location <2, 3, -6>\n  look_at <2, 3, 0>\n  angle 90\n}\n";
    let camera = stands(pov, [2.0, 3.0, 6.0], AHEAD, UP);
    assert_eq!(camera.projection(), Projection::Parallel);
    assert!((camera.window().width() - 12.0).abs() < 1e-9, "2 D tan 45°");
    let meshlab = "<project><VCGCamera TranslationVector=\"-2 -1 -6 1\" ViewportPx=\"640 480\" PixelSizeMm=\"0.01 0.01\" CenterPx=\"300 240\" \
        FocalMm=\"5\" RotationMatrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></project>";
    stands(meshlab, [2.0, 1.0, 6.0], AHEAD, UP);
    spans(meshlab, [-0.6, 0.68, -0.48, 0.48]);
    let blender = "cam.location = (1, -6, 2)\ncam.rotation_euler = (1.5707963267948966, 0, 0)\ncam.data.lens = 50\ncam.data.sensor_width = 36\n";
    stands(blender, [1.0, 2.0, 6.0], AHEAD, UP);
    let sexp = "(camera (up 0 1 0) (target 1 2 0) (position 1 2 3) (fov 40))";
    stands(sexp, [1.0, 2.0, 3.0], AHEAD, UP);
}

/// Files whose cameras stand in parts: their places are multiplied.
#[test]
fn parts_above_a_camera_move_it() {
    let usd = "#usda 1.0\n(\n    upAxis = \"Y\"\n)\ndef Xform \"W\"\n{\n    double3 xformOp:translate = (1, 2, 3)\n    float3 xformOp:rotateXYZ = (0, 90, 0)\n    \
        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateXYZ\"]\n    def Camera \"A\"\n    {\n        \
        matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (4, 3, 6, 1) )\n    }\n    def Camera \"B\"\n    {\n        \
        float focalLength = 35\n    }\n}\n";
    // A quarter of a turn about y takes (4, 3, 6) to (6, 3, −4).
    let own = stands(usd, [7.0, 5.0, -1.0], [-1.0, 0.0, 0.0], UP);
    assert!((own.view_angle().degrees() - 2.0 * (15.2908_f64 / 100.0).atan().to_degrees()).abs() < 1e-9);
    assert_eq!(camera_names(&cameras(usd)), ["A", "B"]);
    let lens = |id: &str, angle: u32| {
        format!(
            "<camera id=\"{id}\"><optics><technique_common><perspective><yfov>{angle}</yfov></perspective></technique_common></optics></camera>"
        )
    };
    let dae = format!(
        "<COLLADA><asset><up_axis>Z_UP</up_axis></asset><library_cameras>{}{}</library_cameras><library_visual_scenes><visual_scene>\
        <node name=\"A\"><translate>1 2 3</translate><rotate>1 0 0 90</rotate><instance_camera url=\"#b\"/></node>\
        <node name=\"P\"><matrix>1 0 0 0 0 1 0 0 0 0 1 5 0 0 0 1</matrix><node name=\"B\"><rotate>1 0 0 90</rotate><instance_camera url=\"#a\"/></node></node>\
        </visual_scene></library_visual_scenes></COLLADA>",
        lens("a", 40),
        lens("b", 50)
    );
    assert_eq!(camera_names(&cameras(&dae)), ["A", "B"]);
    // z is up there.
    let first = stands(&dae, [1.0, 3.0, -2.0], AHEAD, UP);
    assert!((first.view_angle().degrees() - 50.0).abs() < 1e-9);
    let second = camera(&cameras(&dae)[1]).unwrap().0;
    assert!(second.position().abs_diff_eq(DVec3::new(0.0, 5.0, 0.0), 1e-9), "{}", second.position());
    // The camera of pbrt looks along z, and a mirror makes its world right-handed.
    let pbrt =
        |steps: &str| format!("{steps}\nCamera \"perspective\" \"float fov\" [45]\nWorldBegin\nTranslate 9 9 9\n");
    stands(&pbrt("Translate 0 0 5\nRotate 90 0 1 0"), [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], UP);
    stands(&pbrt("Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 -1 6 1]"), [0.0, 1.0, 6.0], AHEAD, UP);
    stands(&pbrt("Scale -1 1 1\nLookAt 3 4 1.5 0 4 1.5 0 0 1"), [3.0, 4.0, 1.5], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    assert!(matches!(camera(&cameras(&pbrt("Scale 2 1 1\nTranslate 0 0 5"))[0]), Err(RecoveryError::Length { .. })));
}

#[test]
fn code_and_texts_of_more_programs_are_read() {
    // Yaw turns x towards y, and a world of centimetres has z up and is left-handed.
    let unreal = "FVector Location(100, 200, 300);\nFRotator Rotation(0, 90, 0);\n";
    stands(unreal, [1.0, 3.0, 2.0], [0.0, 0.0, 1.0], UP);
    let copied = "RelativeLocation=(X=100,Y=200,Z=300)\nRelativeRotation=(Roll=0,Pitch=-90,Yaw=0)\nFieldOfView=90\n";
    stands(copied, [1.0, 3.0, 2.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]);
    let pov = |rest: &str| format!("camera {{\n  location <0, 2, -5>\n  look_at <0, 2, 0>\n  {rest}\n}}\n");
    spans(&pov("right x*1.5\n  up y\n  angle 90"), [-1.0, 1.0, -2.0 / 3.0, 2.0 / 3.0]);
    spans(&pov("up <0, 2, 0>\n  right <3, 0, 0>\n  direction 2*z"), [-0.75, 0.75, -0.5, 0.5]);
    stands(&pov("right -x*4/3"), [0.0, 2.0, -5.0], [0.0, 0.0, 1.0], UP);
    let unity = "Camera:\n  near clip plane: 0.3\n  far clip plane: 90\n  field of view: 60\n  orthographic: 0\nTransform:\n  \
        m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}\n  m_LocalPosition: {x: 1, y: 2, z: -10}\n";
    let camera = stands(unity, [1.0, 2.0, 10.0], AHEAD, UP);
    assert_eq!((camera.near(), camera.far()), (0.3, 90.0));
    let glm = "view = glm::lookAt(glm::vec3(1, 2, 3), glm::vec3(1, 2, 0), glm::vec3(0, 1, 0));\nproj = glm::perspective(glm::radians(90.0f), 8.0f / 4.0f, 0.1f, 100.0f);\n";
    stands(glm, [1.0, 2.0, 3.0], AHEAD, UP);
    spans(glm, [-2.0, 2.0, -1.0, 1.0]);
    let parts = "camera.position.x = 1\ncamera.position.y = 2\ncamera.position.z = 3\ncamera.target = (1, 2, 0)\n";
    stands(parts, [1.0, 2.0, 3.0], AHEAD, UP);
    let both = "viewMatrix: [1,0,0,0, 0,1,0,0, 0,0,1,0, -1,-2,-5,1]\nprojectionMatrix: [1,0,0,0, 0,2,0,0, 0.5,0,-1.5,-1, 0,0,-5,0]\n";
    stands(both, [1.0, 2.0, 5.0], AHEAD, UP);
    spans(both, [-0.5, 1.5, -0.5, 0.5]);
    let godot = "[gd_scene format=3]\n[node name=\"A\" type=\"Camera3D\"]\ntransform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 5)\nprojection = 1\nsize = 8.0\n";
    assert!((first(godot).window().height() - 8.0).abs() < 1e-12);
    let labels =
        "Up vector: [0, 1, 0]\nLook at point: [1, 2, 0]\nCamera position: [1, 2, 5]\nVertical FOV (degrees): 90\n";
    spans(labels, [-4.0 / 3.0, 4.0 / 3.0, -1.0, 1.0]);
    for position in ["{x: 1, y: 2, z: 3}", "{z: 3, x: 1, y: 2}"] {
        stands(&format!("target: {{y: 2, z: 0, x: 1}}\nposition: {position}\n"), [1.0, 2.0, 3.0], AHEAD, UP);
    }
    let sides = "[left]\neye = -1 0 5\ntarget = -1 0 0\n[right]\neye = 1 0 5\ntarget = 1 0 0\n";
    assert_eq!(camera_names(&cameras(sides)), ["left", "right"]);
}

/// Coefficients of 0 are no distortion.
#[test]
fn no_distortion_is_used() {
    let info = "width: 640\nheight: 480\nK: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nD: [0, 0, 0, 0, 0]\n";
    let pasted = &cameras(info)[0];
    assert!(pasted.left_out.is_empty() && pasted.used.iter().any(|used| used.name == "D"), "{pasted:?}");
    assert_eq!(camera(pasted).unwrap().1, Certainty::Only);
}

#[test]
fn a_part_of_a_window_is_a_part_of_it() {
    let three = |rest: &str| {
        format!(
            "{{\"object\": {{\"type\": \"PerspectiveCamera\", \"fov\": 90, \"aspect\": 1, \"near\": 1, \"far\": 9, {rest}, \"matrix\": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}}}}"
        )
    };
    let view = "\"view\": {\"enabled\": true, \"fullWidth\": 800, \"fullHeight\": 800, \"offsetX\": 400, \"offsetY\": 200, \"width\": 400, \"height\": 400}";
    spans(&three(view), [0.0, 1.0, -0.5, 0.5]);
    spans(&three(&view.replace("true", "false")), [-1.0, 1.0, -1.0, 1.0]);
    // 7 mm of 35 mm, a fifth of the whole width 2.
    spans(&three("\"filmGauge\": 35, \"filmOffset\": 7"), [-0.8, 1.2, -1.0, 1.0]);
    spans(&three("\"zoom\": 2"), [-0.5, 0.5, -0.5, 0.5]);
    let usd = "#usda 1.0\ndef Camera \"C\"\n{\n    float focalLength = 20\n    float horizontalAperture = 40\n    float verticalAperture = 20\n    float horizontalApertureOffset = 4\n    matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (4, 3, 6, 1) )\n}\n";
    stands(usd, [4.0, 3.0, 6.0], AHEAD, UP);
    spans(usd, [-0.8, 1.2, -0.5, 0.5]);
    let vtk = "camera.SetPosition(0, 0, 5)\ncamera.SetFocalPoint(0, 0, 0)\ncamera.SetViewUp(0, 1, 0)\ncamera.SetViewAngle(90)\ncamera.SetWindowCenter(0.5, 0)\n";
    let camera = first(vtk);
    assert!((camera.window().left / camera.window().width() + 0.25).abs() < 1e-9);
}

#[test]
fn a_pair_with_a_baseline_stands_in_one_world() {
    let calib = "cam0=[4000 0 1176.5; 0 4000 1011.5; 0 0 1]\ncam1=[4000 0 1307.5; 0 4000 1011.5; 0 0 1]\ndoffs=131\nbaseline=200\nwidth=2964\nheight=1988\n";
    let all = cameras(calib);
    let places: Vec<DVec3> = all.iter().map(|pasted| camera(pasted).unwrap().0.position()).collect();
    assert_eq!(places, [DVec3::ZERO, DVec3::new(200.0, 0.0, 0.0)]);
    let zed = "[LEFT_CAM_HD]\nfx=700\nfy=700\ncx=640\ncy=360\n[RIGHT_CAM_HD]\nfx=700\nfy=700\ncx=640\ncy=360\n[STEREO]\nBaseline=120\n";
    let all = cameras(zed);
    assert_eq!(camera_names(&all), ["LEFT_CAM_HD", "RIGHT_CAM_HD"]);
    assert_eq!(camera(&all[1]).unwrap().0.position(), DVec3::new(120.0, 0.0, 0.0));
}

#[test]
fn other_sensors_and_maps_are_no_cameras() {
    let kitti = "P0: 700 0 600 0 0 700 180 0 0 0 1 0\nP1: 700 0 600 -350 0 700 180 0 0 0 1 0\nTr_velo_to_cam: 0 -1 0 0 0 0 -1 0 1 0 0 0\n";
    let all = cameras(kitti);
    assert_eq!(camera_names(&all), ["P0", "P1"]);
    assert!(all[0].left_out.iter().any(|left| left.name == "Tr_velo_to_cam" && left.why == Why::NotCamera));
    for text in [
        "H = [[1.2,0.1,30],[0.05,1.1,20],[0.0001,0.0002,1]]",
        "fundamental: 1 2 3 4 5 6 7 8 9",
        "Q = [[1, 0, 0, -318.5], [0, 1, 0, -242.25], [0, 0, 0, 520], [0, 0, 0.15, 0]]",
    ] {
        assert!(read_cameras(text.as_bytes()).is_err(), "{text}");
    }
    let bare = "[[1, 0, 0, -318.5], [0, 1, 0, -242.25], [0, 0, 0, 520], [0, 0, 0.15, 0]]";
    assert_eq!(camera(&cameras(bare)[0]).unwrap_err(), RecoveryError::Disparity);
}

#[test]
fn two_lines_of_tum_are_two_poses() {
    for head in ["", "# timestamp tx ty tz qx qy qz qw\n"] {
        let all = cameras(&format!("{head}0 0 0 5 0 0 0 1\n1 1 0 5 0 0 0 1\n"));
        assert_eq!(all.len(), 2, "{head}");
    }
    // The head decides the order.
    let turned = "# timestamp tx ty tz qx qy qz qw\n0 1 2 3 0.6 0 0 0.8\n1 1 0 5 0 0 0 1\n";
    let camera = first(turned);
    assert!(camera.position().abs_diff_eq(DVec3::new(1.0, 2.0, 3.0), 1e-12) || camera.position().y == 3.0);
}

/// Texts of other programs, of the kind of public questions, each behind a line with its name.
const TEXTS: &str = include_str!("camera_texts.txt");

fn texts() -> impl Iterator<Item = (&'static str, &'static str)> {
    TEXTS.split("=== ").filter_map(|part| part.split_once('\n'))
}

/// The answer to a text: each camera with its entries, or the message.
fn answer(text: &str) -> String {
    match read_cameras(text.as_bytes()) {
        Ok(all) => all
            .iter()
            .map(|pasted| format!("{pasted:?} {:?}", camera(pasted).map(|found| *found.0.parameters())))
            .collect(),
        Err(error) => error.to_string(),
    }
}

/// The places of names and of numbers in a text, without its comments.
fn words(text: &str) -> Vec<Range<usize>> {
    let is_part = |c: char| c.is_alphanumeric() || "_.+-".contains(c);
    let mut all = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let comment = ["#", "//", "%", "<?"].iter().any(|mark| line.trim_start().starts_with(mark));
        let mut at = start;
        for part in line.split(|c| !is_part(c)).filter(|_| !comment) {
            if !part.is_empty() {
                all.push(at..at + part.len());
            }
            at += part.len() + text[at + part.len()..].chars().next().map_or(0, char::len_utf8);
        }
        start += line.len();
    }
    all
}

/// An entry that is deleted, doubled or renamed, and two numbers that change places, are noticed.
#[test]
fn no_change_of_an_entry_goes_unnoticed() {
    let (mut count, mut unnoticed) = (0, Vec::new());
    for (id, text) in texts() {
        let right = answer(text);
        let mut check = |what: &str, changed: String| {
            count += 1;
            if changed != text && answer(&changed) == right {
                unnoticed.push(format!("{id}: {what}"));
            }
        };
        let (mut names, mut values) = (Vec::new(), Vec::new());
        for pasted in read_cameras(text.as_bytes()).unwrap_or_default() {
            let used = pasted.used.iter().map(|used| (&used.name, &used.value));
            for (name, value) in used.chain(pasted.left_out.iter().map(|left| (&left.name, &left.value))) {
                names.extend(name.split([',', ' ', '.', '[', ']']).filter(|part| !part.is_empty()).map(str::to_owned));
                values.extend(value.split(' ').filter_map(|part| part.parse::<f64>().ok()));
            }
        }
        let all = words(text);
        let number = |place: &Range<usize>| text[place.clone()].parse::<f64>().ok();
        let is_name =
            |place: &&Range<usize>| number(place).is_none() && names.contains(&text[(*place).clone()].to_owned());
        // A name that stands elsewhere too has other meanings, such as that of a key between parts.
        let times = |word: &str| all.iter().filter(|place| &text[(*place).clone()] == word).count();
        for place in all.iter().filter(is_name).filter(|place| times(&text[(*place).clone()]) == 1) {
            let renamed = format!("{}xyz{}", &text[..place.end], &text[place.end..]);
            check(&format!("renamed {}", &text[place.clone()]), renamed);
        }
        let shown = |place: &&Range<usize>| number(place).is_some_and(|number| values.contains(&number));
        // Counts and indices of a list aren't entries.
        let is_shape = |at: usize| {
            let name = at.checked_sub(1).map_or("", |before| &text[all[before].clone()]);
            ["rows", "cols", "index", "id", "number_of_elements", "sensor_id", "next_id"].contains(&name)
        };
        let numbers: Vec<_> = all
            .iter()
            .enumerate()
            .filter(|(at, place)| shown(place) && !is_shape(*at))
            .map(|(_, place)| place)
            .collect();
        for pair in numbers.windows(2).filter(|pair| number(pair[0]) != number(pair[1])) {
            let [a, b] = [pair[0].clone(), pair[1].clone()];
            let parts = [&text[..a.start], &text[b.clone()], &text[a.end..b.start], &text[a.clone()], &text[b.end..]];
            check(&format!("exchanged {} and {}", &text[a], &text[b]), parts.concat());
        }
        let lines: Vec<&str> = text.lines().collect();
        let mut begin = 0;
        for (at, line) in lines.iter().enumerate() {
            let here = begin..begin + line.len();
            begin += line.len() + 1;
            let own = || all.iter().filter(|place| here.contains(&place.start));
            // A head without a number is no entry.
            if own().any(|place| is_name(&place)) && own().any(|place| number(place).is_some()) {
                check(&format!("deleted {line}"), [&lines[..at], &lines[at + 1..]].concat().join("\n"));
                check(&format!("doubled {line}"), [&lines[..=at], &lines[at..]].concat().join("\n"));
            }
        }
    }
    assert!(count > 1200, "{count}");
    assert!(unnoticed.is_empty(), "{} of {count}:\n{}", unnoticed.len(), unnoticed.join("\n"));
}

/// Every reading of a text with an entry of unknown meaning is less than certain.
#[test]
fn only_needs_every_entry() {
    let text = "eye = (2, 3, 8)\ncenter = (0, 1, 0)\nup = (0, 1, 0)\nfov = 40";
    assert_eq!(camera(&cameras(text)[0]).unwrap().1, Certainty::Only);
    for more in ["lensThing = 3", "squeeze: [1.5, 1]", "mood = \"blue\""] {
        let found = cameras(&format!("{text}\n{more}"));
        assert_eq!(camera(&found[0]).unwrap().1, Certainty::Likely, "{more}");
        assert_eq!(found[0].left_out[0].why.changes_image(), None);
    }
    let bare = "4 3 5\n1 0 0.5\n0 0 1";
    assert!(camera(&cameras(bare)[0]).unwrap().1 < Certainty::Only, "three vectors without a word");
}
