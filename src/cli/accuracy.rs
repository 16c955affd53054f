//! `camera-lab accuracy`: error against run time.

use serde::Serialize;

use super::args::AccuracyArgs;
use super::render::save;
use super::{Failure, accuracy_of_figure, json_of, print, progress};
use crate::cli::args::words::{DataFormat, written};
use crate::export::plot::{self, Block};
use crate::numerics::overhead::{self, Price};
use crate::numerics::{self, Effort, Findings, Study};
use crate::progress::at_once;
use crate::sanitize;
use camera_lab_words::why::numerics as words;
use camera_lab_words::{Lang, command_line as texts};

/// The JSON output.
#[derive(Serialize)]
struct Accuracy<'a> {
    seed: u64,
    studies: &'a [Findings],
    /// With all studies only.
    #[serde(skip_serializing_if = "Option::is_none")]
    price: Option<Price>,
}

/// A line of a table for spreadsheets: a row without its figure.
#[derive(Serialize)]
struct StudyLine<'a> {
    study: Study,
    case: &'a str,
    parameter: f64,
    method: &'a str,
    error: f64,
    error_max: f64,
    unit: &'static str,
    nanos: f64,
    bits: f64,
    pareto: bool,
    predicted: Option<f64>,
    nanos_low: f64,
    nanos_high: f64,
    bytes: f64,
    undecided: bool,
}

pub(super) fn run(args: &AccuracyArgs, lang: Lang) -> Result<(), Failure> {
    if let Some(figure) = &args.figure {
        return accuracy_of_figure::run(figure, args, lang);
    }
    if !args.common.is_plain() {
        return Err(Failure::BadInput(texts::without_figure(lang)));
    }
    let (studies, seconds, seed) = (args.studies(), args.seconds(20.0, lang)?, args.seed(lang)?);
    let plot = args.plot(lang)?;
    let effort = Effort { seed, seconds: seconds / studies.len().max(1) as f64, thorough: true };
    let (findings, price) = progress::watched(lang, |progress| {
        let findings: Vec<Findings> =
            studies.iter().map(|&study| at_once(numerics::run(study, &effort, progress))).collect();
        let price = (studies.len() == Study::ALL.len()).then(|| overhead::measure(&effort, progress));
        (findings, price.flatten())
    });
    // Output and files don't depend on the system's language.
    let written = written(args.common.lang);
    if let Some((path, format)) = plot {
        let name = sanitize::path(path);
        let (bytes, beside) = plot::encode(&blocks(written, &findings), written.tag(), format, path)
            .map_err(|error| Failure::Failed(format!("{name}: {error}")))?;
        save(path, &bytes, beside, lang)?;
    }
    let text = match args.format {
        DataFormat::Text => {
            let tables = findings.iter().map(|f| words::table(written, f));
            let price = price.map(|price| words::price(written, &price));
            tables.chain(price).collect::<Vec<_>>().join("\n")
        }
        DataFormat::Json => json_of(&Accuracy { seed, studies: &findings, price })?,
        DataFormat::Csv => csv_of(&findings).map_err(|error| Failure::Failed(error.to_string()))?,
    };
    print(text.as_bytes(), lang)
}

/// The charts of all studies, a block each.
fn blocks(lang: Lang, findings: &[Findings]) -> Vec<Block> {
    let block = |findings: &Findings| Block {
        title: words::title(lang, findings.study).to_owned(),
        rows: words::with_words(lang, findings.study, |words| {
            let pairs = findings.cases().into_iter().map(|case| findings.charts(case, words));
            pairs.map(|pair| vec![pair.by_parameter, pair.by_time]).collect()
        }),
    };
    findings.iter().map(block).collect()
}

fn csv_of(findings: &[Findings]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for Findings { study, rows, .. } in findings {
        for row in rows {
            writer.serialize(StudyLine {
                study: *study,
                case: &row.case,
                parameter: row.parameter,
                method: row.method,
                error: row.error,
                error_max: row.error_max,
                unit: row.unit.name(),
                nanos: row.nanos,
                bits: row.bits,
                pareto: row.pareto,
                predicted: row.predicted,
                nanos_low: row.nanos_low,
                nanos_high: row.nanos_high,
                bytes: row.bytes,
                undecided: row.undecided,
            })?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
