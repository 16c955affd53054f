//! Interaction with the pictures by keys and by a pointer without a drag. Drags are in `held`.

use eframe::egui::{self, Event, EventFilter, Key, Modifiers, PointerButton, Ui, Vec2};
use glam::DVec2;

use super::held::{GIZMO_REACH, gizmo_lines, tell};
use super::keyboard_probe::{ProbeStep, Probing, pixel_of};
use super::picking::{self, PickQuery, PickRequest};
use super::probe_steps::Click;
use super::{camera_drag, followed, handle_drag};
use crate::camera::{Convention, Operation};
use crate::geometry::Angle;
use crate::gui::views::arrange::orbit;
use crate::gui::views::labels::label_drag::arrow_of;
use crate::gui::views::status::Status;
use crate::gui::views::{Canvas, Pane, readout, toggle_maximized};
use crate::sanitize::escaped;
use crate::views::handles::handle_at;
use crate::views::transform_gizmo::part_at;
use crate::views::{Handle, Hover, Probe, Request, Transforming, View, camera_at, pick};
use camera_lab_desk::{Model, ObserverChange, Placing};
use camera_lab_words::window::cameras;
use camera_lab_words::window::canvas::CanvasTexts;

/// Logarithm of the zoom for one point of the wheel.
const ZOOM_PER_POINT: f64 = 0.004;

/// Degrees for one press of an arrow key.
const STEP: f64 = 5.0;

/// Zoom or dolly for one press of a key.
const STEP_FACTOR: f64 = 1.1;

impl Canvas {
    /// Handles pointer and keys. Returns the status lines.
    pub(in crate::gui::views) fn interact(
        &mut self,
        ui: &Ui,
        model: &mut Model,
        placing: &mut Option<Placing>,
        panes: &[Pane],
        texts: &'static CanvasTexts,
    ) -> Status {
        let mut status = Status::default();
        if !panes.iter().any(|pane| self.drag.as_ref().is_some_and(|(picture, _)| *picture == pane.picture)) {
            self.drag = None;
        }
        let escape = self.drag.is_none() && ui.input(|i| i.key_pressed(Key::Escape));
        if escape && model.label_mode.on {
            // A field that the user types in gives the key up first.
            if !model.label_mode.is_typing {
                model.label_mode.step_back();
            }
        } else if escape && model.photograph.on {
            if !ui.ctx().text_edit_focused() {
                model.photograph.step_back();
            }
        } else if escape {
            // One thing after the other.
            if model.pinned().is_none() && !self.is_probing() && model.release_shown() {
                ui.request_repaint();
            }
            model.pin(None);
            self.stop_probing();
        }
        let mut hovered = None;
        self.hover_pick = None;
        self.hover.hovered = None;
        for pane in panes {
            self.focus(ui, model, placing, pane);
            if Self::place(ui, pane, placing.as_mut()) {
                continue;
            }
            if !self.fingers(ui, model, pane) {
                self.drag(ui, model, pane);
                self.wheel(ui, model, pane);
            }
            if self.drag.is_none() && pane.response.hovered() && !ui.input(|i| i.pointer.any_down()) {
                hovered = self.hover(ui, model, pane, &mut status, texts);
                if let Some((probe, place)) = hovered.zip(pane.response.hover_pos()) {
                    self.probed_side = pane.side_index(place).map(|side| (probe, side));
                }
            }
            self.click(model, pane, hovered);
            if status.message.is_empty() && pane.response.has_focus() {
                keys_hint(pane.view, texts).clone_into(&mut status.message);
            }
        }
        if self.drag.is_some() {
            self.say_drag(ui, model, &mut status, texts);
        }
        if status.message.is_empty()
            && let Some(why) = model.impossible_side()
        {
            (status.message, status.warning) = (why, true);
        }
        if status.message.is_empty() {
            let is_there = |view| panes.iter().any(|pane| pane.view == view);
            let idle = match (is_there(View::World), is_there(View::Canonical)) {
                (true, _) => texts.idle,
                (false, true) => texts.idle_canonical,
                (false, false) => texts.pointer_in_image,
            };
            idle.clone_into(&mut status.message);
        }
        self.hover.probe = hovered;
        status
    }

    fn click(&mut self, model: &mut Model, pane: &Pane, hovered: Option<Probe>) {
        let response = &pane.response;
        if model.label_mode.on {
            self.label_click(model, pane);
            return;
        }
        if response.double_clicked_by(PointerButton::Primary) {
            self.stop_probing();
            model.pin(self.pinned_before);
            toggle_maximized(model, pane.view);
            response.ctx.request_repaint();
        } else if response.clicked_by(PointerButton::Primary)
            && response.hovered()
            && self.hover.hovered.is_none()
            && looks_through_clicked(model, pane)
        {
            response.ctx.request_repaint();
        } else if response.clicked_by(PointerButton::Primary) && response.hovered() {
            self.pinned_before = model.pinned();
            self.stop_probing();
            let unanswered = self.hover_pick.take().filter(|pick| hovered.is_none() && pick.is_heavy());
            match unanswered.filter(|pick| self.picker.found(&response.ctx, pick).is_none()) {
                // It's pinned when it's found.
                Some(pick) => self.clicked_pick = Some(pick),
                None => model.pin(hovered),
            }
            self.clicked = Click::in_picture(model, pane);
        }
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
    }

    fn wheel(&mut self, ui: &Ui, model: &mut Model, pane: &Pane) {
        if !pane.response.hovered() {
            return;
        }
        let (wheel, pinch) = ui.input(|i| (f64::from(i.smooth_scroll_delta().y), f64::from(i.zoom_delta())));
        let factor = (wheel * ZOOM_PER_POINT).exp() * pinch;
        if pane.view == View::Image {
            let is_own = pane.response.hover_pos().is_some_and(|place| pane.is_own(place));
            if factor != 1.0 && is_own {
                let dolly = camera_drag::dollied(model.desk.shown.camera(), factor);
                model.operate(dolly);
            }
            return;
        }
        if factor != 1.0
            && let Some(pointer) = pane.response.hover_pos()
            && let Some(seen) = self.seen(pane.picture)
        {
            let at = pane.rect.pixel(pointer);
            let observer = orbit::zoomed_at(seen, factor, at, pane.rect.size);
            self.turn(model, pane.picture, observer);
        }
    }

    // The pointer, not held.

    /// Marks the target of the pointer and reports it.
    fn hover(
        &mut self,
        ui: &Ui,
        model: &Model,
        pane: &Pane,
        status: &mut Status,
        texts: &'static CanvasTexts,
    ) -> Option<Probe> {
        let place = pane.response.hover_pos()?;
        let (ref request, pointer) = pane.under(place);
        let is_own = pane.is_own(place);
        let (camera, digits) = (model.desk.shown.camera(), model.settings.digits.min(6));
        status.aside = format!("{} × {} px", pane.rect.size.width, pane.rect.size.height);
        if model.label_mode.on {
            self.label_hover(ui, model, pane, place, status);
            return None;
        }
        if pane.view == View::World
            && is_own
            && let Some(handle) = handle_at(request, pointer, pane.rect.pixels(handle_drag::REACH))
        {
            let asked = &model.frame.asked;
            let lines = [
                handle_drag::readout(handle, camera, digits, (asked, texts)),
                handle_drag::hint(handle, camera, digits, texts),
            ];
            tell(ui, status, &lines, handle_drag::cursor(false));
            self.hover.hovered = Some(handle);
            return probed(handle, model);
        }
        if pane.view == View::World
            && is_own
            && let Some(part) = part_at(request, pointer, pane.rect.pixels(GIZMO_REACH))
        {
            tell(ui, status, &gizmo_lines(model, digits), handle_drag::cursor(false));
            if let Some(gizmo) = &mut self.hover.gizmo {
                gizmo.hovered = Some(part);
            }
            return None;
        }
        if let Some((p, lines)) = followed::hovered(request, pointer, pane, model) {
            tell(ui, status, &lines, handle_drag::cursor(false));
            return Some(Probe::Point(p));
        }
        if is_own && let Some(index) = camera_under(request, pointer, pane) {
            tell(ui, status, &camera_lines(index, model), egui::CursorIcon::PointingHand);
            return None;
        }
        status.message = match pane.view {
            View::Image => match pick::window_point_in_image(request, pointer) {
                Some(point) => {
                    let image = request.shot.look.image;
                    let pixel = readout::pair(pixel_of(image, &request.camera, point), 17, texts.lang.mark());
                    let point = readout::pair(point, 4, texts.lang.mark());
                    format!(
                        "{} {} {pixel} / {} × {} · {} {point} · {}",
                        texts.pointer,
                        texts.space_pixel,
                        image.width,
                        image.height,
                        texts.space_window,
                        texts.pointer_in_image
                    )
                }
                None => texts.pointer_in_image.to_owned(),
            },
            View::World | View::Canonical => texts.pointer_in_space.to_owned(),
        };
        if pane.view == View::Canonical && model.is_on_the_way() {
            return None;
        }
        let what = PickQuery::Under { pointer, reach: pane.rect.pixels(picking::REACH) };
        let request = Request { hover: Hover::default(), ..request.clone() };
        let pick = PickRequest { request, what };
        self.hover_pick = Some(pick.clone());
        self.picker.ask(ui.ctx(), pick).probe
    }

    // The keys.

    /// Keeps the arrow keys in a picture that has the focus, and lets the keys act.
    fn focus(&mut self, ui: &Ui, model: &mut Model, placing: &mut Option<Placing>, pane: &Pane) {
        if !pane.response.has_focus() {
            return;
        }
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, tab: false, escape: true };
        ui.memory_mut(|m| m.set_focus_lock_filter(pane.response.id, filter));
        let pressed: Vec<(Key, Modifiers)> = ui.input(|i| {
            let key = |event: &Event| match event {
                Event::Key { key, pressed: true, modifiers, .. } if !modifiers.command && !modifiers.alt => {
                    Some((*key, *modifiers))
                }
                _ => None,
            };
            i.events.iter().filter_map(key).collect()
        });
        for (key, modifiers) in pressed {
            if !Self::place_by_key(placing.as_mut(), pane, key, modifiers)
                && !self.label_by_key(model, pane, key, modifiers)
                && !self.probe_by_key(model, pane, key, modifiers)
            {
                self.key(model, pane, key, modifiers);
            }
            ui.request_repaint();
        }
    }

    /// Lets the keys move the probe in probing mode. Returns true if this key did.
    fn probe_by_key(&mut self, model: &mut Model, pane: &Pane, key: Key, modifiers: Modifiers) -> bool {
        let step = |probing, arrow| ProbeStep { probing, from: None, arrow, fast: modifiers.shift };
        if let Some(asked) = Probing::asked(key, pane.view) {
            // The same key ends it.
            let is_on = self.probing == Some((pane.picture, asked));
            self.probing = (!is_on).then_some((pane.picture, asked));
            self.probe_steps.clear();
            if is_on {
                model.pin(None);
            } else {
                self.probe_steps.push_back((pane.picture, step(asked, DVec2::ZERO)));
            }
            return true;
        }
        let arrow = arrow_of(key);
        let probing = self.probing.filter(|(picture, _)| *picture == pane.picture && arrow != DVec2::ZERO);
        self.probe_steps.extend(probing.map(|(picture, probing)| (picture, step(probing, arrow))));
        probing.is_some()
    }

    fn key(&mut self, model: &mut Model, pane: &Pane, key: Key, modifiers: Modifiers) {
        let (picture, view) = (pane.picture, pane.view);
        let arrow = arrow_of(key);
        match (key, view) {
            (Key::Plus | Key::Equals | Key::Minus, _) => {
                let factor = if key == Key::Minus { STEP_FACTOR.recip() } else { STEP_FACTOR };
                if view == View::Image {
                    model.operate(Operation::Zoom(factor));
                } else if let Some(seen) = self.seen(picture) {
                    self.turn(model, picture, seen.zoom(factor));
                }
            }
            (Key::Home, View::World | View::Canonical) => self.asked = Some((picture, ObserverChange::Fit)),
            (Key::PageUp, View::World | View::Image) => model.operate(Operation::Dolly(STEP_FACTOR)),
            (Key::PageDown, View::World | View::Image) => {
                model.operate(Operation::Dolly(STEP_FACTOR.recip()));
            }
            (Key::T, View::World) => model.tree.transforming = Transforming::Move,
            (Key::R, View::World) => model.tree.transforming = Transforming::Turn,
            (Key::S, View::World) => model.tree.transforming = Transforming::Scale,
            _ if arrow != DVec2::ZERO => self.arrow(model, pane, arrow, modifiers),
            _ => {}
        }
    }

    /// Turns the camera about PF as the eye expects: up raises it, right moves it to the right. By the right-hand rule
    /// a positive elevation lowers it, but by the signs of VTK it raises it. In the canonical volume, and with Shift in
    /// the world, the observer turns instead.
    fn arrow(&mut self, model: &mut Model, pane: &Pane, arrow: DVec2, modifiers: Modifiers) {
        let view = pane.view;
        if view == View::Canonical || (view == View::World && modifiers.shift) {
            let step = STEP / orbit::DEGREES_PER_POINT;
            #[expect(clippy::cast_possible_truncation, reason = "a few steps")]
            let motion = Vec2::new(-(arrow.x * step) as f32, (arrow.y * step) as f32);
            for other in self.turning_with(pane.picture, model) {
                if let Some(seen) = self.seen(other) {
                    self.turn(model, other, orbit::orbited(seen, motion));
                }
            }
            return;
        }
        if arrow.y != 0.0 {
            let raised = match model.operations.convention {
                Convention::RightHand => -STEP,
                Convention::Vtk => STEP,
            };
            model.operate(Operation::Elevation(Angle::from_degrees(raised * arrow.y)));
        }
        if arrow.x != 0.0 {
            model.operate(Operation::Azimuth(Angle::from_degrees(STEP * arrow.x)));
        }
    }
}

/// C and PF are points of the world, so the user can probe them.
fn probed(handle: Handle, model: &Model) -> Option<Probe> {
    let camera = model.desk.shown.camera();
    match handle {
        Handle::FocalPoint => Some(Probe::Point(camera.focal_point())),
        Handle::Position | Handle::ViewUp | Handle::Near | Handle::Far => None,
    }
}

fn keys_hint(view: View, texts: &CanvasTexts) -> &'static str {
    match view {
        View::World => texts.keys_in_world,
        View::Canonical => texts.keys_in_canonical,
        View::Image => texts.keys_in_image,
    }
}

impl Canvas {
    /// Lets two fingers move and zoom a three-dimensional picture. True while they are on it. Takes back the action
    /// that the first finger had begun before the second came, because it wasn't meant.
    pub(in crate::gui::views) fn fingers(&mut self, ui: &Ui, model: &mut Model, pane: &Pane) -> bool {
        let touch = ui.input(|input| input.multi_touch());
        let Some(touch) = touch.filter(|touch| pane.rect.rect.contains(touch.start_pos)) else { return false };
        if self.drag.is_some() {
            self.give_up(model);
        }
        let moved = pane.rect.pixel(touch.center_pos) - pane.rect.pixel(touch.center_pos - touch.translation_delta);
        if pane.view != View::Image
            && let Some(seen) = self.seen(pane.picture)
        {
            let at = pane.rect.pixel(touch.center_pos);
            let moved = seen.pan(moved.x, moved.y, pane.rect.size.smaller_side());
            let observer = orbit::zoomed_at(moved, f64::from(touch.zoom_delta), at, pane.rect.size);
            if observer != seen {
                self.turn(model, pane.picture, observer);
            }
        }
        true
    }
}

/// The place in the list of the camera at the pointer (pixels).
fn camera_under(request: &Request, pointer: DVec2, pane: &Pane) -> Option<usize> {
    let reach = pane.rect.pixels(handle_drag::REACH);
    camera_at(request, pointer, reach).filter(|_| pane.view == View::World)
}

/// Its name, and the effect of a click.
fn camera_lines(index: usize, model: &Model) -> [String; 2] {
    let name = model.desk.shown.figure().cameras.get(index).map_or("", |other| &other.name);
    [escaped(name), cameras::texts(model.settings.lang).click.to_owned()]
}

/// Looks through the clicked camera. Returns false if there is none.
fn looks_through_clicked(model: &mut Model, pane: &Pane) -> bool {
    let Some(place) = pane.response.interact_pointer_pos().filter(|place| pane.is_own(*place)) else { return false };
    let (request, pointer) = pane.under(place);
    let Some(index) = camera_under(&request, pointer, pane) else { return false };
    model.look_through(index);
    true
}
