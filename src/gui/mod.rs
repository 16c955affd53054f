//! The window: a thin shell over the library. What it shows, the command line can print.
//!
//! | file | purpose |
//! | --- | --- |
//! | `about` | the dialog About: version, licence, components |
//! | `app` | the sequence of a frame |
//! | `canvas/` | the three pictures in the middle of the window |
//! | `chart_export` | charts of the window as files |
//! | `coach` | the coach: why an image is empty, health of the camera, repairs |
//! | `command` | the commands: label, tooltip and shortcut of each one |
//! | `compare_dialog` | the dialog that compares the figure with itself in another way |
//! | `comparison` | the lines in which two texts differ |
//! | `context_help` | context help: widgets report the note on them, and F1 opens it |
//! | `dialog_buttons` | the buttons below a question |
//! | `dialogs` | the questions in the window |
//! | `document` | the edited figure: the last valid one, the draft, its file, undo and redo |
//! | `elide` | texts longer than their space, shortened between words |
//! | `exercises/` | the exercises in the window: list, statement, answers, verdict, solution |
//! | `explain/` | the explanations: a file for each tab |
//! | `export` | exports, in the same way as `camera-lab render`, byte for byte |
//! | `export_dialog` | the export dialog, with a preview |
//! | `family` | a family in the export dialog |
//! | `family_choice` | the family that is exported: a key or an operation, with its values |
//! | `file_flow` | opening, saving and closing: the questions, their order, the actions |
//! | `file_kind` | the kinds of files: title, endings, proposed name, whether they are written |
//! | `focus` | the keyboard's way through the window: regions, focus ring, scrolling |
//! | `gallery/` | the gallery of figures: built-in, recent, of a folder |
//! | `handle_drag` | dragging C, PF, VUP and the clipping planes in the world |
//! | `highlight` | the selection of the tree, marked in the pictures |
//! | `history` | undo and redo: snapshots of the figure, which share the scenes that have not changed |
//! | `key_repeat` | the held key: all its repeats are one step |
//! | `launch_options` | options of one window, from the command line or the address of a page |
//! | `lesson/` | the lesson that is played: bar, text, task, list of lessons |
//! | `link_dialog` | the dialog of the figure as a link |
//! | `mathematics` | formulas, set as `KaTeX` sets them |
//! | `memo` | values computed once for each thing that they are computed from, at once or beside the window's thread |
//! | `menu` | the bar at the top: menus, the name of the figure, switches |
//! | `motion` | the short animation of an operation |
//! | `native` | file dialogs: those of the system, or of a browser |
//! | `number_field` | a field for one number: drag it, type an expression, or step it |
//! | `number_tables` | the numbers of the figure as tables, for the panel and for copying |
//! | `panels/` | the panels at the sides, and the few shapes that all of them are made of |
//! | `plotting` | common parts of the plots of the window |
//! | `preferences/` | preferences of the window, in a small TOML file in the user's configuration folder |
//! | `presentation` | the presentation: its keys, and the annotations over the pictures |
//! | `preview` | the picture in the export dialog, and the one it copies |
//! | `prose` | text in Markdown, with mathematics between dollar signs |
//! | `qr` | a link as a QR code over the whole window |
//! | `scene_cache` | the scene of the pictures; mesh files are read beside the window's thread |
//! | `search` | one search for everything in the window |
//! | `selection_gizmo` | the effect of the gizmo in the world on the selection |
//! | `sequence` | the previous and the next figure, of a folder or of the built-in ones |
//! | `session/` | the session of a window that did not close |
//! | `state/` | state shared by the panels and the pictures |
//! | `tab_order` | typed text and Tab in one frame, in their order |
//! | `text_field` | the text fields of the window, and their limits |
//! | `theme` | fonts, sizes and colours of the window |
//! | `tooltip` | tooltips: when, where, and with the titles of the notes that they cite |
//! | `watch` | changes of the figure's file by another program |
//! | `web/` | the window as a page of a browser |
//! | `window_size` | the size in which the window opens |
//! | `worker` | work beside the window's thread, or in slices in the frames |

mod about;
pub mod app;
pub mod canvas;
mod chart_export;
mod coach;
pub mod command;
pub mod compare_dialog;
pub mod comparison;
mod context_help;
mod dialog_buttons;
pub mod dialogs;
pub mod document;
mod elide;
mod exercises;
pub mod explain;
pub mod export;
mod export_dialog;
mod family;
pub mod family_choice;
pub mod file_flow;
mod file_kind;
mod focus;
pub mod gallery;
mod handle_drag;
mod highlight;
mod history;
mod key_repeat;
pub mod launch_options;
mod lesson;
mod link_dialog;
mod mathematics;
mod memo;
pub mod menu;
mod motion;
pub mod native;
pub mod number_field;
mod number_tables;
pub mod panels;
mod plotting;
pub mod preferences;
mod presentation;
pub mod preview;
mod prose;
mod qr;
pub mod scene_cache;
mod search;
mod selection_gizmo;
mod sequence;
pub mod session;
pub mod state;
mod tab_order;
mod text_field;
pub mod theme;
mod tooltip;
mod watch;
#[cfg(target_arch = "wasm32")]
pub mod web;
#[cfg(not(target_arch = "wasm32"))]
mod window_size;
mod worker;

use crate::figure::Figure;
use crate::files::SourceFile;
use crate::i18n::Lang;
use crate::lessons::OpenLesson;
use crate::scene::Preset;
pub use app::App;
pub use launch_options::LaunchOptions;
pub use state::State;

/// The initial state of the window.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// The figure; its camera must be possible.
    pub figure: Figure,
    /// Its file; `None`: a new figure.
    pub file: Option<SourceFile>,
    /// The language of the interface.
    pub lang: Lang,
    /// The user lets the figure name any file of this machine.
    pub allow_files: bool,
    /// The lesson that is played; its step has the figure.
    pub lesson: Option<OpenLesson>,
}

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum GuiError {
    /// No display, or no usable OpenGL.
    #[error("{0}")]
    NoWindow(String),
    /// The figure's camera is impossible.
    #[error(transparent)]
    Camera(#[from] crate::camera::CameraError),
}

/// The figure that the window begins with: the default scene, from where it and its view volume are worth seeing.
#[must_use]
pub fn fresh() -> Figure {
    Figure::of_preset(Preset::default())
}

/// The initial size of the window, in points: with title bar and task bar it fits a screen of 1280 × 720, so that
/// messages at its bottom are seen.
pub const DEFAULT_SIZE: [f32; 2] = [1240.0, 640.0];

/// Opens the window and returns when it is closed. Its language is the one in `asked`, else the stored one, else that
/// of `start`.
///
/// # Errors
/// [`GuiError::NoWindow`] where there is no display or no usable OpenGL.
#[cfg(not(target_arch = "wasm32"))]
pub fn run(mut start: Start, asked: Option<Lang>) -> Result<(), GuiError> {
    let restore = start.file.is_none() && start.lesson.is_none() && start.figure == fresh();
    // After the preferences, among which are the panels.
    let lesson = start.lesson.take();
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
                app.state.file_flow.news.tell(session::News::NoHome);
            }
            if let Some(open) = lesson {
                file_flow::begin(&context.egui_ctx, &mut app.state, state::AfterSave::Lesson(open));
            }
            Ok(Box::new(app))
        }),
    )
    .map_err(|error| GuiError::NoWindow(error.to_string()))
}
