//! What the pointer and the keys do in the pictures.

use eframe::egui::{
    CursorIcon, Event, EventFilter, Key, Modifiers, PointerButton, PopupAnchor, Pos2, RichText, TextWrapMode, Tooltip,
    Ui, Vec2,
};
use glam::DVec2;

use super::seek::What;
use super::status::Status;
use super::{Canvas, Pane, look, probe, question, setup, toggle_maximized};
use crate::camera::{Convention, Operation};
use crate::figure::Observer;
use crate::geometry::Angle;
use crate::gui::handles::{self, HandleDrag};
use crate::gui::highlight::Movable;
use crate::gui::panels::scene::Selected;
use crate::gui::state::{Look, Side, State, Tab};
use crate::i18n::canvas::CanvasTexts;
use crate::i18n::faults::camera_error;
use crate::i18n::scenes;
use crate::numbers::significant;
use crate::views::arrows::{arrow_at, pull};
use crate::views::handles::{Handle, handle_at};
use crate::views::{Probe, View, pick};

/// Logarithm of the zoom for one point of the wheel.
const ZOOM_PER_POINT: f64 = 0.004;

/// Degrees for one press of an arrow key.
const STEP: f64 = 5.0;

/// Zoom or dolly for one press of a key.
const STEP_FACTOR: f64 = 1.1;

/// How near the pointer must come to an arrow, in points.
const ARROW_REACH: f32 = 7.0;

/// What is held with the pointer.
pub(super) enum Drag {
    /// The eye of a three-dimensional picture turns.
    Orbit { picture: View, pressed: [Observer; 2] },
    /// The eye of a three-dimensional picture moves.
    Pan { picture: View, pressed: Observer },
    /// Something in the world is moved.
    Handle(Box<HandleDrag>),
    /// What is selected is moved along an axis.
    Arrow(Box<ArrowDrag>),
}

/// An arrow that is held.
pub(super) struct ArrowDrag {
    /// As it was when it was taken.
    movable: Movable,
    axis: usize,
    observer: Observer,
    from: DVec2,
}

impl Drag {
    fn picture(&self) -> View {
        match self {
            Self::Orbit { picture, .. } | Self::Pan { picture, .. } => *picture,
            Self::Handle(_) | Self::Arrow(_) => View::World,
        }
    }
}

impl Canvas {
    /// Lets pointer and keys act; the result says what is under the pictures.
    pub(super) fn act(&mut self, ui: &Ui, state: &mut State, panes: &[Pane], texts: &'static CanvasTexts) -> Status {
        let mut status = Status::default();
        if !panes.iter().any(|pane| self.drag.as_ref().is_some_and(|drag| drag.picture() == pane.picture)) {
            self.drag = None;
        }
        if self.drag.is_none() && ui.input(|i| i.key_pressed(Key::Escape)) {
            self.pinned = None;
        }
        let mut hovered = None;
        self.extras.hot = None;
        for pane in panes {
            self.focus(ui, state, pane);
            self.drag(ui, state, pane);
            self.wheel(ui, state, pane);
            if self.drag.is_none() && pane.response.hovered() && !ui.input(|i| i.pointer.any_down()) {
                hovered = self.hover(ui, state, pane, &mut status, texts);
            }
            self.click(state, pane, hovered);
            if status.message.is_empty() && pane.response.has_focus() {
                keys_hint(pane.picture, texts).clone_into(&mut status.message);
            }
        }
        if self.drag.is_some() {
            self.say_drag(ui, state, &mut status, texts);
        }
        if status.message.is_empty() {
            texts.idle.clone_into(&mut status.message);
        }
        self.extras.probe = self.pinned.or(hovered);
        status
    }

    fn click(&mut self, state: &mut State, pane: &Pane, hovered: Option<Probe>) {
        let response = &pane.response;
        if response.double_clicked_by(PointerButton::Primary) {
            self.pinned = self.pinned_before;
            toggle_maximized(state, pane.picture);
            response.ctx.request_repaint();
        } else if response.clicked_by(PointerButton::Primary) && response.hovered() {
            self.pinned_before = self.pinned;
            self.pinned = hovered;
            self.select(state, pane);
        }
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
    }

    /// While the tree of the scene is open, selects the object that was clicked.
    fn select(&self, state: &mut State, pane: &Pane) {
        let is_open = state.settings.tab == Tab::Scene && state.settings.panels().is_shown(Side::Left);
        let Some(pointer) = pane.response.interact_pointer_pos().filter(|_| is_open) else { return };
        let pointer = pane.place.pixel(pointer);
        let setup = setup(state, &self.extras, pane.place.size);
        let found = match pane.picture {
            View::World => pick::object_in_world(&setup, &self.seen[0], pointer),
            View::Image => pick::object_in_image(&setup, pointer),
            // What is seen there has been clipped and projected: it is taken in the other two.
            View::Canonical => None,
        };
        let selected = found.and_then(|name| Selected::of_object(&state.document.figure().scene, &name));
        if selected.is_some() {
            state.tree.select(selected);
            pane.response.ctx.request_repaint();
        }
    }

    // The pointer, held.

    fn drag(&mut self, ui: &Ui, state: &mut State, pane: &Pane) {
        let (origin, pointer) = ui.input(|i| (i.pointer.press_origin(), i.pointer.latest_pos()));
        if pane.response.drag_started()
            && let Some(origin) = origin
        {
            self.drag = self.taken(ui, state, pane, origin);
        }
        if self.drag.as_ref().is_none_or(|drag| drag.picture() != pane.picture) {
            return;
        }
        if ui.input(|i| i.key_pressed(Key::Escape)) {
            self.give_up(state);
            return;
        }
        if let (Some(origin), Some(pointer)) = (origin, pointer) {
            self.follow(ui, state, pane, origin, pointer);
        }
        if pane.response.drag_stopped() || !ui.input(|i| i.pointer.any_down()) {
            self.drag = None;
        }
    }

    /// What a press at `origin` takes.
    fn taken(&self, ui: &Ui, state: &State, pane: &Pane, origin: Pos2) -> Option<Drag> {
        let picture = pane.picture;
        let (modifiers, primary) = ui.input(|i| (i.modifiers, i.pointer.button_down(PointerButton::Primary)));
        if picture == View::Image {
            return None;
        }
        let from = pane.place.pixel(origin);
        if picture == View::World && primary {
            let setup = setup(state, &self.extras, pane.place.size);
            let observer = self.seen[0];
            if let Some(handle) = handle_at(&setup, &observer, from, pane.place.pixels(handles::REACH)) {
                return Some(Drag::Handle(Box::new(HandleDrag::new(handle, &setup, observer, from, modifiers))));
            }
            if let Some(movable) = Movable::selected(state)
                && let Some(axis) = arrow_at(&setup, &observer, from, pane.place.pixels(ARROW_REACH))
            {
                return Some(Drag::Arrow(Box::new(ArrowDrag { movable, axis, observer, from })));
            }
        }
        Some(if primary && !modifiers.shift {
            Drag::Orbit { picture, pressed: self.seen }
        } else {
            Drag::Pan { picture, pressed: self.seen[picture.index()] }
        })
    }

    fn follow(&mut self, ui: &Ui, state: &mut State, pane: &Pane, origin: Pos2, pointer: Pos2) {
        let motion = pointer - origin;
        match &mut self.drag {
            None => {}
            Some(Drag::Orbit { picture, pressed }) => {
                let (picture, pressed) = (*picture, *pressed);
                for other in [View::World, View::Canonical] {
                    if other == picture || state.layout.linked {
                        self.turn(state, other, look::orbited(pressed[other.index()], motion));
                    }
                }
            }
            Some(Drag::Pan { picture, pressed }) => {
                let (picture, pressed) = (*picture, *pressed);
                let motion = pane.place.pixel(pointer) - pane.place.pixel(origin);
                let height = f64::from(pane.place.size.height);
                self.turn(state, picture, pressed.pan(motion.x, motion.y, height));
            }
            Some(Drag::Handle(held)) => {
                let setup = setup(state, &self.extras, pane.place.size);
                let modifiers = ui.input(|i| i.modifiers);
                let moved = held.moved(&setup, pane.place.pixel(pointer), modifiers);
                if let Some(parameters) = moved.filter(|p| p != state.document.draft()) {
                    state.document.set_parameters(parameters);
                    ui.request_repaint();
                }
            }
            Some(Drag::Arrow(held)) => {
                let setup = setup(state, &self.extras, pane.place.size);
                let ArrowDrag { movable, axis, observer, from } = held.as_ref();
                let Some(arrows) = movable.arrows(None) else { return };
                let line = (arrows.origin, arrows.axes[*axis]);
                if let Some(way) = pull(&setup, observer, line, *from, pane.place.pixel(pointer)) {
                    let place = movable.moved(*axis, way);
                    if Movable::selected(state).is_some_and(|now| now.place != place) {
                        movable.put(&mut state.document, place);
                        ui.request_repaint();
                    }
                }
            }
        }
    }

    /// Puts back what was there before the press.
    fn give_up(&mut self, state: &mut State) {
        match self.drag.take() {
            None => {}
            Some(Drag::Orbit { pressed: [world, canonical], picture }) => {
                for (other, observer) in [(View::World, world), (View::Canonical, canonical)] {
                    if other == picture || state.layout.linked {
                        self.turn(state, other, observer);
                    }
                }
            }
            Some(Drag::Pan { picture, pressed }) => self.turn(state, picture, pressed),
            Some(Drag::Handle(held)) => state.document.set_parameters(held.before()),
            Some(Drag::Arrow(held)) => held.movable.put(&mut state.document, held.movable.place),
        }
    }

    fn say_drag(&mut self, ui: &Ui, state: &State, status: &mut Status, texts: &CanvasTexts) {
        let digits = state.settings.digits.min(6);
        match &self.drag {
            None => {}
            Some(Drag::Orbit { picture, .. }) => {
                let Observer { azimuth, elevation, .. } = self.seen[picture.index()];
                let angles = [azimuth, elevation].map(|a| significant(a, 4));
                status.message = format!("{}: {}°, {}°", texts.turning, angles[0], angles[1]);
                ui.set_cursor_icon(CursorIcon::Grabbing);
            }
            Some(Drag::Pan { .. }) => {
                texts.moving.clone_into(&mut status.message);
                ui.set_cursor_icon(CursorIcon::Move);
            }
            Some(Drag::Handle(held)) => {
                self.extras.hot = Some(held.handle());
                let camera = state.document.camera();
                let mut lines = vec![handles::readout(held.handle(), camera, digits, texts)];
                status.message = match held.stopped() {
                    Some(error) => {
                        let reason = format!("{} {}", texts.stopped, camera_error(state.settings.lang, error));
                        lines.push(reason.clone());
                        status.warning = true;
                        reason
                    }
                    None => format!("{} · {}", lines[0], handles::hint(held.handle(), camera, digits, texts)),
                };
                tooltip(ui, &lines);
                ui.set_cursor_icon(handles::cursor(true));
            }
            Some(Drag::Arrow(held)) => {
                if let Some(arrows) = &mut self.extras.arrows {
                    arrows.hot = Some(held.axis);
                }
                let lines = arrow_lines(state, digits);
                status.message = lines.join(" · ");
                tooltip(ui, &lines);
                ui.set_cursor_icon(handles::cursor(true));
            }
        }
    }

    fn wheel(&mut self, ui: &Ui, state: &mut State, pane: &Pane) {
        if pane.picture == View::Image || !pane.response.hovered() {
            return;
        }
        let (wheel, pinch) = ui.input(|i| (f64::from(i.smooth_scroll_delta().y), f64::from(i.zoom_delta())));
        let factor = (wheel * ZOOM_PER_POINT).exp() * pinch;
        if factor != 1.0
            && let Some(pointer) = pane.response.hover_pos()
        {
            let at = pane.place.pixel(pointer);
            let observer = look::zoomed_at(self.seen[pane.picture.index()], factor, at, pane.place.size);
            self.turn(state, pane.picture, observer);
        }
    }

    // The pointer, not held.

    /// Marks what is under the pointer and says what it is.
    fn hover(
        &mut self,
        ui: &Ui,
        state: &State,
        pane: &Pane,
        status: &mut Status,
        texts: &'static CanvasTexts,
    ) -> Option<Probe> {
        let pointer = pane.place.pixel(pane.response.hover_pos()?);
        let setup = setup(state, &self.extras, pane.place.size);
        let (camera, digits) = (state.document.camera(), state.settings.digits.min(6));
        let observer = self.seen.get(pane.picture.index()).unwrap_or(&self.seen[0]);
        status.aside = format!("{} × {} px", pane.place.size.width, pane.place.size.height);
        if pane.picture == View::World
            && let Some(handle) = handle_at(&setup, observer, pointer, pane.place.pixels(handles::REACH))
        {
            let lines = [handles::readout(handle, camera, digits, texts), handles::hint(handle, camera, digits, texts)];
            tooltip(ui, &lines);
            status.message = lines.join(" · ");
            ui.set_cursor_icon(handles::cursor(false));
            self.extras.hot = Some(handle);
            return probed(handle, state);
        }
        if pane.picture == View::World
            && let Some(axis) = arrow_at(&setup, observer, pointer, pane.place.pixels(ARROW_REACH))
        {
            let lines = arrow_lines(state, digits);
            tooltip(ui, &lines);
            status.message = lines.join(" · ");
            ui.set_cursor_icon(handles::cursor(false));
            if let Some(arrows) = &mut self.extras.arrows {
                arrows.hot = Some(axis);
            }
            return None;
        }
        let what = What::Under {
            picture: pane.picture,
            observer: *observer,
            size: pane.place.size,
            pointer,
            reach: pane.place.pixels(probe::REACH),
        };
        let asked = question(state, &self.extras, what);
        status.message = match pane.picture {
            View::Image => match pick::window_point_in_image(&setup, pointer) {
                Some(point) => {
                    let image = state.document.figure().image;
                    let pixel = probe::pair(probe::pixel_of(image, camera, point), 17);
                    let point = probe::pair(point, 4);
                    format!(
                        "{} {pixel} / {} × {} · {} {point} · {}",
                        texts.space_pixel, image.width, image.height, texts.space_window, texts.pointer_in_image
                    )
                }
                None => texts.pointer_in_image.to_owned(),
            },
            _ => texts.pointer_in_space.to_owned(),
        };
        self.seeker.ask(ui.ctx(), asked).probe
    }

    // The keys.

    /// Keeps the arrow keys in a picture that has the focus, and lets the keys act.
    fn focus(&mut self, ui: &Ui, state: &mut State, pane: &Pane) {
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
            self.key(state, pane.picture, key, modifiers);
            ui.request_repaint();
        }
    }

    fn key(&mut self, state: &mut State, picture: View, key: Key, modifiers: Modifiers) {
        let arrow = match key {
            Key::ArrowRight => DVec2::X,
            Key::ArrowLeft => DVec2::NEG_X,
            Key::ArrowUp => DVec2::Y,
            Key::ArrowDown => DVec2::NEG_Y,
            _ => DVec2::ZERO,
        };
        match (key, picture) {
            (Key::Plus | Key::Equals | Key::Minus, _) => {
                let factor = if key == Key::Minus { STEP_FACTOR.recip() } else { STEP_FACTOR };
                if picture == View::Image {
                    operate(state, Operation::Zoom(factor));
                } else {
                    self.turn(state, picture, self.seen[picture.index()].zoom(factor));
                }
            }
            (Key::Home, View::World | View::Canonical) => self.asked = Some((picture, Look::Fit)),
            (Key::PageUp, View::World | View::Image) => operate(state, Operation::Dolly(STEP_FACTOR)),
            (Key::PageDown, View::World | View::Image) => operate(state, Operation::Dolly(STEP_FACTOR.recip())),
            _ if arrow != DVec2::ZERO => self.arrow(state, picture, arrow, modifiers),
            _ => {}
        }
    }

    /// Turns the camera about PF as the eye expects: up raises it, right moves it to the right. By the right-hand rule a
    /// positive elevation would lower it. In the canonical volume, and with Shift in the world, the observer turns instead.
    fn arrow(&mut self, state: &mut State, picture: View, arrow: DVec2, modifiers: Modifiers) {
        if picture == View::Canonical || (picture == View::World && modifiers.shift) {
            let step = STEP / look::DEGREES_PER_POINT;
            #[expect(clippy::cast_possible_truncation, reason = "a few steps")]
            let motion = Vec2::new(-(arrow.x * step) as f32, (arrow.y * step) as f32);
            for other in [View::World, View::Canonical] {
                if other == picture || state.layout.linked {
                    self.turn(state, other, look::orbited(self.seen[other.index()], motion));
                }
            }
            return;
        }
        if arrow.y != 0.0 {
            operate(state, Operation::Elevation(Angle::from_degrees(-STEP * arrow.y)));
        }
        if arrow.x != 0.0 {
            operate(state, Operation::Azimuth(Angle::from_degrees(STEP * arrow.x)));
        }
    }
}

/// Does an operation to the camera; where it cannot be done, nothing happens.
fn operate(state: &mut State, operation: Operation) {
    if let Ok(camera) = operation.apply(state.document.camera(), Convention::RightHand) {
        state.document.set_parameters(*camera.parameters());
    }
}

/// C and PF are points of the world, and so can be probed.
fn probed(handle: Handle, state: &State) -> Option<Probe> {
    let camera = state.document.camera();
    match handle {
        Handle::FocalPoint => Some(Probe::Point(camera.focal_point())),
        Handle::Position | Handle::ViewUp | Handle::Near | Handle::Far => None,
    }
}

fn keys_hint(picture: View, texts: &CanvasTexts) -> &'static str {
    match picture {
        View::World => texts.keys_in_world,
        View::Canonical => texts.keys_in_canonical,
        View::Image => texts.keys_in_image,
    }
}

/// A note beside the pointer.
fn tooltip(ui: &Ui, lines: &[String]) {
    let id = ui.scope_id().with("handle");
    Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, PopupAnchor::Pointer).gap(16.0).show(|ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for (i, line) in lines.iter().enumerate() {
            let text = RichText::new(line);
            ui.label(if i == 0 { text.strong() } else { text.small() });
        }
    });
}

/// Where what is selected is, and how its arrows are dragged.
fn arrow_lines(state: &State, digits: usize) -> Vec<String> {
    let t = scenes::texts(state.settings.lang);
    let Some(movable) = Movable::selected(state) else { return Vec::new() };
    let hint = if movable.is_light() { t.drag_lamp } else { t.drag_object };
    let symbol = if movable.is_light() { "P" } else { "T" };
    vec![format!("{symbol} = {}", handles::point(movable.place, digits)), hint.to_owned()]
}
