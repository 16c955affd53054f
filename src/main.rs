//! Hands the arguments to the command line, and opens the window when there is no subcommand.

use std::process::ExitCode;

use camera_lab::cli::{self, Asked};

fn main() -> ExitCode {
    match cli::run(std::env::args_os()) {
        Asked::Done(code) => code,
        Asked::Window(opening) => open(*opening),
    }
}

#[cfg(feature = "gui")]
fn open(opening: cli::Opening) -> ExitCode {
    use camera_lab::gui::{self, GuiError, Start};
    use camera_lab::i18n::{command_line as texts, messages};

    let cli::Opening { figure, file, allow_files, lang, asked_lang } = opening;
    match gui::run(Start { figure, file, lang, allow_files }, asked_lang) {
        Ok(()) => ExitCode::SUCCESS,
        Err(GuiError::NoWindow(why)) => cli::fail(1, &texts::no_window(lang, &why)),
        Err(GuiError::Camera(error)) => cli::fail(2, &messages::camera(lang, &error)),
    }
}

#[cfg(not(feature = "gui"))]
fn open(opening: cli::Opening) -> ExitCode {
    cli::fail(1, &camera_lab::i18n::command_line::not_built_in(opening.lang))
}
