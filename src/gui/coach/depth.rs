//! The depth panel: z_n over the distance from the eye, what formats of depth buffers tell apart, and planes that hold the scene.

use eframe::egui::{Grid, RichText, Ui};
use egui_plot::{Corner, Legend, Line, Plot, PlotPoints, VLine, uniform_grid_spacer};

use super::title;
use crate::camera::{Camera, Parameters};
use crate::gui::number_field::{NumberField, Step};
use crate::gui::panels::numerics::color_of;
use crate::gui::plotting::{decade, decades, still};
use crate::gui::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::{coach as words, window};
use crate::numerics::health::{suggested_planes, with_planes};
use crate::numerics::{Resolution, resolutions};
use crate::views::Probe;

/// Height of the plot in points.
const HEIGHT: f32 = 150.0;
const SAMPLES: u32 = 200;
/// Where B/F is more, depths are shown by their logarithms: all else would be at the left border.
const WIDE_RANGE: f64 = 50.0;

/// Shows the panel; gives a camera with other planes where that is wanted.
pub(super) fn ui(ui: &mut Ui, state: &mut State, camera: &Camera) -> Option<Parameters> {
    let lang = state.settings.lang;
    let t = words::texts(lang);
    title(ui, t.depth);
    let [near, far] = [camera.near(), camera.far()];
    let probe = match state.probe {
        Some(Probe::Point(p)) => Some(-camera.view_point(p).z).filter(|depth| (near..=far).contains(depth)),
        Some(Probe::Window(_)) | None => None,
    };
    plot(ui, t, camera, probe);
    let depth = probe.unwrap_or_else(|| camera.distance().clamp(near, far));
    let n = |x: f64| lang.mark().number(x, 3);
    ui.horizontal(|ui| {
        ui.label(t.two_planes);
        let texts = window::texts(lang);
        let mut gap = state.coach.gap;
        let field = NumberField::new(t.two_planes, Step::Multiply(2.0)).within(1e-15..=1e15).width(90.0);
        field.hint(t.two_planes_hint).show(ui, texts, &mut gap);
        state.coach.gap = gap;
        let place = if probe.is_some() { t.at_probe } else { t.at_focus };
        ui.label(format!("{place} −z_c = {}", n(depth)));
    });
    Grid::new("formats").num_columns(3).spacing([18.0, 2.0]).show(ui, |ui| {
        for head in [t.format, t.step_here, ""] {
            ui.label(RichText::new(head).small().weak());
        }
        ui.end_row();
        for Resolution { format, step, told_apart } in resolutions(camera, depth, state.coach.gap) {
            ui.label(crate::i18n::numerics::name(lang, format));
            ui.label(n(step));
            if told_apart {
                ui.label(t.told_apart);
            } else {
                ui.label(RichText::new(format!("⚠ {}", t.flickers)).color(ui.visuals().warn_fg_color));
            }
            ui.end_row();
        }
    });
    let planes = suggested_planes(camera, state.scene_cache.scene().bounds()?)?;
    let mut wanted = None;
    ui.horizontal(|ui| {
        ui.label(format!("{} F = {}, B = {}", t.suggested, n(planes[0]), n(planes[1])));
        if planes != [near, far] && ui.button(t.use_them).clicked() {
            wanted = Some(with_planes(camera.parameters(), planes));
        }
    });
    wanted.filter(|p| Camera::new(p).is_ok())
}

/// z_n of (5.6) in perspective, as in parallel projection, and reversed (1 at F, 0 at B).
fn plot(ui: &mut Ui, t: &words::Texts, camera: &Camera, probe: Option<f64>) {
    let (f, b) = (camera.near(), camera.far());
    let perspective = move |d: f64| (1.0 + f / b - 2.0 * f / d) / (1.0 - f / b);
    let parallel = move |d: f64| (2.0 * d - f - b) / (b - f);
    let reversed = move |d: f64| (f / d - f / b) / (1.0 - f / b);
    // Near F there are as many samples as far from it.
    let depth = move |i: u32| f * (b / f).powf(f64::from(i) / f64::from(SAMPLES));
    let logarithmic = b / f > WIDE_RANGE;
    let across = move |d: f64| if logarithmic { d.log10() } else { d };
    let curve = |of: &dyn Fn(f64) -> f64| -> PlotPoints<'static> {
        (0..=SAMPLES).map(|i| [across(depth(i)), of(depth(i))]).collect()
    };
    let mut plot = still(Plot::new(("depth", logarithmic)))
        .height(HEIGHT)
        .x_axis_label(t.distance)
        .y_axis_label("z_n")
        .legend(Legend::default().position(Corner::RightBottom));
    if logarithmic {
        plot = plot.x_axis_formatter(decade).x_grid_spacer(uniform_grid_spacer(decades));
    }
    let dark = ui.visuals().dark_mode;
    let shown = plot.show(ui, |plot| {
        plot.set_plot_bounds_x(across(f)..=across(b));
        plot.set_plot_bounds_y(-1.05..=1.05);
        let curves: [(&str, &dyn Fn(f64) -> f64); 3] =
            [(t.perspective, &perspective), (t.parallel, &parallel), (t.reversed, &reversed)];
        for (i, (name, of)) in curves.into_iter().enumerate() {
            plot.line(Line::new(name, curve(of)).color(color_of(Some(i), dark)).width(2.0));
        }
        if let Some(depth) = probe {
            let line = VLine::new(t.at_probe.trim_end_matches(','), across(depth));
            plot.vline(line.color(color_of(None, dark)));
        }
    });
    shown.response.explained(t.depth_hint);
}
