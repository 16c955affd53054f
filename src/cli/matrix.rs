//! `camera-lab matrix`: the camera of a matrix from another program.

use std::fmt::Write as _;

use serde::Serialize;

use super::{Failure, open, print};
use crate::camera::{MatrixEntries, MatrixKind, Recognised, Stated, Unknown, recognise};
use crate::cli::args::matrix::MatrixArgs;
use crate::cli::args::words::{LangArg, TableFormat};
use crate::figure::update;
use crate::i18n::Lang;
use crate::i18n::why::dialects;
use crate::inspect::CameraReport;

/// The JSON output.
#[derive(Serialize)]
struct Answer {
    #[serde(rename = "as")]
    kind: &'static str,
    axes: &'static str,
    by_columns: bool,
    evidence: &'static str,
    others: Vec<&'static str>,
    camera: CameraReport,
    image: [u32; 2],
    unknown: Vec<Open>,
}

/// A quantity that the matrix leaves open, or another notice.
#[derive(Serialize)]
struct Open {
    code: &'static str,
    message: &'static str,
}

pub(super) fn run(args: &MatrixArgs, lang: Lang) -> Result<(), Failure> {
    let refused = |why: String| Failure::BadInput(format!("--numbers: {why}"));
    let entries = MatrixEntries::read(&args.numbers).map_err(|fault| refused(dialects::unreadable(lang, &fault)))?;
    let size = args.size(lang)?;
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let mut figure = opened.figure;
    let stated = Stated {
        kind: args.kind,
        axes: args.axes,
        by_columns: args.columns,
        ndc: args.ndc,
        image: size.unwrap_or(figure.image),
    };
    let found = recognise(&entries, &stated, camera.parameters())
        .map_err(|error| refused(dialects::recovery_error(lang, &error)))?;
    figure.camera = found.found.parameters;
    if found.reading.kind == MatrixKind::Pinhole {
        figure.image = found.reading.image;
    }
    let written = args.common.lang.map_or(Lang::En, LangArg::lang);
    let text = match args.format {
        TableFormat::Json => {
            let answer = Answer::new(&found, written);
            serde_json::to_string_pretty(&answer).map_err(|error| Failure::Failed(error.to_string()))? + "\n"
        }
        TableFormat::Text => comments(&found, written) + &update(&opened.text, &figure),
    };
    print(text.as_bytes(), lang)
}

impl Answer {
    fn new(found: &Recognised, lang: Lang) -> Self {
        let Recognised { reading, by_columns, evidence, found, others } = found;
        let open = |unknown: &Unknown| Open { code: unknown.code(), message: dialects::unknown(lang, *unknown) };
        Self {
            kind: reading.kind.name(),
            axes: reading.axes.name(),
            by_columns: *by_columns,
            evidence: evidence.name(),
            others: others.iter().map(|kind| kind.name()).collect(),
            camera: CameraReport::new(&found.parameters),
            image: [reading.image.width, reading.image.height],
            unknown: found.unknown.iter().map(open).collect(),
        }
    }
}

/// How the matrix was read, and what it leaves open, as comments of a figure file.
fn comments(found: &Recognised, lang: Lang) -> String {
    let mut text = format!("# {}\n", dialects::reading(lang, &found.reading, found.by_columns, found.evidence));
    for kind in &found.others {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "# --as {}: {}", kind.name(), dialects::kind(lang, *kind));
    }
    for unknown in &found.found.unknown {
        let _ = writeln!(text, "# {}", dialects::unknown(lang, *unknown));
    }
    text + "\n"
}
