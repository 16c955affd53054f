//! No subcommand: the initial state of the window.

use super::args::WindowArgs;
use super::{Failure, Opening};
use crate::cli::args::words::LangArg;
use crate::figure::Figure;
use crate::scene::Preset;
use camera_lab_files as files;
use camera_lab_words::{Lang, messages};

pub(super) fn opening(args: &WindowArgs, lang: Lang) -> Result<Opening, Failure> {
    let (allow_files, asked_lang) = (args.common.allow_files, args.common.lang.map(LangArg::lang));
    // This thread will be the window's.
    #[cfg(not(target_arch = "wasm32"))]
    files::limit_waiting(files::WINDOW_WAIT);
    if let Some(path) = args.figure.as_ref().filter(|path| args.common.is_plain() && files::stalls(path)) {
        let figure = Figure::of_preset(Preset::default());
        let later = Some(path.clone());
        return Ok(Opening { figure, file: None, allow_files, lang, asked_lang, lesson: None, later });
    }
    if let Some(path) = args.figure.as_ref().filter(|path| files::is_lesson(path)) {
        return super::lesson::opened(path, allow_files, (lang, asked_lang));
    }
    if let Some(path) = &args.figure {
        let (opened, _) = super::open(path, &args.common, lang)?;
        let (figure, file) = opened.at(path);
        return Ok(Opening { figure, file: Some(file), allow_files, lang, asked_lang, lesson: None, later: None });
    }
    let mut figure = Figure::of_preset(Preset::default());
    figure.show = args.common.shown(figure.show, lang)?;
    super::operate(&mut figure, &args.common.operations(lang)?, args.common.convention)
        .map_err(|error| Failure::BadInput(messages::inspect(lang, &error)))?;
    Ok(Opening { figure, file: None, allow_files, lang, asked_lang, lesson: None, later: None })
}
