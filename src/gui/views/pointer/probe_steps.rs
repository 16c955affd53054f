//! Searches that take a while in a heavy scene, and the use of their results. Steps of the keys are pinned, and so are
//! clicks, which also select an object or choose a triangle.

use eframe::egui::Context;
use glam::DVec2;

use super::keyboard_probe::ProbeStep;
use super::picking::{PickQuery, PickRequest};
use crate::figure::Explanation;
use crate::gui::views::{Canvas, Inputs, Pane};
use crate::views::{Hover, Request, View};
use camera_lab_desk::{Model, Selected, Side, Tab};

/// A click on an object or on a triangle.
pub(in crate::gui::views) struct Click {
    pick: PickRequest,
    pointer: DVec2,
    /// True if the object is added to the selection.
    beside: bool,
}

/// True if clicks select, because the tree of the scene is open.
fn selects(model: &Model) -> bool {
    model.settings.tab == Tab::Scene && model.settings.panels().is_shown(Side::Left)
}

impl Click {
    /// The click that a picture has received, if it selects or chooses anything: objects while the tree of the scene is
    /// open, triangles of the image while one is explained.
    pub(in crate::gui::views) fn in_picture(model: &Model, pane: &Pane) -> Option<Self> {
        let object = selects(model) && (pane.view != View::Canonical || !model.is_on_the_way());
        let triangle = model.shows_explanation(Explanation::Triangle) && pane.view == View::Image;
        let place = pane.response.interact_pointer_pos().filter(|_| object || triangle)?;
        let (request, pointer) = pane.under(place);
        let request = Request { hover: Hover::default(), ..request };
        let pick = PickRequest { request, what: PickQuery::Click { pointer, object, triangle } };
        Some(Self { pick, pointer, beside: pane.response.ctx.input(|i| i.modifiers.command) })
    }
}

impl Canvas {
    /// True while the keys move the probe, or it's on its way.
    pub(in crate::gui::views) fn is_probing(&self) -> bool {
        self.probing.is_some() || !self.probe_steps.is_empty() || self.clicked_pick.is_some() || self.clicked.is_some()
    }

    /// Ends the probing by keys, with the steps that have not been taken yet.
    pub(in crate::gui::views) fn stop_probing(&mut self) {
        self.probing = None;
        self.probe_steps.clear();
        (self.clicked_pick, self.clicked) = (None, None);
    }

    /// Selects the object and chooses the triangle of a click, once they have been found.
    pub(in crate::gui::views) fn take_click(&mut self, ctx: &Context, model: &mut Model, inputs: &mut Inputs<'_>) {
        let Some(click) = self.clicked.take() else { return };
        // A pixel of the followed triangle, or another triangle?
        let waits = model.shows_explanation(Explanation::Triangle) && inputs.triangle_waits;
        let Some(found) = self.click_picker.found(ctx, &click.pick).filter(|_| !waits) else {
            self.clicked = Some(click).filter(|_| waits || self.click_picker.is_waiting());
            return;
        };
        let Click { pick: PickRequest { request, .. }, pointer, beside } = click;
        let scene = &model.desk.shown.figure().scene;
        let selected = found.object.filter(|_| selects(model)).and_then(|name| Selected::of_object(scene, &name));
        if selected.is_some() {
            model.select(selected, beside);
            ctx.request_repaint();
        }
        let is_of_image = request.view == View::Image && model.shows_explanation(Explanation::Triangle);
        if is_of_image && (inputs.on_triangle)(ctx, model, &request, pointer, found.triangle) {
            // It's the intended one.
            self.clicked_pick = None;
            model.pin(None);
            ctx.request_repaint();
        }
    }

    /// Pins the result of a click in a heavy scene, once it's found.
    pub(in crate::gui::views) fn pin_clicked(&mut self, ctx: &Context, model: &mut Model) {
        let Some(pick) = self.clicked_pick.take() else { return };
        match self.picker.found(ctx, &pick) {
            Some(found) => {
                model.pin(found.probe);
                ctx.request_repaint();
            }
            None if self.picker.is_waiting() => self.clicked_pick = Some(pick),
            None => {}
        }
    }

    /// Takes the steps requested by keys, each from the result of the one before. In a heavy scene they take a while,
    /// beside the window's thread.
    pub(in crate::gui::views) fn take_probe_steps(&mut self, ctx: &Context, model: &mut Model, panes: &[Pane]) {
        while let Some((picture, step)) = self.probe_steps.front().copied() {
            let is_there =
                |pane: &&Pane| pane.picture == picture && !(pane.view == View::Canonical && model.is_on_the_way());
            if let Some(pane) = panes.iter().find(is_there) {
                let step = ProbeStep { from: model.pinned().filter(|_| step.arrow != DVec2::ZERO), ..step };
                // Except for `from`, the step doesn't depend on the pinned probe, so a pin doesn't start a new request.
                let request = pane.request.clone().with_shot(|shot| shot.show.probe = None);
                let request = Request { hover: Hover::default(), ..request };
                let pick = PickRequest { request, what: PickQuery::Step(step) };
                match self.key_picker.found(ctx, &pick) {
                    Some(found) => {
                        if found.probe.is_some() {
                            model.pin(found.probe);
                        }
                        ctx.request_repaint();
                    }
                    None if self.key_picker.is_waiting() => return,
                    // The search has panicked, so there is no answer to wait for.
                    None => {}
                }
            }
            self.probe_steps.pop_front();
        }
    }
}
