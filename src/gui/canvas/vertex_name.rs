//! The vertex at a point: its number and its object.

use glam::DVec3;

use crate::gui::memo::Memo;
use crate::gui::state::{Selected, preset_objects};
use crate::scene::edit::placements;
use crate::scene::{Scene, SceneSpec, ShapeData};
use crate::views::SharedScene;

/// A vertex, as people call it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct VertexName {
    /// The object's name.
    pub(super) object: String,
    /// Part of the named scene.
    pub(super) of_preset: bool,
    /// Its place among the object's vertices, from 1.
    pub(super) number: usize,
}

/// The name of the point requested last: in a scene of millions of vertices it takes a while to find.
#[derive(Debug, Default)]
pub(super) struct VertexNames {
    last: Memo<(SharedScene, DVec3), Option<VertexName>>,
}

impl VertexNames {
    /// The vertex at a point of the world, if one is exactly there.
    pub(super) fn at(&mut self, p: DVec3, scene: &SharedScene, spec: &SceneSpec) -> Option<VertexName> {
        self.last.of((scene.clone(), p), |_| of_mesh(p, scene, spec).or_else(|| of_list(p, spec))).clone()
    }
}

fn of_mesh(p: DVec3, scene: &Scene, spec: &SceneSpec) -> Option<VertexName> {
    let vertex = scene.vertices().find(|vertex| vertex.p_world == p)?;
    let of_preset = !matches!(Selected::of_object(spec, vertex.owner), Some(Selected::Object(_)));
    Some(VertexName { object: vertex.object.to_owned(), of_preset, number: vertex.index + 1 })
}

/// Points and segments are no objects of the built scene.
fn of_list(p: DVec3, spec: &SceneSpec) -> Option<VertexName> {
    let own: Vec<&str> = spec.objects.iter().map(|object| object.name.as_str()).collect();
    let mut all = spec.clone();
    all.objects.extend(preset_objects(spec.preset).into_iter().filter(|object| !own.contains(&object.name.as_str())));
    let placed = placements(spec).ok()?;
    all.objects.iter().find_map(|object| {
        let points = match object.shape.as_ref()?.data() {
            ShapeData::Points(points) => points,
            ShapeData::None | ShapeData::Path(_) => return None,
        };
        let world = placed.get(&object.name)?;
        let index = points.iter().position(|point| world.transform_point3(*point) == p)?;
        let of_preset = !own.contains(&object.name.as_str());
        Some(VertexName { object: object.name.clone(), of_preset, number: index + 1 })
    })
}
