//! Hidden surfaces: the image painted so far, triangle by triangle, by each hidden-surface algorithm, and the faces
//! that are turned away.

use eframe::egui::{RichText, Slider, Ui};

use crate::appearance::Visibility;
use crate::figure::{Depth, Reveal};
use crate::gui::kit::{Explained, alternatives, theme};
use crate::gui::why::state::explain::Explain;
use camera_lab_desk::Model;
use camera_lab_words::why::stages;

/// Shows it.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let t = stages::texts(model.settings.lang);
    ui.label(RichText::new(t.hint).weak());
    if !model.layout.is_shown(crate::views::View::Image) {
        ui.label(t.hidden);
    }
    let figure = model.desk.shown.figure();
    let (mut style, mut reveal) = (figure.style, figure.reveal);
    ui.horizontal_wrapped(|ui| {
        let all = [
            (Visibility::Painter, t.painter, t.painter_hint),
            (Visibility::Bsp, t.bsp, t.bsp_hint),
            (Visibility::DepthBuffer, t.depth_buffer, t.depth_buffer_hint),
        ];
        alternatives(ui, &mut style.visibility, all);
    });
    ui.label(match style.visibility {
        Visibility::Painter => t.painter_said,
        Visibility::Bsp => t.bsp_said,
        Visibility::DepthBuffer => t.depth_buffer_said,
    });
    scrubber(ui, t, model);
    let mut depth = reveal.depth == Depth::Stored;
    if ui.checkbox(&mut depth, t.depth).explained(t.depth_hint).changed() {
        reveal = Reveal { depth: if depth { Depth::Stored } else { Depth::Off }, ..reveal };
    }
    super::compare_button(ui, model);
    let words = camera_lab_words::window::texts(model.settings.lang);
    ui.checkbox(&mut reveal.culled, words.culled_view).explained(words.culled_view_hint);
    model.desk.shown.set(|figure| &mut figure.style, style);
    model.desk.shown.set(|figure| &mut figure.reveal, reveal);
}

/// From nothing to the whole image. The arrow keys move the slider.
fn scrubber(ui: &mut Ui, t: &stages::Texts, model: &mut Model) {
    let old = model.painted_share().unwrap_or(1.0);
    let mut share = old;
    ui.horizontal(|ui| {
        for (sign, name, to) in
            [("|◀", t.nothing, 0.0), ("◀", t.fewer, share - STEP), ("▶", t.more, share + STEP), ("▶|", t.all, 1.0)]
        {
            if ui.button(sign).explained(name).accessible_name(name).clicked() {
                share = to;
            }
        }
    });
    ui.scope(|ui| {
        theme::strengthen_rail(ui);
        ui.spacing_mut().slider_width = (ui.available_width() - 16.0).max(80.0);
        let slider = Slider::new(&mut share, 0.0..=1.0).show_value(false).smart_aim(false);
        ui.add(slider).explained(t.scrubber).accessible_name(t.scrubber);
    });
    if old.to_bits() != share.to_bits() {
        model.paint_share(share);
        ui.ctx().request_repaint();
    }
}

/// The share of the triangles that a button adds or removes.
const STEP: f64 = 1.0 / 24.0;
