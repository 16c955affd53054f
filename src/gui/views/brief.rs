//! The camera check in the pictures: a few words under them, and in an empty image the reason why it's empty.

use eframe::egui::{self, Align, Button, Layout, Rect, Response, RichText, TextStyle, Ui, UiBuilder, vec2};

use crate::gui::kit::{Explained, elide, theme};
use crate::numerics::diagnosis::Diagnosis;
use crate::numerics::health::Level;
use camera_lab_desk::{Advice, Model};
use camera_lab_words::window::coach as words;

/// The summary of the coach.
pub(super) struct Brief {
    text: String,
    level: Level,
    lang: camera_lab_words::Lang,
}

impl Brief {
    /// The last advice, until there is more. `None` in a presentation, which uses the space for the keys.
    pub(super) fn of(model: &Model) -> Option<Self> {
        if model.settings.presentation {
            return None;
        }
        let lang = model.settings.lang;
        let t = words::texts(lang);
        let Some(Advice { diagnosis, health, .. }) = model.coach.newest_advice() else {
            return Some(Self { text: t.looking.to_owned(), level: Level::Good, lang });
        };
        let worst = health.iter().map(|line| line.level).max().unwrap_or(Level::Good);
        let findings = diagnosis.as_ref().map_or(0, |diagnosis| diagnosis.findings.len());
        let (text, level) = match diagnosis {
            Some(Diagnosis { camera_error: Some(_), .. }) => (t.one_finding.to_owned(), Level::Poor),
            Some(diagnosis) if model.is_image_empty(diagnosis) => (t.image_empty.to_owned(), Level::Poor),
            Some(Diagnosis { visible: 0, .. }) => (words::camera_is(lang, worst), worst),
            _ if findings == 1 => (t.one_finding.to_owned(), Level::Fair.max(worst)),
            _ if findings > 1 => (format!("{findings} {}", t.many_findings), Level::Fair.max(worst)),
            _ => (words::camera_is(lang, worst), worst),
        };
        Some(Self { text, level, lang })
    }

    /// The text of the button.
    fn shown(text: &str, level: Level) -> String {
        if level > Level::Good { format!("⚠ {text}") } else { text.to_owned() }
    }

    /// Space for any of its texts, so that its neighbours don't move under the pointer.
    fn room(&self, ui: &Ui) -> f32 {
        let t = words::texts(self.lang);
        let levels = [Level::Good, Level::Fair, Level::Poor];
        let texts = levels.map(|level| Self::shown(&words::camera_is(self.lang, level), level)).into_iter();
        let findings = [t.image_empty.to_owned(), format!("99 {}", t.many_findings)];
        let texts = texts.chain(findings.iter().map(|text| Self::shown(text, Level::Poor)));
        let font = TextStyle::Small.resolve(ui.style());
        let widest = texts.map(|text| elide::width(ui, &font, &text)).fold(0.0, f32::max);
        (widest + 2.0 * ui.spacing().button_padding.x).ceil()
    }

    /// A small button with it.
    pub(super) fn button(&self, ui: &mut Ui) -> Response {
        let mut text = RichText::new(Self::shown(&self.text, self.level)).small();
        if self.level > Level::Good {
            text = text.color(theme::level_color(ui, self.level));
        }
        let button = Button::new(text).min_size(vec2(self.room(ui), 0.0));
        ui.add(button).explained(words::texts(self.lang).coach_hint)
    }
}

/// Names the files that the figure needs and that can't be read, in the lower corner of the image. Returns true if
/// there are any.
pub(super) fn lost_files(ui: &mut Ui, picture: Rect, model: &Model) -> bool {
    let lost = model.scene_cache.lost_files();
    if lost.is_empty() {
        return false;
    }
    let room = picture.shrink2(vec2(16.0, 8.0));
    let place = Rect::from_min_max(egui::pos2(room.left(), room.bottom() - room.height().min(90.0)), room.max);
    let builder = UiBuilder::new()
        .id_salt("lost files")
        .max_rect(place)
        .layout(Layout::bottom_up(Align::Min).with_cross_justify(false));
    ui.scope_builder(builder, |ui| {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            theme::sentence_label(ui, &words::lost_files(model.settings.lang, &lost));
        });
    });
    true
}

/// Explains an empty image over it, with the button of the repair.
pub(super) fn why_empty(ui: &mut Ui, picture: Rect, model: &mut Model) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let Some(diagnosis) = model.coach.advice().and_then(|advice| advice.diagnosis.as_ref()) else { return };
    let Some(finding) = diagnosis.findings.first().filter(|_| model.is_image_empty(diagnosis)) else { return };
    let (text, repair) = (words::finding(lang, finding, diagnosis, &model.desk.shown.figure().scene), finding.repair);
    let change = repair.map(|repair| model.changes_of(&repair));
    let room = picture.shrink2(vec2(16.0, 8.0));
    let width = room.width().min(420.0);
    let place = Rect::from_center_size(room.center(), vec2(width, room.height().min(110.0)));
    let mut pressed = false;
    let builder = UiBuilder::new().id_salt("why empty").max_rect(place).layout(Layout::top_down(Align::Center));
    ui.scope_builder(builder, |ui| {
        let frame = egui::Frame::popup(ui.style());
        frame.show(ui, |ui| {
            theme::sentence_label(ui, &text);
            if let Some(change) = change {
                pressed = ui.button(t.show_it).explained(change).clicked();
            }
        });
    });
    if let Some(repair) = repair.filter(|_| pressed) {
        model.apply_repair(repair);
        ui.request_repaint();
    }
}
