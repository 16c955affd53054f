//! The card of the tool: the mark to draw, and the resulting camera, step by step.

use eframe::egui::{self, Button, Id, RichText, ScrollArea, Ui, Window, vec2};

use crate::camera::{Camera, Doubt, PhotographCamera, PhotographError, WorldAxis};
use crate::gui::kit::{Explained, NumberField, Step, theme};
use crate::gui::views::{Canvas, Pane};
use camera_lab_desk::{Drawn, Model};
use camera_lab_words::why::photograph as steps;
use camera_lab_words::window::photograph::Texts;
use camera_lab_words::window::{self, photograph as words};

/// The width of the card.
const WIDTH: f32 = 286.0;

impl Canvas {
    /// Shows the card while the tool is open. The user can move it.
    pub(in crate::gui::views) fn photograph_card(ui: &Ui, model: &mut Model, panes: &[Pane]) {
        let room = panes.iter().map(|pane| pane.rect.rect).reduce(|a, b| a.union(b));
        let Some(room) = room.filter(|_| model.photograph.on) else { return };
        let t = words::texts(model.settings.lang);
        let whole = ui.ctx().content_rect();
        let card = Window::new(t.title).id(Id::unique("card of the photograph")).constrain_to(whole).resizable(false);
        // Beside the pictures, over the panel there, because all of the photograph has to be visible.
        let card = card.default_width(WIDTH).default_pos(room.right_top() + vec2(8.0, 0.0));
        card.collapsible(false).show(ui.ctx(), |ui| {
            ui.set_width(WIDTH);
            drawn(ui, model, t);
            ui.separator();
            let given = *model.desk.shown.camera().parameters();
            let found = model.photograph.camera(model.desk.shown.figure().image, &given);
            let scroll = ScrollArea::vertical().max_height((room.height() - 230.0).max(80.0));
            scroll.show(ui, |ui| match &found {
                Ok(found) => account(ui, model, found),
                Err(error) => {
                    let reason = format!("⚠ {}", steps::error(model.settings.lang, error));
                    ui.add(egui::Label::new(RichText::new(reason).weak()).wrap());
                }
            });
            middle(ui, model, t, &found);
            ui.horizontal_wrapped(|ui| {
                let take = ui.add_enabled(found.is_ok(), Button::new(t.take)).explained(t.take_hint);
                if let Ok(found) = found
                    && take.clicked()
                {
                    use_camera(model, &found);
                }
                let is_empty = model.photograph.grips().is_empty();
                if ui.add_enabled(!is_empty, Button::new(t.clear)).clicked() {
                    model.photograph.clear();
                }
                if ui.button(window::texts(t.lang).close).clicked() {
                    model.photograph.step_back();
                }
            });
        });
    }
}

/// The kind of mark that the next drag draws, and the coordinate of the known length.
fn drawn(ui: &mut Ui, model: &mut Model, t: &Texts) {
    let lang = model.settings.lang;
    ui.add(egui::Label::new(RichText::new(t.how).small()).wrap());
    if model.desk.shown.figure().compare.as_ref().is_some_and(|comparison| comparison.beside) {
        ui.colored_label(ui.visuals().warn_fg_color, t.beside);
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(t.draw);
        for drawn in Drawn::ALL {
            let (text, name, hint) = match drawn {
                Drawn::Line(axis) => (axis.name(), format!("{} {}", t.line, axis.name()), t.line_hint),
                Drawn::Origin => (t.origin, t.origin.to_owned(), t.origin_hint),
                Drawn::Length => (t.known, t.known.to_owned(), t.known_hint),
            };
            let button = ui.add(Button::new(text).selected(model.photograph.drawn == drawn)).explained(hint);
            if button.accessible_name(name).clicked() {
                model.photograph.drawn = drawn;
            }
        }
    });
    if model.photograph.drawn == Drawn::Length || model.photograph.marks.length.is_some() {
        length(ui, model, t);
    }
    ui.checkbox(&mut model.photograph.has_scene, t.with_scene).explained(t.with_scene_hint);
    let of = |axis| model.photograph.marks.lines.iter().filter(|line| line.axis == axis).count();
    ui.label(RichText::new(words::counts(lang, WorldAxis::ALL.map(of))).small().weak());
}

/// The axis and the coordinate of the point of the length.
fn length(ui: &mut Ui, model: &mut Model, t: &Texts) {
    let (mut axis, mut coordinate) = model.photograph.length;
    ui.horizontal(|ui| {
        for one in WorldAxis::ALL {
            let button = ui.selectable_label(axis == one, one.name());
            if button.explained(t.along).accessible_name(format!("{}: {}", t.along, one.name())).clicked() {
                axis = one;
            }
        }
        ui.label("=");
        let field = NumberField::new(t.coordinate, Step::Multiply(1.1)).hint(t.known_hint).width(92.0);
        let before = coordinate;
        field.show(ui, window::texts(model.settings.lang), &mut coordinate);
        // 0 is the origin.
        if coordinate == 0.0 {
            coordinate = before;
        }
    });
    model.photograph.length = (axis, coordinate);
    if let Some((_, at, _)) = model.photograph.marks.length {
        model.photograph.marks.length = Some((axis, at, coordinate));
    }
}

/// The buttons that take the middle of the lens which the lines give, and that of the image again.
fn middle(ui: &mut Ui, model: &mut Model, t: &Texts, found: &Result<PhotographCamera, PhotographError>) {
    let doubts = match found {
        Ok(found) => found.doubts.as_slice(),
        Err(PhotographError::OffMiddle(doubt)) => std::slice::from_ref(doubt),
        Err(_) => &[],
    };
    for doubt in doubts {
        if let Doubt::Middle { pixel, .. } = doubt
            && ui.button(t.middle).explained(t.middle_hint).clicked()
        {
            model.photograph.marks.middle = Some(*pixel);
        }
    }
    if model.photograph.marks.middle.is_some() && ui.button(t.middle_of_image).clicked() {
        model.photograph.marks.middle = None;
    }
}

/// The arithmetic, as the command line prints it, and the values that the photograph doesn't give.
fn account(ui: &mut Ui, model: &Model, found: &PhotographCamera) {
    let lang = model.settings.lang;
    for (number, step) in steps::steps(lang, found).iter().enumerate() {
        theme::sentence_label(ui, &format!("{}. {step}", number + 1));
    }
    let untold = found.untold.iter().map(|untold| steps::untold(lang, *untold).to_owned());
    for text in untold.chain(steps::doubts(lang, found)) {
        let text = RichText::new(format!("⚠ {text}")).color(ui.visuals().warn_fg_color);
        ui.add(egui::Label::new(text).wrap());
    }
}

/// Makes it the camera of the figure, as one step of undo.
fn use_camera(model: &mut Model, found: &PhotographCamera) {
    match Camera::new(&found.parameters) {
        Ok(camera) => {
            model.desk.commit();
            model.desk.shown.set_camera(camera);
            // Whether it fits shows when the scene lies on the photograph.
            model.photograph.has_scene = true;
        }
        Err(error) => model.say_camera_error(Err(error)),
    }
}
