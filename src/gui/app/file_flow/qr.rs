//! A link as a QR code over the whole window, so that a class gets the figure or the lesson on its telephones.

use eframe::egui::{self, Align2, Color32, Key, Modifiers, Rect, Sense, TextStyle, Ui, vec2};
use qrcode::{Color, EcLevel, QrCode};

use crate::gui::app::file_flow::link_dialog::Sharing;
use crate::gui::learn::Learn;
use camera_lab_words::window::sharing;

/// The free border around the code, in modules, as the standard requires.
const QUIET: usize = 4;

/// Fills the window with the code, dark on light in every theme, because cameras read nothing else well. `first` is
/// true when it has just been opened. Returns false once it's closed.
pub(in crate::gui) fn show(
    ctx: &egui::Context,
    model: &camera_lab_desk::Model,
    learn: &Learn,
    sharing: &mut Sharing,
    first: bool,
) -> bool {
    let t = sharing::texts(model.settings.lang);
    let link = sharing.link(model, learn, first).map(|(link, ..)| link);
    let code = link.as_ref().ok().and_then(|link| QrCode::with_error_correction_level(link, EcLevel::L).ok());
    let rect = ctx.content_rect();
    let mut closes = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
    let area = egui::Area::new(egui::Id::unique("qr code")).order(egui::Order::Foreground).fixed_pos(rect.min);
    area.show(ctx, |ui| {
        let response = ui.allocate_rect(rect, Sense::click());
        closes |= response.clicked();
        ui.painter().rect_filled(rect, 0.0, Color32::WHITE);
        match (&link, &code) {
            (Ok(link), Some(code)) => paint(ui, rect, code, link),
            _ => {
                let font = TextStyle::Heading.resolve(ui.style());
                ui.painter().text(rect.center(), Align2::CENTER_CENTER, t.too_long_for_code, font, Color32::BLACK);
            }
        }
        let label = code.as_ref().map_or(t.too_long_for_code, |_| t.code);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, label));
    });
    !closes
}

fn paint(ui: &Ui, rect: Rect, code: &QrCode, link: &str) {
    let font = TextStyle::Small.resolve(ui.style());
    let text = crate::sanitize::within(link, 90);
    let foot = ui.painter().text(
        rect.center_bottom() - vec2(0.0, 10.0),
        Align2::CENTER_BOTTOM,
        text,
        font,
        Color32::from_gray(0x40),
    );
    let modules = code.width() + 2 * QUIET;
    #[expect(clippy::cast_precision_loss, reason = "at most 185 modules")]
    let count = modules as f32;
    let room = (foot.top() - rect.top() - 8.0).min(rect.width());
    // Whole pixels for each module, because others would blur its border.
    let pixels = ui.ctx().pixels_per_point();
    let side = (room * pixels / count).floor().max(1.0) / pixels;
    let corner = egui::pos2(rect.center().x - 0.5 * side * count, rect.top() + 4.0);
    for y in 0..code.width() {
        for x in (0..code.width()).filter(|x| code[(*x, y)] == Color::Dark) {
            #[expect(clippy::cast_precision_loss, reason = "at most 185 modules")]
            let at = vec2((x + QUIET) as f32, (y + QUIET) as f32) * side;
            ui.painter().rect_filled(Rect::from_min_size(corner + at, vec2(side, side)), 0.0, Color32::BLACK);
        }
    }
}
