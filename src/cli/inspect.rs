//! `camera-lab inspect`: every number of a figure's camera.

use serde_json::Value;

use super::args::InspectArgs;
use super::args::figure::CameraStep;
use super::args::words::{Format, written};
use super::{Failure, open, print, say};
use crate::camera::{ImageSize, Operation};
use crate::explain::{self, DepthPixelReport, Setting};
use crate::figure::Figure;
use crate::inspect::{Bounds, InspectError, Report, for_terminals, json_text};
use camera_lab_files as files;
use camera_lab_words::{Lang, command_line as texts, messages};

pub(super) fn run(args: &InspectArgs, lang: Lang) -> Result<(), Failure> {
    let (points, pixels, depth_pixels) = (args.points(lang)?, args.pixels(lang)?, args.depth_pixels(lang)?);
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let figure = &opened.figure;
    let bad_input = |error: InspectError| {
        Failure::BadInput(format!("{}: {}", messages::opened(lang, &args.figure), messages::inspect(lang, &error)))
    };
    let space = camera.clip_space(args.ndc).map_err(|error| bad_input(error.into()))?;
    let report = Report::of(&space, figure.image, figure.viewport, &points, &pixels).map_err(bad_input)?;
    let report = report.with_cameras(figure, &space, &points).map_err(bad_input)?;
    let setting = Setting::new(space, figure.image, figure.viewport);
    let way_back = |(pixel, depth): ([i64; 2], f64)| {
        DepthPixelReport::new(&setting, pixel, depth)
            .map_err(|error| bad_input(InspectError::DepthPixel { pixel, error }))
    };
    let ways = depth_pixels.iter().copied().map(way_back).collect::<Result<Vec<_>, _>>()?;
    let ImageSize { width, height } = figure.image;
    let bounds = if args.bounds { Some(bounds(args, &report, figure, lang)?) } else { None };
    let is_inside = |[i, j]: [i64; 2]| (0..i64::from(width)).contains(&i) && (0..i64::from(height)).contains(&j);
    let asked = pixels.into_iter().chain(depth_pixels.into_iter().map(|(pixel, _)| pixel));
    for pixel in asked.filter(|pixel| !is_inside(*pixel)) {
        say(&texts::pixel_outside(lang, pixel, figure.image));
    }
    let json = explain::json(&report, &setting, args.trace, &ways, bounds.as_ref());
    let text = match args.format {
        Format::Json => json_text(&json),
        Format::Text => list(written(args.common.lang), json, bounds.as_ref()),
    };
    print(text.as_bytes(), lang)
}

/// The bounds of a report, from the numbers of the figure as its file has them, before the operations.
fn bounds(args: &InspectArgs, report: &Report, figure: &Figure, lang: Lang) -> Result<Bounds, Failure> {
    let name = messages::opened(lang, &args.figure);
    let given = files::open_figure(&args.figure);
    let given = given.map_err(|error| Failure::BadInput(messages::file(lang, &name, &error)))?.figure.camera;
    let steps = args.common.steps(lang)?.into_iter().map(|step| match step {
        CameraStep::Operation(operation) => Some(operation),
        CameraStep::Framing(..) => None,
    });
    // Steps about objects give a camera with numbers of its own.
    let operations: Option<Vec<Operation>> = steps.collect();
    let given = if operations.is_some() { given } else { figure.camera };
    let operations = operations.unwrap_or_default();
    let way = (&given, &operations[..], args.common.convention);
    Ok(Bounds::new(report, way, args.ndc, (figure.image, figure.viewport)))
}

/// Each number of the report on a line, with its bounds and the digits that they prove, and then what the questions
/// themselves lose.
fn list(lang: Lang, mut json: Value, bounds: Option<&Bounds>) -> String {
    let mut proofs = Value::Null;
    if let Some(parts) = json.as_object_mut() {
        parts.remove("condition");
        proofs = parts.remove("bounds").unwrap_or_default();
    }
    let mut text = String::new();
    write_lines(lang, "", &json, &proofs, &mut text);
    text += &bounds.map(|bounds| texts::conditions(lang, &bounds.condition)).unwrap_or_default();
    for_terminals(&text)
}

/// Writes the numbers and names below a path, each with its bounds if it has any.
fn write_lines(lang: Lang, path: &str, json: &Value, proofs: &Value, text: &mut String) {
    let parts: Vec<(String, &Value)> = match json {
        Value::Array(items) => items.iter().enumerate().map(|(i, item)| (i.to_string(), item)).collect(),
        Value::Object(fields) => fields.iter().map(|(name, item)| (name.clone(), item)).collect(),
        _ => {
            let pair = proofs.pointer(path).cloned();
            let proof = pair.map(|pair| texts::bounds(lang, serde_json::from_value(pair).ok())).unwrap_or_default();
            let line =
                format!("{:<28} {:<24} {proof}", path.replace('/', ".").trim_start_matches('.'), json.to_string());
            *text += line.trim_end();
            return text.push('\n');
        }
    };
    for (name, part) in parts {
        write_lines(lang, &format!("{path}/{name}"), part, proofs, text);
    }
}
