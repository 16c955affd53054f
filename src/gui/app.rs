//! What happens in a frame, in order.

use eframe::egui::{self, ViewportCommand};

use super::canvas::Canvas;
use super::command::Command;
use super::state::State;
use super::{menu, panels, theme};
use crate::appearance::Theme;
use crate::i18n::Lang;

/// The window's program.
pub struct App {
    /// What the panels and the pictures share.
    pub state: State,
    canvas: Canvas,
}

/// What the presentation enlarges everything by.
const PRESENTATION_ZOOM: f32 = 1.6;

impl App {
    /// Starts from a state, in a window whose fonts and style it sets.
    #[must_use]
    pub fn new(ctx: &egui::Context, state: State) -> Self {
        theme::install_fonts(ctx);
        theme::install_style(ctx);
        let app = Self { state, canvas: Canvas::default() };
        app.apply_settings(ctx);
        app
    }

    /// One frame; `ui` is the whole window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let ctx = ui.ctx().clone();
        if let Some(command) = self.keyboard(&ctx) {
            self.perform(&ctx, command);
        }
        let bar = egui::Panel::top("menu").show(ui, |ui| menu::bar(ui, &self.state)).inner;
        egui::Panel::bottom("status").show(ui, |ui| panels::status::ui(ui, &mut self.state));
        if self.state.settings.parameters_panel {
            egui::Panel::left("parameters")
                .default_size(256.0)
                .size_range(220.0..=420.0)
                .show(ui, |ui| panels::parameters::ui(ui, &mut self.state));
        }
        if self.state.settings.numbers_panel {
            egui::Panel::right("numbers").default_size(300.0).size_range(260.0..=520.0).show(ui, |ui| {
                self.right(ui);
            });
        }
        egui::CentralPanel::no_frame().show(ui, |ui| self.canvas.ui(ui, &mut self.state));
        if let Some(command) = bar {
            self.perform(&ctx, command);
        }
        self.apply_settings(&ctx);
        if ctx.input(|i| !i.pointer.any_down() && i.keys_down.is_empty()) {
            self.state.document.commit();
        }
    }

    /// Operations above, numbers below; the border between them can be dragged.
    fn right(&mut self, ui: &mut egui::Ui) {
        let height = ui.available_height();
        egui::Panel::bottom("values")
            .resizable(true)
            .default_size(height * 0.48)
            .size_range(60.0..=(height - 60.0).max(60.0))
            .frame(egui::Frame::NONE.inner_margin(egui::Margin { top: 4, ..Default::default() }))
            .show(ui, |ui| {
                egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                    panels::probe::ui(ui, &mut self.state);
                    panels::values::ui(ui, &mut self.state);
                });
            });
        egui::CentralPanel::no_frame().show(ui, |ui| {
            egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| panels::operations::ui(ui, &mut self.state));
        });
    }

    /// The command whose keys were pressed.
    fn keyboard(&self, ctx: &egui::Context) -> Option<Command> {
        let typing = ctx.text_edit_focused();
        Command::all().filter(|command| !(typing && command.is_for_text_too()) && command.is_enabled(&self.state)).find(
            |command| {
                [Some(command.shortcut()), command.second_shortcut()]
                    .into_iter()
                    .flatten()
                    .any(|keys| ctx.input_mut(|input| input.consume_shortcut(&keys)))
            },
        )
    }

    /// Does what a menu or the keyboard asks for.
    fn perform(&mut self, ctx: &egui::Context, command: Command) {
        let state = &mut self.state;
        match command {
            Command::New | Command::Open | Command::Save | Command::SaveAs | Command::Export => {}
            Command::Quit => ctx.send_viewport_cmd(ViewportCommand::Close),
            Command::Undo => state.document.undo(),
            Command::Redo => state.document.redo(),
            Command::Reset => state.document.reset(),
            Command::CopyNumbers => ctx.copy_text(panels::values::copy(state)),
            Command::Language => {
                state.settings.lang = match state.settings.lang {
                    Lang::En => Lang::PtBr,
                    Lang::PtBr => Lang::En,
                };
            }
            Command::Theme => {
                state.document.edit(|figure| {
                    figure.style.theme = if figure.style.theme == Theme::Dark { Theme::Light } else { Theme::Dark };
                });
            }
            Command::Presentation => {
                state.settings.presentation = !state.settings.presentation;
                ctx.send_viewport_cmd(ViewportCommand::Fullscreen(state.settings.presentation));
            }
            Command::ZoomIn => state.settings.zoom = (state.settings.zoom + 0.1).min(3.0),
            Command::ZoomOut => state.settings.zoom = (state.settings.zoom - 0.1).max(0.5),
            Command::ZoomReset => state.settings.zoom = 1.0,
            Command::ParametersPanel => state.settings.parameters_panel = !state.settings.parameters_panel,
            Command::NumbersPanel => state.settings.numbers_panel = !state.settings.numbers_panel,
            Command::Show(picture) => state.layout.toggle(picture),
            Command::Look(look) => state.look = Some(look),
            Command::LinkOrbits => state.layout.linked = !state.layout.linked,
        }
    }

    /// Theme and zoom, as the settings say.
    fn apply_settings(&self, ctx: &egui::Context) {
        let theme = match self.state.document.figure().style.theme {
            Theme::Dark => egui::Theme::Dark,
            Theme::Light | Theme::Print => egui::Theme::Light,
        };
        if ctx.theme() != theme {
            ctx.set_theme(theme);
            ctx.request_repaint();
        }
        let presentation = if self.state.settings.presentation { PRESENTATION_ZOOM } else { 1.0 };
        let zoom = self.state.settings.zoom * presentation;
        if ctx.zoom_factor() != zoom {
            ctx.set_zoom_factor(zoom);
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }
}
