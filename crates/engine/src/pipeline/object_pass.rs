//! One object on its way through the stages, from its mesh to surfaces and strokes of the drawing.

use crate::appearance::{Style, Visibility};
use crate::pipeline::plan::{FacesDone, LitAt, ObjectPlan, Options, Plan, Stage};
use crate::pipeline::space::Screen;
use crate::pipeline::space::projector::{Projector, ViewFromObject};
use crate::pipeline::stage::attributes::FacesToLight;
use crate::pipeline::stage::clip::clip;
use crate::pipeline::stage::cull_faces::{FaceTask, cull_faces};
use crate::pipeline::stage::faces::Faces;
use crate::pipeline::stage::hidden_surfaces::Unordered;
use crate::pipeline::stage::light::light;
use crate::pipeline::stage::lines::{Strokes, object_lines};
use crate::pipeline::stage::reflection::Lights;
use crate::pipeline::stage::shadow_maps::ShadowLight;
use crate::pipeline::stage::vertices::{Snap, Vertices, Wanted};
use crate::scene::Object;

/// The data that all objects of a picture share.
#[derive(Clone, Copy)]
pub(crate) struct PassContext<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) projector: &'a Projector,
    pub(crate) screen: &'a Screen,
    pub(crate) lights: &'a Lights,
    pub(crate) shadows: &'a [ShadowLight],
    pub(crate) style: &'a Style,
    pub(crate) options: Options,
}

/// An object that may be in view.
pub(crate) struct ObjectPass<'a> {
    pub(crate) object: &'a Object,
    pub(crate) plan: &'a ObjectPlan,
    /// Its place in the scene.
    pub(crate) index: usize,
    view_from_object: ViewFromObject,
    context: PassContext<'a>,
}

impl<'a> ObjectPass<'a> {
    pub(crate) fn new(index: usize, object: &'a Object, plan: &'a ObjectPlan, context: PassContext<'a>) -> Self {
        let view_from_object = context.projector.view_from_object(object.world_from_object);
        Self { object, plan, index, view_from_object, context }
    }

    /// Its vertices, in any space.
    pub(crate) fn vertices(&self) -> Vertices<'_> {
        let positions = &self.object.mesh.positions;
        Vertices { projector: self.context.projector, view_from_object: &self.view_from_object, positions }
    }

    /// Transform, oblique window, divide and viewport: takes each vertex of its faces through all spaces, once.
    pub(crate) fn transform(&self, faces: &mut Faces) {
        let PassContext { projector, screen, .. } = self.context;
        let inverse_w = projector.projection.is_perspective() && self.plan.interpolates(self.object);
        let wanted = Wanted { outcodes: self.plan.clip_planes != 0, inverse_w };
        faces.image.fill(&self.vertices(), screen, Snap::Grid, wanted);
    }

    /// Drops the faces that turn their back, or are outside of a plane.
    pub(crate) fn cull_faces(&self, faces: &mut Faces) {
        let task = FaceTask {
            cull_back: self.culls_back(faces),
            watch_turning: !self.context.plan.depth,
            want_source: self.wants_source(),
            want_used: self.plan.lit == LitAt::Vertices,
        };
        cull_faces(faces, &self.vertices(), &self.object.mesh.triangles, task);
    }

    /// Clips the remaining faces. Corners that this makes take the way of all vertices.
    pub(crate) fn clip(&self, faces: &mut Faces) {
        let PassContext { screen, options, .. } = self.context;
        clip(faces, &self.vertices(), screen, self.wants_source(), options.forces(Stage::Clip));
    }

    /// Lights the remaining faces, with their normals, and hands them on as a surface.
    pub(crate) fn light(&self, faces: &mut Faces, into: &mut Unordered<'a>) {
        let PassContext { plan, lights, .. } = self.context;
        let mesh = &self.object.mesh;
        let to_light = FacesToLight {
            object: self.object,
            vertices: self.vertices(),
            lights,
            lit: self.plan.lit,
            shadows: self.shadows(),
            textured: self.plan.textured,
            both_sides: self.object.shows_both_sides(faces.cut_open()),
            depth_test: plan.depth || (faces.turned_over > 0 && plan.order == Visibility::DepthBuffer),
        };
        if plan.order == Visibility::DepthBuffer {
            into.surfaces.extend(light(&to_light, faces));
        } else {
            let never_hides_itself = mesh.convex && mesh.closed && self.culls_back(faces) && faces.turned_over == 0;
            if let Some(layer) = to_light.layer(faces, never_hides_itself) {
                into.add_layer(self.index, self.object, layer);
            }
        }
    }

    /// Draws its edges and its outline. Returns the number of points transformed for them.
    pub(crate) fn lines(&self, strokes: &mut Strokes) -> usize {
        object_lines(strokes, self.object, &self.vertices(), self.context.style)
    }

    /// The treatment of its back faces.
    pub(crate) fn back_faces(&self, faces: &Faces) -> FacesDone {
        match self.culls_back(faces) {
            true => FacesDone::BackDropped,
            false if self.plan.cull_back => FacesDone::CutOpen,
            false => FacesDone::BothSides,
        }
    }

    /// The lights whose shadows may fall on it.
    fn shadows(&self) -> &'a [ShadowLight] {
        if self.plan.shadowed { self.context.shadows } else { &[] }
    }

    /// True if its back faces are dropped, because none can be seen.
    fn culls_back(&self, faces: &Faces) -> bool {
        self.plan.cull_back && !self.object.shows_both_sides(faces.cut_open())
    }

    /// True if each remaining face must know its triangle of the mesh.
    fn wants_source(&self) -> bool {
        self.plan.colors_faces(self.object) || self.context.options.followed.is_some()
    }
}
