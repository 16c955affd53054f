//! The world: the scene, the camera in it, and the camera's view volume.

use crate::drawing::Drawing;
use crate::figure::Observer;
use crate::geometry::Aabb;
use crate::pipeline;

use super::observer::Preset;
use super::{Palette, Setup};

/// The observer that a button gives: it looks from the preset's side and has everything of interest in the picture.
#[must_use]
pub fn observer(setup: &Setup, preset: Preset) -> Observer {
    Observer::fit(Aabb { min: setup.camera.position(), max: setup.camera.focal_point() }, preset, setup.size.aspect())
}

/// Draws the world as `observer` sees it.
#[must_use]
pub fn draw(setup: &Setup, observer: &Observer) -> Drawing {
    let palette = Palette::of(setup.figure.style.theme);
    let bounds = setup.scene.objects.iter().filter_map(|o| o.mesh.bounds()).reduce(Aabb::union);
    let camera = observer.camera(bounds, setup.size.aspect());
    let camera = camera.as_ref().unwrap_or(setup.camera);
    pipeline::draw(setup.scene, camera, setup.size.target(palette.paper), &setup.figure.style)
}
