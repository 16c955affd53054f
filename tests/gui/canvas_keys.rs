//! The three pictures: actions of keys in them.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Parameters};
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::canvas::{IMAGE, Stage, WORLD, parameters, stage, world_observer};

#[test]
fn keys_raise_the_camera_and_turn_the_view() {
    let mut h = stage(|_| ());
    let before = parameters(&h);
    h.get_by_label_contains(IMAGE).focus();
    h.run();
    h.key_press(Key::ArrowUp);
    h.run();
    let raised = parameters(&h);
    assert!(raised.position.y > before.position.y, "up raises the camera");
    let distance = |p: &Parameters| p.position.distance(p.focal_point);
    assert!((distance(&raised) - distance(&before)).abs() < 1e-12);

    let right = Camera::new(&raised).unwrap().basis().u;
    h.key_press(Key::ArrowRight);
    h.run();
    let turned = parameters(&h);
    assert!((turned.position - raised.position).dot(right) > 0.3, "right moves it to the right");

    h.key_press(Key::Minus);
    h.run();
    assert!(parameters(&h).view_angle > turned.view_angle);
    let wider = parameters(&h);
    h.key_press(Key::PageUp);
    h.run();
    assert!((distance(&parameters(&h)) - distance(&wider) / 1.1).abs() < 1e-12);

    let camera = parameters(&h);
    h.get_by_label_contains(WORLD).focus();
    h.run();
    h.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
    h.run();
    assert!((world_observer(&h).azimuth - 105.0).abs() < 1e-4, "the eye goes to the right");
    assert_eq!(parameters(&h), camera);
}

/// The image alone, with the focus.
fn focused_image() -> Harness<'static, Stage> {
    let mut h = stage(|state| state.model.layout.maximized = Some(View::Image));
    h.get_by_label_contains(IMAGE).focus();
    h.run();
    h
}

#[test]
fn keys_all_the_way_round_give_the_camera_back() {
    let mut h = focused_image();
    let before = parameters(&h);
    for key in [Key::ArrowRight, Key::ArrowUp] {
        for _ in 0..72 {
            h.key_press(key);
            h.step();
        }
        let after = parameters(&h);
        assert_eq!((after.position, after.focal_point), (before.position, before.focal_point), "{key:?}: 72 times 5°");
        // The rounding error of a zero is far below the last bit of anything else.
        assert!(after.view_up.distance(before.view_up) < 1e-30, "{key:?}: {}", after.view_up);
    }
}

#[test]
fn keys_raise_the_camera_by_the_signs_that_are_chosen() {
    use camera_lab::camera::{Convention, Operation};
    use camera_lab::geometry::Angle;
    for (convention, degrees) in [(Convention::RightHand, -5.0), (Convention::Vtk, 5.0)] {
        let mut h = focused_image();
        h.state_mut().state.model.operations.convention = convention;
        let camera = h.state().state.model.desk.shown.camera().clone();
        h.key_press(Key::ArrowUp);
        h.run();
        let elevated = Operation::Elevation(Angle::from_degrees(degrees)).apply(&camera, convention).unwrap();
        assert_eq!(parameters(&h), *elevated.parameters());
        assert!(parameters(&h).position.y > camera.position().y, "up raises it");
    }
}

#[test]
fn a_key_that_can_do_nothing_says_why() {
    let mut h = focused_image();
    let impossible = Parameters { near: 100.0, ..parameters(&h) };
    h.state_mut().state.model.desk.shown.set_parameters(impossible);
    h.run();
    for key in [Key::PageUp, Key::ArrowLeft, Key::Plus] {
        h.state_mut().state.model.message = None;
        h.key_press(key);
        h.run();
        assert_eq!(parameters(&h), impossible, "what was typed stays");
        let message = h.state().state.model.message.as_ref().unwrap();
        assert!(message.is_error() && message.text(Lang::En).contains("F must be less than B"), "{message:?}");
    }
}
