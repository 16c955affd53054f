//! Intersections of a segment with the faces of a scene.

use glam::DVec3;

use crate::camera::{Camera, Projection};
use crate::geometry::ray_meets_triangle;
use crate::scene::{Object, ObjectPaint, Scene};

/// The first point of the scene's faces on a segment (world), beginning at `from`.
pub(in crate::views) fn first_hit(scene: &Scene, from: DVec3, to: DVec3) -> Option<DVec3> {
    let t = first_crossing(scene, from, to)?;
    Some(from + (to - from) * t)
}

/// The objects with visible faces. Wholly transparent ones don't hide anything and can't be picked.
pub(in crate::views) fn faced(scene: &Scene) -> impl Iterator<Item = (usize, &Object)> {
    let is_invisible = |object: &Object| match &object.paint {
        ObjectPaint::Solid(color) => color.a == 0,
        ObjectPaint::Faces(colors) | ObjectPaint::Vertices(colors) => colors.iter().all(|color| color.a == 0),
        ObjectPaint::Texture(_) => false,
    };
    scene.objects.iter().enumerate().filter(move |(_, object)| object.faces && !is_invisible(object))
}

/// Like [`first_hit`], for the faces that leave a depth in the image: opaque ones, and only the fronts of open
/// one-sided objects.
pub(in crate::views) fn first_opaque(scene: &Scene, from: DVec3, to: DVec3) -> Option<DVec3> {
    let opaque = scene.objects.iter().filter(|o| o.faces && !o.paint.is_translucent());
    let t = opaque.filter_map(|o| crossing(o, from, to, fronts_only(o))).min_by(f64::total_cmp)?;
    Some(from + (to - from) * t)
}

/// True if only the fronts of an object's faces are visible. A closed solid shows its inside where a plane cuts it
/// open, and a segment that begins outside a whole one meets a front first.
pub(in crate::views) fn fronts_only(object: &Object) -> bool {
    !object.two_sided && !object.mesh.closed
}

/// The first intersection of a segment with a face: 0 at `from`, 1 at `to`.
pub(in crate::views) fn first_crossing(scene: &Scene, from: DVec3, to: DVec3) -> Option<f64> {
    faced(scene).filter_map(|(_, o)| crossing(o, from, to, false)).min_by(f64::total_cmp)
}

/// True if no face hides a point behind a camera's front plane.
pub(in crate::views) fn can_be_seen(p: DVec3, faces: &Scene, camera: &Camera) -> bool {
    let depth = -camera.view_point(p).z;
    let to_eye = match camera.projection() {
        Projection::Perspective => (camera.position() - p) / depth,
        Projection::Parallel => camera.basis().n,
    };
    let eye = p + to_eye * (depth - camera.near());
    // The faces that meet in the point end there and don't hide it.
    first_crossing(faces, eye, p).is_none_or(|t| t > 1.0 - 1e-6)
}

/// Like [`first_crossing`], for one object.
pub(in crate::views) fn crossing(object: &Object, from: DVec3, to: DVec3, fronts_only: bool) -> Option<f64> {
    triangle_hit(object, from, to, fronts_only).map(|(t, _)| t)
}

/// Like [`crossing`], with the index of the triangle.
pub(in crate::views) fn triangle_hit(object: &Object, from: DVec3, to: DVec3, fronts_only: bool) -> Option<(f64, u32)> {
    let object_from_world = object.world_from_object.inverse();
    if !object_from_world.is_finite() {
        return None; // scaled to nothing
    }
    let (a, b) = (object_from_world.transform_point3(from), object_from_world.transform_point3(to));
    let positions = &object.mesh.positions;
    let corner = |i: u32| positions.get(i as usize).copied();
    let hit = |[i, j, k]: [u32; 3]| ray_meets_triangle(a, b - a, [corner(i)?, corner(j)?, corner(k)?]);
    let hits = object.mesh.triangles.iter().zip(0..).filter_map(|(corners, i)| Some((hit(*corners)?, i)));
    hits.filter(|((t, is_front), _)| (0.0..=1.0).contains(t) && (*is_front || !fronts_only))
        .map(|((t, _), i)| (t, i))
        .min_by(|one, other| one.0.total_cmp(&other.0))
}
