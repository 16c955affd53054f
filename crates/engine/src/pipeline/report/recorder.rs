//! The record of a picture while it is made: counts and times, the work of the stage that is shown, rounding,
//! and the triangle that is followed.

use super::rounding_check::Misplaced;
use super::work::Notes;
use crate::drawing::Drawing;
use crate::pipeline::budget::OverBudget;
use crate::pipeline::object_pass::{ObjectPass, PassContext};
use crate::pipeline::plan::counts::SceneCounts;
use crate::pipeline::plan::{ObjectReport, Reason};
use crate::pipeline::report::{FollowedTriangle, Frame, Meter};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::stage::faces::Faces;
use crate::stage::Stage;

/// Watches the stages of one picture.
pub(crate) struct Recorder<'a> {
    pub(crate) meter: Meter,
    /// The report of each object.
    objects: Vec<ObjectReport>,
    followed: Option<FollowedTriangle>,
    notes: Option<Notes<'a>>,
    misplaced: Misplaced<'a>,
    /// Number of objects of the scene. Those that come after them are gear, whose rounding isn't reported.
    own_objects: usize,
    context: PassContext<'a>,
}

impl<'a> Recorder<'a> {
    /// Begins when the plan is made.
    pub(crate) fn new(mut meter: Meter, misplaced: Misplaced<'a>, scenes: Scenes, context: PassContext<'a>) -> Self {
        let PassContext { plan, projector, screen, options, .. } = context;
        let mut notes = options.shown.map(|stage| Notes::new(stage, projector, screen));
        if let Some(notes) = &mut notes {
            notes.objects(scenes, plan);
        }
        meter.lap(Stage::Traverse);
        let objects = plan.objects.iter().map(|planned| ObjectReport::from(planned.containment)).collect();
        let own_objects = scenes.own_object_count();
        Self { meter, objects, followed: None, notes, misplaced, own_objects, context }
    }

    pub(crate) fn transformed(&mut self, pass: &ObjectPass) {
        if let Some(notes) = &mut self.notes {
            notes.vertices(pass.object, &pass.vertices(), self.context.lights);
        }
        self.meter.lap(Stage::Transform);
    }

    pub(crate) fn culled(&mut self, pass: &ObjectPass, faces: &Faces) {
        if let Some(notes) = &mut self.notes {
            notes.culled(&pass.vertices(), &pass.object.mesh.triangles, faces);
        }
        self.meter.lap(Stage::CullFaces);
    }

    /// `surface`: the place in the drawing of the surface of this object.
    pub(crate) fn clipped(&mut self, pass: &ObjectPass, faces: &Faces, surface: usize) {
        let vertices = pass.vertices();
        if let Some(notes) = &mut self.notes {
            notes.clipped(&vertices, faces);
        }
        self.meter.lap(Stage::Clip);
        if let Some((_, triangle)) = self.context.options.followed.filter(|(of, _)| *of == pass.index) {
            let its = (0..).zip(&faces.source).filter(|(_, source)| **source == triangle).map(|(i, _)| i);
            self.followed = Some(FollowedTriangle { surface, triangles: its.collect() });
        }
        let Some(done) = self.objects.get_mut(pass.index) else { return };
        done.triangles = faces.triangles.len();
        done.lit = pass.plan.lit;
        done.faces = pass.back_faces(faces);
        self.meter.count(pass, faces, done);
    }

    /// Records that an object is drawn; `ends`: the number of points transformed for its lines.
    pub(crate) fn drawn(&mut self, pass: &ObjectPass, ends: usize) {
        if !pass.plan.faces {
            self.meter.vertices += ends;
        }
        self.meter.lap(Stage::Lines);
        if pass.index < self.own_objects {
            self.misplaced.look_at(pass.object, &pass.vertices());
        }
        self.meter.lap(Stage::Transform);
    }

    /// The picture with all that was recorded.
    pub(crate) fn frame(self, drawing: Drawing, scenes: Scenes) -> Frame {
        let PassContext { plan, projector, style, .. } = self.context;
        let done = SceneCounts::of_done(scenes, &plan.objects, &self.objects, style);
        let report = self.meter.report(plan, &done, style);
        // A stage that was forced shows nothing, as if it were left out.
        let ran = |stage| report.iter().any(|r| r.stage == stage && r.ran && r.reason != Reason::Forced);
        Frame {
            drawing,
            work: self.notes.map(|notes| notes.work).filter(|work| ran(work.stage)),
            plan: plan.clone(),
            lamps: scenes.lights.len(),
            objects: self.objects,
            placed_within: self.misplaced.within(),
            over_budget: OverBudget::rounding(self.misplaced.found()),
            depths: projector.depths,
            dropped_faces: Vec::new(),
            ground: 0,
            before: None,
            followed: self.followed,
            report,
        }
    }
}
