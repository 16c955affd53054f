//! The subject of a new note, from a place in a picture.

use glam::{DVec2, DVec3};

use super::author_labels::extent;
use crate::figure::NotePlace;
use crate::views::interact::named_points::point_at;
use crate::views::interact::pick;
use crate::views::{Request, SharedScene};

/// The subject of a note at a place (pixels) of a picture: a named point, a vertex or an edge of the scene within
/// `reach`, else the place itself.
pub fn note_place(request: &Request, pointer: DVec2, reach: f64) -> NotePlace {
    if let Some(point) = point_at(request, pointer, reach).and_then(|i| request.shot.points.get(i)) {
        return NotePlace::World(point.position);
    }
    let of_scene = pick::vertex(request, pointer, reach).map(|p| vertex_of(&request.scene, p));
    of_scene.or_else(|| edge_at(request, pointer, reach)).unwrap_or_else(|| {
        let share = (pointer / extent(request).max(DVec2::ONE)).clamp(DVec2::ZERO, DVec2::ONE);
        NotePlace::Picture(((DVec2::new(share.x, 1.0 - share.y)) * 1000.0).round() / 1000.0)
    })
}

/// The vertex of an object that's at a point of the world.
fn vertex_of(scene: &SharedScene, p: DVec3) -> NotePlace {
    for object in &scene.objects {
        let at = object.mesh.positions.iter().position(|v| object.world_from_object.transform_point3(*v) == p);
        if let Some(vertex) = at.and_then(|i| u32::try_from(i).ok()) {
            return NotePlace::Vertex { object: object.name.clone(), vertex };
        }
    }
    NotePlace::World(p)
}

/// The edge of an object whose line in the picture is nearest to a place, within `reach` of it.
fn edge_at(request: &Request, pointer: DVec2, reach: f64) -> Option<NotePlace> {
    let places = pick::places(request)?;
    let mut best: Option<(f64, NotePlace)> = None;
    for object in &request.scene.objects {
        let place = |i: u32| places(object.world_from_object.transform_point3(*object.mesh.positions.get(i as usize)?));
        for (edge, [a, b]) in (0_u32..).zip(object.mesh.edges.iter().copied()) {
            let (Some(a), Some(b)) = (place(a), place(b)) else { continue };
            let along = ((pointer - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            let distance = pointer.distance(a.lerp(b, along));
            if distance <= reach && best.as_ref().is_none_or(|(nearest, _)| distance < *nearest) {
                best = Some((distance, NotePlace::Edge { object: object.name.clone(), edge }));
            }
        }
    }
    best.map(|(_, place)| place)
}
