//! Taking C, PF, VUP and the clipping planes in the world with the pointer.

use eframe::egui::{CursorIcon, Modifiers};
use glam::{DVec2, DVec3};

use crate::camera::{Camera, CameraError, ParameterKey, Parameters};
use crate::inspect::Asked;
use crate::inspect::quantity::Quantity;
use crate::views::{Handle, Request, handles};
use camera_lab_words::window;
use camera_lab_words::window::canvas::CanvasTexts;

/// Distance within which the pointer catches a handle, in points.
pub(in crate::gui) const REACH: f32 = 10.0;

/// A held handle.
#[derive(Clone, Debug)]
pub(in crate::gui) struct HandleDrag {
    pub(super) handle: Handle,
    /// The picture and the pointer (pixels) from which the motion is measured. They are those of the press, or, with
    /// the camera of the moment, those in which the modifier changed.
    pressed: Request,
    from: DVec2,
    vertical: bool,
    /// The camera that Esc restores.
    pub(super) before: Camera,
    /// The reason why the handle doesn't follow the pointer.
    pub(super) stopped: Option<CameraError>,
}

impl HandleDrag {
    /// Takes a handle at `from` (pixels).
    pub(in crate::gui) fn new(handle: Handle, pressed: Request, from: DVec2, modifiers: Modifiers) -> Self {
        let before = pressed.camera.clone();
        Self { handle, pressed, from, vertical: vertical(modifiers), before, stopped: None }
    }

    /// The parameters with the pointer at `to` (pixels). `None` if they aren't a camera. Then the last one stays and
    /// [`HandleDrag::stopped`] gives the reason.
    pub(in crate::gui) fn moved(&mut self, now: &Request, to: DVec2, modifiers: Modifiers) -> Option<Parameters> {
        if self.vertical != vertical(modifiers) {
            self.vertical = !self.vertical;
            self.pressed.camera = now.camera.clone();
            self.from = to;
        }
        let parameters = handles::drag(&self.pressed, self.handle, self.from, to, self.vertical);
        if let Err(error) = Camera::new(&parameters) {
            self.stopped = Some(error);
            return None;
        }
        // The planes stop just before each other, so that they are still a camera.
        let touching = matches!(self.handle, Handle::Near | Handle::Far) && parameters.far <= 1.011 * parameters.near;
        let (near, far) = (parameters.near, parameters.near);
        self.stopped = touching.then_some(CameraError::FarNotBeyondNear { near, far });
        Some(parameters)
    }
}

/// True if a point is to move up and down.
fn vertical(modifiers: Modifiers) -> bool {
    modifiers.shift || modifiers.command || modifiers.ctrl
}

/// The name and place of a handle, such as `C = (3, 4, 5)`. Its name alone while a question asks for the place.
pub(in crate::gui) fn readout(
    handle: Handle,
    camera: &Camera,
    digits: usize,
    (asked, texts): (&Asked, &CanvasTexts),
) -> String {
    let mark = texts.lang.mark();
    let (key, name, values) = match handle {
        Handle::Position => (ParameterKey::Position, "C", camera.position().to_array().to_vec()),
        Handle::FocalPoint => (ParameterKey::FocalPoint, "PF", camera.focal_point().to_array().to_vec()),
        Handle::ViewUp => (ParameterKey::ViewUp, "VUP", camera.view_up().to_array().to_vec()),
        Handle::Near => (ParameterKey::Near, "F", vec![camera.near()]),
        Handle::Far => (ParameterKey::Far, "B", vec![camera.far()]),
    };
    if asked.hides(&[Quantity::Camera(key)], &values) {
        return format!("{name}: {}", window::texts(texts.lang).asked_here);
    }
    match handle {
        Handle::Position => format!("C = {}", point(camera.position(), digits, mark)),
        Handle::FocalPoint => format!("PF = {}", point(camera.focal_point(), digits, mark)),
        Handle::ViewUp => format!("VUP = {}", point(camera.view_up(), digits, mark)),
        Handle::Near => format!("F = {} ({})", mark.number(camera.near(), digits), window::texts(texts.lang).near),
        Handle::Far => format!("B = {} ({})", mark.number(camera.far(), digits), window::texts(texts.lang).far),
    }
}

/// The hint for dragging a handle.
pub(in crate::gui) fn hint(handle: Handle, camera: &Camera, digits: usize, texts: &CanvasTexts) -> String {
    let on_plane =
        |y: f64| format!("{} {} · {}", texts.drag_on_plane, texts.lang.mark().number(y, digits), texts.drag_vertically);
    match handle {
        Handle::Position => on_plane(camera.position().y),
        Handle::FocalPoint => on_plane(camera.focal_point().y),
        Handle::ViewUp => texts.drag_up.to_owned(),
        Handle::Near | Handle::Far => texts.drag_along_axis.to_owned(),
    }
}

/// The cursor over a handle, or while it's held.
pub(in crate::gui) fn cursor(held: bool) -> CursorIcon {
    if held { CursorIcon::Grabbing } else { CursorIcon::Grab }
}

/// A point in the notation of the whole window.
pub(in crate::gui) fn point(p: DVec3, digits: usize, mark: crate::numbers::DecimalMark) -> String {
    mark.tuple(&p.to_array(), digits)
}
