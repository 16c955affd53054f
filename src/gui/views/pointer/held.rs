//! Drags of the pointer: the observer of a picture, a handle of the camera, the gizmo of the selection, a followed
//! point.

use eframe::egui::{CursorIcon, Key, PointerButton, PopupAnchor, Pos2, RichText, TextWrapMode, Tooltip, Ui};
use glam::DVec2;

use super::camera_drag::CameraDrag;
use super::followed::PointDrag;
use crate::figure::Observer;
use crate::gui::views::arrange::orbit;
use crate::gui::views::labels::label_drag::LabelDrag;
use crate::gui::views::pointer::handle_drag::{self, HandleDrag};
use crate::gui::views::pointer::selection_gizmo::Movable;
use crate::gui::views::status::Status;
use crate::gui::views::{Canvas, Pane};
use crate::views::handles::handle_at;
use crate::views::transform_gizmo::{part_at, pull};
use crate::views::{GizmoPart, Handle, Picture, Transforming, View};
use camera_lab_desk::Model;
use camera_lab_words::messages::faults::camera_error;
use camera_lab_words::window::canvas::CanvasTexts;
use camera_lab_words::window::scenes;

/// Distance within which the pointer catches a part of the gizmo, in points.
pub(in crate::gui::views) const GIZMO_REACH: f32 = 7.0;

/// A drag of the pointer in a picture.
pub(in crate::gui::views) enum Drag {
    /// The eye of a three-dimensional picture turns. Holds the former observers, also of the pictures that turn with
    /// it, by picture.
    Orbit(Vec<Option<Observer>>),
    /// The eye of a three-dimensional picture moves. Holds the former observer.
    Pan(Observer),
    /// Something in the world is moved.
    Handle(Box<HandleDrag>),
    /// The selection is moved, turned or scaled.
    Gizmo(Box<GizmoDrag>),
    /// The user moves a followed point.
    Point(Box<PointDrag>),
    /// A label is moved.
    Label(Box<LabelDrag>),
    /// The camera is moved by its image.
    Camera(Box<CameraDrag>),
}

/// A held part of the gizmo.
pub(in crate::gui::views) struct GizmoDrag {
    /// Its state when it was taken, and the scene with it.
    movable: Movable,
    before: crate::scene::SceneSpec,
    part: GizmoPart,
    observer: Option<Observer>,
    from: DVec2,
    /// True if some objects would be sheared and stay unchanged.
    is_sheared: bool,
}

impl Canvas {
    pub(in crate::gui::views) fn drag(&mut self, ui: &Ui, model: &mut Model, pane: &Pane) {
        let (origin, pointer) = ui.input(|i| (i.pointer.press_origin(), i.pointer.latest_pos()));
        if pane.response.drag_started()
            && let Some(origin) = origin
        {
            self.drag = self.taken(ui, model, pane, origin).map(|drag| (pane.picture, drag));
        }
        if self.drag.as_ref().is_none_or(|(picture, _)| *picture != pane.picture) {
            return;
        }
        if ui.input(|i| i.key_pressed(Key::Escape)) {
            self.give_up(model);
            return;
        }
        if let (Some(origin), Some(pointer)) = (origin, pointer) {
            self.follow(ui, model, pane, origin, pointer);
        }
        if pane.response.drag_stopped() || !ui.input(|i| i.pointer.any_down()) {
            self.drag = None;
        }
    }

    /// The drag that a press at `origin` begins.
    fn taken(&self, ui: &Ui, model: &Model, pane: &Pane, origin: Pos2) -> Option<Drag> {
        let Pane { picture, view, request, .. } = pane;
        let picture = *picture;
        let (modifiers, primary) = ui.input(|i| (i.modifiers, i.pointer.button_down(PointerButton::Primary)));
        let from = pane.rect.pixel(origin);
        let point = || PointDrag::taken(request.clone(), from, pane);
        if model.label_mode.on && primary {
            let labels = &self.pictures[picture].labels;
            if let Some(held) = LabelDrag::taken(labels, *view, from, model) {
                return Some(Drag::Label(Box::new(held)));
            }
        }
        let is_own = pane.is_own(origin) && !model.label_mode.on;
        if *view == View::Image {
            if let Some(held) = (primary && is_own).then(point).flatten() {
                return Some(Drag::Point(Box::new(held)));
            }
            let pans = !primary || modifiers.shift;
            let held = is_own.then(|| CameraDrag::taken(request, model.desk.shown.camera(), from, pans));
            return held.flatten().map(|held| Drag::Camera(Box::new(held)));
        }
        if *view == View::World && primary && is_own {
            if let Some(handle) = handle_at(request, from, pane.rect.pixels(handle_drag::REACH)) {
                let held = HandleDrag::new(handle, request.clone(), from, modifiers);
                return Some(Drag::Handle(Box::new(held)));
            }
            if let Some(movable) = Movable::selected(model)
                && let Some(part) = part_at(request, from, pane.rect.pixels(GIZMO_REACH))
            {
                let (observer, before) = (request.observer, model.desk.shown.figure().scene.clone());
                let held = GizmoDrag { movable, before, part, observer, from, is_sheared: false };
                return Some(Drag::Gizmo(Box::new(held)));
            }
            if let Some(held) = point() {
                return Some(Drag::Point(Box::new(held)));
            }
        }
        Some(if primary && !modifiers.shift {
            Drag::Orbit(self.shot.pictures.iter().map(|picture| picture.observer).collect())
        } else {
            Drag::Pan(self.seen(picture)?)
        })
    }

    fn follow(&mut self, ui: &Ui, model: &mut Model, pane: &Pane, origin: Pos2, pointer: Pos2) {
        let motion = pointer - origin;
        let request = &pane.request;
        match &mut self.drag {
            None => {}
            Some((picture, Drag::Orbit(pressed))) => {
                let (picture, pressed) = (*picture, pressed.clone());
                self.turn_with(model, picture, &pressed, |pressed| orbit::orbited(pressed, motion));
            }
            Some((picture, Drag::Pan(pressed))) => {
                let (picture, pressed) = (*picture, *pressed);
                let motion = pane.rect.pixel(pointer) - pane.rect.pixel(origin);
                self.turn(model, picture, pressed.pan(motion.x, motion.y, pane.rect.size.smaller_side()));
            }
            Some((_, Drag::Handle(held))) => {
                let modifiers = ui.input(|i| i.modifiers);
                let moved = held.moved(request, pane.rect.pixel(pointer), modifiers);
                if let Some(parameters) = moved.filter(|p| p != model.desk.shown.draft()) {
                    model.desk.shown.set_parameters(parameters);
                    ui.request_repaint();
                }
            }
            Some((_, Drag::Point(held))) => held.follow(model, pane.rect.pixel(pointer), ui.ctx()),
            Some((_, Drag::Label(held))) => {
                held.follow(model, pane.rect.pixel(pointer), ui.ctx());
            }
            Some((_, Drag::Camera(held))) => {
                let points = DVec2::new(f64::from(motion.x), f64::from(motion.y));
                if held.follow(model, points, pane.rect.pixel(pointer) - pane.rect.pixel(origin)) {
                    ui.request_repaint();
                }
            }
            Some((_, Drag::Gizmo(held))) => {
                let GizmoDrag { movable, before, part, observer, from, is_sheared } = held.as_mut();
                let request = request.clone().seen_by(*observer);
                let Some(pulled) = pull(&request, &movable.gizmo, *part, *from, pane.rect.pixel(pointer)) else {
                    return;
                };
                let snap = ui.input(|i| i.modifiers.command).then(|| snap_length(model));
                // If the scene can't be built with it, the last possible one stays.
                let Ok(Some((scene, all))) = movable.pulled(before, *part, pulled, snap) else { return };
                *is_sheared = !all;
                if model.desk.shown.figure().scene != scene {
                    model.desk.shown.edit(|figure| figure.scene = scene);
                    ui.request_repaint();
                }
            }
        }
    }

    /// The pictures whose observers turn together with this one.
    pub(in crate::gui::views) fn turning_with(&self, picture: usize, model: &Model) -> Vec<usize> {
        let turns =
            |(i, other): &(usize, &Picture)| *i == picture || (model.layout.linked && other.kind != View::Image);
        self.shot.pictures.iter().enumerate().filter(turns).map(|(i, _)| i).collect()
    }

    /// Turns a picture and those that turn with it, from their former observers.
    fn turn_with(
        &mut self,
        model: &mut Model,
        picture: usize,
        pressed: &[Option<Observer>],
        turned: impl Fn(Observer) -> Observer,
    ) {
        for other in self.turning_with(picture, model) {
            if let Some(pressed) = pressed.get(other).copied().flatten() {
                self.turn(model, other, turned(pressed));
            }
        }
    }

    /// Restores the state before the press.
    pub(in crate::gui::views) fn give_up(&mut self, model: &mut Model) {
        match self.drag.take() {
            None => {}
            Some((picture, Drag::Orbit(pressed))) => self.turn_with(model, picture, &pressed, |pressed| pressed),
            Some((picture, Drag::Pan(pressed))) => self.turn(model, picture, pressed),
            Some((_, Drag::Handle(held))) => model.desk.shown.set_camera(held.before),
            Some((_, Drag::Gizmo(held))) => model.desk.shown.edit(|figure| figure.scene = held.before),
            Some((_, Drag::Point(held))) => held.give_up(model),
            Some((_, Drag::Label(held))) => held.give_up(model),
            Some((_, Drag::Camera(held))) => model.desk.shown.set_camera(held.start),
        }
    }

    pub(in crate::gui::views) fn say_drag(&mut self, ui: &Ui, model: &Model, status: &mut Status, texts: &CanvasTexts) {
        let digits = model.settings.digits.min(6);
        match &self.drag {
            None => {}
            Some((picture, Drag::Orbit(_))) => {
                let Some(Observer { azimuth, elevation, .. }) = self.seen(*picture) else { return };
                let angles = [azimuth, elevation].map(|a| texts.lang.mark().number(a, 4));
                status.message = format!("{}: {}° · {}°", texts.turning, angles[0], angles[1]);
                ui.set_cursor_icon(CursorIcon::Grabbing);
            }
            Some((_, Drag::Pan(_))) => {
                texts.moving.clone_into(&mut status.message);
                ui.set_cursor_icon(CursorIcon::Move);
            }
            Some((_, Drag::Handle(held))) => {
                self.hover.hovered = Some(held.handle);
                let camera = model.desk.shown.camera();
                let mut lines = vec![handle_drag::readout(held.handle, camera, digits, (&model.frame.asked, texts))];
                status.message = match &held.stopped {
                    Some(error) => {
                        let reason = format!("{} {}", texts.stopped, camera_error(model.settings.lang, error));
                        lines.push(reason.clone());
                        status.warning = true;
                        reason
                    }
                    None => format!("{} · {}", lines[0], handle_drag::hint(held.handle, camera, digits, texts)),
                };
                tooltip(ui, &lines);
                ui.set_cursor_icon(handle_drag::cursor(true));
            }
            Some((_, Drag::Point(held))) => {
                tell(ui, status, &held.lines(model), handle_drag::cursor(true));
            }
            Some((_, Drag::Label(held))) => {
                status.message = held.line(model);
                ui.set_cursor_icon(CursorIcon::Grabbing);
            }
            Some((_, Drag::Camera(held))) => {
                let camera = model.desk.shown.camera();
                let moved = if held.is_pan() { Handle::FocalPoint } else { Handle::Position };
                status.message = handle_drag::readout(moved, camera, digits, (&model.frame.asked, texts));
                ui.set_cursor_icon(if held.is_pan() { CursorIcon::Move } else { CursorIcon::Grabbing });
            }
            Some((_, Drag::Gizmo(held))) => {
                if let Some(gizmo) = &mut self.hover.gizmo {
                    gizmo.hovered = Some(held.part);
                }
                let mut lines = gizmo_lines(model, digits);
                if held.is_sheared {
                    scenes::texts(model.settings.lang).sheared.clone_into(&mut lines[1]);
                    status.warning = true;
                }
                tell(ui, status, &lines, handle_drag::cursor(true));
            }
        }
    }
}

/// Shows the lines beside the pointer and in the status line.
pub(in crate::gui::views) fn tell(ui: &Ui, status: &mut Status, lines: &[String], cursor: CursorIcon) {
    status.message = lines.join(" · ");
    tooltip(ui, lines);
    ui.set_cursor_icon(cursor);
}

/// A note beside the pointer.
pub(in crate::gui::views) fn tooltip(ui: &Ui, lines: &[String]) {
    let id = ui.scope_id().with("handle");
    Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), id, PopupAnchor::Pointer).gap(16.0).show(|ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for (i, line) in lines.iter().enumerate() {
            let text = RichText::new(line);
            ui.label(if i == 0 { text.strong() } else { text.small() });
        }
    });
}

/// Length of one step of a move while the modifier is held: a tenth of D, rounded to a power of ten.
fn snap_length(model: &Model) -> f64 {
    crate::numbers::power_of_ten(model.desk.shown.camera().distance() / 10.0).unwrap_or(1.0)
}

/// The transform of the selection that the gizmo changes, and the way to drag it.
pub(in crate::gui::views) fn gizmo_lines(model: &Model, digits: usize) -> [String; 2] {
    let t = scenes::texts(model.settings.lang);
    let Some(movable) = Movable::selected(model) else { return Default::default() };
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
