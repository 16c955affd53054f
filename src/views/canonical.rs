//! The canonical volume: the scene after clipping and projection, in the cube \[−1, 1\]³.

use glam::DVec3;

use crate::drawing::Drawing;
use crate::figure::Observer;
use crate::geometry::Aabb;
use crate::pipeline;

use super::observer::Preset;
use super::{Palette, Setup};

/// The observer that a button gives: it looks from the preset's side and has the cube in the picture.
#[must_use]
pub fn observer(setup: &Setup, preset: Preset) -> Observer {
    Observer::fit(Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE }, preset, setup.size.aspect())
}

/// Draws the canonical volume as `observer` sees it.
#[must_use]
pub fn draw(setup: &Setup, observer: &Observer) -> Drawing {
    let palette = Palette::of(setup.figure.style.theme);
    let camera = observer.camera(None, setup.size.aspect());
    let camera = camera.as_ref().unwrap_or(setup.camera);
    pipeline::draw(setup.scene, camera, setup.size.target(palette.paper), &setup.figure.style)
}
