//! `camera-lab animate`: the view volume becomes the canonical one, step by step, as an animation or as a strip of
//! stills. Families and ways to other cameras are in `sweep`.

use super::args::AnimateArgs;
use super::render::{no_picture, save};
use super::{Failure, OpenFigure, progress, say, sweep, text_for_picture};
use crate::camera::ImageSize;
use crate::cli::args::figure::size;
use crate::cli::args::words::written;
use crate::picture::{Animation, FilmFormat, PictureFile};
use crate::progress::at_once;
use crate::sanitize;
use crate::views::View;
use camera_lab_words::{Lang, command_line as texts, messages, pictures};

/// The size of each picture if none is given.
const SIZE: ImageSize = ImageSize { width: 480, height: 360 };

pub(super) fn run(args: &AnimateArgs, lang: Lang) -> Result<(), Failure> {
    let name = sanitize::path(&args.output);
    let format = FilmFormat::of(&args.output).ok_or_else(|| Failure::BadInput(texts::animation_ending(lang, &name)))?;
    let size = size(args.size.as_deref(), lang)?.unwrap_or(SIZE);
    if args.to.is_some() || !args.family.vary.is_empty() {
        return sweep::run(args, format, size, lang);
    }
    let seconds = args.seconds(lang)?;
    let subject = OpenFigure::open(&args.figure, &args.common, Some(size), lang)?;
    let film = Animation { request: subject.request(View::Canonical, false), decomposition: args.steps };
    if film.steps() == 0 {
        let name = messages::opened(lang, &args.figure);
        return Err(Failure::BadInput(format!("{name}: {}", texts::no_steps(lang, film.decomposition))));
    }
    let text = text_for_picture(&args.figure, &subject.opened, &args.common, &args.output, lang);
    let written = written(args.common.lang);
    let told = pictures::told_of(written, &subject.opened.figure, &film.stills(), text).for_file(&args.output);
    let made = progress::watched(lang, |progress| at_once(film.file(format, seconds, &told, progress)));
    let PictureFile { bytes, beside, over_budget, .. } =
        made.map_err(|error| no_picture(lang, &name, error, subject.pixels()))?;
    if let Some(over_budget) = over_budget {
        say(&format!("{name}: {}", messages::over_budget(lang, &over_budget)));
    }
    save(&args.output, &bytes, beside, lang)
}
