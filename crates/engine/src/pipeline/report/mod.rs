//! The report of a picture: counts and times, stage by stage.

pub mod operations;
pub(crate) mod recorder;
pub(crate) mod rounding_check;
pub(crate) mod work;

use std::time::Duration;

use crate::appearance::{Style, Visibility};
use crate::drawing::{Drawing, Surface};
use crate::pipeline::budget::OverBudget;
use crate::pipeline::object_pass::ObjectPass;
use crate::pipeline::plan::counts::SceneCounts;
use crate::pipeline::plan::{LitAt, ObjectReport, Options, Plan, Reason};
use crate::pipeline::space::depths::DepthScale;
use crate::pipeline::stage::faces::Faces;
use crate::scene::ObjectPaint;
use crate::stage::{Operations, Stage};
use work::StageWork;

/// A picture, and how it came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The display list that pixels and vectors are made from.
    pub drawing: Drawing,
    /// The stages needed, with reasons.
    pub plan: Plan,
    /// The report, by stage.
    pub report: Vec<StageReport>,
    /// Number of lamps of the scene.
    pub lamps: usize,
    /// The report of each object, in the order of the scene.
    pub objects: Vec<ObjectReport>,
    /// The exceeded budget. If it's that of pieces, the drawing is for an output with a depth buffer, whatever was
    /// requested. It is reported in preference to rounding.
    pub over_budget: Option<OverBudget>,
    /// Every vertex of the scene in the picture is drawn within this distance of its place, pixels. It's proved by the
    /// error bounds of the way from its coordinates to the grid of the image.
    pub placed_within: f64,
    /// The scale of the depths of the drawing.
    pub depths: DepthScale,
    /// Input and output of the stage to show; `None` if it didn't run.
    pub work: Option<StageWork>,
    /// Faces that only show the drops of that stage. They are painted over the drawing, and no stage counts them.
    pub dropped_faces: Vec<Surface>,
    /// Number of surfaces at the beginning of the drawing that lie under the scene, as paper and a photograph do.
    pub ground: usize,
    /// The picture before that stage, for its left half; `None` if the output is drawn over the input.
    pub before: Option<Drawing>,
    /// The place of the followed triangle in the drawing; `None` if there is none, or its object isn't drawn.
    pub followed: Option<FollowedTriangle>,
}

/// The place of a triangle of a mesh in a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FollowedTriangle {
    /// Its index in the drawing.
    pub surface: usize,
    /// The triangles of this surface that are left of it: one, none, or the fan that clipping makes.
    pub triangles: Vec<usize>,
}

impl Frame {
    /// Gives a stage another reason, which the plan can't know, because the scene was prepared for it.
    pub fn say(&mut self, stage: Stage, reason: Reason) {
        if let Some(report) = self.report.iter_mut().find(|report| report.stage == stage) {
            report.reason = reason;
        }
    }
}

/// One stage of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StageReport {
    /// The stage that did this.
    pub stage: Stage,
    /// True if it ran.
    pub ran: bool,
    /// The reason why it does or doesn't run.
    pub reason: Reason,
    /// Counts in and out. `None` if the pipeline doesn't know them (work on pixels).
    ///
    /// | stage | in | out |
    /// | --- | --- | --- |
    /// | traverse | objects of the scene | the same |
    /// | cull objects | objects of the scene | those that may be in view |
    /// | normals | vertices whose normals are transformed to view space | the same |
    /// | light | faces or vertices, if they are lit before there are pixels | the same |
    /// | transform, oblique window | vertices of objects that may be in view and have faces; of the others, those of edges (each once, where edges share them) and of outlines | the same |
    /// | cull faces | triangles of these objects | the front faces |
    /// | clip | these triangles | triangles inside the volume |
    /// | divide, viewport | vertices of these objects, and those that clipping made | the same |
    /// | hidden surfaces, painted in order | triangles | the pieces that they were split into |
    /// | lines | edges, outlines (by polyline), lines, marks and texts | strokes, marks and texts that are in view |
    pub counts: Option<(usize, usize)>,
    /// Its time; `None` without a clock, and for stages that run together with another.
    pub time: Option<Duration>,
    /// Its operations by the textbook, as soon as the picture is painted. None if they aren't counted
    /// ([`Stage::is_counted`]), or for work on pixels until these are counted one by one.
    pub operations: Operations,
}

/// Counts and times while a picture is made.
#[derive(Default)]
pub(crate) struct Meter {
    clock: Option<fn() -> Duration>,
    last: Duration,
    times: [Duration; Stage::ALL.len()],
    pub(crate) vertices: usize,
    /// Vertices that clipping made.
    cuts: usize,
    normals: usize,
    lit: usize,
    triangles: usize,
    front: usize,
    drawn: usize,
    /// Triangles that were put in order, and pieces that they were split into.
    pub(crate) pieces: Option<(usize, usize)>,
    /// Edges, lines, marks and texts of the scene, and strokes, marks and texts of the picture.
    pub(crate) lines: (usize, usize),
}

impl Meter {
    pub(crate) fn new(options: Options) -> Self {
        let last = options.clock.map_or(Duration::ZERO, |now| now());
        Self { clock: options.clock, last, ..Self::default() }
    }

    /// Books the time since the last call to `stage`.
    pub(crate) fn lap(&mut self, stage: Stage) {
        if let Some(now) = self.clock {
            let now = now();
            self.times[stage as usize] += now.saturating_sub(self.last);
            self.last = now;
        }
    }

    /// Counts the work on the faces of one object. `done` is the treatment of its back faces.
    pub(crate) fn count(&mut self, pass: &ObjectPass, faces: &Faces, done: &ObjectReport) {
        let (object, vertices) = (pass.object, pass.vertices().len());
        let triangles = object.mesh.triangles.len();
        self.vertices += vertices;
        self.cuts += faces.cuts.len();
        self.triangles += triangles;
        self.front += triangles - faces.back;
        self.drawn += faces.triangles.len();
        // Vertices between faces of several colours are lit once for each, unless the light stays apart.
        let own_colors = matches!(object.paint, ObjectPaint::Faces(_)) && !pass.plan.shadowed;
        let lit = match done.lit {
            _ if faces.triangles.is_empty() => 0,
            LitAt::Nowhere | LitAt::Pixels => 0,
            LitAt::Faces => faces.triangles.len(),
            LitAt::Vertices if own_colors => 3 * faces.triangles.len(),
            LitAt::Vertices => faces.used_vertices(vertices),
        };
        self.lit += lit;
        self.normals += match done.lit {
            LitAt::Vertices => lit,
            LitAt::Pixels if !faces.triangles.is_empty() => vertices,
            LitAt::Pixels | LitAt::Nowhere | LitAt::Faces => 0,
        };
    }

    /// Reports all stages. `done` says whether each stage that works on faces had any, and why.
    pub(crate) fn report(&self, plan: &Plan, done: &SceneCounts, style: &Style) -> Vec<StageReport> {
        let drawn = plan.objects.iter().filter(|planned| planned.drawn).count();
        let same = |n: usize| Some((n, n));
        plan.stages
            .iter()
            .map(|planned| {
                let (counts, timed) = match planned.stage {
                    Stage::Traverse => (same(plan.objects.len()), true),
                    Stage::CullObjects => (Some((plan.objects.len(), drawn)), false),
                    Stage::Transform => (same(self.vertices), true),
                    // One loop takes a vertex through all spaces, so its time is booked to the first of them.
                    Stage::Oblique => (same(self.vertices), false),
                    Stage::Divide | Stage::Viewport => (same(self.vertices + self.cuts), false),
                    Stage::Normals => (same(self.normals), false),
                    Stage::CullFaces => (Some((self.triangles, self.front)), true),
                    Stage::Clip => (Some((self.front, self.drawn)), true),
                    Stage::Light => (same(self.lit), true),
                    Stage::HiddenSurfaces => (self.pieces, plan.order != Visibility::DepthBuffer),
                    Stage::Lines => (Some(self.lines), true),
                    _ => (None, false),
                };
                let (ran, reason) = done.face_stage(planned, style).unwrap_or((planned.runs, planned.reason));
                StageReport {
                    stage: planned.stage,
                    ran,
                    operations: Operations::NONE,
                    reason,
                    counts: counts.filter(|_| ran),
                    time: (self.clock.is_some() && timed && ran).then(|| self.times[planned.stage as usize]),
                }
            })
            .collect()
    }
}
