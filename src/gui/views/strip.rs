//! The strip under the pictures: every stage of the pipeline in the order of `[3]`, with counts in and out, time, or
//! the reason why it was left out, for the picture on the screen.

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    self, Align, Align2, Color32, FontId, Id, Label, Layout, Rect, RichText, Sense, Stroke, StrokeKind, TextStyle, Ui,
    UiBuilder, WidgetInfo, pos2, vec2,
};

use super::icons::{Icon, icon_button};
use crate::gui::kit::{Explained, choice, elide, help_topic};
use crate::numbers;
use crate::pipeline::{Stage, StageReport};
use crate::views::View;
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::why::{notes, pipeline as words};
use camera_lab_words::window::canvas::CanvasTexts;

/// The least width of a cell, in heights of its letters.
const CELL_WIDTH: f32 = 8.2;

/// The action of a control of the strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StripAction {
    /// Show the stages of another picture.
    Of(View),
    /// Hide the strip.
    Close,
    /// Show or hide the input and output of a stage.
    Show(Stage),
}

/// The content of the strip.
pub(super) struct Strip<'a> {
    pub(super) lang: camera_lab_words::Lang,
    pub(super) texts: &'a CanvasTexts,
    pub(super) view: View,
    /// `None` if the picture is hidden, or hasn't been drawn yet.
    pub(super) account: Option<&'a crate::picture::RenderReport>,
    /// The picture is hidden.
    pub(super) hidden: bool,
    /// The stage displayed in the picture.
    pub(super) shown: Option<Stage>,
}

fn font(ui: &Ui) -> FontId {
    TextStyle::Small.resolve(ui.style())
}

fn line(ui: &Ui) -> f32 {
    (ui.text_style_height(&TextStyle::Small) + 1.0).ceil()
}

fn columns(ui: &Ui, width: f32) -> usize {
    let most = Stage::ALL.len();
    let fit = (width - 12.0) / (CELL_WIDTH * line(ui));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a few dozen")]
    let fit = fit.clamp(1.0, 64.0) as usize;
    // No row shorter than necessary: the same number of rows, evenly filled.
    let rows = most.div_ceil(fit.min(most));
    most.div_ceil(rows)
}

fn cell_height(ui: &Ui) -> f32 {
    2.0 * line(ui) + 6.0
}

/// The height of the strip under pictures of this total width.
#[expect(clippy::cast_precision_loss, reason = "a few rows")]
pub(super) fn height(ui: &Ui, width: f32) -> f32 {
    let rows = Stage::ALL.len().div_ceil(columns(ui, width)) as f32;
    ui.spacing().interact_size.y + rows * cell_height(ui) + 8.0
}

impl Strip<'_> {
    /// Draws the strip.
    pub(super) fn show(&self, ui: &mut Ui, rect: Rect) -> Option<StripAction> {
        let edge = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().hline(rect.x_range(), rect.top(), edge);
        let inner = rect.shrink2(vec2(6.0, 3.0));
        let (head, cells) = inner.split_top_bottom_at_y(inner.top() + ui.spacing().interact_size.y);
        let (pointed, clicked) = self.cells(ui, cells.with_min_y(cells.min.y + 1.0));
        self.head(ui, head, pointed.or(self.shown)).or(clicked.map(StripAction::Show))
    }

    /// The picture of the stages, and a sentence about the stage under the pointer.
    fn head(&self, ui: &mut Ui, rect: Rect, pointed: Option<Stage>) -> Option<StripAction> {
        let mut action = None;
        let builder = UiBuilder::new().id_salt("strip").max_rect(rect).layout(Layout::left_to_right(Align::Center));
        ui.scope_builder(builder, |ui| {
            let mut chosen = self.view;
            ui.add(Label::new(RichText::new(self.texts.strip).strong()).selectable(false));
            let views = View::ALL.map(|view| (view, self.texts.view(view)));
            if choice(ui, self.texts.strip_of, self.texts.strip_of, &mut chosen, &views) {
                action = Some(StripAction::Of(chosen));
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if icon_button(ui, Icon::Hide, self.texts.strip_close, false).clicked() {
                    action = Some(StripAction::Close);
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let (room, body) = (ui.available_width(), TextStyle::Body.resolve(ui.style()));
                    let text = elide::words(&self.sentence(pointed), |text| elide::width(ui, &body, text) <= room);
                    ui.add(Label::new(text).truncate().selectable(false));
                });
            });
        });
        action
    }

    /// The stage under the pointer in full, or a summary of the strip.
    fn sentence(&self, pointed: Option<Stage>) -> String {
        let Some(account) = self.account else {
            return (if self.hidden { self.texts.strip_hidden } else { "" }).to_owned();
        };
        if let Some(report) = pointed.and_then(|stage| account.stages.iter().find(|report| report.stage == stage)) {
            return words::line(self.lang, report);
        }
        let ran = account.stages.iter().filter(|report| report.ran).count();
        let out = account.stages.len() - ran;
        format!(
            "{}: {} · {} {ran} · {} {out} · {}",
            self.texts.strip_total,
            self.duration(account.total),
            self.texts.strip_ran,
            self.texts.strip_out,
            self.texts.strip_hint
        )
    }

    /// Draws the cells. Returns the one under the pointer, or with the keyboard.
    fn cells(&self, ui: &Ui, rect: Rect) -> (Option<Stage>, Option<Stage>) {
        let Some(account) = self.account else { return (None, None) };
        let mut clicked = None;
        let columns = columns(ui, rect.width() + 12.0);
        #[expect(clippy::cast_precision_loss, reason = "a few columns")]
        let size = vec2(rect.width() / columns as f32, cell_height(ui));
        let mut pointed = None;
        for (i, report) in account.stages.iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a few columns")]
            let corner = rect.min + size * vec2((i % columns) as f32, (i / columns) as f32);
            let place = Rect::from_min_size(corner, size).shrink2(vec2(1.5, 1.0));
            let response = ui.interact(place, Id::unique(("stage", report.stage)), Sense::click());
            let response = response.on_hover_cursor(egui::CursorIcon::PointingHand);
            let said = words::line(self.lang, report);
            let shown = self.shown == Some(report.stage);
            if response.clicked() {
                clicked = Some(report.stage);
            }
            response.widget_info(|| WidgetInfo {
                selected: Some(shown),
                ..WidgetInfo::labeled(Role::ListItem, true, &said)
            });
            if response.has_focus() || (response.hovered() && pointed.is_none()) {
                pointed = Some(report.stage);
            }
            help_topic(&response, notes::of_stage(report.stage));
            let strong = response.hovered() || response.has_focus();
            self.cell(ui, place, report, account.total, strong);
            response.explained_by(|ui| {
                ui.strong(words::stage(self.lang, report.stage));
                ui.label(with_titles(words::purpose(self.lang, report.stage)));
                ui.label(said);
                ui.weak(if shown { self.texts.strip_unreveal } else { self.texts.strip_reveal });
            });
        }
        (pointed, clicked)
    }

    fn duration(&self, time: Duration) -> String {
        self.lang.mark().printed(&numbers::duration(time))
    }

    /// The counts in and out, with their unit if it `fits`.
    fn counts(&self, report: &StageReport, fits: impl Fn(&str) -> bool) -> String {
        let Some((from, to)) = report.counts else { return String::new() };
        let count = |n| self.lang.mark().printed(&numbers::count(n));
        let unit = words::unit(self.lang, report);
        let (short, long) = match unit.split_once(" → ") {
            // The output is of another kind than the input.
            Some((before, after)) => {
                let short = format!("{}→{}", count(from), count(to));
                (
                    short.clone(),
                    vec![format!("{} {before}→{} {after}", count(from), count(to)), format!("{short} {after}")],
                )
            }
            None if from == to => (count(to), vec![format!("{} {unit}", count(to))]),
            None => {
                let short = format!("{}→{}", count(from), count(to));
                (short.clone(), vec![format!("{short} {unit}")])
            }
        };
        long.into_iter().find(|text| fits(text)).unwrap_or(short)
    }

    fn cell(&self, ui: &Ui, place: Rect, report: &StageReport, total: Duration, strong: bool) {
        let visuals = ui.visuals();
        let painter = ui.painter().with_clip_rect(place.intersect(ui.clip_rect()));
        let shown = self.shown == Some(report.stage);
        let fill = match (shown, report.ran) {
            (true, _) => visuals.selection.bg_fill,
            (false, true) => visuals.extreme_bg_color,
            (false, false) => Color32::TRANSPARENT,
        };
        let border = if strong || shown {
            Stroke::new(1.5, visuals.hyperlink_color)
        } else {
            visuals.widgets.noninteractive.bg_stroke
        };
        painter.rect(place, 3.0, fill, border, StrokeKind::Inside);
        let weak = if shown { visuals.selection.stroke.color } else { visuals.weak_text_color() };
        let ink = match (shown, report.ran) {
            (true, _) => visuals.selection.stroke.color,
            (false, true) => visuals.text_color(),
            (false, false) => weak,
        };
        let (font, height) = (font(ui), line(ui));
        let at = |row: f32| pos2(place.left() + 5.0, place.top() + 2.0 + height * row);
        let name = words::stage(self.lang, report.stage);
        let written = painter.text(at(0.0), Align2::LEFT_TOP, name, font.clone(), ink);
        if report.ran {
            let width = |text: &str| painter.layout_no_wrap(text.to_owned(), font.clone(), ink).size().x;
            let counts = self.counts(report, |text| width(text) <= place.width() - 10.0);
            let counted = painter.text(at(1.0), Align2::LEFT_TOP, counts, font.clone(), weak);
            if let Some(time) = report.time {
                let text = painter.layout_no_wrap(self.duration(time), font, ink);
                let left = place.right() - 5.0 - text.size().x;
                // Beside the counts, or above them if they take the room. If the name takes it too, the sentence has
                // it.
                let rows = [(1.0, counted), (0.0, written)];
                if let Some((row, _)) = rows.iter().find(|(_, beside)| left > beside.right() + 3.0) {
                    painter.galley(pos2(left, at(*row).y), text, ink);
                }
                let share = time.as_secs_f32() / total.as_secs_f32().max(1e-9);
                let bar = Rect::from_min_max(
                    pos2(place.left() + 1.0, place.bottom() - 3.0),
                    pos2(place.left() + 1.0 + (place.width() - 2.0) * share.clamp(0.0, 1.0), place.bottom() - 1.0),
                );
                painter.rect_filled(bar, 1.0, visuals.hyperlink_color);
            }
        } else {
            let middle = written.center().y + 0.5;
            painter.hline(written.x_range(), middle, Stroke::new(1.0, ink));
            // The first words of a reason that is too long. The tooltip shows it whole.
            let room = place.width() - 10.0;
            let whole = words::reason(self.lang, report.reason);
            let reason = elide::words(&whole, |text| elide::width(ui, &font, text) <= room);
            painter.text(at(1.0), Align2::LEFT_TOP, reason, font, ink);
        }
    }
}
