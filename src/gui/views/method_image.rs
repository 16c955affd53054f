//! The image of a way to draw the figure, beside the exact one, over the view of the image.

use std::sync::Arc;

use eframe::egui::{
    Align2, Color32, ColorImage, CursorIcon, Id, Pos2, Rect, Sense, Stroke, TextStyle, TextureHandle, TextureOptions,
    Ui, WidgetInfo, pos2,
};

use super::{Canvas, Pane};
use crate::picture::Pixels;
use crate::views::{View, image_frame};
use camera_lab_desk::{MethodImage, Model};
use camera_lab_words::why::this_figure as words;

/// Half the width of the strip in which the pointer catches the divider, in points.
const REACH: f32 = 6.0;

/// The textures of the last image, and the place of the divider.
pub(super) struct MethodPane {
    image: Option<(Arc<MethodImage>, [TextureHandle; 2])>,
    share: f32,
}

impl Default for MethodPane {
    fn default() -> Self {
        Self { image: None, share: 0.5 }
    }
}

impl Canvas {
    /// Shows the image of a way to draw, if the study of the figure asks for it: the exact image to the left of a
    /// divider, the way's own to its right.
    pub(super) fn method_image(&mut self, ui: &Ui, model: &mut Model, panes: &[Pane]) {
        let wanted = model.frame.method_image.take();
        let Some((image, pane)) = wanted.zip(panes.iter().find(|pane| pane.view == View::Image)) else { return };
        let method = &mut self.method;
        if method.image.as_ref().is_none_or(|(shown, _)| !Arc::ptr_eq(shown, &image)) {
            let texture = |name: &str, pixels: &Pixels| {
                let size = [pixels.width() as usize, pixels.height() as usize];
                let pixels = ColorImage::from_rgba_premultiplied(size, pixels.rgba());
                ui.ctx().load_texture(name, pixels, TextureOptions::LINEAR)
            };
            let textures = [texture("exact image", &image.exact), texture("method image", &image.drawn)];
            method.image = Some((image, textures));
        }
        let Some((_, textures)) = &method.image else { return };
        let shot = &pane.request.shot;
        let frame = image_frame(pane.rect.size, shot.look.image_aspect(&pane.request.camera));
        let [x, y, width, height] = [frame.x, frame.y, frame.width, frame.height].map(|v| v as f32);
        let rect = pane.rect.rect_of(x, y, width, height);
        let painter = ui.painter().with_clip_rect(rect);
        let across = |share: f32| rect.left() + share * rect.width();
        for (texture, [from, to]) in textures.iter().zip([[0.0, method.share], [method.share, 1.0]]) {
            let part = Rect::from_min_max(pos2(across(from), rect.top()), pos2(across(to), rect.bottom()));
            let uv = Rect::from_min_max(pos2(from, 0.0), pos2(to, 1.0));
            painter.image(texture.id(), part, uv, Color32::WHITE);
        }
        let t = words::texts(model.settings.lang);
        let visuals = ui.visuals();
        let middle = across(method.share);
        painter.vline(middle, rect.y_range(), Stroke::new(1.5, visuals.strong_text_color()));
        for (text, at, anchor) in [
            (t.exact, pos2(middle - 6.0, rect.top() + 4.0), Align2::RIGHT_TOP),
            (t.drawn, pos2(middle + 6.0, rect.top() + 4.0), Align2::LEFT_TOP),
        ] {
            let text =
                painter.layout_no_wrap(text.to_owned(), TextStyle::Body.resolve(ui.style()), visuals.text_color());
            let place = anchor.anchor_size(at, text.size());
            painter.rect_filled(place.expand(2.0), 2.0, visuals.window_fill());
            painter.galley(place.min, text, visuals.text_color());
        }
        let strip = Rect::from_x_y_ranges(middle - REACH..=middle + REACH, rect.y_range());
        let response = ui.interact(strip, Id::unique("method divider"), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::slider(true, f64::from(method.share), t.divider));
        let response = response.on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
        if let Some(Pos2 { x, .. }) = response.interact_pointer_pos().filter(|_| response.dragged()) {
            method.share = ((x - rect.left()) / rect.width().max(1.0)).clamp(0.0, 1.0);
        }
    }
}
