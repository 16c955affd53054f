//! The vertex at a point: its number and its object.

use eframe::egui;
use glam::DVec3;

use crate::gui::kit::frames;
use crate::scene::edit::placements;
use crate::scene::{Scene, SceneSpec, ShapeData};
use crate::views::SharedScene;
use camera_lab_desk::background::memo::MAX_WAIT;
use camera_lab_desk::{Latest, Memo, Selected, is_heavy, preset_objects};

/// A vertex, as people call it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::gui::views) struct VertexName {
    /// The object's name.
    pub(in crate::gui::views) object: String,
    /// Part of the named scene.
    pub(in crate::gui::views) of_preset: bool,
    /// Its place among the object's vertices, from 1.
    pub(in crate::gui::views) number: usize,
}

/// A point of a scene.
type Place = (SharedScene, DVec3);

/// The name of the point requested last.
#[derive(Debug)]
pub(in crate::gui::views) struct VertexNames {
    last: Memo<Place, Option<VertexName>>,
    /// Searches among many vertices.
    search: Latest<Place, Option<OfMesh>>,
}

impl Default for VertexNames {
    fn default() -> Self {
        let search = Latest::new("vertex names", || {
            async |(scene, p): &Place, _: &crate::progress::Progress| OfMesh::at(*p, scene)
        });
        Self { last: Memo::default(), search }
    }
}

/// A vertex of a mesh.
#[derive(Clone, Debug)]
struct OfMesh {
    /// The name of the scene's object.
    object: String,
    /// The name of the figure's object.
    owner: String,
    /// Its place among the object's vertices, from 1.
    number: usize,
}

impl VertexNames {
    /// The vertex at a point of the world, if one is exactly there. In a heavy scene it's found beside the window's
    /// thread, which then requests a frame of `ctx`.
    pub(in crate::gui::views) fn at(
        &mut self,
        ctx: &egui::Context,
        p: DVec3,
        scene: &SharedScene,
        spec: &SceneSpec,
    ) -> Option<VertexName> {
        let place = (scene.clone(), p);
        let mut searched = None;
        if is_heavy(scene) {
            self.search.ask(&frames(ctx), place.clone());
            self.search.poll(MAX_WAIT);
            searched = Some(self.search.answer()?.clone());
        }
        let name = |(scene, p): &Place| {
            let of_mesh = searched.unwrap_or_else(|| OfMesh::at(*p, scene));
            of_mesh.map(|vertex| vertex.name(spec)).or_else(|| of_list(*p, spec))
        };
        self.last.of(place, name).clone()
    }
}

impl OfMesh {
    fn at(p: DVec3, scene: &Scene) -> Option<Self> {
        let vertex = scene.vertices().find(|vertex| vertex.p_world == p)?;
        Some(Self { object: vertex.object.to_owned(), owner: vertex.owner.to_owned(), number: vertex.index + 1 })
    }

    fn name(self, spec: &SceneSpec) -> VertexName {
        let of_preset = !matches!(Selected::of_object(spec, &self.owner), Some(Selected::Object(_)));
        VertexName { object: self.object, of_preset, number: self.number }
    }
}

/// Points and segments aren't objects of the built scene.
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
