//! A small scene and its camera, whose numbers can be worked out by hand.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::sync::Arc;

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, Rgba, Shading, Style};
use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use camera_lab_engine::pipeline::Target;
use camera_lab_engine::scene::{Mesh, Object, ObjectPaint, Scene};
use glam::{DMat4, DVec3};

pub(crate) const TARGET: Target = Target { width: 200, height: 100, scale: 2.0, background: Rgba::rgb(255, 255, 255) };
pub(crate) const CLAY: Rgba = Rgba::rgb(200, 100, 40);
pub(crate) const STROKE: LineStyle =
    LineStyle { color: CLAY, width: 1.5, dash: Dash::Solid, hidden: HiddenLines::Shown, arrow: true };

/// At the origin, looking along −z, window 4 × 2 on F = 1, B = 9.
pub(crate) fn eye(projection: Projection) -> Camera {
    let window = ViewWindow { left: -2.0, right: 2.0, bottom: -1.0, top: 1.0 };
    Camera::new(&Parameters {
        position: DVec3::ZERO,
        focal_point: DVec3::NEG_Z,
        projection,
        near: 1.0,
        far: 9.0,
        window: Some(window),
        ..Parameters::default()
    })
    .unwrap()
}

pub(crate) fn shading(shading: Shading) -> Style {
    Style { shading, ..Style::default() }
}

/// The cube [−1, 1]³, each face with vertices of its own, edges once.
pub(crate) fn cube() -> Mesh {
    let mut mesh = Mesh { closed: true, convex: true, ..Mesh::default() };
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = DVec3::AXES[axis] * sign;
            let (s, t) = (DVec3::AXES[(axis + 1) % 3], DVec3::AXES[(axis + 2) % 3] * sign);
            let first = u32::try_from(mesh.positions.len()).unwrap();
            mesh.positions.extend([normal - s - t, normal + s - t, normal + s + t, normal - s + t]);
            mesh.normals.extend([normal; 4]);
            mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
    // The faces of ±x and the four edges along x.
    mesh.edges = vec![[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    mesh
}

pub(crate) fn object(mesh: Mesh, world_from_object: DMat4) -> Object {
    Object {
        two_sided: !mesh.closed,
        ..Object::new("thing", Arc::new(mesh), world_from_object, ObjectPaint::Solid(CLAY))
    }
}

pub(crate) fn only(object: Object) -> Scene {
    Scene { objects: vec![object], ..Scene::default() }
}
