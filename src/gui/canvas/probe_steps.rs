//! Searches that take a while in a heavy scene, and pin their results: steps of the keys, and clicks.

use eframe::egui::Context;
use glam::DVec2;

use super::keyboard_probe::ProbeStep;
use super::picking::{PickQuery, PickRequest};
use super::{Canvas, Pane};
use crate::gui::state::State;
use crate::views::{Hover, Request, View};

impl Canvas {
    /// True while the keys move the probe, or it is on its way.
    pub(super) fn is_probing(&self) -> bool {
        self.probing.is_some() || !self.probe_steps.is_empty() || self.clicked_pick.is_some()
    }

    /// Ends the probing by keys, with the steps that have not been taken yet.
    pub(super) fn stop_probing(&mut self) {
        self.probing = None;
        self.probe_steps.clear();
        self.clicked_pick = None;
    }

    /// Pins the result of a click in a heavy scene, once it has been found.
    pub(super) fn pin_clicked(&mut self, ctx: &Context, state: &mut State) {
        let Some(pick) = self.clicked_pick.take() else { return };
        match self.picker.found(ctx, &pick) {
            Some(found) => {
                state.pin(found.probe);
                ctx.request_repaint();
            }
            None if self.picker.is_waiting() => self.clicked_pick = Some(pick),
            None => {}
        }
    }

    /// Takes the steps that keys have asked for, one from where the other has led. In a heavy scene they take a while,
    /// beside the window's thread.
    pub(super) fn take_probe_steps(&mut self, ctx: &Context, state: &mut State, panes: &[Pane]) {
        while let Some((picture, step)) = self.probe_steps.front().copied() {
            let is_there =
                |pane: &&Pane| pane.picture == picture && !(pane.view == View::Canonical && state.is_on_the_way());
            if let Some(pane) = panes.iter().find(is_there) {
                let step = ProbeStep { from: state.pinned().filter(|_| step.arrow != DVec2::ZERO), ..step };
                // The step does not depend on what is pinned but for `from`: a pin does not ask anew.
                let request = pane.request.clone().with_shot(|shot| shot.show.probe = None);
                let request = Request { hover: Hover::default(), ..request };
                let pick = PickRequest { request, what: PickQuery::Step(step) };
                match self.key_picker.found(ctx, &pick) {
                    Some(found) => {
                        if found.probe.is_some() {
                            state.pin(found.probe);
                        }
                        ctx.request_repaint();
                    }
                    None if self.key_picker.is_waiting() => return,
                    // The search has panicked: there is no answer to wait for.
                    None => {}
                }
            }
            self.probe_steps.pop_front();
        }
    }
}
