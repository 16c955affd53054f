//! Windows as narrow as a telephone, or as a tablet held upright: one picture, panels from below, and controls as large
//! as a finger.

use eframe::egui::{Context, Panel, Rangef, vec2};

use super::theme;

/// Below this width, in points, there is room for one picture only, and none for menus beside the switches.
pub(in crate::gui) const PHONE: f32 = 600.0;
/// Below this width there is, if the window is higher than wide.
const TABLET: f32 = 900.0;
/// The least height of a control for a finger, in points.
const FINGER: f32 = 44.0;

/// True for such a window.
pub(in crate::gui) fn is_handheld(ctx: &Context) -> bool {
    let window = ctx.content_rect().size();
    window.x < PHONE || window.x < TABLET.min(window.y)
}

/// Makes controls as large as such a window needs them.
pub(in crate::gui) fn fit_controls(ctx: &Context) {
    let interact_size = if is_handheld(ctx) { vec2(FINGER, FINGER) } else { theme::INTERACT_SIZE };
    if ctx.global_style().spacing.interact_size != interact_size {
        ctx.all_styles_mut(|style| style.spacing.interact_size = interact_size);
    }
}

/// A panel at a side, or below the picture. There it's lower if a lesson is below it.
pub(in crate::gui) fn side_panel(ctx: &Context, panel: Panel, (width, widths): (f32, Rangef), lesson: bool) -> Panel {
    if !is_handheld(ctx) {
        return panel.default_size(width).size_range(widths);
    }
    let height = ctx.content_rect().height();
    let (id, usual, most) = if lesson { ("sheet of a lesson", 0.25, 0.4) } else { ("sheet", 0.45, 0.7) };
    Panel::bottom(id).default_size(usual * height).size_range(0.15 * height..=most * height)
}
