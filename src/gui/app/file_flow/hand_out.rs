//! The page for students and the package for a course platform, with the open lesson or figure in them.

use std::path::Path;

use eframe::egui;

use crate::gui::app::file_flow;
use crate::gui::app::file_flow::questions::{HandOut, Purpose};
use crate::gui::app::state::State;
use camera_lab_files::hand_out::{PAGE_NAME, USUAL_PASS, lesson_with_files, of_shipped, package, page_with, read_page};
use camera_lab_files::share::{Held, fragment};
use camera_lab_files::{self as files, FileError, text_with_files};
use camera_lab_words::told;

/// Asks for the file to write. The page in one file lies beside the program, or is where the user found it last.
/// Otherwise asks for it first.
pub(in crate::gui) fn begin(ctx: &egui::Context, state: &mut State, what: HandOut) {
    // A page of a browser doesn't hand itself out, and needs none of this. The file of a lesson gets the typed text. If
    // it can't, a message says why.
    if cfg!(target_arch = "wasm32") || !state.learn.save_text(&mut state.model) {
        return;
    }
    if let Err(error) = opened(state) {
        // Before anything is asked.
        return state.model.say(camera_lab_desk::Message::File(PAGE_NAME.into(), error));
    }
    let beside = std::env::current_exe().ok().map(|program| program.with_file_name(PAGE_NAME));
    let known = beside.into_iter().chain([state.sharing.page_file.clone()]).find(|page| read_page(page).is_ok());
    file_flow::ask(ctx, state, known.map_or(Purpose::Page(what), |page| Purpose::HandOut(what, page)));
}

/// Goes on with the page that the user has chosen.
pub(super) fn take_page(ctx: &egui::Context, state: &mut State, what: HandOut, page: &Path) {
    match read_page(page) {
        Ok(_) => {
            page.clone_into(&mut state.sharing.page_file);
            file_flow::ask(ctx, state, Purpose::HandOut(what, page.to_owned()));
        }
        Err(error) => state.model.say(camera_lab_desk::Message::File(page.to_owned(), error)),
    }
}

/// The bytes of the file.
pub(super) fn bytes(state: &State, what: HandOut, page: &Path) -> Result<Vec<u8>, FileError> {
    if cfg!(target_arch = "wasm32") {
        return Err(FileError::OtherPage);
    }
    let (page, opened) = (read_page(page)?, opened(state)?);
    let lang = state.model.settings.lang;
    let playing = state.learn.lesson.as_ref();
    if let Some(lesson) = playing.map(|playing| &playing.lesson).filter(|_| what == HandOut::Course) {
        let course = (told(lang, &lesson.title), lang.tag(), USUAL_PASS);
        return package(page, lesson, &opened, course);
    }
    let end = match playing {
        None => fragment(Held::Figure, &opened),
        Some(playing) if playing.path.is_none() => of_shipped(&opened),
        Some(_) => fragment(Held::Lesson, &opened),
    };
    Ok(page_with(&page, &end).into_bytes())
}

/// The text that the file opens, with the files that it names: that of the figure or of the user's own lesson. The
/// identifier of a built-in lesson.
fn opened(state: &State) -> Result<String, FileError> {
    let Some(playing) = &state.learn.lesson else {
        let shown = &state.model.desk.shown;
        return text_with_files(&file_flow::text_as_shown(&state.model), [shown.figure()], &shown.files());
    };
    match playing.path.as_deref() {
        Some(path) => lesson_with_files(&files::read_lesson(path)?.1, &playing.lesson, Some(path)),
        None => Ok(playing.lesson.id.clone()),
    }
}
