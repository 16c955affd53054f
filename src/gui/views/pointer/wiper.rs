//! The wiper between the two sides of a compared picture, and the content under the pointer on either side.

use eframe::egui::{CursorIcon, EventFilter, Id, Key, Pos2, Rect, Sense, Stroke, Ui, WidgetInfo, vec2};
use glam::DVec2;

use crate::gui::views::{Canvas, Pane};
use crate::views::{Request, Side};
use camera_lab_desk::Model;
use camera_lab_words::window::compare as words;

/// Half the width of the strip in which the pointer catches the wiper, and the radius of its handle, in points.
const REACH: f32 = 6.0;
const RADIUS: f32 = 9.0;
/// The share of the picture for one press of an arrow key, and with Shift.
const STEPS: [f64; 2] = [0.02, 0.1];

impl Pane {
    /// The side of a compared picture at a place. `None` if there is no comparison.
    pub(in crate::gui::views) fn side(&self, pointer: Pos2) -> Option<Side> {
        self.request.side_at(self.rect.pixel(pointer).x)
    }

    /// The same side as 0 or 1.
    pub(in crate::gui::views) fn side_index(&self, pointer: Pos2) -> Option<usize> {
        let [_, other] = self.request.sides()?;
        Some(usize::from(self.rect.pixel(pointer).x >= f64::from(other.columns.start)))
    }

    /// The picture at a place, and the place in its pixels. For a compared one, the side at that place.
    pub(in crate::gui::views) fn under(&self, pointer: Pos2) -> (Request, DVec2) {
        self.side_of(self.rect.pixel(pointer))
    }

    /// As [`under`](Self::under), for a place in the pixels of the whole picture.
    pub(in crate::gui::views) fn side_of(&self, pixel: DVec2) -> (Request, DVec2) {
        match self.request.side_at(pixel.x) {
            Some(side) => (side.request, pixel - DVec2::X * f64::from(side.left)),
            None => (self.request.clone(), pixel),
        }
    }

    /// True if the picture shows the figure's own camera in its full size, so that the camera can be dragged there.
    pub(in crate::gui::views) fn is_own(&self, pointer: Pos2) -> bool {
        self.side(pointer)
            .is_none_or(|side| side.request.size == self.request.size && side.request.camera == self.request.camera)
    }
}

impl Canvas {
    /// Shows the wiper of each picture that has one, and lets pointer and keys move it.
    pub(in crate::gui::views) fn wipers(ui: &Ui, model: &mut Model, panes: &[Pane]) {
        for pane in panes {
            let Some(compared) = pane.request.shot.compared.as_ref().filter(|compared| !compared.comparison.beside)
            else {
                continue;
            };
            let moved = wiper(ui, model, pane, compared.comparison.wiper);
            if let Some(share) = moved {
                model.desk.shown.edit(|figure| {
                    if let Some(comparison) = &mut figure.compare {
                        comparison.wiper = share;
                    }
                });
                ui.request_repaint();
            }
        }
    }
}

/// Shows a wiper. Returns its new place if it has been moved.
fn wiper(ui: &Ui, model: &Model, pane: &Pane, share: f64) -> Option<f64> {
    let words = words::texts(model.settings.lang);
    let Rect { min, max } = pane.rect.rect;
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let x = min.x + (max.x - min.x) * share as f32;
    let strip = Rect::from_min_max(Pos2::new(x - REACH, min.y), Pos2::new(x + REACH, max.y)).intersect(pane.rect.rect);
    let response = ui.interact(strip, Id::unique(("wiper", pane.picture)), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::slider(true, share, words.wiper));
    let response = response.on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
    let middle = Pos2::new(x, (min.y + max.y) / 2.0);
    let visuals = ui.style().interact(&response);
    let painter = ui.painter().with_clip_rect(pane.rect.rect);
    painter.circle(middle, RADIUS, visuals.bg_fill, Stroke::new(1.5, visuals.fg_stroke.color));
    for side in [-1.0, 1.0] {
        let tip = middle + vec2(side * 5.5, 0.0);
        for wing in [-2.5, 2.5] {
            painter.line_segment([tip, tip + vec2(-side * 2.5, wing)], Stroke::new(1.5, visuals.fg_stroke.color));
        }
    }
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    let mut moved = share;
    if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        moved = f64::from((pointer.x - min.x) / (max.x - min.x).max(1.0));
    }
    if response.has_focus() {
        painter.circle_stroke(middle, RADIUS + 2.5, Stroke::new(2.0, ui.visuals().hyperlink_color));
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: false, tab: false, escape: false };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        ui.input(|input| {
            let step = STEPS[usize::from(input.modifiers.shift)];
            let presses = |key| f64::from(u32::try_from(input.num_presses(key)).unwrap_or(0));
            moved += step * (presses(Key::ArrowRight) - presses(Key::ArrowLeft));
            for (key, place) in [(Key::Home, 0.0), (Key::End, 1.0)] {
                if input.key_pressed(key) {
                    moved = place;
                }
            }
        });
    }
    let moved = moved.clamp(0.0, 1.0);
    (moved.to_bits() != share.to_bits()).then_some(moved)
}
