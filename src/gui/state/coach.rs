//! The coach's findings about the figure: computed beside the window's thread, and anew only when their inputs have
//! changed.

use std::time::Duration;

use eframe::egui;

use super::State;
use crate::appearance::Style;
use crate::camera::{Camera, ImageSize, Parameters};
use crate::gui::memo::Latest;
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
    advice: Latest<HealthRequest, Advice>,
    /// The gap between two surfaces, in scene units, for the test whether they can be told apart.
    pub gap: f64,
}

impl Default for Coach {
    fn default() -> Self {
        let advice = Latest::new("coach", || {
            async |HealthRequest { camera, scene, style, image }: &HealthRequest, _: &Progress| Advice {
                camera: camera.clone(),
                diagnosis: diagnose(scene, camera, style, *image),
                health: health(camera, *image, scene.bounds()),
            }
        });
        Self { advice, gap: 0.01 }
    }
}

impl Coach {
    /// Takes results. Waits up to `patience`.
    pub fn take(&mut self, patience: Duration) {
        self.advice.poll(patience);
    }

    /// The advice for the last request; `None` until it is known.
    #[must_use]
    pub fn advice(&self) -> Option<&Advice> {
        self.advice.answer()
    }

    /// The advice, or the last one while changes since are being examined.
    #[must_use]
    pub fn newest_advice(&self) -> Option<&Advice> {
        self.advice.newest().map(|(_, advice)| advice)
    }
}

impl State {
    /// Has the coach look at the figure, where it has changed; not while the hand moves.
    pub(in crate::gui) fn consult(&mut self, ctx: &egui::Context) {
        self.coach.take(Duration::ZERO);
        if ctx.input(|input| input.pointer.any_down()) || self.operations.motion.is_some() {
            return;
        }
        // Until then the scene is not whole.
        if self.scene_cache.loading().is_empty() {
            let request = HealthRequest {
                camera: self.document.camera().clone(),
                scene: self.scene_cache.scene().clone(),
                style: self.document.figure().style,
                image: self.document.figure().image,
            };
            self.coach.advice.ask(ctx, request);
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
