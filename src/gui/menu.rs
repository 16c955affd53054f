//! The bar at the top: menus, the name of the figure, and the switches that a lecture needs at once.

use eframe::egui::{self, Button, RichText};

use super::command::{Command, MENUS};
use super::focus::with_room_before;
use super::panels;
use super::state::State;
use crate::gui::tooltip::Explained;
use crate::i18n::window::{self, Texts};
use crate::sanitize::escaped;

/// Below this width, in points, the menus have no room beside the switches: a telephone held upright.
pub(super) const PHONE: f32 = 600.0;

/// Shows the bar; the chosen command, if any.
pub fn bar(ui: &mut egui::Ui, state: &State) -> Option<Command> {
    let t = window::texts(state.settings.lang);
    let mut chosen = None;
    egui::MenuBar::new().ui(ui, |ui| {
        let is_phone = ui.available_width() < PHONE;
        if is_phone {
            // One button, so that the switches have room.
            ui.menu_button("☰", |ui| chosen = menus(ui, t, state)).response.accessible_name(t.menus);
        } else {
            chosen = menus(ui, t, state);
        }
        ui.separator();
        for command in [Command::Undo, Command::Redo] {
            let sign = if command == Command::Undo { "↶" } else { "↷" };
            if switch(ui, t, state, command, sign) {
                chosen = Some(command);
            }
        }
        let mut of_title = None;
        let middle = |ui: &mut egui::Ui| {
            // News get the little space that there is on a telephone.
            if !is_phone {
                title(ui, t, state, &mut of_title);
            }
            panels::status::news(ui, state);
        };
        let switched = with_room_before(ui, middle, |ui| {
            let mut switched = None;
            for (command, sign) in [
                (Command::Language, t.language),
                (Command::Theme, "◐"),
                (Command::Presentation, "▶"),
                (Command::ParametersPanel, "◧"),
                (Command::Pipeline, "⬓"),
                (Command::NumbersPanel, "◨"),
                (Command::Explain, "?"),
                (Command::Exercises, "✎"),
            ] {
                if switch(ui, t, state, command, sign) {
                    switched = Some(command);
                }
            }
            switched
        });
        chosen = switched.or(of_title).or(chosen);
    });
    chosen
}

/// The menus, one beside or below the other; the chosen command, if any.
fn menus(ui: &mut egui::Ui, t: &Texts, state: &State) -> Option<Command> {
    let mut chosen = None;
    for menu in MENUS {
        ui.menu_button((menu.title)(t), |ui| {
            ui.set_min_width(220.0);
            let mut is_first = true;
            for group in menu.groups(state) {
                for (place, command) in group.enumerate() {
                    if place == 0 && !std::mem::take(&mut is_first) {
                        ui.separator();
                    }
                    if item(ui, t, state, command) {
                        chosen = Some(command);
                        ui.close();
                    }
                }
            }
        });
    }
    chosen
}

fn item(ui: &mut egui::Ui, t: &Texts, state: &State, command: Command) -> bool {
    let keys = keys(ui, state, command);
    let mark = match command.is_on(state) {
        Some(true) => "✔ ",
        Some(false) => "    ",
        None => "",
    };
    let button = Button::new(format!("{mark}{}", command.label(t))).shortcut_text(keys.unwrap_or_default());
    ui.add_enabled(command.is_enabled(state), button)
        .explained(command.hint(t))
        .explained_disabled(command.hint_disabled(t))
        .clicked()
}

/// The keys of a command as they are written, if it has any here.
fn keys(ui: &egui::Ui, state: &State, command: Command) -> Option<String> {
    command.keys(state).next().map(|keys| ui.ctx().format_shortcut(&keys))
}

fn switch(ui: &mut egui::Ui, t: &Texts, state: &State, command: Command, sign: &str) -> bool {
    let keys = keys(ui, state, command).map(|keys| format!(" ({keys})"));
    let hint = format!("{}{}\n{}", command.label(t), keys.unwrap_or_default(), command.hint(t));
    let button = Button::selectable(command.is_on(state).unwrap_or(false), sign);
    ui.add_enabled(command.is_enabled(state), button)
        .explained(&hint)
        .explained_disabled(&hint)
        .accessible_name(command.label(t))
        .clicked()
}

fn title(ui: &mut egui::Ui, t: &Texts, state: &State, chosen: &mut Option<Command>) {
    let name = state.document.name().map_or_else(|| t.untitled.to_owned(), |name| escaped(&name));
    let text = if state.document.is_changed() { format!("{name} •") } else { name };
    if state.document.name().is_none() && !state.document.is_changed() {
        // Whoever has just come in sees where there is more to see.
        let keys = ui.ctx().format_shortcut(&Command::Gallery.shortcut());
        let link = ui.link(format!("{} ({keys})", t.gallery.trim_end_matches('…')));
        if link.explained(t.gallery_hint).clicked() {
            *chosen = Some(Command::Gallery);
        }
    }
    let label = egui::Label::new(RichText::new(text).weak()).truncate();
    let hint = if state.document.is_changed() { t.changed_hint } else { t.unchanged_hint };
    ui.add(label).explained(hint);
}
