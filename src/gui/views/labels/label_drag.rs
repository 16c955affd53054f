//! Dragging a label, and the keys that move it.

use eframe::egui::{Context, CursorIcon, Key, Modifiers, PointerButton, Pos2, Stroke, StrokeKind, Ui};
use glam::DVec2;

use crate::figure::labels::note_name;
use crate::figure::{Labels, Note, NotePlace};
use crate::gui::views::pointer::handle_drag;
use crate::gui::views::status::Status;
use crate::gui::views::{Canvas, Pane};
use crate::views::{LabelPlace, View, note_place};
use camera_lab_desk::Model;
use camera_lab_words::window::labels as words;

/// A held label.
pub(in crate::gui::views) struct LabelDrag {
    label: LabelPlace,
    view: View,
    /// From the pointer to the middle of the text, pixels.
    grip: DVec2,
    before: Labels,
}

impl LabelDrag {
    /// Takes the label at `from` (pixels), if one is there.
    pub(in crate::gui::views) fn taken(labels: &[LabelPlace], view: View, from: DVec2, model: &Model) -> Option<Self> {
        let label = label_at(labels, from)?.clone();
        let grip = label.center - from;
        Some(Self { label, view, grip, before: model.desk.shown.figure().labels.clone() })
    }

    /// The label follows the pointer (pixels).
    pub(in crate::gui::views) fn follow(&self, model: &mut Model, to: DVec2, ctx: &Context) {
        let by = self.label.moved_to(to + self.grip);
        model.label_mode.choose(Some((self.view, self.label.name.clone())));
        if model.desk.shown.figure().labels.change(&self.label.name, self.view).by != Some(by) {
            model.desk.shown.edit_labels(|labels| labels.move_to(&self.label.name, self.view, by));
            ctx.request_repaint();
        }
    }

    /// Puts it back in its former place.
    pub(in crate::gui::views) fn give_up(self, model: &mut Model) {
        model.desk.shown.edit_labels(|labels| *labels = self.before);
    }

    /// Its text, and its distance from its point.
    pub(in crate::gui::views) fn line(&self, model: &Model) -> String {
        let mark = model.settings.lang.mark();
        let by = model.desk.shown.figure().labels.change(&self.label.name, self.view).by.unwrap_or_default();
        let [x, y] = by.to_array().map(|v| mark.number(v, 3));
        format!("{}: ({x}, {y}) em", crate::sanitize::escaped(&self.label.text))
    }
}

fn label_at(labels: &[LabelPlace], place: DVec2) -> Option<&LabelPlace> {
    // The label laid out last is on top.
    labels.iter().rev().find(|label| label.holds(place))
}

impl Canvas {
    /// Shows the possible actions for the label under the pointer.
    pub(in crate::gui::views) fn label_hover(
        &self,
        ui: &Ui,
        model: &Model,
        pane: &Pane,
        place: Pos2,
        status: &mut Status,
    ) {
        let t = words::texts(model.settings.lang);
        status.message = if model.label_mode.adding { t.adding } else { t.idle }.to_owned();
        if model.label_mode.adding {
            ui.set_cursor_icon(CursorIcon::Crosshair);
        } else if label_at(&self.pictures[pane.picture].labels, pane.rect.pixel(place)).is_some() {
            ui.set_cursor_icon(CursorIcon::Grab);
        }
    }

    /// A click chooses a label, or puts a note.
    pub(in crate::gui::views) fn label_click(&self, model: &mut Model, pane: &Pane) {
        let response = &pane.response;
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        let is_click = response.clicked_by(PointerButton::Primary) || response.clicked_by(PointerButton::Secondary);
        let Some(place) = response.interact_pointer_pos().filter(|_| is_click) else { return };
        let pixel = pane.rect.pixel(place);
        if model.label_mode.adding {
            add_note(model, pane, pixel);
        } else {
            let label = label_at(&self.pictures[pane.picture].labels, pixel);
            model.label_mode.choose(label.map(|label| (pane.view, label.name.clone())));
        }
        response.ctx.request_repaint();
    }

    /// Lets the arrow keys move the chosen label, Delete hide it, and Enter put a note. Returns true if this key did.
    pub(in crate::gui::views) fn label_by_key(
        &self,
        model: &mut Model,
        pane: &Pane,
        key: Key,
        modifiers: Modifiers,
    ) -> bool {
        if !model.label_mode.on {
            return false;
        }
        if model.label_mode.adding && key == Key::Enter {
            let size = pane.rect.size;
            add_note(model, pane, 0.5 * DVec2::new(f64::from(size.width), f64::from(size.height)));
            return true;
        }
        if matches!(key, Key::Delete | Key::Backspace)
            && let Some((_, name)) = model.label_mode.chosen.take()
        {
            model.desk.shown.edit_labels(|labels| labels.hide(&name));
            return true;
        }
        let arrow = arrow_of(key);
        let Some((_, name)) = model.label_mode.chosen.clone().filter(|_| arrow != DVec2::ZERO) else { return false };
        let labels = &self.pictures[pane.picture].labels;
        let Some(label) = labels.iter().find(|label| label.name == name) else { return false };
        let step = if modifiers.shift { 1.0 } else { 0.25 } * label.em;
        let by = label.moved_to(label.center + DVec2::new(arrow.x, -arrow.y) * step);
        model.desk.shown.edit_labels(|labels| labels.move_to(&name, pane.view, by));
        true
    }

    /// Frames around the labels that can be dragged, and around the chosen one.
    pub(in crate::gui::views) fn outline_labels(&self, ui: &Ui, model: &Model, panes: &[Pane]) {
        if !model.label_mode.on {
            return;
        }
        for pane in panes {
            let hovered = pane.response.hover_pos().map(|place| pane.rect.pixel(place));
            let painter = ui.painter().with_clip_rect(pane.rect.rect);
            for label in &self.pictures[pane.picture].labels {
                let [corner, size] = [label.center - label.half, 2.0 * label.half];
                #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
                let [x, y, w, h] = [corner.x, corner.y, size.x, size.y].map(|v| v as f32);
                let rect = pane.rect.rect_of(x, y, w, h).expand(1.0);
                let is_chosen = model.label_mode.chosen.as_ref().is_some_and(|(_, name)| *name == label.name);
                let stroke = if is_chosen {
                    Stroke::new(2.0, ui.visuals().hyperlink_color)
                } else if hovered.is_some_and(|place| label.holds(place)) {
                    Stroke::new(1.5, ui.visuals().hyperlink_color)
                } else {
                    Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.6))
                };
                painter.rect_stroke(rect, 2.0, stroke, StrokeKind::Outside);
            }
        }
    }
}

/// Puts a note at a place (pixels) of a picture, and chooses it.
fn add_note(model: &mut Model, pane: &Pane, pixel: DVec2) {
    model.label_mode.adding = false;
    let count = model.desk.shown.figure().labels.notes.len();
    if count >= crate::limits::MAX_LABELS {
        return;
    }
    // The other side of a comparison may be under the pointer.
    let (request, place) = pane.side_of(pixel);
    let at = note_place(&request, place, pane.rect.pixels(handle_drag::REACH));
    let view = matches!(at, NotePlace::Picture(_)).then_some(pane.view);
    let text = words::texts(model.settings.lang).note.to_owned();
    let note = Note { view, at, by: None, text, size: None, color: None };
    model.desk.shown.edit_labels(|labels| labels.notes.push(note));
    model.label_mode.choose(Some((pane.view, note_name(count))));
    model.label_mode.is_new = true;
}

/// The direction of an arrow key, x right and y up. Zero for any other key.
pub(in crate::gui::views) fn arrow_of(key: Key) -> DVec2 {
    match key {
        Key::ArrowRight => DVec2::X,
        Key::ArrowLeft => DVec2::NEG_X,
        Key::ArrowUp => DVec2::Y,
        Key::ArrowDown => DVec2::NEG_Y,
        _ => DVec2::ZERO,
    }
}
