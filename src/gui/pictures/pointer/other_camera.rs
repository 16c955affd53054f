//! Another camera of the figure under the pointer. A click looks through it.

use glam::DVec2;

use super::handle_drag;
use crate::gui::pictures::Pane;
use crate::sanitize::escaped;
use crate::views::{Request, View, camera_at};
use camera_lab_desk::Model;
use camera_lab_words::window::cameras;

/// The place in the list of the camera at the pointer (pixels).
pub(in crate::gui::pictures) fn hovered(request: &Request, pointer: DVec2, pane: &Pane) -> Option<usize> {
    let reach = pane.rect.pixels(handle_drag::REACH);
    camera_at(request, pointer, reach).filter(|_| pane.view == View::World)
}

/// Its name, and the effect of a click.
pub(in crate::gui::pictures) fn lines(index: usize, model: &Model) -> [String; 2] {
    let name = model.desk.shown.figure().cameras.get(index).map_or("", |other| &other.name);
    [escaped(name), cameras::texts(model.settings.lang).click.to_owned()]
}

/// Looks through the clicked camera. Returns false if there is none.
pub(in crate::gui::pictures) fn is_clicked(model: &mut Model, pane: &Pane) -> bool {
    let Some(place) = pane.response.interact_pointer_pos().filter(|place| pane.is_own(*place)) else { return false };
    let (request, pointer) = pane.under(place);
    let Some(index) = hovered(&request, pointer, pane) else { return false };
    model.look_through(index);
    true
}
