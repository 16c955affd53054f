//! The stages that a picture needs, and the reason why each other one is left out.
//!
//! A [`Plan`] is a pure function of scene, camera and style, made before anything is drawn from bounding boxes and
//! properties of the meshes alone. It changes no pixel: with [`Options::force_all_stages`] everything runs, and the
//! picture is the same.

pub(crate) mod counts;
pub(crate) mod object;
pub(crate) mod reason;

use std::time::Duration;

use crate::appearance::{Shading, Style, Visibility};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::ALL_PLANES;
use crate::pipeline::space::projector::Projector;
use crate::scene::{Object, ObjectPaint};
pub use crate::stage::Stage;
use counts::SceneCounts;
pub(crate) use object::Extent;
pub use object::{Containment, FacesDone, LitAt, ObjectPlan, ObjectReport};
pub use reason::{Output, Reason, StagePlan};

/// The plan of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// The plan of each object, in the order of the scene.
    pub objects: Vec<ObjectPlan>,
    /// One entry for each stage, in order.
    pub stages: Vec<StagePlan>,
    /// The hidden-surface algorithm: the style's choice, or that of the output, if faces may hide each other at all.
    pub order: Visibility,
    /// The depth of faces is recorded.
    pub depth: bool,
}

/// Options of a picture, apart from its content.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Run all stages, needed or not. The picture is the same.
    pub force_all_stages: bool,
    /// Run this stage, needed or not. The picture is the same.
    pub force_stage: Option<Stage>,
    /// The output of the drawing.
    pub output: Output,
    /// The depths of the drawing are 1 at F and 0 at B, whatever is in view. For a drawing that another one is put
    /// into.
    pub depth_of_volume: bool,
    /// Record the input and output of this stage in [`Frame::work`](crate::pipeline::Frame::work).
    pub shown: Option<Stage>,
    /// Report the place of this triangle (object, index in its mesh) in the drawing in
    /// [`Frame::followed`](crate::pipeline::Frame::followed). Not available if faces are sorted.
    pub followed: Option<(usize, u32)>,
    /// Returns the time since any moment, for the report. Without it nothing is timed.
    pub clock: Option<fn() -> Duration>,
}

impl Options {
    /// True if a stage is to run, needed or not.
    pub(crate) fn forces(&self, stage: Stage) -> bool {
        self.force_all_stages || self.force_stage == Some(stage)
    }
}

impl Plan {
    /// Plans the picture of a scene whose objects have these extents.
    pub(crate) fn new(
        scenes: Scenes,
        projector: &Projector,
        style: &Style,
        extents: &[Extent],
        options: Options,
    ) -> Self {
        let dark = scenes.lights.is_empty();
        let casts = scenes.casts_shadows() && style.shading != Shading::Wireframe;
        let planned = |(object, extent): (&Object, &Extent)| {
            let planned = plan_object(object, extent.containment, style, dark, options);
            let is_lit_in_world = || object.in_world.as_ref().is_some_and(|in_world| !in_world.taken.is_empty());
            let takes_shadow = planned.lit != LitAt::Nowhere || is_lit_in_world();
            ObjectPlan { shadowed: planned.drawn && casts && takes_shadow, ..planned }
        };
        let objects: Vec<ObjectPlan> = scenes.objects().zip(extents).map(planned).collect();
        let counts = SceneCounts::new(scenes, &objects, style);
        let stages = Stage::ALL
            .map(|stage| {
                let (runs, reason) = counts.stage(stage, projector, style, options.output);
                let force = options.forces(stage);
                let reason = if force && !runs { Reason::Forced } else { reason };
                StagePlan { stage, runs: runs || force, reason }
            })
            .to_vec();
        let order = counts.order(style, options.output);
        let mut plan = Self { objects, stages, order, depth: true };
        plan.depth = match order {
            Visibility::DepthBuffer => plan.runs(Stage::HiddenSurfaces),
            Visibility::Painter | Visibility::Bsp => counts.lines_ask || options.forces(Stage::HiddenSurfaces),
        };
        plan
    }

    /// The plan of one stage.
    pub fn stage(&self, stage: Stage) -> StagePlan {
        // `stages` holds all of them in the order of the enumeration.
        self.stages[stage as usize]
    }

    /// True if `stage` runs.
    pub fn runs(&self, stage: Stage) -> bool {
        self.stage(stage).runs
    }
}

fn plan_object(object: &Object, containment: Containment, style: &Style, dark: bool, options: Options) -> ObjectPlan {
    let (force, forces) = (options.force_all_stages, |stage| options.forces(stage));
    let drawn = match containment {
        Containment::Crosses(_) => true,
        Containment::Outside(_) => force,
        Containment::Empty => false,
    };
    if !drawn {
        return containment.into();
    }
    let clip_planes = match containment {
        Containment::Crosses(planes) if !forces(Stage::Clip) => planes,
        Containment::Crosses(_) | Containment::Outside(_) | Containment::Empty => ALL_PLANES,
    };
    let translucent = object.paint.is_translucent();
    let textured = matches!(&object.paint, ObjectPaint::Texture(pictured) if forces(Stage::Texture) || pictured.one_color().is_none());
    let vertex_colors = matches!(object.paint, ObjectPaint::Vertices(_));
    let lit = match style.shading {
        _ if !object.lit => LitAt::Nowhere,
        _ if dark && !forces(Stage::Light) => LitAt::Nowhere,
        // Without a lamp the formula gives each colour back, wherever it is applied.
        _ if dark && vertex_colors => LitAt::Vertices,
        _ if dark => LitAt::Faces,
        Shading::Wireframe if !forces(Stage::Light) => LitAt::Nowhere,
        Shading::Wireframe | Shading::Flat => LitAt::Faces,
        Shading::Gouraud => LitAt::Vertices,
        // Interpolated colours are lit where they are known.
        Shading::Phong if vertex_colors => LitAt::Vertices,
        Shading::Phong => LitAt::Pixels,
    };
    ObjectPlan {
        containment,
        drawn,
        clip_planes,
        faces: object.faces
            && !object.mesh.triangles.is_empty()
            && (forces(Stage::Fill) || style.shading != Shading::Wireframe),
        cull_back: !object.shows_both_sides(false),
        lit,
        shadowed: false,
        translucent,
        textured,
    }
}
