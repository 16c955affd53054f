//! `camera-lab render`: a picture of a figure.

use std::path::Path;

use super::args::RenderArgs;
use super::{Failure, open, progress, say, scene, text_for_picture};
use crate::camera::{Camera, ImageSize};
use crate::cli::args::figure::{FigureArgs, size};
use crate::cli::args::words::written;
use crate::picture::{
    self, Beside, Composite, Handout, NoComposite, OnPaper, PictureError, PictureFile, SheetSize, gap,
};
use crate::pipeline::OverBudget;
use crate::progress::at_once;
use crate::sanitize;
use crate::views::{ObserverOf, Request, SharedScene, Shot, Size, View, unknown_labels};
use camera_lab_files::{self as files, Opened, Overwrite};
use camera_lab_words::window::{compare, labels as labels_words};
use camera_lab_words::{Lang, command_line as texts, families, handout, messages, pictures};

pub(super) fn run(args: &RenderArgs, lang: Lang) -> Result<(), Failure> {
    let out = &args.out;
    let name = sanitize::path(&out.output);
    let format = out.format(lang)?;
    let (given, scale) = (size(out.size.as_deref(), lang)?, out.scale(lang)?);
    let (paper, centimetres) = (out.on_paper(lang)?, out.centimetres(lang)?);
    let (mut opened, camera) = open(&args.figure, &args.common, lang)?;
    opened.figure.style.theme = out.theme.unwrap_or(opened.figure.style.theme);
    let scene = SharedScene::new(scene(&args.figure, &opened, &args.common, lang)?);
    let figure = &opened.figure;
    let count = args.view.views().count();
    let [width, height] = match (&paper, centimetres) {
        (Some(paper), [Some(width), height]) => on_paper(paper, width, height, figure.image, count),
        _ => pixels(given, figure.image, count, scale.unwrap_or(1.0)),
    };
    let (Ok(wide), Ok(high)) = (u32::try_from(width), u32::try_from(height)) else {
        return Err(no_picture(lang, &name, PictureError::TooLarge, [width, height]));
    };
    let labels = pictures::labels(written(args.common.lang));
    let shot = Shot::of(figure);
    let other = observer_of(out.observer_of.as_deref(), &args.common, lang)?;
    let spec = out.spec((args.view, SheetSize::Whole([wide, high])), (format, scale), paper);
    let size = Size { width: wide, height: high, scale: 1.0 };
    let request = Request::new(&shot, View::Image, &camera, &scene, labels, size);
    let request = Request { force_all_stages: args.force_all_stages, ..request };
    let sheet = progress::watched(lang, |progress| at_once(spec.sheet(&request, &shot, other.as_ref(), progress)));
    let sheet = sheet.map_err(|error| no_picture(lang, &name, error, [width, height]))?;
    let text = text_for_picture(&args.figure, &opened, &args.common, &out.output, lang);
    let written = written(args.common.lang);
    let told = pictures::told_of(written, &opened.figure, &sheet, text).for_file(&out.output);
    let made = progress::watched(lang, |progress| at_once(picture::file(&sheet, spec.options, &told, progress)));
    let file = made.map_err(|error| no_picture(lang, &name, error, [width, height]))?;
    report(&file, &sheet, spec.options.dpi, [&messages::opened(lang, &args.figure), &name], lang);
    if let Some(Err(error)) = figure.compare.as_ref().map(|comparison| comparison.other_side(figure)) {
        say(&format!("{}: {}", messages::opened(lang, &args.figure), compare::impossible(lang, &error)));
    }
    for (unknown, near) in unknown_labels(&shot, &scene) {
        let opened = messages::opened(lang, &args.figure);
        say(&format!("{opened}: {}", labels_words::unknown(lang, &unknown, near.as_deref())));
    }
    save(&out.output, &file.bytes, file.beside, lang)
}

/// Reports the shortcomings of a picture. `names` are those of the figure and of the picture.
pub(super) fn report(file: &PictureFile, sheet: &Composite, dpi: Option<f64>, [figure, name]: [&str; 2], lang: Lang) {
    if let Some(over_budget) = &file.over_budget {
        say(&format!("{figure}: {}", messages::over_budget(lang, over_budget)));
    }
    if let Some(points) = dpi.and_then(|dpi| sheet.tiny_letters(dpi)) {
        say(&format!("{name}: {}", pictures::tiny_letters(lang, points)));
    }
    if let Some(why) = &file.no_areas {
        say(&format!("{name}: {}", pictures::no_areas(lang, why)));
    }
    if let Some(crowded) = &sheet.crowded {
        say(&format!("{name}: {}", pictures::crowded(lang, crowded)));
    }
}

/// The figure of `--observer-of`, with its scene.
pub(super) fn observer_of(path: Option<&Path>, args: &FigureArgs, lang: Lang) -> Result<Option<ObserverOf>, Failure> {
    let Some(path) = path else { return Ok(None) };
    let (opened, camera) = open_other(path, lang)?;
    let scene = SharedScene::new(scene(path, &opened, args, lang)?);
    Ok(Some(ObserverOf { shot: Shot::of(&opened.figure), camera, scene }))
}

/// Opens another figure than the displayed one, with its camera.
pub(super) fn open_other(path: &Path, lang: Lang) -> Result<(Opened, Camera), Failure> {
    let name = messages::opened(lang, path);
    let opened = files::open_figure(path).map_err(|error| Failure::BadInput(messages::file(lang, &name, &error)))?;
    let camera = Camera::new(&opened.figure.camera)
        .map_err(|error| Failure::BadInput(format!("{name}: {}", messages::camera(lang, &error))))?;
    Ok((opened, camera))
}

/// Writes a picture, and the file beside it, if there is one.
pub(super) fn save(output: &Path, bytes: &[u8], beside: Option<Beside>, lang: Lang) -> Result<(), Failure> {
    let beside = beside.map(|Beside { name, bytes }| (output.with_file_name(name), bytes));
    let files = beside.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice())).chain([(output, bytes)]);
    for (path, bytes) in files {
        files::save(path, bytes, Overwrite::Writable)
            .map_err(|error| Failure::Failed(messages::file(lang, &sanitize::path(path), &error)))?;
    }
    Ok(())
}

/// Writes a handout as PDF.
pub(super) fn save_handout(made: &Handout, output: &Path, lang: Lang) -> Result<(), Failure> {
    let bytes = progress::watched(lang, |progress| at_once(made.pdf(progress)));
    let bytes = bytes.map_err(|error| no_picture(lang, &sanitize::path(output), error, handout::PICTURE))?;
    save(output, &bytes, None, lang)
}

/// The reason why there is no picture file of this size.
pub(super) fn no_picture(lang: Lang, name: &str, error: PictureError, [width, height]: [u64; 2]) -> Failure {
    let encoder = |format, why: &str| Failure::Failed(format!("{name}: {}", messages::encoder(lang, format, why)));
    match error {
        PictureError::TooLarge | PictureError::Composite(NoComposite::TooLarge) => {
            Failure::BadInput(texts::too_large(lang, width, height))
        }
        PictureError::Composite(NoComposite::UnevenRows { count, columns }) => {
            Failure::BadInput(families::uneven_rows(lang, count, columns))
        }
        PictureError::Composite(NoComposite::NoRoom { count, gap }) => {
            Failure::BadInput(texts::no_room(lang, count, [width, height], gap))
        }
        // The command line never cancels it. To cancel, the user ends the program.
        PictureError::Cancelled => Failure::Failed(format!("{name}: {error}")),
        PictureError::Strokes => {
            Failure::Failed(format!("{name}: {}", messages::over_budget(lang, &OverBudget::Strokes)))
        }
        PictureError::Font => Failure::Failed(format!("{name}: {error}")),
        PictureError::Png(error) => Failure::Failed(format!("{name}: {}", messages::png(lang, &error))),
        PictureError::Encode { format, why } => encoder(format.name(), &why),
        PictureError::Animate { format, why } => encoder(format.name(), &why),
    }
}

/// Width and height in pixels of a picture `width` centimetres wide. By default, as high as the figure's image, or as
/// `count` of them side by side.
fn on_paper(paper: &OnPaper, width: f64, height: Option<f64>, image: ImageSize, count: usize) -> [u64; 2] {
    let pixels = |centimetres| paper.pixels_across(centimetres);
    let width = pixels(width);
    let of_one = width / count.max(1) as f64;
    let height = height.map_or(of_one * f64::from(image.height) / f64::from(image.width), pixels);
    #[expect(clippy::cast_possible_truncation, reason = "positive; what is too large is refused")]
    let whole = |side: f64| side.round().max(1.0) as u64;
    [whole(width), whole(height)]
}

/// Width and height in pixels.
fn pixels(given: Option<ImageSize>, image: ImageSize, count: usize, scale: f32) -> [u64; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "positive, and at most 16384 · 16")]
    let scaled = |side: u32| (f64::from(side) * f64::from(scale)).round().max(1.0) as u64;
    let size = given.unwrap_or(image);
    let [width, height] = [size.width, size.height].map(scaled);
    // Without a size of the whole sheet, each picture on it has the size of the image.
    let count = u64::try_from(count.max(1)).unwrap_or(1);
    let width = if given.is_none() { count * width + (count - 1) * u64::from(gap(scale)) } else { width };
    [width, height]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paper_has_pixels() {
        let image = ImageSize { width: 640, height: 480 };
        let paper = OnPaper { dpi: 300.0, letters: Some(9.0), lines: None, arranged: false };
        assert_eq!(on_paper(&paper, 8.0, None, image, 1), [945, 709]);
        assert_eq!(on_paper(&paper, 8.0, None, image, 3), [945, 236]);
        assert_eq!(on_paper(&paper, 8.0, Some(6.0), image, 3), [945, 709]);
    }

    #[test]
    fn sizes_are_scaled_and_a_sheet_has_room_for_three() {
        let size = |width, height| ImageSize { width, height };
        assert_eq!(pixels(None, size(640, 480), 1, 1.0), [640, 480]);
        assert_eq!(pixels(Some(size(5, 7)), size(640, 480), 3, 1.5), [8, 11]);
        assert_eq!(pixels(None, size(640, 480), 3, 2.0), [3 * 1280 + 16, 960]);
        assert_eq!(pixels(None, size(1, 1), 1, 0.1), [1, 1]);
        assert_eq!(pixels(None, size(16_384, 16_384), 1, 16.0), [262_144, 262_144]);
    }
}
