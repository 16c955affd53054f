//! Common parts of the plots of the window. They don't move, and their logarithmic axes are marked at powers of ten.

use eframe::egui::{Color32, TextStyle, Ui};
use egui_plot::{Axis, AxisHints, GridInput, GridMark, Plot};

use crate::appearance::Rgba;
use crate::export::plot::COLORS;
use crate::gui::kit::tooltip::Explained;
use camera_lab_words::{Lang, window};

/// A plot that neither moves nor zooms, and shows no coordinates of its own. The values under the pointer appear beside
/// it.
pub(in crate::gui) fn still(plot: Plot<'_>) -> Plot<'_> {
    plot.show_x(false).show_y(false).allow_drag(false).allow_zoom(false).allow_scroll(false).allow_boxed_zoom(false)
}

/// Room of a mark in heights of its type, beside the next one, and above it.
const ROOM: [f32; 2] = [3.0, 1.8];

/// A plot with a logarithmic horizontal axis, marked at as many powers of ten as there is room for.
pub(in crate::gui) fn logarithmic_x<'a>(plot: Plot<'a>, ui: &Ui, label: &str) -> Plot<'a> {
    plot.custom_x_axes(vec![axis(Axis::X, label)]).x_grid_spacer(decades(ROOM[0] * type_size(ui)))
}

/// A plot with a linear horizontal axis, with as many marks as there is room for.
pub(in crate::gui) fn linear_x<'a>(plot: Plot<'a>, ui: &Ui, label: &str) -> Plot<'a> {
    let room = 2.2 * type_size(ui);
    plot.custom_x_axes(vec![AxisHints::new_x().label(label).label_spacing(room..=1.2 * room)])
}

/// A plot with a logarithmic vertical axis, marked at as many powers of ten as there is room for.
pub(in crate::gui) fn logarithmic_y<'a>(plot: Plot<'a>, ui: &Ui, label: &str) -> Plot<'a> {
    plot.custom_y_axes(vec![axis(Axis::Y, label)]).y_grid_spacer(decades(ROOM[1] * type_size(ui)))
}

/// The size of the type of marks, in points.
fn type_size(ui: &Ui) -> f32 {
    TextStyle::Body.resolve(ui.style()).size
}

fn axis<'a>(axis: Axis, label: &str) -> AxisHints<'a> {
    // The marks are as far apart as needed, so none fades.
    AxisHints::new(axis).label(label).formatter(decade).label_spacing(0.0..=1.0)
}

/// The mark of a power of ten on a logarithmic axis.
fn decade(mark: GridMark, _: &std::ops::RangeInclusive<f64>) -> String {
    crate::chart::power_of_ten(10f64.powf(mark.value))
}

/// Marks of a logarithmic axis at whole decades, at least `room` points apart.
fn decades(room: f32) -> impl Fn(GridInput) -> Vec<GridMark> {
    /// The number of points for a step that a plot recommends as the smallest.
    const SMALLEST: f64 = 8.0;
    move |GridInput { bounds: (low, high), base_step_size }| {
        let least = f64::from(room) * base_step_size / SMALLEST;
        let steps = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];
        let step = steps.into_iter().find(|step| *step >= least).unwrap_or(200.0);
        let mut marks = Vec::new();
        let mut value = (low / step).ceil() * step;
        while value <= high && marks.len() < MOST_MARKS {
            marks.push(GridMark { value, step_size: step });
            value += step;
        }
        marks
    }
}

/// More marks than an axis has room for.
const MOST_MARKS: usize = 200;

/// The colours of the charts on paper, by their place, which the table shows too. On a dark ground the darkest are
/// lightened. `None` is grey.
pub(in crate::gui) fn color_of(color: Option<usize>, dark: bool) -> Color32 {
    let ground = if dark { Rgba::rgb(0x16, 0x1a, 0x20) } else { Rgba::rgb(255, 255, 255) };
    let own = color.map_or(Rgba::rgb(0x70, 0x70, 0x70), |i| COLORS[i % COLORS.len()]);
    let Rgba { r, g, b, .. } = own.legible_on(ground);
    Color32::from_rgb(r, g, b)
}

/// A button that exports a chart. True if it was clicked.
pub(in crate::gui) fn export_button(ui: &mut Ui, lang: Lang) -> bool {
    let t = window::texts(lang);
    ui.button(t.export_chart).explained(t.export_chart_hint).clicked()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_whole_decades_with_room_between_them() {
        // 400 points: five decades have 80 each, of fifty every fifth has 40.
        for (decades_shown, room, step) in [(5.0, 42.0, 1.0), (5.0, 90.0, 2.0), (50.0, 40.0, 5.0), (50.0, 42.0, 10.0)] {
            let bounds = (-0.25 - decades_shown, -0.25);
            let marks = decades(room)(GridInput { bounds, base_step_size: decades_shown / 400.0 * 8.0 });
            assert!(marks.len() > 1 && marks.iter().all(|mark| mark.value % step == 0.0 && mark.step_size == step));
            assert!(marks.iter().all(|mark| (bounds.0..=bounds.1).contains(&mark.value)));
        }
        assert!(decades(42.0)(GridInput { bounds: (0.0, 1e300), base_step_size: 1.0 }).len() <= MOST_MARKS);
    }
}
