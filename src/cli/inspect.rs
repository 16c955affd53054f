//! `camera-lab inspect`: every number of a figure's camera.

use super::args::InspectArgs;
use super::{Failure, open, print, say};
use crate::camera::ImageSize;
use crate::explain::{self, DepthPixelReport, Setting};
use crate::inspect::{InspectError, Report};
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
    let report = report.with_cameras(figure, args.ndc).map_err(bad_input)?;
    let setting = Setting::new(space, figure.image, figure.viewport);
    let way_back = |(pixel, depth): ([i64; 2], f64)| {
        DepthPixelReport::new(&setting, pixel, depth)
            .map_err(|error| bad_input(InspectError::DepthPixel { pixel, error }))
    };
    let ways = depth_pixels.iter().copied().map(way_back).collect::<Result<Vec<_>, _>>()?;
    let ImageSize { width, height } = figure.image;
    let is_inside = |[i, j]: [i64; 2]| (0..i64::from(width)).contains(&i) && (0..i64::from(height)).contains(&j);
    let asked = pixels.into_iter().chain(depth_pixels.into_iter().map(|(pixel, _)| pixel));
    for pixel in asked.filter(|pixel| !is_inside(*pixel)) {
        say(&texts::pixel_outside(lang, pixel, figure.image));
    }
    print(args.to_text(|| explain::json(&report, &setting, args.trace, &ways)).as_bytes(), lang)
}
