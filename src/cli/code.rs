//! `camera-lab code`: the camera as code for a library.

use super::args::CodeArgs;
use super::{Failure, open, print, say};
use crate::cli::args::words::written;
use crate::explain::Setting;
use crate::explain::code::CodeConvention;
use camera_lab_words::Lang;
use camera_lab_words::why::{code as texts, dialects};

pub(super) fn run(args: &CodeArgs, lang: Lang) -> Result<(), Failure> {
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let setting = Setting::new(camera.notes_clip_space(), opened.figure.image, opened.figure.viewport);
    if let Some(limitation) = args.target.limitation(&camera, opened.figure.image) {
        let why = dialects::limitation(lang, limitation);
        return Err(Failure::BadInput(format!("--for {}: {why}", args.target.word())));
    }
    let written = written(args.common.lang);
    let conventions = args.target.conventions(&camera);
    // JSON has no place for it.
    for moved in conventions.iter().filter(|said| matches!(said, CodeConvention::MovedBack(_))) {
        if args.target.comment().is_none() {
            say(&texts::convention(lang, args.target, *moved));
        }
    }
    let comments = texts::comments(written, args.target, &conventions);
    print(args.target.code(&setting, &comments).as_bytes(), lang)
}
