//! What can be taken with the pointer in the world: where it is on the screen, and what dragging it does.

use glam::DVec2;

use crate::camera::Parameters;
use crate::figure::Observer;

use super::Setup;

/// Something that can be dragged in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// C
    Position,
    /// PF
    FocalPoint,
    /// The tip of VUP.
    ViewUp,
    /// The front face.
    Near,
    /// The back face.
    Far,
}

/// The handles that lie in the picture, with their places in pixels.
#[must_use]
pub fn handles(_setup: &Setup, _observer: &Observer) -> Vec<(Handle, DVec2)> {
    Vec::new()
}

/// The handle at `pointer` (pixels), within `reach` pixels.
#[must_use]
pub fn handle_at(setup: &Setup, observer: &Observer, pointer: DVec2, reach: f64) -> Option<Handle> {
    let near = |p: &DVec2| p.distance(pointer);
    handles(setup, observer)
        .into_iter()
        .filter(|(_, p)| near(p) <= reach)
        .min_by(|a, b| near(&a.1).total_cmp(&near(&b.1)))
        .map(|(handle, _)| handle)
}

/// The camera parameters after `handle` was taken at `from` and is now at `to` (pixels), beginning with the camera of `setup`,
/// which must be the one at the time of taking. C and PF move on the plane y = their own height, or vertically; near and far
/// along the axis.
#[must_use]
pub fn drag(
    setup: &Setup,
    _observer: &Observer,
    _handle: Handle,
    _from: DVec2,
    _to: DVec2,
    _vertical: bool,
) -> Parameters {
    *setup.camera.parameters()
}
