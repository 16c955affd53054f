//! `camera-lab inspect`: every number of a figure's camera.

use super::args::InspectArgs;
use super::{Failure, open, print, say};
use crate::camera::ImageSize;
use crate::foreign;
use crate::i18n::{Lang, command_line as texts, messages};
use crate::inspect::{InspectError, Report};

pub(super) fn run(args: &InspectArgs, lang: Lang) -> Result<(), Failure> {
    let (points, pixels) = (args.points(lang)?, args.pixels(lang)?);
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let figure = &opened.figure;
    let report = camera
        .clip_space(args.ndc)
        .map_err(InspectError::from)
        .and_then(|space| Report::of(&space, figure.image, figure.viewport, &points, &pixels))
        .map_err(|error| {
            Failure::BadInput(format!("{}: {}", foreign::path(&args.figure), messages::inspect(lang, &error)))
        })?;
    let ImageSize { width, height } = figure.image;
    let is_inside = |[i, j]: [i64; 2]| (0..i64::from(width)).contains(&i) && (0..i64::from(height)).contains(&j);
    for pixel in pixels.into_iter().filter(|pixel| !is_inside(*pixel)) {
        say(&texts::pixel_outside(lang, pixel, figure.image));
    }
    print(args.to_text(&report).as_bytes(), lang)
}
