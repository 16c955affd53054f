//! One object on its way through the stages, from its mesh to surfaces and strokes of the drawing.

use super::faces::{FaceTask, Faces};
use super::hidden_surfaces::Unordered;
use super::light::Lights;
use super::lines::Strokes;
use super::plan::{Options, Plan};
use super::pool::Pool;
use super::projector::{Projector, ViewFromObject};
use super::shade::Shaded;
use super::shadow_maps::ShadowLight;
use super::stages::{FacesDone, LitAt, ObjectPlan};
use super::transform::{Screen, Vertices};
use crate::appearance::{Style, Visibility};
use crate::scene::Object;

/// All that objects of a picture have in common.
#[derive(Clone, Copy)]
pub(super) struct PassContext<'a> {
    pub(super) plan: &'a Plan,
    pub(super) projector: &'a Projector,
    pub(super) screen: &'a Screen,
    pub(super) lights: &'a Lights,
    pub(super) shadows: &'a [ShadowLight],
    pub(super) style: &'a Style,
    pub(super) options: Options,
}

/// An object that may be in view.
pub(super) struct ObjectPass<'a> {
    pub(super) object: &'a Object,
    pub(super) plan: &'a ObjectPlan,
    /// Its place in the scene.
    pub(super) index: usize,
    view_from_object: ViewFromObject,
    context: PassContext<'a>,
}

impl<'a> ObjectPass<'a> {
    pub(super) fn new(index: usize, object: &'a Object, plan: &'a ObjectPlan, context: PassContext<'a>) -> Self {
        let view_from_object = context.projector.view_from_object(object.world_from_object);
        Self { object, plan, index, view_from_object, context }
    }

    /// Its vertices, in any space.
    pub(super) fn vertices(&self) -> Vertices<'_> {
        let positions = &self.object.mesh.positions;
        Vertices { projector: self.context.projector, view_from_object: &self.view_from_object, positions }
    }

    /// Takes each vertex of its faces through all spaces, once.
    pub(super) fn transform(&self, faces: &mut Faces, pool: &mut Pool) {
        let PassContext { projector, screen, .. } = self.context;
        let interpolates = projector.perspective && Shaded::interpolates(self.object, self.plan);
        pool.refill(faces);
        faces.image.fill::<true>(&self.vertices(), screen, self.plan.clip_planes != 0, interpolates);
    }

    /// Drops the faces that turn their back, or are outside of a plane.
    pub(super) fn cull(&self, faces: &mut Faces) {
        let task = FaceTask {
            cull_back: self.culls_back(faces),
            watch_turning: !self.context.plan.depth,
            want_source: self.wants_source(),
            want_used: self.plan.lit == LitAt::Vertices,
        };
        faces.cull(&self.vertices(), &self.object.mesh.triangles, task);
    }

    /// Clips the faces that are left, before the divide.
    pub(super) fn clip(&self, faces: &mut Faces) {
        let PassContext { screen, options, .. } = self.context;
        faces.clip(&self.vertices(), screen, self.wants_source(), options.force_all_stages);
    }

    /// The treatment of the faces that turn their back.
    pub(super) fn faces_done(&self, faces: &Faces) -> FacesDone {
        match self.culls_back(faces) {
            true => FacesDone::BackDropped,
            false if self.plan.cull_back => FacesDone::CutOpen,
            false => FacesDone::BothSides,
        }
    }

    /// Lights the faces that are left, and hands them on.
    pub(super) fn light(&self, faces: &mut Faces, pool: &mut Pool, into: &mut Unordered<'a>) {
        let PassContext { plan, lights, .. } = self.context;
        let mesh = &self.object.mesh;
        let both_sides = self.lights_both_sides(faces);
        let shaded = Shaded {
            object: self.object,
            vertices: self.vertices(),
            lights,
            lit: self.plan.lit,
            shadows: self.shadows(),
            textured: self.plan.textured,
            both_sides,
            depth_test: plan.depth || (faces.turned_over > 0 && plan.order == Visibility::DepthBuffer),
        };
        if plan.order == Visibility::DepthBuffer {
            into.surfaces.extend(shaded.surface(faces, pool));
        } else {
            let never_hides_itself = mesh.convex && mesh.closed && self.culls_back(faces) && faces.turned_over == 0;
            if let Some(layer) = shaded.layer(faces, pool, never_hides_itself) {
                into.add_layer(self.object, layer);
            }
        }
    }

    /// The lights whose shadows may fall on it.
    pub(super) fn shadows(&self) -> &'a [ShadowLight] {
        if self.plan.shadowed { self.context.shadows } else { &[] }
    }

    /// Draws its edges and its outline. Returns how many points were transformed for them.
    pub(super) fn lines(&self, strokes: &mut Strokes) -> usize {
        let (vertices, style) = (self.vertices(), self.context.style);
        strokes.edges(self.object, &vertices, style) + strokes.outline(self.object, &vertices, style)
    }

    /// True where faces are lit on the side that is seen.
    pub(super) fn lights_both_sides(&self, faces: &Faces) -> bool {
        let translucent = self.object.mesh.closed && self.plan.translucent;
        self.object.two_sided || self.is_cut_open(faces) || translucent
    }

    /// True where the near plane shows the inside of a solid.
    fn is_cut_open(&self, faces: &Faces) -> bool {
        self.object.mesh.closed && faces.cut_open()
    }

    fn culls_back(&self, faces: &Faces) -> bool {
        self.plan.cull_back && !self.is_cut_open(faces)
    }

    /// True where each face that is left must know which triangle of the mesh it was.
    fn wants_source(&self) -> bool {
        Shaded::colors_faces(self.object, self.plan) || self.context.options.followed.is_some()
    }
}
