//! One object on its way through the stages, from its mesh to surfaces and strokes of the drawing.

use crate::appearance::{Style, Visibility};
use crate::pipeline::plan::{FacesDone, LitAt, ObjectPlan};
use crate::pipeline::plan::{Options, Plan};
use crate::pipeline::space::projector::{Projector, ViewFromObject};
use crate::pipeline::stage::cull_faces::{FaceTask, Faces};
use crate::pipeline::stage::hidden_surfaces::Unordered;
use crate::pipeline::stage::light::Shaded;
use crate::pipeline::stage::lines::Strokes;
use crate::pipeline::stage::pool::Pool;
use crate::pipeline::stage::reflection::Lights;
use crate::pipeline::stage::shadow_maps::ShadowLight;
use crate::pipeline::stage::vertices::{Screen, Vertices};
use crate::scene::Object;

/// All that objects of a picture have in common.
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

    /// Takes each vertex of its faces through all spaces, once.
    pub(crate) fn transform(&self, faces: &mut Faces, pool: &mut Pool) {
        let PassContext { projector, screen, .. } = self.context;
        let interpolates = projector.perspective && Shaded::interpolates(self.object, self.plan);
        pool.refill(faces);
        faces.image.fill::<true>(&self.vertices(), screen, self.plan.clip_planes != 0, interpolates);
    }

    /// Drops the faces that turn their back, or are outside of a plane.
    pub(crate) fn cull(&self, faces: &mut Faces) {
        let task = FaceTask {
            cull_back: self.culls_back(faces),
            watch_turning: !self.context.plan.depth,
            want_source: self.wants_source(),
            want_used: self.plan.lit == LitAt::Vertices,
        };
        faces.cull(&self.vertices(), &self.object.mesh.triangles, task);
    }

    /// Clips the faces that are left, before the divide.
    pub(crate) fn clip(&self, faces: &mut Faces) {
        let PassContext { screen, options, .. } = self.context;
        faces.clip(&self.vertices(), screen, self.wants_source(), options.force_all_stages);
    }

    /// The treatment of the faces that turn their back.
    pub(crate) fn faces_done(&self, faces: &Faces) -> FacesDone {
        match self.culls_back(faces) {
            true => FacesDone::BackDropped,
            false if self.plan.cull_back => FacesDone::CutOpen,
            false => FacesDone::BothSides,
        }
    }

    /// Lights the faces that are left, and hands them on.
    pub(crate) fn light(&self, faces: &mut Faces, pool: &mut Pool, into: &mut Unordered<'a>) {
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
    pub(crate) fn shadows(&self) -> &'a [ShadowLight] {
        if self.plan.shadowed { self.context.shadows } else { &[] }
    }

    /// Draws its edges and its outline. Returns how many points were transformed for them.
    pub(crate) fn lines(&self, strokes: &mut Strokes) -> usize {
        let (vertices, style) = (self.vertices(), self.context.style);
        strokes.edges(self.object, &vertices, style) + strokes.outline(self.object, &vertices, style)
    }

    /// True where faces are lit on the side that is seen.
    pub(crate) fn lights_both_sides(&self, faces: &Faces) -> bool {
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
