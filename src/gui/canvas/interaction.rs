//! What the pointer and the keys do in the pictures.

use eframe::egui::{
    CursorIcon, Event, EventFilter, Key, Modifiers, PointerButton, PopupAnchor, Pos2, RichText, TextWrapMode, Tooltip,
    Ui, Vec2,
};
use glam::DVec2;

use super::followed::{self, PointDrag};
use super::keyboard_probe::Probing;
use super::picking::{self, PickRequest, What};
use super::status::Status;
use super::{Canvas, Pane, orbit, readout, toggle_maximized};
use crate::camera::{Convention, Operation};
use crate::figure::Observer;
use crate::geometry::Angle;
use crate::gui::handle_drag::{self, HandleDrag};
use crate::gui::selection_gizmo::Movable;
use crate::gui::state::{ObserverChange, Selected, Side, State, Tab};
use crate::i18n::canvas::CanvasTexts;
use crate::i18n::faults::camera_error;
use crate::i18n::scenes;
use crate::numbers::power_of_ten;
use crate::scene::SceneSpec;
use crate::views::Handle;
use crate::views::handles::handle_at;
use crate::views::transform_gizmo::{part_at, pull};
use crate::views::{GizmoPart, Overlays, Probe, Request, Transforming, View, pick};

/// Logarithm of the zoom for one point of the wheel.
const ZOOM_PER_POINT: f64 = 0.004;

/// Degrees for one press of an arrow key.
const STEP: f64 = 5.0;

/// Zoom or dolly for one press of a key.
const STEP_FACTOR: f64 = 1.1;

/// How near the pointer must come to a part of the gizmo, in points.
const GIZMO_REACH: f32 = 7.0;

/// What is held with the pointer.
pub(super) enum Drag {
    /// The eye of a three-dimensional picture turns.
    Orbit { view: View, pressed: [Option<Observer>; 3] },
    /// The eye of a three-dimensional picture moves.
    Pan { view: View, pressed: Observer },
    /// Something in the world is moved.
    Handle(Box<HandleDrag>),
    /// What is selected is moved, turned or scaled.
    Gizmo(Box<GizmoDrag>),
    /// A point that is followed is moved.
    Point(Box<PointDrag>),
}

/// A part of the gizmo that is held.
pub(super) struct GizmoDrag {
    /// As it was when it was taken, and the scene with it.
    movable: Movable,
    before: SceneSpec,
    part: GizmoPart,
    observer: Option<Observer>,
    from: DVec2,
    /// Some objects would be sheared and stay as they were.
    is_sheared: bool,
}

impl Drag {
    fn view(&self) -> View {
        match self {
            Self::Orbit { view, .. } | Self::Pan { view, .. } => *view,
            Self::Handle(_) | Self::Gizmo(_) => View::World,
            Self::Point(held) => held.view(),
        }
    }
}

impl Canvas {
    /// Lets pointer and keys act; the result says what is under the pictures.
    pub(super) fn interact(
        &mut self,
        ui: &Ui,
        state: &mut State,
        panes: &[Pane],
        texts: &'static CanvasTexts,
    ) -> Status {
        let mut status = Status::default();
        if !panes.iter().any(|pane| self.drag.as_ref().is_some_and(|drag| drag.view() == pane.view)) {
            self.drag = None;
        }
        if self.drag.is_none() && ui.input(|i| i.key_pressed(Key::Escape)) {
            // One thing after the other.
            if self.pinned.is_none() && self.probing.is_none() && state.shown_stage().is_some() {
                state.layout.stage = None;
                ui.request_repaint();
            }
            self.pinned = None;
            self.probing = None;
        }
        let mut hovered = None;
        self.overlays.hot = None;
        for pane in panes {
            self.focus(ui, state, pane);
            self.drag(ui, state, pane);
            self.wheel(ui, state, pane);
            if self.drag.is_none() && pane.response.hovered() && !ui.input(|i| i.pointer.any_down()) {
                hovered = self.hover(ui, state, pane, &mut status, texts);
            }
            self.click(state, pane, hovered);
            if status.message.is_empty() && pane.response.has_focus() {
                keys_hint(pane.view, texts).clone_into(&mut status.message);
            }
        }
        if self.drag.is_some() {
            self.say_drag(ui, state, &mut status, texts);
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
        self.overlays.probe = self.pinned.or(hovered);
        status
    }

    fn click(&mut self, state: &mut State, pane: &Pane, hovered: Option<Probe>) {
        let response = &pane.response;
        if response.double_clicked_by(PointerButton::Primary) {
            self.pinned = self.pinned_before;
            toggle_maximized(state, pane.view);
            response.ctx.request_repaint();
        } else if response.clicked_by(PointerButton::Primary) && response.hovered() {
            self.pinned_before = self.pinned;
            self.pinned = hovered;
            self.probing = None;
            let beside = response.ctx.input(|i| i.modifiers.command);
            self.select(state, pane, beside);
        }
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
    }

    /// While the tree of the scene is open, selects the object that was clicked; with `beside`, beside what is selected.
    fn select(&self, state: &mut State, pane: &Pane, beside: bool) {
        let is_open = state.settings.tab == Tab::Scene && state.settings.panels().is_shown(Side::Left);
        let is_there = pane.view != View::Canonical || !state.is_on_the_way();
        let Some(pointer) = pane.response.interact_pointer_pos().filter(|_| is_open && is_there) else { return };
        let pointer = pane.rect.pixel(pointer);
        let request = self.request(state, pane.view, pane.rect.size);
        let selected =
            pick::object(&request, pointer).and_then(|name| Selected::of_object(&state.document.figure().scene, &name));
        if selected.is_some() {
            state.select(selected, beside);
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
        if self.drag.as_ref().is_none_or(|drag| drag.view() != pane.view) {
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
        let view = pane.view;
        let (modifiers, primary) = ui.input(|i| (i.modifiers, i.pointer.button_down(PointerButton::Primary)));
        let from = pane.rect.pixel(origin);
        let point = || PointDrag::taken(self.request(state, view, pane.rect.size), from, pane);
        if view == View::Image {
            return primary.then(point)?.map(|held| Drag::Point(Box::new(held)));
        }
        if view == View::World && primary {
            let request = self.request(state, pane.view, pane.rect.size);
            if let Some(handle) = handle_at(&request, from, pane.rect.pixels(handle_drag::REACH)) {
                return Some(Drag::Handle(Box::new(HandleDrag::new(handle, request, from, modifiers))));
            }
            if let Some(movable) = Movable::selected(state)
                && let Some(part) = part_at(&request, from, pane.rect.pixels(GIZMO_REACH))
            {
                let (observer, before) = (request.observer, state.document.figure().scene.clone());
                let held = GizmoDrag { movable, before, part, observer, from, is_sheared: false };
                return Some(Drag::Gizmo(Box::new(held)));
            }
            if let Some(held) = point() {
                return Some(Drag::Point(Box::new(held)));
            }
        }
        Some(if primary && !modifiers.shift {
            Drag::Orbit { view, pressed: self.seen }
        } else {
            Drag::Pan { view, pressed: self.seen[view.index()]? }
        })
    }

    fn follow(&mut self, ui: &Ui, state: &mut State, pane: &Pane, origin: Pos2, pointer: Pos2) {
        let motion = pointer - origin;
        let request = self.request(state, pane.view, pane.rect.size);
        match &mut self.drag {
            None => {}
            Some(Drag::Orbit { view, pressed }) => {
                let (view, pressed) = (*view, *pressed);
                for other in turning_with(view, state) {
                    if let Some(pressed) = pressed[other.index()] {
                        self.turn(state, other, orbit::orbited(pressed, motion));
                    }
                }
            }
            Some(Drag::Pan { view, pressed }) => {
                let (view, pressed) = (*view, *pressed);
                let motion = pane.rect.pixel(pointer) - pane.rect.pixel(origin);
                let height = f64::from(pane.rect.size.height);
                self.turn(state, view, pressed.pan(motion.x, motion.y, height));
            }
            Some(Drag::Handle(held)) => {
                let modifiers = ui.input(|i| i.modifiers);
                let moved = held.moved(&request, pane.rect.pixel(pointer), modifiers);
                if let Some(parameters) = moved.filter(|p| p != state.document.draft()) {
                    state.document.set_parameters(parameters);
                    ui.request_repaint();
                }
            }
            Some(Drag::Point(held)) => held.follow(state, pane.rect.pixel(pointer), ui.ctx()),
            Some(Drag::Gizmo(held)) => {
                let GizmoDrag { movable, before, part, observer, from, is_sheared } = held.as_mut();
                let request = Request { observer: *observer, ..request };
                let Some(pulled) = pull(&request, &movable.gizmo, *part, *from, pane.rect.pixel(pointer)) else {
                    return;
                };
                let snap = ui.input(|i| i.modifiers.command).then(|| snap_length(state));
                // Where the scene cannot be built with it, the last one that could stays.
                let Ok(Some((scene, all))) = movable.pulled(before, *part, pulled, snap) else { return };
                *is_sheared = !all;
                if state.document.figure().scene != scene {
                    state.document.edit(|figure| figure.scene = scene);
                    ui.request_repaint();
                }
            }
        }
    }

    /// Puts back what was there before the press.
    fn give_up(&mut self, state: &mut State) {
        match self.drag.take() {
            None => {}
            Some(Drag::Orbit { pressed, view }) => {
                for other in turning_with(view, state) {
                    if let Some(pressed) = pressed[other.index()] {
                        self.turn(state, other, pressed);
                    }
                }
            }
            Some(Drag::Pan { view, pressed }) => self.turn(state, view, pressed),
            Some(Drag::Handle(held)) => state.document.set_camera(held.before()),
            Some(Drag::Gizmo(held)) => state.document.edit(|figure| figure.scene = held.before),
            Some(Drag::Point(held)) => held.give_up(state),
        }
    }

    fn say_drag(&mut self, ui: &Ui, state: &State, status: &mut Status, texts: &CanvasTexts) {
        let digits = state.settings.digits.min(6);
        match &self.drag {
            None => {}
            Some(Drag::Orbit { view, .. }) => {
                let Some(Observer { azimuth, elevation, .. }) = self.seen[view.index()] else { return };
                let angles = [azimuth, elevation].map(|a| texts.lang.mark().number(a, 4));
                status.message = format!("{}: {}° · {}°", texts.turning, angles[0], angles[1]);
                ui.set_cursor_icon(CursorIcon::Grabbing);
            }
            Some(Drag::Pan { .. }) => {
                texts.moving.clone_into(&mut status.message);
                ui.set_cursor_icon(CursorIcon::Move);
            }
            Some(Drag::Handle(held)) => {
                self.overlays.hot = Some(held.handle());
                let camera = state.document.camera();
                let mut lines = vec![handle_drag::readout(held.handle(), camera, digits, texts)];
                status.message = match held.stopped() {
                    Some(error) => {
                        let reason = format!("{} {}", texts.stopped, camera_error(state.settings.lang, error));
                        lines.push(reason.clone());
                        status.warning = true;
                        reason
                    }
                    None => format!("{} · {}", lines[0], handle_drag::hint(held.handle(), camera, digits, texts)),
                };
                tooltip(ui, &lines);
                ui.set_cursor_icon(handle_drag::cursor(true));
            }
            Some(Drag::Point(held)) => {
                let lines = held.lines(state);
                status.message = lines.join(" · ");
                tooltip(ui, &lines);
                ui.set_cursor_icon(handle_drag::cursor(true));
            }
            Some(Drag::Gizmo(held)) => {
                if let Some(gizmo) = &mut self.overlays.gizmo {
                    gizmo.hot = Some(held.part);
                }
                let mut lines = gizmo_lines(state, digits);
                if held.is_sheared {
                    scenes::texts(state.settings.lang).sheared.clone_into(&mut lines[1]);
                    status.warning = true;
                }
                status.message = lines.join(" · ");
                tooltip(ui, &lines);
                ui.set_cursor_icon(handle_drag::cursor(true));
            }
        }
    }

    fn wheel(&mut self, ui: &Ui, state: &mut State, pane: &Pane) {
        if pane.view == View::Image || !pane.response.hovered() {
            return;
        }
        let (wheel, pinch) = ui.input(|i| (f64::from(i.smooth_scroll_delta().y), f64::from(i.zoom_delta())));
        let factor = (wheel * ZOOM_PER_POINT).exp() * pinch;
        if factor != 1.0
            && let Some(pointer) = pane.response.hover_pos()
            && let Some(seen) = self.seen[pane.view.index()]
        {
            let at = pane.rect.pixel(pointer);
            let observer = orbit::zoomed_at(seen, factor, at, pane.rect.size);
            self.turn(state, pane.view, observer);
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
        let pointer = pane.rect.pixel(pane.response.hover_pos()?);
        let request = self.request(state, pane.view, pane.rect.size);
        let (camera, digits) = (state.document.camera(), state.settings.digits.min(6));
        status.aside = format!("{} × {} px", pane.rect.size.width, pane.rect.size.height);
        if pane.view == View::World
            && let Some(handle) = handle_at(&request, pointer, pane.rect.pixels(handle_drag::REACH))
        {
            let lines =
                [handle_drag::readout(handle, camera, digits, texts), handle_drag::hint(handle, camera, digits, texts)];
            tooltip(ui, &lines);
            status.message = lines.join(" · ");
            ui.set_cursor_icon(handle_drag::cursor(false));
            self.overlays.hot = Some(handle);
            return probed(handle, state);
        }
        if pane.view == View::World
            && let Some(part) = part_at(&request, pointer, pane.rect.pixels(GIZMO_REACH))
        {
            let lines = gizmo_lines(state, digits);
            tooltip(ui, &lines);
            status.message = lines.join(" · ");
            ui.set_cursor_icon(handle_drag::cursor(false));
            if let Some(gizmo) = &mut self.overlays.gizmo {
                gizmo.hot = Some(part);
            }
            return None;
        }
        if let Some((p, lines)) = followed::hovered(&request, pointer, pane, state) {
            tooltip(ui, &lines);
            status.message = lines.join(" · ");
            ui.set_cursor_icon(handle_drag::cursor(false));
            return Some(Probe::Point(p));
        }
        status.message = match pane.view {
            View::Image => match pick::window_point_in_image(&request, pointer) {
                Some(point) => {
                    let image = state.document.figure().image;
                    let pixel = readout::pair(picking::pixel_of(image, camera, point), 17, texts.lang.mark());
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
        if pane.view == View::Canonical && state.is_on_the_way() {
            return None;
        }
        let what = What::Under { pointer, reach: pane.rect.pixels(picking::REACH) };
        let request = Request { overlays: Overlays::default(), ..request };
        self.picker.ask(ui.ctx(), PickRequest { request, what }).probe
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
            if !self.probe_by_key(state, pane, key, modifiers) {
                self.key(state, pane.view, key, modifiers);
            }
            ui.request_repaint();
        }
    }

    /// Lets the keys move the probe, once they were asked to; true where this key did.
    fn probe_by_key(&mut self, state: &State, pane: &Pane, key: Key, modifiers: Modifiers) -> bool {
        let request = Request { overlays: Overlays::default(), ..self.request(state, pane.view, pane.rect.size) };
        if let Some(asked) = Probing::asked(key, pane.view) {
            // The same key again ends it.
            let is_on = self.probing == Some((pane.view, asked));
            self.probing = (!is_on).then_some((pane.view, asked));
            self.pinned = if is_on { None } else { asked.first(&request) };
            return true;
        }
        let arrow = arrow_of(key);
        let Some((view, probing)) = self.probing.filter(|_| arrow != DVec2::ZERO) else { return false };
        if view != pane.view {
            return false;
        }
        self.pinned = match self.pinned {
            Some(now) => probing.moved(&request, now, arrow, modifiers).or(self.pinned),
            None => probing.first(&request),
        };
        true
    }

    fn key(&mut self, state: &mut State, view: View, key: Key, modifiers: Modifiers) {
        let arrow = arrow_of(key);
        match (key, view) {
            (Key::Plus | Key::Equals | Key::Minus, _) => {
                let factor = if key == Key::Minus { STEP_FACTOR.recip() } else { STEP_FACTOR };
                if view == View::Image {
                    state.operate(Operation::Zoom(factor));
                } else if let Some(seen) = self.seen[view.index()] {
                    self.turn(state, view, seen.zoom(factor));
                }
            }
            (Key::Home, View::World | View::Canonical) => self.asked = Some((view, ObserverChange::Fit)),
            (Key::PageUp, View::World | View::Image) => state.operate(Operation::Dolly(STEP_FACTOR)),
            (Key::PageDown, View::World | View::Image) => state.operate(Operation::Dolly(STEP_FACTOR.recip())),
            (Key::T, View::World) => state.tree.transforming = Transforming::Move,
            (Key::R, View::World) => state.tree.transforming = Transforming::Turn,
            (Key::S, View::World) => state.tree.transforming = Transforming::Scale,
            _ if arrow != DVec2::ZERO => self.arrow(state, view, arrow, modifiers),
            _ => {}
        }
    }

    /// Turns the camera about PF as the eye expects: up raises it, right moves it to the right. By the right-hand rule a
    /// positive elevation lowers it, by the signs of VTK it raises it. In the canonical volume, and with Shift in the world, the observer turns instead.
    fn arrow(&mut self, state: &mut State, view: View, arrow: DVec2, modifiers: Modifiers) {
        if view == View::Canonical || (view == View::World && modifiers.shift) {
            let step = STEP / orbit::DEGREES_PER_POINT;
            #[expect(clippy::cast_possible_truncation, reason = "a few steps")]
            let motion = Vec2::new(-(arrow.x * step) as f32, (arrow.y * step) as f32);
            for other in turning_with(view, state) {
                if let Some(seen) = self.seen[other.index()] {
                    self.turn(state, other, orbit::orbited(seen, motion));
                }
            }
            return;
        }
        if arrow.y != 0.0 {
            let raised = match state.operations.convention {
                Convention::RightHand => -STEP,
                Convention::Vtk => STEP,
            };
            state.operate(Operation::Elevation(Angle::from_degrees(raised * arrow.y)));
        }
        if arrow.x != 0.0 {
            state.operate(Operation::Azimuth(Angle::from_degrees(STEP * arrow.x)));
        }
    }
}

/// The direction of an arrow key: x right, y up; zero for any other.
fn arrow_of(key: Key) -> DVec2 {
    match key {
        Key::ArrowRight => DVec2::X,
        Key::ArrowLeft => DVec2::NEG_X,
        Key::ArrowUp => DVec2::Y,
        Key::ArrowDown => DVec2::NEG_Y,
        _ => DVec2::ZERO,
    }
}

/// The pictures whose observers turn with that of `view`.
fn turning_with(view: View, state: &State) -> impl Iterator<Item = View> + use<> {
    let linked = state.layout.linked;
    [View::World, View::Canonical].into_iter().filter(move |other| *other == view || linked)
}

/// C and PF are points of the world, and so can be probed.
fn probed(handle: Handle, state: &State) -> Option<Probe> {
    let camera = state.document.camera();
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

/// How far a move goes in one step while the modifier is held: a tenth of D, as a power of ten.
fn snap_length(state: &State) -> f64 {
    power_of_ten(state.document.camera().distance() / 10.0).unwrap_or(1.0)
}

/// What the gizmo changes of what is selected, as it is now, and how it is dragged.
fn gizmo_lines(state: &State, digits: usize) -> [String; 2] {
    let t = scenes::texts(state.settings.lang);
    let Some(movable) = Movable::selected(state) else { return Default::default() };
    let (symbol, value, hint) = match (movable.is_light(), movable.gizmo.does) {
        (true, Transforming::Turn) => ("L", movable.place, t.drag_parallel_light),
        (true, Transforming::Move | Transforming::Scale) => ("P", movable.place, t.drag_lamp),
        (false, Transforming::Move) => ("T", movable.place, t.drag_object),
        (false, Transforming::Turn) => ("R", movable.rotate, t.drag_ring),
        (false, Transforming::Scale) => ("S", movable.scale, t.drag_bar),
    };
    let together = match movable.count() {
        1 => String::new(),
        count => format!(" · {count} {}", t.together),
    };
    [
        format!("{symbol} = {}{together}", handle_drag::point(value, digits, t.lang.mark())),
        format!("{hint} · {}", t.drag_snaps),
    ]
}
