//! YAML of other programs: `OpenCV`, `camera_info` of ROS, Kalibr and `EuRoC` by their keys.
//!
//! | keys | what |
//! | --- | --- |
//! | `camera_matrix`, `K`, `k`, `intrinsics` | K: nine numbers, or `f_x f_y c_x c_y` |
//! | `image_width`, `width`, `resolution` … | the size of the image |
//! | `R` and `T`, `rvec` and `tvec` | the pose, from the world to the camera |
//! | `projection_matrix`, `P`, `P1` … | K \[R \| t\] |
//! | `T_cam_imu`, `T_cn_cnm1`, `T_BS` | a pose: into the camera, and out of it |

use saphyr_parser::{Event, Parser};
use serde_json::{Map, Value};

use crate::camera::ImageSize;
use crate::camera::recovery::entries::MatrixEntries;
use crate::camera::recovery::text::json::written;
use crate::camera::recovery::text::{
    GivenLens, Pasted, VISION, image_size, is_intrinsics, list, number, of_rotation, rotation_of,
};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The depth of nesting that is read. No camera needs more.
const DEPTH: usize = 32;

/// The cameras of a text, if it is YAML with the keys of one of these programs.
pub(crate) fn cameras(text: &str) -> Option<Vec<Pasted>> {
    // `%YAML:1.0` of OpenCV is no directive of YAML.
    let text = text.trim_start();
    let body = if text.starts_with("%YAML:") { text.split_once('\n')?.1 } else { text };
    let document = document(body)?;
    let own = of_map(&document);
    if !own.is_empty() {
        return Some(own);
    }
    // Kalibr has a map for each camera: cam0, cam1 …
    let inner = document.as_object()?.iter().filter(|(_, value)| value.is_object());
    let found: Vec<Pasted> = inner.flat_map(|(name, value)| named(name, of_map(value))).collect();
    (!found.is_empty()).then_some(found)
}

fn named(name: &str, mut cameras: Vec<Pasted>) -> Vec<Pasted> {
    if let [camera] = cameras.as_mut_slice()
        && camera.name.is_empty()
    {
        name.clone_into(&mut camera.name);
    }
    cameras
}

/// The names of K \[R | t\], twelve numbers by rows in the axes of `OpenCV`.
const PROJECTIONS: [&str; 8] = ["projection_matrix", "P", "p", "P0", "P1", "P2", "P3", "Pr"];

/// The names of poses, sixteen numbers by rows in the same axes, and their kinds.
const POSES: [(&str, MatrixKind); 4] = [
    ("T_BS", MatrixKind::CameraToWorld),
    ("T_cam_imu", MatrixKind::View),
    ("T_cn_cnm1", MatrixKind::View),
    ("T_imu_cam", MatrixKind::CameraToWorld),
];

/// The cameras of a map: the matrices of a projection, else K with a pose or alone.
fn of_map(map: &Value) -> Vec<Pasted> {
    let (image, lens) = (image(map), lens(map));
    let camera = |name: &str, word: &'static str, kind: MatrixKind, numbers: Vec<f64>| {
        let in_line = if numbers.len() == 9 { 3 } else { 4 };
        let entries = MatrixEntries::new(numbers.into_iter().map(written).collect(), Some(in_line))?;
        Some(Pasted { image, ..Pasted::pose(name, entries, kind, Axes::OPENCV, (Order::Rows, word)) })
    };
    let projections = PROJECTIONS.into_iter().filter_map(|key| Some((key, matrix(map, &[key], 12)?)));
    // A projection of zeros stands for no rectification.
    let projections = projections.filter(|(_, p)| p.iter().any(|x| *x != 0.0));
    let mut found: Vec<Pasted> = projections.filter_map(|(key, p)| camera(key, key, MatrixKind::Pinhole, p)).collect();
    if let [only] = &mut found[..] {
        only.name.clear();
    }
    if !found.is_empty() {
        return found;
    }
    if let Some(entries) = rigid(map).filter(|_| lens.is_some() || map.get("rvec").is_some()) {
        return vec![Pasted { lens, image, word: Some(VISION), ..Pasted::new("", entries) }];
    }
    let mut poses = POSES.into_iter().filter_map(|(key, kind)| camera("", key, kind, matrix(map, &[key], 16)?));
    if let Some(pose) = poses.next().filter(|_| lens.is_some()) {
        return vec![Pasted { lens, ..pose }];
    }
    let alone = matrix(map, &INTRINSICS, 9).filter(|k| is_intrinsics(k));
    if let Some(alone) = alone.and_then(|k| camera("", "camera_matrix", MatrixKind::Intrinsics, k)) {
        return vec![alone];
    }
    lens.map(|lens| Pasted::lens("", lens, image)).into_iter().collect()
}

/// The names of K. With two cameras, R and T lead to the second one.
const INTRINSICS: [&str; 8] = ["camera_matrix", "K", "k", "K2", "M2", "cameraMatrix2", "intrinsic_matrix", "K1"];

/// K, or `f_x f_y c_x c_y` of Kalibr and `EuRoC`.
fn lens(map: &Value) -> Option<GivenLens> {
    if let Some(k) = matrix(map, &INTRINSICS, 9).filter(|k| is_intrinsics(k)) {
        return Some(GivenLens::of_k(&k));
    }
    match matrix(map, &["intrinsics"], 4)?.as_slice() {
        [f_x, f_y, x, y] => Some(GivenLens::pixels([*f_x, *f_y], [*x, *y])),
        _ => None,
    }
}

/// R and T, or rvec and tvec.
fn rigid(map: &Value) -> Option<MatrixEntries> {
    let vector = |keys: &[&str]| matrix(map, keys, 3);
    let r = matrix(map, &["R", "rotation", "rotation_matrix"], 9)
        .or_else(|| vector(&["rvec", "R", "rotation_vector"]).map(|rvec| rotation_of(&rvec)))?;
    let t = vector(&["T", "t", "tvec", "translation", "translation_vector"])?;
    Some(of_rotation(&r, &t))
}

/// The numbers under one of some keys: a list, or the `data` of a matrix.
fn matrix(map: &Value, keys: &[&str], count: usize) -> Option<Vec<f64>> {
    let of = |key: &&str| {
        let value = map.get(*key)?;
        list(value.get("data").unwrap_or(value)).filter(|numbers| numbers.len() == count)
    };
    keys.iter().find_map(of)
}

fn image(map: &Value) -> Option<ImageSize> {
    let of = |keys: [&str; 2]| keys.into_iter().find_map(|key| map.get(key).and_then(number));
    let pair = |key: &str| match matrix(map, &[key], 2)?.as_slice() {
        [width, height] => image_size(*width, *height),
        _ => None,
    };
    let sides = of(["image_width", "width"]).zip(of(["image_height", "height"]));
    let sides = sides.and_then(|(width, height)| image_size(width, height));
    sides.or_else(|| ["resolution", "image_size", "imageSize"].into_iter().find_map(pair))
}

/// The first document, if it is a map.
fn document(text: &str) -> Option<Value> {
    /// A list or a map that isn't closed yet, with the key that waits for its value.
    enum Open {
        List(Vec<Value>),
        Map(Map<String, Value>, Option<String>),
    }
    let mut open: Vec<Open> = Vec::new();
    for event in Parser::new_from_str(text) {
        let done = match event.ok()?.0 {
            Event::Scalar(text, ..) => scalar(&text),
            Event::SequenceStart(..) if open.len() < DEPTH => {
                open.push(Open::List(Vec::new()));
                continue;
            }
            Event::MappingStart(..) if open.len() < DEPTH => {
                open.push(Open::Map(Map::new(), None));
                continue;
            }
            Event::SequenceEnd | Event::MappingEnd => match open.pop()? {
                Open::List(items) => Value::Array(items),
                Open::Map(map, _) => Value::Object(map),
            },
            Event::Alias(_) => Value::Null,
            Event::SequenceStart(..) | Event::MappingStart(..) => return None,
            Event::Nothing | Event::StreamStart | Event::StreamEnd | Event::DocumentStart(_) | Event::DocumentEnd => {
                continue;
            }
        };
        match open.last_mut() {
            Some(Open::List(items)) => items.push(done),
            Some(Open::Map(map, key)) => match key.take() {
                Some(key) => drop(map.insert(key, done)),
                None => *key = Some(done.as_str().map_or_else(|| done.to_string(), str::to_owned)),
            },
            None => return Some(done).filter(Value::is_object),
        }
    }
    None
}

/// A number if it is one: `1.` and `.nan` too.
fn scalar(text: &str) -> Value {
    let is_nan = matches!(text, ".nan" | ".NaN" | ".NAN" | ".Nan");
    match text.parse::<f64>() {
        _ if is_nan => Value::Null,
        Ok(number) if text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) => number.into(),
        _ => Value::String(text.to_owned()),
    }
}
