//! The pipeline as the pictures use it.

use std::time::Duration;

use super::{Request, View};
use crate::appearance::{DepthFormat, Style};
use crate::camera::Camera;
use crate::drawing::Drawing;
use crate::pipeline::depths::DepthScale;
use crate::pipeline::{Frame, Options, Pipeline, Scenes, Target};
use crate::views::reveal::stage_overlay;

/// The pipeline, with buffers that serve one picture after the other, and a clock for callers that want the time of
/// each stage.
#[derive(Clone, Debug, Default)]
pub struct TimedPipeline {
    /// The stages.
    pub stages: Pipeline,
    /// The time since some fixed moment. Without it nothing is timed.
    pub clock: Option<fn() -> Duration>,
}

impl TimedPipeline {
    /// Sends the content of a picture through the pipeline. `repaint` may paint its surfaces in another way, before a
    /// stage is shown over them.
    pub(super) fn frame<'a>(
        &mut self,
        request: &Request,
        scenes: impl Into<Scenes<'a>>,
        camera: &Camera,
        target: Target,
        style: &Style,
        repaint: impl Fn(&mut Drawing, DepthScale),
    ) -> Frame {
        let options = Options {
            force_all_stages: request.force_all_stages,
            force_stage: request.force_stage,
            output: request.output,
            // Faces divided first are put into the image, with depths from F to B. Also, whole numbers of a format are
            // shares of that range.
            depth_of_volume: request.view == View::Image
                && (request.shot.look.reveal.divide_first || style.depth_format != DepthFormat::Float),
            shown: request.shot.show.stage,
            followed: None,
            clock: self.clock,
        };
        let scenes = scenes.into();
        let mut frame = self.stages.frame(scenes, camera, target, style, options);
        repaint(&mut frame.drawing, frame.depths);
        if frame.work.is_some() {
            let options = Options { shown: None, clock: None, ..options };
            let again = |scenes: Scenes, style: &Style, output| {
                let options = Options { output, ..options };
                let Frame { mut drawing, depths, .. } = self.stages.frame(scenes, camera, target, style, options);
                repaint(&mut drawing, depths);
                drawing
            };
            stage_overlay::show(&mut frame, request, scenes, style, again);
        }
        frame
    }
}
