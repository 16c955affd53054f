//! One triangle step by step, in the tab of stages.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::figure::Explanation;
use camera_lab::figure::TriangleStep;
use camera_lab::gui::{Start, State};
use camera_lab::picture::FollowedTriangle;
use camera_lab::progress::at_once;
use camera_lab::scene::Preset;
use camera_lab::views::{Request, Size, TriangleOverlay, View};
use camera_lab_words::Lang;
use camera_lab_words::why::triangle::{step, texts};
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable as _;

use super::window::Window;

fn staged(lang: Lang) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Cube;
    figure.style.antialias = camera_lab::appearance::Samples::One;
    (figure.image.width, figure.image.height) = (160, 120);
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, [1100.0, 1000.0]);
    window.explain(Explanation::Triangle);
    window
}

/// The marks of the followed triangle in the pictures.
fn overlay(window: &Window) -> TriangleOverlay {
    let state = window.state();
    let size = Size { width: 640, height: 480, scale: 1.0 };
    let labels = camera_lab_words::pictures::labels(Lang::En);
    let (figure, camera) = (state.model.desk.shown.figure(), state.model.desk.shown.camera());
    let request = Request::of(figure, View::Image, camera, state.model.scene_cache.scene(), labels, size);
    at_once(FollowedTriangle::default().overlay(&request)).unwrap().as_ref().clone()
}

/// The object and the index of the triangle that is followed.
fn chosen(window: &Window) -> Option<(String, u32)> {
    window.state().model.shown().triangle.as_ref().map(|shown| (shown.object.clone(), shown.index))
}

fn click_image(window: &mut Window) {
    let at = window.harness.get_by_role(Role::Image).rect().center();
    window.harness.hover_at(at);
    window.run();
    window.harness.drag_at(at);
    window.harness.drop_at(at);
    window.run();
}

#[test]
fn a_triangle_is_clicked_in_the_image_and_each_step_shows_in_it() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = staged(lang);
        assert!(window.state().model.shown().triangle.is_none());
        click_image(&mut window);
        let shown = overlay(&window);
        assert_eq!(shown.step, TriangleStep::View);
        // The triangle can be seen: its middle faces the eye.
        let camera = window.state().model.desk.shown.camera().clone();
        let [a, b, c] = shown.corners;
        assert!((b - a).cross(c - a).dot(camera.position() - a) > 0.0);
        for one in &TriangleStep::ALL[1..] {
            let drawn = window.app_mut().canvas.drawn()[View::Image.index()];
            window.click(t.next);
            let shown = overlay(&window);
            assert_eq!(shown.step, *one);
            assert!(window.app_mut().canvas.drawn()[View::Image.index()] > drawn, "{one:?} shows");
            assert_eq!(shown.rows.is_empty(), !matches!(one, TriangleStep::Pixels | TriangleStep::Depth));
        }
        assert!(window.says(t.kept), "nothing is before it");
        // A click on one of its pixels chooses that pixel, not a triangle.
        let before = window.state().model.shown().triangle.clone().unwrap();
        click_image(&mut window);
        let after = window.state().model.shown().triangle.clone().unwrap();
        assert_eq!((&after.object, after.index), (&before.object, before.index));
        assert!(before.pixel.is_none() && after.pixel.is_some());
        window.key(Key::Escape);
        assert!(window.state().model.shown().triangle.is_none());
    }
}

#[test]
fn a_triangle_is_chosen_and_stepped_by_keyboard_and_f1_opens_the_note() {
    let lang = Lang::En;
    let t = texts(lang);
    let mut window = staged(lang);
    window.harness.get_by_role_and_label(Role::ComboBox, t.object).focus();
    window.run();
    window.key(Key::Enter);
    let name = window.app_mut().state.model.scene_cache.scene().objects[0].name.clone();
    window.harness.get_by_role_and_label(Role::Button, &name).focus();
    window.run();
    window.key(Key::Enter);
    assert_eq!(chosen(&window), Some((name.clone(), 0)));
    window.harness.get_by_label(t.number).focus();
    window.run();
    window.key(Key::ArrowUp);
    assert_eq!(chosen(&window), Some((name, 1)));
    window.harness.get_by_label(step(t, TriangleStep::Outcodes)).focus();
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.shown().triangle.as_ref().unwrap().step, TriangleStep::Outcodes);
    assert!(window.says("w + x = ") && window.says(t.inside));
    window.key(Key::F1);
    assert_eq!(window.state().model.explained.shown(), Explanation::Notes);
    assert_eq!(window.state().explain.notes.chosen, "stage-clip");
    assert!(window.state().model.shown().triangle.is_none(), "hidden, nothing of it is shown");
}

#[test]
fn a_triangle_that_is_left_alone_does_not_repaint() {
    let mut window = staged(Lang::En);
    click_image(&mut window);
    window.click(step(texts(Lang::En), TriangleStep::Depth));
    window.assert_rests();
}
