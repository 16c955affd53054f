//! Counts of planned or finished work, and the reasons that follow from them.

use super::object::{Containment, FacesDone, LitAt, ObjectPlan, ObjectReport};
use super::reason::{Output, Reason, StagePlan};
use crate::appearance::{HiddenLines, LineStyle, Samples, Shading, Style, Visibility};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{NEAR, PlaneSet};
use crate::scene::{Object, ObjectPaint};
use crate::stage::Stage;

/// The counts for the plan of a frame or, once its work is finished, for its report. They cover only objects in view,
/// and their faces only if there are any.
pub(crate) struct SceneCounts {
    objects: usize,
    outside: usize,
    in_view: usize,
    crossing: usize,
    planes: PlaneSet,
    faces: usize,
    culled: usize,
    cut_open: usize,
    lit_faces: usize,
    lit_vertices: usize,
    lit_pixels: usize,
    dark: bool,
    varies: usize,
    textured: usize,
    casts: bool,
    shadowed: usize,
    pictured: usize,
    translucent: usize,
    hides_itself: bool,
    pub(crate) lines_ask: bool,
    lines: bool,
}

impl SceneCounts {
    pub(crate) fn new(scenes: Scenes, plans: &[ObjectPlan], style: &Style) -> Self {
        let is_outside = |plan: &&ObjectPlan| matches!(plan.containment, Containment::Outside(_));
        let is_in_view = |(_, plan): &(&Object, &ObjectPlan)| matches!(plan.containment, Containment::Crosses(_));
        let in_view: Vec<(&Object, &ObjectPlan)> = scenes.objects().zip(plans).filter(is_in_view).collect();
        let wireframe = style.shading == Shading::Wireframe;
        let faces: Vec<_> = in_view.iter().filter(|(_, plan)| plan.faces && !wireframe).collect();
        let lit = |at: LitAt| faces.iter().filter(|(_, plan)| plan.lit == at).count();
        let planes = |plan: &ObjectPlan| match plan.containment {
            Containment::Crosses(planes) => planes,
            Containment::Outside(_) | Containment::Empty => 0,
        };
        let outline = |object: &Object| object.outline.filter(|_| !wireframe);
        let asks = |line: LineStyle| line.in_style(style).hidden != HiddenLines::Shown;
        // The inside of an object that the near plane may cut open is hidden by its outside.
        let hides_itself = |object: &Object, plan: &ObjectPlan| {
            !(object.mesh.convex && object.mesh.closed && plan.cull_back && planes(plan) & NEAR == 0)
        };
        // Even if the plan is forced to use a texture of one colour.
        let has_colors =
            |object: &Object| matches!(&object.paint, ObjectPaint::Texture(pictured) if pictured.one_color().is_none());
        Self {
            objects: scenes.object_count(),
            outside: plans.iter().filter(is_outside).count(),
            in_view: in_view.len(),
            crossing: in_view.iter().filter(|(_, plan)| planes(plan) != 0).count(),
            planes: in_view.iter().fold(0, |all, (_, plan)| all | planes(plan)),
            faces: faces.len(),
            culled: faces.iter().filter(|(_, plan)| plan.cull_back).count(),
            cut_open: 0,
            lit_faces: lit(LitAt::Faces),
            lit_vertices: lit(LitAt::Vertices),
            lit_pixels: lit(LitAt::Pixels),
            dark: scenes.lights.is_empty(),
            varies: faces.iter().filter(|(object, plan)| plan.interpolates(object)).count(),
            casts: scenes.casts_shadows(),
            shadowed: faces.iter().filter(|(_, plan)| plan.shadowed).count(),
            textured: faces.iter().filter(|(object, _)| has_colors(object)).count(),
            pictured: faces.iter().filter(|(object, _)| matches!(object.paint, ObjectPaint::Texture(_))).count(),
            translucent: faces.iter().filter(|(_, plan)| plan.translucent).count(),
            hides_itself: faces.iter().any(|(object, plan)| hides_itself(object, plan)),
            lines_ask: in_view.iter().any(|(object, _)| object.edges.is_some_and(asks))
                || in_view.iter().any(|(object, _)| outline(object).is_some_and(asks))
                || scenes.lines().any(|line| asks(line.style))
                || scenes.marks().any(|mark| mark.fade_if_hidden)
                || scenes.texts().any(|text| text.fade_if_hidden),
            lines: in_view.iter().any(|(object, _)| wireframe || object.edges.is_some() || outline(object).is_some())
                || scenes.line_count() > 0,
        }
    }

    /// The same counts of finished work. An object all of whose faces were dropped or clipped away has none, and one
    /// that the front plane has cut open keeps its back faces.
    pub(crate) fn of_done(scenes: Scenes, plans: &[ObjectPlan], done: &[ObjectReport], style: &Style) -> Self {
        let culled = |plan: &ObjectPlan, done: &ObjectReport| ObjectPlan {
            cull_back: done.faces == FacesDone::BackDropped,
            ..*plan
        };
        let left = |plan: &ObjectPlan, done: &ObjectReport| ObjectPlan {
            faces: plan.faces && done.triangles > 0,
            ..culled(plan, done)
        };
        let all = |change: &dyn Fn(&ObjectPlan, &ObjectReport) -> ObjectPlan| -> Vec<ObjectPlan> {
            plans.iter().zip(done).map(|(plan, done)| change(plan, done)).collect()
        };
        // Culling comes before the remaining faces are known, so it counts all objects whose faces it was given.
        let culling = Self::new(scenes, &all(&culled), style);
        let cut_open = done.iter().filter(|done| done.faces == FacesDone::CutOpen).count();
        Self { culled: culling.culled, cut_open, ..Self::new(scenes, &all(&left), style) }
    }

    /// The final report of a stage that works on faces: whether it had anything to do, and why. `None` for other
    /// stages, and for those that decide on faces that **may** be seen. Their plan is their report.
    pub(crate) fn face_stage(&self, planned: &StagePlan, style: &Style) -> Option<(bool, Reason)> {
        let StagePlan { stage, runs, reason } = *planned;
        if !runs || reason == Reason::Forced {
            return None;
        }
        match stage {
            Stage::CullFaces => Some(self.cull_faces()),
            Stage::Normals
            | Stage::Light
            | Stage::Fill
            | Stage::Interpolate
            | Stage::Texture
            | Stage::Shadow
            | Stage::Blend => {
                Some(if self.faces == 0 { (false, Reason::NoFaceLeft) } else { self.with_faces(stage, style) })
            }
            _ => None,
        }
    }

    /// The reason why a stage that works on faces has none.
    fn no_faces(&self, style: &Style) -> Option<(bool, Reason)> {
        match style.shading {
            Shading::Wireframe => Some((false, Reason::Wireframe)),
            _ if self.in_view == 0 => Some((false, Reason::NothingInView)),
            _ if self.faces == 0 => Some((false, Reason::NoFaces)),
            Shading::Flat | Shading::Gouraud | Shading::Phong => None,
        }
    }

    /// The hidden-surface algorithm: the style's choice, or that of the output. If no face hides another it's the depth
    /// buffer, which needs no order.
    pub(crate) fn order(&self, style: &Style, output: Output) -> Visibility {
        match (output, style.visibility) {
            _ if self.no_faces(style).is_some() => Visibility::DepthBuffer,
            // Painting in order needs an order even of faces that hide nothing.
            (Output::Vectors, Visibility::DepthBuffer) => Visibility::Bsp,
            (Output::Vectors, chosen) => chosen,
            (Output::Pixels, chosen) if self.faces > 1 || self.hides_itself => chosen,
            (Output::Pixels, _) => Visibility::DepthBuffer,
        }
    }

    /// True if a stage is needed, and the reason.
    pub(crate) fn stage(&self, stage: Stage, projector: &Projector, style: &Style, output: Output) -> (bool, Reason) {
        match stage {
            Stage::Transform | Stage::Oblique | Stage::Divide | Stage::Viewport if self.in_view == 0 && !self.lines => {
                (false, Reason::NothingInView)
            }
            Stage::Traverse | Stage::Write => (true, Reason::Always),
            Stage::Viewport | Stage::Transform => (true, Reason::SomethingInView),
            Stage::CullObjects if self.outside == 0 => (false, Reason::NoneOutside { of: self.objects }),
            Stage::CullObjects => (true, Reason::Outside { outside: self.outside, of: self.objects }),
            Stage::HiddenSurfaces => self.no_faces(style).unwrap_or_else(|| self.hidden_surfaces(style, output)),
            Stage::Clip if self.in_view == 0 => (false, Reason::NothingInView),
            Stage::Clip if self.crossing == 0 => (false, Reason::AllInside { objects: self.in_view }),
            Stage::Clip => (true, Reason::Crossing { objects: self.crossing, of: self.in_view, planes: self.planes }),
            Stage::Oblique if projector.shift == [0.0, 0.0] => (false, Reason::SymmetricWindow),
            Stage::Oblique => (true, Reason::ObliqueWindow),
            Stage::Divide if projector.projection.is_perspective() => (true, Reason::PerspectiveProjection),
            Stage::Divide => (false, Reason::ParallelProjection),
            Stage::Lines if self.lines => (true, Reason::LinesInView),
            Stage::Lines if self.in_view == 0 => (false, Reason::NothingInView),
            Stage::Lines => (false, Reason::NoLines),
            _ => self.no_faces(style).unwrap_or_else(|| self.with_faces(stage, style)),
        }
    }

    /// The report of a stage that works on faces, if there are any.
    fn with_faces(&self, stage: Stage, style: &Style) -> (bool, Reason) {
        match stage {
            Stage::Normals | Stage::Light => self.light(stage),
            Stage::CullFaces => self.cull_faces(),
            Stage::Interpolate => match self.varies {
                0 => (false, Reason::OneColorAFace),
                objects => (true, Reason::VariesOverFaces { objects }),
            },
            Stage::Texture => match self.textured {
                0 if self.pictured > 0 => (false, Reason::TextureOfOneColor { objects: self.pictured }),
                0 => (false, Reason::NoTexture),
                objects => (true, Reason::Textured { objects }),
            },
            Stage::Shadow => match self.shadowed {
                0 if self.casts => (false, Reason::NothingShadowed),
                0 => (false, Reason::NoShadows),
                objects => (true, Reason::Shadowed { objects }),
            },
            Stage::Blend => match self.translucent {
                0 => (false, Reason::AllOpaque),
                objects => (true, Reason::Translucent { objects }),
            },
            Stage::Antialias => match style.antialias {
                Samples::One => (false, Reason::OneSample),
                samples => (true, Reason::Samples { samples: samples.count() }),
            },
            Stage::Fill => (true, Reason::FacesInView { objects: self.faces }),
            // `stage` and `face_stage` don't ask about these.
            _ => (true, Reason::Always),
        }
    }

    fn cull_faces(&self) -> (bool, Reason) {
        match (self.culled, self.cut_open) {
            (0, 0) => (false, Reason::BothSidesSeen { objects: self.faces }),
            (0, objects) => (false, Reason::CutOpen { objects, of: self.faces.max(objects) }),
            (objects, _) => (true, Reason::BackFaces { objects, of: self.faces.max(objects) }),
        }
    }

    fn light(&self, stage: Stage) -> (bool, Reason) {
        if self.dark {
            return (false, Reason::NoLight);
        }
        match (self.lit_faces, self.lit_vertices, self.lit_pixels) {
            (0, 0, 0) => (false, Reason::Unlit { objects: self.faces }),
            (0, 0, objects) => (stage == Stage::Normals, Reason::LitPixels { objects }),
            (0, objects, 0) => (true, Reason::LitVertices { objects }),
            (0, vertices, pixels) => (true, Reason::LitVerticesAndPixels { vertices, pixels }),
            // No shading lights faces and vertices in one picture.
            (_, _, _) if stage == Stage::Normals => (false, Reason::FlatShading),
            (objects, _, _) => (true, Reason::LitFaces { objects }),
        }
    }

    fn hidden_surfaces(&self, style: &Style, output: Output) -> (bool, Reason) {
        match self.order(style, output) {
            Visibility::Painter => (true, Reason::PaintedByCentroid),
            Visibility::Bsp if style.visibility == Visibility::Bsp => (true, Reason::PaintedBySplitting),
            Visibility::Bsp => (true, Reason::NoDepthBuffer),
            Visibility::DepthBuffer if self.faces > 1 => (true, Reason::SeveralObjects { objects: self.faces }),
            Visibility::DepthBuffer if self.hides_itself => (true, Reason::HidesItself),
            Visibility::DepthBuffer if self.lines_ask => (true, Reason::LinesAskForDepth),
            Visibility::DepthBuffer => (false, Reason::ConvexAlone),
        }
    }
}
