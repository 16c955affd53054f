//! Depth: the depth buffer as a picture, z_n over the distance from the eye, the resolution of formats of depth
//! buffers, and planes that contain the scene.

use eframe::egui::accesskit::Role;
use eframe::egui::{self, Align2, Color32, Grid, Label, Mesh, Rect, RichText, Sense, Shape, Ui, WidgetInfo, vec2};
use egui_plot::{Line, Plot, PlotPoints, Text, VLine};

use crate::appearance::DepthFormat;
use crate::camera::{Camera, Ndc, Parameters, Projection};
use crate::chart::{Axis, Chart, Look, Series};
use crate::figure::Depth;
use crate::gui::kit::{
    Explained, NumberField, Step, choice_row, color_of, export_button, linear_x, logarithmic_x, still, theme,
};
use crate::gui::why::state::explain::Explain;
use crate::numerics::health::{suggested_planes, with_planes};
use crate::numerics::{Resolution, Seen, TwoPlanes, resolutions};
use crate::views::Probe;
use camera_lab_desk::{Action, Model};
use camera_lab_words::Lang;
use camera_lab_words::window::{self, coach as words, compare};

/// Height of the plot in points.
const HEIGHT: f32 = 150.0;
const SAMPLES: u32 = 200;
/// The widest head of a column of formats, in points, because in a presentation the table has little room.
const HEAD: f32 = 76.0;
/// The share of the plot's height that a name takes.
const NAME: f64 = 0.15;
/// If B/F is greater, depths are shown by their logarithms. Otherwise all would be at the left border.
const WIDE_RANGE: f64 = 50.0;

/// Shows it for the camera of the figure.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    depth_view(ui, model);
    let camera = model.desk.shown.camera().clone();
    if let Some(wanted) = of_camera(ui, model, explain, &camera) {
        model.apply_camera(wanted);
        ui.request_repaint();
    }
}

/// The image in colours, or the depth buffer in its place.
fn depth_view(ui: &mut Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let mut depth = model.desk.shown.figure().reveal.depth;
    let depths = [(Depth::Off, t.depth_off), (Depth::Stored, t.depth_stored), (Depth::Linear, t.depth_linear)];
    choice_row(ui, t.depth_view, t.depth_view_hint, &mut depth, &depths);
    model.desk.shown.set(|figure| &mut figure.reveal.depth, depth);
    let t = compare::texts(model.settings.lang);
    let mut format = model.desk.shown.figure().style.depth_format;
    let formats =
        [(DepthFormat::Fixed16, "fixed 16"), (DepthFormat::Fixed24, "fixed 24"), (DepthFormat::Float, "f32 reversed")];
    let names = formats.map(|(_, name)| camera_lab_words::why::numerics::name(model.settings.lang, name));
    let choices: Vec<_> = formats.iter().zip(&names).map(|((format, _), name)| (*format, &**name)).collect();
    choice_row(ui, t.format, t.format_hint, &mut format, &choices);
    model.desk.shown.set(|figure| &mut figure.style.depth_format, format);
    super::compare_button(ui, model);
}

/// Shows the consequences of a camera. Returns one with other planes if the user wants that.
fn of_camera(ui: &mut Ui, model: &mut Model, explain: &mut Explain, camera: &Camera) -> Option<Parameters> {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let [near, far] = [camera.near(), camera.far()];
    let probe = match model.frame.probe {
        Some(Probe::Point(p)) => Some(-camera.view_point(p).z).filter(|depth| (near..=far).contains(depth)),
        Some(Probe::Window(_)) | None => None,
    };
    let space = camera.possible_clip_space(model.settings.conventions.ndc);
    let said = words::depth_in(lang, space.ndc());
    theme::wrapped(ui, &said, &egui::TextStyle::Body, ui.visuals().text_color());
    plot(ui, lang, camera, space.ndc(), probe);
    ui.horizontal(|ui| {
        if export_button(ui, lang) {
            model.request(Action::chart(t.depth_chart, chart(lang, camera, space.ndc(), &said)));
        }
    });
    let depth = probe.unwrap_or_else(|| camera.distance().clamp(near, far));
    let n = |x: f64| lang.mark().number(x, 3);
    ui.horizontal_wrapped(|ui| {
        ui.label(t.two_planes);
        let texts = window::texts(lang);
        let mut gap = explain.gap;
        let field = NumberField::new(t.two_planes, Step::Multiply(2.0)).within(1e-15..=1e15).width(90.0);
        field.hint(t.two_planes_hint).show(ui, texts, &mut gap);
        explain.gap = gap;
        let place = if probe.is_some() { t.at_probe } else { t.at_focus };
        ui.label(format!("{}; {place} {}", t.scene_units, n(depth)));
    });
    let of = (*camera.parameters(), space.ndc(), [depth, explain.gap]);
    formats(ui, lang, explain.resolutions.of(of, |(_, _, [depth, gap])| resolutions(&space, *depth, *gap)));
    let planes = suggested_planes(camera, model.scene_cache.scene().bounds()?)?;
    let mut wanted = None;
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{} F = {}, B = {}", t.suggested, n(planes[0]), n(planes[1])));
        if planes != [near, far] && ui.button(t.use_them).clicked() {
            wanted = Some(with_planes(camera.parameters(), planes));
        }
    });
    wanted.filter(|p| Camera::new(p).is_ok())
}

/// The resolution of each format of depth buffers, and its picture of the two planes.
fn formats(ui: &mut Ui, lang: Lang, resolutions: &[Resolution]) {
    let t = words::texts(lang);
    let colors = PlaneColors::of(ui);
    let right = ui.max_rect().right();
    Grid::new("formats").num_columns(3).spacing([10.0, 2.0]).show(ui, |ui| {
        for head in [t.format, t.step_here] {
            ui.vertical(|ui| {
                ui.set_max_width(HEAD);
                ui.add(Label::new(RichText::new(head).small().weak()).wrap());
            });
        }
        ui.vertical(|ui| {
            ui.label(RichText::new(t.nearer).small().strong().color(colors.nearer));
            ui.label(RichText::new(t.farther).small().strong().color(colors.farther));
        });
        ui.end_row();
        for Resolution { format, step, planes } in resolutions {
            let name = camera_lab_words::why::numerics::name(lang, format);
            ui.label(&name);
            ui.label(lang.mark().number(*step, 3));
            let said = words::two_planes(lang, planes.share_through());
            ui.vertical(|ui| {
                ui.set_max_width((right - ui.cursor().left()).max(TwoPlanes::WIDTH as f32));
                picture(ui, planes, &colors, &format!("{name}: {said}"));
                let flickers = planes.share_through() > 0.0;
                let color = if flickers { ui.visuals().warn_fg_color } else { ui.visuals().text_color() };
                let said = if flickers { format!("⚠ {said}") } else { said };
                ui.add(Label::new(RichText::new(said).small().color(color)).wrap());
            });
            ui.end_row();
        }
    });
}

/// The colours of the two planes.
struct PlaneColors {
    nearer: Color32,
    farther: Color32,
}

impl PlaneColors {
    fn of(ui: &Ui) -> Self {
        let dark = ui.visuals().dark_mode;
        Self { nearer: color_of(Some(4), dark), farther: color_of(Some(0), dark) }
    }
}

/// The two planes, a point for each pixel.
fn picture(ui: &mut Ui, planes: &TwoPlanes, colors: &PlaneColors, said: &str) {
    let (rect, response) =
        ui.allocate_exact_size(vec2(TwoPlanes::WIDTH as f32, TwoPlanes::HEIGHT as f32), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, said));
    let mut mesh = Mesh::default();
    for (row, seen) in planes.seen.chunks(TwoPlanes::WIDTH as usize).enumerate() {
        let mut left = 0;
        // Neighbours of one colour are one rectangle.
        for run in seen.chunk_by(|a, b| a == b) {
            let color = match run.first() {
                Some(Seen::Nearer) => Some(colors.nearer),
                Some(Seen::Farther | Seen::Through) => Some(colors.farther),
                Some(Seen::Ground) | None => None,
            };
            if let Some(color) = color {
                let corner = rect.min + vec2(left as f32, row as f32);
                mesh.add_colored_rect(Rect::from_min_size(corner, vec2(run.len() as f32, 1.0)), color);
            }
            left += run.len();
        }
    }
    ui.painter().add(Shape::mesh(mesh));
}

/// A curve of z_n, by name, and true if it's that of the camera in the present convention.
type Curve = (&'static str, Vec<[f64; 2]>, bool);

/// z_n over the distance from the eye, by the matrices of a convention: in perspective, in parallel projection, and
/// reversed.
fn curves(t: &'static words::Texts, camera: &Camera, ndc: Ndc, across: impl Fn(f64) -> f64) -> Vec<Curve> {
    let (f, b) = (camera.near(), camera.far());
    // As many samples near F as far from it.
    let depth = |i: u32| f * (b / f).powf(f64::from(i) / f64::from(SAMPLES));
    let own = camera.projection();
    let all = [
        (t.perspective, Projection::Perspective, false),
        (t.parallel, Projection::Parallel, false),
        // In the projection of the camera, if the convention itself is reversed.
        (t.reversed, if ndc.reversed { own } else { Projection::Perspective }, true),
    ];
    let curve = |(name, projection, reversed): (&'static str, Projection, bool)| {
        let camera = Camera::new(&Parameters { projection, ..*camera.parameters() }).ok()?;
        let space = camera.possible_clip_space(Ndc { reversed, ..ndc });
        let points = (0..=SAMPLES).map(|i| [across(depth(i)), space.ndc_depth(depth(i))]).collect();
        Some((name, points, projection == own && reversed == ndc.reversed))
    };
    all.into_iter().filter_map(curve).collect()
}

/// The curves as a chart.
fn chart(lang: Lang, camera: &Camera, ndc: Ndc, said: &str) -> Chart {
    let t = words::texts(lang);
    let series = |(i, (name, points, is_own)): (usize, Curve)| {
        let look = if is_own { Look::BoldLine } else { Look::Line };
        Series { name: name.to_owned(), color: Some(i), points, look }
    };
    let across = if is_wide(camera) { Axis::Logarithmic } else { Axis::Linear };
    Chart {
        title: said.replace("z_n", "zₙ"),
        x_label: t.distance.to_owned(),
        y_label: "zₙ".to_owned(),
        axes: [across, Axis::Linear],
        mark: lang.mark(),
        series: curves(t, camera, ndc, |d| d).into_iter().enumerate().map(series).collect(),
    }
}

/// True if distances are shown by their logarithms.
fn is_wide(camera: &Camera) -> bool {
    camera.far() / camera.near() > WIDE_RANGE
}

/// For each curve the point at which it's farthest from the others, and the corner of its name at that point. The name
/// lies beside the curve, on the side without another curve.
fn places_of_names(curves: &[Curve], [low, high]: [f64; 2]) -> Vec<([f64; 2], Align2)> {
    let height = |curve: usize, k: usize| curves[curve].1[k][1];
    let others = |curve: usize, k: usize| {
        (0..curves.len()).filter(move |other| *other != curve).map(move |other| height(other, k) - height(curve, k))
    };
    let apart = |curve: usize, k: usize| others(curve, k).map(f64::abs).fold(f64::INFINITY, f64::min);
    let best = |curve: usize| {
        let points = &curves[curve].1;
        // Not at the ends, because a name would leave the plot there.
        let within = points.len() / 4..points.len() - points.len() / 4;
        let k = within.max_by(|a, b| apart(curve, *a).total_cmp(&apart(curve, *b))).unwrap_or_default();
        let rises = height(curve, (k + 1).min(points.len() - 1)) > height(curve, k);
        let y = height(curve, k);
        let has_room_above = high - y > NAME * (high - low);
        let has_room_below = y - low > NAME * (high - low);
        let is_free_above = others(curve, k).filter(|above| *above > 0.0).count() < curves.len() / 2;
        let is_above = has_room_above && (is_free_above || !has_room_below);
        let anchor = match (is_above, rises) {
            (true, true) => Align2::RIGHT_BOTTOM,
            (true, false) => Align2::LEFT_BOTTOM,
            (false, true) => Align2::LEFT_TOP,
            (false, false) => Align2::RIGHT_TOP,
        };
        (points[k], anchor)
    };
    (0..curves.len()).map(best).collect()
}

fn plot(ui: &mut Ui, lang: Lang, camera: &Camera, ndc: Ndc, probe: Option<f64>) {
    let t = words::texts(lang);
    let (f, b) = (camera.near(), camera.far());
    let logarithmic = is_wide(camera);
    let across = move |d: f64| if logarithmic { d.log10() } else { d };
    let curves = curves(t, camera, ndc, across);
    let depths = curves.iter().flat_map(|(_, points, _)| points).map(|point| point[1]);
    let [low, high] = depths.fold([0.0, 0.0], |[low, high]: [f64; 2], z| [low.min(z), high.max(z)]);
    let plot = still(Plot::new(("depth", logarithmic))).height(HEIGHT);
    let plot = plot.y_axis_formatter(move |mark, _| lang.mark().number(mark.value, 3));
    let plot = if logarithmic { logarithmic_x(plot, ui, t.distance) } else { linear_x(plot, ui, t.distance) };
    let dark = ui.visuals().dark_mode;
    let shown = plot.show(ui, |plot| {
        // The last mark of the axis is whole only if the axis continues.
        plot.set_plot_bounds_x(across(f)..=across(b) + 0.04 * (across(b) - across(f)));
        plot.set_plot_bounds_y(low - 0.05..=high + 0.05);
        for (i, (place, anchor)) in places_of_names(&curves, [low, high]).into_iter().enumerate() {
            let name = RichText::new(curves[i].0).color(color_of(Some(i), dark)).strong();
            plot.text(Text::new(curves[i].0, place.into(), name).anchor(anchor));
        }
        for (i, (name, points, is_own)) in curves.into_iter().enumerate() {
            let width = if is_own { 3.5 } else { 1.5 };
            plot.line(Line::new(name, PlotPoints::from(points)).color(color_of(Some(i), dark)).width(width));
        }
        if let Some(depth) = probe {
            let line = VLine::new(t.at_probe.trim_end_matches(','), across(depth));
            plot.vline(line.color(color_of(None, dark)));
        }
    });
    shown.response.explained(t.depth_hint);
}
