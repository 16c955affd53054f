//! `camera-lab render`: a picture of a figure.

use std::path::Path;

use super::args::RenderArgs;
use super::words::LangArg;
use super::{Failure, open, progress, say, scene};
use crate::camera::ImageSize;
use crate::export::format::PictureFormat;
use crate::figure::update;
use crate::files::{self, Overwrite};
use crate::i18n::{Lang, command_line as texts, compare, messages, pictures};
use crate::picture::{self, Beside, Composite, FileOptions, NoComposite, OnPaper, PictureError, PictureFile, gap};
use crate::pipeline::OverBudget;
use crate::progress::at_once;
use crate::sanitize;
use crate::views::{Finish, Request, SharedScene, Shot, Size, View, Views};

pub(super) fn run(args: &RenderArgs, lang: Lang) -> Result<(), Failure> {
    let name = sanitize::path(&args.output);
    let format = PictureFormat::of(&args.output).ok_or_else(|| Failure::BadInput(texts::ending(lang, &name)))?;
    if args.transparent && !format.has_transparency() {
        return Err(Failure::BadInput(texts::no_transparency(lang, format)));
    }
    let (given, scale) = (args.size(lang)?, args.scale(lang)?);
    let (paper, centimetres) = (args.paper(lang)?, args.centimetres(lang)?);
    let (mut opened, camera) = open(&args.figure, &args.common, lang)?;
    opened.figure.style.theme = args.theme().unwrap_or(opened.figure.style.theme);
    let scene = SharedScene::new(scene(&args.figure, &opened, &args.common, lang)?);
    let figure = &opened.figure;
    let all = args.view == Views::All;
    let [width, height] = match (&paper, centimetres) {
        (Some(paper), [Some(width), height]) => on_paper(paper, width, height, figure.image, all),
        _ => pixels(given, figure.image, all, scale.unwrap_or(1.0)),
    };
    let size = match (u32::try_from(width), u32::try_from(height)) {
        (Ok(width), Ok(height)) => sized(width, height, scale, paper.as_ref()),
        _ => return Err(no_picture(lang, &name, PictureError::TooLarge, [width, height])),
    };
    let labels = pictures::labels(args.common.lang.map_or(Lang::En, LangArg::lang));
    let shot = Shot::of(figure);
    let request = Request::new(&shot, View::Image, &camera, &scene, labels, size);
    let finish = Finish { transparent: args.transparent, ..Finish::default() };
    let request = Request { force_all_stages: args.force_all_stages, finish, ..request };
    let sheet = Composite::of(args.view, &request, &shot, paper.as_ref())
        .map_err(|error| no_picture(lang, &name, error.into(), [width, height]))?;
    let text = update(&opened.text, &opened.figure);
    // Letters and lines in points have a resolution, too, by which vectors are measured.
    let dpi = paper.filter(|_| args.is_for_paper() || format.is_vector()).map(|paper| paper.dpi);
    let form = FileOptions { format, crop: args.crop, dpi, faces: args.faces, letters: args.outlines() };
    let written = args.common.lang.map_or(Lang::En, LangArg::lang);
    let told = pictures::told_of(written, &opened.figure, &sheet, text).for_file(&args.output);
    let made = progress::watched(lang, |progress| at_once(picture::file(&sheet, form, &told, progress)));
    let PictureFile { bytes, beside, too_much, no_areas } =
        made.map_err(|error| no_picture(lang, &name, error, [width, height]))?;
    if let Some(too_much) = too_much {
        say(&format!("{}: {}", messages::opened(lang, &args.figure), messages::too_much(lang, &too_much)));
    }
    if let Some(points) = dpi.and_then(|dpi| sheet.tiny_letters(dpi)) {
        say(&format!("{name}: {}", pictures::tiny_letters(lang, points)));
    }
    if let Some(why) = no_areas {
        say(&format!("{name}: {}", pictures::no_areas(lang, &why)));
    }
    if let Some(Err(error)) = figure.compare.as_ref().map(|comparison| comparison.other_side(figure)) {
        say(&format!("{}: {}", messages::opened(lang, &args.figure), compare::impossible(lang, &error)));
    }
    if let Some(crowded) = &sheet.crowded {
        say(&format!("{name}: {}", pictures::crowded(lang, crowded)));
    }
    save(&args.output, &bytes, beside, lang)
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

/// The reason why there is no picture file of this size.
pub(super) fn no_picture(lang: Lang, name: &str, error: PictureError, [width, height]: [u64; 2]) -> Failure {
    let encoder = |format, why: &str| Failure::Failed(format!("{name}: {}", messages::encoder(lang, format, why)));
    match error {
        PictureError::TooLarge | PictureError::Composite(NoComposite::TooLarge) => {
            Failure::BadInput(texts::too_large(lang, width, height))
        }
        PictureError::Composite(NoComposite::NoRoom { count, gap }) => {
            Failure::BadInput(texts::no_room(lang, count, [width, height], gap))
        }
        // Nobody cancels it: whoever wants to ends the program.
        PictureError::Cancelled => Failure::Failed(format!("{name}: {error}")),
        PictureError::Strokes => Failure::Failed(format!("{name}: {}", messages::too_much(lang, &OverBudget::Strokes))),
        PictureError::Font => Failure::Failed(format!("{name}: {error}")),
        PictureError::Png(error) => Failure::Failed(format!("{name}: {}", messages::png(lang, &error))),
        PictureError::Encode { format, why } => encoder(format.name(), &why),
        PictureError::Animate { format, why } => encoder(format.name(), &why),
    }
}

/// A picture with strokes and letters as they are wanted: by a scale, by the height of letters in pixels, or as on a
/// screen.
fn sized(width: u32, height: u32, scale: Option<f32>, paper: Option<&OnPaper>) -> Size {
    let letters = paper.and_then(|paper| Some(paper.pixels(paper.letters?)));
    #[expect(clippy::cast_possible_truncation, reason = "the height of letters")]
    match (scale, letters) {
        (Some(scale), _) => Size { width, height, scale },
        (None, Some(letters)) => Size::with_letters(width, height, letters as f32),
        (None, None) => Size::as_on_a_screen(width, height),
    }
}

/// Width and height in pixels of a picture `width` centimetres wide; by default, as high as the figure's image, or as
/// three of them side by side.
fn on_paper(paper: &OnPaper, width: f64, height: Option<f64>, image: ImageSize, all: bool) -> [u64; 2] {
    let pixels = |centimetres| paper.pixels_across(centimetres);
    let width = pixels(width);
    let of_one = if all { width / 3.0 } else { width };
    let height = height.map_or(of_one * f64::from(image.height) / f64::from(image.width), pixels);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive; what is too large is refused"
    )]
    let whole = |side: f64| side.round().max(1.0) as u64;
    [whole(width), whole(height)]
}

/// Width and height in pixels.
fn pixels(given: Option<ImageSize>, image: ImageSize, all: bool, scale: f32) -> [u64; 2] {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive, and at most 16384 · 16")]
    let scaled = |side: u32| (f64::from(side) * f64::from(scale)).round().max(1.0) as u64;
    let size = given.unwrap_or(image);
    let [width, height] = [size.width, size.height].map(scaled);
    // Without a size of the whole sheet, each picture on it has the size of the image.
    let width = if all && given.is_none() { 3 * width + 2 * u64::from(gap(scale)) } else { width };
    [width, height]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paper_has_pixels_and_letters_have_points() {
        let image = ImageSize { width: 640, height: 480 };
        let paper = OnPaper { dpi: 300.0, letters: Some(9.0), lines: None, arranged: false };
        assert_eq!(on_paper(&paper, 8.0, None, image, false), [945, 709]);
        assert_eq!(on_paper(&paper, 8.0, None, image, true), [945, 236]);
        assert_eq!(on_paper(&paper, 8.0, Some(6.0), image, true), [945, 709]);
        // 9 pt at 300 dpi.
        assert!((sized(945, 709, None, Some(&paper)).letters() - 37.5).abs() < 0.1);
        assert_eq!(sized(3000, 2250, None, None).scale, 3000.0 / 1920.0);
        assert_eq!(sized(3000, 2250, Some(1.0), None).scale, 1.0);
    }

    #[test]
    fn sizes_are_scaled_and_a_sheet_has_room_for_three() {
        let size = |width, height| ImageSize { width, height };
        assert_eq!(pixels(None, size(640, 480), false, 1.0), [640, 480]);
        assert_eq!(pixels(Some(size(5, 7)), size(640, 480), true, 1.5), [8, 11]);
        assert_eq!(pixels(None, size(640, 480), true, 2.0), [3 * 1280 + 16, 960]);
        assert_eq!(pixels(None, size(1, 1), false, 0.1), [1, 1]);
        assert_eq!(pixels(None, size(16_384, 16_384), false, 16.0), [262_144, 262_144]);
    }
}
