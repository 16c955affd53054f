//! The camera for programs with axes of their own: their rows of the table of axes, written as code or as their files.

use std::fmt::Write as _;

use glam::{DMat3, DMat4, DQuat, DVec3};
use serde_json::json;

use super::{CodeTarget, list, pose, sides};
use crate::camera::{Axes, Camera, ImageSize, Program, Projection};
use crate::numbers::exact;

/// The middle of the window over its height.
fn shift(camera: &Camera) -> [f64; 2] {
    let [left, right, bottom, top] = sides(camera);
    [(left + right) / 2.0, (bottom + top) / 2.0].map(|x| x / camera.window_height())
}

fn rows(m: DMat4) -> Vec<Vec<f64>> {
    (0..4).map(|i| m.row(i).to_array().map(|x| x + 0.0).to_vec()).collect()
}

/// R as rows of Python, and t.
fn rotation_and_translation(m: DMat4) -> ([String; 3], String) {
    ([0, 1, 2].map(|i| list(m.row(i).truncate().to_array())), list(m.col(3).truncate().to_array()))
}

fn floats(v: DVec3) -> String {
    v.to_array().map(|x| format!("{}f", exact(x + 0.0))).join(", ")
}

pub(super) fn open_cv(camera: &Camera, image: ImageSize) -> String {
    let [f_x, f_y, x, y] = camera.intrinsics(image).map(|x| exact(x + 0.0));
    let (r, t) = rotation_and_translation(Axes::OPENCV.view_from_world(camera));
    let ImageSize { width, height } = image;
    format!(
        "import numpy as np\n\nsize = ({width}, {height})\nK = np.array([[{f_x}, 0, {x}], [0, {f_y}, {y}], [0, 0, 1]])\nR = np.array([[{}], [{}], [{}]])\nt = np.array([{t}])\nP = K @ np.c_[R, t]\n",
        r[0], r[1], r[2]
    )
}

pub(super) fn open3d(camera: &Camera, image: ImageSize) -> String {
    let [f_x, f_y, x, y] = camera.intrinsics(image).map(|x| x + 0.0);
    let by_columns = Axes::OPENCV.view_from_world(camera).to_cols_array().map(|x| x + 0.0);
    file(&json!({
        "class_name": "PinholeCameraParameters",
        "extrinsic": by_columns,
        "intrinsic": {
            "height": image.height,
            "intrinsic_matrix": [f_x, 0.0, 0.0, 0.0, f_y, 0.0, x, y, 1.0],
            "width": image.width,
        },
        "version_major": 1,
        "version_minor": 0,
    }))
}

pub(super) fn colmap(camera: &Camera, image: ImageSize) -> String {
    let m = Axes::OPENCV.view_from_world(camera);
    let turn = DQuat::from_mat3(&DMat3::from_mat4(m)).normalize();
    let quaternion = [turn.w, turn.x, turn.y, turn.z];
    let spaced = |values: &[f64]| values.iter().map(|x| exact(x + 0.0)).collect::<Vec<_>>().join(" ");
    format!(
        "# cameras.txt\n1 PINHOLE {} {} {}\n# images.txt\n1 {} {} 1 image.png\n\n",
        image.width,
        image.height,
        spaced(&camera.intrinsics(image)),
        spaced(&quaternion),
        spaced(&m.col(3).truncate().to_array())
    )
}

pub(super) fn nerfstudio(camera: &Camera, image: ImageSize) -> String {
    let [f_x, f_y, x, y] = camera.intrinsics(image).map(|x| x + 0.0);
    let world_from_camera = rows(Axes::BLENDER.world_from_view(camera));
    file(&json!({
        "camera_model": "OPENCV",
        "w": image.width,
        "h": image.height,
        "fl_x": f_x,
        "fl_y": f_y,
        "cx": x,
        "cy": y,
        "frames": [{ "file_path": "image.png", "transform_matrix": world_from_camera }],
    }))
}

pub(super) fn gltf(camera: &Camera) -> String {
    let (near, far) = (camera.near(), camera.far());
    let lens = match camera.projection() {
        Projection::Perspective => json!({
            "type": "perspective",
            "perspective": {
                "yfov": camera.view_angle().radians(),
                "aspectRatio": camera.window_aspect(),
                "znear": near,
                "zfar": far,
            },
        }),
        Projection::Parallel => json!({
            "type": "orthographic",
            "orthographic": {
                "xmag": camera.window_width() / 2.0,
                "ymag": camera.window_height() / 2.0,
                "znear": near,
                "zfar": far,
            },
        }),
    };
    file(&json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{
            "name": "camera",
            "camera": 0,
            "matrix": Axes::OPENGL.world_from_view(camera).to_cols_array().map(|x| x + 0.0),
        }],
        "cameras": [lens],
    }))
}

/// A file of JSON. It has no comments.
fn file(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}

/// The height of the sensor and the focal length in mm, and the shape of the pixels; `None` if one is beyond its range.
/// The sensor is 24 mm high if the focal length fits.
pub(super) fn blender_lens(camera: &Camera, image: ImageSize) -> Option<[f64; 4]> {
    const LENS: [f64; 2] = [1.0, 5000.0];
    let focal_lengths = camera.near() / camera.window_height();
    let lens = (24.0 * focal_lengths).clamp(LENS[0], LENS[1]);
    let sensor = if lens == 24.0 * focal_lengths { 24.0 } else { lens / focal_lengths };
    let wide = camera.window_aspect() * f64::from(image.height) / f64::from(image.width);
    // The same shape but for rounding.
    let wide = if (wide - 1.0).abs() < 1e-12 { 1.0 } else { wide };
    let pixel = [wide.max(1.0), wide.recip().max(1.0)];
    let is_parallel = camera.projection() == Projection::Parallel;
    let is_possible =
        (is_parallel || (sensor >= 1.0 && sensor <= f64::from(f32::MAX))) && pixel[0].max(pixel[1]) <= 200.0;
    is_possible.then_some([sensor, lens, pixel[0], pixel[1]])
}

pub(super) fn blender(camera: &Camera, image: ImageSize) -> String {
    let m = Axes::BLENDER.world_from_view(camera);
    let matrix: Vec<String> = (0..4).map(|i| format!("({})", list(m.row(i).to_array()))).collect();
    let [x, y] = shift(camera).map(|x| exact(x + 0.0));
    // Of a camera that it can't have, any numbers.
    let [sensor, lens, pixel_x, pixel_y] = blender_lens(camera, image).unwrap_or([1.0; 4]);
    let mut text = format!(
        "import bpy\nfrom mathutils import Matrix\n\nscene = bpy.context.scene\ncamera = scene.camera\ncamera.matrix_world = Matrix(({}))\ncamera.data.sensor_fit = 'VERTICAL'\n",
        matrix.join(", ")
    );
    let _ = match camera.projection() {
        Projection::Perspective => writeln!(
            text,
            "camera.data.type = 'PERSP'\ncamera.data.sensor_height = {sensor}\ncamera.data.lens = {}",
            exact(lens)
        ),
        Projection::Parallel => {
            writeln!(text, "camera.data.type = 'ORTHO'\ncamera.data.ortho_scale = {}", exact(camera.window_height()))
        }
    };
    let (near, far) = (exact(camera.near()), exact(camera.far()));
    let ImageSize { width, height } = image;
    // Writing to a String can't fail.
    let _ = writeln!(
        text,
        "camera.data.shift_x, camera.data.shift_y = {x}, {y}\ncamera.data.clip_start, camera.data.clip_end = {near}, {far}\nscene.render.resolution_x, scene.render.resolution_y = {width}, {height}"
    );
    if pixel_x != pixel_y {
        let (x, y) = (exact(pixel_x), exact(pixel_y));
        let _ = writeln!(text, "scene.render.pixel_aspect_x, scene.render.pixel_aspect_y = {x}, {y}");
    }
    text
}

pub(super) fn unity(camera: &Camera) -> String {
    let axes = Axes::DIRECT3D;
    let [eye, forward, up] = [camera.position(), camera.direction_of_projection(), camera.basis().v]
        .map(|v| floats(axes.foreign_from_world(v)));
    let float = |x: f64| format!("{}f", exact(x + 0.0));
    let (near, far) = (float(camera.near()), float(camera.far()));
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => format!(
            "camera.orthographic = false;\ncamera.fieldOfView = {};\ncamera.aspect = {};\n",
            float(camera.view_angle().degrees()),
            float(camera.window_aspect())
        ),
        (Projection::Parallel, true) => format!(
            "camera.orthographic = true;\ncamera.orthographicSize = {};\ncamera.aspect = {};\n",
            float(camera.window_height() / 2.0),
            float(camera.window_aspect())
        ),
        (projection, false) => {
            let call = if projection == Projection::Perspective { "Frustum" } else { "Ortho" };
            let [left, right, bottom, top] = sides(camera).map(float);
            format!("camera.projectionMatrix = Matrix4x4.{call}({left}, {right}, {bottom}, {top}, {near}, {far});\n")
        }
    };
    format!(
        "camera.transform.SetPositionAndRotation(\n    new Vector3({eye}),\n    Quaternion.LookRotation(new Vector3({forward}), new Vector3({up})));\ncamera.nearClipPlane = {near};\ncamera.farClipPlane = {far};\n{lens}"
    )
}

pub(super) fn pytorch3d(camera: &Camera, image: ImageSize) -> String {
    // Row vectors: X R + T.
    let m = Axes::PYTORCH3D.view_from_world(camera);
    let r = [0, 1, 2].map(|i| list(m.col(i).truncate().to_array()));
    let t = list(m.col(3).truncate().to_array());
    let ImageSize { width, height } = image;
    let [f_x, f_y, x, y] = camera.intrinsics(image).map(|x| exact(x + 0.0));
    let class = match camera.projection() {
        Projection::Perspective => "PerspectiveCameras",
        Projection::Parallel => "OrthographicCameras",
    };
    format!(
        "import torch\nfrom pytorch3d.renderer import {class}\n\nR = torch.tensor([[[{}], [{}], [{}]]])\nT = torch.tensor([[{t}]])\ncameras = {class}(\n    R=R, T=T, focal_length=(({f_x}, {f_y}),), principal_point=(({x}, {y}),),\n    image_size=(({height}, {width}),), in_ndc=False)\n",
        r[0], r[1], r[2]
    )
}

pub(super) fn godot(camera: &Camera) -> String {
    let m = Axes::OPENGL.world_from_view(camera);
    let columns = [0, 1, 2, 3].map(|i| format!("Vector3({})", list(m.col(i).truncate().to_array())));
    let (near, far) = (exact(camera.near()), exact(camera.far()));
    let height = exact(camera.window_height());
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => {
            format!("camera.set_perspective({}, {near}, {far})\n", exact(camera.view_angle().degrees()))
        }
        (Projection::Perspective, false) => {
            let offset = list(shift(camera).map(|x| x * camera.window_height()));
            format!("camera.set_frustum({height}, Vector2({offset}), {near}, {far})\n")
        }
        (Projection::Parallel, _) => format!("camera.set_orthogonal({height}, {near}, {far})\n"),
    };
    format!(
        "camera.global_transform = Transform3D(\n\tBasis({}, {}, {}),\n\t{})\n{lens}",
        columns[0], columns[1], columns[2], columns[3]
    )
}

pub(super) fn babylon(camera: &Camera) -> String {
    let axes = Axes::DIRECT3D;
    let [eye, target, up] = [camera.position(), camera.focal_point(), camera.view_up()]
        .map(|v| format!("new BABYLON.Vector3({})", list(axes.foreign_from_world(v).to_array())));
    let lens = match camera.projection() {
        Projection::Perspective => format!("camera.fov = {};\n", exact(camera.view_angle().radians())),
        Projection::Parallel => {
            let [left, right, bottom, top] = sides(camera).map(|x| exact(x + 0.0));
            format!(
                "camera.mode = BABYLON.Camera.ORTHOGRAPHIC_CAMERA;\ncamera.orthoLeft = {left};\ncamera.orthoRight = {right};\ncamera.orthoBottom = {bottom};\ncamera.orthoTop = {top};\n"
            )
        }
    };
    format!(
        "const camera = new BABYLON.FreeCamera(\"camera\", {eye}, scene);\ncamera.upVector = {up};\ncamera.setTarget({target});\ncamera.minZ = {};\ncamera.maxZ = {};\n{lens}",
        exact(camera.near()),
        exact(camera.far())
    )
}

pub(super) fn bevy(camera: &Camera) -> String {
    let [eye, target, up] = pose(camera);
    let (near, far) = (exact(camera.near()), exact(camera.far()));
    let lens = match camera.projection() {
        Projection::Perspective => format!(
            "Projection::Perspective(PerspectiveProjection {{\n        fov: {},\n        aspect_ratio: {},\n        near: {near},\n        far: {far},\n        ..default()\n    }})",
            exact(camera.view_angle().radians()),
            exact(camera.window_aspect())
        ),
        Projection::Parallel => format!(
            "Projection::Orthographic(OrthographicProjection {{\n        near: {near},\n        far: {far},\n        scaling_mode: ScalingMode::Fixed {{ width: {}, height: {} }},\n        ..OrthographicProjection::default_3d()\n    }})",
            exact(camera.window_width()),
            exact(camera.window_height())
        ),
    };
    format!(
        "commands.spawn((\n    Camera3d::default(),\n    {lens},\n    Transform::from_xyz({eye}).looking_at(Vec3::new({target}), Vec3::new({up})),\n));\n"
    )
}

pub(super) fn unreal(camera: &Camera) -> String {
    let Program { axes, units, .. } = *CodeTarget::Unreal.program();
    let vector = |v: DVec3| format!("FVector({})", list(axes.foreign_from_world(v).to_array()));
    let eye = vector(units * camera.position());
    let [forward, up] = [camera.direction_of_projection(), camera.basis().v].map(vector);
    let centimetres = |x: f64| exact(units * x);
    let lens = match camera.projection() {
        Projection::Perspective => {
            let angle = 2.0 * (camera.window_width() / 2.0).atan2(camera.near()).to_degrees();
            format!("Component->SetFieldOfView({});\n", exact(angle))
        }
        Projection::Parallel => format!(
            "Component->SetProjectionMode(ECameraProjectionMode::Orthographic);\nComponent->SetOrthoWidth({});\nComponent->SetOrthoNearClipPlane({});\nComponent->SetOrthoFarClipPlane({});\n",
            centimetres(camera.window_width()),
            centimetres(camera.near()),
            centimetres(camera.far())
        ),
    };
    format!(
        "Camera->SetActorLocationAndRotation(\n    {eye},\n    FRotationMatrix::MakeFromXZ({forward}, {up}).Rotator());\nUCameraComponent* Component = Camera->GetCameraComponent();\nComponent->SetAspectRatio({});\n{lens}",
        exact(camera.window_aspect())
    )
}
