//! The pipeline as the pictures use it.

use std::borrow::Cow;
use std::time::Duration;

use super::{Request, SharedScene, View};
use crate::appearance::{DepthFormat, Shading, Style};
use crate::camera::Camera;
use crate::drawing::Drawing;
use crate::pipeline::canonical::legible_clipped_scene;
use crate::pipeline::depths::DepthScale;
use crate::pipeline::{Frame, Options, Pipeline, Scenes, Target};
use crate::scene::Scene;
use crate::views::image::depth;
use crate::views::reveal::stage_overlay;
use crate::views::world::gizmos;
use crate::views::world::gizmos::SceneChange;

/// The pipeline, with buffers that serve one picture after the other, and a clock for those who want to know how long
/// each stage takes.
#[derive(Clone, Debug, Default)]
pub struct TimedPipeline {
    /// The stages.
    pub stages: Pipeline,
    /// The time since any moment that stays the same. Without it nothing is timed.
    pub clock: Option<fn() -> Duration>,
    /// The changed scene of the last picture that had one: the pointer moves over the same one for long.
    changed: Option<(SharedScene, SceneChange, SharedScene)>,
    /// The content of the canonical volume of the last picture. Its observer may go around it for long.
    projected: Option<(SharedScene, Camera, Shading, SharedScene)>,
}

impl TimedPipeline {
    /// Forgets what was made of scenes and shadow maps. The next picture makes its own, in the same memory.
    pub fn forget(&mut self) {
        self.stages.forget();
        self.projected = None;
    }

    /// The scene of the request, clipped and projected. Made once for all pictures of it and its camera.
    pub(super) fn projected(&mut self, request: &Request) -> SharedScene {
        let (camera, shading) = (&request.camera, request.shot.look.style.shading);
        if let Some((of, by, lit, made)) = &self.projected
            && *of == request.scene
            && by == camera
            && *lit == shading
        {
            return made.clone();
        }
        let made = SharedScene::new(legible_clipped_scene(&request.scene, camera, shading));
        self.projected = Some((request.scene.clone(), camera.clone(), shading, made.clone()));
        made
    }

    /// A scene for a picture, changed: one of its own, or `of`, which is changed once, and neither copied nor changed
    /// again for the next picture of it.
    pub(super) fn scene(&mut self, of: &SharedScene, scene: Cow<'_, Scene>, by: Option<SceneChange>) -> SharedScene {
        let changed = |mut scene: Scene| {
            match by {
                None => {}
                Some(SceneChange::Wired) => gizmos::wire(&mut scene),
                Some(SceneChange::Faces) => depth::only(&mut scene),
            }
            SharedScene::new(scene)
        };
        match (scene, by) {
            (Cow::Owned(scene), _) => changed(scene),
            (Cow::Borrowed(_), None) => of.clone(),
            (Cow::Borrowed(_), Some(by)) => match &self.changed {
                Some((known, how, made)) if known == of && *how == by => made.clone(),
                _ => {
                    let made = changed(Scene::clone(of));
                    self.changed = Some((of.clone(), by, made.clone()));
                    made
                }
            },
        }
    }

    /// Sends the content of a picture through the pipeline. `repaint` may paint its surfaces otherwise, before a stage
    /// is shown over them.
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
            output: request.output,
            // Faces divided first are put into the image, with depths from F to B.
            // And whole numbers of a format are shares of that range.
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

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::figure::Figure;
    use crate::scene::{Preset, no_files};
    use crate::views::unlabelled;
    use crate::views::{Size, scene_of};

    #[test]
    fn a_scene_is_changed_once_for_all_pictures_of_it_and_one_without_change_is_not_copied() {
        let figure = Figure::of_preset(Preset::Cube);
        let camera = Camera::new(&figure.camera).unwrap();
        let scene = SharedScene::new(scene_of(&figure, &mut no_files, &Default::default()).unwrap());
        let size = Size { width: 10, height: 10, scale: 1.0 };
        let request = Request::of(&figure, View::World, &camera, &scene, unlabelled(), size);
        let mut pipeline = TimedPipeline::default();
        let mut made = |by| pipeline.scene(&request.scene, Cow::Borrowed(&*request.scene), by);
        assert_eq!(made(None), scene);
        let wired = made(Some(SceneChange::Wired));
        assert!(wired.objects.iter().all(|object| !object.faces) && wired != scene);
        assert_eq!(made(Some(SceneChange::Wired)), wired, "the same one");
        let faces = made(Some(SceneChange::Faces));
        assert!(faces.lights.is_empty() && faces.objects.iter().all(|object| object.edges.is_none()));
    }
}
