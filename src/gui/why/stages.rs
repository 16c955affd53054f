//! A stage of the pipeline in full: its purpose, its report, its source. The strip under the views has all of them.

use eframe::egui::{Color32, RichText, Ui};

use crate::appearance::{FaceOrder, Rgba};
use crate::figure::CostReveal;
use crate::gui::kit::{Explained, choice_row};
use crate::gui::why::state::explain::Explain;
use crate::views::{Probe, Request, View};
use camera_lab_desk::Model;
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::why::{pipeline, stages};

/// Shows the stage that the strip has put into the view.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let t = stages::texts(model.settings.lang);
    shown(ui, t, model);
    ui.separator();
    costs(ui, t, model);
    ui.separator();
    ui.checkbox(&mut model.layout.strip, t.strip).explained(t.strip_hint);
}

/// The displayed stage: its name, its purpose, and its report, or the reason why it was left out.
fn shown(ui: &mut Ui, t: &stages::Texts, model: &Model) {
    let Some(stage) = model.shown_stage() else {
        ui.label(RichText::new(t.none_shown).weak());
        return;
    };
    let lang = model.settings.lang;
    ui.label(RichText::new(format!("{}: {}", t.shown, pipeline::stage(lang, stage))).strong());
    ui.label(with_titles(pipeline::purpose(lang, stage)));
    if let Some(report) = model.frame.reports.iter().find(|report| report.stage == stage) {
        ui.label(pipeline::line(lang, report));
        if report.ran {
            ui.label(RichText::new(stages::in_and_out(t, stage)).weak());
        }
    }
    source(ui, t, stage);
}

/// The cost of the pixels: the tint of the image, the needless fills, and the faces at the pixel of the probe.
fn costs(ui: &mut Ui, t: &stages::Texts, model: &mut Model) {
    let lang = model.settings.lang;
    let labels = camera_lab_words::pictures::labels(lang);
    let figure = model.desk.shown.figure();
    let (mut cost, mut order) = (figure.reveal.cost, figure.style.order);
    let kinds = std::iter::once(None).chain(CostReveal::NAMED.iter().map(|(_, kind)| Some(*kind)));
    let kinds: Vec<_> = kinds.zip(labels.costs).collect();
    choice_row(ui, t.costs, t.costs_hint, &mut cost, &kinds);
    model.desk.shown.set(|figure| &mut figure.reveal.cost, cost);
    let orders: Vec<_> = FaceOrder::NAMED.iter().map(|(_, order)| *order).zip(labels.face_orders).collect();
    choice_row(ui, t.order, t.order_hint, &mut order, &orders);
    model.desk.shown.set(|figure| &mut figure.style.order, order);
    let Some(request) = &model.frame.explained else { return };
    let Some(costs) = model.costs.known(request) else {
        // They're counted beside the window's thread.
        ui.label("…");
        ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
        return;
    };
    ui.label(pipeline::needless(lang, costs));
    if request.view != View::Image {
        return;
    }
    let Some(pixel) = model.frame.probe.and_then(|probe| pixel_of(request, probe)) else {
        ui.label(RichText::new(t.point_there).weak());
        return;
    };
    let faces = costs.faces_at(pixel);
    ui.label(if faces.is_empty() { t.no_faces } else { t.at_pixel });
    for (place, face) in (1..).zip(&faces) {
        ui.horizontal_wrapped(|ui| {
            if let Some(Rgba { r, g, b, .. }) = face.color {
                ui.label(RichText::new("■").color(Color32::from_rgb(r, g, b)));
            }
            ui.label(format!("{place}. {}", pipeline::face(lang, face)));
        });
    }
}

/// The pixel of an image in which a probe lies.
fn pixel_of(request: &Request, probe: Probe) -> Option<[u32; 2]> {
    let camera = &request.camera;
    let look = &request.shot.look;
    let place = match probe {
        Probe::Window(place) => place,
        Probe::Point(p) => {
            let space = camera.possible_clip_space(request.shot.ndc);
            space.stations(p, look.image, &look.viewport).projected?.window
        }
    };
    let (window, frame) = (camera.window(), request.image_frame());
    let [x, y] = [
        f64::from(frame.x) + (place.x - window.left) / window.width() * f64::from(frame.width),
        f64::from(frame.y) + (window.top - place.y) / window.height() * f64::from(frame.height),
    ];
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "not negative, and beyond it saturates"
    )]
    (x >= 0.0 && y >= 0.0).then_some([x as u32, y as u32])
}

/// The source file of a stage, for readers who want to see how it works.
pub(super) fn source(ui: &mut Ui, t: &stages::Texts, stage: crate::pipeline::Stage) {
    let text = RichText::new(format!("{}: {}", t.in_the_code, stage.source())).small().weak();
    ui.label(text).explained(t.in_the_code_hint);
}
