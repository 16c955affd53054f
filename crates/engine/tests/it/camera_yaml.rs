//! YAML of `OpenCV`, ROS, Kalibr and `EuRoC`: K, the size of the image and C against their own numbers.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{
    Camera, ImageSize, MatrixKind, Parameters, Stated, camera_names, read_cameras, recognise,
};
use glam::DVec3;

/// The result: the kind, `f_x f_y c_x c_y` from the window, the size, C.
fn read(text: &str, at: usize) -> (MatrixKind, [f64; 4], [u32; 2], DVec3) {
    let cameras = read_cameras(text.as_bytes()).unwrap();
    let image = cameras[at].image.unwrap_or(ImageSize { width: 640, height: 480 });
    let stated = Stated { image, ..Stated::default() };
    let found = recognise(&cameras[at], &stated, &Parameters::default()).unwrap();
    let camera = Camera::new(&found.best().found.parameters).unwrap();
    let (w, near, [m, n]) = (camera.window(), camera.near(), [image.width, image.height].map(f64::from));
    let [width, height] = [w.right - w.left, w.top - w.bottom];
    let k = [near * m / width, near * n / height, -w.left * m / width, w.top * n / height];
    (found.best().reading.kind, k, [image.width, image.height], camera.position())
}

#[track_caller]
fn holds(text: &str, kind: MatrixKind, k: [f64; 4], size: [u32; 2], position: Option<[f64; 3]>) {
    let found = read(text, 0);
    assert_eq!((found.0, found.2), (kind, size));
    assert!(found.1.iter().zip(k).all(|(a, b)| (a - b).abs() < 1e-9 * b.abs().max(1.0)), "{:?}, not {k:?}", found.1);
    if let Some(position) = position {
        assert!(found.3.abs_diff_eq(DVec3::from_array(position), 1e-6), "{}", found.3);
    }
}

/// The head of the sample of `calibrateCamera`, in which twelve numbers of poses follow K.
const OPENCV: &str = "%YAML:1.0
---
calibration_time: \"Mon 02 Jan 2023 10:00:00\"
image_width: 800 # pixels
image_height: 600
square_size: 25.
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 5.3591573396163199e+02, 0., 3.9228315473308373e+02, 0.,
       5.3591573396163199e+02, 2.9557082909788173e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -2.6637260909660682e-01, -3.8588898922304653e-02, 1.7831947042852964e-03,
       -2.8122100441115472e-04, 2.3839153080878486e-01 ]
extrinsic_parameters: !!opencv-matrix
   rows: 2
   cols: 6
   dt: d
   data: [ 0.1, 0.2, 0.3, 1., 2., 10., 0.15, 0.25, 0.35, 1.1, 2.1, 11. ]
";

#[test]
fn a_calibration_of_opencv() {
    let f = 535.915_733_961_632;
    let k = [f, f, 392.28315473308373, 295.57082909788173];
    holds(OPENCV, MatrixKind::Intrinsics, k, [800, 600], None);
    holds(&OPENCV.replace('\n', "\r\n"), MatrixKind::Intrinsics, k, [800, 600], None);
}

#[test]
fn data_before_the_rows_and_one_number_a_line() {
    let flow = "camera_matrix:\n  data: [600.5, 0.0, 320.5, 0.0, 601.5, 240.5, 0.0, 0.0, 1.0]\n  cols: 3\n  rows: 3\n";
    let k = [600.5, 601.5, 320.5, 240.5];
    holds(&format!("{flow}image_height: 480\nimage_width: 640\n"), MatrixKind::Intrinsics, k, [640, 480], None);
    let lines = ["600.5", "0.0", "320.5", "0.0", "601.5", "240.5", "0.0", "0.0", "1.0"].map(|x| format!("  - {x}\n"));
    let block = format!("image_width: 640\nimage_height: 480\ncamera_matrix:\n  rows: 3\n  data:\n{}", lines.concat());
    holds(&block, MatrixKind::Intrinsics, k, [640, 480], None);
}

#[test]
fn camera_info_of_ros() {
    let info = "height: 480\nwidth: 640\nD: [0.1, -0.2, 0.0, 0.0, 0.0]\nK: [554.25, 0.0, 320.5, 0.0, 554.25, 240.5, 0.0, 0.0, 1.0]
R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
P: [554.25, 0.0, 320.5, -38.7975, 0.0, 554.25, 240.5, 0.0, 0.0, 0.0, 1.0, 0.0]\nbinning_x: 0\n---\n";
    let k = [554.25, 554.25, 320.5, 240.5];
    // C = (38.7975/554.25, 0, 0): the right camera of a pair.
    holds(info, MatrixKind::Pinhole, k, [640, 480], Some([0.07, 0.0, 0.0]));
    let file = info.replace("P: [", "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [");
    holds(&file, MatrixKind::Pinhole, k, [640, 480], Some([0.07, 0.0, 0.0]));
}

#[test]
fn the_second_camera_of_a_stereo_pair_of_opencv_stands_beside_the_first() {
    let matrix = |name: &str, numbers: &str| {
        format!("{name}: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ {numbers} ]\n")
    };
    let text = "%YAML:1.0\n---\n".to_owned()
        + &matrix("K1", "530., 0., 320., 0., 530., 240., 0., 0., 1.")
        + &matrix("K2", "535., 0., 325., 0., 535., 245., 0., 0., 1.")
        + &matrix("R", "1., 0., 0., 0., 1., 0., 0., 0., 1.")
        + &matrix("T", "-3.3, 0.03, 0.01");
    // C = −Rᵀ t, and the first camera is the origin of their world.
    holds(&text, MatrixKind::View, [530.0, 530.0, 320.0, 240.0], [640, 480], Some([0.0; 3]));
    let (_, k, _, position) = read(&text, 1);
    assert!(k.iter().zip([535.0, 535.0, 325.0, 245.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{k:?}");
    assert!(position.abs_diff_eq(DVec3::new(3.3, -0.03, -0.01), 1e-6), "{position}");
    let rectified = text
        + &matrix("P1", "421.5, 0., 336., 0., 0., 421.5, 243., 0., 0., 0., 1., 0.")
        + &matrix("P2", "421.5, 0., 336., -1405., 0., 421.5, 243., 0., 0., 0., 1., 0.");
    let names = camera_names(&read_cameras(rectified.as_bytes()).unwrap());
    assert_eq!(names, ["P1", "P2"]);
    assert!((read(&rectified, 1).3.x - 1405.0 / 421.5).abs() < 1e-9);
}

#[test]
fn kalibr_and_euroc() {
    let k = [458.654, 457.296, 367.215, 248.375];
    // R = (0 1 0; −1 0 0; 0 0 1), t = (0.1, 0.2, 0.3): C = −Rᵀ t = (0.2, −0.1, −0.3).
    let kalibr = "cam0:\n  camera_model: pinhole\n  intrinsics: [458.654, 457.296, 367.215, 248.375]\n  resolution: [752, 480]
  T_cam_imu:\n  - [0.0, 1.0, 0.0, 0.1]\n  - [-1.0, 0.0, 0.0, 0.2]\n  - [0.0, 0.0, 1.0, 0.3]\n  - [0.0, 0.0, 0.0, 1.0]\n";
    holds(kalibr, MatrixKind::View, k, [752, 480], Some([0.2, -0.1, -0.3]));
    // A word of a comment says nothing: T_BS leads out of the camera.
    let euroc = "# Sensor extrinsics wrt. the body-frame.\nT_BS:\n  cols: 4\n  rows: 4\n  data: [0.0, 1.0, 0.0, 0.1,
         -1.0, 0.0, 0.0, 0.2,\n        0.0, 0.0, 1.0, 0.3,\n         0.0, 0.0, 0.0, 1.0]
resolution: [752, 480]\nintrinsics: [458.654, 457.296, 367.215, 248.375] #fu, fv, cu, cv\n";
    holds(euroc, MatrixKind::CameraToWorld, k, [752, 480], Some([0.1, 0.2, 0.3]));
}

#[test]
fn rvec_and_tvec() {
    // A quarter of a turn about y: R = (0 0 1; 0 1 0; −1 0 0), so C = −Rᵀ t = (4, −0.25, −0.5).
    let text =
        "camera_matrix:\n  data: [500., 0., 320., 0., 500., 240., 0., 0., 1.]\nrvec: [0., 1.5707963267948966, 0.]
tvec: [0.5, 0.25, 4.]\n";
    holds(text, MatrixKind::View, [500.0, 500.0, 320.0, 240.0], [640, 480], Some([4.0, -0.25, -0.5]));
}
