//! The title of a picture: its name, and the buttons that change its viewpoint and scale.

use eframe::egui::{self, Align2, Id, Popup, Rect, RichText, Sense, TextStyle, Ui, UiBuilder, WidgetText};

use crate::gui::kit::{Command, Explained, written};
use crate::gui::views::icons::{Icon, icon_button, left_center};
use crate::views::View;
use crate::views::observer::Viewpoint;
use camera_lab_desk::ObserverChange;
use camera_lab_words::window;
use camera_lab_words::window::canvas::CanvasTexts;

/// The action of a title's button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gui::views) enum TitleAction {
    /// Look from somewhere else.
    Observe(ObserverChange),
    /// Give the picture all the room, or restore the others.
    ToggleMaximized,
    /// Hides the picture.
    Hide,
    /// Show the image as the eye would see it, or its m × n pixels again.
    ToggleUndistorted,
    /// Something that belongs to the window.
    Do(Command),
}

/// The content of a title.
pub(in crate::gui::views) struct Title<'a> {
    pub(in crate::gui::views) view: View,
    pub(in crate::gui::views) name: &'a str,
    pub(in crate::gui::views) texts: &'a CanvasTexts,
    pub(in crate::gui::views) linked: bool,
    pub(in crate::gui::views) maximized: bool,
    /// True in a presentation, in which only the name is shown until the pointer is over the title.
    pub(in crate::gui::views) quiet: bool,
    /// False for the only picture left.
    pub(in crate::gui::views) can_hide: bool,
    /// True if the image is shown as the eye would see it. `None` if that makes no difference.
    pub(in crate::gui::views) undistorted: Option<bool>,
    /// True if the world is shown as a section. `None` for the other pictures.
    pub(in crate::gui::views) section: Option<bool>,
}

const CHANGES: [ObserverChange; 8] = [
    ObserverChange::Fit,
    ObserverChange::From(Viewpoint::Front),
    ObserverChange::From(Viewpoint::Top),
    ObserverChange::From(Viewpoint::Side),
    ObserverChange::From(Viewpoint::Iso),
    ObserverChange::From(Viewpoint::AlongU),
    ObserverChange::From(Viewpoint::AlongV),
    ObserverChange::From(Viewpoint::AlongN),
];

/// The number of [`CHANGES`] for a canonical volume, which has no u, v and n of its own.
const OF_THE_CUBE: usize = 5;

impl Title<'_> {
    /// Draws the title in `rect`. The menu of viewpoints has its word if there is room.
    pub(in crate::gui::views) fn show(&self, ui: &mut Ui, rect: Rect) -> Option<TitleAction> {
        let mut action = None;
        let font = TextStyle::Button.resolve(ui.style());
        let galley = WidgetText::from(self.name).into_galley(ui, Some(egui::TextWrapMode::Extend), f32::INFINITY, font);
        let side = ui.spacing().interact_size.y;
        let solid = matches!(self.view, View::World | View::Canonical);
        let word = button_width(ui, self.menu_text());
        let room_beside = |extra: f32, buttons: u8| {
            rect.width() >= galley.size().x + f32::from(buttons) * (side + 1.0) + 18.0 + extra
        };
        let worded = solid && room_beside(word, 3);
        let observer_buttons: u8 = match (solid, worded) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => 2,
        };
        let buttons = observer_buttons + 1 + u8::from(self.can_hide);
        let room_for_switch = self.undistorted.map_or(0.0, |_| button_width(ui, self.switch_text()));
        let room_for_word = if worded { word } else { 0.0 };
        let width = f32::from(buttons) * (side + 1.0) + if solid { 5.0 } else { 1.0 } + room_for_switch + room_for_word;

        let bar = ui.interact(rect, Id::unique(("picture title", self.view)), Sense::CLICK);
        if bar.double_clicked() {
            action = Some(TitleAction::ToggleMaximized);
        }
        let is_quiet = self.quiet && !ui.rect_contains_pointer(rect) && !ui.ctx().any_popup_open();
        let width = if is_quiet { 0.0 } else { width };
        let room = Rect::from_min_max(egui::pos2(rect.right() - width, rect.top()), rect.max);
        let builder = UiBuilder::new()
            .id_salt(("title buttons", self.view))
            .max_rect(room)
            .layout(egui::Layout::left_to_right(egui::Align::Center));
        ui.scope_builder(builder, |ui| {
            if is_quiet {
                return;
            }
            ui.spacing_mut().item_spacing.x = 1.0;
            if solid {
                action = self.observer_menu(ui, worded).or(action);
                if icon_button(ui, Icon::Fit, self.texts.fit, false).clicked() {
                    action = Some(TitleAction::Observe(ObserverChange::Fit));
                }
                ui.add_space(4.0);
            }
            if let Some(on) = self.undistorted {
                let switch = egui::Button::selectable(on, self.switch_text());
                if ui.add(switch.frame_when_inactive(true)).explained(self.texts.undistorted_hint).clicked() {
                    action = Some(TitleAction::ToggleUndistorted);
                }
            }
            let (icon, text) = if self.maximized {
                (Icon::Restore, self.texts.restore)
            } else {
                (Icon::Maximize, self.texts.maximize)
            };
            if icon_button(ui, icon, text, false).clicked() {
                action = Some(TitleAction::ToggleMaximized);
            }
            if self.can_hide && icon_button(ui, Icon::Hide, self.texts.hide, false).clicked() {
                action = Some(TitleAction::Hide);
            }
        });
        let font = TextStyle::Button.resolve(ui.style());
        let left = (room.left() - rect.left() - 9.0).max(0.0);
        let galley = WidgetText::from(self.name).into_galley(ui, Some(egui::TextWrapMode::Truncate), left, font);
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        let place = Align2::LEFT_CENTER.anchor_size(left_center(rect, 6.0), galley.size());
        painter.galley(place.min, galley, ui.visuals().strong_text_color());
        action
    }

    fn switch_text(&self) -> RichText {
        RichText::new(self.texts.undistorted).small()
    }

    fn menu_text(&self) -> RichText {
        RichText::new(format!("{} ▾", self.texts.look)).small()
    }

    fn changes(&self) -> impl Iterator<Item = ObserverChange> + use<> {
        CHANGES.into_iter().take(if self.view == View::World { CHANGES.len() } else { OF_THE_CUBE })
    }

    /// The menu of viewpoints, in words and with their keys.
    fn observer_menu(&self, ui: &mut Ui, worded: bool) -> Option<TitleAction> {
        let mut action = None;
        let button = if worded {
            let button = ui.add(egui::Button::new(self.menu_text()).frame_when_inactive(false));
            button.explained(self.texts.look_menu).accessible_name(self.texts.look_menu)
        } else {
            icon_button(ui, Icon::Iso, self.texts.look_menu, false)
        };
        Popup::menu(&button).show(|ui| action = self.viewpoints(ui));
        action
    }

    /// The entries of the menu of viewpoints.
    fn viewpoints(&self, ui: &mut Ui) -> Option<TitleAction> {
        let mut action = None;
        for change in self.changes() {
            let keys = written(ui.ctx(), &Command::Observe(change).shortcut(), self.texts.lang);
            let entry = egui::Button::new(change_name(self.texts, change)).shortcut_text(keys);
            if ui.add(entry).clicked() {
                action = Some(TitleAction::Observe(change));
            }
        }
        ui.separator();
        ui.scope(|ui| {
            // Menus have no borders, without which an empty box is invisible.
            ui.visuals_mut().widgets.inactive.bg_stroke = ui.ctx().global_style().visuals.widgets.inactive.bg_stroke;
            if let Some(mut on) = self.section
                && ui.checkbox(&mut on, self.texts.section).changed()
            {
                action = Some(TitleAction::Do(Command::Section));
            }
            let mut linked = self.linked;
            if ui.checkbox(&mut linked, self.texts.link).changed() {
                action = Some(TitleAction::Do(Command::LinkOrbits));
            }
        });
        action
    }

    /// The menu that a right click in the picture opens.
    pub(in crate::gui::views) fn context_menu(&self, ui: &mut Ui, t: &window::Texts) -> Option<TitleAction> {
        let mut action = None;
        if matches!(self.view, View::World | View::Canonical) {
            action = self.viewpoints(ui);
            ui.separator();
        }
        let size = if self.maximized { self.texts.restore } else { self.texts.maximize };
        let mut offer = |ui: &mut Ui, name: &str, then: TitleAction| {
            if ui.button(name).clicked() {
                action = Some(then);
            }
        };
        offer(ui, size, TitleAction::ToggleMaximized);
        if self.can_hide {
            offer(ui, self.texts.hide, TitleAction::Hide);
        }
        ui.separator();
        for command in [Command::KeepCamera, Command::Compare, Command::Export] {
            let keys = written(ui.ctx(), &command.shortcut(), self.texts.lang);
            if ui.add(egui::Button::new(command.label(t)).shortcut_text(keys)).clicked() {
                action = Some(TitleAction::Do(command));
            }
        }
        if action.is_some() {
            ui.close();
        }
        action
    }
}

/// Width of a button with a small text.
fn button_width(ui: &Ui, text: RichText) -> f32 {
    let extend = Some(egui::TextWrapMode::Extend);
    let galley = WidgetText::from(text).into_galley(ui, extend, f32::INFINITY, TextStyle::Small);
    galley.size().x + 2.0 * ui.spacing().button_padding.x + 2.0
}

fn change_name(texts: &CanvasTexts, change: ObserverChange) -> &'static str {
    match change {
        ObserverChange::Fit => texts.fit,
        ObserverChange::From(Viewpoint::Front) => texts.front,
        ObserverChange::From(Viewpoint::Top) => texts.top,
        ObserverChange::From(Viewpoint::Side) => texts.side,
        ObserverChange::From(Viewpoint::Iso) => texts.iso,
        ObserverChange::From(Viewpoint::AlongU) => texts.along_u,
        ObserverChange::From(Viewpoint::AlongV) => texts.along_v,
        ObserverChange::From(Viewpoint::AlongN) => texts.along_n,
    }
}
