//! The bar at the top: menus, the name of the figure, and the switches that a lecture needs at once.

use eframe::egui::containers::menu::MenuButton;
use eframe::egui::{self, Button, RichText, TextStyle};

use super::command::MENUS;
use crate::gui::app::state::State;
use crate::gui::app::status;
use crate::gui::kit::handheld::PHONE;
use crate::gui::kit::{Command, Explained, elide, is_handheld, with_room_before, written};
use crate::gui::learn::Learn;
use camera_lab_desk::Model;
use camera_lab_words::window::{self, Texts};

/// From this width on, in points, the most used switches have their words.
const WORDS: f32 = 1000.0;

/// From this width on, every switch of the bar has its word.
const ALL_WORDS: f32 = 1500.0;

/// The least room for a longer name of a figure, in points.
const LEAST_NAME: f32 = 48.0;

/// A switch at the right end of the bar.
struct Switch {
    command: Command,
    /// The sign that replaces the word if the window is narrower than a width, in points.
    sign: Option<(&'static str, f32)>,
    word: fn(&Texts) -> &'static str,
}

impl Switch {
    /// The others are in the menus alone.
    fn on_phone(&self) -> bool {
        self.sign.is_some() && ![Command::Pipeline, Command::Presentation].contains(&self.command)
    }
}

const SWITCHES: &[Switch] = &[
    Switch { command: Command::Language, sign: None, word: |t| t.lang.next().name() },
    Switch { command: Command::ParametersPanel, sign: Some(("◧", ALL_WORDS)), word: |t| t.parameters_panel },
    Switch { command: Command::Pipeline, sign: Some(("⬓", WORDS)), word: |t| t.stages_word },
    Switch { command: Command::NumbersPanel, sign: Some(("◨", ALL_WORDS)), word: |t| t.operations_word },
    Switch { command: Command::Explain, sign: Some(("?", WORDS)), word: |t| t.explain_word },
    Switch { command: Command::Exercises, sign: Some(("✎", WORDS)), word: |t| t.exercises },
    Switch { command: Command::Presentation, sign: Some(("▶", WORDS)), word: |t| t.menu_present },
];

/// The signs of the bar with their commands, for a legend.
pub(in crate::gui) fn legend() -> impl Iterator<Item = (&'static str, Command)> {
    let switches = SWITCHES.iter().filter_map(|switch| Some((switch.sign?.0, switch.command)));
    HISTORY.into_iter().map(|(command, sign)| (sign, command)).chain(switches)
}

const HISTORY: [(Command, &str); 2] = [(Command::Undo, "↶"), (Command::Redo, "↷")];

/// Shows the bar. Returns the chosen command, if any.
pub fn bar(ui: &mut egui::Ui, state: &State) -> Option<Command> {
    let t = window::texts(state.model.settings.lang);
    let mut chosen = None;
    egui::MenuBar::new().ui(ui, |ui| {
        let is_phone = ui.available_width() < PHONE;
        if is_phone {
            // One button, so that the switches have room.
            let button = Button::new("☰").min_size(ui.spacing().interact_size);
            let (button, _) = MenuButton::from_button(button).ui(ui, |ui| chosen = menus(ui, t, state));
            button.accessible_name(t.menus);
        } else {
            chosen = menus(ui, t, state);
        }
        ui.separator();
        for (command, sign) in HISTORY {
            if switch(ui, t, &state.model, command, sign, (command.is_enabled(state), false)) {
                chosen = Some(command);
            }
        }
        let mut of_title = None;
        let middle = |ui: &mut egui::Ui| {
            // On a telephone, news get the little space there is.
            if !is_phone {
                title(ui, t, &state.model, &state.learn, &mut of_title);
            }
            status::news(ui, &state.model);
        };
        let switched = with_room_before(ui, middle, |ui| {
            let mut switched = None;
            let width = ui.ctx().content_rect().width();
            for Switch { command, sign, word } in SWITCHES.iter().filter(|switch| !is_phone || switch.on_phone()) {
                let text = sign.filter(|(_, least)| width < *least).map_or_else(|| word(t), |(text, _)| text);
                let on = command.is_on(state).unwrap_or(false);
                if switch(ui, t, &state.model, *command, text, (command.is_enabled(state), on)) {
                    switched = Some(*command);
                }
            }
            switched
        });
        chosen = switched.or(of_title).or(chosen);
    });
    chosen
}

/// The menus, one beside or below the other. Returns the chosen command, if any.
fn menus(ui: &mut egui::Ui, t: &Texts, state: &State) -> Option<Command> {
    let mut chosen = None;
    for menu in MENUS.iter().filter(|menu| menu.in_bar) {
        ui.menu_button((menu.title)(t), |ui| {
            ui.set_min_width(220.0);
            let rows = menu.groups(&state.model).flatten().filter(|command| command.is_listed(state)).count();
            let room = ui.ctx().content_rect().bottom() - ui.cursor().top();
            #[expect(clippy::cast_precision_loss, reason = "some twenty")]
            if (rows + 2) as f32 * (ui.spacing().interact_size.y + ui.spacing().item_spacing.y) > room {
                // The large letters of a presentation.
                (ui.spacing_mut().item_spacing.y, ui.spacing_mut().button_padding.y) = (0.0, 0.0);
                ui.spacing_mut().interact_size.y = ui.text_style_height(&TextStyle::Button);
            }
            let mut is_first = true;
            let has_marks = menu.groups(&state.model).flatten().any(|command| command.is_on(state).is_some());
            for group in menu.groups(&state.model) {
                for (place, command) in group.filter(|command| command.is_listed(state)).enumerate() {
                    if place == 0 && !std::mem::take(&mut is_first) {
                        ui.separator();
                    }
                    let is_on = if has_marks { Some(command.is_on(state).unwrap_or(false)) } else { None };
                    if item(ui, t, &state.model, command, (command.is_enabled(state), is_on)) {
                        chosen = Some(command);
                        ui.close();
                    }
                }
            }
        });
    }
    chosen
}

/// An entry of a menu, enabled, and on, off, or `None` if no entry of its menu can be on.
fn item(ui: &mut egui::Ui, t: &Texts, model: &Model, command: Command, (enabled, on): (bool, Option<bool>)) -> bool {
    let keys = keys(ui, model, command);
    let mark = match on {
        Some(true) => "✔ ",
        Some(false) => "    ",
        None => "",
    };
    let button = Button::new(format!("{mark}{}", command.label(t))).shortcut_text(keys.unwrap_or_default());
    ui.add_enabled(enabled, button).explained(command.hint(t)).explained_disabled(command.hint_disabled(t)).clicked()
}

/// The written keys of a command, if it has any here.
fn keys(ui: &egui::Ui, model: &Model, command: Command) -> Option<String> {
    command.keys(model).next().map(|keys| written(ui.ctx(), &keys, model.settings.lang))
}

/// A button of the bar, enabled, and on.
fn switch(
    ui: &mut egui::Ui,
    t: &Texts,
    model: &Model,
    command: Command,
    sign: &str,
    (enabled, on): (bool, bool),
) -> bool {
    let keys = keys(ui, model, command).map(|keys| format!(" ({keys})"));
    let hint = format!("{}{}\n{}", command.label(t), keys.unwrap_or_default(), command.hint(t));
    let button = Button::selectable(on, sign);
    let button = if is_handheld(ui.ctx()) { button.min_size(ui.spacing().interact_size) } else { button };
    ui.add_enabled(enabled, button)
        .explained(&hint)
        .explained_disabled(&hint)
        .accessible_name(command.label(t))
        .clicked()
}

fn title(ui: &mut egui::Ui, t: &Texts, model: &Model, learn: &Learn, chosen: &mut Option<Command>) {
    let name = crate::sanitize::escaped(&model.figure_name());
    let is_marked = learn.is_marked(model);
    let text = if is_marked { format!("{name} •") } else { name };
    for command in [Command::Gallery, Command::Search] {
        let keys = keys(ui, model, command).map(|keys| format!(" ({keys})")).unwrap_or_default();
        let name = command.label(t).trim_end_matches('…');
        let font = TextStyle::Body.resolve(ui.style());
        if elide::width(ui, &font, name) > ui.available_width() {
            // A small window has them only in its menus.
            continue;
        }
        let link = ui.link(name);
        if link.explained(format!("{}{keys}", command.hint(t))).clicked() {
            *chosen = Some(command);
        }
    }
    // A letter or two of a name are no help.
    let font = TextStyle::Body.resolve(ui.style());
    if ui.available_width() < elide::width(ui, &font, &text).min(LEAST_NAME) {
        return;
    }
    let label = egui::Label::new(RichText::new(text).weak()).truncate();
    let hint = if is_marked { t.changed_hint } else { t.unchanged_hint };
    ui.add(label).explained(hint);
}
