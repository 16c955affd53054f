//! Clipping: the clipped part of any triangles is in the volume, and all indices exist.

use std::sync::Arc;

use camera_lab::appearance::{Rgba, Shading};
use camera_lab::camera::{Camera, Parameters, Projection};
use camera_lab::pipeline::canonical::{clipped_scene, legible_clipped_scene};
use camera_lab::pipeline::clip_parts::clip_parts;
use camera_lab::scene::{Mesh, Object, ObjectPaint, Scene};
use glam::{DMat4, DVec3};

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Some((&choice, bytes)) = bytes.split_first() else { return };
    let mut numbers = bytes.chunks_exact(4).map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])));
    let mut vector = || Some(DVec3::new(numbers.next()?, numbers.next()?, numbers.next()?));
    let (Some(position), Some(focal_point), Some(planes)) = (vector(), vector(), vector()) else { return };
    let parameters = Parameters {
        position,
        focal_point,
        near: planes.x.abs(),
        far: planes.x.abs() + planes.y.abs(),
        view_angle: planes.z.abs() % 180.0,
        projection: if choice % 2 == 0 { Projection::Perspective } else { Projection::Parallel },
        ..Parameters::default()
    };
    let Ok(camera) = Camera::new(&parameters) else { return };
    let positions: Vec<DVec3> = std::iter::from_fn(vector).collect();
    let count = u32::try_from(positions.len()).expect("a short input");
    let triangles: Vec<[u32; 3]> = (2..count).map(|i| [i - 2, i - 1, i]).collect();
    let edges = (1..count).map(|i| [i - 1, i]).collect();
    let object = Object {
        lit: false,
        two_sided: true,
        ..Object::new(
            "m",
            Arc::new(Mesh { positions, triangles, edges, ..Mesh::default() }),
            DMat4::IDENTITY,
            ObjectPaint::Solid(Rgba::rgb(1, 2, 3)),
        )
    };
    let scene = Scene { objects: vec![object], ..Scene::default() };
    for clipped in [clipped_scene, legible_clipped_scene].map(|clip| clip(&scene, &camera, Shading::Flat)) {
        for mesh in clipped.objects.iter().map(|object| &object.mesh) {
            for p in &mesh.positions {
                assert!(p.is_finite() && p.abs().max_element() <= 1.0 + 1e-9, "{p}");
            }
            let indices = mesh.triangles.iter().flatten().chain(mesh.edges.iter().flatten());
            assert!(indices.into_iter().all(|&i| (i as usize) < mesh.positions.len()));
        }
    }
    let parts = clip_parts(&scene, &camera, false);
    for mesh in parts.inside.objects.iter().chain(&parts.outside.objects).map(|object| &object.mesh) {
        assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
    }
}
