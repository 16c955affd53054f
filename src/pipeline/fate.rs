//! What culling does with an object, for who wants to see what is not drawn.

use glam::DVec3;

use super::bounds::Bounds;
use super::clip::PlaneSet;
use super::cull::{Place, facing, place};
use super::transform::Projector;
use crate::camera::Camera;
use crate::scene::Object;

/// What culling does with an object for a camera.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// All of it is drawn, or clipped.
    Kept,
    /// Its bounding box is outside one of these planes: it is dropped whole.
    Dropped(PlaneSet),
    /// True for each triangle that turns its back and is dropped.
    BackFaces(Vec<bool>),
}

/// What culling does with `object` when `camera` draws it.
#[must_use]
pub fn fate(object: &Object, camera: &Camera) -> Fate {
    let projector = Projector::new(camera);
    let view_from_object = projector.view_from_object(object.world_from_object);
    let mesh = &object.mesh;
    let Some(bounds) = Bounds::of(mesh) else { return Fate::Kept };
    let place = place(&projector, &view_from_object, &bounds);
    if let Place::Outside(planes) = place {
        return Fate::Dropped(planes);
    }
    let view = |i: u32| mesh.positions.get(i as usize).map(|&p| view_from_object.point(p));
    let before_near = |p: &DVec3| -view_from_object.point(*p).z < projector.near;
    let cut_open = mesh.closed && mesh.positions.iter().any(before_near);
    if object.two_sided || cut_open || (mesh.closed && object.paint.is_translucent()) {
        return Fate::Kept;
    }
    let outward = view_from_object.outward();
    let turned = |triangle: &[u32; 3]| match triangle.map(view) {
        [Some(a), Some(b), Some(c)] => facing(&projector, [a, b, c]) * outward < 0.0,
        _ => false,
    };
    Fate::BackFaces(mesh.triangles.iter().map(turned).collect())
}
