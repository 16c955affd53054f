//! The report of a picture: the work of the pipeline, and the work on pixels.

use std::time::Duration;

use crate::drawing::{Drawing, Surface, SurfaceLight};
use crate::pipeline::operations::{Elements, operations};
use crate::pipeline::{Frame, ObjectReport, OverBudget, Stage, StageReport};
use crate::raster::Work;
use crate::views::LabelPlace;

/// The report of a picture. Without a clock it only has the shortfall and the labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderReport {
    /// Every stage, in order. Their times add up to the total.
    pub stages: Vec<StageReport>,
    /// The report of each object that went through the pipeline, beginning with those of the scene, in its order.
    pub objects: Vec<ObjectReport>,
    /// From the scene to the last pixel.
    pub total: Duration,
    /// The shortfall. Available without a clock too.
    pub over_budget: Option<OverBudget>,
    /// The places of its labels. Available without a clock too. For a compared picture, they're the visible labels of
    /// both sides.
    pub labels: Vec<LabelPlace>,
}

impl RenderReport {
    /// The report of the pipeline, completed with the work on pixels. `on_window` is the time of the image on the view
    /// window, if it was drawn. Neither the pipeline nor the rasterizer measures the preparation of the picture's
    /// scene, which is clipped and projected for the canonical volume, and gets the camera's gear in the world. That
    /// time counts as traversal.
    pub(super) fn of(frame: &Frame, work: Work, on_window: Option<Duration>, total: Duration) -> Self {
        let mut stages = frame.report.clone();
        for report in stages.iter_mut().filter(|report| report.ran) {
            complete(report, &frame.drawing, work, on_window);
            report.operations = operations(report.stage, elements(report, frame, work));
        }
        let known = stages.iter().filter_map(|report| report.time).sum();
        if let Some(traversal) = stages.iter_mut().find(|report| report.stage == Stage::Traverse) {
            traversal.time = Some(traversal.time.unwrap_or_default() + total.saturating_sub(known));
        }
        let labels = LabelPlace::all(&frame.drawing);
        Self { stages, objects: frame.objects.clone(), total, over_budget: frame.over_budget.clone(), labels }
    }
}

/// The elements that a stage worked on. A stage that the report counts by its triangles works on their pixels. They
/// have their share of all drawn pixels.
fn elements(report: &StageReport, frame: &Frame, work: Work) -> Elements {
    let drawing = &frame.drawing;
    let pixels = |weight: &dyn Fn(&Surface) -> usize| {
        let triangles: usize = drawing.surfaces.iter().map(|surface| weight(surface) * surface.triangles.len()).sum();
        let drawn = work.written / u64::from(drawing.antialias.count());
        drawn * triangles as u64 / work.triangles.max(1) as u64
    };
    let (entering, leaving) = report.counts.unwrap_or_default();
    let entering = match report.stage {
        Stage::Interpolate => pixels(&|surface| usize::from(surface.varies())),
        Stage::Texture => pixels(&|surface| usize::from(surface.is_textured())),
        Stage::Shadow => pixels(&|surface| surface.shadows.len()),
        Stage::Blend => pixels(&|surface| usize::from(surface.translucent)),
        _ => entering as u64,
    };
    let is_lit = |surface: &Surface| usize::from(matches!(surface.light, SurfaceLight::PerPixel(_)));
    Elements {
        entering,
        leaving: leaving as u64,
        lamps: frame.lamps as u64,
        lit_pixels: pixels(&is_lit),
        in_order: drawing.painted_in_order,
    }
}

/// Adds the work on pixels.
fn complete(report: &mut StageReport, drawing: &Drawing, work: Work, on_window: Option<Duration>) {
    let count = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
    let triangles = |which: &dyn Fn(&Surface) -> bool| {
        let n = drawing.surfaces.iter().filter(|s| which(s)).map(|s| s.triangles.len()).sum();
        Some((n, n))
    };
    let pixels = drawing.width as usize * drawing.height as usize;
    let own = |time: Duration| Some(report.time.unwrap_or_default() + time);
    match report.stage {
        Stage::Fill => {
            report.time = own(work.surfaces);
            report.counts = Some((work.triangles, count(work.covered)));
        }
        // When painted in order, the picture's triangles decide among themselves.
        Stage::HiddenSurfaces if !drawing.painted_in_order => {
            report.counts = Some((count(work.covered), count(work.written)));
        }
        Stage::Interpolate => report.counts = triangles(&Surface::varies),
        Stage::Texture => {
            report.counts = triangles(&Surface::is_textured);
            report.time = on_window;
        }
        Stage::Shadow => report.counts = triangles(&|s| !s.shadows.is_empty()),
        Stage::Blend => report.counts = triangles(&|s| s.translucent),
        Stage::Antialias => report.counts = Some((pixels * usize::from(drawing.antialias.count()), pixels)),
        Stage::Write => report.counts = Some((pixels, pixels)),
        Stage::Lines => report.time = own(work.strokes),
        // The pipeline does the rest.
        _ => {}
    }
}
