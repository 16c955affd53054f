//! What can be done from the menus and the keyboard: label, tooltip and shortcut of each command in one place.

use eframe::egui::{Key, KeyboardShortcut, Modifiers};

use super::state::{ObserverChange, Side, State, Tab};
use crate::appearance::Theme;
use crate::i18n::window::Texts;
use crate::i18n::{canvas, sharing};
use crate::views::observer::Viewpoint;
use crate::views::{Arrangement, View};

/// Something that can be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// The default figure.
    New,
    /// Asks for a file and opens it.
    Open,
    /// Asks which figure to begin with.
    Gallery,
    /// Asks which of the files that were used last to open.
    Recent,
    /// Writes the file.
    Save,
    /// Asks for a file and writes it.
    SaveAs,
    /// Asks for a picture file and writes it.
    Export,
    /// The figure as a link to the clipboard.
    CopyLink,
    /// Closes the window.
    Quit,
    /// One step back.
    Undo,
    /// One step forward.
    Redo,
    /// The camera as it was when the figure was opened.
    Reset,
    /// The numbers as text to the clipboard.
    CopyNumbers,
    /// The other language.
    Language,
    /// Light or dark.
    Theme,
    /// What would move is at its end at once.
    ReduceMotion,
    /// Saving keeps what the pictures explain.
    SaveExplained,
    /// Large type and thick strokes.
    Presentation,
    /// The next figure of the folder, or of the program.
    NextFigure,
    /// The figure before.
    PreviousFigure,
    /// The pointer draws over the pictures.
    Pen,
    /// A spot shows where the pointer is.
    Spot,
    /// The pictures stay as they are while one edits.
    Freeze,
    /// A black screen.
    Blank,
    /// Takes away what lies over the pictures.
    ClearAnnotations,
    /// A larger interface.
    ZoomIn,
    /// A smaller interface.
    ZoomOut,
    /// The interface at its normal size.
    ZoomReset,
    /// Shows or hides the panel on the left.
    ParametersPanel,
    /// Shows or hides the panel on the right.
    NumbersPanel,
    /// Shows the panel on the left with one of its tabs.
    Tab(Tab),
    /// Shows or hides a picture.
    Show(View),
    /// Says how the pictures share the room; `None`: as suits it.
    Arrange(Option<Arrangement>),
    /// Looks at both 3D pictures from somewhere.
    Observe(ObserverChange),
    /// The 3D pictures as they were seen before.
    ViewBack,
    /// The 3D pictures as they were seen before going back.
    ViewForward,
    /// The world as the section along **u**, or in space.
    Section,
    /// Shows or hides the dimension lines of the world.
    Dimensions,
    /// Turning one 3D picture turns the other.
    LinkOrbits,
    /// Shows or hides the stages of the pipeline.
    Pipeline,
    /// Shows or hides the studies of error against run time.
    Numerics,
    /// Shows or hides the explanations of the numbers.
    Explain,
    /// Shows or hides the exercises.
    Exercises,
    /// Mouse and keyboard at a glance.
    Help,
    /// The version, the licence, and those of the libraries.
    About,
}

/// Shift on top of the platform's command key.
const COMMAND_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

impl Command {
    /// The menu of files.
    pub const FILE: [Self; 10] = [
        Self::New,
        Self::Gallery,
        Self::Open,
        Self::Recent,
        Self::Save,
        Self::SaveAs,
        Self::SaveExplained,
        Self::Export,
        Self::CopyLink,
        Self::Quit,
    ];
    /// The menu of changes.
    pub const EDIT: [Self; 4] = [Self::Undo, Self::Redo, Self::Reset, Self::CopyNumbers];
    /// The menu of what is shown.
    pub const VIEW: [Self; 23] = [
        Self::Show(View::World),
        Self::Show(View::Canonical),
        Self::Show(View::Image),
        Self::Arrange(None),
        Self::Arrange(Some(Arrangement::Row)),
        Self::Arrange(Some(Arrangement::Column)),
        Self::Arrange(Some(Arrangement::Above)),
        Self::Arrange(Some(Arrangement::Beside)),
        Self::Observe(ObserverChange::From(Viewpoint::Front)),
        Self::Observe(ObserverChange::From(Viewpoint::Top)),
        Self::Observe(ObserverChange::From(Viewpoint::Side)),
        Self::Observe(ObserverChange::From(Viewpoint::Iso)),
        Self::Observe(ObserverChange::From(Viewpoint::AlongU)),
        Self::Observe(ObserverChange::From(Viewpoint::AlongV)),
        Self::Observe(ObserverChange::From(Viewpoint::AlongN)),
        Self::Observe(ObserverChange::Fit),
        Self::ViewBack,
        Self::ViewForward,
        Self::Section,
        Self::Dimensions,
        Self::LinkOrbits,
        Self::Pipeline,
        Self::Numerics,
    ];
    /// The menu of the window: its panels, its looks, its language.
    pub const WINDOW: [Self; 13] = [
        Self::Tab(Tab::Camera),
        Self::Tab(Tab::Scene),
        Self::Tab(Tab::Drawing),
        Self::ParametersPanel,
        Self::NumbersPanel,
        Self::Explain,
        Self::Exercises,
        Self::Theme,
        Self::ReduceMotion,
        Self::ZoomIn,
        Self::ZoomOut,
        Self::ZoomReset,
        Self::Language,
    ];
    /// The menu of a presentation.
    pub const PRESENT: [Self; 8] = [
        Self::Presentation,
        Self::NextFigure,
        Self::PreviousFigure,
        Self::Pen,
        Self::Spot,
        Self::Freeze,
        Self::Blank,
        Self::ClearAnnotations,
    ];
    /// The menu of what one may ask.
    pub const HELP: [Self; 2] = [Self::Help, Self::About];

    /// All commands, each once.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::FILE
            .into_iter()
            .chain(Self::EDIT)
            .chain(Self::VIEW)
            .chain(Self::WINDOW)
            .chain(Self::PRESENT)
            .chain(Self::HELP)
    }

    /// Its name.
    #[must_use]
    pub fn label(self, t: &Texts) -> &'static str {
        self.words(t).0
    }

    /// Its tooltip.
    #[must_use]
    pub fn hint(self, t: &Texts) -> &'static str {
        self.words(t).1
    }

    /// The reason why it is disabled, where that is not plain; else its tooltip.
    #[must_use]
    pub fn hint_disabled(self, t: &Texts) -> &'static str {
        if self == Self::Dimensions { t.dimensions_in_section } else { self.hint(t) }
    }

    fn words(self, t: &Texts) -> (&'static str, &'static str) {
        match self {
            Self::New => (t.new, t.new_hint),
            Self::Open => (t.open, t.open_hint),
            Self::Gallery => (t.gallery, t.gallery_hint),
            Self::Recent => (t.recent, t.recent_hint),
            Self::Save => (t.save, t.save_hint),
            Self::SaveAs => (t.save_as, t.save_as_hint),
            Self::Export => (t.export, t.export_hint),
            Self::CopyLink => (sharing::texts(t.lang).copy_link, sharing::texts(t.lang).copy_link_hint),
            Self::Quit => (t.quit, t.quit_hint),
            Self::Undo => (t.undo, t.undo_hint),
            Self::Redo => (t.redo, t.redo_hint),
            Self::Reset => (t.reset, t.reset_hint),
            Self::CopyNumbers => (t.copy_numbers, t.copy_numbers_hint),
            Self::Language => (t.language, t.language_hint),
            Self::Theme => (t.theme, t.theme_hint),
            Self::ReduceMotion => (t.reduce_motion, t.reduce_motion_hint),
            Self::SaveExplained => (t.save_explained, t.save_explained_hint),
            Self::Presentation => (t.presentation, t.presentation_hint),
            Self::NextFigure => (t.next_figure, t.next_figure_hint),
            Self::PreviousFigure => (t.previous_figure, t.previous_figure_hint),
            Self::Pen => (t.pen, t.pen_hint),
            Self::Spot => (t.spot, t.spot_hint),
            Self::Freeze => (t.freeze, t.freeze_hint),
            Self::Blank => (t.blank, t.blank_hint),
            Self::ClearAnnotations => (t.clear_annotations, t.clear_annotations_hint),
            Self::ZoomIn => (t.zoom_in, t.zoom_in_hint),
            Self::ZoomOut => (t.zoom_out, t.zoom_out_hint),
            Self::ZoomReset => (t.zoom_reset, t.zoom_reset_hint),
            Self::ParametersPanel => (t.parameters_panel, t.parameters_panel_hint),
            Self::NumbersPanel => (t.numbers_panel, t.numbers_panel_hint),
            Self::Explain => (t.explain_panel, t.explain_panel_hint),
            Self::Exercises => (t.exercises, t.exercises_hint),
            Self::Tab(Tab::Camera) => (t.camera_tab, t.camera_tab_hint),
            Self::Tab(Tab::Scene) => (t.scene_tab, t.scene_tab_hint),
            Self::Tab(Tab::Drawing) => (t.drawing_tab, t.drawing_tab_hint),
            Self::Show(View::World) => (t.show_world, t.show_picture_hint),
            Self::Show(View::Canonical) => (t.show_canonical, t.show_picture_hint),
            Self::Show(View::Image) => (t.show_image, t.show_picture_hint),
            Self::Arrange(arrangement) => (canvas::texts(t.lang).arrangement(arrangement), t.arrange_hint),
            Self::Observe(ObserverChange::From(Viewpoint::Front)) => (t.look_front, t.look_front_hint),
            Self::Observe(ObserverChange::From(Viewpoint::Top)) => (t.look_top, t.look_top_hint),
            Self::Observe(ObserverChange::From(Viewpoint::Side)) => (t.look_side, t.look_side_hint),
            Self::Observe(ObserverChange::From(Viewpoint::Iso)) => (t.look_iso, t.look_iso_hint),
            Self::Observe(ObserverChange::From(Viewpoint::AlongU)) => (t.look_along_u, t.look_along_u_hint),
            Self::Observe(ObserverChange::From(Viewpoint::AlongV)) => (t.look_along_v, t.look_along_v_hint),
            Self::Observe(ObserverChange::From(Viewpoint::AlongN)) => (t.look_along_n, t.look_along_n_hint),
            Self::Observe(ObserverChange::Fit) => (t.look_fit, t.look_fit_hint),
            Self::ViewBack => (t.view_back, t.view_back_hint),
            Self::ViewForward => (t.view_forward, t.view_forward_hint),
            Self::Section => (t.section_view, t.section_view_hint),
            Self::Dimensions => (t.dimensions, t.dimensions_hint),
            Self::LinkOrbits => (t.link_orbits, t.link_orbits_hint),
            Self::Pipeline => (t.pipeline, t.pipeline_hint),
            Self::Numerics => (t.numerics, t.numerics_hint),
            Self::Help => (t.help, t.help_hint),
            Self::About => (t.about, t.about_hint),
        }
    }

    /// The keys that call it.
    #[must_use]
    pub fn shortcut(self) -> KeyboardShortcut {
        let (modifiers, key) = match self {
            Self::New => (Modifiers::COMMAND, Key::N),
            Self::Open => (Modifiers::COMMAND, Key::O),
            Self::Gallery => (Modifiers::COMMAND, Key::G),
            Self::Recent => (COMMAND_SHIFT, Key::O),
            Self::Save => (Modifiers::COMMAND, Key::S),
            Self::SaveAs => (COMMAND_SHIFT, Key::S),
            Self::Export => (Modifiers::COMMAND, Key::E),
            Self::CopyLink => (Modifiers::COMMAND, Key::K),
            Self::Quit => (Modifiers::COMMAND, Key::Q),
            Self::Undo => (Modifiers::COMMAND, Key::Z),
            Self::Redo => (COMMAND_SHIFT, Key::Z),
            Self::Reset => (Modifiers::COMMAND, Key::R),
            Self::CopyNumbers => (COMMAND_SHIFT, Key::C),
            Self::Language => (Modifiers::COMMAND, Key::L),
            Self::Theme => (Modifiers::COMMAND, Key::T),
            Self::ReduceMotion => (Modifiers::ALT, Key::M),
            Self::SaveExplained => (Modifiers::ALT, Key::Q),
            Self::Presentation => (Modifiers::NONE, Key::F11),
            Self::NextFigure => (Modifiers::COMMAND, Key::PageDown),
            Self::PreviousFigure => (Modifiers::COMMAND, Key::PageUp),
            Self::Pen => (Modifiers::ALT, Key::P),
            Self::Spot => (Modifiers::ALT, Key::S),
            Self::Freeze => (Modifiers::ALT, Key::F),
            Self::Blank => (Modifiers::ALT, Key::B),
            Self::ClearAnnotations => (Modifiers::ALT, Key::Backspace),
            Self::ZoomIn => (Modifiers::COMMAND, Key::Plus),
            Self::ZoomOut => (Modifiers::COMMAND, Key::Minus),
            Self::ZoomReset => (Modifiers::COMMAND, Key::Num0),
            Self::ParametersPanel => (Modifiers::NONE, Key::F8),
            Self::NumbersPanel => (Modifiers::NONE, Key::F9),
            Self::Explain => (Modifiers::ALT, Key::E),
            Self::Exercises => (Modifiers::ALT, Key::X),
            Self::Pipeline => (Modifiers::NONE, Key::F10),
            Self::Numerics => (Modifiers::COMMAND, Key::Num9),
            Self::Tab(Tab::Camera) => (Modifiers::NONE, Key::F5),
            Self::Tab(Tab::Scene) => (Modifiers::NONE, Key::F6),
            Self::Tab(Tab::Drawing) => (Modifiers::NONE, Key::F7),
            Self::Show(View::World) => (Modifiers::COMMAND, Key::Num1),
            Self::Show(View::Canonical) => (Modifiers::COMMAND, Key::Num2),
            Self::Show(View::Image) => (Modifiers::COMMAND, Key::Num3),
            Self::Arrange(None) => (Modifiers::COMMAND, Key::Num4),
            Self::Arrange(Some(Arrangement::Row)) => (Modifiers::COMMAND, Key::Num5),
            Self::Arrange(Some(Arrangement::Column)) => (Modifiers::COMMAND, Key::Num6),
            Self::Arrange(Some(Arrangement::Above)) => (Modifiers::COMMAND, Key::Num7),
            Self::Arrange(Some(Arrangement::Beside)) => (Modifiers::COMMAND, Key::Num8),
            Self::Observe(ObserverChange::From(Viewpoint::Front)) => (Modifiers::ALT, Key::Num1),
            Self::Observe(ObserverChange::From(Viewpoint::Top)) => (Modifiers::ALT, Key::Num2),
            Self::Observe(ObserverChange::From(Viewpoint::Side)) => (Modifiers::ALT, Key::Num3),
            Self::Observe(ObserverChange::From(Viewpoint::Iso)) => (Modifiers::ALT, Key::Num4),
            Self::Observe(ObserverChange::From(Viewpoint::AlongU)) => (Modifiers::ALT, Key::Num5),
            Self::Observe(ObserverChange::From(Viewpoint::AlongV)) => (Modifiers::ALT, Key::Num6),
            Self::Observe(ObserverChange::From(Viewpoint::AlongN)) => (Modifiers::ALT, Key::Num7),
            Self::Observe(ObserverChange::Fit) => (Modifiers::ALT, Key::Num0),
            Self::ViewBack => (Modifiers::ALT, Key::ArrowLeft),
            Self::ViewForward => (Modifiers::ALT, Key::ArrowRight),
            Self::Section => (Modifiers::ALT, Key::Num8),
            Self::Dimensions => (Modifiers::ALT, Key::Num9),
            Self::LinkOrbits => (Modifiers::ALT, Key::L),
            Self::Help => (Modifiers::NONE, Key::F1),
            Self::About => (Modifiers::SHIFT, Key::F1),
        };
        KeyboardShortcut::new(modifiers, key)
    }

    /// Other keys that call it too.
    #[must_use]
    pub fn second_shortcut(self) -> Option<KeyboardShortcut> {
        match self {
            Self::Redo => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::Y)),
            // On most keyboards + is on the key of =.
            Self::ZoomIn => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::Equals)),
            Self::New
            | Self::Open
            | Self::Gallery
            | Self::Recent
            | Self::Save
            | Self::SaveAs
            | Self::Export
            | Self::CopyLink
            | Self::Quit
            | Self::Undo
            | Self::Reset
            | Self::CopyNumbers
            | Self::Language
            | Self::Theme
            | Self::ReduceMotion
            | Self::SaveExplained
            | Self::Presentation
            | Self::NextFigure
            | Self::PreviousFigure
            | Self::Pen
            | Self::Spot
            | Self::Freeze
            | Self::Blank
            | Self::ClearAnnotations
            | Self::ZoomOut
            | Self::ZoomReset
            | Self::ParametersPanel
            | Self::NumbersPanel
            | Self::Explain
            | Self::Exercises
            | Self::Tab(_)
            | Self::Show(_)
            | Self::Arrange(_)
            | Self::Observe(_)
            | Self::ViewBack
            | Self::ViewForward
            | Self::Section
            | Self::Dimensions
            | Self::LinkOrbits
            | Self::Pipeline
            | Self::Numerics
            | Self::Help
            | Self::About => None,
        }
    }

    /// The keys that call it in this window: a page in a browser has to leave some to the browser.
    pub fn keys(self, state: &State) -> impl Iterator<Item = KeyboardShortcut> {
        let keys = [Some(self.shortcut()), self.second_shortcut()].into_iter().flatten();
        keys.filter(move |_| self.is_there(state) && !(state.in_browser && self.has_keys_of_browsers()))
    }

    /// True for keys that call a command in a page of a browser.
    #[must_use]
    pub fn any_has_in_browser(key: Key, modifiers: Modifiers) -> bool {
        Self::all().filter(|command| !command.has_keys_of_browsers()).any(|command| {
            let keys = [Some(command.shortcut()), command.second_shortcut()].into_iter().flatten();
            keys.into_iter().any(|keys| keys.logical_key == key && modifiers.matches_exact(keys.modifiers))
        })
    }

    /// False for what a window of this kind has not.
    #[must_use]
    pub fn is_there(self, state: &State) -> bool {
        // A page has no files that it could open again by itself, and is closed by the browser.
        !(state.in_browser && matches!(self, Self::Recent | Self::Quit))
    }

    /// True where its keys do something that people want of every browser: a new window or tab, the address, reloading,
    /// zooming, other tabs.
    fn has_keys_of_browsers(self) -> bool {
        matches!(
            self,
            Self::New
                | Self::Theme
                | Self::Language
                | Self::Reset
                | Self::ZoomIn
                | Self::ZoomOut
                | Self::ZoomReset
                | Self::NextFigure
                | Self::PreviousFigure
                | Self::Tab(Tab::Camera)
        )
    }

    /// False where it would do nothing.
    #[must_use]
    pub fn is_enabled(self, state: &State) -> bool {
        match self {
            Self::Undo => state.document.can_undo(),
            Self::Redo => state.document.can_redo(),
            Self::Reset => state.document.can_reset(),
            Self::ViewBack => state.views.can_go_back(state.document.figure().observers),
            Self::ViewForward => state.views.can_go_forward(state.document.figure().observers),
            Self::ClearAnnotations => state.annotations.any(),
            Self::Dimensions => !state.document.figure().world.section,
            Self::New
            | Self::Open
            | Self::Gallery
            | Self::Recent
            | Self::Save
            | Self::SaveAs
            | Self::Export
            | Self::CopyLink
            | Self::Quit
            | Self::CopyNumbers
            | Self::Language
            | Self::Theme
            | Self::ReduceMotion
            | Self::SaveExplained
            | Self::Presentation
            | Self::NextFigure
            | Self::PreviousFigure
            | Self::Pen
            | Self::Spot
            | Self::Freeze
            | Self::Blank
            | Self::ZoomIn
            | Self::ZoomOut
            | Self::ZoomReset
            | Self::ParametersPanel
            | Self::NumbersPanel
            | Self::Explain
            | Self::Exercises
            | Self::Tab(_)
            | Self::Show(_)
            | Self::Arrange(_)
            | Self::Observe(_)
            | Self::Section
            | Self::LinkOrbits
            | Self::Pipeline
            | Self::Numerics
            | Self::Help
            | Self::About => true,
        }
    }

    /// The state of a switch.
    #[must_use]
    pub fn is_on(self, state: &State) -> Option<bool> {
        match self {
            Self::Theme => Some(state.settings.theme == Theme::Dark),
            Self::ReduceMotion => Some(state.settings.reduce_motion),
            Self::SaveExplained => Some(state.settings.saves_explained),
            Self::Presentation => Some(state.settings.presentation),
            Self::Pen => Some(state.annotations.pen),
            Self::Spot => Some(state.annotations.spot),
            Self::Freeze => Some(state.annotations.frozen),
            Self::Blank => Some(state.annotations.blank),
            Self::ParametersPanel => Some(state.settings.panels().is_shown(Side::Left)),
            Self::NumbersPanel => Some(state.settings.panels().is_shown(Side::Right)),
            Self::Explain => Some(state.settings.panels().is_shown(Side::Explain)),
            Self::Exercises => Some(state.shows_exercises()),
            Self::Tab(tab) => Some(state.settings.tab == tab && state.settings.panels().is_shown(Side::Left)),
            Self::Show(picture) => Some(state.layout.is_shown(picture)),
            Self::Arrange(arrangement) => Some(state.layout.arrangement == arrangement),
            Self::Section => Some(state.document.figure().world.section),
            Self::Dimensions => Some(state.document.figure().world.dimensions),
            Self::LinkOrbits => Some(state.layout.linked),
            Self::Pipeline => Some(state.layout.strip),
            Self::Numerics => Some(state.numerics.shown),
            Self::New
            | Self::Open
            | Self::Gallery
            | Self::Recent
            | Self::Save
            | Self::SaveAs
            | Self::Export
            | Self::CopyLink
            | Self::Quit
            | Self::Undo
            | Self::Redo
            | Self::Reset
            | Self::CopyNumbers
            | Self::Language
            | Self::NextFigure
            | Self::PreviousFigure
            | Self::ClearAnnotations
            | Self::ZoomIn
            | Self::ZoomOut
            | Self::ZoomReset
            | Self::Observe(_)
            | Self::ViewBack
            | Self::ViewForward
            | Self::Help
            | Self::About => None,
        }
    }

    /// Whether a text field handles it itself while it has the focus.
    #[must_use]
    pub fn is_for_text_too(self) -> bool {
        matches!(self, Self::Undo | Self::Redo)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn no_two_commands_share_keys() {
        let mut seen = HashSet::new();
        for command in Command::all() {
            for keys in [Some(command.shortcut()), command.second_shortcut()].into_iter().flatten() {
                assert!(seen.insert((keys.modifiers, keys.logical_key)), "{command:?}: {keys:?}");
            }
        }
        assert_eq!(Command::all().collect::<HashSet<_>>().len(), Command::all().count());
    }
}
