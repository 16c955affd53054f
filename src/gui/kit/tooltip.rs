//! Tooltips: their time, their place, and the titles of the notes that they cite.

use eframe::egui::{self, Id, LayerId, Rect, RectAlign, Response, Tooltip, Ui};

use super::theme;
use camera_lab_words::why::sources::with_titles;

/// The place of the tooltips of a panel.
#[derive(Clone, Copy)]
struct Beside {
    panel: Rect,
    layer: LayerId,
    align: RectAlign,
}

/// The margin of a panel's frame.
const MARGIN: f32 = 8.0;

fn key() -> Id {
    Id::unique("tooltips beside the panel")
}

/// From here on tooltips in this panel appear at its side and cover none of its other fields: `RIGHT_START` to its
/// right, `LEFT_START` to its left.
pub(in crate::gui) fn beside_panel(ui: &Ui, align: RectAlign) {
    let beside = Beside { panel: ui.max_rect(), layer: ui.layer_id(), align };
    ui.ctx().data_mut(|data| data.insert_temp(key(), beside));
}

/// Ends a panel. From here on, tooltips appear in any free room.
pub(in crate::gui) fn beside_nothing(ctx: &egui::Context) {
    ctx.data_mut(|data| data.remove::<Beside>(key()));
}

/// Shows a tooltip when the pointer rests on a control.
pub(in crate::gui) trait Explained {
    /// Shows `text`.
    fn explained(self, text: impl AsRef<str>) -> Self;

    /// Shows `text` if the control is greyed.
    fn explained_disabled(self, text: impl AsRef<str>) -> Self;

    /// Shows a tooltip with this content.
    fn explained_by(self, content: impl FnOnce(&mut Ui)) -> Self;
}

impl Explained for Response {
    fn explained(self, text: impl AsRef<str>) -> Self {
        let text = with_titles(text.as_ref());
        if text.is_empty() {
            return self;
        }
        describe(&self, &text);
        self.explained_by(|ui| drop(theme::sentence_label(ui, &text)))
    }

    fn explained_disabled(self, text: impl AsRef<str>) -> Self {
        show(&self, Tooltip::for_disabled(&self), |ui| drop(theme::sentence_label(ui, &with_titles(text.as_ref()))));
        self
    }

    fn explained_by(self, content: impl FnOnce(&mut Ui)) -> Self {
        // While the user drags something, they watch its effect.
        if self.ctx.dragged_id().is_none() {
            show(&self, Tooltip::for_enabled(&self), content);
        }
        self
    }
}

/// Shows `content` beside a control in every frame that calls it, in its row, so that no other row is covered.
pub(in crate::gui) fn beside(response: &Response, content: impl FnOnce(&mut Ui)) {
    let mut tooltip = Tooltip::always_open(response.ctx.clone(), response.layer_id, response.id, response.rect);
    tooltip.popup = tooltip.popup.align(RectAlign::RIGHT);
    show(response, tooltip, content);
}

/// Its description for screen readers, and its name if it has none.
fn describe(response: &Response, text: &str) {
    if !response.ctx.has_accesskit_node(response.id) {
        return;
    }
    response.ctx.accesskit_node_builder(response.id, |node| {
        if node.description().is_none() {
            node.set_description(text);
        }
        let is_named = node.label().is_some_and(|label| !label.is_empty()) || !node.labelled_by().is_empty();
        if node.role() != egui::accesskit::Role::Label && !is_named {
            node.set_label(text);
        }
    });
}

fn show(response: &Response, mut tooltip: Tooltip<'_>, content: impl FnOnce(&mut Ui)) {
    let ctx = &response.ctx;
    // A dialog has opened in front of it.
    if !ctx.memory(|memory| memory.is_above_modal_layer(response.layer_id)) {
        return;
    }
    let beside = ctx.data(|data| data.get_temp::<Beside>(key()));
    let in_panel = |beside: &Beside| beside.layer == response.layer_id && beside.panel.intersects(response.rect);
    if let Some(beside) = beside.filter(in_panel) {
        let place = Rect::from_x_y_ranges(beside.panel.x_range().expand(MARGIN), response.rect.y_range());
        tooltip.popup = tooltip.popup.anchor(place).align(beside.align);
    }
    tooltip.show(|ui| {
        // It has the width of every tooltip, because egui's own has that of the one before, and breaks numbers.
        ui.set_max_width(ui.spacing().tooltip_width);
        content(ui);
    });
}
