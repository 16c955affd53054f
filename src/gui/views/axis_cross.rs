//! The axes of the world in a corner of its view. Each one leads to the viewpoint that it points at.

use eframe::egui::{self, Align2, Color32, Id, Pos2, Rect, Sense, Stroke, TextStyle, Ui, WidgetInfo, vec2};
use glam::DVec3;

use crate::gui::kit::Explained;
use crate::views::observer::Viewpoint;
use camera_lab_desk::ObserverChange;
use camera_lab_words::window::canvas::CanvasTexts;

/// The length of an axis that lies in the plane of the picture, in points.
const LENGTH: f32 = 22.0;
/// The radius of the end of an axis.
const END: f32 = 8.0;
/// The distance from the corner of the picture to the middle of the cross.
const INSET: f32 = LENGTH + END + 6.0;
/// The cross is left out of a smaller picture.
const LEAST: [f32; 2] = [260.0, 170.0];

/// Draws the cross in the lower left corner of a picture. Returns the viewpoint of the clicked axis.
pub(super) fn show(
    ui: &Ui,
    rect: Rect,
    observer: &crate::figure::Observer,
    t: &CanvasTexts,
    look: crate::appearance::Theme,
) -> Option<ObserverChange> {
    if rect.width() < LEAST[0] || rect.height() < LEAST[1] {
        return None;
    }
    let [right, up, towards] = observer.axes();
    let middle = rect.left_bottom() + vec2(INSET, -INSET);
    let colors = crate::views::Palette::of(look).axes;
    let axes = [
        (DVec3::X, "x", Viewpoint::Side, t.side),
        (DVec3::Y, "y", Viewpoint::Top, t.top),
        (DVec3::Z, "z", Viewpoint::Front, t.front),
    ];
    let mut axes: Vec<_> = axes.into_iter().zip(colors).collect();
    // The nearer ones are drawn over the others.
    axes.sort_by(|((a, ..), _), ((b, ..), _)| a.dot(towards).total_cmp(&b.dot(towards)));
    let mut chosen = None;
    for ((axis, name, viewpoint, hint), color) in axes {
        #[expect(clippy::cast_possible_truncation, reason = "shares of a few points")]
        let way = vec2(axis.dot(right) as f32, -axis.dot(up) as f32) * LENGTH;
        let end: Pos2 = middle + way;
        let color = Color32::from_rgb(color.r, color.g, color.b);
        let place = Rect::from_center_size(end, vec2(2.0 * END, 2.0 * END));
        let response = ui.interact(place, Id::unique(("axis cross", name)), Sense::click());
        let label = format!("{} {name}", t.axis);
        response.widget_info(|| WidgetInfo::labeled(egui::accesskit::Role::Button, true, &label));
        ui.painter().line_segment([middle, end], Stroke::new(1.5, color));
        ui.painter().circle(end, END, ui.visuals().extreme_bg_color, Stroke::new(1.5, color));
        if response.hovered() || response.has_focus() {
            ui.painter().circle_filled(end, END, color.gamma_multiply(0.3));
        }
        let font = TextStyle::Small.resolve(ui.style());
        ui.painter().text(end, Align2::CENTER_CENTER, name, font, color);
        if response.explained(hint).clicked() {
            chosen = Some(ObserverChange::From(viewpoint));
        }
    }
    chosen
}
