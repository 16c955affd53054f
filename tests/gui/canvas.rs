//! The three pictures: actions of the pointer in them, their arrangement, and that nothing is drawn twice.

#![expect(clippy::unwrap_used, clippy::cast_possible_truncation, reason = "tests; places on a small screen")]

use std::time::Duration;

use camera_lab::camera::{Camera, Parameters};
use camera_lab::figure::{Figure, Observer};
use camera_lab::gui::app::frame::pictures;
use camera_lab::gui::kit::theme;
use camera_lab::gui::views::Canvas;
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::handles::handles;
use camera_lab::views::{Arrangement, Handle, Request, Size, View};
use camera_lab_words::Lang;
use camera_lab_words::pictures::labels;
use camera_lab_words::window::canvas as words;
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Rect, TouchDeviceId, TouchId,
    TouchPhase, Vec2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;

use super::window::Window;
use crate::words::en;

pub(super) struct Stage {
    pub(super) state: State,
    pub(super) canvas: Canvas,
}

pub(super) const WORLD: &str = "World: the scene";
pub(super) const CANONICAL: &str = "Canonical volume: the scene";
pub(super) const IMAGE: &str = "Image: what the camera sees";

pub(super) fn observer() -> Observer {
    Observer {
        target: DVec3::new(1.0, 1.5, 2.0),
        distance: 22.0,
        azimuth: 100.0,
        elevation: 30.0,
        roll: 0.0,
        parallel: false,
    }
}

pub(super) fn stage(change: impl FnOnce(&mut State)) -> Harness<'static, Stage> {
    let mut figure =
        Figure { camera: Parameters { near: 2.0, far: 9.0, ..Parameters::default() }, ..Figure::default() };
    figure.scene.preset = Preset::Cube;
    figure.style.antialias = camera_lab::appearance::Samples::One;
    figure.observers.world = Some(observer());
    figure.observers.canonical = Some(Observer { target: DVec3::ZERO, distance: 8.0, ..observer() });
    let mut state = State::new(Start { figure, lang: Lang::En, ..Start::default() }).unwrap();
    change(&mut state);
    let mut canvas = Canvas::default();
    canvas.patience = Some(Duration::from_secs(60));
    let mut harness = Harness::builder()
        .with_size([1110.0, 330.0])
        .with_step_dt(0.05)
        .with_context_setup(theme::install_fonts)
        .build_ui_state(
            |ui, stage: &mut Stage| pictures(ui, &mut stage.canvas, &mut stage.state),
            Stage { state, canvas },
        );
    harness.run();
    harness
}

pub(super) fn place(harness: &Harness<Stage>, label: &str) -> Rect {
    harness.get_by_label_contains(label).rect()
}

pub(super) fn parameters(harness: &Harness<Stage>) -> Parameters {
    *harness.state().state.model.desk.shown.draft()
}

pub(super) fn world_observer(harness: &Harness<Stage>) -> Observer {
    harness.state().state.model.desk.shown.figure().observers.world.unwrap()
}

pub(super) fn canonical_observer(harness: &Harness<Stage>) -> Observer {
    harness.state().state.model.desk.shown.figure().observers.canonical.unwrap()
}

/// The world in `rect`.
pub(super) fn world(harness: &Harness<Stage>, rect: Rect) -> Request {
    let state = &harness.state().state;
    let side = |s: f32| s.round() as u32;
    let size = Size { width: side(rect.width()), height: side(rect.height()), scale: 1.0 };
    let (figure, camera) = (state.model.desk.shown.figure(), state.model.desk.shown.camera());
    Request::of(figure, View::World, camera, state.model.scene_cache.scene(), labels(Lang::En), size)
}

/// The place of a handle on the screen.
pub(super) fn handle(harness: &Harness<Stage>, wanted: Handle) -> Pos2 {
    let rect = place(harness, WORLD);
    let all = handles(&world(harness, rect));
    let (_, p) = all.into_iter().find(|(h, _)| *h == wanted).unwrap();
    rect.min + vec2(p.x as f32, p.y as f32)
}

pub(super) fn drag(
    harness: &mut Harness<Stage>,
    from: Pos2,
    motion: Vec2,
    button: PointerButton,
    modifiers: Modifiers,
) {
    let press = |pressed, pos| Event::PointerButton { pos, button, pressed, modifiers };
    harness.event(Event::ModifiersChanged(modifiers));
    harness.hover_at(from);
    harness.run();
    harness.event(press(true, from));
    harness.run();
    for share in [0.4, 1.0] {
        harness.hover_at(from + motion * share);
        harness.run();
    }
    harness.event(press(false, from + motion));
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
    harness.run();
    harness.state_mut().state.model.desk.commit();
}

pub(super) fn drag_primary(harness: &mut Harness<Stage>, from: Pos2, motion: Vec2) {
    drag(harness, from, motion, PointerButton::Primary, Modifiers::NONE);
}

/// A place in the world that no handle covers.
pub(super) fn free_place(harness: &Harness<Stage>) -> Pos2 {
    place(harness, WORLD).left_bottom() + vec2(30.0, -30.0)
}

#[test]
fn a_drag_turns_the_observer_by_half_a_degree_a_point_and_is_no_undo_step() {
    let mut h = stage(|_| ());
    let from = free_place(&h);
    drag_primary(&mut h, from, vec2(60.0, 20.0));
    let now = world_observer(&h);
    assert!((now.azimuth - 70.0).abs() < 1e-4 && (now.elevation - 40.0).abs() < 1e-4, "{now:?}");
    assert_eq!((now.target, now.distance), (observer().target, observer().distance));
    assert_eq!(canonical_observer(&h).azimuth, observer().azimuth, "the other picture is not linked");
    assert!(!h.state().state.model.desk.can_undo(true));
}

#[test]
fn linked_orbits_turn_together() {
    let mut h = stage(|state| state.model.layout.linked = true);
    let from = place(&h, CANONICAL).left_bottom() + vec2(20.0, -20.0);
    drag_primary(&mut h, from, vec2(-40.0, 0.0));
    for now in [world_observer(&h), canonical_observer(&h)] {
        assert!((now.azimuth - 120.0).abs() < 1e-4, "{now:?}");
    }
}

#[test]
fn shift_and_the_right_button_move_the_picture_with_the_pointer() {
    for (button, modifiers) in [(PointerButton::Secondary, Modifiers::NONE), (PointerButton::Primary, Modifiers::SHIFT)]
    {
        let mut h = stage(|_| ());
        let focal_point_before = handle(&h, Handle::FocalPoint);
        let from = free_place(&h);
        drag(&mut h, from, vec2(25.0, -15.0), button, modifiers);
        let now = world_observer(&h);
        assert_eq!((now.azimuth, now.elevation, now.distance), (100.0, 30.0, 22.0));
        let moved = handle(&h, Handle::FocalPoint) - focal_point_before;
        assert!((moved - vec2(25.0, -15.0)).length() < 4.0, "{moved}");
    }
}

#[test]
fn the_wheel_goes_nearer_to_the_point_under_the_pointer() {
    let mut h = stage(|_| ());
    let focal_point = handle(&h, Handle::FocalPoint);
    h.hover_at(focal_point + vec2(0.0, 14.0));
    h.run();
    h.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, 100.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    h.run_steps(40);
    let now = world_observer(&h);
    assert!(now.distance < 0.75 * observer().distance, "{now:?}");
    let moved = handle(&h, Handle::FocalPoint) - focal_point;
    assert!(moved.length() < 10.0, "what is near the pointer stays near it: {moved}");
}

#[test]
fn c_goes_over_its_plane_in_one_undo_step() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    let from = handle(&h, Handle::Position);
    drag_primary(&mut h, from, vec2(30.0, 12.0));
    let after = parameters(&h);
    assert_eq!(after.position.y, before.position.y, "C keeps its height");
    assert!(after.position.distance(before.position) > 0.5);
    assert_eq!((after.focal_point, after.near, after.far), (before.focal_point, before.near, before.far));
    let now = handle(&h, Handle::Position);
    assert!(now.distance(from + vec2(30.0, 12.0)) < 2.0, "C is under the pointer: {now}");
    let desk = &mut h.state_mut().state.model.desk;
    desk.undo(true);
    assert_eq!(*desk.shown.draft(), before);
    assert!(!desk.can_undo(true), "one step");
}

#[test]
fn with_ctrl_c_goes_up_and_down() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    let from = handle(&h, Handle::Position);
    drag(&mut h, from, vec2(0.0, 30.0), PointerButton::Primary, Modifiers::CTRL);
    let after = parameters(&h);
    assert!((after.position - before.position).truncate().x.abs() < 1e-12);
    assert_eq!(after.position.z, before.position.z);
    assert!(after.position.y < before.position.y - 0.3, "{}", after.position);
}

#[test]
fn the_front_plane_goes_along_the_axis_and_stops_before_the_back_plane() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    let from = handle(&h, Handle::Near);
    let axis = handle(&h, Handle::Far) - from;
    drag_primary(&mut h, from, axis * 0.3);
    let after = parameters(&h);
    assert!(after.near > before.near + 0.5 && after.near < before.far, "{}", after.near);
    assert_eq!((after.position, after.far), (before.position, before.far));

    let from = handle(&h, Handle::Near);
    drag_primary(&mut h, from, axis * 3.0);
    let after = parameters(&h);
    assert!(after.near < after.far && Camera::new(&after).is_ok());
}

#[test]
fn escape_gives_a_handle_back() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    let from = handle(&h, Handle::Position);
    h.hover_at(from);
    h.run();
    h.drag_at(from);
    h.run();
    h.hover_at(from + vec2(40.0, 0.0));
    h.run();
    assert_ne!(parameters(&h), before);
    h.key_press(Key::Escape);
    h.run();
    assert_eq!(parameters(&h), before);
    h.hover_at(from + vec2(80.0, 0.0));
    h.run();
    assert_eq!(parameters(&h), before, "what was given back is not held any more");
}

#[test]
fn a_picture_can_be_hidden_and_shown_again() {
    let mut h = stage(|state| state.model.layout.arrangement = Some(Arrangement::Row));
    let width = place(&h, IMAGE).width();
    h.get_all_by_label(en::CANVAS.hide).next().unwrap().click();
    h.run();
    assert_eq!(h.state().state.model.layout.shown, [false, true, true]);
    assert!(h.query_by_label_contains(WORLD).is_none());
    assert!(place(&h, IMAGE).width() > 1.4 * width);
    h.get_by_label("World").click();
    h.run();
    assert_eq!(h.state().state.model.layout.shown, [true; 3]);
    assert!(h.query_by_label_contains(WORLD).is_some());
}

#[test]
fn a_double_click_gives_a_picture_all_the_room_and_takes_it_back() {
    let mut h = stage(|_| ());
    for expected in [Some(View::Canonical), None] {
        let center = place(&h, CANONICAL).left_top() + vec2(15.0, 15.0);
        h.hover_at(center);
        h.run();
        for _ in 0..2 {
            h.drag_at(center);
            h.step();
            h.drop_at(center);
            h.step();
        }
        h.run();
        assert_eq!(h.state().state.model.layout.maximized, expected);
        assert_eq!(h.query_by_label_contains(IMAGE).is_none(), expected.is_some());
        h.run_steps(60);
    }
}

#[test]
fn only_changed_pictures_are_drawn_again() {
    let mut h = stage(|_| ());
    let drawn = h.state().canvas.drawn();
    assert!(drawn.iter().all(|&n| n >= 1));
    h.run_steps(5);
    assert_eq!(h.state().canvas.drawn(), drawn, "nothing has changed");

    let from = free_place(&h);
    drag_primary(&mut h, from, vec2(40.0, 0.0));
    let orbited = h.state().canvas.drawn();
    assert!(orbited[0] > drawn[0]);
    assert_eq!(orbited[1..], drawn[1..], "only the world has another observer");

    h.state_mut().state.model.layout.shown[1] = false;
    h.run();
    let hidden = h.state().canvas.drawn();
    let wider = Parameters { view_angle: 60.0, ..parameters(&h) };
    h.state_mut().state.model.desk.shown.set_parameters(wider);
    h.run();
    let changed = h.state().canvas.drawn();
    assert_eq!((changed[0], changed[1], changed[2]), (hidden[0] + 1, hidden[1], hidden[2] + 1));
}

/// Takes a viewpoint of the world from its menu.
fn look(h: &mut Harness<'_, Stage>, from: &str) {
    h.get_all_by_label(en::CANVAS.look_menu).next().unwrap().click();
    h.run();
    h.get_by_label_contains(from).click();
    h.run();
}

#[test]
fn a_side_view_is_stored_and_an_automatic_observer_ignores_small_moves() {
    let mut h = stage(|_| ());
    look(&mut h, "From the top (+y)");
    assert_eq!(world_observer(&h).elevation, 90.0);
    assert_eq!(canonical_observer(&h).elevation, 30.0, "each picture has its own buttons");
    look(&mut h, "From a corner");
    assert_eq!(h.state().state.model.desk.shown.figure().observers.world, None);

    let drawn = h.state().canvas.drawn()[0];
    let moved = Parameters { position: parameters(&h).position * 1.02, ..parameters(&h) };
    h.state_mut().state.model.desk.shown.set_parameters(moved);
    h.run();
    assert_eq!(h.state().canvas.drawn()[0], drawn + 1, "one picture, from one place");
}

#[test]
fn two_bars_divide_the_pictures() {
    let mut h = stage(|_| ());
    let (world, canonical) = (place(&h, WORLD), place(&h, CANONICAL));
    let bar = Pos2::new((world.right() + canonical.left()) / 2.0, world.center().y);
    drag_primary(&mut h, bar, vec2(-80.0, 0.0));
    assert!((place(&h, WORLD).width() - (world.width() - 80.0)).abs() <= 2.0);
}

#[test]
fn pictures_are_arranged_as_asked() {
    let mut h = stage(|state| state.model.layout.arrangement = Some(Arrangement::Row));
    assert!(place(&h, IMAGE).left() > place(&h, CANONICAL).right(), "side by side");
    h.get_by_label(en::CANVAS.arrange).click();
    h.run_steps(4);
    h.get_by_label(en::CANVAS.arrange_above).click();
    h.run_steps(4);
    let (world, canonical, image) = (place(&h, WORLD), place(&h, CANONICAL), place(&h, IMAGE));
    assert!(canonical.top() > world.bottom() && image.top() == canonical.top() && image.left() > canonical.right());
    assert!(world.width() > canonical.width() + image.width());
}

/// A finger as a browser tells it: the first one is a pointer too.
fn finger(harness: &Harness<Stage>, id: u64, phase: TouchPhase, pos: Pos2) {
    if id == 0 {
        match phase {
            TouchPhase::Start => harness.event(press(pos, true)),
            TouchPhase::Move => harness.event(Event::PointerMoved(pos)),
            TouchPhase::End | TouchPhase::Cancel => harness.event(press(pos, false)),
        }
    }
    harness.event(Event::Touch { device_id: TouchDeviceId(0), id: TouchId(id), phase, pos, force: None });
}

fn press(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE }
}

#[test]
fn one_finger_turns_a_picture_and_two_move_and_zoom_it() {
    let mut harness = stage(|_| {});
    let center = place(&harness, WORLD).center() + vec2(-90.0, 60.0);
    // One.
    finger(&harness, 0, TouchPhase::Start, center);
    harness.step();
    finger(&harness, 0, TouchPhase::Move, center + vec2(40.0, 0.0));
    harness.step();
    let turned = world_observer(&harness);
    assert_eq!((turned.azimuth, turned.distance), (80.0, observer().distance));
    // The second comes while the first has moved, so the first one's change is taken back.
    finger(&harness, 1, TouchPhase::Start, center + vec2(60.0, 0.0));
    harness.step();
    finger(&harness, 0, TouchPhase::Move, center + vec2(40.0, 1.0));
    harness.step();
    let back = world_observer(&harness);
    assert_eq!(back.azimuth, observer().azimuth);
    // Apart, twice as far.
    finger(&harness, 0, TouchPhase::Move, center + vec2(30.0, 1.0));
    finger(&harness, 1, TouchPhase::Move, center + vec2(70.0, 1.0));
    harness.step();
    harness.step();
    let zoomed = world_observer(&harness);
    assert!(zoomed.distance < 0.6 * back.distance, "{} {}", zoomed.distance, back.distance);
    assert_eq!(zoomed.azimuth, back.azimuth);
    // Together, to the side.
    finger(&harness, 0, TouchPhase::Move, center + vec2(50.0, 1.0));
    finger(&harness, 1, TouchPhase::Move, center + vec2(90.0, 1.0));
    harness.step();
    harness.step();
    let moved = world_observer(&harness);
    assert!((moved.distance / zoomed.distance - 1.0).abs() < 1e-3);
    assert!(moved.target.distance(zoomed.target) > 0.1 && moved.azimuth == zoomed.azimuth);
    // Lifting one does not begin to turn again.
    finger(&harness, 1, TouchPhase::End, center + vec2(90.0, 1.0));
    harness.step();
    finger(&harness, 0, TouchPhase::Move, center + vec2(80.0, 1.0));
    harness.step();
    assert_eq!(world_observer(&harness).azimuth, moved.azimuth);
    finger(&harness, 0, TouchPhase::End, center + vec2(80.0, 1.0));
    harness.step();
}

/// In the image the hand moves the camera: a drag turns it about PF and keeps it level, with Shift the point at PF
/// stays below the pointer, and the wheel goes nearer. Esc gives a drag up, and each drag is one step back.
#[test]
fn the_hand_on_the_image_moves_the_camera() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    let from = place(&h, IMAGE).center() + vec2(-60.0, 30.0);
    drag_primary(&mut h, from, vec2(50.0, 10.0));
    let turned = parameters(&h);
    assert_eq!((turned.focal_point, turned.view_up), (before.focal_point, before.view_up));
    assert!(turned.position.distance(before.position) > 0.5, "{:?} {:?}", turned.position, before.position);
    let [near, far] = [before, turned].map(|p| p.position.distance(p.focal_point));
    assert!((near - far).abs() < 1e-9 && turned.position.y > before.position.y, "downwards it rises");
    let state = &mut h.state_mut().state;
    state.learn.undo(&mut state.model, true);
    h.run();
    assert_eq!(parameters(&h), before);
    let shift = Modifiers::SHIFT;
    drag(&mut h, from, vec2(40.0, 0.0), PointerButton::Primary, shift);
    let panned = parameters(&h);
    let moved = panned.focal_point - before.focal_point;
    assert!(moved.length() > 0.1 && (panned.position - before.position - moved).length() < 1e-9);
    let state = &mut h.state_mut().state;
    state.learn.undo(&mut state.model, true);
    h.hover_at(from);
    h.run();
    h.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, 100.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    h.run_steps(40);
    let nearer = parameters(&h);
    assert!(nearer.position.distance(nearer.focal_point) < 0.9 * near);
}

#[test]
fn a_right_click_in_a_picture_opens_its_menu() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.layout.maximized = None;
    window.run();
    let description = |window: &Window, view| {
        let state = window.state();
        words::describe(Lang::En, view, state.model.desk.shown.camera(), state.model.desk.shown.figure().image)
    };
    let world = description(&window, View::World);
    window.harness.get_by_label(&world).click_secondary();
    window.run();
    // The titles have narrow buttons of the same name.
    let named = window.harness.get_all_by_label(en::CANVAS.hide);
    named.max_by(|a, b| a.rect().width().total_cmp(&b.rect().width())).unwrap().click();
    window.run();
    assert!(!window.state().model.layout.is_shown(View::World));
    // A command of the window.
    let image = description(&window, View::Image);
    window.harness.get_by_label(&image).click_secondary();
    window.run();
    // With its keys.
    window.harness.get_by_label_contains(camera_lab_words::window::cameras::texts(Lang::En).add).click();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().cameras.len(), 1);
}

#[test]
fn the_axes_in_the_corner_lead_to_their_viewpoints() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.layout.maximized = Some(View::World);
    window.run();
    for (name, axis) in [(en::CANVAS.top, DVec3::Y), (en::CANVAS.side, DVec3::X), (en::CANVAS.front, DVec3::Z)] {
        let axis_name = ["x", "y", "z"][axis.to_array().iter().position(|part| *part == 1.0).unwrap()];
        window.click(&format!("{} {axis_name}", en::CANVAS.axis));
        let observer = window.state().model.desk.shown.figure().observers.world.unwrap();
        assert!(observer.axes()[2].dot(axis) > 0.999, "{name}");
    }
}
