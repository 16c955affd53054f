//! The commands of menus and keyboard: [`MENUS`] has a row for each.

mod keys_page;
mod table;

use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};
pub use keys_page::{keys_pdf, keys_text};
pub use table::MENUS;
pub(super) use table::show_lessons;

use crate::gui::app::state::State;
use crate::gui::kit::Command;
use camera_lab_desk::Model;
use camera_lab_words::window::Texts;

/// A menu: its title, and its commands in groups with lines between them.
#[derive(Debug)]
pub struct Menu {
    /// Its title.
    pub title: fn(&Texts) -> &'static str,
    /// False if its place is elsewhere, at the titles of the pictures.
    pub in_bar: bool,
    groups: &'static [&'static [CommandRow]],
}

impl Menu {
    /// Its commands in groups, without those that a window of this kind lacks.
    pub fn groups(&self, model: &Model) -> impl Iterator<Item = impl Iterator<Item = Command>> {
        let commands = |group: &'static [CommandRow]| group.iter().map(|row| row.command);
        self.groups.iter().map(move |group| commands(group).filter(|command| command.is_there(model)))
    }
}

/// The properties of a command.
#[derive(Clone, Copy, Debug)]
struct CommandRow {
    command: Command,
    shortcut: KeyboardShortcut,
    second_shortcut: Option<KeyboardShortcut>,
    in_browser: InBrowser,
    /// Label and hint.
    words: fn(&Texts) -> (&'static str, &'static str),
    enabled: fn(&State) -> bool,
    /// True if its menu lists it only while it's enabled.
    only_if_enabled: bool,
    /// The reason why it's disabled, if that isn't obvious.
    hint_disabled: Option<fn(&Texts) -> &'static str>,
    on: Option<fn(&State) -> bool>,
    run: fn(&mut State, &Context),
}

/// The part of a command that a page in a browser has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum InBrowser {
    /// The command and its keys.
    All,
    /// Only the command, because users expect its keys to do something else in every browser (a new window or tab, the
    /// address, reloading, zooming, other tabs).
    WithoutKeys,
    /// Nothing, because a page can't reopen files by itself, and the browser closes it.
    Nothing,
}

fn rows() -> impl Iterator<Item = &'static CommandRow> {
    MENUS.iter().flat_map(|menu| menu.groups).flat_map(|group| *group)
}

impl Command {
    /// All commands, in the order of the menus.
    pub fn all() -> impl Iterator<Item = Self> {
        rows().map(|row| row.command)
    }

    #[expect(clippy::expect_used, reason = "a test looks for the row of every command")]
    fn row(self) -> &'static CommandRow {
        rows().find(|row| row.command == self).expect("a row")
    }

    /// The label.
    pub fn label(self, t: &Texts) -> &'static str {
        (self.row().words)(t).0
    }

    /// The hint.
    pub fn hint(self, t: &Texts) -> &'static str {
        (self.row().words)(t).1
    }

    /// The hint while it's disabled: the reason, if that isn't obvious.
    pub fn hint_disabled(self, t: &Texts) -> &'static str {
        self.row().hint_disabled.map_or_else(|| self.hint(t), |hint| hint(t))
    }

    /// The keys that call it.
    pub fn shortcut(self) -> KeyboardShortcut {
        self.row().shortcut
    }

    /// The keys that call it in this window. A page in a browser has to leave some to the browser.
    pub fn keys(self, model: &Model) -> impl Iterator<Item = KeyboardShortcut> + use<> {
        let row = self.row();
        let are_there = !model.in_browser || row.in_browser == InBrowser::All;
        row.all_keys().filter(move |_| are_there)
    }

    /// True for keys that call a command in a page of a browser.
    pub fn any_has_in_browser(key: Key, modifiers: Modifiers) -> bool {
        let mut keys = rows().filter(|row| row.in_browser != InBrowser::WithoutKeys).flat_map(CommandRow::all_keys);
        keys.any(|keys| keys.logical_key == key && modifiers.matches_exact(keys.modifiers))
    }

    /// True if a window of this kind has it.
    pub fn is_there(self, model: &Model) -> bool {
        !(model.in_browser && self.row().in_browser == InBrowser::Nothing)
    }

    /// True if it would have an effect.
    pub fn is_enabled(self, state: &State) -> bool {
        (self.row().enabled)(state)
    }

    /// True if its menu lists it now.
    pub fn is_listed(self, state: &State) -> bool {
        !self.row().only_if_enabled || self.is_enabled(state)
    }

    /// On or off, for a switch.
    pub fn is_on(self, state: &State) -> Option<bool> {
        self.row().on.map(|on| on(state))
    }

    /// Does it.
    pub(in crate::gui) fn run(self, state: &mut State, ctx: &Context) {
        (self.row().run)(state, ctx);
    }

    /// True for an action that a text field does itself while it has the keyboard.
    pub fn is_for_text_too(self) -> bool {
        matches!(self, Self::Undo | Self::Redo)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::gui::kit::keys::{self, WITHOUT_VALUE};
    use crate::views::observer::Viewpoint;
    use crate::views::{Arrangement, View};
    use camera_lab_desk::layout::{ObserverChange, Tab};
    use camera_lab_words::{Lang, window};

    #[test]
    fn every_command_has_one_row() {
        let commands: Vec<Command> = Command::all().collect();
        assert_eq!(commands.iter().collect::<HashSet<_>>().len(), commands.len());
        let mut expected = WITHOUT_VALUE.to_vec();
        expected.extend([Tab::Camera, Tab::Scene, Tab::Drawing].map(Command::Tab));
        expected.extend(View::ALL.map(Command::Show));
        expected.extend(Arrangement::ALL.map(|arrangement| Command::Arrange(Some(arrangement))));
        expected.extend(Viewpoint::ALL.map(|from| Command::Observe(ObserverChange::From(from))));
        expected.extend([Command::Arrange(None), Command::Observe(ObserverChange::Fit)]);
        for command in expected {
            assert!(commands.contains(&command), "{command:?}");
        }
    }

    #[test]
    fn no_two_commands_share_keys() {
        let mut seen = HashSet::new();
        for row in rows() {
            for keys in row.all_keys() {
                assert!(seen.insert((keys.modifiers, keys.logical_key)), "{:?}: {keys:?}", row.command);
            }
        }
    }

    /// The guides give keys behind the name of a command, as in `*Hand out ▸ Copy a link…* (Ctrl+K)`.
    #[test]
    fn keys_in_the_guides_are_those_of_their_commands() {
        let (mut faults, mut compared, ctx) = (Vec::new(), 0, Context::default());
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        for name in ["student", "lecturer", "author", "command-line", "cameras", "numerics"] {
            for lang in [Lang::En, Lang::PtBr] {
                let page = format!("docs/{name}.{}.md", lang.tag());
                let text = std::fs::read_to_string(folder.join(&page)).expect("a guide");
                for (number, line) in text.lines().enumerate() {
                    for (at, _) in line.match_indices("* (") {
                        let command = line[..at].rsplit('*').next().and_then(|path| path.split(" ▸ ").last());
                        let keys = line[at + 3..].split([')', ',']).next().unwrap_or_default();
                        let command = command.and_then(|label| {
                            let is_it = |command: &Command| {
                                command.label(window::texts(lang)).trim_end_matches('…') == label.trim_end_matches('…')
                            };
                            Command::all().find(is_it)
                        });
                        let is_key = keys.starts_with(['C', 'A', 'S', 'F']) && !keys.contains(' ');
                        let Some(command) = command.filter(|_| is_key) else { continue };
                        compared += 1;
                        let own: Vec<String> =
                            command.row().all_keys().map(|own| keys::written(&ctx, &own, lang)).collect();
                        if !own.iter().any(|own| own == keys) {
                            faults.push(format!("{page}:{}: {keys}; {command:?} has {own:?}", number + 1));
                        }
                    }
                }
            }
        }
        assert!(faults.is_empty(), "\n{}", faults.join("\n"));
        assert!(compared > 30, "only {compared} keys were compared");
    }

    #[test]
    fn every_command_has_words_of_its_own_in_both_languages() {
        for t in [Lang::En, Lang::PtBr].map(window::texts) {
            assert!(Command::all().all(|command| !command.label(t).is_empty() && !command.hint(t).is_empty()));
            let labels: HashSet<&str> = Command::all().map(|command| command.label(t)).collect();
            assert_eq!(labels.len(), Command::all().count());
        }
    }
}
