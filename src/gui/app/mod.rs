//! The program of the window: its frames, commands, menus, search, questions about files, and preferences.
//!
//! Only this module uses features, in order, and only its functions take the whole state of the window.

pub mod command;
pub mod dialogs;
pub mod file_flow;
pub mod frame;
pub(super) mod key_repeat;
pub mod launch_options;
pub mod menu;
pub mod preferences;
pub(super) mod presentation;
pub mod search;
pub mod state;
pub mod status;
pub(super) mod tab_order;
#[cfg(target_arch = "wasm32")]
pub mod web;

use std::path::Path;

use eframe::egui::os::OperatingSystem;
use eframe::egui::{self, KeyboardShortcut, Vec2, ViewportCommand};

use crate::appearance::Theme;
use crate::gui::app::key_repeat::HeldKey;
use crate::gui::app::launch_options::LaunchOptions;
use crate::gui::app::preferences::Preferences;
use crate::gui::app::presentation::RestingPointer;
use crate::gui::app::state::State;
use crate::gui::app::tab_order::KeyOrder;
use crate::gui::kit::{Command, Focus, text_field, theme};
#[cfg(not(target_arch = "wasm32"))]
use crate::gui::platform::window_size::{Opening, Whereabouts};
use crate::gui::views::Canvas;
use camera_lab_desk::{Keeping, Message, Restored, Sessions};

/// The window's program.
pub struct App {
    /// State shared by the panels and the pictures.
    pub state: State,
    /// The pictures.
    pub canvas: Canvas,
    sessions: Option<Sessions>,
    preferences: Option<Preferences>,
    held_key: HeldKey,
    caret: text_field::CaretRest,
    focus: Focus,
    key_order: KeyOrder,
    title: String,
    resting: RestingPointer,
    #[cfg(not(target_arch = "wasm32"))]
    opening: Opening,
    #[cfg(not(target_arch = "wasm32"))]
    whereabouts: Whereabouts,
}

impl App {
    /// Starts from a state, in a window whose fonts and style it sets.
    pub fn new(ctx: &egui::Context, state: State) -> Self {
        theme::install_fonts(ctx);
        theme::install_style(ctx);
        let app = Self {
            state,
            canvas: Canvas::default(),
            sessions: None,
            preferences: None,
            held_key: HeldKey::default(),
            caret: text_field::CaretRest::default(),
            focus: Focus::default(),
            key_order: KeyOrder::default(),
            title: String::new(),
            resting: RestingPointer::default(),
            #[cfg(not(target_arch = "wasm32"))]
            opening: Opening::default(),
            #[cfg(not(target_arch = "wasm32"))]
            whereabouts: Whereabouts::default(),
        };
        app.apply_first_settings(ctx);
        app
    }

    /// Stores preferences in `folder` from now on, and sets the window up from them and from the options in `asked`.
    pub fn keep_preferences(&mut self, ctx: &egui::Context, folder: &Path, asked: LaunchOptions) {
        self.preferences = Some(Preferences::begin(folder, &mut self.state, asked));
        self.apply_first_settings(ctx);
    }

    /// Follows the system's setting if the user hasn't chosen one.
    #[cfg(target_arch = "wasm32")]
    pub(in crate::gui) fn follow_system(&mut self, theme: Theme, reduce_motion: bool) {
        if let Some(preferences) = &mut self.preferences {
            preferences.follow(&mut self.state, "theme", |state| state.model.settings.theme = theme);
            let reduce = |state: &mut State| state.model.settings.reduce_motion = reduce_motion;
            preferences.follow(&mut self.state, "reduce_motion", reduce);
        }
    }

    /// The title of the window.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Stores the session in `folder` from now on. With `restore`, restores that of a window that didn't close.
    pub fn keep_session(&mut self, folder: &Path, restore: bool) {
        let (sessions, left) = Sessions::begin(folder, restore);
        self.sessions = Some(sessions);
        self.go_on_with(left);
        self.show_notices();
    }

    /// Continues with a restored document.
    fn go_on_with(&mut self, left: Option<Restored>) {
        if let Some(Restored { document, text, .. }) = left {
            let figure = document.figure().clone();
            self.state.learn.take_over(&mut self.state.model, document);
            if let Some(text) = text {
                self.state.learn.resume_text(&mut self.state.model, text, figure);
            }
            // Another program may have changed the file since.
            self.state.file_flow.look = true;
        }
    }

    /// Collects notices about sessions and preferences. Each stays until dismissed. Write failures stay as long as they
    /// last.
    fn show_notices(&mut self) {
        let said = &mut self.state.file_flow.news;
        if let Some(preferences) = &mut self.preferences {
            preferences.news().into_iter().for_each(|news| said.tell(news));
            preferences.kept().for_each(|what| said.is_kept(what));
        }
        if let Some(sessions) = &mut self.sessions {
            sessions.news().into_iter().for_each(|news| said.tell(news));
            if !sessions.is_failing() {
                said.is_kept(Keeping::Session);
            }
        }
    }

    /// Removes from the input the first key press that calls a command, and returns the command.
    fn keyboard(&self, ctx: &egui::Context) -> Option<Command> {
        let is_press = |event: &egui::Event| matches!(event, egui::Event::Key { pressed: true, .. });
        if !ctx.input(|input| input.events.iter().any(is_press)) {
            return None;
        }
        let typing = ctx.text_edit_focused();
        // On a Mac, Option writes accents and signs.
        let writes = |keys: &KeyboardShortcut| {
            typing && ctx.os() == OperatingSystem::Mac && keys.modifiers.alt && !keys.modifiers.command
        };
        let mut shortcuts: Vec<_> = Command::all()
            .filter(|command| !(typing && command.is_for_text_too()))
            .flat_map(|command| command.keys(&self.state.model).map(move |keys| (keys, command)))
            .collect();
        if self.state.model.settings.presentation && !typing && !ctx.any_popup_open() {
            shortcuts.extend(presentation::KEYS);
            if ctx.memory(|memory| memory.focused().is_none()) {
                shortcuts.extend(presentation::ARROWS);
            }
        }
        if self.state.learn.lesson.is_some() && !typing && !ctx.any_popup_open() {
            shortcuts.extend(presentation::PAGES);
        }
        shortcuts.retain(|(keys, _)| !writes(keys));
        // Ctrl+Shift+S is Ctrl+S as well, so shortcuts with more keys are tested first, also if their command can do
        // nothing. For example, Ctrl+Shift+Z must not undo if there is nothing to redo.
        shortcuts.sort_by_key(|(keys, _)| !keys.modifiers.shift);
        let called_by = |event: &egui::Event| match event {
            egui::Event::Key { key, modifiers, pressed: true, .. } => shortcuts
                .iter()
                .find(|(keys, _)| keys.logical_key == *key && modifiers.matches_logically(keys.modifiers))
                .map(|(_, command)| *command)
                .filter(|command| command.is_enabled(&self.state)),
            _ => None,
        };
        ctx.input_mut(|input| {
            let (place, command) = input.events.iter().enumerate().find_map(|(i, e)| Some((i, called_by(e)?)))?;
            input.events.remove(place);
            Some(command)
        })
    }

    /// Performs a command of a menu or the keyboard.
    fn perform(&mut self, ctx: &egui::Context, command: Command) {
        command.run(&mut self.state, ctx);
    }

    /// Lets links in texts, which may have another author, open only pages and mail, but no files or programs of this
    /// machine.
    fn refuse_links(&mut self, ctx: &egui::Context) {
        let mut refused = None;
        ctx.output_mut(|output| {
            output.commands.retain(|command| match command {
                egui::OutputCommand::OpenUrl(link) if !opens(&link.url) => {
                    refused = Some(link.url.clone());
                    false
                }
                _ => true,
            });
        });
        if let Some(link) = refused {
            self.state.model.say(Message::LinkRefused(link));
            ctx.request_repaint();
        }
    }

    /// The name of the figure in the title of the window.
    fn update_title(&mut self, ctx: &egui::Context) {
        let name = self.state.model.figure_name();
        let mark = if self.state.learn.is_marked(&self.state.model) { " •" } else { "" };
        let title = format!("{}{mark} – Camera Lab", crate::sanitize::escaped(&name));
        if title != self.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }

    /// Theme and zoom before the first frame. [`egui::Context::set_zoom_factor`] would scale the size of the window in
    /// the frame before. Before the first one that's 10,000 points, and the program would draw pictures as large.
    fn apply_first_settings(&self, ctx: &egui::Context) {
        ctx.options_mut(|options| options.zoom_factor = self.zoom(Vec2::ZERO));
        self.apply_theme(ctx);
    }

    /// The zoom of the interface, with that of a presentation in a window of this size without any zoom.
    fn zoom(&self, window: Vec2) -> f32 {
        let zoom = self.state.model.settings.zoom;
        // If everything is large already, a presentation needs nothing larger.
        if self.state.model.settings.presentation { presentation::zoom(window).max(zoom) } else { zoom }
    }

    /// Theme and zoom, as the settings say.
    fn apply_settings(&self, ctx: &egui::Context) {
        self.apply_theme(ctx);
        let zoom = self.zoom(ctx.content_rect().size() * ctx.zoom_factor());
        // The size of the window is rounded.
        if (ctx.zoom_factor() - zoom).abs() > 1e-3 * zoom {
            ctx.set_zoom_factor(zoom);
        }
    }

    fn apply_theme(&self, ctx: &egui::Context) {
        let theme = match self.state.model.settings.theme {
            Theme::Dark => egui::Theme::Dark,
            Theme::Light | Theme::Print => egui::Theme::Light,
        };
        let visuals = theme::visuals(self.state.model.settings.theme);
        if ctx.theme() != theme || ctx.style_of(theme).visuals.panel_fill != visuals.panel_fill {
            // The caret has its own settings.
            ctx.style_mut_of(theme, |style| {
                let text_cursor = style.visuals.text_cursor.clone();
                style.visuals = egui::Visuals { text_cursor, ..visuals };
            });
            ctx.set_theme(theme);
            ctx.request_repaint();
        }
    }
}

/// True if a link may be opened outside the window.
fn opens(link: &str) -> bool {
    let scheme = link.split_once(':').map(|(scheme, _)| scheme.to_ascii_lowercase());
    scheme.is_some_and(|scheme| ["http", "https", "mailto"].contains(&scheme.as_str()))
}

/// The corner of a screen other than the window's, in points of the window's. `None` if there is no other.
#[cfg(not(target_arch = "wasm32"))]
fn other_screen(frame: &eframe::Frame) -> Option<egui::Pos2> {
    let window = frame.winit_window()?;
    let here = window.current_monitor()?;
    let other = window.available_monitors().find(|screen| *screen != here)?;
    let corner = other.position().to_logical::<f32>(window.scale_factor());
    Some(egui::pos2(corner.x, corner.y))
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        #[cfg(not(target_arch = "wasm32"))]
        {
            let window = &mut self.state.model.settings.window;
            self.opening.go_on(ui.ctx(), *window);
            *window = self.whereabouts.settled(ui.ctx(), *window).or(*window);
            let wants_notes = self.state.learn.lesson.as_ref().is_some_and(|playing| playing.shows_notes);
            if !wants_notes {
                self.state.learn.other_screen = None;
            } else if self.state.learn.other_screen.is_none() {
                self.state.learn.other_screen = Some(other_screen(frame));
            }
        }
        self.show(ui);
        file_flow::open_dialog(ui.ctx(), &mut self.state.file_flow, frame);
    }

    /// The ground of the window. Clearing it costs little, but painting it once more, in software, takes milliseconds.
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.panel_fill.to_normalized_gamma_f32()
    }

    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        if self.key_order.hold(&mut input.events) {
            ctx.request_repaint();
        }
        let held = ctx.input(|input| input.pointer.any_down());
        let asks = self.state.file_flow.is_asking() || ctx.any_popup_open();
        let is_free = self.state.model.settings.presentation && !held && !asks;
        let now = input.time.unwrap_or_else(|| ctx.input(|input| input.time));
        self.resting.follow(input, now, is_free);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.state.learn.save_text(&mut self.state.model);
        // Only once, whatever the outcome.
        self.state.model.settings.welcomed = true;
        if let Some(preferences) = &mut self.preferences {
            preferences.finish(&mut self.state);
        }
        // The program has asked the user about unsaved changes, but not if the system ended it.
        if let Some(sessions) = self.sessions.as_mut().filter(|_| self.state.file_flow.may_close) {
            sessions.forget();
        }
    }
}
