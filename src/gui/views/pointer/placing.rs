//! A question for a place in the image: a cross that a click, a drag or the arrow keys put there, and beside it the
//! guess and the right place, once they may be shown.

use eframe::egui::{Align2, Color32, CursorIcon, Key, Modifiers, Stroke, TextStyle, Ui, vec2};
use glam::DVec2;

use crate::gui::views::image_place::ImagePlace;
use crate::gui::views::labels::label_drag::arrow_of;
use crate::gui::views::{Canvas, Pane};
use crate::views::{View, pick};
use camera_lab_desk::Placing;

/// Half a side of the cross, and the radius of the rings, in points.
const CROSS: f32 = 11.0;
const RING: f32 = 7.0;
/// Pixels of the image for one press of an arrow key with Shift.
const FAST: f64 = 10.0;

impl Canvas {
    /// Puts the cross under the pointer, if a question asks for a place. Returns false if none does.
    pub(in crate::gui::views) fn place(ui: &Ui, pane: &Pane, placing: Option<&mut Placing>) -> bool {
        let Some(placing) = placing.filter(|placing| placing.is_open && pane.view == View::Image) else { return false };
        let response = &pane.response;
        if response.hovered() {
            ui.set_cursor_icon(CursorIcon::Crosshair);
        }
        let is_held = response.clicked() || response.is_pointer_button_down_on();
        let pointer = response.interact_pointer_pos().filter(|_| is_held);
        let on_window = pointer.and_then(|at| pick::window_point_in_image(&pane.request, pane.rect.pixel(at)));
        if let Some(point) = on_window {
            let request = &pane.request;
            let place = request.shot.look.image.image_from_window(&request.camera.window(), point);
            response.request_focus();
            placing.mark = Some(place.round().to_array());
        }
        true
    }

    /// Moves the cross by an arrow key. Returns true if it was one.
    pub(in crate::gui::views) fn place_by_key(
        placing: Option<&mut Placing>,
        pane: &Pane,
        key: Key,
        held: Modifiers,
    ) -> bool {
        let arrow = arrow_of(key);
        let placing = placing.filter(|placing| placing.is_open && pane.view == View::Image);
        let Some(placing) = placing.filter(|_| arrow != DVec2::ZERO) else { return false };
        let image = pane.request.shot.look.image;
        let sides = DVec2::new(f64::from(image.width), f64::from(image.height));
        let from = placing.mark.map_or(0.5 * sides, DVec2::from_array);
        let step = if held.shift { FAST } else { 1.0 };
        let to = from + step * DVec2::new(arrow.x, -arrow.y);
        placing.mark = Some(to.clamp(DVec2::ZERO, sides).round().to_array());
        true
    }

    /// Draws the marks of a question for a place.
    pub(in crate::gui::views) fn marks(ui: &Ui, placing: Option<&Placing>, panes: &[Pane]) {
        let Some(placing) = placing else { return };
        for pane in panes.iter().filter(|pane| pane.view == View::Image) {
            let (dark, visuals) = (Color32::from_black_alpha(160), ui.visuals());
            let shown = ImagePlace::of(pane);
            let on_screen = |place: [f64; 2]| shown.on_screen(DVec2::from_array(place));
            let painter = ui.painter().with_clip_rect(pane.rect.rect);
            let [mine, right] = [Color32::from_rgb(0xff, 0xa5, 0x20), Color32::from_rgb(0x4c, 0xd0, 0x6a)];
            let mut gap = None;
            if let (Some(guess), Some(place)) = (placing.guess, placing.right) {
                let ends = [guess, place].map(on_screen);
                painter.line_segment(ends, Stroke::new(1.5, mine));
                gap = Some((ends[0].lerp(ends[1], 0.5), DVec2::from_array(guess).distance(DVec2::from_array(place))));
            }
            let rings = [(placing.guess, mine), (placing.right, right), (placing.second, right)];
            for (at, color) in rings.into_iter().filter_map(|(at, color)| Some((at?, color))) {
                let at = on_screen(at);
                painter.circle_stroke(at, RING, Stroke::new(4.0, dark));
                painter.circle_stroke(at, RING, Stroke::new(2.0, color));
            }
            // Over the rings, with the length in pixels of the image.
            if let Some((middle, length)) = gap.filter(|(_, length)| *length >= 1.0) {
                let font = TextStyle::Body.resolve(ui.style());
                let galley = painter.layout_no_wrap(format!("{length:.0} px"), font, visuals.text_color());
                let room = Align2::CENTER_CENTER.anchor_size(middle, galley.size());
                painter.rect_filled(room.expand(2.0), 3.0, visuals.panel_fill);
                painter.galley(room.min, galley, visuals.text_color());
            }
            if let Some(from) = placing.from {
                let at = on_screen(from);
                let font = TextStyle::Heading.resolve(ui.style());
                painter.circle_filled(at, 4.5, Color32::WHITE);
                painter.circle_filled(at, 3.0, dark);
                painter.text(at + vec2(8.0, -4.0), Align2::LEFT_BOTTOM, "M", font, right);
            }
            if let Some(mark) = placing.mark.filter(|_| placing.right.is_none() || placing.is_open) {
                let at = on_screen(mark);
                for (width, color) in [(4.0, dark), (2.0, mine)] {
                    let stroke = Stroke::new(width, color);
                    painter.hline(at.x - CROSS..=at.x + CROSS, at.y, stroke);
                    painter.vline(at.x, at.y - CROSS..=at.y + CROSS, stroke);
                }
            } else if placing.is_open && placing.mark.is_none() && placing.guess.is_none() {
                let font = TextStyle::Body.resolve(ui.style());
                let place = pane.rect.rect.center_top() + vec2(0.0, 8.0);
                let galley = painter.layout_no_wrap(placing.hint.to_owned(), font, visuals.text_color());
                let room = Align2::CENTER_TOP.anchor_size(place, galley.size());
                painter.rect_filled(room.expand(4.0), 3.0, visuals.panel_fill);
                painter.galley(room.min, galley, visuals.text_color());
            }
        }
    }
}
