//! The cameras of glTF: each node that has one, in the world of its scene.
//!
//! The values are read from the JSON itself, in `f64`. The `gltf` crate would round them to `f32`.

use glam::{DMat4, DQuat, DVec3};
use serde_json::Value;

use crate::camera::recovery::entries::MatrixEntries;
use crate::camera::recovery::text::{GivenLens, MatrixTextError, Pasted, list, number};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The most steps from the roots of a scene. More are a cycle, or made to take all the time there is.
const MAX_STEPS: usize = 100_000;

/// The cameras of a GLB file.
///
/// # Errors
/// [`MatrixTextError::NoCamera`].
pub(crate) fn of_glb(bytes: &[u8]) -> Result<Vec<Pasted>, MatrixTextError> {
    // A header of 12 bytes, then the first chunk: its length, its kind, its JSON. What follows has no cameras.
    let json = || {
        let length = u32::from_le_bytes(bytes.get(12..16)?.try_into().ok()?);
        let rest = bytes.get(16..)?.strip_prefix(b"JSON")?;
        serde_json::from_slice(rest.get(..usize::try_from(length).ok()?)?).ok()
    };
    cameras(&json().ok_or(MatrixTextError::NoCamera("GLB"))?)
}

/// The cameras of a glTF file.
///
/// # Errors
/// [`MatrixTextError::NoCamera`].
pub(crate) fn cameras(file: &Value) -> Result<Vec<Pasted>, MatrixTextError> {
    let array = |key: &str| file.get(key).and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let (nodes, lenses) = (array("nodes"), array("cameras"));
    let children = |node: &Value| -> Vec<usize> {
        let list = node.get("children").and_then(Value::as_array);
        list.into_iter().flatten().filter_map(index).filter(|child| *child < nodes.len()).collect()
    };
    let mut is_inner = vec![false; nodes.len()];
    nodes.iter().flat_map(children).for_each(|child| is_inner[child] = true);
    let roots = (0..nodes.len()).rev().filter(|node| !is_inner[*node]);
    let mut waiting: Vec<(usize, DMat4)> = roots.map(|node| (node, DMat4::IDENTITY)).collect();
    let mut found = Vec::new();
    for _ in 0..MAX_STEPS {
        let Some((at, parent)) = waiting.pop() else { break };
        let node = &nodes[at];
        let world_from_node = parent * transform(node);
        if let Some(camera) = node.get("camera").and_then(index).and_then(|at| lenses.get(at)) {
            let name = [camera, node].iter().find_map(|thing| thing.get("name")?.as_str()).unwrap_or_default();
            let entries = MatrixEntries::of_matrix(world_from_node, 0.0);
            let pose = Pasted::pose(name, entries, MatrixKind::CameraToWorld, Axes::OPENGL, (Order::Rows, "glTF"));
            found.push(Pasted { lens: lens(camera), ..pose });
        }
        waiting.extend(children(node).into_iter().rev().map(|child| (child, world_from_node)));
    }
    if found.is_empty() { Err(MatrixTextError::NoCamera("glTF")) } else { Ok(found) }
}

/// A node or a camera that was cut out of a file.
pub(crate) fn of_part(value: &Value) -> Option<Pasted> {
    let is_list = |key: &str, length: usize| value.get(key).and_then(list).is_some_and(|list| list.len() == length);
    if is_list("rotation", 4) && is_list("translation", 3) {
        let entries = MatrixEntries::of_matrix(transform(value), 0.0);
        return Some(Pasted::pose("", entries, MatrixKind::CameraToWorld, Axes::OPENGL, (Order::Rows, "rotation")));
    }
    Some(Pasted::lens("", lens(value)?, None))
}

fn index(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}

/// A node's matrix, or T R S.
fn transform(node: &Value) -> DMat4 {
    if let Some(Ok(matrix)) = node.get("matrix").and_then(list).map(<[f64; 16]>::try_from) {
        return DMat4::from_cols_array(&matrix);
    }
    let three = |key: &str, default: f64| match node.get(key).and_then(list).as_deref() {
        Some([x, y, z]) => DVec3::new(*x, *y, *z),
        _ => DVec3::splat(default),
    };
    let rotation = match node.get("rotation").and_then(list).as_deref() {
        Some([x, y, z, w]) => DQuat::from_xyzw(*x, *y, *z, *w).normalize(),
        _ => DQuat::IDENTITY,
    };
    DMat4::from_scale_rotation_translation(three("scale", 1.0), rotation, three("translation", 0.0))
}

fn lens(camera: &Value) -> Option<GivenLens> {
    if let Some(lens) = camera.get("perspective") {
        let value = |key: &str| lens.get(key).and_then(number);
        return Some(GivenLens::AngleY {
            degrees: value("yfov")?.to_degrees(),
            aspect: value("aspectRatio"),
            near: value("znear"),
            far: value("zfar"),
        });
    }
    let lens = camera.get("orthographic")?;
    let value = |key: &str| lens.get(key).and_then(number);
    let (across, up) = (value("xmag")?, value("ymag")?);
    Some(GivenLens::Parallel {
        height: 2.0 * up,
        aspect: Some(across / up),
        planes: Some([value("znear")?, value("zfar")?]),
    })
}
