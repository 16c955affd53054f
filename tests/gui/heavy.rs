//! Scenes of so many triangles that whatever looks through them does so beside the window's thread: the answers come
//! later, and are the same.

use std::time::{Duration, Instant};

use camera_lab::figure::Explanation;
use camera_lab::figure::{ShownTriangle, TriangleStep};
use camera_lab::gui::{Start, State};
use camera_lab::picture::TrianglePixels;
use camera_lab::progress::at_once;
use camera_lab::scene::{ObjectSpec, Preset, Shape};
use camera_lab::views::{Probe, Request, Size, View, image_frame};
use camera_lab_desk::layout::{Side, Tab};
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::why::triangle::texts;
use camera_lab_words::{Lang, pictures};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Pos2, vec2};
use egui_kittest::kittest::Queryable as _;

use super::window::Window;

/// A window with the image of a box before a ball. The ball alone has more than sixty thousand triangles.
fn window(change: impl FnOnce(&mut State)) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.scene.objects = vec![
        ObjectSpec::new("box", Shape::Box).at(-1.5, 0.0, 0.0),
        ObjectSpec::new("ball", Shape::Sphere).with_segments(256),
    ];
    figure.style.antialias = camera_lab::appearance::Samples::One;
    (figure.image.width, figure.image.height) = (160, 120);
    let mut state =
        State::new(Start { figure, file: None, lang: Lang::En, allow_files: false, lesson: None, later: None })
            .expect("a possible camera");
    state.model.layout.maximized = Some(View::Image);
    change(&mut state);
    let window = Window::with_state(state, [1100.0, 900.0]);
    let triangles = window.state().model.scene_cache.scene().objects.iter().map(|object| object.mesh.triangles.len());
    assert!(triangles.sum::<usize>() > 60_000);
    window
}

fn with_tree(state: &mut State) {
    state.model.settings.tab = Tab::Scene;
    state.model.settings.panels.wanted = [true, false, false];
}

fn with_stages(state: &mut State) {
    state.model.settings.panels.show(Side::Explain);
    state.model.explained.show(Explanation::Triangle);
}

fn middle(window: &Window) -> Pos2 {
    window.harness.get_by_role(Role::Image).rect().center()
}

/// The pointer comes and clicks at once, before anything can have been found.
fn click(window: &mut Window, at: Pos2) {
    window.harness.hover_at(at);
    window.harness.drag_at(at);
    window.harness.drop_at(at);
    window.harness.step();
}

#[test]
fn a_click_selects_the_object_in_front_when_it_is_found() {
    let mut window = window(with_tree);
    let at = middle(&window);
    let selected = |window: &Window| {
        let state = window.state();
        state.model.tree.selected(&state.model.desk.shown.figure().scene).cloned()
    };
    click(&mut window, at);
    window.wait(|window| selected(window) == Some(Selected::Object("ball".to_owned())));
    // Nothing is there: the selection stays.
    let corner = window.harness.get_by_role(Role::Image).rect().min + vec2(3.0, 3.0);
    click(&mut window, corner);
    window.run();
    assert_eq!(selected(&window), Some(Selected::Object("ball".to_owned())));
}

#[test]
fn a_click_is_pinned_when_its_vertex_is_found_and_the_vertex_is_named() {
    let mut window = window(|state| state.model.settings.panels.wanted = [false; 3]);
    let at = middle(&window);
    click(&mut window, at);
    window.wait(|window| window.state().model.pinned().is_some());
    let Some(Probe::Point(p)) = window.state().model.pinned() else { panic!("{:?}", window.state().model.pinned()) };
    let scene = window.state().model.scene_cache.scene().clone();
    let vertex = scene.vertices().find(|vertex| vertex.p_world == p).expect("a vertex of the ball");
    let name = format!("Vertex {} – ball", vertex.index + 1);
    window.wait(|window| window.says(&name));
}

#[test]
fn esc_gives_up_a_click_whose_vertex_is_not_found_yet() {
    // How long it takes here, so that the wait afterwards is long enough to see it.
    let mut slow = window(with_tree);
    let (at, since) = (middle(&slow), Instant::now());
    click(&mut slow, at);
    slow.wait(|window| window.state().model.pinned().is_some());
    let needed = since.elapsed();

    let mut window = window(with_tree);
    click(&mut window, at);
    window.harness.remove_cursor();
    window.harness.key_press(Key::Escape);
    window.harness.step();
    assert_eq!(window.state().model.pinned(), None, "it is not found yet");
    let since = Instant::now();
    while since.elapsed() < 2 * needed + Duration::from_millis(100) {
        window.run();
    }
    assert_eq!(window.state().model.pinned(), None);
}

#[test]
fn a_click_chooses_a_triangle_and_at_its_depth_test_a_pixel_of_it() {
    let t = texts(Lang::En);
    let mut window = window(with_stages);
    let at = middle(&window);
    click(&mut window, at);
    window.wait(|window| window.state().model.shown().triangle.is_some());
    let chosen = window.state().model.shown().triangle.clone().expect("a triangle");
    assert_eq!((chosen.object.as_str(), chosen.step), ("ball", TriangleStep::View));
    assert_eq!(window.state().model.pinned(), None, "it is what was meant");
    // A larger one, the first side of the box that is seen.
    let own = |index| ShownTriangle { object: "box".to_owned(), index, step: TriangleStep::Depth, pixel: None };
    let seen = |index: &u32| {
        window.app_mut().state.model.desk.shown.show_mut().triangle = Some(own(*index));
        window.wait(|window| !window.says(t.being_found));
        window.says(t.kept)
    };
    let index = (0..12).find(seen).expect("a side that is seen");
    let pixel = covered(&window, index);
    let place = window.harness.get_by_role(Role::Image).rect();
    let size = Size { width: place.width() as u32, height: place.height() as u32, scale: 1.0 };
    let frame = image_frame(size, 4.0 / 3.0);
    let [x, y] = [(pixel[0], frame.x, frame.width, 160.0), (pixel[1], frame.y, frame.height, 120.0)]
        .map(|(pixel, from, side, of)| from as f32 + (pixel as f32 + 0.5) / of * side as f32);
    click(&mut window, place.min + vec2(x, y));
    window.wait(|window| window.state().model.shown().triangle.as_ref().is_some_and(|shown| shown.pixel.is_some()));
    assert_eq!(window.state().model.shown().triangle, Some(ShownTriangle { pixel: Some(pixel), ..own(index) }));
}

/// A pixel in the middle of a triangle of the box.
fn covered(window: &Window, triangle: u32) -> [u32; 2] {
    let (document, scene) = (&window.state().model.desk.shown, window.state().model.scene_cache.scene());
    let size = Size { width: 1, height: 1, scale: 1.0 };
    let request =
        Request::of(document.figure(), View::Image, document.camera(), scene, pictures::labels(Lang::En), size);
    let pixels = at_once(TrianglePixels::of(&request, 0, triangle)).expect("it is drawn");
    pixels.tested(None).expect("it covers some")
}
