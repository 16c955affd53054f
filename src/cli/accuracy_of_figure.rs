//! `camera-lab accuracy FIGURE`: error, time and memory of each way to draw the figure.

use std::path::Path;

use super::args::AccuracyArgs;
use super::render::save;
use super::{Failure, OpenFigure, json_of, print, progress};
use crate::cli::args::figure::size;
use crate::cli::args::words::DataFormat;
use crate::export::plot::{self, Block};
use crate::numerics::this_figure::{self, Effort, SECONDS, Study, Subject};
use crate::progress::{Progress, at_once};
use crate::sanitize;
use camera_lab_words::why::this_figure as words;
use camera_lab_words::{Lang, messages, pictures};

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
        DataFormat::Json => json_of(&study.data(|why| words::why_not(*written, why)))?,
        DataFormat::Csv => study.csv().map_err(|error| Failure::Failed(error.to_string()))?,
    };
    print(text.as_bytes(), lang)
}
