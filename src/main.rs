//! Hands the arguments to the command line, and opens the window if there is no subcommand. In a browser there is only
//! the window.

// A double click opens no console, so printed text goes through `camera-lab.com` (dist/windows/console).
#![cfg_attr(all(windows, feature = "gui"), windows_subsystem = "windows")]

#[cfg(target_arch = "wasm32")]
fn main() {
    #[cfg(feature = "gui")]
    camera_lab::gui::app::web::run();
}

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    system::main()
}

#[cfg(not(target_arch = "wasm32"))]
mod system {
    use std::process::ExitCode;

    use camera_lab::cli::{self, Asked};

    pub(super) fn main() -> ExitCode {
        match cli::run(std::env::args_os()) {
            Asked::Done(code) => code,
            Asked::Window(opening) => open(*opening),
            Asked::Keys { lang, output } => keys(lang, output.as_deref()),
            Asked::NoWindow { status, message } => no_window(status, &message),
        }
    }

    #[cfg(feature = "gui")]
    fn open(opening: cli::Opening) -> ExitCode {
        use camera_lab::gui::{self, GuiError, Start};
        use camera_lab_words::{command_line as texts, messages};

        let cli::Opening { figure, file, allow_files, lang, asked_lang, lesson, later, page_address } = opening;
        match gui::run(Start { figure, file, lang, allow_files, lesson, later }, asked_lang, page_address) {
            Ok(()) => ExitCode::SUCCESS,
            Err(GuiError::NoWindow(why)) => no_window(1, &texts::no_window(lang, &why)),
            Err(GuiError::Camera(error)) => no_window(2, &messages::camera(lang, &error)),
        }
    }

    #[cfg(feature = "gui")]
    fn keys(lang: camera_lab_words::Lang, output: Option<&std::path::Path>) -> ExitCode {
        use camera_lab::gui::app::command::{keys_pdf, keys_text};

        let model = match camera_lab::gui::State::new(camera_lab::gui::Start::default()) {
            Ok(state) => state.model,
            Err(error) => return cli::fail(1, &camera_lab_words::messages::camera(lang, &error)),
        };
        let page = output.and_then(|_| keys_pdf(&model, lang));
        cli::deliver(&page.unwrap_or_else(|| keys_text(&model, lang).into_bytes()), output, lang)
    }

    #[cfg(not(feature = "gui"))]
    fn keys(lang: camera_lab_words::Lang, _: Option<&std::path::Path>) -> ExitCode {
        cli::fail(1, &camera_lab_words::command_line::not_built_in(lang))
    }

    #[cfg(not(feature = "gui"))]
    fn open(opening: cli::Opening) -> ExitCode {
        cli::fail(1, &camera_lab_words::command_line::not_built_in(opening.lang))
    }

    /// Reports why there is no window. Windows has no console for a program opened by a double click, so it shows a box
    /// there.
    fn no_window(status: u8, message: &str) -> ExitCode {
        #[cfg(all(windows, feature = "gui"))]
        if std::env::var_os("CAMERA_LAB_CONSOLE").is_none() {
            camera_lab::gui::platform::native::message_box(message);
        }
        cli::fail(status, message)
    }
}
