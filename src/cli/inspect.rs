//! `camera-lab inspect`: every number of a figure's camera.

use super::args::InspectArgs;
use super::{Failure, open, print};
use crate::foreign;
use crate::i18n::{Lang, messages};
use crate::inspect::Report;

pub(super) fn run(args: &InspectArgs, lang: Lang) -> Result<(), Failure> {
    let (points, pixels) = (args.points(lang)?, args.pixels(lang)?);
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let figure = &opened.figure;
    let report = Report::of(&camera, figure.image, figure.viewport, &points, &pixels).map_err(|error| {
        Failure::BadInput(format!("{}: {}", foreign::path(&args.figure), messages::inspect(lang, &error)))
    })?;
    print(args.to_text(&report).as_bytes(), lang)
}
