//! The result of culling an object, for showing the faces that aren't drawn.

use glam::DVec3;

use crate::camera::Camera;
use crate::pipeline::mesh::bounds::Bounds;
use crate::pipeline::plan::Containment;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ObjectPoint, PlaneSet};
use crate::pipeline::stage::cull_faces::facing;
use crate::pipeline::stage::cull_objects::containment;
use crate::pipeline::stage::vertex::view_point;
use crate::scene::Object;

/// The result of culling an object for a camera.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CullResult {
    /// All of it is drawn, or clipped.
    Kept,
    /// Its bounding box is outside one of these planes. It is dropped whole.
    Dropped(PlaneSet),
    /// True for each triangle that turns its back and is dropped.
    BackFaces(Vec<bool>),
}

/// The result of culling `object` when `camera` draws it.
pub fn cull_result(object: &Object, camera: &Camera) -> CullResult {
    let projector = Projector::new(camera);
    let view_from_object = projector.view_from_object(object.world_from_object);
    let mesh = &object.mesh;
    let Some(bounds) = Bounds::of(mesh) else { return CullResult::Kept };
    let place = containment(&projector, &view_from_object, &bounds).containment;
    if let Containment::Outside(planes) = place {
        return CullResult::Dropped(planes);
    }
    let view = |i: u32| mesh.positions.get(i as usize).map(|&p| view_point(&view_from_object, ObjectPoint(p)));
    let before_near = |p: &DVec3| -view_point(&view_from_object, ObjectPoint(*p)).0.z < projector.near;
    let is_cut_open = mesh.closed && mesh.positions.iter().any(before_near);
    if object.shows_both_sides(is_cut_open) {
        return CullResult::Kept;
    }
    let outward = view_from_object.outward();
    let turned = |triangle: &[u32; 3]| match triangle.map(view) {
        [Some(a), Some(b), Some(c)] => facing(&projector, [a, b, c]) * outward < 0.0,
        _ => false,
    };
    CullResult::BackFaces(mesh.triangles.iter().map(turned).collect())
}
