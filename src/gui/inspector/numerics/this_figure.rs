//! The study of the figure on the screen: error, time and memory of each way to draw it.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use eframe::egui::{self, Grid, ProgressBar, RichText, ScrollArea, Ui};
use egui_plot::{Plot, PlotPoint};

use super::{GLANCE, plot};
use crate::appearance::Rgba;
use crate::chart::Chart;
use crate::figure::Figure;
use crate::gui::kit::{
    Explained, choice, color_of, export_button, frames, keep_in_sight, linear_x, logarithmic_y, still,
};
use crate::numerics::this_figure::{self, Effort, NoExactImage, Study, Subject, Way, apply};
use crate::picture::Renderer;
use crate::progress::Progress;
use crate::views::{Palette, Request, SharedScene, Size};
use camera_lab_desk::{Action, Latest, MethodImage, Model, Running};
use camera_lab_words::pictures::labels;
use camera_lab_words::why::this_figure as words;
use camera_lab_words::{Lang, why};

/// Distance within which the pointer catches a point, in points.
const NEAR: f32 = 14.0;
/// Room for the answers below the chart.
const ANSWERS: f32 = 64.0;
/// Width of the table of ways.
const TABLE: f32 = 520.0;

/// The figure to examine.
#[derive(Clone, Debug, PartialEq)]
struct Asked {
    figure: Arc<Figure>,
    scene: SharedScene,
    request: Request,
    set_aside: Vec<&'static str>,
}

/// The results after each round, for the window.
type Partial = Arc<Mutex<Option<Arc<Study>>>>;

/// The state of the study.
#[derive(Debug)]
pub struct ThisFigure {
    /// The effort of a run.
    pub effort: Effort,
    /// The figure that the results belong to.
    asked: Option<Asked>,
    study: Option<Arc<Study>>,
    failed: Option<NoExactImage>,
    partial: Partial,
    job: Latest<(Asked, u64), Result<Arc<Study>, NoExactImage>>,
    /// The choice that gives the colours, by its place. The most telling one at first.
    by: Option<usize>,
    /// The way whose image stays in the view.
    kept: Option<usize>,
    images: Latest<Drawn, Option<Arc<MethodImage>>>,
}

/// A way to draw, for its image.
#[derive(Clone, Debug)]
struct Drawn {
    study: Arc<Study>,
    way: usize,
}

impl PartialEq for Drawn {
    fn eq(&self, other: &Self) -> bool {
        self.way == other.way && Arc::ptr_eq(&self.study.exact, &other.study.exact)
    }
}

impl Default for ThisFigure {
    fn default() -> Self {
        let effort = Effort::default();
        let partial = Partial::default();
        let results = Arc::clone(&partial);
        let job = Latest::new("this-figure", move || {
            let results = Arc::clone(&results);
            async move |(asked, seconds): &(Asked, u64), progress: &Progress| {
                let Asked { figure, scene, request, set_aside } = asked;
                let with = |study: Study| Arc::new(Study { set_aside: set_aside.clone(), ..study });
                let tell = |study: &Study| {
                    *results.lock().unwrap_or_else(PoisonError::into_inner) = Some(with(study.clone()));
                };
                let effort = Effort { seconds: f64::from_bits(*seconds), ..effort };
                this_figure::study(Subject { figure, scene, request }, effort, progress, tell).await.map(with)
            }
        });
        let images = Latest::new("this-figure-image", || {
            let mut renderer = Renderer::default();
            async move |Drawn { study, way }: &Drawn, _: &Progress| {
                let request = study.requests.get(*way)?;
                let drawn = renderer.pixels(request)?;
                let Rgba { r, g, b, .. } = Palette::of(request.shot.look.style.theme).differing;
                MethodImage::new(&study.exact.pixels, &drawn, [r, g, b]).map(Arc::new)
            }
        });
        Self { effort, asked: None, study: None, failed: None, partial, job, by: None, kept: None, images }
    }
}

impl ThisFigure {
    /// Takes results. Waits up to `patience`.
    pub fn take(&mut self, patience: Duration) {
        let partial = self.partial.lock().unwrap_or_else(PoisonError::into_inner).take();
        let whole = self.job.take(patience);
        if whole.is_none() && self.job.waiting().is_none() {
            return;
        }
        match whole.map(|(_, result)| result) {
            Some(Ok(study)) => self.study = Some(study),
            Some(Err(NoExactImage::Cancelled)) => {}
            Some(Err(error)) => self.failed = Some(error),
            None => self.study = partial.or_else(|| self.study.take()),
        }
    }

    /// The results, once there are some.
    pub fn study(&self) -> Option<&Study> {
        self.study.as_deref()
    }

    /// True while the figure is being examined.
    pub fn is_busy(&self) -> bool {
        self.job.waiting().is_some()
    }

    /// Examines the figure on the screen, beside the window's thread.
    pub fn examine(&mut self, ctx: &egui::Context, model: &Model) {
        let asked = subject(model);
        (self.study, self.failed, self.kept, self.by) = (None, None, None, None);
        self.job.ask_again(&frames(ctx), (asked.clone(), self.effort.seconds.to_bits()));
        self.asked = Some(asked);
    }

    fn cancel(&mut self) {
        self.job.stop();
        self.job.give_up();
    }
}

/// The figure on the screen as a subject.
fn subject(model: &Model) -> Asked {
    let figure = model.desk.shown.figure();
    let scene = model.scene_cache.scene();
    let size = Size { width: figure.image.width, height: figure.image.height, scale: 1.0 };
    let labels = labels(model.settings.lang);
    let (request, set_aside) = this_figure::request_of(figure, scene, model.desk.shown.camera(), labels, size);
    Asked { figure: Arc::new(figure.clone()), scene: scene.clone(), request, set_aside }
}

/// The button that examines the figure, or the progress.
pub(super) fn button(ui: &mut Ui, model: &Model, state: &mut ThisFigure) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    if state.is_busy() {
        let share = state.job.running().and_then(|Running { now, .. }| now).and_then(|(_, share)| share);
        ui.horizontal(|ui| {
            if ui.button(why::numerics::texts(lang).cancel).explained(t.tab).clicked() {
                state.cancel();
            }
            ui.add(ProgressBar::new(share.unwrap_or(0.0)).desired_width(100.0));
        });
        return;
    }
    let name = if state.study.is_some() { t.again } else { t.study };
    if ui.button(name).explained(t.study_hint).clicked() {
        state.examine(ui.ctx(), model);
    }
}

/// The chart and the table.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, state: &mut ThisFigure) {
    state.take(Duration::ZERO);
    if state.is_busy() {
        ui.ctx().request_repaint_after(GLANCE);
    }
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let Some((study, asked)) = state.study.clone().zip(state.asked.clone()) else {
        let text = state.failed.map_or_else(|| t.nothing_yet.to_owned(), |error| words::no_exact_image(lang, error));
        ui.vertical(|ui| {
            ui.add_space(8.0);
            ui.label(text);
        });
        return;
    };
    let mut now = subject(model);
    // In another language it's the same figure.
    now.request.labels = asked.request.labels;
    let is_old = asked != now;
    let height = ui.available_height();
    let table = TABLE.min(ui.available_width() * 0.5);
    let room = egui::vec2((ui.available_width() - table - 24.0).max(120.0), height);
    let mut pointed = None;
    ui.allocate_ui(room, |ui| pointed = chart(ui, model, state, &study, &asked.figure));
    ui.separator();
    ui.allocate_ui(egui::vec2(table, height), |ui| {
        ui.vertical(|ui| {
            let shown = pointed.or(state.kept).unwrap_or(study.cheapest);
            uses(ui, model, &study, shown, is_old);
            ScrollArea::both().id_salt("ways").auto_shrink(false).show(ui, |ui| {
                if let Some(way) = ways(ui, lang, &asked.figure, &study, shown, state) {
                    pointed = Some(way);
                }
                keep_in_sight(ui);
            });
        });
    });
    if let Some(way) = pointed.or(state.kept).filter(|_| !is_old) {
        state.images.ask(&frames(ui.ctx()), Drawn { study, way });
        state.images.poll(Duration::ZERO);
        model.frame.method_image = state.images.newest().and_then(|(_, image)| image.clone());
    }
}

/// The chart with the answers below it. Returns the way under the pointer, and keeps the one that's clicked.
fn chart(ui: &mut Ui, model: &mut Model, state: &mut ThisFigure, study: &Arc<Study>, figure: &Figure) -> Option<usize> {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    ui.vertical(|ui| {
        let mut by = state.by.or_else(|| study.telling());
        ui.horizontal(|ui| {
            let name = |(k, choice): (usize, &this_figure::Choice)| (Some(k), choice.key.path());
            let names: Vec<(Option<usize>, String)> = study.choices.iter().enumerate().map(name).collect();
            if !names.is_empty() && choice(ui, t.color_by, "", &mut by, &names) {
                state.by = by;
            }
            if export_button(ui, lang) {
                let chart = words::with_words(lang, &figure.scene, |words| study.chart(by, words));
                let json = serde_json::to_string_pretty(&study.data(|why| words::why_not(lang, why)));
                let tables = [study.csv().unwrap_or_default(), json.unwrap_or_default()];
                model.request(Action::chart_with(t.title, chart, tables));
            }
        });
        let chart = words::with_words(lang, &figure.scene, |words| study.chart(by, words));
        let pointed = plotted(ui, study, &chart, &mut state.kept);
        ScrollArea::vertical().id_salt("answers").max_height(ANSWERS).show(ui, |ui| {
            let lines = words::answers(lang, &figure.scene, study).into_iter().chain(words::left_out(lang, study));
            lines.for_each(|line| drop(ui.label(RichText::new(line).small())));
        });
        pointed
    })
    .inner
}

fn plotted(ui: &mut Ui, study: &Study, chart: &Chart, kept: &mut Option<usize>) -> Option<usize> {
    let [x, y] = chart.range();
    let y = y.map(f64::log10);
    let height = (ui.available_height() - ANSWERS - 6.0).max(80.0);
    let plot = still(Plot::new("this figure"))
        .height(height)
        .default_x_bounds(x[0], x[1])
        .default_y_bounds(y[0], y[1])
        .grid_color(ui.visuals().weak_text_color().gamma_multiply(0.5));
    let plot = logarithmic_y(linear_x(plot, ui, &chart.x_label), ui, &chart.y_label);
    let dark = ui.visuals().dark_mode;
    let shown = plot.show(ui, |plot_ui| {
        plot_ui.set_plot_bounds_x(x[0]..=x[1]);
        plot_ui.set_plot_bounds_y(y[0]..=y[1]);
        plot::draw(plot_ui, chart, dark);
        let pointer = plot_ui.response().hover_pos()?;
        let distance = |way: &Way| {
            let [ms, error] = study.place(way);
            plot_ui.screen_from_plot(PlotPoint::new(ms, error.log10())).distance(pointer)
        };
        let all = study.ways.iter().map(distance).enumerate();
        all.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, distance)| *distance < NEAR).map(|(way, _)| way)
    });
    if shown.response.clicked() {
        *kept = shown.inner;
    }
    shown.inner
}

/// The button that writes the keys of a way into the figure, in one step.
fn uses(ui: &mut Ui, model: &mut Model, study: &Study, shown: usize, is_old: bool) {
    let t = words::texts(model.settings.lang);
    let changes = study.ways.get(shown).map(|way| study.changes(way)).unwrap_or_default();
    if is_old {
        ui.label(RichText::new(t.old).small());
        return;
    }
    ui.horizontal_wrapped(|ui| {
        let button = ui.add_enabled(!changes.is_empty(), egui::Button::new(t.use_these)).explained(t.use_hint);
        let lines = changes.iter().map(|(key, value)| format!("{} = {value}", key.path()));
        ui.label(RichText::new(lines.collect::<Vec<_>>().join(", ")).small().weak());
        if button.clicked() {
            model.desk.commit();
            model.desk.shown.edit(|figure| apply(figure, &changes));
        }
    });
}

/// The table of all ways, the fastest first. Returns the one under the pointer, and keeps the one that's clicked.
fn ways(
    ui: &mut Ui,
    lang: Lang,
    figure: &Figure,
    study: &Study,
    shown: usize,
    state: &mut ThisFigure,
) -> Option<usize> {
    let t = words::texts(lang);
    let by = state.by.or_else(|| study.telling());
    let mut order: Vec<usize> = (0..study.ways.len()).collect();
    order.sort_by(|&a, &b| study.ways[a].ms.median.total_cmp(&study.ways[b].ms.median));
    let mut pointed = None;
    Grid::new("ways").num_columns(5).striped(true).show(ui, |ui| {
        for head in [t.ms, t.different, t.rms, t.memory, t.change] {
            ui.label(RichText::new(head).strong());
        }
        ui.end_row();
        for k in order {
            let way = &study.ways[k];
            for column in words::columns(lang, way) {
                ui.monospace(column);
            }
            let mark = words::mark(way);
            let names = [(study.yours, t.yours), (study.cheapest, t.cheapest)];
            let mut text: Vec<String> =
                names.iter().filter(|(of, _)| *of == k).map(|(_, name)| (*name).into()).collect();
            let is_named = !text.is_empty();
            text.push(words::changed(lang, &figure.scene, study, way));
            text.retain(|text| !text.is_empty());
            ui.horizontal(|ui| {
                let color = by.and_then(|choice| way.combination.get(choice)).copied();
                ui.colored_label(color_of(color, ui.visuals().dark_mode), "●");
                let text = RichText::new(format!("{mark} {}", text.join(": ")));
                let text = if is_named { text.strong() } else { text };
                let label = ui.selectable_label(k == shown, text);
                if label.hovered() || label.has_focus() {
                    pointed = Some(k);
                }
                if label.clicked() {
                    state.kept = if state.kept == Some(k) { None } else { Some(k) };
                }
            });
            ui.end_row();
        }
    });
    ui.label(RichText::new(t.star).small());
    pointed
}
