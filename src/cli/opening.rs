//! No subcommand: the initial state of the window.

use std::path::PathBuf;

use super::args::WindowArgs;
use super::{Failure, Opening};
use crate::cli::args::words::LangArg;
use crate::figure::Figure;
use crate::scene::Preset;
use crate::scene::import::MESH_ENDINGS;
use camera_lab_files::{self as files, FigureFiles, FileAccess};
use camera_lab_words::Lang;

pub(super) fn opening(args: &WindowArgs, lang: Lang) -> Result<Opening, Failure> {
    let (allow_files, asked_lang) = (args.common.allow_files, args.common.lang.map(LangArg::lang));
    // This thread will be the window's.
    #[cfg(not(target_arch = "wasm32"))]
    files::limit_waiting(files::WINDOW_WAIT);
    let is_later = |path: &&PathBuf| files::has_ending(path, MESH_ENDINGS) || files::stalls(path);
    if let Some(path) = args.figure.as_ref().filter(|path| args.common.is_plain() && is_later(path)) {
        let figure = Figure::of_preset(Preset::default());
        let later = Some(path.clone());
        return Ok(Opening {
            figure,
            file: None,
            allow_files,
            lang,
            asked_lang,
            lesson: None,
            later,
            page_address: None,
        });
    }
    if let Some(path) = args.figure.as_ref().filter(|path| files::is_lesson(path)) {
        return super::lesson::opened(path, allow_files, (lang, asked_lang));
    }
    if let Some(path) = &args.figure {
        let (opened, _) = super::open(path, &args.common, lang)?;
        let (figure, file) = opened.at(path);
        return Ok(Opening {
            figure,
            file: Some(file),
            allow_files,
            lang,
            asked_lang,
            lesson: None,
            later: None,
            page_address: None,
        });
    }
    let mut figure = Figure::of_preset(Preset::default());
    figure.show = args.common.shown(figure.show, lang)?;
    let none = FigureFiles::new(std::path::Path::new(""), FileAccess::of(std::path::Path::new(""), false, allow_files));
    super::operate(&mut figure, &args.common.steps(lang)?, args.common.convention, none, lang)
        .map_err(Failure::BadInput)?;
    Ok(Opening { figure, file: None, allow_files, lang, asked_lang, lesson: None, later: None, page_address: None })
}
