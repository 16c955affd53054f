//! Intersections of a segment with the faces of a scene.

use glam::DVec3;

use crate::camera::{Camera, Projection};
use crate::scene::{Object, ObjectPaint, Scene};

/// The first point of the scene's faces on a segment (world), beginning at `from`.
pub(in crate::views) fn first_hit(scene: &Scene, from: DVec3, to: DVec3) -> Option<DVec3> {
    let t = first_crossing(scene, from, to)?;
    Some(from + (to - from) * t)
}

/// The objects whose faces can be seen: what is wholly transparent neither hides anything nor is picked.
pub(in crate::views) fn faced(scene: &Scene) -> impl Iterator<Item = (usize, &Object)> {
    let is_invisible = |object: &Object| match &object.paint {
        ObjectPaint::Solid(color) => color.a == 0,
        ObjectPaint::Faces(colors) | ObjectPaint::Vertices(colors) => colors.iter().all(|color| color.a == 0),
        ObjectPaint::Texture(_) => false,
    };
    scene.objects.iter().enumerate().filter(move |(_, object)| object.faces && !is_invisible(object))
}

/// As [`first_hit`], of the faces that leave a depth in the image: opaque ones, and of open one-sided objects only the
/// fronts.
pub(in crate::views) fn first_opaque(scene: &Scene, from: DVec3, to: DVec3) -> Option<DVec3> {
    let opaque = scene.objects.iter().filter(|o| o.faces && !o.paint.is_translucent());
    let t = opaque.filter_map(|o| crossing(o, from, to, fronts_only(o))).min_by(f64::total_cmp)?;
    Some(from + (to - from) * t)
}

/// True where only the fronts of an object's faces are seen. A closed solid shows its inside where a plane cuts it
/// open, and a segment that begins outside of a whole one meets a front first.
pub(in crate::views) fn fronts_only(object: &Object) -> bool {
    !object.two_sided && !object.mesh.closed
}

/// The first intersection of a segment with a face: 0 at `from`, 1 at `to`.
pub(in crate::views) fn first_crossing(scene: &Scene, from: DVec3, to: DVec3) -> Option<f64> {
    faced(scene).filter_map(|(_, o)| crossing(o, from, to, false)).min_by(f64::total_cmp)
}

/// Whether no face hides a point behind a camera's front plane.
pub(in crate::views) fn can_be_seen(p: DVec3, faces: &Scene, camera: &Camera) -> bool {
    let depth = -camera.view_point(p).z;
    let to_eye = match camera.projection() {
        Projection::Perspective => (camera.position() - p) / depth,
        Projection::Parallel => camera.basis().n,
    };
    let eye = p + to_eye * (depth - camera.near());
    // The faces that meet in the point end there and do not hide it.
    first_crossing(faces, eye, p).is_none_or(|t| t > 1.0 - 1e-6)
}

/// As [`first_crossing`], of one object.
pub(in crate::views) fn crossing(object: &Object, from: DVec3, to: DVec3, fronts_only: bool) -> Option<f64> {
    triangle_hit(object, from, to, fronts_only).map(|(t, _)| t)
}

/// As [`crossing`], with the index of the triangle.
pub(in crate::views) fn triangle_hit(object: &Object, from: DVec3, to: DVec3, fronts_only: bool) -> Option<(f64, u32)> {
    let object_from_world = object.world_from_object.inverse();
    if !object_from_world.is_finite() {
        return None; // scaled to nothing
    }
    let (a, b) = (object_from_world.transform_point3(from), object_from_world.transform_point3(to));
    let positions = &object.mesh.positions;
    let corner = |i: u32| positions.get(i as usize).copied();
    object
        .mesh
        .triangles
        .iter()
        .zip(0..)
        .filter_map(|(t, i)| Some((triangle_crossing(a, b - a, [corner(t[0])?, corner(t[1])?, corner(t[2])?])?, i)))
        .filter(|((_, facing), _)| !fronts_only || *facing > 0.0)
        .map(|((t, _), i)| (t, i))
        .min_by(|one, other| one.0.total_cmp(&other.0))
}

/// The parameter, 0 … 1, at which a segment meets a triangle (Möller and Trumbore 1997), and a number that is positive
/// where the segment comes from the side from which the corners run counter-clockwise.
fn triangle_crossing(origin: DVec3, d: DVec3, [a, b, c]: [DVec3; 3]) -> Option<(f64, f64)> {
    let (ab, ac) = (b - a, c - a);
    let p = d.cross(ac);
    let det = ab.dot(p);
    if det == 0.0 {
        return None;
    }
    let s = origin - a;
    let u = s.dot(p) / det;
    let q = s.cross(ab);
    let v = d.dot(q) / det;
    let t = ac.dot(q) / det;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (0.0..=1.0).contains(&t)).then_some((t, det))
}
