//! The sizes of the camera's gear in the world.

use glam::DVec3;

use crate::camera::Camera;
use crate::figure::WorldLook;
use crate::views::screen::Screen;

/// The sizes of the camera's gear in scene units. They're fixed on the screen, so that the camera can be found in any
/// scene.
#[derive(Clone, Copy, Debug)]
pub(in crate::views) struct GizmoSizes {
    /// One unit of [`camera_body`](super::gizmos::camera_body).
    pub(in crate::views) body: f64,
    /// Length of **u**, **v**, **n**.
    pub(in crate::views) axis: f64,
    /// Their usual length, which is the measure for everything else beside the camera.
    pub(in crate::views) usual_axis: f64,
}

impl GizmoSizes {
    pub(in crate::views) fn new(screen: &Screen, camera: &Camera, look: &WorldLook) -> Self {
        let pixel = screen.units_per_pixel(camera.position());
        let (side, scale) = (screen.extent.min_element(), screen.scale);
        let axis_of = |length: f64| pixel * (0.12 * length * side).clamp(30.0 * scale, 180.0 * length.max(1.0) * scale);
        Self {
            body: pixel * (0.036 * side).clamp(9.0 * scale, 60.0 * scale),
            // Longer ones need no minimum length, which would push them out of a low picture.
            axis: axis_of(look.axes_length.unwrap_or(1.0)),
            usual_axis: axis_of(1.0),
        }
    }

    /// The tip of VUP's arrow.
    pub(in crate::views) fn view_up_tip(&self, camera: &Camera) -> DVec3 {
        let up = crate::geometry::try_unit(camera.view_up()).unwrap_or(DVec3::Y);
        camera.position() + up * (1.35 * self.axis)
    }

    /// Points around the camera that a picture of it must hold.
    pub(in crate::views) fn room(&self, camera: &Camera) -> [DVec3; 5] {
        let (c, basis) = (camera.position(), camera.basis());
        let out = 1.35 * self.axis;
        [self.view_up_tip(camera), c + basis.u * out, c + basis.v * out, c + basis.n * out, c - basis.v * (0.3 * out)]
    }
}
