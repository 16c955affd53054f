//! `camera-lab accuracy FIGURE`: error, time and memory of each way to draw the figure.

use std::path::Path;

use serde::Serialize;
use serde_json::{Map, Value as Json, json};

use super::args::AccuracyArgs;
use super::render::save;
use super::{Failure, OpenFigure, json_of, print, progress};
use crate::cli::args::figure::size;
use crate::cli::args::words::DataFormat;
use crate::export::plot::{self, Block};
use crate::numerics::this_figure::{self, Effort, SAMPLES, SECONDS, Study, Subject, Value};
use crate::progress::{Progress, at_once};
use crate::sanitize;
use camera_lab_words::why::this_figure as words;
use camera_lab_words::{Lang, messages, pictures};

/// The JSON output.
#[derive(Serialize)]
struct Accuracy {
    size: [u32; 2],
    choices: Map<String, Json>,
    left_out: Vec<Json>,
    /// Sections of the figure that neither image shows.
    set_aside: Vec<&'static str>,
    reference: Json,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    set: Map<String, Json>,
    different: f64,
    wrong: f64,
    rms: f64,
    ms: [f64; 3],
    bytes: usize,
    front: bool,
    undecided: bool,
    yours: bool,
    cheapest: bool,
}

pub(super) fn run(path: &Path, args: &AccuracyArgs, lang: Lang) -> Result<(), Failure> {
    let effort = Effort { seconds: args.seconds(SECONDS, lang)?, within: args.within(lang)? };
    let plot = args.plot(lang)?;
    let subject = OpenFigure::open(path, &args.common, size(args.size.as_deref(), lang)?, lang)?;
    let OpenFigure { opened, camera, scene, size, lang: written } = &subject;
    let figure = &opened.figure;
    let labels = pictures::labels(*written);
    let (request, set_aside) = this_figure::request_of(figure, scene, camera, labels, *size);
    let of = Subject { figure, scene, request: &request };
    let study = progress::watched(lang, |progress| at_once(this_figure::study(of, effort, progress, |_| ())));
    let study = study.map_err(|error| {
        Failure::BadInput(format!("{}: {}", messages::opened(lang, path), words::no_exact_image(lang, error)))
    })?;
    let study = Study { set_aside, ..study };
    if let Some(reference) = &args.reference {
        let png = at_once(study.exact.pixels.clone().into_png("", None, None, &Progress::default()));
        let name = sanitize::path(reference);
        let bytes = png.map_err(|error| Failure::Failed(format!("{name}: {}", messages::png(lang, &error))))?;
        save(reference, &bytes, None, lang)?;
    }
    if let Some((path, format)) = plot {
        let chart = words::with_words(*written, &figure.scene, |words| study.chart(study.telling(), words));
        let block = Block { title: String::new(), rows: vec![vec![chart]] };
        let (bytes, beside) = plot::encode(&[block], written.tag(), format, path)
            .map_err(|error| Failure::Failed(format!("{}: {error}", sanitize::path(path))))?;
        save(path, &bytes, beside, lang)?;
    }
    let text = match args.format {
        DataFormat::Text => words::table(*written, &figure.scene, &study),
        DataFormat::Json => json_of(&answer(&study, *written))?,
        DataFormat::Csv => csv_of(&study).map_err(|error| Failure::Failed(error.to_string()))?,
    };
    print(text.as_bytes(), lang)
}

fn json_value(value: Value) -> Json {
    match value {
        Value::Word(word) => json!(word),
        Value::Number(number) if number.fract() == 0.0 => {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number of samples or texels"
            )]
            let whole = number as u64;
            json!(whole)
        }
        Value::Number(number) => json!(number),
    }
}

fn rows(study: &Study) -> impl Iterator<Item = Row> {
    study.ways.iter().enumerate().map(|(place, way)| Row {
        set: study.set(way).map(|(key, value)| (key.path(), json_value(value))).collect(),
        different: way.cost.different,
        wrong: way.cost.wrong,
        rms: way.cost.rms,
        ms: [way.ms.median, way.ms.low, way.ms.high],
        bytes: way.cost.bytes,
        front: way.front,
        undecided: way.undecided,
        yours: place == study.yours,
        cheapest: place == study.cheapest,
    })
}

fn answer(study: &Study, lang: Lang) -> Accuracy {
    let choice = |choice: &this_figure::Choice| {
        (choice.key.path(), choice.values.iter().copied().map(json_value).collect::<Vec<Json>>().into())
    };
    let left_out = |out: &this_figure::LeftOut| json!({ "key": out.key, "reason": words::why_not(lang, out.why) });
    Accuracy {
        size: study.size,
        choices: study.choices.iter().map(choice).collect(),
        left_out: study.left_out.iter().map(left_out).collect(),
        set_aside: study.set_aside.clone(),
        reference: json!({ "samples": SAMPLES, "rays": study.exact.rays }),
        rows: rows(study).collect(),
    }
}

/// A line for each way: a column for each key, then the numbers.
fn csv_of(study: &Study) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let numbers =
        ["different", "wrong", "rms", "ms", "ms_low", "ms_high", "bytes", "front", "undecided", "yours", "cheapest"];
    let keys = study.choices.iter().map(|choice| choice.key.path());
    writer.write_record(keys.chain(numbers.map(str::to_owned)))?;
    for row in rows(study) {
        let values = row.set.values().map(|value| value.as_str().map_or_else(|| value.to_string(), str::to_owned));
        let [ms, low, high] = row.ms;
        let floats = [row.different, row.wrong, row.rms, ms, low, high].map(|number| number.to_string());
        let flags = [row.front, row.undecided, row.yours, row.cheapest].map(|flag| flag.to_string());
        writer.write_record(values.chain(floats).chain([row.bytes.to_string()]).chain(flags))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
