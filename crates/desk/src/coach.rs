//! The coach's findings about the figure. They are computed beside the window's thread, and again only if their inputs
//! have changed.

use std::time::Duration;

use crate::background::memo::Latest;
use crate::camera::{Camera, ImageSize, Parameters};
use crate::figure::{Figure, Reveal};
use crate::model::Model;
use crate::numerics::diagnosis::{
    Cause, Diagnosis, IN_A_WINDOW, ImageSpec, ImpossibleCamera, Repair, diagnose, impossible_camera,
};
use crate::numerics::health::{Health, health};
use camera_lab_words::window::coach;

/// The inputs of the findings.
#[derive(Clone, Debug, PartialEq)]
struct HealthRequest {
    camera: Camera,
    scene: crate::views::SharedScene,
    style: crate::appearance::Style,
    reveal: Reveal,
    image: ImageSize,
    /// Parameters in the fields that aren't a camera.
    impossible: Option<ImpossibleCamera>,
}

/// The faults of the picture, and the health of the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// The camera examined.
    pub camera: Camera,
    /// `None` if the image is too large to draw.
    pub diagnosis: Option<Diagnosis>,
    /// Six quantities. None for an impossible camera.
    pub health: Vec<Health>,
}

/// The coach.
#[derive(Debug)]
pub struct Coach {
    advice: Latest<HealthRequest, Advice>,
}

impl Default for Coach {
    fn default() -> Self {
        let advice = Latest::new("coach", || {
            async |request: &HealthRequest, progress: &crate::progress::Progress| {
                let HealthRequest { camera, scene, style, reveal, image, impossible } = request;
                if let Some(impossible) = impossible {
                    let diagnosis = Some(impossible_camera(impossible, scene));
                    return Advice { camera: camera.clone(), diagnosis, health: Vec::new() };
                }
                let spec = ImageSpec { scene, camera, style, reveal, image: *image, compared: IN_A_WINDOW };
                Advice {
                    camera: camera.clone(),
                    diagnosis: diagnose(&spec, progress).await.ok(),
                    health: health(camera, style.depth_format, *image, scene.bounds()),
                }
            }
        });
        Self { advice }
    }
}

impl Coach {
    /// Takes results. Waits up to `patience`.
    pub fn take(&mut self, patience: Duration) {
        self.advice.poll(patience);
    }

    /// The advice for the last request. `None` until it's known.
    pub fn advice(&self) -> Option<&Advice> {
        self.advice.answer()
    }

    /// The advice, or the last one while changes since are being examined.
    pub fn newest_advice(&self) -> Option<&Advice> {
        self.advice.newest().map(|(_, advice)| advice)
    }
}

impl Model {
    /// Makes the coach examine the figure, if it has changed, but not during a move or while a pointer button is down.
    pub fn check_camera(&mut self, window: &dyn crate::Wake, is_down: bool) {
        self.coach.take(Duration::ZERO);
        if is_down || self.motion.is_some() {
            return;
        }
        // Until then the scene isn't whole.
        if self.scene_cache.loading().is_empty() {
            let Figure { style, reveal, image, .. } = *self.desk.shown.figure();
            let impossible = self.desk.shown.problem().cloned().map(|error| ImpossibleCamera {
                error,
                parameters: *self.desk.shown.draft(),
                style,
                reveal,
                image,
            });
            let (camera, scene) = (self.desk.shown.camera().clone(), self.scene_cache.scene().clone());
            let request = HealthRequest { camera, scene, style, reveal, image, impossible };
            self.coach.advice.ask(window, request);
        }
    }

    /// True if nothing is visible although the scene isn't empty. With an impossible camera the last good image stays,
    /// and a photograph without a scene is an image too.
    pub fn is_image_empty(&self, diagnosis: &Diagnosis) -> bool {
        let is_photograph = self.scene_cache.scene().photograph.is_some()
            && diagnosis.findings.iter().all(|finding| finding.cause == Cause::EmptyScene);
        diagnosis.visible == 0 && diagnosis.camera_error.is_none() && !is_photograph
    }

    /// The changes of a repair, in symbols.
    pub fn changes_of(&self, repair: &Repair) -> String {
        // The numbers in the fields, which may not be a camera.
        let camera = *self.desk.shown.draft();
        let figure = Figure { camera, ..self.desk.shown.figure().without_scene() };
        coach::changes_in_symbols(self.settings.lang, &repair.changes(&figure))
    }

    /// Applies a repair to the figure, as one step that can be undone.
    pub fn apply_repair(&mut self, repair: Repair) {
        self.apply_camera(repair.camera);
        self.desk.shown.edit(|figure| repair.apply(figure));
    }

    /// Applies a repair of the camera alone.
    pub fn apply_camera(&mut self, camera: Parameters) {
        self.desk.commit();
        self.desk.shown.set_parameters(camera);
    }
}
