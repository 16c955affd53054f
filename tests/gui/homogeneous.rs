//! The tab of w: points behind the eye, the middle of a segment, the floor, vanishing points.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Parameters, Projection};
use camera_lab::figure::{Explanation, NamedPoint};
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;
use glam::DVec3;

use super::window::Window;
use crate::words::en;

fn window(lang: Lang, points: &[(&str, DVec3)]) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.camera = Parameters { position: DVec3::new(0.0, 0.0, 5.0), ..figure.camera };
    figure.points =
        points.iter().map(|(name, position)| NamedPoint { name: (*name).to_owned(), position: *position }).collect();
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, [1000.0, 1300.0]);
    window.explain(Explanation::Homogeneous);
    window
}

#[test]
fn a_point_behind_the_eye_is_flipped_and_one_beside_it_has_no_line() {
    let window = window(Lang::En, &[("Q", DVec3::new(1.0, 0.0, 9.0)), ("S", DVec3::new(2.0, 0.0, 5.0))]);
    let written: Vec<String> = window.written().into_iter().map(|(text, _)| text).collect();
    assert!(written.iter().any(|text| text == "Q flipped"), "{written:?}");
    assert!(written.iter().any(|text| text == "S ideal"), "{written:?}");
    // Straight ahead, x and y are parallel to the view plane.
    assert!(written.iter().any(|text| text == "(±x, 0) ideal") && written.iter().any(|text| text == "(±z, 0)"));
    assert!(window.says("behind the eye, or in its plane"), "the segment of the two has no image");
}

#[test]
fn the_middle_is_seen_where_the_formula_says() {
    // w = 2 and w = 6.
    let mut window = window(Lang::PtBr, &[("A", DVec3::new(0.0, 0.0, 3.0)), ("B", DVec3::new(1.0, 0.0, -1.0))]);
    assert!(window.says("s = 0,5·6/(0,5·2 + 0,5·6) = 0,75"));
    window.harness.get_by_role(Role::Slider).set_value_accesskit(0.25);
    window.run();
    assert!(window.says("= 0,5"), "0.25·6/(0.75·2 + 0.25·6)");
}

#[test]
fn the_floor_is_drawn_twice_and_vanishing_points_are_a_switch() {
    let mut window = window(Lang::En, &[]);
    for name in ["affine: wrong", "with w: right"] {
        window.harness.get_by_role_and_label(Role::Image, name);
    }
    assert!(window.says("corners of the volume"));
    window.click(en::HOMOGENEOUS.vanishing);
    assert!(window.state().model.desk.shown.figure().reveal.vanishing);
    let parallel =
        Parameters { projection: Projection::Parallel, ..*window.state().model.desk.shown.camera().parameters() };
    window.app_mut().state.model.desk.shown.set_camera(Camera::new(&parallel).unwrap());
    window.run();
    assert!(window.says("both are the same") && window.says("every w is 1"));
}
