//! Small buttons with drawn signs, because no font has all of them, and they are the same in every language.

use eframe::egui::accesskit::Role;
use eframe::egui::{Painter, Pos2, Rect, Response, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2};

use crate::gui::kit::Explained;

/// The icon of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Icon {
    /// Four corners around a point.
    Fit,
    /// A cube.
    Iso,
    /// A large frame.
    Maximize,
    /// A small frame before another.
    Restore,
    /// A cross.
    Hide,
    /// Three frames.
    Arrange,
}

/// A square button as high as other buttons. `name` is its tooltip and its name for screen readers. `on` means that
/// it's switched on.
pub(super) fn icon_button(ui: &mut Ui, icon: Icon, name: &str, on: bool) -> Response {
    let side = ui.spacing().interact_size.y;
    let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click());
    if ui.is_rect_visible(rect) {
        let visuals = ui.style().interact_selectable(&response, on);
        if on || response.hovered() || response.has_focus() {
            let frame = rect.shrink(1.0);
            ui.painter().rect(frame, 3.0, visuals.weak_bg_fill, visuals.bg_stroke, StrokeKind::Inside);
        }
        draw(ui.painter(), icon, rect, Stroke::new(1.2 * side / 18.0, visuals.fg_stroke.color));
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    response.explained(name)
}

fn draw(painter: &Painter, icon: Icon, rect: Rect, stroke: Stroke) {
    let unit = rect.width() / 18.0;
    let at = |x: f32, y: f32| rect.center() + unit * vec2(x, y);
    let line = |points: &[Pos2]| {
        painter.add(Shape::line(points.to_vec(), stroke));
    };
    let frame = |a: Pos2, b: Pos2| {
        painter.rect_stroke(Rect::from_two_pos(a, b), 1.0, stroke, StrokeKind::Middle);
    };
    match icon {
        Icon::Fit => {
            for (sx, sy) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                line(&[at(5.5 * sx, 2.5 * sy), at(5.5 * sx, 5.5 * sy), at(2.5 * sx, 5.5 * sy)]);
            }
            painter.circle_filled(at(0.0, 0.0), 1.8 * unit, stroke.color);
        }
        Icon::Iso => cube(painter, rect, stroke),
        Icon::Maximize => frame(at(-5.0, -5.0), at(5.0, 5.0)),
        Icon::Restore => {
            frame(at(-5.0, -1.0), at(1.0, 5.0));
            line(&[at(-2.0, -1.0), at(-2.0, -5.0), at(5.0, -5.0), at(5.0, 2.0), at(1.0, 2.0)]);
        }
        Icon::Arrange => {
            frame(at(-6.0, -5.0), at(6.0, 0.0));
            frame(at(-6.0, 0.0), at(0.0, 5.0));
            frame(at(0.0, 0.0), at(6.0, 5.0));
        }
        Icon::Hide => {
            line(&[at(-4.5, -4.5), at(4.5, 4.5)]);
            line(&[at(4.5, -4.5), at(-4.5, 4.5)]);
        }
    }
}

/// A cube, seen from one of its corners.
fn cube(painter: &Painter, rect: Rect, stroke: Stroke) {
    let unit = rect.width() / 18.0;
    let at = |x: f32, y: f32| rect.center() + unit * vec2(x, y);
    let (hub, top, bottom) = (at(0.0, 0.0), at(0.0, -6.0), at(0.0, 6.0));
    let (left_top, left_low) = (at(-5.2, -3.0), at(-5.2, 3.0));
    let (right_top, right_low) = (at(5.2, -3.0), at(5.2, 3.0));
    let thin = Stroke { width: 0.8 * stroke.width, ..stroke };
    painter.add(Shape::closed_line(vec![top, right_top, right_low, bottom, left_low, left_top], thin));
    for corner in [left_top, right_top, bottom] {
        painter.line_segment([hub, corner], thin);
    }
}

/// The middle of a rectangle's left side, moved to the right.
pub(super) fn left_center(rect: Rect, inset: f32) -> Pos2 {
    pos2(rect.left() + inset, rect.center().y)
}
