//! The coach's findings about the figure: computed beside the window's thread, and anew only when their inputs have
//! changed.

use std::time::Duration;

use eframe::egui;

use super::State;
use crate::appearance::Style;
use crate::camera::{Camera, ImageSize, Parameters};
use crate::clock;
use crate::gui::worker::{Work, Worker, one_by_one};
use crate::numerics::diagnosis::{Diagnosis, Repair, diagnose};
use crate::numerics::health::{Health, health};
use crate::progress::Progress;
use crate::views::SharedScene;

/// The inputs of the findings.
#[derive(Clone, Debug, PartialEq)]
struct HealthRequest {
    camera: Camera,
    scene: SharedScene,
    style: Style,
    image: ImageSize,
}

/// The faults of the picture, and the health of the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// The camera that it is about.
    pub camera: Camera,
    /// `None` where the image is too large to be drawn.
    pub diagnosis: Option<Diagnosis>,
    /// Six quantities.
    pub health: Vec<Health>,
}

/// The coach.
#[derive(Debug)]
pub struct Coach {
    worker: Worker<HealthRequest, (HealthRequest, Advice)>,
    asked: Option<HealthRequest>,
    known: Option<(HealthRequest, Advice)>,
    /// How far apart two surfaces are, in scene units, of which is asked whether they can be told apart.
    pub gap: f64,
}

impl Default for Coach {
    fn default() -> Self {
        let work = || -> Work<HealthRequest, (HealthRequest, Advice)> {
            one_by_one(async |asked: HealthRequest, _: &Progress| {
                let HealthRequest { camera, scene, style, image } = &asked;
                let advice = Advice {
                    camera: camera.clone(),
                    diagnosis: diagnose(scene, camera, style, *image),
                    health: health(camera, *image, scene.bounds()),
                };
                (asked, advice)
            })
        };
        Self { worker: Worker::new("coach", clock::now, work), asked: None, known: None, gap: 0.01 }
    }
}

impl Coach {
    /// Takes what has been found. Waits for it as long as `patience` says.
    pub fn take(&mut self, patience: Duration) {
        let [done] = self.worker.take(patience);
        if let Some(outcome) = done.and_then(|done| done.outcome) {
            self.known = Some(outcome);
        }
    }

    /// The advice for the last request; `None` until it is known.
    #[must_use]
    pub fn advice(&self) -> Option<&Advice> {
        self.known.as_ref().filter(|(of, _)| Some(of) == self.asked.as_ref()).map(|(_, advice)| advice)
    }

    /// The advice, or the last one while changes since are being examined.
    #[must_use]
    pub fn newest_advice(&self) -> Option<&Advice> {
        self.known.as_ref().map(|(_, advice)| advice)
    }
}

impl State {
    /// Has the coach look at the figure, where it has changed; not while the hand moves.
    pub(in crate::gui) fn consult(&mut self, ctx: &egui::Context) {
        self.coach.take(Duration::ZERO);
        if ctx.input(|input| input.pointer.any_down()) || self.operations.motion.is_some() {
            return;
        }
        let asked = HealthRequest {
            camera: self.document.camera().clone(),
            scene: self.scene_cache.scene().clone(),
            style: self.document.figure().style,
            image: self.document.figure().image,
        };
        // The scene is not whole yet.
        if self.scene_cache.loading().is_empty() && self.coach.asked.as_ref() != Some(&asked) {
            self.coach.asked = Some(asked.clone());
            self.coach.worker.ask(ctx, 0, asked);
        }
    }

    /// Changes camera and style as a repair has it, as one step that can be undone.
    pub(in crate::gui) fn apply_repair(&mut self, Repair { camera, style }: Repair) {
        self.apply_camera(camera);
        self.document.edit(|figure| figure.style.shading = style.shading);
    }

    /// Applies a repair of the camera alone.
    pub(in crate::gui) fn apply_camera(&mut self, camera: Parameters) {
        self.document.commit();
        self.document.set_parameters(camera);
    }
}
