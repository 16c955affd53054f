//! `camera-lab explain`: the stages of the pipeline that a picture needs, and the reason why each other one is left
//! out.

use std::fmt::Write as _;

use serde::Serialize;

use super::args::ExplainArgs;
use super::{Failure, OpenFigure, json_of, print, progress};
use crate::appearance::FaceOrder;
use crate::cli::args::figure::size;
use crate::cli::args::words::TableFormat;
use crate::clock;
use crate::numerics::this_figure::{Saving, savings};
use crate::picture::{Pixels, RenderReport, Renderer};
use crate::pipeline::{Containment, ObjectReport, Stage, StageReport};
use crate::progress::{Progress, at_once};
use crate::sanitize::{self, escaped};
use crate::scene::{Object, Scene};
use crate::stage::Operations;
use crate::views::{Request, Size, View};
use camera_lab_words::why::{pipeline, this_figure};
use camera_lab_words::window::canvas;
use camera_lab_words::{Lang, command_line as texts};

/// Seconds for measuring what the stages left out would have cost.
const SAVED_SECONDS: f64 = 2.0;

/// The JSON output.
#[derive(Serialize)]
struct Explanation<'a> {
    view: &'a str,
    stages: Vec<StageLine>,
    total_micros: f64,
    /// The stages whose operations aren't counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_counted: Option<Vec<&'static str>>,
    /// Samples that were filled, and those painted over, in each order of the faces; the figure's own comes first.
    #[serde(skip_serializing_if = "Option::is_none")]
    fills: Option<Vec<FillsLine>>,
    /// Only for the image, whose objects are those of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    objects: Option<Vec<ObjectLine<'a>>>,
}

#[derive(Serialize)]
struct FillsLine {
    order: &'static str,
    filled: u64,
    painted_over: u64,
}

#[derive(Serialize)]
struct ObjectLine<'a> {
    name: &'a str,
    place: &'static str,
    /// The planes of the volume that it may cross, or that it lies outside.
    planes: Vec<&'static str>,
    reason: String,
}

#[derive(Serialize)]
struct StageLine {
    stage: &'static str,
    ran: bool,
    reason: String,
    #[serde(rename = "in")]
    entering: usize,
    #[serde(rename = "out")]
    leaving: usize,
    micros: f64,
    /// The stage in whose time this one's is.
    #[serde(skip_serializing_if = "Option::is_none")]
    timed_with: Option<&'static str>,
    /// Only if the cost is requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    operations: Option<OperationsLine>,
    /// Only of a stage that is left out, if savings are requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    saved_ms: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    same_bytes: Option<bool>,
}

/// Operations and accesses.
#[derive(Serialize)]
struct OperationsLine {
    float: u64,
    integer: u64,
    memory: u64,
}

pub(super) fn run(args: &ExplainArgs, lang: Lang) -> Result<(), Failure> {
    let subject = OpenFigure::open(&args.figure, &args.common, size(args.size.as_deref(), lang)?, lang)?;
    let OpenFigure { scene, size, lang, .. } = &subject;
    let (size, lang) = (*size, *lang);
    let request = subject.request(args.view, args.force_all_stages);
    let mut account = account(&request).ok_or_else(|| subject.too_large())?;
    let counted = |progress: &Progress| at_once(Renderer::default().costs(&request, progress));
    let costs = args.cost.then(|| progress::watched(lang, counted).ok_or_else(|| subject.too_large())).transpose()?;
    for report in account.stages.iter_mut().filter(|report| report.stage.is_raster()) {
        report.operations = costs.as_ref().map_or(Operations::NONE, |costs| costs.of_stage(report.stage));
    }
    let left_out: Vec<Stage> = account.stages.iter().filter(|report| !report.ran).map(|report| report.stage).collect();
    let saved = |progress: &Progress| at_once(savings(&request, &left_out, SAVED_SECONDS, progress));
    let saved =
        if args.saved { progress::watched(lang, saved).ok_or_else(|| subject.too_large())? } else { Vec::new() };
    let view = args.view.name();
    let objects = (args.view == View::Image).then(|| objects(scene, &account, lang));
    let text = match args.format {
        TableFormat::Text => {
            let mut text = table(&account, canvas::texts(lang).view(args.view), size, args.cost, lang);
            let needless = costs.map(|costs| pipeline::needless(lang, &costs)).filter(|text| !text.is_empty());
            text += &needless.map_or_else(String::new, |needless| format!("\n{needless}\n"));
            if let Some(objects) = objects.filter(|objects| !objects.is_empty()) {
                text += "\n";
                objects.iter().for_each(|object| text += &format!("{:<18} {}\n", escaped(object.name), object.reason));
            }
            if args.saved {
                text += "\n";
                text += &this_figure::savings(lang, &saved);
            }
            text += &format!("\n{} {}\n", texts::explain(lang).accuracy, sanitize::path(&args.figure));
            text
        }
        TableFormat::Json => {
            let stages = account.stages.iter().map(|report| line(report, args.cost, &saved, lang)).collect();
            let uncounted = || Stage::ALL.into_iter().filter(|stage| !stage.is_counted()).map(Stage::name).collect();
            let not_counted = args.cost.then(uncounted);
            let line = |&(order, [filled, painted_over]): &(FaceOrder, [u64; 2])| FillsLine {
                order: order.name(),
                filled,
                painted_over,
            };
            let fills = costs.map(|costs| costs.fills.iter().map(line).collect());
            json_of(&Explanation { view, stages, total_micros: micros(account.total), not_counted, fills, objects })?
        }
    };
    print(text.as_bytes(), lang)
}

/// The report of each object of the scene.
fn objects<'a>(scene: &'a Scene, account: &RenderReport, lang: Lang) -> Vec<ObjectLine<'a>> {
    let line = |(object, report): (&'a Object, &ObjectReport)| {
        let (place, planes) = match report.containment {
            Containment::Empty => ("empty", 0),
            Containment::Crosses(0) => ("inside", 0),
            Containment::Crosses(planes) => ("crosses", planes),
            Containment::Outside(planes) => ("outside", planes),
        };
        let names = ["left", "right", "bottom", "top", "near", "far"];
        let planes = (0..).zip(names).filter(|(i, _)| planes & (1 << i) != 0).map(|(_, name)| name).collect();
        ObjectLine { name: &object.name, place, planes, reason: pipeline::object(lang, report) }
    };
    scene.objects.iter().zip(&account.objects).map(line).collect()
}

/// Draws the picture twice. The first time, memory new to the process would dominate the measurement.
fn account(request: &Request) -> Option<RenderReport> {
    let (mut renderer, mut picture) = (Renderer::default(), Pixels::default());
    renderer.measure(Some(clock::now));
    at_once(renderer.pixels_into(request, &mut picture))?;
    renderer.forget();
    at_once(renderer.pixels_into(request, &mut picture))
}

fn line(report: &StageReport, cost: bool, saved: &[Saving], lang: Lang) -> StageLine {
    let saved = saved.iter().find(|saving| saving.stage == report.stage);
    let Operations { float, integer, memory } = report.operations;
    let (entering, leaving) = report.counts.unwrap_or_default();
    StageLine {
        stage: report.stage.name(),
        ran: report.ran,
        reason: pipeline::reason(lang, report.reason),
        entering,
        leaving,
        micros: report.time.map_or(0.0, micros),
        timed_with: report.stage.timed_with().filter(|_| report.ran && report.time.is_none()).map(|stage| stage.name()),
        operations: cost.then_some(OperationsLine { float, integer, memory }),
        saved_ms: saved.map(|Saving { ms, .. }| [ms.median, ms.low, ms.high]),
        same_bytes: saved.map(|saving| saving.same_bytes),
    }
}

/// Rounded to a nanosecond, the unit of the clock.
fn micros(time: std::time::Duration) -> f64 {
    (time.as_secs_f64() * 1e9).round() / 1e3
}

/// A table: stage, counts in → out with their unit, microseconds, `cost` if requested, reason.
fn table(account: &RenderReport, view: &str, size: Size, cost: bool, lang: Lang) -> String {
    let words = texts::explain(lang);
    let mut text = format!("{view}, {} × {}\n\n", size.width, size.height);
    let mut row = |[stage, entering, leaving, unit, micros, why]: [&str; 6], operations: [&str; 3]| {
        // Writing to a String can't fail.
        let _ = write!(text, "{stage:<18} {entering:>9} {leaving:>9}  {unit:<22} {micros:>9}  ");
        if cost {
            let _ = write!(text, "{}", columns_of_cost(operations));
        }
        let _ = writeln!(text, "{why}");
    };
    row(words.columns, words.cost);
    for report in &account.stages {
        let name = pipeline::stage(lang, report.stage);
        let reason = pipeline::reason(lang, report.reason);
        if !report.ran {
            let why = format!("{}: {reason}", pipeline::left_out(lang));
            row([name, "–", "–", "", "–", &why], ["–"; 3]);
            continue;
        }
        let [entering, leaving] = report.counts.map_or_else(Default::default, |(i, o)| [i.to_string(), o.to_string()]);
        let time = match (report.time, report.stage.timed_with()) {
            (Some(time), _) => format!("{:.1}", micros(time)),
            (None, Some(_)) => "″".to_owned(),
            (None, None) => String::new(),
        };
        let operations = in_digits(report.operations);
        let operations = if report.stage.is_counted() { operations.each_ref().map(String::as_str) } else { ["·"; 3] };
        row([name, &entering, &leaving, pipeline::unit(lang, report), &time, &reason], operations);
    }
    let _ = writeln!(text, "\n{:<62} {:>9.1}  {}", words.total, micros(account.total), words.together);
    if cost {
        let sum = |which: &dyn Fn(Stage) -> bool| {
            let stages = account.stages.iter().filter(|report| which(report.stage));
            in_digits(stages.fold(Operations::NONE, |sum, report| sum.and(report.operations)))
        };
        let sums = [sum(&|stage| !stage.is_raster()), sum(&|stage| stage.is_raster()), sum(&|_| true)];
        text.push('\n');
        for (name, sum) in words.blocks.iter().zip(&sums) {
            let _ = writeln!(text, "{name:<73} {}", columns_of_cost(sum.each_ref().map(String::as_str)).trim_end());
        }
        let _ = writeln!(text, "\n{}", words.counted);
    }
    text
}

fn columns_of_cost([float, integer, memory]: [&str; 3]) -> String {
    format!("{float:>11} {integer:>11} {memory:>11}  ")
}

fn in_digits(Operations { float, integer, memory }: Operations) -> [String; 3] {
    [float.to_string(), integer.to_string(), memory.to_string()]
}
