//! `camera-lab sheet`: a family of pictures on one sheet.

use std::path::Path;

use super::render::{no_picture, observer_of, report, save};
use super::{Failure, open, progress, scene, text_for_picture};
use crate::camera::Camera;
use crate::cli::args::figure::{FigureArgs, size};
use crate::cli::args::sheet::SheetArgs;
use crate::cli::args::words::written;
use crate::figure::variation::{Variant, Variation, VariationError, variants};
use crate::limits::MAX_FAMILY;
use crate::picture::{self, Family, SheetSize};
use crate::progress::at_once;
use crate::sanitize;
use crate::views::{Request, SharedScene, Shot, Size, View};
use camera_lab_files::Opened;
use camera_lab_words::{Lang, families, messages, pictures};

/// The width of each picture in pixels if no size is given.
const WIDTH: u32 = 480;

pub(super) fn run(args: &SheetArgs, lang: Lang) -> Result<(), Failure> {
    let name = sanitize::path(&args.out.output);
    let format = args.out.format(lang)?;
    let (given, scale) = (size(args.out.size.as_deref(), lang)?, args.out.scale(lang)?);
    let (paper, centimetres) = (args.out.on_paper(lang)?, args.out.centimetres(lang)?);
    let variations = args.family.variations(None, lang)?;
    if !(1..=2).contains(&variations.len()) {
        return Err(Failure::BadInput(families::variations(lang, variations.len(), 2)));
    }
    let columns = args.columns(lang)?;
    let (mut opened, camera) = open(&args.figure, &args.common, lang)?;
    opened.figure.style.theme = args.out.theme.unwrap_or(opened.figure.style.theme);
    let of_figures = members(&args.figure, &opened, (&args.common, &camera), &variations, MAX_FAMILY, lang)?;
    let labels = pictures::labels(written(args.common.lang));
    let views = args.view.views().count().max(1);
    if of_figures.len() * views > MAX_FAMILY {
        let error = VariationError::TooMany { count: of_figures.len() * views, limit: MAX_FAMILY };
        return Err(Failure::BadInput(families::error(lang, &error)));
    }
    let image = opened.figure.image;
    let size = match (&paper, centimetres, given) {
        (Some(paper), [Some(width), Some(height)], _) => {
            SheetSize::Whole([width, height].map(|side| whole(paper.pixels_across(side))))
        }
        (Some(paper), [Some(width), None], _) => SheetSize::Width(whole(paper.pixels_across(width))),
        (_, _, Some(size)) => {
            let scaled = |side: u32| whole(f64::from(side) * f64::from(scale.unwrap_or(1.0)));
            SheetSize::Whole([size.width, size.height].map(scaled))
        }
        _ => {
            let width = f64::from(WIDTH) * f64::from(scale.unwrap_or(1.0));
            SheetSize::Pictures([whole(width), whole((width / image.aspect()).max(1.0))])
        }
    };
    let spec = args.out.spec((args.view, size), (format, scale), paper);
    let pixels = spec.pixels();
    let size_of_words = Size { width: pixels[0], height: pixels[1], scale: scale.unwrap_or(1.0) };
    let shot = Shot::of(&opened.figure);
    let base = of_figures.first().map(|(_, scene)| scene.clone()).unwrap_or_default();
    let request = Request::new(&shot, View::Image, &camera, &base, labels, size_of_words);
    let family = Family {
        members: of_figures,
        views: args.view,
        columns,
        parts: args.parts,
        captions: args.captions.clone(),
        observer_of: observer_of(args.out.observer_of.as_deref(), &args.common, lang)?,
    };
    let sheet =
        spec.family(&family, &request).map_err(|error| no_picture(lang, &name, error.into(), pixels.map(u64::from)))?;
    let written = written(args.common.lang);
    let text = text_for_picture(&args.figure, &opened, &args.common, &args.out.output, lang);
    let told = pictures::told_of(written, &opened.figure, &sheet, text).for_file(&args.out.output);
    let made = progress::watched(lang, |progress| at_once(picture::file(&sheet, spec.options, &told, progress)));
    let file = made.map_err(|error| no_picture(lang, &name, error, pixels.map(u64::from)))?;
    report(&file, &sheet, spec.options.dpi, [&messages::opened(lang, &args.figure), &name], lang);
    save(&args.out.output, &file.bytes, file.beside, lang)
}

/// The figures of a family, each with its scene. Those with the same objects share one.
pub(super) fn members(
    path: &Path,
    opened: &Opened,
    (args, camera): (&FigureArgs, &Camera),
    variations: &[Variation],
    limit: usize,
    lang: Lang,
) -> Result<Vec<(Variant, SharedScene)>, Failure> {
    let name = messages::opened(lang, path);
    let figures = variants(&opened.figure, camera, variations, args.convention, limit)
        .map_err(|error| Failure::BadInput(format!("{name}: {}", families::error(lang, &error))))?;
    picture::members(figures, |figure| {
        let own = Opened { figure: figure.clone(), ..opened.clone() };
        Ok(SharedScene::new(scene(path, &own, args, lang)?))
    })
}

/// Rounds to whole pixels. Sizes that are too large are refused when the pictures are drawn.
fn whole(side: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, reason = "what is too large is refused")]
    let side = side.round().max(1.0) as u32;
    side
}
