//! JSON of other programs: `Open3D`, nerfstudio, glTF and three.js by their keys, others as numbers under names.

use glam::DMat4;
use serde_json::Value;

use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::text::numbers::Segment;
use crate::camera::recovery::text::{GivenLens, MatrixTextError, Pasted, gltf, image_size, list, number, of_segments};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The cameras of a JSON text.
///
/// # Errors
/// [`MatrixTextError`] if there is none.
pub(crate) fn cameras(value: &Value, text: &str) -> Result<Vec<Pasted>, MatrixTextError> {
    if let Some(frames) = value.get("frames").and_then(Value::as_array) {
        let found: Vec<Pasted> = frames.iter().filter_map(|frame| nerfstudio(value, frame)).collect();
        if !found.is_empty() {
            return Ok(found);
        }
    }
    if value.get("asset").is_some() || value.get("nodes").is_some_and(Value::is_array) {
        return gltf::cameras(value);
    }
    if let Some(camera) = gltf::of_part(value) {
        return Ok(vec![camera]);
    }
    if let Some(parameters) = value.get("parameters").and_then(Value::as_array) {
        let found: Vec<Pasted> = parameters.iter().filter_map(open3d).collect();
        if !found.is_empty() {
            return Ok(found);
        }
    }
    if let Some(camera) = open3d(value) {
        return Ok(vec![camera]);
    }
    let mut found = Vec::new();
    three_js(value.get("object").unwrap_or(value), DMat4::IDENTITY, &mut found);
    if !found.is_empty() {
        return Ok(found);
    }
    let mut segments = Vec::new();
    flatten("", value, &mut segments);
    of_segments(segments, text)
}

fn entries(value: &Value) -> Option<MatrixEntries> {
    let in_line = value.as_array()?.first()?.as_array().map(Vec::len);
    MatrixEntries::new(list(value)?.into_iter().map(written).collect(), in_line)
}

/// All digits of a number of JSON are there, or those of an `f32`.
pub(crate) fn written(value: f64) -> Written {
    let digits = format!("{}", value.abs()).chars().filter(char::is_ascii_digit).count();
    Written { value, error: if digits > 7 { 6e-8 * value.abs() } else { 0.0 } }
}

/// A `PinholeCameraParameters` of `Open3D`: Eigen writes matrices by columns.
fn open3d(value: &Value) -> Option<Pasted> {
    let pose = entries(value.get("extrinsic")?)?;
    let intrinsic = value.get("intrinsic")?;
    let k = list(intrinsic.get("intrinsic_matrix")?)?;
    let [f_x, _, _, _, f_y, _, x, y, _] = k.as_slice() else { return None };
    let side = |key: &str| intrinsic.get(key).and_then(number);
    Some(Pasted {
        lens: Some(GivenLens::pixels([*f_x, *f_y], [*x, *y])),
        image: side("width").zip(side("height")).and_then(|(width, height)| image_size(width, height)),
        ..Pasted::pose("", pose, MatrixKind::View, Axes::OPENCV, (Order::Columns, "extrinsic"))
    })
}

/// A frame of `transforms.json`: its own lens, or that of all frames.
///
/// <https://docs.nerf.studio/quickstart/data_conventions.html>: the camera of OpenGL, z up in the world.
fn nerfstudio(whole: &Value, frame: &Value) -> Option<Pasted> {
    let pose = entries(frame.get("transform_matrix")?)?;
    let value = |key: &str| frame.get(key).or(whole.get(key)).and_then(number);
    let image = value("w").zip(value("h"));
    let lens = match (value("fl_x"), value("camera_angle_x"), image) {
        (Some(f_x), _, _) => {
            let middle = |side: Option<f64>| side.map(|side| side / 2.0);
            let x = value("cx").or(middle(value("w")))?;
            let y = value("cy").or(middle(value("h")))?;
            Some(GivenLens::pixels([f_x, value("fl_y").unwrap_or(f_x)], [x, y]))
        }
        (None, Some(angle), _) => Some(GivenLens::AngleX(angle)),
        _ => None,
    };
    let image = image.and_then(|(width, height)| image_size(width, height));
    let name = frame.get("file_path").and_then(Value::as_str).unwrap_or_default();
    let said = (Order::Rows, "transform_matrix");
    Some(Pasted { lens, image, ..Pasted::pose(name, pose, MatrixKind::CameraToWorld, Axes::BLENDER, said) })
}

/// The cameras of an object of three.js and of its children.
fn three_js(object: &Value, parent: DMat4, found: &mut Vec<Pasted>) {
    let own = object.get("matrix").and_then(list).and_then(|m| <[f64; 16]>::try_from(m).ok());
    let world_from_object = parent * own.map_or(DMat4::IDENTITY, |m| DMat4::from_cols_array(&m));
    let value = |key: &str| object.get(key).and_then(number);
    let zoom = value("zoom").unwrap_or(1.0);
    let lens = match object.get("type").and_then(Value::as_str) {
        Some("PerspectiveCamera") => value("fov").map(|fov| GivenLens::AngleY {
            degrees: 2.0 * ((fov.to_radians() / 2.0).tan() / zoom).atan().to_degrees(),
            aspect: value("aspect"),
            near: value("near"),
            far: value("far"),
        }),
        Some("OrthographicCamera") => {
            let sides = ["left", "right", "bottom", "top", "near", "far"].map(value);
            let [Some(left), Some(right), Some(bottom), Some(top), Some(near), Some(far)] = sides else { return };
            let height = (top - bottom) / zoom;
            let aspect = Some((right - left) / (top - bottom));
            Some(GivenLens::Parallel { height, aspect, planes: Some([near, far]) })
        }
        _ => None,
    };
    if lens.is_some() {
        let name = object.get("name").and_then(Value::as_str).unwrap_or_default();
        let entries = MatrixEntries::of_matrix(world_from_object, 0.0);
        let pose = Pasted::pose(name, entries, MatrixKind::CameraToWorld, Axes::OPENGL, (Order::Rows, "three.js"));
        found.push(Pasted { lens, ..pose });
    }
    // serde_json has limited the depth.
    for child in object.get("children").and_then(Value::as_array).into_iter().flatten() {
        three_js(child, world_from_object, found);
    }
}

/// Numbers under names. An object of numbers, such as `{"0": 1, "1": 0 …}` and `{"x": …}`, is a list.
fn flatten(name: &str, value: &Value, into: &mut Vec<Segment>) {
    let segment = |numbers: Vec<f64>, in_line: Option<usize>| {
        let lines = in_line.map_or_else(Vec::new, |in_line| vec![in_line; numbers.len() / in_line.max(1)]);
        Segment { name: name.to_owned(), numbers: numbers.into_iter().map(written).collect(), lines }
    };
    match value {
        Value::Array(items) => match list(value) {
            Some(numbers) => into.push(segment(numbers, items.first().and_then(Value::as_array).map(Vec::len))),
            None => items.iter().for_each(|item| flatten(name, item, into)),
        },
        Value::Object(map) => {
            let numbers: Option<Vec<f64>> = map.values().map(number).collect();
            match numbers {
                Some(numbers) if matches!(numbers.len(), 3 | 4 | 7 | 9 | 12 | 16) => into.push(segment(numbers, None)),
                _ => {
                    for (key, value) in map {
                        let name = if matches!(key.as_str(), "elements" | "data" | "value") { name } else { key };
                        flatten(name, value, into);
                    }
                }
            }
        }
        Value::Number(_) => into.extend(number(value).map(|number| segment(vec![number], None))),
        _ => {}
    }
}
