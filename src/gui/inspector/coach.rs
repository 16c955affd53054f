//! The coach: in an empty image why it is empty, under the pictures a few words, and in a dialog all there is to say,
//! with repairs.

use eframe::egui::{self, Align, Button, Color32, Layout, Rect, Response, RichText, TextStyle, Ui, UiBuilder, vec2};

use crate::camera::ImageSize;
use crate::figure::{Explanation, Figure};
use crate::gui::files::questions::{Dialog, FileFlow};
use crate::gui::inspector::state::coach::{Advice, Coach};
use crate::gui::kit::dialog_buttons::{CANCEL, Pressed, buttons};
use crate::gui::kit::tooltip::Explained;
use crate::gui::kit::{elide, theme};
use crate::gui::model::Model;
use crate::i18n::Lang;
use crate::i18n::window::Texts;
use crate::i18n::window::coach as words;
use crate::numerics::diagnosis::{Cause, Diagnosis, IN_A_WINDOW, Repair, changes};
use crate::numerics::health::Level;

/// The width of the dialog.
pub(in crate::gui) const WIDTH: f32 = 720.0;

/// The summary of the coach.
pub(in crate::gui) struct Brief {
    text: String,
    level: Level,
    lang: Lang,
}

impl Brief {
    /// The last advice, until there is more. `None` in a presentation, where the space is for the keys.
    pub(in crate::gui) fn of(model: &Model, coach: &Coach) -> Option<Self> {
        if model.settings.presentation {
            return None;
        }
        let lang = model.settings.lang;
        let t = words::texts(lang);
        let Some(Advice { diagnosis, health, .. }) = coach.newest_advice() else {
            return Some(Self { text: t.looking.to_owned(), level: Level::Good, lang });
        };
        let worst = health.iter().map(|line| line.level).max().unwrap_or(Level::Good);
        let findings = diagnosis.as_ref().map_or(0, |diagnosis| diagnosis.findings.len());
        let (text, level) = match diagnosis {
            Some(Diagnosis { camera_error: Some(_), .. }) => (t.one_finding.to_owned(), Level::Poor),
            Some(diagnosis) if is_empty(model, diagnosis) => (t.image_empty.to_owned(), Level::Poor),
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

    /// Space for any of its texts, so that nothing beside it moves under the pointer.
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
    pub(in crate::gui) fn button(&self, ui: &mut Ui) -> Response {
        let mut text = RichText::new(Self::shown(&self.text, self.level)).small();
        if self.level > Level::Good {
            text = text.color(color(ui, self.level));
        }
        let button = Button::new(text).min_size(vec2(self.room(ui), 0.0));
        ui.add(button).explained(words::texts(self.lang).coach_hint)
    }
}

fn color(ui: &Ui, level: Level) -> Color32 {
    match level {
        Level::Good => ui.visuals().text_color(),
        Level::Fair => ui.visuals().warn_fg_color,
        Level::Poor => ui.visuals().error_fg_color,
    }
}

/// Whether nothing is visible although there's something to see. With an impossible camera the last good image stays,
/// and a photograph without a scene is an image too.
fn is_empty(model: &Model, diagnosis: &Diagnosis) -> bool {
    let is_photograph = model.scene_cache.scene().photograph.is_some()
        && diagnosis.findings.iter().all(|finding| finding.cause == Cause::EmptyScene);
    diagnosis.visible == 0 && diagnosis.camera_error.is_none() && !is_photograph
}

/// Explains an empty image over it, with the button of the repair.
pub(in crate::gui) fn why_empty(ui: &mut Ui, picture: Rect, model: &mut Model, coach: &Coach) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let Some(diagnosis) = coach.advice().and_then(|advice| advice.diagnosis.as_ref()) else { return };
    let Some(finding) = diagnosis.findings.first().filter(|_| is_empty(model, diagnosis)) else { return };
    let (text, repair) = (words::finding(lang, finding, diagnosis, &model.document.figure().scene), finding.repair);
    let change = repair.map(|repair| change(model, &repair));
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

/// The changes of a repair.
fn change(model: &Model, repair: &Repair) -> String {
    // The numbers in the fields, which may make no camera.
    let camera = *model.document.draft();
    let figure = Figure { camera, ..model.document.figure().without_scene() };
    words::changes_in_symbols(model.settings.lang, &repair.changes(&figure))
}

/// An action to take.
enum Wish {
    Repair(Repair),
    Camera(crate::camera::Parameters),
    /// Go to the explanation of depths.
    Depth,
}

/// The dialog with all there is to say.
pub(in crate::gui) fn show(
    ui: &mut Ui,
    t: &Texts,
    model: &mut Model,
    file_flow: &mut FileFlow,
    coach: &Coach,
    first: bool,
) {
    let words = words::texts(model.settings.lang);
    ui.heading(words.coach);
    let height = (ui.ctx().content_rect().height() - 150.0).max(120.0);
    let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false, true]);
    let mut wish = None;
    area.show(ui, |ui| match coach.advice().cloned() {
        None => drop(ui.label(words.looking)),
        Some(advice) => {
            findings(ui, model, &advice, &mut wish);
            health(ui, model, &advice, &mut wish);
            if ui.link(words.about_depth).clicked() {
                wish = Some(Wish::Depth);
            }
        }
    });
    ui.add_space(8.0);
    let closed = !matches!(buttons(ui, t.close, &[], first.then_some(CANCEL)), Pressed::Nothing);
    let Some(wish) = wish else {
        file_flow.dialog = (!closed).then_some(Dialog::Coach);
        return;
    };
    match wish {
        Wish::Repair(repair) => model.apply_repair(repair),
        Wish::Camera(camera) => model.apply_camera(camera),
        Wish::Depth => {
            file_flow.dialog = None;
            model.show_explanation(Explanation::Depth);
        }
    }
    ui.request_repaint();
}

fn title(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(text).font(theme::bold(12.5)));
}

fn findings(ui: &mut Ui, model: &Model, advice: &Advice, wish: &mut Option<Wish>) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    title(ui, t.findings);
    let Some(diagnosis) = &advice.diagnosis else {
        ui.label(t.too_large);
        return;
    };
    if diagnosis.camera_error.is_none() {
        ui.label(words::seen(lang, diagnosis.visible, diagnosis.covered));
    }
    if diagnosis.findings.is_empty() {
        let ImageSize { width, height } = model.document.figure().image;
        let is_coarse = u64::from(width) * u64::from(height) > IN_A_WINDOW;
        ui.label(if is_coarse { t.no_problems_in_coarse } else { t.no_problems });
    }
    for finding in &diagnosis.findings {
        let button = finding.repair.map(|repair| (t.show_it, change(model, &repair)));
        if line(ui, &words::finding(lang, finding, diagnosis, &model.document.figure().scene), button) {
            *wish = finding.repair.map(Wish::Repair);
        }
    }
}

fn health(ui: &mut Ui, model: &Model, advice: &Advice, wish: &mut Option<Wish>) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    if !advice.health.is_empty() {
        title(ui, t.health);
    }
    for health in &advice.health {
        let color = color(ui, health.level);
        let sign = if health.level == Level::Good { "" } else { "⚠ " };
        let (name, level) = (words::quantity(lang, health.quantity), words::level(lang, health.level));
        ui.label(RichText::new(format!("{sign}{name}: {level}")).color(color));
        let figure = model.document.figure();
        let change = |camera| words::changes_in_symbols(lang, &changes(&figure.camera, camera));
        let button = health.repair.as_ref().map(|camera| (t.improve, change(camera)));
        if line(ui, &words::health(lang, health, &advice.camera, figure.style.depth_format), button) {
            *wish = health.repair.map(Wish::Camera);
        }
    }
}

/// A sentence, and the button that acts on it. True if that was pressed.
fn line(ui: &mut Ui, text: &str, button: Option<(&str, String)>) -> bool {
    let mut pressed = false;
    ui.indent(text, |ui| {
        theme::sentence_label(ui, text);
        if let Some((name, change)) = button {
            ui.horizontal_wrapped(|ui| {
                pressed = ui.button(name).explained(&change).clicked();
                ui.label(RichText::new(change).small().weak());
            });
        }
    });
    pressed
}
