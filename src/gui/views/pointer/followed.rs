//! Drags a followed point, in the world and in the image.

use eframe::egui::Context;
use glam::{DVec2, DVec3};

use crate::gui::views::Pane;
use crate::gui::views::pointer::handle_drag;
use crate::views::{Request, named_points};
use camera_lab_desk::Model;
use camera_lab_words::why::explain_point;

/// A held point.
pub(in crate::gui::views) struct PointDrag {
    index: usize,
    before: DVec3,
    /// The picture and the pointer (pixels) from which the motion is measured.
    pressed: Request,
    from: DVec2,
}

impl PointDrag {
    /// Takes the point at `from` (pixels), if one is there.
    pub(in crate::gui::views) fn taken(pressed: Request, from: DVec2, pane: &Pane) -> Option<Self> {
        let index = named_points::point_at(&pressed, from, pane.rect.pixels(handle_drag::REACH))?;
        let before = pressed.shot.points.get(index)?.position;
        Some(Self { index, before, pressed, from })
    }

    /// The point follows the pointer (pixels).
    pub(in crate::gui::views) fn follow(&self, model: &mut Model, to: DVec2, ctx: &Context) {
        let Some(moved) = named_points::dragged(&self.pressed, self.before, self.from, to) else { return };
        let Some(point) = model.desk.shown.figure().points.get(self.index) else { return };
        if point.position == moved {
            return;
        }
        let name = point.name.clone();
        if model.follow.index(&model.desk.shown.figure().points) != Some(self.index) {
            model.follow.choose(&name);
        }
        model.move_point(self.index, moved);
        ctx.request_repaint();
    }

    /// Puts it back in its former place.
    pub(in crate::gui::views) fn give_up(&self, model: &mut Model) {
        model.move_point(self.index, self.before);
    }

    /// Its position, and the way to drag it.
    pub(in crate::gui::views) fn lines(&self, model: &Model) -> Vec<String> {
        lines(self.index, model)
    }
}

/// The point under the pointer, and its status lines.
pub(in crate::gui::views) fn hovered(
    request: &Request,
    pointer: DVec2,
    pane: &Pane,
    model: &Model,
) -> Option<(DVec3, Vec<String>)> {
    let index = named_points::point_at(request, pointer, pane.rect.pixels(handle_drag::REACH))?;
    Some((request.shot.points.get(index)?.position, lines(index, model)))
}

fn lines(index: usize, model: &Model) -> Vec<String> {
    let (lang, digits) = (model.settings.lang, model.settings.digits.min(6));
    let Some(point) = model.desk.shown.figure().points.get(index) else { return Vec::new() };
    let place = handle_drag::point(point.position, digits, lang.mark());
    vec![
        format!("{} = {place}", crate::sanitize::escaped(&point.name)),
        explain_point::texts(lang).drag_point.to_owned(),
    ]
}
