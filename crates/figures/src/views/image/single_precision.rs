//! The image of a pipeline in single precision (`[reveal] single_precision`), with numbers in `f32` where a program for
//! graphics cards has them, up to view space. The later stages lose little more.

use std::sync::Arc;

use glam::DVec3;

use crate::camera::Camera;
use crate::scene::{Mesh, Object, Scene};
use crate::views::{Request, SharedScene};

/// The same request with the points where single precision puts them; `None` if the figure doesn't ask for it.
pub(super) fn in_single(request: &Request) -> Option<Request> {
    if !request.shot.look.reveal.single_precision {
        return None;
    }
    let mut scene = Scene::clone(&request.scene);
    for object in &mut scene.objects {
        round(object, &request.camera);
    }
    let place = |p: &mut DVec3| *p = seen(*p, &request.camera);
    scene.lines.iter_mut().flat_map(|line| &mut line.points).for_each(place);
    scene.marks.iter_mut().for_each(|mark| place(&mut mark.position));
    Some(Request { scene: SharedScene::new(scene), ..request.clone() })
}

/// Moves the vertices of an object to where single precision sees them.
fn round(object: &mut Object, camera: &Camera) {
    let to_world = object.world_from_object.as_mat4();
    let object_from_world = object.world_from_object.inverse();
    if !object_from_world.is_finite() {
        return;
    }
    let place = |p: &DVec3| {
        let world = to_world.transform_point3(p.as_vec3());
        object_from_world.transform_point3(seen(world.as_dvec3(), camera))
    };
    let positions: Vec<DVec3> = object.mesh.positions.iter().map(place).collect();
    object.mesh = Arc::new(Mesh { positions, ..Mesh::clone(&object.mesh) });
}

/// The point of the world whose exact place is that of `point` after a view matrix in single precision.
fn seen(point: DVec3, camera: &Camera) -> DVec3 {
    let view = camera.view_from_world().as_mat4().transform_point3(point.as_vec3());
    let basis = camera.basis();
    let [x, y, z] = view.as_dvec3().to_array();
    camera.position() + basis.u * x + basis.v * y + basis.n * z
}
