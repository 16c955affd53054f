//! The lines under the pictures: hints and position of the pointer, and the coordinates of the probe.

use eframe::egui::{
    self, Align, Color32, FontId, Id, Label, Layout, Popup, Rect, RichText, TextStyle, Ui, UiBuilder, pos2, vec2,
};

use super::brief::Brief;
use super::icons::{Icon, icon_button};
use super::long_work::LongWork;
use super::readout::Cell;
use crate::gui::kit::{Explained, elide, is_handheld, with_room_before};
use crate::views::{Arrangement, View};
use camera_lab_words::window::canvas::CanvasTexts;

/// Room between two cells, in heights of a line.
const GAP: f32 = 1.0;

/// The width of the bar that shows the progress of long work.
const BAR: f32 = 120.0;

/// The action of a button under the pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StatusAction {
    /// Show a hidden picture.
    ShowAgain(View),
    /// Share the room in another way. `None` for the best way in the room.
    Arrange(Option<Arrangement>),
    /// Show the coach.
    Coach,
}

/// The content of the lines under the pictures.
#[derive(Default)]
pub(super) struct Status {
    /// The first line.
    pub(super) message: String,
    /// True in a presentation.
    pub(super) presenting: bool,
    /// For a while the keys of a presentation replace the message, with this opacity.
    pub(super) keys: Option<(&'static str, f32)>,
    /// Long work replaces both.
    pub(super) work: Option<LongWork>,
    /// True if the message says why something isn't possible.
    pub(super) warning: bool,
    /// At the right end of the first line.
    pub(super) aside: String,
    /// The arrangement of the pictures, if there is a choice.
    pub(super) arrangement: Option<Option<Arrangement>>,
    /// The summary of the coach.
    pub(super) coach: Option<Brief>,
    /// The pictures that can be shown again.
    pub(super) hidden: Vec<View>,
    /// The coordinates of the probe.
    pub(super) cells: Vec<Cell>,
    /// The cells with all digits, for the tooltip.
    pub(super) exact: Vec<Cell>,
    /// The text without a probe, or after the cells.
    pub(super) note: &'static str,
}

/// Number of lines of cells. It depends on the space alone, so that nothing moves when the probe comes and goes.
fn lines(ui: &Ui, width: f32, presenting: bool) -> u8 {
    let em = line_height(ui);
    if presenting {
        // The room is for the pictures, because the card has all coordinates of the pinned probe.
        1
    } else if width >= 120.0 * em {
        1
    } else if width >= 46.0 * em || is_handheld(ui.ctx()) {
        2
    } else {
        3
    }
}

fn font(ui: &Ui) -> FontId {
    TextStyle::Small.resolve(ui.style())
}

pub(super) fn line_height(ui: &Ui) -> f32 {
    (ui.text_style_height(&TextStyle::Small) + 2.0).ceil()
}

fn first_line_height(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y
}

/// The height of the lines under pictures of this total width.
pub(super) fn height(ui: &Ui, width: f32, presenting: bool) -> f32 {
    first_line_height(ui) + f32::from(lines(ui, width, presenting)) * line_height(ui) + 4.0
}

impl Status {
    /// Draws the lines, with their buttons.
    pub(super) fn show(&self, ui: &mut Ui, rect: Rect, texts: &CanvasTexts) -> Option<StatusAction> {
        let inner = rect.shrink2(vec2(6.0, 1.0));
        let first = Rect::from_min_size(inner.min, vec2(inner.width(), first_line_height(ui)));
        let action = self.first_line(ui, first, texts);
        let lines = lines(ui, rect.width(), self.presenting);
        let cells = Rect::from_min_max(pos2(inner.left(), first.bottom()), inner.max);
        self.cells(ui, cells, lines);
        action
    }

    fn first_line(&self, ui: &mut Ui, rect: Rect, texts: &CanvasTexts) -> Option<StatusAction> {
        let mut action = None;
        let builder = UiBuilder::new().id_salt("status").max_rect(rect).layout(Layout::left_to_right(Align::Center));
        ui.scope_builder(builder, |ui| {
            with_room_before(
                ui,
                |ui| self.message(ui),
                |ui| {
                    if self.presenting && !ui.rect_contains_pointer(rect.expand(4.0)) {
                        return;
                    }
                    if !self.hidden.is_empty() {
                        ui.add(Label::new(RichText::new(texts.hidden).small()).selectable(false));
                    }
                    for &picture in &self.hidden {
                        if ui.small_button(RichText::new(texts.view(picture)).small()).clicked() {
                            action = Some(StatusAction::ShowAgain(picture));
                        }
                    }
                    if !self.aside.is_empty() {
                        ui.add(Label::new(RichText::new(&self.aside).small()).selectable(false));
                    }
                    if let Some(brief) = &self.coach
                        && named(ui, "coach", |ui| brief.button(ui)).clicked()
                    {
                        action = Some(StatusAction::Coach);
                    }
                    if let Some(now) = self.arrangement {
                        action = named(ui, "arrangement", |ui| arrangement_menu(ui, now, texts)).or(action);
                    }
                },
            );
        });
        action
    }

    /// The hint for the target of the pointer, or the progress of long work.
    fn message(&self, ui: &mut Ui) {
        if let Some(work) = &self.work {
            if let Some(share) = work.share {
                ui.add(egui::ProgressBar::new(share).desired_width(BAR).desired_height(8.0));
            }
            ui.add(Label::new(RichText::new(&work.text).small().strong()).truncate().selectable(false));
            return;
        }
        let room = ui.available_width();
        if let Some((keys, opacity)) = self.keys {
            let said = elide::parts(keys, |text| elide::width(ui, &font(ui), text) <= room);
            let color = ui.visuals().strong_text_color().gamma_multiply(opacity);
            ui.add(Label::new(RichText::new(said).small().color(color)).truncate().selectable(false)).explained(keys);
            return;
        }
        let said = elide::parts(&self.message, |text| elide::width(ui, &font(ui), text) <= room);
        if said != self.message && !self.warning && is_handheld(ui.ctx()) {
            // A hint for a pointer.
            return;
        }
        let mut text = RichText::new(&said).small();
        if self.warning {
            text = text.color(ui.visuals().warn_fg_color).strong();
        }
        let shown = ui.add(Label::new(text).truncate().selectable(false));
        if said != self.message {
            shown.explained(&self.message);
        }
    }

    /// The cells one after the other, each with its own width: all of them, or the most wanted.
    fn cells(&self, ui: &mut Ui, rect: Rect, lines: u8) {
        let response = ui
            .scope_builder(UiBuilder::new().id_salt("probe").max_rect(rect), |ui| {
                ui.expand_to_include_rect(rect);
                let all: Vec<&Cell> = self.cells.iter().collect();
                let wanted: Vec<&Cell> = self.cells.iter().filter(|cell| cell.wanted).collect();
                let (places, fit) = flow(ui, rect, lines, &all);
                let (cells, places) =
                    if fit { (all, places) } else { (wanted.clone(), flow(ui, rect, lines, &wanted).0) };
                for (cell, place) in cells.into_iter().zip(places) {
                    show_cell(ui, place, cell);
                }
                if self.cells.is_empty() {
                    // Wrapped if it's longer than a line, because narrow pictures have room for several.
                    let label = Label::new(RichText::new(self.note).small().weak()).selectable(false);
                    ui.add(if lines > 1 { label.wrap() } else { label.truncate() });
                }
            })
            .response;
        if !self.exact.is_empty() {
            response.explained_by(|ui| table(ui, &self.exact));
        }
    }
}

/// A button whose identity doesn't depend on the ones before it. A press and its release belong together, even if one
/// of those comes or goes in between.
fn named<R>(ui: &mut Ui, name: &'static str, button: impl FnOnce(&mut Ui) -> R) -> R {
    ui.scope_builder(UiBuilder::new().scope_id(Id::unique(("under the pictures", name))), button).inner
}

fn arrangement_menu(ui: &mut Ui, now: Option<Arrangement>, texts: &CanvasTexts) -> Option<StatusAction> {
    let mut action = None;
    let button = icon_button(ui, Icon::Arrange, texts.arrange, false);
    Popup::menu(&button).show(|ui| {
        // Menus leave borders out. Without one, an unchosen button is invisible on a light background.
        ui.visuals_mut().widgets.inactive.bg_stroke = ui.visuals().widgets.noninteractive.fg_stroke;
        for choice in [None].into_iter().chain(Arrangement::ALL.map(Some)) {
            if ui.radio(choice == now, texts.arrangement(choice)).clicked() {
                action = Some(StatusAction::Arrange(choice));
                ui.close();
            }
        }
    });
    action
}

/// The places of cells one after the other in `lines` lines, as many as there is space for. Returns true if those are
/// all.
fn flow(ui: &Ui, rect: Rect, lines: u8, cells: &[&Cell]) -> (Vec<Rect>, bool) {
    let height = line_height(ui);
    let (mut places, mut line, mut x) = (Vec::new(), 0_u8, rect.left());
    for cell in cells {
        let width = (ui.painter().layout_job(cell_text(ui, cell)).size().x.ceil() + 1.0).min(rect.width());
        if x > rect.left() && x + width > rect.right() {
            (line, x) = (line + 1, rect.left());
        }
        if line == lines {
            return (places, false);
        }
        places.push(Rect::from_min_size(pos2(x, rect.top() + f32::from(line) * height), vec2(width, height)));
        x += width + GAP * height;
    }
    (places, true)
}

fn cell_text(ui: &Ui, cell: &Cell) -> egui::text::LayoutJob {
    let (weak, strong) = (ui.visuals().weak_text_color(), ui.visuals().text_color());
    let font = font(ui);
    let mut job = egui::text::LayoutJob::default();
    let format = |color: Color32| egui::TextFormat::simple(font.clone(), color);
    job.append(&format!("{} ", cell.space), 0.0, format(weak));
    job.append(&cell.value, 0.0, format(strong));
    job
}

fn show_cell(ui: &mut Ui, place: Rect, cell: &Cell) {
    let text = cell_text(ui, cell);
    line_of_text(ui, place, text);
}

/// A text that is cut off at the end of its place.
fn line_of_text(ui: &mut Ui, place: Rect, text: impl Into<egui::WidgetText>) {
    let text = text.into();
    ui.put(place, |ui: &mut Ui| {
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| ui.add(Label::new(text).truncate().selectable(false)))
            .inner
    });
}

/// The coordinates, one space in a line.
pub(super) fn table(ui: &mut Ui, cells: &[Cell]) {
    egui::Grid::new("probe table").num_columns(2).show(ui, |ui| {
        for cell in cells {
            ui.label(RichText::new(cell.space).small().weak());
            ui.label(RichText::new(&cell.value).monospace());
            ui.end_row();
        }
    });
}
