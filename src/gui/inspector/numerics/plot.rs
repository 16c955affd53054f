//! The chart of one case of a study. Its axes are logarithms.

use eframe::egui::{self, Ui};
use egui_plot::{Line, LineStyle, Plot, PlotPoint, PlotPoints, Points};

use crate::chart::{Chart, Look, Series};
use crate::gui::kit::{color_of, logarithmic_x, logarithmic_y, still};
use crate::numerics::charts::Pair;
use crate::numerics::{Findings, Row};
use camera_lab_words::why::numerics as words;

/// Distance within which the pointer catches a point, in points.
const NEAR: f32 = 14.0;
/// Room for the line that describes the point under the pointer.
const READOUT: f32 = 22.0;

/// Shows a chart and the values under the pointer. Returns the row whose point was clicked.
pub(super) fn show(
    ui: &mut Ui,
    lang: camera_lab_words::Lang,
    findings: &Findings,
    case: &str,
    pair: &Pair,
    over_time: bool,
) -> Option<Row> {
    let chart = if over_time { &pair.by_time } else { &pair.by_parameter };
    let [x, y] = chart.range().map(|[low, high]| [low.log10(), high.log10()]);
    // The last mark of an axis is whole only if the axis continues.
    let [x, y] = [x, y].map(|[low, high]| [low, high + BEYOND * (high - low)]);
    let height = (ui.available_height() - READOUT).max(80.0);
    let plot = still(Plot::new(("study", findings.study.name(), over_time)))
        .height(height)
        .default_x_bounds(x[0], x[1])
        .default_y_bounds(y[0], y[1])
        .grid_color(ui.visuals().weak_text_color().gamma_multiply(0.5));
    let plot = logarithmic_y(logarithmic_x(plot, ui, &chart.x_label), ui, &chart.y_label);
    let point = |row: &Row| {
        let error = if row.error > 0.0 { row.error } else { pair.floor };
        let across = if over_time { row.nanos } else { row.parameter };
        PlotPoint::new(across.log10(), error.log10())
    };
    let dark = ui.visuals().dark_mode;
    let shown = plot.show(ui, |plot_ui| {
        // The case may have changed under the same plot.
        plot_ui.set_plot_bounds_x(x[0]..=x[1]);
        plot_ui.set_plot_bounds_y(y[0]..=y[1]);
        draw(plot_ui, chart, dark);
        let pointer = plot_ui.response().hover_pos()?;
        let rows = findings.rows.iter().filter(|row| row.case == case);
        let distance = |row: &Row| plot_ui.screen_from_plot(point(row)).distance(pointer);
        rows.map(|row| (distance(row), row)).min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(d, _)| *d < NEAR)
    });
    let row = shown.inner.map(|(_, row)| row);
    let text = match row {
        Some(row) => {
            words::readout(lang, findings.study, row, |x| lang.mark().printed(&crate::numbers::significant(x, 3)))
        }
        None => words::texts(lang).point_at.to_owned(),
    };
    ui.add(egui::Label::new(egui::RichText::new(text).small()).truncate());
    row.filter(|_| shown.response.clicked()).cloned()
}

pub(super) fn draw(plot_ui: &mut egui_plot::PlotUi<'_>, chart: &Chart, dark: bool) {
    for (place, series) in chart.series.iter().enumerate() {
        let color = color_of(series.color, dark);
        let along = |p: &[f64; 2]| [0, 1].map(|axis| chart.axes[axis].along(p[axis]));
        let points = || -> PlotPoints<'_> { series.points.iter().map(along).collect() };
        let width = match series.look {
            Look::Curve => Some(1.5),
            Look::BoldCurve => Some(3.0),
            Look::Line => Some(1.0),
            Look::BoldLine => Some(3.0),
            Look::Dots | Look::Shadow | Look::Ring => None,
        };
        if let Some(width) = width {
            let line = Line::new(series.name.clone(), points()).color(color).width(width);
            // Where curves coincide, each is visible between the dashes of the next.
            let below = chart.series[..place].iter().filter(|other| lie_together(other, series)).count();
            plot_ui.line(match below {
                0 => line,
                1 => line.style(LineStyle::Dashed { length: 9.0 }),
                _ => line.style(LineStyle::Dotted { spacing: 7.0 }),
            });
        }
        let radius = match series.look {
            Look::Curve => 3.0,
            Look::BoldCurve => 4.0,
            Look::Dots => 5.5,
            Look::Shadow => 2.0,
            Look::Ring => 6.0,
            Look::Line | Look::BoldLine => continue,
        };
        let color = if series.look == Look::Shadow { color.gamma_multiply(0.4) } else { color };
        plot_ui.points(Points::new(series.name.clone(), points()).color(color).radius(radius));
    }
}

/// True if two curves can't be told apart, because at every point they are within a twentieth of a decade.
fn lie_together(a: &Series, b: &Series) -> bool {
    let is_curve = |series: &Series| matches!(series.look, Look::Curve | Look::BoldCurve);
    let near = |[a, b]: [f64; 2]| (a.log10() - b.log10()).abs() < 0.05;
    is_curve(a)
        && is_curve(b)
        && a.points.len() == b.points.len()
        && a.points.iter().zip(&b.points).all(|(a, b)| near([a[0], b[0]]) && near([a[1], b[1]]))
}

/// The part of an axis beyond its last mark.
const BEYOND: f64 = 0.04;
