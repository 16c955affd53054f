//! What was done for a picture: counts and times, stage by stage.

use std::time::Duration;

use super::faces::Faces;
use super::plan::{Options, Plan, Reason, Stage};
use super::transform::Vertices;
use crate::appearance::Visibility;
use crate::drawing::Drawing;
use crate::scene::Object;

/// A picture, and how it came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The picture.
    pub drawing: Drawing,
    /// What was needed, and why.
    pub plan: Plan,
    /// What was done.
    pub report: Vec<StageReport>,
}

/// One stage of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StageReport {
    /// Which one.
    pub stage: Stage,
    /// It ran.
    pub ran: bool,
    /// Why, or why not.
    pub reason: Reason,
    /// What went in and what came out: objects for traversal and the culling of objects, vertices for transforms, triangles
    /// for the rest. `None` where the pipeline does not know (what happens to pixels).
    pub counts: Option<(usize, usize)>,
    /// How long it took; `None` without a clock, and for stages that run together with another.
    pub time: Option<Duration>,
}

/// Counts and times while a picture is made.
pub(super) struct Meter {
    clock: Option<fn() -> Duration>,
    last: Duration,
    times: [Duration; Stage::ALL.len()],
    vertices: usize,
    triangles: usize,
    front: usize,
    drawn: usize,
    /// Edges, lines, marks and texts of the scene, and strokes, marks and texts of the picture.
    pub(super) lines: (usize, usize),
}

impl Meter {
    pub(super) fn new(options: Options) -> Self {
        Self {
            clock: options.clock,
            last: options.clock.map_or(Duration::ZERO, |now| now()),
            times: [Duration::ZERO; Stage::ALL.len()],
            vertices: 0,
            triangles: 0,
            front: 0,
            drawn: 0,
            lines: (0, 0),
        }
    }

    /// Books the time since the last call to `stage`.
    pub(super) fn lap(&mut self, stage: Stage) {
        if let Some(now) = self.clock {
            let now = now();
            self.times[stage as usize] += now.saturating_sub(self.last);
            self.last = now;
        }
    }

    /// Counts what was done for the faces of one object.
    pub(super) fn count(&mut self, vertices: &Vertices, faces: &Faces, object: &Object) {
        self.vertices += vertices.len();
        self.triangles += object.mesh.triangles.len();
        self.front += object.mesh.triangles.len() - faces.back;
        self.drawn += faces.triangles.len();
    }

    pub(super) fn report(&self, plan: &Plan) -> Vec<StageReport> {
        let drawn = plan.objects.iter().filter(|object| object.drawn).count();
        let vertices = Some((self.vertices, self.vertices));
        plan.stages
            .iter()
            .map(|planned| {
                let (counts, timed) = match planned.stage {
                    Stage::Traverse => (Some((plan.objects.len(), plan.objects.len())), true),
                    Stage::CullObjects => (Some((plan.objects.len(), drawn)), false),
                    Stage::Transform => (vertices, true),
                    // One loop takes a vertex through all spaces: its time is booked to the first of them.
                    Stage::Divide | Stage::Oblique | Stage::Viewport | Stage::Normals => (vertices, false),
                    Stage::CullFaces => (Some((self.triangles, self.front)), true),
                    Stage::Clip => (Some((self.front, self.drawn)), true),
                    Stage::Light => (Some((self.drawn, self.drawn)), true),
                    Stage::HiddenSurfaces => (None, plan.order() != Visibility::DepthBuffer),
                    Stage::Lines => (Some(self.lines), true),
                    Stage::Fill
                    | Stage::Interpolate
                    | Stage::Texture
                    | Stage::Blend
                    | Stage::Antialias
                    | Stage::Write => (None, false),
                };
                StageReport {
                    stage: planned.stage,
                    ran: planned.runs,
                    reason: planned.reason,
                    counts: counts.filter(|_| planned.runs),
                    time: (self.clock.is_some() && timed && planned.runs).then(|| self.times[planned.stage as usize]),
                }
            })
            .collect()
    }
}
