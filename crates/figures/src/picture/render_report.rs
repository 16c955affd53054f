//! The report of a picture: the work of the pipeline, and the work on pixels.

use std::time::Duration;

use crate::drawing::{Drawing, Surface};
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
            if !report.stage.is_raster() {
                let (entering, leaving) = report.counts.unwrap_or_default();
                let lamps = frame.lamps as u64;
                let (entering, leaving, in_order) = (entering as u64, leaving as u64, frame.drawing.painted_in_order);
                let elements = Elements { entering, leaving, lamps, lit_pixels: 0, in_order };
                report.operations = operations(report.stage, elements);
            }
        }
        let known = stages.iter().filter_map(|report| report.time).sum();
        if let Some(traversal) = stages.iter_mut().find(|report| report.stage == Stage::Traverse) {
            traversal.time = Some(traversal.time.unwrap_or_default() + total.saturating_sub(known));
        }
        let labels = LabelPlace::all(&frame.drawing);
        Self { stages, objects: frame.objects.clone(), total, over_budget: frame.over_budget.clone(), labels }
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
