//! One triangle step by step, among the explanations.

use crate::Lang;
use crate::figure::TriangleStep;

texts!("why/triangle");

/// The name of a step.
pub const fn step(t: &Texts, step: TriangleStep) -> &'static str {
    match step {
        TriangleStep::View => t.step_view,
        TriangleStep::Facing => t.step_facing,
        TriangleStep::Outcodes => t.step_outcodes,
        TriangleStep::Cuts => t.step_cuts,
        TriangleStep::Divide => t.step_divide,
        TriangleStep::Viewport => t.step_viewport,
        TriangleStep::Pixels => t.step_pixels,
        TriangleStep::Depth => t.step_depth,
    }
}
