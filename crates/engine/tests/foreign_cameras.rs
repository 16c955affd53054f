//! Cameras as other programs write them, made here from the conventions and not by the reader: no reading may be
//! certain and wrong.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{
    Axes, Camera, Candidate, Certainty, ImageSize, MatrixKind, Parameters, Projection, RecoveryError, Stated, Unknown,
    ViewWindow, read_cameras, recognise,
};
use glam::{DMat3, DMat4, DVec3};
use proptest::prelude::*;

/// A program: the rows of the axes x, y, z of its camera in **u**, **v**, **n**, and how a vector of our world is
/// written in its world.
struct Program {
    name: &'static str,
    camera: [DVec3; 3],
    world: DMat3,
}

/// From the programs' own documentation: which way x, y and z point.
fn programs() -> Vec<Program> {
    const X: DVec3 = DVec3::X;
    const Y: DVec3 = DVec3::Y;
    const Z: DVec3 = DVec3::Z;
    let same = DMat3::IDENTITY;
    // y up → z up: (x, y, z) → (x, −z, y).
    let z_up = DMat3::from_cols(X, Z, -Y);
    // Left-handed: z the other way.
    let left = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
    // Left-handed and z up: y and z change places, as in Epic's exporter of glTF.
    let exchanged = DMat3::from_cols(X, Z, Y);
    let program = |name, camera, world| Program { name, camera, world };
    vec![
        program("OpenGL", [X, Y, Z], same),
        program("Blender", [X, Y, Z], z_up),
        program("OpenCV", [X, -Y, -Z], same),
        program("Direct3D", [X, Y, -Z], left),
        program("worldToCameraMatrix", [X, Y, Z], left),
        program("Unreal", [-Z, X, Y], exchanged),
        program("PyTorch3D", [-X, Y, -Z], same),
        program("ROS", [-Z, -X, Y], z_up),
    ]
}

/// z_n at F and at B, whether y_n points down, whether the camera of M_p looks along +z.
const NDC: [([f64; 2], bool, bool); 7] = [
    ([-1.0, 1.0], false, false),
    ([0.0, 1.0], false, false),
    ([0.0, 1.0], false, true),
    ([1.0, 0.0], false, true),
    ([0.0, 1.0], true, false),
    ([1.0, 0.0], true, false),
    ([1.0, -1.0], false, false),
];

impl Program {
    fn view(&self, camera: &Camera) -> DMat4 {
        let rows = DMat3::from_cols(self.camera[0], self.camera[1], self.camera[2]).transpose();
        DMat4::from_mat3(rows) * camera.view_from_world() * DMat4::from_mat3(self.world.transpose())
    }
}

/// M_p for our VRC, from z_n = a + d/δ with the depth δ.
fn projection(camera: &Camera, ([at_near, at_far], y_down, _): ([f64; 2], bool, bool)) -> DMat4 {
    let (near, far, w) = (camera.near(), camera.far(), camera.window());
    let down = if y_down { -1.0 } else { 1.0 };
    let [width, height] = [w.right - w.left, w.top - w.bottom];
    let d = (at_near - at_far) * near * far / (far - near);
    let a = at_near - d / near;
    let rows = [
        [2.0 * near / width, 0.0, (w.right + w.left) / width, 0.0],
        [0.0, down * 2.0 * near / height, down * (w.top + w.bottom) / height, 0.0],
        [0.0, 0.0, -a, d],
        [0.0, 0.0, -1.0, 0.0],
    ];
    DMat4::from_cols_array_2d(&rows).transpose()
}

fn camera() -> impl Strategy<Value = Camera> {
    let pose =
        (prop::array::uniform3(-9.0..9.0_f64), prop::array::uniform3(-2.0..2.0_f64), any::<bool>(), -0.4..0.4_f64);
    let lens = (20.0..100.0_f64, 0.6..2.0_f64, 0.05..1.0_f64, 5.0..200.0_f64, any::<bool>(), any::<bool>());
    (pose, lens).prop_filter_map(
        "a camera",
        |((position, target, level, roll), (angle, aspect, near, far, off, round))| {
            let round_to = |x: f64| if round { (x * 10.0).round() / 10.0 } else { x };
            let position = DVec3::from_array(position.map(round_to));
            let view_up = if level { DVec3::Y } else { DVec3::new(roll, 1.0, 0.1) };
            let near = round_to(near).max(0.1);
            let half = near * (angle / 2.0).to_radians().tan();
            let sides = ViewWindow { left: -half * aspect, right: 1.2 * half * aspect, bottom: -0.9 * half, top: half };
            let window = off.then_some(sides);
            let focal_point = DVec3::from_array(target);
            let far = round_to(far);
            let p = Parameters {
                position,
                focal_point,
                view_up,
                view_angle: angle,
                aspect,
                near,
                far,
                window,
                ..Parameters::default()
            };
            Camera::new(&p).ok()
        },
    )
}

/// As a program prints it: by rows or columns, in lines or as a list, with all digits or six decimals.
fn text(m: DMat4, by_columns: bool, in_lines: bool, digits: Option<usize>) -> String {
    let m = if by_columns { m } else { m.transpose() };
    let number = |x: f64| digits.map_or_else(|| format!("{x:?}"), |digits| format!("{x:.digits$}"));
    let lines = m.to_cols_array_2d().map(|line| line.map(number).join(", "));
    if in_lines { lines.join("\n") } else { format!("[{}]", lines.join(", ")) }
}

/// The difference between a camera that was read and the right one, in the parameters that its kind holds.
fn difference(read: &Candidate, right: &Camera) -> f64 {
    let found = Camera::new(&read.found.parameters).unwrap();
    let mut worst = 0.0_f64;
    if read.reading.kind.has_pose() {
        worst = worst.max((found.position() - right.position()).length() / (1.0 + right.position().length()));
        worst = worst.max((found.basis().n - right.basis().n).length());
        worst = worst.max((found.basis().v - right.basis().v).length());
    }
    if read.reading.kind.has_ndc() || read.reading.kind.has_pixels() {
        let slopes = |c: &Camera| c.window().map(|side| side / c.near());
        let (a, b) = (slopes(&found), slopes(right));
        worst = [(a.left, b.left), (a.right, b.right), (a.bottom, b.bottom), (a.top, b.top)]
            .into_iter()
            .fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
        worst = worst.max((found.near() / right.near() - 1.0).abs());
        if !read.found.unknown.contains(&Unknown::Far) {
            // B is the inverse of a difference, so few digits say little of it.
            worst = worst.max((1.0 / found.far() - 1.0 / right.far()).abs() * right.near());
        }
    }
    worst
}

/// Reads a text, and checks that the right camera is among the readings, and that no wrong one is certain.
fn check(text: &str, kind: MatrixKind, right: &Camera, image: ImageSize, tolerance: f64) -> Result<(), TestCaseError> {
    let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
    let stated = Stated { image, ..Stated::default() };
    let found = recognise(pasted, &stated, right.parameters());
    let found = found.map_err(|error| TestCaseError::fail(format!("{kind:?}: {error}\n{text}")))?;
    let is_right = |c: &Candidate| c.reading.kind == kind && difference(c, right) < tolerance;
    prop_assert!(found.readings.iter().any(is_right), "{kind:?} isn't among {:#?}\n{text}", found.readings);
    let best = found.best();
    if best.certainty == Certainty::Only {
        prop_assert!(is_right(best), "certain and wrong: {best:#?}\n{text}");
    }
    Ok(())
}

/// The table of axes writes M_v and its inverse as the programs define them.
#[test]
fn the_table_of_axes_is_that_of_the_programs() {
    let right = camera_of([2.0, 3.0, 7.0]);
    for program in programs() {
        let axes = Axes::ALL.into_iter().find(|axes| axes.title.contains(program.name)).unwrap();
        let (view, inverse) = (axes.view_from_world(&right), axes.world_from_view(&right));
        assert!(view.abs_diff_eq(program.view(&right), 1e-14), "{}: {view}", program.name);
        assert!((view * inverse).abs_diff_eq(DMat4::IDENTITY, 1e-13), "{}: {inverse}", program.name);
    }
}

/// The number of random cameras. A few hundred take seconds, and `.ci/release` asks for 10,000.
fn cases() -> u32 {
    std::env::var("CAMERA_LAB_CASES").ok().and_then(|count| count.parse().ok()).unwrap_or(200)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_view_is_certain_and_wrong(right in camera(), by_columns in any::<bool>(), in_lines in any::<bool>(), six in any::<bool>()) {
        for program in programs() {
            let view = program.view(&right);
            let digits = six.then_some(6);
            for (kind, matrix) in [(MatrixKind::View, view), (MatrixKind::CameraToWorld, view.inverse())] {
                let text = text(matrix, by_columns, in_lines, digits);
                check(&text, kind, &right, ImageSize::default(), 1e-4).map_err(|e| TestCaseError::fail(format!("{} {e}", program.name)))?;
            }
        }
    }

    #[test]
    fn no_projection_is_certain_and_wrong(right in camera(), by_columns in any::<bool>(), in_lines in any::<bool>(), six in any::<bool>()) {
        let digits = six.then_some(6);
        for ndc in NDC {
            let m_p = projection(&right, ndc);
            let forward = DMat4::from_scale(DVec3::new(1.0, 1.0, if ndc.2 { -1.0 } else { 1.0 }));
            let text_of = |m: DMat4| text(m, by_columns, in_lines, digits);
            check(&text_of(m_p * forward), MatrixKind::Projection, &right, ImageSize::default(), 1e-2)?;
            // A left-handed camera stands in a left-handed world.
            let product = m_p * right.view_from_world() * forward;
            check(&text_of(product), MatrixKind::ViewProjection, &right, ImageSize::default(), 1e-2)?;
        }
    }

    #[test]
    fn no_pinhole_is_certain_and_wrong(right in camera(), factor in 0.1..10.0_f64) {
        let image = ImageSize { width: 640, height: 480 };
        let w = right.window();
        let [f_x, f_y] = [640.0 / (w.right - w.left), 480.0 / (w.top - w.bottom)].map(|per_unit| per_unit * right.near());
        let (x, y) = (-w.left / (w.right - w.left) * 640.0, w.top / (w.top - w.bottom) * 480.0);
        let k = DMat3::from_cols_array(&[f_x, 0.0, 0.0, 0.0, f_y, 0.0, x, y, 1.0]);
        let view = programs()[2].view(&right);
        let p = DMat4::from_mat3(k) * view;
        let rows: Vec<String> = (0..3).map(|i| (p.row(i) * factor).to_array().map(|x| x.to_string()).join(" ")).collect();
        check(&rows.join("\n"), MatrixKind::Pinhole, &right, image, 1e-6)?;
        check(&format!("{}\n0 0 0 1", rows.join("\n")), MatrixKind::Pinhole, &right, image, 1e-6)?;
        // K alone.
        let text = format!("[[{f_x:?}, 0, {x:?}], [0, {f_y:?}, {y:?}], [0, 0, 1]]");
        check(&text, MatrixKind::Intrinsics, &right, image, 1e-6)?;
    }

    /// COLMAP and TUM: a quaternion w x y z and t of M_v, t and a quaternion x y z w of its inverse.
    #[test]
    fn no_quaternion_is_certain_and_wrong(right in camera()) {
        let view = programs()[2].view(&right);
        let (_, q, t) = view.to_scale_rotation_translation();
        let colmap = format!("{:?} {:?} {:?} {:?} {:?} {:?} {:?}", q.w, q.x, q.y, q.z, t.x, t.y, t.z);
        check(&colmap, MatrixKind::View, &right, ImageSize::default(), 1e-6)?;
        let (_, q, t) = view.inverse().to_scale_rotation_translation();
        let tum = format!("{:?} {:?} {:?} {:?} {:?} {:?} {:?}", t.x, t.y, t.z, q.x, q.y, q.z, q.w);
        check(&tum, MatrixKind::CameraToWorld, &right, ImageSize::default(), 1e-6)?;
    }
}

/// The error of a text that is no camera.
fn fault(text: &str) -> RecoveryError {
    let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
    recognise(pasted, &Stated::default(), &Parameters::default()).unwrap_err()
}

fn best(text: &str) -> Candidate {
    let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
    let stated = Stated { image: pasted.image.unwrap_or_default(), ..Stated::default() };
    recognise(pasted, &stated, &Parameters::default()).unwrap().best().clone()
}

#[test]
fn a_refusal_names_the_cause() {
    // An infinite reversed projection whose F was forgotten: every depth is 0.
    assert!(matches!(fault("2 0 0 0\n0 2 0 0\n0 0 0 0\n0 0 -1 0"), RecoveryError::Singular { at: 3, .. }));
    // A look-at along its own VUP: u and v vanish.
    assert!(matches!(fault("0 0 0 0\n0 0 0 0\n0 -1 0 9\n0 0 0 1"), RecoveryError::ViewUpAlongView { a: 1, b: 2, .. }));
    // The shift of the window stands one row too low.
    assert!(matches!(
        fault("2 0 0 0\n0 2 0 0\n0 0 -1.2 -2.2\n0.5 0 -1 0"),
        RecoveryError::NotZero { row: 4, column: 1, .. }
    ));
    for spelling in ["NaN", "nan", "-nan", "inf", "-Infinity", "1.#INF", "-1.#IND", "np.nan"] {
        let text = format!("1 0 0 0\n0 1 {spelling} 0\n0 0 1 0\n0 0 0 1");
        assert!(matches!(fault(&text), RecoveryError::NotFinite { row: 2, column: 3, .. }), "{spelling}");
    }
    assert!(matches!(fault("1 0 0\n0 0 -1\n0 1 0"), RecoveryError::RotationAlone));
    assert!(matches!(fault("1 2 3 4 5 6 7"), RecoveryError::Quaternion));
}

/// 90°, A 1, F 1, B 3: x and y are 1, z and d are −2 and −3 in −1 … 1.
#[test]
fn a_projection_is_read_as_programs_print_it() {
    for text in [
        "[\n    [1.0, 0.0, 0.0, 0.0],\n    [0.0, 1.0, 0.0, 0.0],\n    [0.0, 0.0, -2.0, -1.0],\n    [0.0, 0.0, -3.0, 0.0],\n]",
        "Mat4 { x_axis: Vec4(1.0, 0.0, 0.0, 0.0), y_axis: Vec4(0.0, 1.0, 0.0, 0.0), z_axis: Vec4(0.0, 0.0, -2.0, -1.0), w_axis: Vec4(0.0, 0.0, -3.0, 0.0) }",
        "\n  ┌                     ┐\n  │  1  0  0  0 │\n  │  0  1  0  0 │\n  │  0  0 -2 -3 │\n  │  0  0 -1  0 │\n  └                     ┘\n",
        "tensor([[ 1.,  0.,  0.,  0.],\n        [ 0.,  1.,  0.,  0.],\n        [ 0.,  0., -2., -3.],\n        [ 0.,  0., -1.,  0.]], device='cuda:0', dtype=torch.float64)",
        "const float proj[4][4] = {{1.0f, 0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f, -1.0f}, {0.0f, 0.0f, -3.0f, 0.0f}};",
        "Matrix4 {elements: Array(16)}\nelements: (16) [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0]",
        "[0] = {1 0 0 0}\n[1] = {0 1 0 0}\n[2] = {0 0 -2 -3}\n[3] = {0 0 -1 0}",
        "X: (1, 0, 0, 0), Y: (0, 1, 0, 0), Z: (0, 0, -2, -1), W: (0, 0, -3, 0)",
        "m00 = 1 m01 = 0 m02 = 0 m03 = 0 m10 = 0 m11 = 1 m12 = 0 m13 = 0 m20 = 0 m21 = 0 m22 = -2 m23 = -3 m30 = 0 m31 = 0 m32 = -1 m33 = 0",
        "{\"e\": {\"elements\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0]}}",
        "new THREE.Matrix4().set(1, 0, 0, 0,\n 0, 1, 0, 0,\n 0, 0, -2, -3,\n 0, 0, -1, 0)",
        "Row 0: 1 0 0 0\nRow 1: 0 1 0 0\nRow 2: 0 0 -2 -3\nRow 3: 0 0 -1 0",
        "1.0_f64, 0., 0., 0.,\n0., 1e0, 0., 0.,\n0., 0., -2.0E+0, -3.,\n0., 0., -1., 0.",
    ] {
        let best = best(text);
        assert_eq!(best.reading.kind, MatrixKind::Projection, "{text}");
        let p = best.found.parameters;
        assert!((p.view_angle - 90.0).abs() < 1e-9 && (p.aspect - 1.0).abs() < 1e-9, "{p:?}\n{text}");
        assert!((p.near - 1.0).abs() < 1e-9 && (p.far - 3.0).abs() < 1e-9, "{p:?}\n{text}");
    }
}

#[test]
fn files_of_other_programs_are_read() {
    let assert_pose = |best: &Candidate, position: [f64; 3], dop: [f64; 3], up: [f64; 3]| {
        let camera = Camera::new(&best.found.parameters).unwrap();
        for (found, right) in
            [(camera.position(), position), (camera.direction_of_projection(), dop), (camera.basis().v, up)]
        {
            assert!((found - DVec3::from_array(right)).length() < 1e-9, "{found} is not {right:?}");
        }
    };
    // COLMAP: half a turn about x, so y down and z into the scene become y up and z out.
    let colmap = "# Camera list with one line of data per camera:\n1 PINHOLE 640 480 500 500 320 240\n\
        # Image list\n1 0 1 0 0 0 0 4 1 first.png\n1.0 2.0 -1\n2 0 1 0 0 0.5 0 4 1 second.png\n\n";
    let cameras = read_cameras(colmap.as_bytes()).unwrap();
    assert_eq!(cameras.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["first.png", "second.png"]);
    let first = best(colmap);
    // t = (0, 0, 4), R = diag(1, −1, −1): C = −Rᵀt = (0, 0, 4).
    assert_pose(&first, [0.0, 0.0, 4.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    assert!((first.found.parameters.view_angle - 2.0 * 0.48_f64.atan().to_degrees()).abs() < 1e-9);
    // glTF: a quarter turn about y looks along −x, and the camera hangs on a node.
    let h = 0.5_f64.sqrt();
    let gltf = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
        "nodes": [{{"translation": [1, 2, 3], "children": [1]}}, {{"rotation": [0, {h}, 0, {h}], "camera": 0, "name": "eye"}}],
        "cameras": [{{"type": "perspective", "perspective": {{"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.25, "zfar": 40}}}}]}}"#
    );
    let eye = best(&gltf);
    assert_pose(&eye, [1.0, 2.0, 3.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let p = eye.found.parameters;
    assert!((p.view_angle - 0.7_f64.to_degrees()).abs() < 1e-12);
    assert_eq!((p.aspect, p.near, p.far), (1.5, 0.25, 40.0));
    // KITTI: the second camera stands 0.5 to the right. Four lenses are in a file.
    let row = |x: f64| format!("700 0 600 {x} 0 700 180 0 0 0 1 0");
    let kitti = format!(
        "P0: {}\nP1: {}\nR0_rect: 1 0 0 0 1 0 0 0 1\nTr_velo_to_cam: 0 -1 0 0 0 0 -1 0 1 0 0 0",
        row(0.0),
        row(-350.0)
    );
    let cameras = read_cameras(kitti.as_bytes()).unwrap();
    let second = cameras.iter().find(|camera| camera.name == "P1").unwrap();
    let stated = Stated { image: ImageSize { width: 1200, height: 360 }, ..Stated::default() };
    let found = recognise(second, &stated, &Parameters::default()).unwrap();
    assert_pose(found.best(), [0.5, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]);
    // PyVista: C, PF and VUP.
    let pyvista = best("[(4.0, 3.0, 5.0),\n (1.0, 0.0, 0.5),\n (0.0, 0.0, 1.0)]");
    assert_eq!(pyvista.reading.kind, MatrixKind::LookAt);
    let p = pyvista.found.parameters;
    assert_eq!(
        (p.position, p.focal_point, p.view_up),
        (DVec3::new(4.0, 3.0, 5.0), DVec3::new(1.0, 0.0, 0.5), DVec3::Z)
    );
    // three.js: an orthographic camera in a group.
    let three = r#"{"metadata": {"type": "Object"}, "object": {"type": "Scene", "children": [{"type": "OrthographicCamera",
        "left": -4, "right": 4, "top": 3, "bottom": -3, "near": 1, "far": 9, "zoom": 2, "matrix": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,7,1]}]}}"#;
    let parallel = best(three);
    assert_pose(&parallel, [0.0, 0.0, 7.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    let p = parallel.found.parameters;
    assert_eq!((p.projection, p.height, p.near, p.far), (Projection::Parallel, 3.0, 1.0, 9.0));
    // Open3D: a trajectory of two poses, from the camera to the world.
    let log = "0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 1 2\n1 0 0 0.5\n0 1 0 0\n0 0 1 -3\n0 0 0 1\n";
    let poses = read_cameras(log.as_bytes()).unwrap();
    assert_eq!(poses.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["0", "1"]);
    let found = recognise(&poses[1], &Stated::default(), &Parameters::default()).unwrap();
    assert_eq!(found.best().certainty, Certainty::Only);
    assert_pose(found.best(), [0.5, 0.0, -3.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]);
    // ParaView: its file, and its trace, which leaves out a focal point at the origin.
    let property = |name: &str, values: &[f64]| {
        let elements = values.iter().enumerate().map(|(k, x)| format!("<Element index=\"{k}\" value=\"{x}\"/>"));
        let elements: String = elements.collect();
        format!(
            "<Property name=\"{name}\" id=\"1.{name}\" number_of_elements=\"{}\">{elements}</Property>",
            values.len()
        )
    };
    let pvcc = [
        ("CameraPosition", &[4.0, 3.0, 5.0][..]),
        ("CameraFocalPoint", &[1.0, 0.0, 0.5]),
        ("CameraViewUp", &[0.0, 0.0, 1.0]),
        ("CameraViewAngle", &[40.0]),
        ("CameraParallelProjection", &[0.0]),
    ];
    let pvcc: String = pvcc.into_iter().map(|(name, values)| property(name, values)).collect();
    let p =
        best(&format!("<?xml version=\"1.0\"?><PVCameraConfiguration><Proxy>{pvcc}</Proxy></PVCameraConfiguration>"));
    let p = p.found.parameters;
    assert_eq!((p.position.to_array(), p.focal_point.to_array()), ([4.0, 3.0, 5.0], [1.0, 0.0, 0.5]));
    assert_eq!((p.view_up, p.view_angle), (DVec3::Z, 40.0));
    let p = best(
        "renderView1.InteractionMode = '2D'\nrenderView1.CameraPosition = [0.0, 0.0, 10.0]\n\
        renderView1.CameraParallelScale = 2.5\nrenderView1.CameraParallelProjection = 1\n",
    );
    let p = p.found.parameters;
    assert_eq!((p.projection, p.height, p.focal_point), (Projection::Parallel, 5.0, DVec3::ZERO));
    // OpenCV's YAML: K of a calibration, with its size.
    let yaml = "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n\
        \x20  data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n\
        \x20  dt: d\n   data: [ 0.1, 0.2, 0., 0., 0. ]\n";
    let k = best(yaml);
    assert_eq!((k.reading.kind, k.reading.image), (MatrixKind::Intrinsics, ImageSize { width: 640, height: 480 }));
    assert!((k.found.parameters.view_angle - 2.0 * 0.48_f64.atan().to_degrees()).abs() < 1e-9);
}

/// The depths of a product: F = 0.1 in −1 … 1, 0.1998 in 0 … 1. The short number is the one that someone typed.
#[test]
fn the_range_of_ndc_is_the_one_in_which_f_is_short() {
    let position = DVec3::new(4.0, 3.0, 5.0);
    let camera = Camera::new(&Parameters { position, near: 0.1, far: 50.0, ..Parameters::default() }).unwrap();
    for (ndc, name) in [(NDC[0], "opengl"), (NDC[1], "direct3d"), (NDC[4], "vulkan")] {
        let best = best(&text(projection(&camera, ndc) * camera.view_from_world(), false, true, Some(9)));
        assert_eq!((best.reading.kind, best.reading.ndc.name().as_str()), (MatrixKind::ViewProjection, name));
        assert!((best.found.parameters.near - 0.1).abs() < 1e-6, "{name}: {:?}", best.found.parameters);
    }
}

/// A word of the text decides if numbers can't: a level camera in a world whose y points down.
#[test]
fn words_of_the_text_decide() {
    let camera = camera_of([1.0, 2.0, 4.0]);
    // OpenCV, turned by half a turn about x: y points down in its world.
    let flip = DMat4::from_scale(DVec3::new(1.0, -1.0, -1.0));
    let view = flip * camera.view_from_world() * flip;
    let numbers = text(view, false, true, None);
    let of = |text: &str| {
        let best = best(text);
        (best.reading.kind, best.reading.axes.name, best.certainty)
    };
    assert_eq!(of(&format!("extrinsic\n{numbers}")), (MatrixKind::View, "opencv", Certainty::Only));
    assert_eq!(of(&format!("matrix_world = {numbers}")), (MatrixKind::CameraToWorld, "blender", Certainty::Only));
    assert_ne!(of(&numbers).2, Certainty::Only);
}

fn camera_of(position: [f64; 3]) -> Camera {
    Camera::new(&Parameters { position: DVec3::from_array(position), ..Parameters::default() }).unwrap()
}

#[test]
fn a_text_of_any_length_is_answered() {
    for text in
        ["a=".repeat(300_000), "[".repeat(300_000), "1 ".repeat(300_000), "x: 1\n".repeat(100_000), "\"".repeat(99_999)]
    {
        assert!(read_cameras(text.as_bytes()).is_err(), "{} characters", text.len());
    }
    assert!(read_cameras(b"glTF\x02\0\0\0\xff\xff").is_err());
    assert!(read_cameras(&[0xff, 0xfe, 0]).is_err());
}

/// glOrtho(−2, 2, −1.5, 1.5, −1, 1).
#[test]
fn a_parallel_volume_may_lie_around_the_eye() {
    let ortho = "0.5 0 0 0\n0 0.6666666666666666 0 0\n0 0 -1 0\n0 0 0 1";
    let pasted = &read_cameras(ortho.as_bytes()).unwrap()[0];
    let stated = Stated { kind: Some(MatrixKind::Projection), ..Stated::default() };
    let p = recognise(pasted, &stated, &Parameters::default()).unwrap().best().found.parameters;
    assert_eq!((p.projection, p.near, p.far), (Projection::Parallel, -1.0, 1.0));
    let camera = Camera::new(&p).unwrap();
    assert!(camera.clip_from_view().abs_diff_eq(DMat4::from_diagonal((0.5, 1.0 / 1.5, -1.0, 1.0).into()), 1e-12));
}

#[test]
fn an_implausible_lens_is_read_with_a_notice() {
    let notices = |text: &str, image: [u32; 2]| {
        let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
        let image = ImageSize { width: image[0], height: image[1] };
        recognise(pasted, &Stated { image, ..Stated::default() }, &Parameters::default())
            .unwrap()
            .best()
            .found
            .unknown
            .clone()
    };
    let corner = notices("30 0 30 0\n0 30 20 0\n0 0 1 0", [1280, 720]);
    assert!(corner.contains(&Unknown::PrincipalPoint) && corner.contains(&Unknown::WideAngle), "{corner:?}");
    assert!(notices("1500 0 960\n0 1500 540\n0 0 1", [1080, 1920]).contains(&Unknown::ImageTurned));
    assert!(notices("1.2 0 0.5\n0 1.6 0.5\n0 0 1", [800, 600]).contains(&Unknown::NormalisedPixels));
    let usual = notices("1500 0 960\n0 1500 540\n0 0 1", [1920, 1080]);
    assert!(!usual.contains(&Unknown::PrincipalPoint) && !usual.contains(&Unknown::ImageTurned), "{usual:?}");
}

/// Cameras along the axes, at 0 and at short places, with lenses of 1 and ½: their numbers fit much.
fn nasty() -> Vec<Camera> {
    let directions = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let places = [DVec3::ZERO, DVec3::ONE, DVec3::new(0.0, 0.0, 5.0), DVec3::splat(0.5)];
    let pairs = directions.into_iter().flat_map(|d| directions.map(|up| (d, up))).filter(|(d, up)| d.dot(*up) == 0.0);
    let camera = |(k, (direction, view_up)): (usize, (DVec3, DVec3))| {
        let position = places[k % 4];
        let (near, far) = [(1.0, 2.0), (0.5, 1.0), (1.0, 3.0)][k % 3];
        let [width, height] = [[1.0, 1.0], [2.0, 1.0], [0.5, 0.5]][k % 3].map(|side| side * near);
        let [left, bottom] = if k % 5 == 0 { [0.0, 0.0] } else { [-width, -height] };
        let window = Some(ViewWindow { left, right: width, bottom, top: height });
        let focal_point = position + direction;
        Camera::new(&Parameters { position, focal_point, view_up, near, far, window, ..Parameters::default() }).unwrap()
    };
    pairs.enumerate().map(camera).collect()
}

#[test]
fn no_camera_of_nasty_numbers_is_certain_and_wrong() {
    let mut count = 0;
    let mut check = |text: String, kind: MatrixKind, right: &Camera, side: u32| {
        count += 1;
        let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
        let stated = Stated { image: ImageSize { width: side, height: side }, ..Stated::default() };
        let Ok(found) = recognise(pasted, &stated, right.parameters()) else { return };
        let best = found.best();
        let is_right = best.reading.kind == kind && difference(best, right) < 1e-6;
        assert!(best.certainty != Certainty::Only || is_right, "certain and wrong: {best:#?}\n{text}");
    };
    for (k, right) in nasty().iter().enumerate() {
        let by_columns = k % 2 == 1;
        for program in programs() {
            let view = program.view(right);
            check(text(view, by_columns, k % 3 == 0, None), MatrixKind::View, right, 512);
            check(text(view.inverse(), by_columns, k % 3 == 0, None), MatrixKind::CameraToWorld, right, 512);
        }
        for ndc in NDC {
            let m_p = projection(right, ndc);
            check(text(m_p, by_columns, true, None), MatrixKind::Projection, right, 512);
            check(text(m_p * right.view_from_world(), by_columns, true, None), MatrixKind::ViewProjection, right, 512);
        }
        // K [R | t] of a few pixels, with c at 0, in a corner or in the middle.
        let r = DMat4::from_diagonal((1.0, -1.0, -1.0, 1.0).into()) * right.view_from_world();
        for (side, f, c) in [(2, 2.0, 0.5), (2, 1.0, 1.0), (100, 100.0, 0.0), (512, 512.0, 512.0), (512, 256.0, 256.0)]
        {
            let intrinsics = DMat3::from_cols(DVec3::X * f, DVec3::Y * f, DVec3::new(c, c, 1.0));
            let p = DMat4::from_mat3(intrinsics) * r;
            let rows = [0, 1, 2].map(|i| p.row(i).to_array().map(|x| format!("{x:?}")).join(" "));
            let pixels = Camera::new(&Parameters {
                window: Some(ViewWindow {
                    left: -c / f * right.near(),
                    right: (f64::from(side) - c) / f * right.near(),
                    bottom: (c - f64::from(side)) / f * right.near(),
                    top: c / f * right.near(),
                }),
                ..*right.parameters()
            });
            check(rows.join("\n"), MatrixKind::Pinhole, &pixels.unwrap(), side);
        }
    }
    assert!(count > 300, "{count}");
}
