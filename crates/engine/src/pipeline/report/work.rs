//! Input and output of a stage, recorded while a picture is made, so that the picture can show them.

use glam::DVec3;

use crate::pipeline::mesh::resample::VertexOrigin;
use crate::pipeline::plan::{Containment, Plan};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ALL_PLANES, ClipPoint, Screen, ViewPoint, WorldPoint};
use crate::pipeline::stage::clip::Clipper;
use crate::pipeline::stage::faces::Faces;
use crate::pipeline::stage::reflection::{Lights, ObjectLight};
use crate::pipeline::stage::vertex::{clip_from_view, divide, unsnapped, viewport};
use crate::pipeline::stage::vertices::Vertices;
use crate::scene::Object;
use crate::stage::{Stage, WorksOn};

/// Greatest number of recorded sides, vertices and faces. An eye can't distinguish more.
const MOST: usize = 20_000;

/// Input and output of a stage of a picture, as far as they lie in the picture. Points are those of the display list:
/// pixels and depth.
#[derive(Clone, Debug, PartialEq)]
pub struct StageWork {
    /// The stage that did the work.
    pub stage: Stage,
    /// Sides of the input: of boxes around objects, of triangles.
    pub before: Vec<[[f32; 3]; 2]>,
    /// Sides of the output.
    pub after: Vec<[[f32; 3]; 2]>,
    /// Faces that went in and didn't come out, convex.
    pub dropped: Vec<Vec<[f32; 3]>>,
    /// The vertices that clipping made.
    pub cuts: Vec<[f32; 3]>,
    /// Vertices that were worked on.
    pub vertices: Vec<VertexWork>,
    /// Objects that went in.
    pub objects: Vec<ObjectWork>,
    /// There was more work than is recorded.
    pub more: bool,
}

/// A vertex that the camera was applied to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexWork {
    /// World.
    pub world: DVec3,
    /// View.
    pub view: DVec3,
    /// x and y of the clip space.
    pub clip: [f64; 2],
    /// w of the clip space.
    pub w: f64,
    /// On the image: pixels and depth.
    pub image: [f32; 3],
}

/// An object that was compared with the volume.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectWork {
    /// As the author named the object.
    pub name: String,
    /// The middle of its box, if that is in the picture.
    pub middle: Option<[f32; 3]>,
    /// The place of its box.
    pub containment: Containment,
}

/// Records the work of one stage.
pub(crate) struct Notes<'a> {
    projector: &'a Projector,
    screen: &'a Screen,
    clipper: Clipper,
    pub(crate) work: StageWork,
}

impl<'a> Notes<'a> {
    pub(crate) fn new(stage: Stage, projector: &'a Projector, screen: &'a Screen) -> Self {
        let work = StageWork {
            stage,
            before: Vec::new(),
            after: Vec::new(),
            dropped: Vec::new(),
            cuts: Vec::new(),
            vertices: Vec::new(),
            objects: Vec::new(),
            more: false,
        };
        Self { projector, screen, clipper: Clipper::default(), work }
    }

    fn image(&self, p: ClipPoint) -> [f32; 3] {
        unsnapped(viewport(self.screen, divide(&self.projector.depths, p)))
    }

    /// The part of a segment of view space that is in the picture.
    fn side(&mut self, ends: [ViewPoint; 2]) -> Option<[[f32; 3]; 2]> {
        let ends = ends.map(|p| clip_from_view(self.projector, p));
        let [(a, _), (b, _)] = self.clipper.segment(self.projector, ends)?;
        Some([self.image(a), self.image(b)])
    }

    fn has_room(&mut self, taken: usize) -> bool {
        self.work.more |= taken >= MOST;
        taken < MOST
    }

    /// The boxes of objects. All go in, and those of objects that may be in view come out.
    pub(crate) fn objects(&mut self, scenes: Scenes, plan: &Plan) {
        if self.work.stage.works_on() != WorksOn::Objects {
            return;
        }
        for (object, planned) in scenes.objects().zip(&plan.objects) {
            let Some(bounds) = object.bounds() else { continue };
            if !self.has_room(12 * self.work.objects.len()) {
                return;
            }
            let corners = bounds.corners().map(|p| self.projector.view(WorldPoint(p)));
            for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))).filter(|(i, j)| i < j) {
                // Along an edge of the box one coordinate changes.
                let differs = (bounds.corners()[i] - bounds.corners()[j]).to_array().map(|d| d != 0.0);
                if differs.iter().filter(|d| **d).count() == 1
                    && let Some(side) = self.side([corners[i], corners[j]])
                {
                    // If forced, an object outside the volume is drawn too, but the test still drops it.
                    let is_left = matches!(planned.containment, Containment::Crosses(_));
                    let sides = if is_left { &mut self.work.after } else { &mut self.work.before };
                    sides.push(side);
                }
            }
            let middle = self.projector.view(WorldPoint(bounds.center()));
            let middle = self.side([middle, middle]).map(|[p, _]| p);
            let name = object.name.clone();
            self.work.objects.push(ObjectWork { name, middle, containment: planned.containment });
        }
    }

    /// The vertices of an object in view, and their normals.
    pub(crate) fn vertices(&mut self, object: &Object, vertices: &Vertices, lights: &Lights) {
        match self.work.stage.works_on() {
            WorksOn::Vertices => {}
            WorksOn::Normals => return self.normals(object, vertices, lights),
            _ => return,
        }
        for (i, &p) in (0..).zip(vertices.positions) {
            if !self.has_room(self.work.vertices.len()) {
                return;
            }
            let (view, clip) = (vertices.view_point(i), vertices.clip_point(i));
            let Some([image, _]) = self.side([view, view]) else { continue };
            let world = object.world_from_object.transform_point3(p);
            let clip_xy = [clip.x, clip.y];
            self.work.vertices.push(VertexWork { world, view: view.0, clip: clip_xy, w: clip.w, image });
        }
    }

    /// A normal goes in as the object has it and comes out in view space. It is drawn where it is.
    fn normals(&mut self, object: &Object, vertices: &Vertices, lights: &Lights) {
        /// The length of a normal, in radii of its object.
        const LENGTH: f64 = 0.15;
        let length = object.bounds().map_or(0.0, |bounds| LENGTH * bounds.radius());
        let light = ObjectLight::new(lights, &object.mesh, *vertices, object.two_sided);
        for i in (0..).take(object.mesh.normals.len().min(vertices.len())) {
            if !self.has_room(self.work.after.len()) {
                return;
            }
            let foot = vertices.view_point(i);
            let side = self.side([foot, ViewPoint(foot.0 + light.unit_normal(i) * length)]);
            self.work.after.extend(side);
        }
    }

    /// The triangles that culling drops because they turn their back, and those that it leaves.
    pub(crate) fn culled(&mut self, vertices: &Vertices, triangles: &[[u32; 3]], faces: &Faces) {
        if self.work.stage != Stage::CullFaces {
            return;
        }
        let outcomes = faces.outcomes(triangles);
        for (&triangle, is_left) in triangles.iter().zip(outcomes) {
            if !self.has_room(self.work.after.len() + self.work.dropped.len()) {
                return;
            }
            match is_left {
                Some(true) => self.triangle_sides(vertices, triangle, |work| &mut work.after),
                Some(false) => {
                    let corners = triangle.map(|i| vertices.clip_point(i));
                    let polygon = self.clipper.triangle(self.projector, corners, ALL_PLANES);
                    let points: Vec<ClipPoint> = polygon.iter().map(|corner| corner.point).collect();
                    let polygon: Vec<[f32; 3]> = points.into_iter().map(|p| self.image(p)).collect();
                    if polygon.len() > 2 {
                        self.work.dropped.push(polygon);
                    }
                }
                // Faces outside a plane belong to clipping.
                None => {}
            }
        }
    }

    fn triangle_sides(
        &mut self,
        vertices: &Vertices,
        triangle: [u32; 3],
        into: fn(&mut StageWork) -> &mut Vec<[[f32; 3]; 2]>,
    ) {
        let [a, b, c] = triangle.map(|i| vertices.view_point(i));
        for ends in [[a, b], [b, c], [c, a]] {
            let side = self.side(ends);
            into(&mut self.work).extend(side);
        }
    }

    /// The triangles that cross a plane, the pieces that are left of them, and the vertices that clipping made.
    pub(crate) fn clipped(&mut self, vertices: &Vertices, faces: &Faces) {
        if self.work.stage != Stage::Clip {
            return;
        }
        for triangle in faces.crossing() {
            if !self.has_room(self.work.before.len()) {
                return;
            }
            self.triangle_sides(vertices, triangle, |work| &mut work.before);
        }
        let positions = &faces.image.positions;
        let at = |i: u32| positions.get(i as usize).copied().unwrap_or_default();
        for &[a, b, c] in faces.pieces() {
            if !self.has_room(self.work.after.len()) {
                return;
            }
            self.work.after.extend([[a, b], [b, c], [c, a]].map(|ends| ends.map(at)));
        }
        let new = faces.cuts.iter().zip(&positions[vertices.len()..]);
        let new = new.filter(|(cut, _)| matches!(cut, VertexOrigin::Between { .. }));
        self.work.cuts.extend(new.map(|(_, &p)| p));
    }
}
