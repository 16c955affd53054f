//! The window: a thin shell over the library. The command line can print everything it shows.

pub mod app;
pub mod export;
pub mod gallery;
/// The panels at the sides.
pub mod inspector {
    pub(super) mod coach;
    pub mod compare_dialog;
    pub(super) mod number_tables;
    pub mod numerics;
    pub mod operations;
    pub mod parameters;
    mod predict;
    pub mod scene;
    /// The state of the panels between frames.
    pub(super) mod state {
        pub(in crate::gui) mod compare;
    }
    pub mod values;

    use crate::gui::kit::{
        TEXT_LINE, VectorField, choice_row, complain, complaint, erratum, kept_section, more, row, section, toggle,
    };
}
pub mod kit;
pub mod learn;
pub mod views;
/// The system under the window: its file dialogs, and the possible sizes of a window.
pub mod platform {
    pub mod native;
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) mod window_size;
}
/// The lines about what outlives a window.
pub mod storage {
    pub mod recovery;
    pub mod session_news;
}
pub mod why;

pub use app::App;
pub use app::launch_options::LaunchOptions;
pub use app::state::State;

use camera_lab_words::Lang;

/// The initial state of the window.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// The figure. Its camera must be possible.
    pub figure: crate::figure::Figure,
    /// Its file. `None` for a new figure.
    pub file: Option<camera_lab_files::SourceFile>,
    /// The language of the interface.
    pub lang: Lang,
    /// True if the user lets the figure name any file of this machine.
    pub allow_files: bool,
    /// The lesson being played. Its step has the figure.
    pub lesson: Option<crate::lessons::OpenLesson>,
    /// A file to open once the window is there.
    pub later: Option<std::path::PathBuf>,
}

/// The reason why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum GuiError {
    /// No display, or no usable OpenGL.
    #[error("{0}")]
    NoWindow(String),
    /// The figure's camera is impossible.
    #[error(transparent)]
    Camera(#[from] crate::camera::CameraError),
}

/// The initial size of the window, in points. With title bar and task bar it fits a screen of 1280 × 720, so that
/// messages at its bottom are visible.
pub const DEFAULT_SIZE: [f32; 2] = [1240.0, 640.0];

/// Opens the window and returns when it's closed. Its language is the one in `asked`, else the stored one, else that of
/// `start`. It remembers the address of a course's page.
///
/// # Errors
/// [`GuiError::NoWindow`] if there is no display or no usable OpenGL.
#[cfg(not(target_arch = "wasm32"))]
pub fn run(mut start: Start, asked: Option<Lang>, page_address: Option<String>) -> Result<(), GuiError> {
    let restore = start.file.is_none()
        && start.lesson.is_none()
        && start.later.is_none()
        && start.figure == camera_lab_desk::document::fresh();
    // After the preferences, among which are the panels.
    let (lesson, later) = (start.lesson.take(), start.later.take());
    let state = State::new(start)?;
    let mut viewport = eframe::egui::ViewportBuilder::default()
        .with_title("Camera Lab")
        .with_app_id("camera-lab")
        .with_inner_size(DEFAULT_SIZE)
        .with_min_inner_size([640.0, 400.0]);
    if let Ok(icon) = eframe::icon_data::from_png_bytes(include_bytes!("../../dist/icon.png")) {
        viewport = viewport.with_icon(icon);
    }
    // No gradient of the window is long enough to have bands, and OpenGL in software dithers every pixel.
    let options =
        eframe::NativeOptions { viewport, system_font_fallback: false, dithering: false, ..Default::default() };
    eframe::run_native(
        "camera-lab",
        options,
        Box::new(move |context| {
            let mut app = App::new(&context.egui_ctx, state);
            if let Some(folders) = directories::ProjectDirs::from("", "", "camera-lab") {
                let asked = LaunchOptions { lang: asked, ..LaunchOptions::default() };
                app.keep_preferences(&context.egui_ctx, folders.config_dir(), asked);
                app.keep_session(folders.data_dir(), restore);
            } else {
                app.state.file_flow.news.tell(camera_lab_desk::News::NoHome);
            }
            if let Some(address) = page_address {
                app.state.sharing.page_address = address;
            }
            let opened = lesson.map(camera_lab_desk::Intent::Lesson).or(later.map(camera_lab_desk::Intent::OpenPath));
            if let Some(open) = opened {
                app::file_flow::begin(&context.egui_ctx, &mut app.state, open);
            }
            Ok(Box::new(app))
        }),
    )
    .map_err(|error| GuiError::NoWindow(error.to_string()))
}
